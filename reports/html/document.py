"""The document that the page shows: everything the report tells, as JSON data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.extractor.diagnostics import Diagnostic
from rosarch.models.component import ComponentModel
from rosarch.models.derivations import Derivations
from rosarch.models.policy import Reported
from rosarch.models.system.model import SystemModel
from rosarch.models.system.told import Told
from rosarch.reports.findings import tool_version
from rosarch.reports.html.components import component_data
from rosarch.reports.html.findings import findings_data
from rosarch.reports.html.sources import excerpts, places_in
from rosarch.reports.html.systems import system_data
from rosarch.reports.printable import all_printable


@dataclass(frozen=True)
class Subject:
    """What a report is about.

    `told` is by the names of systems, `derivations` by those of components, `link` is the pattern of links to a forge.
    """

    title: str
    folder: Path
    models: Sequence[ComponentModel]
    systems: Sequence[SystemModel]
    reported: Reported
    diagnostics: Sequence[Diagnostic]
    told: Mapping[str, Told] = field(default_factory=dict)
    derivations: Mapping[str, Derivations] = field(default_factory=dict)
    link: str | None = None


def report_document(subject: Subject, read: Callable[[str], str | None]) -> dict[str, Any]:
    """The document; `read` gives the text of a file of the workspace, or None."""
    data = {
        "rosarch": tool_version(),
        "title": subject.title,
        "link": subject.link,
        "components": [component_data(model) for model in subject.models],
        "systems": [system_data(system, subject.told.get(system.name)) for system in subject.systems],
        "findings": findings_data(subject.reported, read),
        "diagnostics": [_diagnostic(diagnostic, subject.folder.absolute()) for diagnostic in subject.diagnostics],
    }
    data["proofs"] = {name: _proofs(found) for name, found in sorted(_derivations(subject).items())}
    data["sources"] = excerpts(places_in(data), read)
    return all_printable(data)


def _derivations(subject: Subject) -> dict[str, Derivations]:
    """The proofs of components and systems; each finding is proven in the first system that has it."""
    found = dict(subject.derivations)
    told = {(finding.systems[0], f"finding {finding.fingerprint}") for finding in subject.reported.shown if finding.systems}
    told |= {(finding.systems[0], f"finding {finding.fingerprint}") for finding in subject.reported.known if finding.systems}
    for name, system in subject.told.items():
        if system.reasons:
            found[name] = system.reasons.of(lambda key, name=name: not key.startswith("finding ") or (name, key) in told)  # type: ignore[misc]
    return found


def _proofs(found: Derivations) -> dict[str, Any]:
    """Steps as text, rule, numbers of the steps they rest on, 1 where more is left out, and a number of `places` where one is known."""
    places: dict[str, int] = {}
    steps: list[list[Any]] = []
    for step in found.steps:
        at = [places.setdefault(str(step.at), len(places))] if step.at else []
        steps.append([step.text, step.rule, list(step.premises), int(step.cut), *at])
    return {"steps": steps, "roots": dict(found.roots), "places": list(places)}


def _diagnostic(diagnostic: Diagnostic, folder: Path) -> dict[str, Any]:
    path = diagnostic.path
    inside = path.relative_to(folder) if path.is_relative_to(folder) else path
    return {"kind": diagnostic.kind, "message": diagnostic.message, "at": f"{inside.as_posix()}:{diagnostic.line}"}
