"""State machines as PlantUML state diagrams."""

from __future__ import annotations

import re

from rosarch.models.machine.build import StateMachine
from rosarch.reports.machine_labels import title
from rosarch.reports.state_diagrams import StateDiagram

_SPECIAL = re.compile(r"""[~<>"\\%#{}@`]|(?<=(.))[-_*/.'](?<=\1\1)|^[-=*#.':!]""")


def machine_text(machine: StateMachine) -> str:
    """One diagram."""
    head = ["@startuml", f"title {_escape(title(machine))}", "hide empty description"]
    return "\n".join([*head, *_DIAGRAM.lines(machine), "@enduml"]) + "\n"


def _escape(text: str) -> str:
    """Characters that mean something in PlantUML, and those that do when doubled, as their code points."""
    return _SPECIAL.sub(lambda match: f"<U+{ord(match[0]):04X}>", text)


_DIAGRAM = StateDiagram(_escape, line_break="\\n", indent="")
