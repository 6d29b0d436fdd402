"""State machines in the format that is asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from types import MappingProxyType

from rosarch.models.machine.build import StateMachine
from rosarch.reports import machine_dot, machine_mermaid, machine_plantuml, machine_scxml, machine_text
from rosarch.reports.machine_json import machines_text as json_text

WRITERS: MappingProxyType[str, Callable[[StateMachine], str]] = MappingProxyType(
    {
        "text": machine_text.machine_text,
        "mermaid": machine_mermaid.machine_text,
        "dot": machine_dot.machine_text,
        "plantuml": machine_plantuml.machine_text,
        "scxml": machine_scxml.machine_text,
    }
)


def machines_text(machines: Sequence[StateMachine], format_: str) -> str:
    """All machines, with an empty line between; JSON as one array."""
    return json_text(machines) if format_ == "json" else "\n".join(map(WRITERS[format_], machines))
