"""Evaluations of one program, one after the other: what facts that differ from earlier ones do not reach is derived once.

Strata are run in their order, when rows are asked for that depend on them. One that reads no relation with other rows than in an
earlier evaluation takes over its rows from there, with their indexes; one that has to be run, and comes to the rows that it had, changes
nothing for those after it. Nothing is approximated: the rows are those of an evaluation from the beginning.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import reduce
from operator import or_
from typing import Any

from rosarch.datalog.engine.engine import Control, Evaluation, Facts, Functions
from rosarch.datalog.engine.on_demand import make_table
from rosarch.datalog.engine.plan import Code, Rule, Stratum, TablePlan

KEPT = 8
"""Evaluations of a series of which all rows are kept."""
SHARE = 10
"""One is worth it that had to run at least one stratum of so many."""
Slots = int
"""A set of relations: the bits at their slots."""
Strata = int
"""A set of strata: the bits at their numbers."""


class Reading:
    """Which relations and tables the strata of a program read, also by way of other tables."""

    def __init__(self, code: Code) -> None:
        rules = [table.all_rules() for table in code.tables]
        asked = [{other for rule in own for other in rule.tables} for own in rules]
        read = [_slots(code, own) for own in rules]
        self._asked = [_closure(number, asked) for number in range(len(code.tables))]
        self._read = [_union(read[other] for other in closed) for closed in self._asked]
        self._indexes: Mapping[int, list[int]] = defaultdict(list)
        for number, index in enumerate(code.indexes, len(code.relation_slot)):
            self._indexes[index.relation].append(number)
        self.strata = [(stratum, *self._of(code, stratum)) for stratum in code.strata if stratum.rules()]
        self._needed = self._strata_needed(code)
        self._asking: Mapping[int, Strata] = defaultdict(int)
        for number, (_, _, tables) in enumerate(self.strata):
            for table in tables:
                self._asking[table] |= 1 << number

    def needed(self, relation: str) -> Strata:
        """The strata that the rows of a relation depend on."""
        return self._needed.get(relation, 0)

    def _strata_needed(self, code: Code) -> Mapping[str, Strata]:
        """The same for all relations that have rules: those of strata come later than what they read."""
        names = {slot: name for name, slot in code.relation_slot.items()}
        found: dict[str, Strata] = {}
        for number, (stratum, reads, _) in enumerate(self.strata):
            needed = _union(found.get(names[slot], 0) for slot in _members(reads)) | 1 << number
            found.update((member.name, needed) for member in stratum.members)
        return found

    def _of(self, code: Code, stratum: Stratum) -> tuple[Slots, Collection[int]]:
        """The relations of a stratum, those that it reads, and the tables."""
        tables = {other for rule in stratum.rules() for number in rule.tables for other in self._asked[number]}
        members = _union(1 << member.full for member in stratum.members)
        return members | _slots(code, stratum.rules()) | _union(self._read[number] for number in tables), tables

    def asking(self, table: int) -> Strata:
        """The strata that ask a table."""
        return self._asking[table]

    def reads(self, table: int) -> Slots:
        """The relations that a table is derived from."""
        return self._read[table]

    def indexes(self, relation: int) -> Sequence[int]:
        """The slots of the indexes of a relation."""
        return self._indexes[relation]


def _slots(code: Code, rules: Iterable[Rule]) -> Slots:
    return _union(1 << slot for rule in rules for slot in code.relations_of(rule))


def _closure(table: int, asked: Sequence[set[int]]) -> set[int]:
    """A table, with all that are asked for it."""
    found, waiting = {table}, [table]
    while waiting:
        more = asked[waiting.pop()] - found
        found |= more
        waiting += more
    return found


def _union(sets: Iterable[Slots]) -> Slots:
    return reduce(or_, sets, 0)


def _members(numbers: int) -> Iterator[int]:
    """The numbers of a set, in their order."""
    while numbers:
        yield (numbers & -numbers).bit_length() - 1
        numbers &= numbers - 1


class Again(Evaluation):
    """An evaluation of a series, which takes over rows of the one `before`, if there is one."""

    def __init__(self, series: Series, before: Again | None, code: Code, functions: Functions, facts: Facts, control: Control) -> None:
        self.series = series
        self.reading = series.reading
        self.before = before
        self.facts = facts
        self.changed: Slots = 0  # relations with other rows than before
        self.settled: Strata = 0  # what was run, or taken over
        self.count = 0  # of those that were run
        # what had been settled in the evaluations before, the nearest first, and changed there, when this one began
        self.earlier: Sequence[tuple[Strata, Slots]] = ((before.settled, before.changed), *before.earlier) if before else ()
        self._taken_over: set[int] = set()  # tables
        super().__init__(code, functions, facts, control, before.state if before else None)

    def load(self, facts: Facts) -> None:
        """Take over all slots, but for those of facts that differ."""
        if self.before is None:
            super().load(facts)
            return
        self.slots, self.tables = list(self.before.slots), list(self.before.tables)
        self._taken_over.update(range(len(self.tables)))
        for name in differing(facts, self.before.facts):
            self.changed |= 1 << self._begin(name)

    def rows(self, keep: Collection[str]) -> dict[str, Collection[Any]]:
        """The rows of some relations; the strata that they depend on, and that changes reach, are run."""
        needed = _union(map(self.reading.needed, keep)) & ~self.settled
        for number in _members(needed):
            stratum, reads, tables = self.reading.strata[number]
            if not self._holds(1 << number, reads):
                self.count += 1
                self._run(stratum, tables)
            self.settled |= 1 << number
        if needed and self.count * SHARE >= self.settled.bit_count():
            self.series.keep(self)
        return super().rows(keep)

    def _holds(self, strata: Strata, reads: Slots) -> bool:
        """Whether what was derived from `reads`, by the nearest evaluation before that settled any of `strata`, would be the same here."""
        changed = self.changed
        for settled, changed_there in self.earlier:
            if settled & strata:
                return not reads & changed
            changed |= changed_there
        return False

    def close(self) -> None:
        """Let go of all relations, unless later evaluations may take them over."""
        if not self.series.keeps(self):
            self.release()

    def release(self) -> None:
        """Let go of all relations, but for what is of the evaluation before."""
        self.tables = [table for number, table in enumerate(self.tables) if number not in self._taken_over]
        super().close()

    def whole_relation(self, plan: TablePlan) -> Collection[Any]:
        """All rows of a relation that is derived on demand, for a table of this evaluation: the one before has other rows."""
        if plan.relation not in self.whole:
            self._begin(plan.relation)
        return super().whole_relation(plan)

    def _begin(self, name: str) -> int:
        """Let a relation have the rows that it begins with; its slot."""
        slot = self.code.relation_slot[name]
        self.slots[slot] = self.given(name, self.facts.get(name))
        for index in self.reading.indexes(slot):
            self.slots[index] = None
        return slot

    def _run(self, stratum: Stratum, tables: Iterable[int]) -> None:
        """Run a stratum that reads `tables`; its relations have changed if they have other rows than before."""
        for number in self._taken_over.intersection(tables):  # all that these are derived from is there
            if not self._holds(self.reading.asking(number), self.reading.reads(number)):
                self._taken_over.remove(number)
                self.tables[number] = make_table(self.code.tables[number], self)
        slots = [member.full for member in stratum.members]
        before = [{same: self.slots[same] for same in (slot, *self.reading.indexes(slot))} for slot in slots]
        for member in stratum.members:
            self._begin(member.name)
        self.run_stratum(stratum)
        for slot, known in zip(slots, before, strict=True):
            if _alike(self.slots[slot], known[slot]):
                for same, value in known.items():
                    self.slots[same] = value
            else:
                self.changed |= 1 << slot


def differing(facts: Facts, others: Facts) -> list[str]:
    """The relations whose facts may not be the same."""
    return [name for name in facts.keys() | others.keys() if not _alike(facts.get(name, ()), others.get(name, ()))]


def _alike(rows: Any, others: Any) -> bool:
    """Whether two collections are known to have the same rows."""
    return rows is others or (type(rows) is type(others) and rows == others)


class Series:
    """Makes the evaluations of one program. Each takes over rows of that one among the kept whose facts differ least from its own."""

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self._kept: list[Again] = []

    def evaluation(self, code: Code, functions: Functions, facts: Facts, control: Control) -> Evaluation:
        """The next evaluation."""
        before = min(self._kept, key=lambda one: len(differing(facts, one.facts)), default=None)
        return Again(self, before, code, functions, facts, control)

    def keep(self, evaluation: Again) -> None:
        """Keep all rows of an evaluation, unless there are enough."""
        if len(self._kept) < KEPT and evaluation not in self._kept:
            self._kept.append(evaluation)

    def keeps(self, evaluation: Again) -> bool:
        """Whether its rows are kept."""
        return evaluation in self._kept

    def close(self) -> None:
        """Let go of all relations."""
        for one in reversed(self._kept):
            one.release()
        self._kept = []
