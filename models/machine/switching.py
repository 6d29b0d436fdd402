"""What goes on at times only, as steps: a variable says whether it is on, what switches it assigns that, what it does hangs on it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rosarch.base.logic import TRUE
from rosarch.models.machine.cells import Cell, Document
from rosarch.models.machine.logic import Formula, Is, Subject
from rosarch.models.machine.meaning import Assignment, Meaning
from rosarch.models.machine.steps import Row, Step, trail_of

ON, OFF = "on", "off"
WAYS = 1000  # more than anything is switched by
START = "start"
"""Triggers what a node does before its callbacks run."""


@dataclass(frozen=True)
class Gate:
    """Something that is on at times only: the cell that says so, the place of a timer or loop, or ports that send while it is on."""

    cell: Cell
    at: str
    ports: frozenset[str]
    once: bool
    ways: tuple[Mapping[str, Any], ...]
    reasons: frozenset[str]

    @property
    def open(self) -> Formula:
        """It is on."""
        return Is(self.cell.subject, frozenset({ON}))

    @property
    def text(self) -> str:
        """What people call it."""
        return self.cell.subject.text


def gates(document: Document) -> list[Gate]:
    """All that is on at times only in a component."""
    names = {str(port["id"]): str(port.get("name")) for port in document.get("ports") or ()}
    loops = {str(row.get("at")) for row in document.get("periodic") or () if row.get("mechanism") != "timer"}
    found = []
    for row in document.get("switched") or ():
        at, ports = str(row["at"]), [str(port) for port in row["ports"]]
        text = f"publisher of {names.get(ports[0])}" if ports else f"{'loop' if at in loops else 'timer'} of {at}"
        subject = Subject(f"{ON} {at} {' '.join(ports)}".strip(), text, (ON, OFF), cell=True)
        initial = (OFF, ON) if row["begins"] == "?" else (str(row["begins"]),)
        cell = Cell(subject, subject.key, "", "", initial, at)
        found.append(Gate(cell, at, frozenset(ports), at in _once(document), tuple(row["switches"]), frozenset(row["reasons"])))
    return found


def starting(document: Document) -> tuple[Cell, list[Step]] | None:
    """What is sent before callbacks run, once, and the cell that is on until then."""
    rows = document.get("starting") or ()
    if not rows:
        return None
    subject = Subject(START, "start", (ON, OFF), cell=True)
    cell = Cell(subject, START, "", "", (ON,), "")
    due = Is(subject, frozenset({ON}))
    steps = [Step(Row(START, 0, ""), (due,), (Assignment(cell, ((TRUE, OFF),)),))]
    for index, (port, at, how) in enumerate(sorted(rows, key=lambda row: _line(str(row[1]))), 1):
        steps.append(Step(Row(START, index, str(at)), (due,), (), (str(port),), sometimes=how != "certainly"))
    return cell, steps


def _line(place: str) -> tuple[str, int]:
    path, _, line = place.rpartition(":")
    return path, int(line)


def _once(document: Document) -> set[str]:
    """The places of timers that run once."""
    switches = [way for row in document.get("switched") or () for way in row["switches"]]
    timed = (row for row in (*(document.get("transitions") or ()), *switches) if "timer" in _list(row.get("trigger")))
    return {str(row.get("at")) for row in document.get("one_shot") or ()} | {at for row in timed for at in _list(row.get("timed_by"))}


def switch_steps(gate: Gate, meaning: Meaning) -> Iterator[tuple[Mapping[str, Any], Step]]:
    """The steps that turn something on or off, each with the row that says what triggers it."""
    for index, way in enumerate(gate.ways):
        to = str(way["to"])
        guard = meaning.guard(way, "guard", "")
        if way["perhaps"]:
            guard += (Is(Subject(f"{gate.cell.subject.key} {index}", f"{gate.text} goes {to}", hidden=True), frozenset({"true"})),)
        yield way, Step(Row("switched", index, str(way["at"])), guard, (Assignment(gate.cell, ((TRUE, to),)),), trail=trail_of(way))


def gated(steps: Sequence[Step], trigger: str, known: Sequence[Gate], document: Document) -> list[Step]:
    """The steps of a trigger, with what they wait for to be on."""
    found = list(steps)
    rows = document.get("transitions") or ()
    for number, gate in enumerate(known):
        timed = [not gate.ports and trigger.split(" ")[0] in ("periodic", "timer") and _of(step, gate, rows, known) for step in found]
        found = [step.within(gate.open) if own else step for step, own in zip(found, timed, strict=True)]
        if gate.once and any(timed):
            ended = Assignment(gate.cell, ((TRUE, OFF),))
            found.insert(0, Step(Row("ran", number, gate.at), (gate.open,), (ended,)))
        found = [part for step in found for part in _by_port(step, gate)]
    return found


def _of(step: Step, gate: Gate, rows: Sequence[Mapping[str, Any]], known: Sequence[Gate]) -> bool:
    """Whether a step is one of the timer's, or of the loop's."""
    if step.row.kind in ("periodic", "one_shot"):
        return step.row.at == gate.at
    if step.row.kind == "transitions":
        return _list(rows[step.row.index].get("timed_by")) == [gate.at]
    if step.row.kind == "switched":
        number, way = divmod(step.row.index, WAYS)
        return _list(known[number].ways[way].get("timed_by")) == [gate.at]
    return False


def _by_port(step: Step, gate: Gate) -> Iterator[Step]:
    """A step, apart from that what it sends through ports that are not always open."""
    sent = [port for port in step.outputs if port in gate.ports]
    if not sent:
        yield step
        return
    rest = tuple(port for port in step.outputs if port not in gate.ports)
    if rest or step.assignments:
        yield replace(step, outputs=rest)
    yield replace(step, outputs=tuple(sent), assignments=()).within(gate.open)


def _list(value: object) -> list[str]:
    if value is None:
        return []
    return [str(item) for item in value] if isinstance(value, list | tuple) else [str(value)]
