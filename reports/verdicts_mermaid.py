"""Counterexamples as Mermaid sequence diagrams."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rosarch.behavior.composition.system import ENVIRONMENT, System
from rosarch.behavior.verification.check import Verdict
from rosarch.behavior.verification.trace import Step
from rosarch.reports.sequence_mermaid import Arrow, Remark, Repeated, arrows, sequence_text


def verdicts_text(system: System, verdicts: Sequence[Verdict]) -> str:
    """A diagram for each property that is violated."""
    found = []
    for verdict in verdicts:
        if verdict.trace:
            items: list[Arrow | Remark | Repeated] = list(_items(system, verdict.trace.stem))
            if verdict.trace.loop:
                items.append(Repeated(tuple(_items(system, verdict.trace.loop))))
            found.append(sequence_text(items, f"{verdict.property.name}: {verdict.verdict}"))
    return "\n".join(found)


def _items(system: System, steps: Iterable[Step]) -> Iterator[Arrow | Remark]:
    for step in (step for step in steps if step.actor):
        told = [*step.inputs, *step.assumes, *(f"{text}: {old} to {new}" for text, old, new in step.changes)]
        if step.cause.startswith(("receives ", "serves ")) and step.takes is None:
            yield Arrow(ENVIRONMENT, step.actor, step.cause.partition(" ")[2])
        elif not step.sends or told:
            told.insert(0, step.cause)
        if told:
            yield Remark(step.actor, ", ".join(told))
        for topic in step.sends:
            yield from arrows(step.actor, system.topics[topic], topic)
        yield from (Remark(node, f"loses an older {topic}") for node, topic in step.dropped)
