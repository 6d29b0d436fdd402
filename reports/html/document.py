"""The document that the page shows: everything the report shows, as JSON data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.analysis.systems.influences import SystemDetails
from rosarch.base.diagnostics import Diagnostic
from rosarch.findings.policy import Reported
from rosarch.models.component import ComponentModel
from rosarch.models.derivations import Derivations
from rosarch.models.system.model import SystemModel
from rosarch.reports.findings import tool_version
from rosarch.reports.html.components import component_data
from rosarch.reports.html.findings import findings_data
from rosarch.reports.html.proofs import Pool
from rosarch.reports.html.sources import excerpts, places_in
from rosarch.reports.html.systems import system_data
from rosarch.reports.printable import all_printable


@dataclass(frozen=True)
class Subject:
    """What a report is about.

    `read` gives the text of a file of the workspace, or None. `details` are by the names of systems, `derivations` by those of components,
    `link` is the pattern of links to a forge.
    """

    title: str
    folder: Path
    read: Callable[[str], str | None]
    models: Sequence[ComponentModel]
    systems: Sequence[SystemModel]
    reported: Reported
    diagnostics: Sequence[Diagnostic]
    details: Mapping[str, SystemDetails] = field(default_factory=dict)
    derivations: Mapping[str, Derivations] = field(default_factory=dict)
    link: str | None = None


def report_document(subject: Subject) -> dict[str, Any]:
    """The document."""
    data = {
        "rosarch": tool_version(),
        "title": subject.title,
        "link": subject.link,
        "components": [component_data(model) for model in subject.models],
        "systems": [system_data(system, subject.details.get(system.name)) for system in subject.systems],
        "findings": findings_data(subject.reported, subject.read),
        "diagnostics": [_diagnostic(diagnostic, subject.folder.absolute()) for diagnostic in subject.diagnostics],
    }
    data["proofs"] = _derivations(subject)
    data["sources"] = excerpts(places_in(data), subject.read)
    return all_printable(data)


def _derivations(subject: Subject) -> dict[str, Any]:
    """Why things are as they are, by the names of components and systems; each finding is proven in the first system that has it."""
    reported = (*subject.reported.shown, *subject.reported.in_baseline)
    first = {(finding.systems[0], f"finding {finding.fingerprint}") for finding in reported if finding.systems}
    pool = Pool()
    roots = {name: pool.add(found, found.roots) for name, found in sorted(subject.derivations.items())}
    for name, details in sorted(subject.details.items()):
        if details.reasons:
            keys = [key for key in details.reasons.roots if not key.startswith("finding ") or (name, key) in first]
            roots[name] = pool.add(details.reasons, keys)
    return {"steps": pool.steps, "places": list(pool.places), "roots": roots}


def _diagnostic(diagnostic: Diagnostic, folder: Path) -> dict[str, Any]:
    path = diagnostic.path
    inside = path.relative_to(folder) if path.is_relative_to(folder) else path
    return {"kind": diagnostic.kind, "message": diagnostic.message, "at": f"{inside.as_posix()}:{diagnostic.line}"}
