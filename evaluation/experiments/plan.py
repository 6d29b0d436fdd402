"""`rosarch experiment FILE`: the file that says which variants of the analysis are compared on which subjects, read with places."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import yaml

from rosarch.base.files import read_file
from rosarch.base.hints import hint
from rosarch.base.plain_yaml import YamlError, YamlReader, compose
from rosarch.datalog import Program
from rosarch.evaluation.experiments.run import Configuration
from rosarch.evaluation.experiments.subjects import Subject
from rosarch.evaluation.experiments.truth import Truth, TruthError, read_truth
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.manifest import content_hash
from rosarch.extractor.stored_facts import has_facts, is_facts_text, read_stored
from rosarch.rule_programs.own_files import own_files
from rosarch.rule_programs.sets import SHIPPED, RuleSet, component_program, find_options, rule_set
from rosarch.rule_programs.variants import RuleSetError, decisions

SEED, SAMPLES = 1, 2000
MAX_SAMPLES = 1_000_000
MAX_CONFIGURATIONS = 256
DEFAULT = "default"

_FINDING = re.compile(r"(?P<at>[^:]+:\d+)(?::\d+)?: .*\[(?P<check>[\w-]+)\]")
_Named = list[tuple[str, RuleSet]]


class PlanError(Exception):
    """An experiment that cannot be made: one line for each thing that is wrong, `path:line:col: message`."""


@dataclass(frozen=True)
class Experiment:
    """Every variant is run on every subject; `pairs` are names of variants that are compared.

    `relations` are those whose rows are compared as well, None for all that are put out.
    """

    name: str
    path: str
    digest: str
    subjects: tuple[Subject, ...]
    variants: tuple[Configuration, ...]
    pairs: tuple[tuple[str, str], ...]
    relations: tuple[str, ...] | None
    seed: int
    samples: int


def read_experiment(path: Path) -> Experiment:
    """The experiment of a file; paths in it are relative to its folder.

    Raises:
        PlanError: something in it, or in the truth that it names, is wrong; all errors are reported.
        DatalogError: the rules of a variant are wrong.
    """
    try:
        text = read_file(path).decode("utf-8")
        root = compose(text, str(path))
    except YamlError as error:
        raise PlanError(str(error)) from None
    except UnicodeDecodeError:
        raise PlanError(f"{path}:1:1: not UTF-8 text") from None
    reader = _Reader(path)
    if root is None:
        raise PlanError(f"{path}:1:1: an experiment without `subjects`")
    found = reader.experiment(root)
    if reader.problems:
        raise PlanError("\n".join(reader.problems))
    return found


class _Reader(YamlReader):
    """Turns nodes into an experiment."""

    def __init__(self, path: Path) -> None:
        super().__init__(str(path))
        self.file = path
        self.folder = path.parent
        self.truths: dict[Path, tuple[Truth, ...]] = {}

    def experiment(self, root: yaml.Node) -> Experiment:
        known: dict[str, Callable[[yaml.Node], Any]] = {
            "name": self.text,
            "seed": lambda node: self._number(node, 0, 2**63),
            "samples": lambda node: self._number(node, 1, MAX_SAMPLES),
            "truth": self._truth,
            "subjects": lambda node: node,
            "variants": self._variants,
            "options": lambda node: node,
            "compare": lambda node: node,
            "relations": lambda node: node,
            "findings": lambda node: self.choice(node, ("true", "false")) == "true",
        }
        parts = dict(self.known_keys(root, known, "key"))
        if isinstance(root, yaml.MappingNode) and "subjects" not in parts:
            self.problem(root, "an experiment without `subjects`")
        subjects = (
            self._subjects(parts["subjects"], parts.get("truth") or (), checked=parts.get("findings", False)) if "subjects" in parts else ()
        )
        chosen = parts.get("variants") or ((DEFAULT, SHIPPED),)
        options = self._values(parts["options"], [rules for _, rules in chosen]) if "options" in parts else {}
        variants = self._combined(root, chosen, options)
        pairs = self._compared(parts.get("compare"), [name for name, _ in variants])
        relations = self.texts(parts["relations"]) if "relations" in parts else None
        if self.problems:
            raise PlanError("\n".join(self.problems))
        made = [(name, rule_set(rules.own, dict(rules.variants), dict(rules.options))) for name, rules in variants]
        programs = [component_program(rules) for _, rules in made]
        self._require_relations(parts.get("relations"), programs)
        return Experiment(
            parts.get("name") or self.file.stem,
            self.path,
            content_hash(self.file),
            subjects,
            tuple(
                Configuration(name, program, kept_relations(program, relations), rules)
                for (name, rules), program in zip(made, programs, strict=True)
            ),
            pairs,
            relations,
            SEED if parts.get("seed") is None else parts["seed"],
            parts.get("samples") or SAMPLES,
        )

    def _number(self, node: yaml.Node, low: int, high: int) -> int | None:
        text = self.text(node)
        if text is not None and not (text.isascii() and text.isdecimal() and low <= int(text) <= high):
            self.problem(node, f"a number from {low} to {high} is expected here, not `{text}`")
            return None
        return int(text) if text else None

    def _folder(self, node: yaml.Node, *, facts: bool = False) -> Path | None:
        """A folder or, where that will do, a text of facts."""
        text = self.text(node)
        if text is None:
            return None
        path = self.folder / text
        if not (os.path.isdir(path) or (facts and is_facts_text(path))):
            self.problem(node, f"{path}: {'not a folder' if os.path.exists(path) else 'no such folder'}")
            return None
        return path

    def _truth(self, node: yaml.Node) -> tuple[Truth, ...]:
        path = self._folder(node)
        if path is None:
            return ()
        if path not in self.truths:
            try:
                self.truths[path] = read_truth(path)
            except TruthError as error:
                self.problems += str(error).splitlines()
                self.truths[path] = ()
        return self.truths[path]

    def _subjects(self, node: yaml.Node, shared: Iterable[Truth], *, checked: bool) -> tuple[Subject, ...]:
        """`NAME: FOLDER`, or a map of `folder`, `truth`, `packages`, `defines` and `findings`."""
        found = []
        for key, value in self.pairs(node):
            if isinstance(value, yaml.MappingNode):
                known: dict[str, Callable[[yaml.Node], Any]] = {
                    "folder": lambda node: self._folder(node, facts=True),
                    "truth": self._truth,
                    "packages": lambda node: node,
                    "findings": self._findings,
                    "defines": lambda node: {key.value: self.text(value, empty=True) or "" for key, value in self.pairs(node)},
                }
                parts = dict(self.known_keys(value, known, "key of a subject"))
                if "folder" not in parts:
                    self.problem(value, "a subject without `folder`")
            else:
                parts = {"folder": self._folder(value, facts=True)}
            truths = parts["truth"] if "truth" in parts else tuple(truth for truth in shared if truth.system == key.value)
            folder = parts.get("folder")
            findings = parts.get("findings")
            packages = self._packages(parts["packages"], folder) if "packages" in parts else ()
            if folder is not None and (checked or findings is not None) and has_facts(folder):
                self.problem(key, f"the systems of `{key.value}` cannot be checked: {folder} has facts, not sources")
            elif folder is not None:
                more = (packages, parts.get("defines", {}), checked or findings is not None, findings)
                found.append(Subject(key.value, folder, truths, *more))
        if not found and not self.problems:
            self.problem(node, "no subjects")
        return tuple(found)

    def _packages(self, node: yaml.Node, folder: Path | None) -> tuple[str, ...]:
        """Names of packages that the folder has."""
        found = self.texts(node)
        if folder is not None:
            known = {c.package for c in read_stored(folder).components} if has_facts(folder) else set(PackagePath([folder]).packages)
            for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
                if item.value in found and item.value not in known:
                    self.problem(item, f"no package {item.value} in {folder}{hint(item.value, known)}")
        return found

    def _findings(self, node: yaml.Node) -> frozenset[tuple[str, str]] | None:
        """A file with a line for each finding, as `rosarch check` prints it: `path:line[:col]: message  [check]`."""
        text = self.text(node)
        if text is None:
            return None
        path = self.folder / text
        try:
            lines = read_file(path).decode("utf-8").splitlines()
        except (OSError, UnicodeDecodeError) as error:
            self.problem(node, f"{path}: cannot be read ({(getattr(error, 'strerror', None) or 'not UTF-8 text').lower()})")
            return None
        found = set()
        for number, line in enumerate(lines, 1):
            match = _FINDING.fullmatch(line)
            if match:
                found.add((match["check"], match["at"]))
            elif line.strip():
                self.problems.append(f"{path}:{number}:1: not of the form `path:line: message  [check]`")
        return frozenset(found)

    def _variants(self, node: yaml.Node) -> tuple[tuple[str, RuleSet], ...]:
        return tuple((key.value, self._variant(value)) for key, value in self.pairs(node))

    def _variant(self, node: yaml.Node) -> RuleSet:
        """`rules` come first: they may bring variants and options of their own."""
        known: dict[str, Callable[[yaml.Node], Any]] = {"decisions": lambda n: n, "options": lambda n: n, "rules": lambda n: n}
        parts = dict(self.known_keys(node, known, "key of a variant"))
        rules = RuleSet(self._own(parts["rules"]) if "rules" in parts else ())
        if "decisions" in parts:
            rules = replace(rules, variants=self._decisions(parts["decisions"], rules))
        if "options" in parts:
            values = self._values(parts["options"], [rules])
            for name in (name for name, own in values.items() if len(own) > 1):
                self.problem(parts["options"], f"`{name}` of a variant has one value; several go below `options` of the experiment")
            rules = replace(rules, options=tuple((name, own[0]) for name, own in values.items() if own))
        return rules

    def _own(self, node: yaml.Node) -> tuple[Path, ...]:
        """Files of rules, and folders of them."""
        found = []
        for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
            text = self.text(item)
            if text is not None:
                try:
                    own_files([self.folder / text])
                    decisions([self.folder / text])
                except RuleSetError as error:
                    self.problem(item, str(error))
                else:
                    found.append(self.folder / text)
        return tuple(found)

    def _decisions(self, node: yaml.Node, rules: RuleSet) -> tuple[tuple[str, str], ...]:
        known = {decision.name: [variant.name for variant in decision.variants] for decision in decisions(rules.own)}
        found = []
        for key, value in self.pairs(node):
            name = self.text(value)
            if key.value not in known:
                self.problem(key, f"unknown decision `{key.value}`{_name_hint(key.value, known)}")
            elif name is not None and name not in known[key.value]:
                self.problem(value, f"unknown variant `{name}` of `{key.value}`{_name_hint(name, known[key.value])}")
            elif name is not None:
                found.append((key.value, name))
        return tuple(found)

    def _values(self, node: yaml.Node, variants: Iterable[RuleSet]) -> dict[str, tuple[str, ...]]:
        """The values of options that all of `variants` have."""
        known = [{option.name: option for option in find_options(rules)} for rules in variants]
        found = {}
        for key, value in self.pairs(node):
            for options in known:
                if key.value not in options:
                    self.problem(key, f"unknown option `{key.value}`{_name_hint(key.value, options)}")
                    break
                for item in value.value if isinstance(value, yaml.SequenceNode) else [value]:
                    if isinstance(item, yaml.ScalarNode) and (why := options[key.value].problem(item.value)):
                        self.problem(item, why)
            found[key.value] = self.texts(value)
        return found

    def _require_relations(self, node: yaml.Node | None, programs: Sequence[Program]) -> None:
        known = {name for program in programs for name in program.relations}
        for item in [] if node is None else node.value if isinstance(node, yaml.SequenceNode) else [node]:
            if item.value not in known:
                self.problem(item, f"unknown relation `{item.value}`{hint(item.value, known)}")

    def _combined(self, root: yaml.Node, variants: Iterable[tuple[str, RuleSet]], options: Mapping[str, tuple[str, ...]]) -> _Named:
        """Each variant with each combination of the values of options; names show the latter."""
        found = []
        for name, rules in variants:
            for values in itertools.islice(itertools.product(*options.values()), MAX_CONFIGURATIONS + 1):
                more = dict(zip(options, values, strict=True))
                given = tuple({**dict(rules.options), **more}.items())
                found.append((" ".join((name, *(f"{key}={value}" for key, value in more.items()))), replace(rules, options=given)))
        if len(found) > MAX_CONFIGURATIONS:
            self.problem(root, f"more than {MAX_CONFIGURATIONS} combinations of variants and options")
        return found

    def _compared(self, node: yaml.Node | None, names: list[str]) -> tuple[tuple[str, str], ...]:
        """Pairs of names; by default the first with each other."""
        if node is None:
            return tuple((names[0], name) for name in names[1:])
        found = []
        for item in self.items(node):
            pair = self.items(item)
            if len(pair) != 2:
                self.problem(item, "two variants are expected here")
                continue
            texts = [self.text(one) for one in pair]
            for one, text in zip(pair, texts, strict=True):
                if text is not None and text not in names:
                    self.problem(one, f"unknown variant `{text}`{_name_hint(text, names)}")
            found.append((texts[0] or "", texts[1] or ""))
        return tuple(found)


def kept_relations(program: Program, more: Iterable[str] | None) -> tuple[str, ...]:
    """The relations whose rows are wanted: those that are put out, and of `more` those that exist."""
    return tuple(dict.fromkeys((*program.outputs, *(name for name in more or () if name in program.relations))))


def _name_hint(name: str, known: Iterable[str]) -> str:
    known = list(known)
    return hint(name, known) or (f", there are {', '.join(known)}" if known else ", there are none")
