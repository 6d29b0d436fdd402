"""Tables: the rows of a relation that have a key, found when that key is first asked for."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable
from operator import itemgetter
from typing import Any, NamedTuple, Protocol

from rosarch.datalog.engine.engine import failure
from rosarch.datalog.engine.indexes import Index
from rosarch.datalog.engine.plan import Rule, TablePlan
from rosarch.datalog.language.domain import EvaluationError

Rows = tuple[Any, ...]
NONE: Rows = ()
FOUND: Rows = ((),)  # what a table has for a key that is a whole row
KEY_ROWS = 5  # rows that rules go through in the time that it takes to ask for a key
Find = Callable[..., None]  # given a key, perhaps rows that are new, and a set for what it finds


class _Prepared(NamedTuple):
    """A rule with its function."""

    rule: Rule
    find: Find


class Deriving(Protocol):
    """What a table asks of the evaluation that it is part of."""

    def prepare_for_table(self, rule: Rule, table: Table) -> Find | None:
        """The function of a rule; None when it finds nothing."""

    def whole_relation(self, plan: TablePlan) -> Collection[Any]:
        """All rows of the relation of a table."""

    def rows_for_whole(self, plan: TablePlan) -> float:
        """How many rows, about, one goes through to find all rows; none if they cannot be found at once."""


class Table(defaultdict[Any, Rows]):
    """What is left of the rows of each key that has been asked for; by `[]` a key is asked for."""

    def __init__(self, plan: TablePlan, evaluation: Deriving) -> None:
        super().__init__(tuple)
        self.plan = plan
        self._evaluation = evaluation
        self._rules: list[_Prepared] = []
        self._loop: list[_Prepared] = []
        self._enough: float = 0  # keys that have been asked for when the table looks at how to go on

    def __missing__(self, key: Any) -> Rows:
        if len(self) >= self._enough and self._prepare():
            return self[key]
        self[key] = found = tuple(self._derived_rows(key))
        return found

    def close(self) -> None:
        """Let go of the rules, with the relations that they read."""
        self._rules, self._loop = [], []

    def _prepare(self) -> bool:
        """Make the rules ready, or after many keys find all rows. Whether all are there: then no key needs Python any more."""
        if not self._enough:
            self._rules, self._loop = self._prepared(self.plan.rules), self._prepared(self.plan.loop)
            if self._rules:
                self._enough = 1 + self._evaluation.rows_for_whole(self.plan) / KEY_ROWS
                return False
        else:
            self._fill()
        self.__class__ = _Filled
        return True

    def _fill(self) -> None:
        """Find the rows of all keys."""
        plan = self.plan
        rows = self._evaluation.whole_relation(plan)
        if plan.arity == len(plan.keys):
            self.update(dict.fromkeys(map(itemgetter(*plan.keys), rows) if plan.arity > 1 else rows, FOUND))
        else:
            self.update(Index(0, plan.arity, plan.keys, (), True).build(rows, False))

    def _derived_rows(self, key: Any) -> set[Any]:
        """What the rules derive for a key."""
        found: set[Any] = set()
        prepared = None
        try:
            for prepared in self._rules:
                prepared.find(key, found)
            delta = found if self._loop else None
            while delta:  # what follows from the rows of the same key, until there are no more
                new: set[Any] = set()
                rows = self._rows(key, delta)
                for prepared in self._loop:
                    prepared.find(key, rows, new)
                delta = new - found
                found |= delta
        except EvaluationError as error:
            raise (failure(prepared.rule, str(error)) if prepared else error) from None
        return found

    def _prepared(self, rules: Iterable[Rule]) -> list[_Prepared]:
        return [_Prepared(rule, find) for rule in rules if (find := self._evaluation.prepare_for_table(rule, self))]

    def _rows(self, key: Any, values: Iterable[Any]) -> list[Any]:
        """Whole rows of the values that are left of them."""
        plan = self.plan
        if plan.arity - len(plan.keys) != 1:
            return list(values) if plan.arity > len(plan.keys) else [key]
        parts = (key,) if len(plan.keys) == 1 else key
        at = next(i for i in range(plan.arity) if i not in plan.keys)
        columns = dict(zip(plan.keys, parts, strict=True))
        return [tuple(value if i == at else columns[i] for i in range(plan.arity)) for value in values]


class _Filled(Table):
    """A table that has all rows: other keys have none."""

    __missing__ = defaultdict.__missing__  # type: ignore[assignment]


class RecursiveTable(Table):
    """A table whose rules ask it for other keys: these are found first, those that ask for each other in rounds."""

    def __init__(self, plan: TablePlan, evaluation: Deriving) -> None:
        super().__init__(plan, evaluation)
        self._asked: list[Any] | None = None  # unknown keys that the rules have asked for, while one is looked for

    def __missing__(self, key: Any) -> Rows:
        if self._asked is not None:
            self._asked.append(key)
            return NONE
        if len(self) >= self._enough and self._prepare():
            return self[key]
        try:
            self._settle(key)
        finally:
            self._asked = None
        return self[key]

    def _settle(self, key: Any) -> None:
        """Find the rows of a key after those of the keys that it needs."""
        path = {key: None}
        while path:
            last = next(reversed(path))
            self._asked = []
            found = self._derived_rows(last)
            waiting = [k for k in dict.fromkeys(self._asked) if k not in path]
            if waiting:
                path.update(dict.fromkeys(waiting))
            elif self._asked:
                self._settle_together(list(path))
                return
            else:
                self[last] = tuple(found)
                del path[last]

    def _settle_together(self, keys: list[Any]) -> None:
        """Find the rows of keys some of which need each other, from none on, until there are no more."""
        known: dict[Any, set[Any]] = {key: set() for key in keys}
        self.update(dict.fromkeys(keys, ()))
        changed = True
        while changed:
            changed = False
            for key in list(known):
                self._asked = []
                found = self._derived_rows(key)
                for other in self._asked:
                    if other not in known:
                        known[other], self[other], changed = set(), (), True
                if len(found) > len(known[key]):
                    known[key], self[key], changed = found, tuple(found), True


def make_table(plan: TablePlan, evaluation: Deriving) -> Table:
    """A table in which nothing has been asked for."""
    return RecursiveTable(plan, evaluation) if plan.recursive else Table(plan, evaluation)
