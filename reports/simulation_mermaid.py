"""The beginning of a simulated run as Mermaid diagrams: who sends what to whom, and when each node is at work."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from rosarch.behavior.composition.system import System
from rosarch.behavior.simulation.records import Record
from rosarch.reports.sequence_mermaid import Arrow, Remark, arrows, sequence_text

MOST_ITEMS = 60


def sequence_diagram(record: Record, system: System, most: int = MOST_ITEMS) -> str:
    """The first events."""
    return sequence_text(list(islice(_items(record, system), most)), record.system)


def _items(record: Record, system: System) -> Iterator[Arrow | Remark]:
    for event in record.events:
        at = f"{event.time:.3f} s"
        if event.kind == "sent":
            yield from arrows(event.actor, system.topics[event.subject], f"{event.subject} at {at}")
        elif event.kind == "changed":
            yield Remark(event.actor, f"{event.subject} {event.detail} at {at}")
        elif event.kind == "dropped":
            yield Remark(event.actor, f"loses {event.subject} at {at}")


def timeline(record: Record, most: int = MOST_ITEMS) -> str:
    """The first reactions, a row for each node."""
    work = sorted(record.work, key=lambda work: work.start)[:most]
    lines = ["gantt", f"  title {_plain(record.system)}", "  dateFormat x", "  axisFormat %S.%L s"]
    for node in dict.fromkeys(item.node for item in work):
        lines.append(f"  section {_plain(node)}")
        for item in work:
            if item.node == node:
                start, end = round(item.start * 1000), round(item.end * 1000)
                lines.append(f"  {_plain(item.cause)} : {start}, {max(end, start + 1)}")
    return "\n".join([*lines, ""])


def _plain(text: str) -> str:
    return re.sub(r"[:;#,\n]", " ", text)
