"""Evaluation: loads rows into slots and runs the strata of generated code, semi-naive where they are recursive."""

from __future__ import annotations

import gc
import time
import types as python_types
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from .compile import Code, Member, Rule, Stratum
from .errors import DatalogError, Diagnostic
from .runtime import NAMES, EvaluationError, State, ordered

Slots = list[Any]
Functions = Mapping[str, Callable[[Slots, State], None]]


def load_functions(code: python_types.CodeType) -> dict[str, Any]:
    """Run the generated module; its namespace holds the rule and index functions."""
    namespace: dict[str, Any] = dict(NAMES)
    exec(code, namespace)
    return namespace


class Control:
    """The limits of one evaluation."""

    def __init__(self, limit_rows: int | None, time_limit: float | None) -> None:
        self.limit_rows = limit_rows
        self.deadline = None if time_limit is None else time.monotonic() + time_limit
        self.time_limit = time_limit
        self.active = limit_rows is not None or time_limit is not None

    def check(self, rule: Rule, rows: int) -> None:
        """Stop a program that has derived too much or run too long."""
        if self.limit_rows is not None and rows > self.limit_rows:
            self._stop(rule, f"more than {self.limit_rows} rows")
        if self.deadline is not None and time.monotonic() > self.deadline:
            self._stop(rule, f"still running after {self.time_limit:g} s")

    @staticmethod
    def _stop(rule: Rule, reason: str) -> None:
        raise DatalogError([Diagnostic(f"{rule.location}: evaluation stopped, `{rule.target}`: {reason}")])


@contextmanager
def _collector_paused() -> Iterator[None]:
    """Rows are acyclic; without the cyclic garbage collector, building millions of them is several times faster."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def evaluate(
    code: Code, functions: Functions, facts: Mapping[str, Iterable[tuple[Any, ...]]], *, keep: Collection[str],
    limit_rows: int | None = None, time_limit: float | None = None,
) -> dict[str, Collection[Any]]:  # fmt: skip
    """The rows of the `keep` relations; rows of unary relations are bare values."""
    slots: Slots = [None] * code.slots
    for name, slot in code.relation_slot.items():
        slots[slot] = set(code.facts.get(name, ()))
    state = State()
    for name, rows in facts.items():
        slots[code.relation_slot[name]].update(_loaded(name, list(rows), code.arity[name]))
    if code.uses_ordinals:
        _number_symbols(slots, code, state)
    control = Control(limit_rows, time_limit)
    kept = set(keep)
    with _collector_paused():
        for stratum in code.strata:
            _run_stratum(stratum, slots, state, functions, control)
            for name, dead in stratum.drops:
                for slot in dead:
                    if slot != code.relation_slot[name] or name not in kept:
                        slots[slot] = None
    return {name: slots[code.relation_slot[name]] for name in keep}


def _loaded(name: str, rows: list[tuple[Any, ...]], arity: int) -> list[Any]:
    """Rows as relations store them, after a check of their length."""
    if set(map(len, rows)) - {arity}:
        wrong = next(row for row in rows if len(row) != arity)
        raise DatalogError(f"facts of `{name}`: expected {arity} column{'s' * (arity != 1)}, given {wrong!r}")
    return [row[0] for row in rows] if arity == 1 else rows


def _number_symbols(slots: Slots, code: Code, state: State) -> None:
    """Number all input symbols in sorted order, so that `ord` does not depend on the order of rows."""
    found: set[str] = set()
    for slot in code.relation_slot.values():
        for row in slots[slot]:
            found.update(v for v in (row if isinstance(row, tuple) else (row,)) if isinstance(v, str))
    state.ordinals.preload(sorted(found))


def _call(rule: Rule, slots: Slots, state: State, functions: Functions) -> None:
    try:
        functions[rule.function](slots, state)
    except EvaluationError as error:
        raise DatalogError([Diagnostic(f"{rule.location}: {error}")]) from None


def _run_stratum(stratum: Stratum, slots: Slots, state: State, functions: Functions, control: Control) -> None:
    members = {m.name: m for m in stratum.members}
    if stratum.staged:
        for member in stratum.members:
            slots[member.new] = set()
    for rule in stratum.base:
        _call(rule, slots, state, functions)
        if control.active:
            control.check(rule, len(slots[members[rule.target].full]))
    if stratum.loop or stratum.staged or any(m.subsumption for m in stratum.members):
        _run_loop(stratum, members, slots, state, functions, control)


def _run_loop(stratum: Stratum, members: dict[str, Member], slots: Slots, state: State, functions: Functions, control: Control) -> None:
    """Semi-naive iteration: rules see the rows that were new in the previous round as `delta`."""
    for member in stratum.members:
        if stratum.staged:
            for row in slots[member.full]:
                slots[member.new].add(row)
            slots[member.full] = set()
            _merge(member, slots, state, functions)
        else:
            slots[member.delta] = set(slots[member.full])
            _subsume(member, slots, state, functions)
    while any(slots[m.delta] for m in stratum.members):
        state.iteration += 1
        for member in stratum.members:
            slots[member.new] = set()
        for rule in stratum.loop:
            _call(rule, slots, state, functions)
            if control.active:
                member = members[rule.target]
                control.check(rule, len(slots[member.full]) + len(slots[member.new]))
        for member in stratum.members:
            _merge(member, slots, state, functions)
    state.iteration = 0
    for member in stratum.members:
        slots[member.delta] = slots[member.new] = None


def _merge(member: Member, slots: Slots, state: State, functions: Functions) -> None:
    """Move the new rows of a relation into it, into its indexes and into its delta."""
    new = slots[member.new]
    if member.choices:
        new = _choose(member, slots[member.full], new)
    slots[member.delta] = new
    if not new:
        return
    slots[member.full] |= new
    for slot, grow in member.indexes:
        if slots[slot] is not None:
            functions[grow](slots[slot], new)
    if member.subsumption:
        _subsume(member, slots, state, functions)


def _choose(member: Member, full: set[Any], new: set[Any]) -> set[Any]:
    """The new rows, in sorted order, that do not clash with an earlier row on a choice domain."""
    taken = [{_key(row, columns) for row in full} for columns in member.choices]
    chosen = set()
    for row in ordered(new):
        keys = [_key(row, columns) for columns in member.choices]
        if any(key in seen for key, seen in zip(keys, taken, strict=True)):
            continue
        chosen.add(row)
        for key, seen in zip(keys, taken, strict=True):
            seen.add(key)
    return chosen


def _key(row: Any, columns: tuple[int, ...]) -> Any:
    return tuple(row[c] for c in columns) if isinstance(row, tuple) else row


def _subsume(member: Member, slots: Slots, state: State, functions: Functions) -> None:
    """Remove rows that another row dominates."""
    if not member.subsumption:
        return
    rejected: set[Any] = set()
    slots[member.delta + 1] = rejected
    for rule in member.subsumption:
        _call(rule, slots, state, functions)
    if rejected:
        slots[member.full] -= rejected
        slots[member.delta] -= rejected
        for slot, _ in member.indexes:
            slots[slot] = None
