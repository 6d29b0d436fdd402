"""Evaluation: loads rows into slots and runs the strata of generated code, semi-naive where they are recursive."""

from __future__ import annotations

import gc
import math
import time
import types as python_types
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, MutableMapping, Sequence, Set
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from rosarch.datalog.engine.plan import BulkRule, Code, Member, Origin, Rule, Stratum, TablePlan
from rosarch.datalog.engine.records import unpack_rows
from rosarch.datalog.engine.runtime import NAMES, EvaluationError, State, ordered
from rosarch.datalog.language.errors import DatalogError, Diagnostic, parse_location

if TYPE_CHECKING:
    from rosarch.datalog.engine.bulk import BulkLoop
    from rosarch.datalog.engine.on_demand import Table

Functions = Mapping[str, Callable[..., None]]
Facts = Mapping[str, Iterable[tuple[Any, ...]]]


PARTIAL_INDEXES = 3  # parts of an index that are made before all of it is
PARTIAL_READERS = 8  # rules; of an index that more of them read, one will ask for all of it
MANY_ROWS = 1 << 15  # rows from which on bitmaps are considered
PARTIAL_RATIO = 8  # a part is made when the relation has so many times more rows than keys are asked for


def load_functions(code: python_types.CodeType, names: Mapping[str, Any] = NAMES) -> dict[str, Any]:
    """Run a generated module; its namespace holds the functions of the rules."""
    namespace = dict(names)
    exec(code, namespace)
    return namespace


class Control:
    """The limits of one evaluation."""

    def __init__(self, limit_rows: int | None, time_limit: float | None) -> None:
        self.limit_rows = limit_rows
        self.deadline = None if time_limit is None else time.monotonic() + time_limit
        self.time_limit = time_limit
        self.active = limit_rows is not None or time_limit is not None

    def check(self, rule: Rule | BulkRule, rows: int) -> None:
        """Stop a program that has derived too much or run too long."""
        if self.limit_rows is not None and rows > self.limit_rows:
            self._stop(rule, f"more than {self.limit_rows} rows")
        if self.deadline is not None and time.monotonic() > self.deadline:
            self._stop(rule, f"still running after {self.time_limit:g} s")

    @staticmethod
    def _stop(rule: Rule | BulkRule, reason: str) -> None:
        raise failure(rule, f"evaluation stopped, `{rule.target}`: {reason}")


def failure(rule: Rule | BulkRule, message: str) -> DatalogError:
    """An error at the clause of a rule."""
    return DatalogError([Diagnostic(message, parse_location(rule.location))])


@contextmanager
def collector_paused() -> Iterator[None]:
    """Rows are acyclic; without the cyclic garbage collector, building millions of them is several times faster."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@dataclass(slots=True)
class _Bound:
    """A rule of a loop with what it works on, once that is known."""

    rule: Rule
    target: int  # position among the members of the stratum
    function: Callable[[Any, Any], None] | None = None


def _forget(rules: Iterable[Iterable[_Bound]]) -> None:
    """Relations are other objects now."""
    for bounds in rules:
        for bound in bounds:
            bound.function = None


class Evaluation:
    """One evaluation of a program: its relations and indexes, each in a slot, and the strata that fill them."""

    def __init__(self, code: Code, functions: Functions, facts: Facts, control: Control, state: State | None = None) -> None:
        self.code = code
        self.functions = functions
        self.control = control
        self.state = state or State()
        self.unpacked: set[int] = set()  # slots of relations that no bitmap can hold
        self.growing: Collection[int] = ()  # relations of the stratum that is run in rounds
        self.partial: dict[int, int] = {}  # how often a part of an index was made for one rule
        self.whole: set[str] = set()  # relations of tables that have been derived as a whole
        self.slots: list[Any] = []
        self.tables: list[Table] = []
        self.load(facts)

    def load(self, facts: Facts) -> None:
        """Fill the slots with what the rules begin with."""
        self.slots = [self.given(name, facts.get(name)) for name in self.code.relation_slot]
        self.slots += [None] * len(self.code.indexes)
        self.tables = self._new_tables()
        if self.code.uses_ordinals:
            self._number_symbols()

    def given(self, name: str, facts: Iterable[tuple[Any, ...]] | None) -> Collection[Any]:
        """The rows that a relation begins with: those of the program, and `facts`."""
        own = set(self._packed(name, self.code.facts.get(name, ())))
        if facts is None:
            return own
        rows = self._packed(name, _loaded(name, facts, self.code.arity[name]))
        if name in self.code.derived:
            return own.union(rows)
        return rows if isinstance(rows, Set) else _distinct(rows, name in self.code.probed)

    def run(self, keep: Collection[str]) -> dict[str, Collection[Any]]:
        """Run all strata; the rows of the `keep` relations, bare values for unary ones."""
        kept = {self.code.relation_slot[name] for name in keep}
        for stratum in self.code.strata:
            self.run_stratum(stratum)
            for slot in stratum.drops:
                if slot not in kept:
                    self.slots[slot] = None
        return self.rows(keep)

    def rows(self, keep: Collection[str]) -> dict[str, Collection[Any]]:
        """What was derived of some relations."""
        return {name: self._kept(name) for name in keep}

    def close(self) -> None:
        """Let go of all relations: tables and what derives them refer to each other, so that only the collector would find them."""
        for table in self.tables:
            table.close()
        self.tables = []
        self.slots = []

    def _packed(self, name: str, rows: Collection[Any]) -> Collection[Any]:
        """Rows from outside with their records as those of this evaluation."""
        columns = self.code.nested.get(name)
        return rows if columns is None else self.state.records.pack_rows(rows, columns, self.code.arity[name])

    def _kept(self, name: str) -> Collection[Any]:
        rows = self.slots[self.code.relation_slot[name]]
        columns = self.code.nested.get(name)
        if columns is not None:
            return unpack_rows(rows, columns, self.code.arity[name])
        return rows if name in self.code.derived else tuple(rows)  # else they may be the caller's

    def prepare(self, rule: Rule, growing: Collection[int] = ()) -> Callable[[Any, Any], None] | None:
        """The function of a rule as one of a delta and what takes new rows; None while a relation it needs is empty."""
        return self.bound(rule, growing) if self._has_needed(rule) else None

    def bound(self, rule: Rule, growing: Collection[int]) -> Callable[[Any, Any], None]:
        """The function of a rule whose relations are there, as one of a delta and what takes new rows."""
        slots = self.slots
        read = [slots[slot] for slot in rule.relations]
        read += [slots[slot] or self._index(slot, origins, growing) for slot, origins in rule.indexes]
        read += [self.tables[number] for number in rule.tables]
        return partial(self.functions[rule.function], self.state, slots[self.code.relation_slot[rule.target]], *read)

    def _has_needed(self, rule: Rule) -> bool:
        """Whether no relation is empty without which a rule derives nothing."""
        slots = self.slots
        return all(slots[slot] for slot in rule.required)

    def _new_tables(self) -> list[Table]:
        if not self.code.tables:
            return []
        from rosarch.datalog.engine.on_demand import make_table

        return [make_table(plan, self) for plan in self.code.tables]

    def whole_relation(self, plan: TablePlan) -> Collection[Any]:
        """All rows of a relation that is derived on demand."""
        if plan.whole is not None and plan.relation not in self.whole:
            self.whole.add(plan.relation)
            self.run_stratum(plan.whole)
        rows: Collection[Any] = self.slots[self.code.relation_slot[plan.relation]]
        return rows

    def rows_for_whole(self, plan: TablePlan) -> float:
        """How many rows, about, one goes through to find all rows of such a relation: for each rule those of the smallest that it needs."""
        if plan.whole is None:
            return math.inf
        slots = self.slots
        return sum(min((len(slots[slot]) for slot in rule.required), default=0) for rule in plan.whole.base)

    def prepare_for_table(self, rule: Rule, table: Table) -> Callable[..., None] | None:
        """The function of a rule as one of a key and what takes new rows; None while a relation it needs is empty."""
        if not self._has_needed(rule):
            return None
        read = [self.slots[slot] for slot in rule.relations]
        read += [self.slots[slot] or self._index(slot, (), ()) for slot, _ in rule.indexes]
        read += [self.tables[number] for number in rule.tables]
        return partial(self.functions[rule.function], self.state, table, *read)

    def call(self, rule: Rule, delta: Collection[Any] | None, new: Any, growing: Collection[int] = ()) -> None:
        """Call the function of a rule once."""
        function = self.prepare(rule, growing)
        if function is None:
            return
        try:
            function(delta, new)
        except EvaluationError as error:
            raise failure(rule, str(error)) from None
        except MemoryError:
            raise failure(rule, f"evaluation stopped, `{rule.target}`: out of memory") from None
        except OverflowError:
            if not self._unpack():
                raise
            self.call(rule, delta, new, growing)
        if self.control.active:
            self.control.check(rule, len(self.slots[self.code.relation_slot[rule.target]]) + (len(new) if isinstance(new, set) else 0))

    def _index(self, slot: int, origins: Sequence[Origin], growing: Collection[int]) -> Any:
        """The index of a slot, or for a rule that asks for few of its keys the part with these, which is not kept."""
        if self.slots[slot] is not None:
            return self.slots[slot]
        index = self.code.indexes[slot - len(self.code.relation_slot)]
        rows = self.slots[index.relation]
        if hasattr(rows, "by_first") and index.keys == (0,):
            return rows.by_first()  # pairs as bitmaps are indexed already
        if origins and not growing and index.readers <= PARTIAL_READERS and self.partial.get(slot, 0) < PARTIAL_INDEXES:
            counts = [(len(self.slots[self.code.relation_slot[o.relation]]), i) for i, o in enumerate(origins)]
            count, best = min(counts)
            if count * PARTIAL_RATIO < len(rows):
                self.partial[slot] = self.partial.get(slot, 0) + 1
                return index.build(rows, False, origins[best].column, self._values(origins[best]))
        self.slots[slot] = found = index.build(rows, index.relation in growing)
        return found

    def _values(self, origin: Origin) -> Collection[Any]:
        rows = self.slots[self.code.relation_slot[origin.relation]]
        return set(rows) if self.code.arity[origin.relation] == 1 else set(map(itemgetter(origin.values), rows))

    def _number_symbols(self) -> None:
        """Number all input symbols in sorted order, so that `ord` does not depend on the order of rows."""
        found: set[str] = set()
        for slot in self.code.relation_slot.values():
            for row in self.slots[slot]:
                found.update(v for v in (row if isinstance(row, tuple) else (row,)) if isinstance(v, str))
        self.state.ordinals.preload(sorted(found))

    def run_stratum(self, stratum: Stratum) -> None:
        """Run the rules of a stratum until nothing is new."""
        fresh: dict[str, set[Any]] = {m.name: set() for m in stratum.members} if stratum.chooses else {}
        for rule in stratum.base:
            self.call(rule, None, fresh.get(rule.target))
        if stratum.staged and (stratum.loop or fresh or any(m.subsumption for m in stratum.members)):
            self._run_rounds(stratum, fresh)
        elif stratum.loop:
            self._run_loop(stratum)

    def _run_loop(self, stratum: Stratum) -> None:
        """Semi-naive iteration: rules see the rows of a relation that were added since they last ran as `delta`."""
        members, slots, active = stratum.members, self.slots, self.control.active
        position = {m.name: i for i, m in enumerate(members)}
        growing, handled, enough = {m.full for m in members}, 0, MANY_ROWS
        pending: list[list[Any]] = [list(slots[m.full]) for m in members]
        rules = [[_Bound(r, position[r.target]) for r in stratum.loop if r.delta == m.name] for m in members]
        indexes = [(slot, j) for j, m in enumerate(members) for slot in m.indexes]
        known: dict[int, int] = {}  # how many of the pending rows an index has because it was built when they were there
        while any(pending):
            for i, delta in enumerate(pending):
                if not delta:
                    continue
                pending[i] = []
                if members[i].indexes:
                    self._extend_indexes(members[i], delta, known)
                for bound in rules[i]:
                    function = bound.function
                    if function is None:
                        if not self._has_needed(bound.rule):
                            continue
                        unbuilt = [(slot, j) for slot, j in indexes if slots[slot] is None]
                        function = bound.function = self.bound(bound.rule, growing)
                        known.update((slot, len(pending[j])) for slot, j in unbuilt if slots[slot] is not None)
                    try:
                        function(delta, pending[bound.target])
                    except (EvaluationError, MemoryError, OverflowError):
                        self.call(bound.rule, delta, pending[bound.target], growing)
                        _forget(rules)
                    if active:
                        self.control.check(bound.rule, len(slots[members[bound.target].full]))
                handled += len(delta)
            if handled >= enough:
                enough *= 2
                if stratum.bulk and self._run_bulk(stratum, {m.name: d for m, d in zip(members, pending, strict=True)}):
                    return
                if self._pack(members):
                    _forget(rules)

    def _pack(self, members: Iterable[Member]) -> bool:
        """Keep large sets of numbers as bitmaps; whether there were any."""
        found = [m.full for m in members if m.counts and m.full not in self.unpacked and isinstance(self.slots[m.full], set)]
        for slot in found:
            if len(self.slots[slot]) < MANY_ROWS:
                continue
            from pyroaring import BitMap

            try:
                self.slots[slot] = BitMap(self.slots[slot])
            except OverflowError:
                self.unpacked.add(slot)
        return bool(found)

    def _unpack(self) -> bool:
        """A number has come that no bitmap holds: keep sets as they are from now on. Whether there was a bitmap."""
        relations = range(len(self.code.relation_slot))
        self.unpacked.update(relations)
        found = [slot for slot in relations if type(self.slots[slot]).__name__ == "BitMap"]
        for slot in found:
            self.slots[slot] = set(self.slots[slot])
        if found:
            self.tables = self._new_tables()
        return bool(found)

    def _run_bulk(self, stratum: Stratum, deltas: Mapping[str, Iterable[Any]]) -> bool:
        """Go on over bitmaps, if the rows are such that it is worth it; whether they were."""
        from rosarch.datalog.engine import bulk

        if not bulk.worthwhile(max((self.slots[m.full] for m in stratum.members), key=len)):
            return False
        for member in stratum.members:
            for slot in member.indexes:
                self.slots[slot] = None
        if self.state.codes is None:
            self.state.codes = bulk.Codes()
        functions = load_functions(compile(self.code.bulk_source, "<datalog>", "exec"), bulk.NAMES)
        members = {m.name: m.full for m in stratum.members}
        loop = bulk.BulkLoop(stratum.bulk, functions, self.slots, members, deltas, self.state.codes)
        while True:
            for rule in stratum.bulk:
                self.call_bulk(rule, loop)
            if not loop.settle():
                break
        loop.finish()
        return True

    def call_bulk(self, rule: BulkRule, loop: BulkLoop) -> None:
        """Call the function of a bulk rule."""
        loop.call(rule)
        if self.control.active:
            self.control.check(rule, loop.growing[rule.target].rows)

    def _extend_indexes(self, member: Member, rows: Sequence[Any], known: MutableMapping[int, int]) -> None:
        """Add rows to the indexes of a relation, but for the first of them that an index knows already."""
        first = len(self.code.relation_slot)
        for slot in member.indexes:
            if self.slots[slot] is not None:
                self.code.indexes[slot - first].grow(self.slots[slot], rows[known.pop(slot, 0) :])

    # -- strict rounds: choice domains, subsumption, counters -----------------------------------------

    def _run_rounds(self, stratum: Stratum, fresh: dict[str, set[Any]]) -> None:
        """Iteration in which the rows of a round become visible together at its end."""
        slots, growing = self.slots, {m.full for m in stratum.members}
        self.growing = growing
        deltas: dict[str, set[Any]] = {}
        for member in stratum.members:
            if stratum.chooses:
                given = fresh[member.name] | slots[member.full]
                slots[member.full] = set()
                deltas[member.name] = self._merge(member, given)
            else:
                deltas[member.name] = set(slots[member.full])
                self._subsume(member, deltas[member.name])
        while any(deltas.values()):
            self.state.iteration += 1
            new: dict[str, set[Any]] = {m.name: set() for m in stratum.members}
            for rule in stratum.loop:
                if deltas[rule.delta]:
                    self.call(rule, deltas[rule.delta], new[rule.target], growing)
            if any(m.limit and len(slots[m.full]) >= m.limit for m in stratum.members):
                break
            deltas = {m.name: self._merge(m, new[m.name]) for m in stratum.members}
            for member in stratum.members if len(stratum.members) > 1 else ():
                if member.subsumption:  # a row may be dominated by way of new rows of the other relations
                    self._subsume(member, set(slots[member.full]))
                    deltas[member.name] &= slots[member.full]
        self.state.iteration = 0

    def _merge(self, member: Member, new: set[Any]) -> set[Any]:
        """Add the new rows of a relation to it and to its indexes; the rows that stay."""
        full = self.slots[member.full]
        if member.choices:
            new = _choose(member, full, new)
        if not new:
            return new
        full |= new
        self._extend_indexes(member, list(new), {})
        self._subsume(member, new)
        return new

    def _subsume(self, member: Member, delta: set[Any]) -> None:
        """Remove rows that another row dominates."""
        if not member.subsumption:
            return
        rejected: set[Any] = set()
        for rule in member.subsumption:
            if delta:
                self.call(rule, delta, rejected, self.growing)
        if rejected:
            self.slots[member.full] -= rejected
            delta -= rejected
            for slot in member.indexes:
                self.slots[slot] = None


def _distinct(rows: Collection[Any], probed: bool) -> Collection[Any]:
    """Rows each once, in the order in which they are given: that is mostly that in memory, which makes indexes in half the time."""
    unique = dict.fromkeys(rows)
    return unique if probed else list(unique)


def _loaded(name: str, rows: Iterable[tuple[Any, ...]], arity: int) -> Collection[Any]:
    """Rows as relations store them, after a check of their length; those of a set are left there."""
    rows = rows if isinstance(rows, (list, Set)) else list(rows)
    if set(map(len, rows)) - {arity}:
        wrong = next(row for row in rows if len(row) != arity)
        raise DatalogError(f"facts of `{name}`: expected {arity} column{'s' * (arity != 1)}, given {wrong!r}")
    return [row[0] for row in rows] if arity == 1 else rows


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
    return tuple(row[c] for c in columns) if type(row) is tuple else row  # a record is another type
