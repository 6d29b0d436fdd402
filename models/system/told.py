"""What reports tell of systems beside their models: how often topics are sent on, and what influences what."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rosarch.extractor.cache import hash_of, rows_digest
from rosarch.extractor.limits import LIMITS
from rosarch.extractor.memo import stage_version
from rosarch.extractor.pool import Failure, default_jobs, run_tasks
from rosarch.models.rule_sets import SystemRules
from rosarch.models.system.rates import RATE_RELATIONS, TopicRate, all_rates
from rosarch.models.system.reading import Reading, rules_hash
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


def tell(rules: SystemRules, shared: Surrounding, launches: Sequence[Launch], reading: Reading) -> Mapping[str, Told]:
    """By the systems' names, in worker processes; a system that takes too long is left out."""
    found: dict[str, Told] = {}
    own = [shared.own_rows(launch) for launch in launches]
    waiting = []
    for index, launch in enumerate(launches):
        known = _kept(reading, shared, own[index])
        if known is None:
            waiting.append(index)
        else:
            found[launch.name] = known

    def work(index: int) -> Told:
        return _told(rules, shared.with_components(own[index]), reading)

    for done, outcome in run_tasks(work, waiting, jobs=reading.jobs or default_jobs(), timeout=LIMITS.evaluation):
        index = waiting[done]
        if not isinstance(outcome, Failure):
            found[launches[index].name] = outcome
            if reading.cache:
                reading.cache.store_value(_key(reading, shared, own[index]), outcome)
        if reading.progress:
            reading.progress("rates", len(launches) - len(waiting) + done + 1, len(launches))
    return found


def _told(rules: SystemRules, rows: Rows, reading: Reading) -> Told:
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


def _kept(reading: Reading, shared: Surrounding, own: Rows) -> Told | None:
    return reading.cache.load_value(_key(reading, shared, own), Told) if reading.cache else None


def _key(reading: Reading, shared: Surrounding, own: Rows) -> str:
    return hash_of(["told", stage_version(), rules_hash(reading.rules), reading.engine, shared.components.digest, rows_digest(own)])
