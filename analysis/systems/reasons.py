"""Why systems are as they are: the proofs of what rules conclude of them, and what in the launch files starts their nodes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from rosarch.base.places import Place
from rosarch.datalog import Result, RowStore
from rosarch.extractor.launch.facts import kind_and_text, path_below, starts
from rosarch.extractor.launch.model import ArgumentPassed, Composition, NodeStart, ParamSetting
from rosarch.extractor.launch.model import Place as LaunchPlace
from rosarch.findings.of_systems import findings_with_rows
from rosarch.models.component import component_of
from rosarch.models.derivations import Derivations, ProofStep, Wanted, derivations
from rosarch.models.system.rows import Rows
from rosarch.rule_programs.sets import SystemRules

RATE_DEPTH = 16
"""Steps below a rate: what comes from a sender, and is added up, is several of them for every node that passes it on."""
WRITTEN = "launch file"
"""The origin of steps that follow from launch files."""


def system_reasons(
    rules: SystemRules, rows: Rows, result: Result, system: str, started: Started, shorten: Callable[[str], str], *, chains: bool
) -> Derivations:
    """Why a system has its nodes, connectors, rates, `chains` and findings; `result` has the rows of all relations."""
    places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
    found = findings_with_rows(rules.checks, result, places, system, started.is_installed)
    asked = [Wanted(f"finding {finding.fingerprint}", finding.check.relation, row) for row, finding in found]
    facts = {relation: list(own) for relation, own in rows.items()}
    implicit = {port for (port,) in rows.get("interface_port_implicit", ())}
    asked += [*_ends(result, implicit), *_rates(result), *(_chains(result, implicit) if chains else ())]
    return started.added_to(derivations(rules.program, RowStore(result, facts), asked, shorten, places))


def _ends(result: Result, implicit: set[str]) -> Iterator[Wanted]:
    for kind, name, side, port in sorted(result.rows("joins_connector"), key=repr):
        if port[1] not in implicit:
            yield Wanted(f"end {name} {_port(port)}", "joins_connector", (kind, name, side, port))


def _rates(result: Result) -> Iterator[Wanted]:
    for topic, high in result.rows("topic_high"):
        yield Wanted(f"topic_high {topic}", "topic_high", (topic, high), RATE_DEPTH)
    for topic, low in result.rows("topic_low"):
        if low:  # 0 is the bound of what is not known
            yield Wanted(f"topic_low {topic}", "topic_low", (topic, low), RATE_DEPTH)
    for topic, reason in result.rows("topic_unbounded"):
        yield Wanted(f"topic_unbounded {topic} {reason}", "topic_unbounded", (topic, reason))


def _chains(result: Result, implicit: set[str]) -> Iterator[Wanted]:
    for relation in ("chain_step", "certain_step"):
        for source, sink, *rest in sorted(result.rows(relation), key=repr):
            if not {source[1], sink[1]} <= implicit:
                yield Wanted(f"{relation} {_port(source)} > {_port(sink)}", relation, (source, sink, *rest))


def _port(port: tuple[str, str, str]) -> str:
    node, model, parameter = port
    title, mark, id_ = model.rpartition("#")
    return f"{node} {component_of(title)}{mark}{id_}{f':{parameter}' if parameter else ''}"


class Started:
    """What starts the nodes of a composition, as steps; paths below `root` are relative to it."""

    def __init__(self, composition: Composition, root: Path, is_installed: Callable[[str], bool] = lambda _: False) -> None:
        self.composition = composition
        self.is_installed = is_installed
        self.root = str(root.absolute())
        self.steps: list[ProofStep] = []
        self.passed: dict[LaunchPlace, list[ArgumentPassed]] = defaultdict(list)
        for argument in composition.passed:
            self.passed[argument.include].append(argument)
        self.files = {include.lines: include.file or include.text for include in composition.includes}

    def added_to(self, found: Derivations) -> Derivations:
        """The derivations, with those of the nodes."""
        self.steps = list(found.steps)
        roots = {f"node {start}": self.node(start, node) for start, node in starts(self.composition)}
        return Derivations(tuple(self.steps), {**found.roots, **roots})

    def node(self, start: str, node: NodeStart) -> int:
        own = [self.include(node.lines[: depth + 1]) for depth in range(len(node.lines) - 1)]
        own += [self.step(f"{condition}, which holds", condition.place) for condition in node.held]
        own += [self.step(f"{condition}, which launch files leave open", condition.place) for condition in node.conditions]
        own += [self.step(f"arguments {node.args}", node.lines[-1])] if node.args else []
        own += [self.step(f"loaded into {node.container}", node.lines[-1])] if node.container else []
        own += [self.step(f"{remap.source} is called {remap.target}", remap.place) for remap in node.own_remaps]
        below = f"{start.partition('#')[0]}/"
        own += [self.param(setting, below, node) for setting in self.composition.params if setting.name.startswith(below)]
        return self.step(f"{start} runs {node.package}/{node.type}", node.lines[-1], own)

    def include(self, lines: tuple[LaunchPlace, ...]) -> int:
        passed = [self.step(f"passes {each.name} = {each.value}", each.place) for each in self.passed[lines[-1]]]
        file = self.files.get(lines)
        return self.step(f"includes {path_below(self.root, file)}" if file else "includes a file", lines[-1], passed)

    def param(self, setting: ParamSetting, below: str, node: NodeStart) -> int:
        source = f", from {path_below(self.root, setting.source)}" if setting.source else ""
        own = "".join(f" {condition}" for condition in setting.conditions if condition not in node.conditions)
        return self.step(f"~{setting.name[len(below) :]} = {kind_and_text(setting.value)[1]}{source}{own}", setting.place)

    def step(self, text: str, at: Any, premises: Sequence[int] = ()) -> int:
        place = Place(path_below(self.root, at.path), at.line, at.column)
        self.steps.append(ProofStep(text, WRITTEN, tuple(premises), at=place))
        return len(self.steps) - 1
