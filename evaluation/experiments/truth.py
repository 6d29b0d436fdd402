"""Models written by hand: what is true of a component, a YAML or JSON document each, with the fields of a component's model."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from rosarch.base.files import read_file
from rosarch.base.places import Place
from rosarch.base.plain_yaml import YamlReader, yaml_problem
from rosarch.evaluation.experiments.truth_fields import check_model, check_truth
from rosarch.extractor.manifest import content_hash

Check = Callable[[YamlReader, yaml.Node], dict[str, yaml.Node]]
SUFFIXES = frozenset({".yml", ".yaml", ".json"})


class TruthError(Exception):
    """Truth that cannot be used: one line for each thing that is wrong, `path:line:col: message`."""


@dataclass(frozen=True, eq=False)
class Truth:
    """What is true of a component; `at` is where the file names it."""

    system: str
    package: str
    component: str
    document: Mapping[str, Any]
    at: Place
    digest: str

    @property
    def program(self) -> str:
        """The component that it is about a node of, else the component itself."""
        return str(self.document.get("executable") or self.component)

    @property
    def title(self) -> str:
        """`package/component`."""
        return f"{self.package}/{self.component}"


def read_truth(folder: Path) -> tuple[Truth, ...]:
    """All truth below a folder, by system, package and component. Documents that name no component are none.

    Raises:
        TruthError: something in it is wrong; all errors are reported.
    """
    problems: list[str] = []
    found: dict[tuple[str, str, str], Truth] = {}
    for truth in _documents(folder, check_truth, problems):
        first = found.setdefault((truth.system, truth.package, truth.component), truth)
        if first is not truth:
            at = f"{truth.at}:{truth.at.column}"
            problems.append(f"{at}: {truth.title} of {truth.system} is told of for the second time, first in {first.at}")
    if problems:
        raise TruthError("\n".join(problems))
    if not found:
        raise TruthError(
            f"{folder}: no truth below this folder; it is a YAML file with `component`, `package`, `ports`, ... for each component"
        )
    return tuple(found[key] for key in sorted(found))


def read_models(folder: Path) -> dict[tuple[str, str], Mapping[str, Any]]:
    """All models below a folder, as documents with the fields of truth, by package and component; of two of one component the last counts.

    Raises:
        TruthError: one of them is damaged.
    """
    problems: list[str] = []
    found = {(model.package, model.component): model.document for model in _documents(folder, check_model, problems)}
    if problems:
        raise TruthError("\n".join(problems))
    return found


def _documents(folder: Path, check: Check, problems: list[str]) -> Iterator[Truth]:
    for path in sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES and os.path.isfile(path)):
        found = _read(path, check, problems)
        if found is not None:
            yield found


def _read(path: Path, check: Check, problems: list[str]) -> Truth | None:
    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        text = read_file(path).decode("utf-8")
        opened = loader(text)
        try:
            root = opened.get_single_node()
            document = opened.construct_document(root) if root is not None else None
        finally:
            opened.dispose()
    except yaml.YAMLError as error:
        problems.append(yaml_problem(str(path), error))
        return None
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        problems.append(f"{path}:{line}:1: not UTF-8 text: byte 0x{error.object[error.start]:02x}")
        return None
    except (OSError, RecursionError, ValueError) as error:
        problems.append(f"{path}:1:1: cannot be read ({' '.join(str(error).split()).lower()})")
        return None
    if not isinstance(document, dict) or "component" not in document:
        return None
    reader = YamlReader(str(path))
    fields = check(reader, root)
    problems += reader.problems
    if reader.problems:
        return None
    system = str(document.get("system") or path.parent.name)
    return Truth(
        system, str(document["package"]), str(document["component"]), document, reader.place(fields["component"]), content_hash(path)
    )


def systems(truth: tuple[Truth, ...]) -> Iterator[tuple[str, tuple[Truth, ...]]]:
    """The truth of each system."""
    for system in sorted({each.system for each in truth}):
        yield system, tuple(each for each in truth if each.system == system)
