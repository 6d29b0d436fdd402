"""The findings about a workspace, with what reports need beside them: little enough to be kept whole."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rosarch.findings.model import Finding
from rosarch.models.openness import OpenPart

if TYPE_CHECKING:
    from rosarch.analysis.systems.analysis import SystemAnalysis
    from rosarch.base.diagnostics import Diagnostic
    from rosarch.models.system.model import SystemModel


@dataclass(frozen=True)
class Scope:
    """How much was checked: `unknown` of the nodes have no model, `open` ones of the others may have more ports than were seen."""

    systems: int
    nodes: int
    unknown: int
    open: int = 0


@dataclass(frozen=True)
class CheckResult:
    """What was found and not understood, the files that it rests on, in which comments may say what is intended, and what was not seen."""

    findings: tuple[Finding, ...]
    diagnostics: tuple[Diagnostic, ...]
    files: tuple[str, ...]
    scope: Scope
    unseen: tuple[OpenPart, ...] = ()


def checked(analysis: SystemAnalysis) -> CheckResult:
    """What a check needs of an analysis."""
    paths = {path for model in analysis.models for path in model.sources}
    paths |= {evidence.place.path for finding in analysis.findings for evidence in finding.evidence}
    paths |= {place.path for system in analysis.systems for node in system.nodes for place in node.lines}
    unseen = {part for system in analysis.systems for part in system.unseen}
    return CheckResult(analysis.findings, analysis.diagnostics, tuple(sorted(paths)), scope_of(analysis.systems), tuple(sorted(unseen)))


def scope_of(systems: Collection[SystemModel]) -> Scope:
    """How much there is in systems."""
    origins = [node.origin for system in systems for node in system.nodes]
    opened = sum(node.open and node.origin != "unknown" for system in systems for node in system.nodes)
    return Scope(len(systems), len(origins), origins.count("unknown"), opened)
