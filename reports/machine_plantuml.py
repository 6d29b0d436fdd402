"""State machines as PlantUML state diagrams."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rosarch.models.machine.build import Region, StateMachine
from rosarch.reports.machine_labels import ANY, always_labels, edges, region_title, state_id, state_text, title, wrapped

_SPECIAL = re.compile(r"""[~<>"\\%#{}@`]|(?<=(.))[-_*/.'](?<=\1\1)|^[-=*#.':!]""")


def machine_text(machine: StateMachine) -> str:
    """One diagram: a composite state for each region; reactions that stay in a state are written into it."""
    out = ["@startuml", f"title {_escape(title(machine))}", "hide empty description"]
    for number, region in enumerate(machine.regions, 1):
        out += _region(machine, region, f"r{number}")
    if machine.always:
        out.append('state "in every state" as always')
        out += _inside("always", always_labels(machine), "")
    return "\n".join([*out, "@enduml"]) + "\n"


def _region(machine: StateMachine, region: Region, name: str) -> list[str]:
    out = [f'state "{_escape(region_title(region))}" as {name} {{']
    out += [f'  state "{_escape(state_text(region, state))}" as {name}_{state}' for state in range(len(region.states))]
    out += [f"  [*] --> {name}_{state}" for state in region.initial]
    found = edges(machine, region)
    if any(edge.source == ANY for edge in found):
        out.append(f'  state "any state" as {state_id(name, ANY)}')
    for edge in found:
        if edge.source == edge.target:
            out += _inside(state_id(name, edge.source), edge.labels, "  ")
        else:
            label = "\\n".join(_escape(line) for label in edge.labels for line in wrapped(label))
            out.append(f"  {state_id(name, edge.source)} --> {state_id(name, edge.target)} : {label}")
    return [*out, "}"]


def _inside(state: str, labels: Iterable[str], indent: str) -> list[str]:
    return [f"{indent}{state} : {_escape(line)}" for label in labels for line in wrapped(label)]


def _escape(text: str) -> str:
    """Characters that mean something in PlantUML, and those that do when doubled, as their code points."""
    return _SPECIAL.sub(lambda match: f"<U+{ord(match[0]):04X}>", text)
