"""State machines as Mermaid state diagrams."""

from __future__ import annotations

import re

from rosarch.models.machine.build import StateMachine
from rosarch.reports.machine_labels import title
from rosarch.reports.state_diagrams import StateDiagram

_SPECIAL = re.compile(r"[^\w\s.,/~!=&|()\[\]+*?\'-]|-(?=-)|%")


def machine_text(machine: StateMachine) -> str:
    """One diagram."""
    return "\n".join(["---", f'title: "{_escape(title(machine))}"', "---", "stateDiagram-v2", *_DIAGRAM.lines(machine)]) + "\n"


def _escape(text: str) -> str:
    """Characters that mean something in Mermaid as their code points."""
    return _SPECIAL.sub(lambda match: f"#{ord(match[0])};", text)


_DIAGRAM = StateDiagram(_escape, line_break="<br/>", indent="  ")
