"""What reports tell of systems beside their models: how often topics are sent on, and what influences what."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rosarch.extractor.pool import Failure
from rosarch.models.rule_sets import SystemRules
from rosarch.models.system.analysis import each_system
from rosarch.models.system.rates import RATE_RELATIONS, TopicRate, all_rates
from rosarch.models.system.reading import Reading
from rosarch.models.system.rows import Rows
from rosarch.models.system.surrounding import Launch, Surrounding

_STEPS = ("chain_step", "certain_step")
End = tuple[str, str]
"""A node's id, and that of one of its ports."""


@dataclass(frozen=True)
class InfluenceStep:
    """What passes through `source` has an influence on what passes through `sink`, next to it in a chain; see `chain_step`."""

    source: End
    sink: End
    how: str
    kind: str
    certain: bool


@dataclass(frozen=True)
class Told:
    """Of one system; without rules of data flow there are no `steps`, but None."""

    rates: tuple[TopicRate, ...]
    steps: tuple[InfluenceStep, ...] | None = None


def tell(shared: Surrounding, launches: Sequence[Launch], reading: Reading) -> Mapping[str, Told]:
    """By the systems' names; a system that takes too long is left out."""
    found: dict[str, Told] = {}
    for done, (index, outcome) in enumerate(each_system("told", shared, launches, reading, _told), 1):
        if not isinstance(outcome, Failure):
            found[launches[index].name] = outcome
        if reading.progress:
            reading.progress("rates", done, len(launches))
    return found


def _told(rules: SystemRules, _launch: Launch, rows: Rows, reading: Reading) -> Told:
    wanted = (*RATE_RELATIONS, *(_STEPS if reading.rules.flows else ()))
    result = rules.program.evaluate(rows, engine=reading.engine, keep=wanted)
    rates = tuple(all_rates(result))
    if not reading.rules.flows:
        return Told(rates)
    certain = set(result.rows("certain_step"))
    steps = [
        InfluenceStep(_end(source), _end(sink), how, kind, (source, sink) in certain)
        for source, sink, how, kind in sorted(result.rows("chain_step"), key=repr)
    ]
    return Told(rates, tuple(steps))


def _end(port: tuple[str, str, str]) -> End:
    node, model, parameter = port
    return node, model.rpartition("#")[2] + (f":{parameter}" if parameter else "")
