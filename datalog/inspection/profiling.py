"""`profile`: where an evaluation by the embedded engine spends its time, by rule and by relation.

Without a profile nothing is measured.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog.engine.engine import Evaluation
from rosarch.datalog.engine.plan import BulkRule, Rule
from rosarch.datalog.program import Program, Result

if TYPE_CHECKING:
    from rosarch.datalog.engine.bulk import BulkLoop


@dataclass(slots=True)
class RuleProfile:
    """What one rule took: `calls` of its function, one a round for a recursive rule, and the rows it added."""

    place: str
    relation: str
    seconds: float = 0.0
    calls: int = 0
    rows: int = 0


@dataclass(frozen=True, slots=True)
class RelationProfile:
    """What all rules of a relation took, and the rows it has in the end."""

    relation: str
    seconds: float
    rules: int
    rows: int


@dataclass(frozen=True, slots=True)
class Profile:
    """An evaluation with its profile; both lists start with what took longest."""

    result: Result
    seconds: float
    rules: tuple[RuleProfile, ...]
    relations: tuple[RelationProfile, ...]


def profile(
    program: Program, facts: Mapping[str, Iterable[tuple[Any, ...]]] | Path, *, keep: Collection[str] | str | None = "all"
) -> Profile:
    """Evaluate with the embedded engine and measure every rule."""
    found: dict[str, RuleProfile] = {}
    for stratum in (*program.code.strata, *(table.whole for table in program.code.tables if table.whole)):
        for rule in stratum.rules():
            found.setdefault(_family(rule), RuleProfile(rule.location.rpartition(":")[0], rule.target))
    clock = _Clock()

    class Measured(Evaluation):
        """An evaluation that measures its rules, with the indexes that are built for them."""

        def bound(self, rule: Rule, growing: Collection[int]) -> Callable[[Any, Any], None]:
            entry = found[_family(rule)]
            with clock.measured(entry):
                function = super().bound(rule, growing)
            return _measured(function, entry, clock, self.slots[self.code.relation_slot[rule.target]])

        def call_bulk(self, rule: BulkRule, loop: BulkLoop) -> None:
            entry = found[_family(rule)]
            with clock.measured(entry):
                super().call_bulk(rule, loop)
            entry.calls += 1

    start = time.perf_counter()
    result = program.evaluate_as(Measured, facts, keep)
    seconds = time.perf_counter() - start
    by_time = sorted(found.values(), key=lambda r: (-r.seconds, r.place))
    return Profile(result, seconds, tuple(by_time), _relations(by_time, result))


class _Clock:
    """Time by rule: what is derived for a rule that asks for it is the time of the rules that derive it."""

    def __init__(self) -> None:
        self.inner = 0.0  # seconds of rules that were run within the one that is measured

    @contextmanager
    def measured(self, entry: RuleProfile) -> Iterator[None]:
        """Count the time of what is done as that of a rule."""
        before, self.inner = self.inner, 0.0
        start = time.perf_counter()
        try:
            yield
        finally:
            seconds = time.perf_counter() - start
            entry.seconds += seconds - self.inner
            self.inner = before + seconds


def _measured(function: Callable[[Any, Any], None], entry: RuleProfile, clock: _Clock, full: Collection[Any]) -> Callable[[Any, Any], None]:
    def run(delta: Any, new: Any) -> None:
        counted = new if isinstance(new, set) else full
        before = len(counted)
        try:
            with clock.measured(entry):
                function(delta, new)
        finally:
            entry.calls += 1
            entry.rows += len(counted) - before

    return run


def _family(rule: Rule | BulkRule) -> str:
    """What the versions of one recursive rule, one for each delta, have in common."""
    return "_".join(rule.function.split("_")[:2])


def _relations(rules: Iterable[RuleProfile], result: Result) -> tuple[RelationProfile, ...]:
    grouped: dict[str, list[RuleProfile]] = {}
    for rule in rules:
        grouped.setdefault(rule.relation, []).append(rule)
    kept = set(result.names())
    found = [
        RelationProfile(name, sum(r.seconds for r in own), len(own), result.count(name) if name in kept else sum(r.rows for r in own))
        for name, own in grouped.items()
    ]
    return tuple(sorted(found, key=lambda r: (-r.seconds, r.relation)))


def profile_text(found: Profile, *, most: int = 20, shorten: Callable[[str], str] = str) -> str:
    """The rules and the relations that took longest."""
    rules = [(_milliseconds(r.seconds), str(r.rows), str(r.calls), r.relation, shorten(r.place)) for r in found.rules]
    relations = [(_milliseconds(r.seconds), str(r.rows), str(r.rules), r.relation) for r in found.relations]
    total = sum(r.seconds for r in found.rules)
    head = f"{_milliseconds(found.seconds)} ms, {_milliseconds(total)} ms of it in {len(rules)} rules\n"
    by_rule = _columns(("ms", "rows", "calls", "relation", "rule"), rules, most, 3)
    return head + "\n" + by_rule + "\n" + _columns(("ms", "rows", "rules", "relation"), relations, most, 3)


def _milliseconds(seconds: float) -> str:
    return f"{seconds * 1000:.1f}"


def _columns(names: tuple[str, ...], rows: Sequence[tuple[str, ...]], most: int, numbers: int) -> str:
    """A table; the first `numbers` columns are aligned to the right."""
    shown = [names, *rows[:most]]
    widths = [max(len(row[i]) for row in shown) for i in range(len(names))]
    lines = []
    for row in shown:
        cells = [c.rjust(w) if i < numbers else c.ljust(w) for i, (c, w) in enumerate(zip(row, widths, strict=True))]
        lines.append("  ".join(cells).rstrip())
    if len(rows) > most:
        lines.append(f"... {len(rows) - most} more")
    return "".join(f"{line}\n" for line in lines)
