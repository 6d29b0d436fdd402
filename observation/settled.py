"""Names that the sources leave open, as the running node has them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from rosarch.analysis.systems.interfaces import model_rows
from rosarch.extractor.launch.facts import launch_rows
from rosarch.extractor.launch.model import Composition, NodeStart, Place
from rosarch.models.component import ComponentModel
from rosarch.models.system.rows import merged
from rosarch.observation.company import company
from rosarch.observation.compare import Filled, compare
from rosarch.observation.observed import watched_rows
from rosarch.observation.subject import Subject
from rosarch.rule_programs.sets import SystemRules


def is_open(model: ComponentModel) -> bool:
    """Whether the model leaves a name open."""
    return any("?" in port.name for port in model.ports)


def settle(subject: Subject, model: ComponentModel, command: Sequence[str], rules: SystemRules, engine: str) -> tuple[Filled, ...]:
    """Start the node alone, and report what it has where its model leaves a name open: several names of one port are possible.

    Raises:
        StartError: it does not come up.
        CallError: it is gone before it was looked at.
    """
    with company(subject) as other:
        other.start(command)
        watched = other.watched()
    ros = 1 if watched.domain is None else 2
    start = NodeStart(model.package, model.types[0], subject.name.strip("/"), "/", (Place(command[0], 1, 1),), ros=ros)
    composition = Composition(nodes=(start,), tests=(), params=(), includes=(), problems=(), files=())
    rows = merged([launch_rows(composition, Path()), model_rows(model)])
    found = compare(rules, subject.name, rows, watched_rows(watched), engine)
    return tuple(filled for filled in found.filled if filled.what == "name")
