"""What checkers found about properties, as text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rosarch.behavior.verification.check import HOLDS, Verdict
from rosarch.behavior.verification.trace import Step, Trace
from rosarch.reports.printable import printable


def verdicts_text(system: str, verdicts: Sequence[Verdict], checker: str) -> str:
    """Each property with its verdict and, when it is violated, how."""
    lines = [system, ""]
    for found in verdicts:
        lines += [f"{found.property.name}: {found.verdict}", f"  {found.property.text}"]
        lines += _trace(found.trace) if found.trace else []
        lines += [f"  note: {note}" for note in found.notes] if found.verdict != HOLDS else []
        lines.append("")
    number = sum(found.verdict == HOLDS for found in verdicts)
    most = max((found.states for found in verdicts), default=0)
    seconds = sum(found.seconds for found in verdicts)
    return "\n".join(
        [*map(printable, lines), f"{number} of {len(verdicts)} properties hold; {checker}, up to {most} states, {seconds:.1f} s", ""]
    )


def _trace(trace: Trace) -> Iterator[str]:
    if trace.first:
        yield "  begins with " + ", ".join(f"{text} {value}" for text, value in trace.first)
    rows = list(enumerate(trace.stem, 1))
    yield from (f"  {number}. {_step_text(step)}" for number, step in rows)
    if trace.loop:
        yield "  then again and again:"
        yield from (f"  {number}. {_step_text(step)}" for number, step in enumerate(trace.loop, len(rows) + 1))
    elif not trace.stem:
        yield "  nothing happens"
    if trace.assumes:
        yield "  if this can be so: " + "; ".join(trace.assumes)


def _step_text(step: Step) -> str:
    """A step on one line."""
    cause = step.cause if not step.inputs else f"{step.cause} with {' and '.join(step.inputs)}"
    effects = [f"{text} {old} -> {new}" for text, old, new in step.changes]
    effects += [f"sends {topic}" for topic in step.sends if not step.cause.startswith("sends ")]
    effects += [f"{node} loses an older {topic}" for node, topic in step.dropped]
    places = f"  [{', '.join(_places(step))}]" if step.places else ""
    return f"{step.actor} {cause}{': ' if effects else ''}{', '.join(effects)}{places}".lstrip()


def _places(step: Step) -> list[str]:
    """The source lines of a step."""
    return list(dict.fromkeys(place for places in step.places for place in places.split(" ")))
