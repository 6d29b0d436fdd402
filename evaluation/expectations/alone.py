"""A component that is started alone: the findings about a single source."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.analysis.systems.interfaces import model_rows
from rosarch.analysis.systems.workspace import shared_rows
from rosarch.base import places
from rosarch.datalog import Program
from rosarch.extractor.launch.facts import launch_rows
from rosarch.extractor.launch.model import Composition, NodeStart, Place
from rosarch.findings.model import Finding
from rosarch.findings.of_systems import findings
from rosarch.models.component import ComponentModel
from rosarch.models.system.build import evaluate
from rosarch.models.system.rows import merged
from rosarch.rule_programs.sets import RuleSet, system_rules


@dataclass(frozen=True)
class Alone:
    """Each component of single sources, started by itself: without arguments and parameters, in the first line of its source."""

    root: Path
    rules: RuleSet
    engine: str

    @property
    def program(self) -> Program:
        return system_rules(self.rules).program

    def rows(self) -> Sequence[dict[str, list[tuple[Any, ...]]]]:
        return ()  # questions about systems are in launch files

    def findings_with(self, models: Sequence[ComponentModel]) -> Sequence[Finding]:
        return self.findings(models)

    def findings(self, models: Sequence[ComponentModel]) -> Sequence[Finding]:
        rules = system_rules(self.rules)
        found: list[Finding] = []
        for model in models:
            composition = Composition((_start(self.root, model),), (), (), (), (), ())
            rows = merged([launch_rows(composition, self.root), model_rows(model), shared_rows([model])])
            result = evaluate(rules, rows, self.engine)
            known = {row[0]: places.Place(*row[1:]) for row in rows["place"]}
            found += findings(rules.checks, result, known, f"{model.package}/{model.component}")
        return found


def _start(root: Path, model: ComponentModel) -> NodeStart:
    """A class is loaded by the program that nodelets have for that."""
    here = (Place(str(root / model.sources[0]) if model.sources else str(root), 1),)
    name = model.node_name or model.component
    if model.plugin:
        return NodeStart("nodelet", "nodelet", name, "/", here, args=f"standalone {model.plugin.name}")
    return NodeStart(model.package, model.component, name, "/", here)
