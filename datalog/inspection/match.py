"""Rule bodies matched against rows that are already there: what explanations are made of.

Literals are lifted as for the compiler (see `normalise`), put into an order that binds what they need, and run one
row at a time. Nothing is derived.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from rosarch.datalog.inspection.goals import ANY, fits, is_ground
from rosarch.datalog.inspection.rows import Row, RowStore
from rosarch.datalog.inspection.terms import Bound, Terms, opaque
from rosarch.datalog.language.domain import EvaluationError, domain
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.ground import grounded_variables, is_bound
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.normalise import Absent, Fold, Generate, Normaliser, Scan, Step
from rosarch.datalog.language.syntax import (
    Aggregate,
    Argument,
    Atom,
    Branch,
    Constraint,
    Literal,
    Nil,
    Number,
    Record,
    String,
    Truth,
    Unnamed,
    Variable,
    variables,
)  # fmt: skip
from rosarch.datalog.language.types import Types

if TYPE_CHECKING:
    from rosarch.datalog.inspection.clauses import Rule, Rules

HEAD = -1


@dataclass(frozen=True, slots=True)
class Contribution:
    """A row that an aggregate ranges over."""

    relation: str
    row: Row


@dataclass(frozen=True, slots=True)
class Folded:
    """The value of an aggregate and the rows it was made from."""

    aggregate: Aggregate
    value: Any
    rows: tuple[Contribution, ...]


@dataclass(slots=True)
class Match:
    """A satisfied body: values of the variables, the row of every positive atom, the aggregates, by literal."""

    bound: Bound
    rows: dict[int, Row] = field(default_factory=dict)
    folds: dict[int, tuple[Folded, ...]] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class Planned:
    """A step at its place in the order; `columns` are those bound before a scan, `first`: one row is enough."""

    literal: int
    step: Step
    columns: tuple[int, ...] = ()
    first: bool = False
    test: bool = False  # a constraint that binds nothing
    swapped: bool = False  # an equation that binds its left side


class Lifted:
    """The literals of a clause, or of a query, as steps, and what computes its terms: the same for all rows."""

    def __init__(self, literals: Sequence[Literal], head: Atom | None, types: Types, clause_types: ClauseTypes) -> None:
        self.types = types
        self.terms = Terms(types, clause_types)
        self.normaliser = Normaliser(clause_types)  # it keeps the terms alive that it makes
        given = grounded_variables(literals)
        self.steps: list[tuple[int, Step]] = []
        for number, literal in enumerate(literals):
            for step in self.normaliser.body([literal], given, top=True):
                self.steps.append((number, step))
        self.head_args: tuple[Argument, ...] = ()
        if head is not None:
            lifted: list[Step] = []
            self.head_args = self.normaliser.head(head, lifted, given).args
            self.steps += [(HEAD, step) for step in lifted]


class Body:
    """The literals of a clause, ready to be matched with the rows of a store."""

    def __init__(self, lifted: Lifted, store: RowStore) -> None:
        self.store = store
        self.types = lifted.types
        self.terms = lifted.terms
        self.steps = lifted.steps
        self.head_args = lifted.head_args
        self._plans: dict[tuple[frozenset[str], frozenset[str], bool], list[Planned]] = {}

    @classmethod
    def of(cls, rule: Rule, rules: Rules, store: RowStore) -> Body:
        """The body of a rule; what is the same for all stores is kept."""
        lifted = rules.lifted.get(rule.number)
        if lifted is None:
            lifted = rules.lifted[rule.number] = Lifted(rule.clause.body, rule.clause.head, rules.types, rule.types)
        return cls(lifted, store)

    # -- heads --------------------------------------------------------------------------------------

    def open(self, values: Sequence[Any]) -> tuple[Bound, list[tuple[Argument, Any]]] | None:
        """The bindings that a row gives to the head, and the terms to compare once their variables are bound.

        None when the head does not fit the row.
        """
        bound: Bound = {}
        later: list[tuple[Argument, Any]] = []
        work = list(zip(self.head_args, values, strict=True))
        while work:
            term, value = work.pop(0)
            if value is ANY:
                continue
            if isinstance(term, (Record, Branch)):
                parts = _parts(term, value)
                if parts is None:
                    return None
                work = parts + work
            elif isinstance(term, (Variable, Unnamed, String, Number, Nil)) and is_ground(value):
                if not self.terms.unify(term, value, bound):
                    return None
            elif not opaque(term):
                later.append((term, value))
        return bound, later

    def matches(self, values: Sequence[Any], wanted: Collection[str] = ()) -> Iterator[Match]:
        """The matches of the body that derive a row. Of relations not in `wanted` one row is enough."""
        opened = self.open(values)
        if opened is None:
            return
        bound, later = opened
        for found in self.solve(bound, wanted):
            if all(self.agrees(term, value, found.bound) for term, value in later):
                yield found

    def agrees(self, term: Argument, value: Any, bound: Bound) -> bool:
        """Whether a term of the head has the value, or fits the pattern, that is asked for."""
        try:
            return fits(value, self.terms.value(term, bound))
        except (EvaluationError, KeyError):
            return False

    # -- order --------------------------------------------------------------------------------------

    def plan(self, bound: Collection[str], wanted: Collection[str] = (), *, written: bool = False) -> list[Planned]:
        """The steps in the order they are run in when these variables are bound.

        Of several atoms the one with the fewest rows to expect comes first; with `written`, the first that shares a
        variable with what came before it.
        """
        key = frozenset(bound), frozenset(wanted), written
        found = self._plans.get(key)
        if found is None:
            head = {v for a in self.head_args for v in variables(a)}
            found = self._plans[key] = self._order(list(self.steps), set(bound), head, wanted, written)
        return found

    def _order(
        self, pending: list[tuple[int, Step]], bound: set[str], outside: set[str], wanted: Collection[str], written: bool = False
    ) -> list[Planned]:
        pending = [(n, s) for n, s in pending if not (isinstance(s, Constraint) and opaque(s))]
        result: list[Planned] = []
        while pending:
            chosen = next((p for p in pending if self._ready(p[1], bound)), None) or self._cheapest(pending, bound, written)
            pending.remove(chosen)
            number, step = chosen
            planned = Planned(number, step)
            if isinstance(step, Scan):
                planned.columns = tuple(i for i, a in enumerate(step.atom.args) if is_bound(a, bound))
                free = {v for a in step.atom.args for v in variables(a)} - bound
                used = outside | {v for _, s in pending for v in _used(s)}
                planned.first = step.atom.name not in wanted and not free & used
            elif isinstance(step, Constraint):
                planned.swapped = not is_bound(step.left, bound)
                planned.test = not planned.swapped and is_bound(step.right, bound)
            result.append(planned)
            bound |= _bound_by(step)
        return result

    @staticmethod
    def _ready(step: Step, bound: set[str]) -> bool:
        """Whether a step takes no loop."""
        match step:
            case Truth():
                return True
            case Constraint():
                left, right = is_bound(step.left, bound), is_bound(step.right, bound)
                if left and right:
                    return True
                return step.op == "=" and ((left and _is_pattern(step.right)) or (right and _is_pattern(step.left)))
            case Absent():
                return all(isinstance(a, Unnamed) or is_bound(a, bound) for a in step.atom.args)
            case Fold():
                return step.inputs <= bound
            case Scan():
                return all(is_bound(a, bound) for a in step.atom.args)
            case Generate():
                return False

    def _cheapest(self, pending: Sequence[tuple[int, Step]], bound: set[str], written: bool) -> tuple[int, Step]:
        best: tuple[float, int] | None = None
        for position, (_, step) in enumerate(pending):
            if isinstance(step, Scan):
                arity = max(len(step.atom.args), 1)
                free = sum(not is_bound(a, bound) for a in step.atom.args)
                cost = max(self.store.count(step.atom.name), 1) ** (free / arity) if not written else float(free == arity)
            elif isinstance(step, Generate) and all(is_bound(a, bound) for a in step.functor.args):
                cost = 100.0
            else:
                continue
            if best is None or (cost, position) < best:
                best = (cost, position)
        if best is None:
            raise DatalogError([Diagnostic("no order of evaluation binds every variable", _place(pending[0][1]))])
        return pending[best[1]]

    # -- running ------------------------------------------------------------------------------------

    def solve(self, bound: Bound, wanted: Collection[str] = ()) -> Iterator[Match]:
        """The matches of the body that agree with some bindings."""
        yield from self.run(self.plan(bound, wanted), 0, Match(dict(bound)), None)

    def run(self, plan: Sequence[Planned], start: int, state: Match, failed: Callable[[int, Match], None] | None) -> Iterator[Match]:
        """Run the steps from `start`; `failed` is called with where, and with which bindings, a step has no result."""
        if start == len(plan):
            yield state
            return
        planned, found = plan[start], False
        for after in self.step(planned, state):
            found = True
            yield from self.run(plan, start + 1, after, failed)
            if planned.first:
                break
        if not found and failed is not None:
            failed(start, state)

    def step(self, planned: Planned, state: Match) -> Iterator[Match]:
        """The states after one step."""
        step, bound = planned.step, state.bound
        try:
            match step:
                case Truth():
                    if step.value:
                        yield state
                case Absent():
                    if not self.blocking(step.atom, bound):
                        yield state
                case Constraint():
                    yield from self._constraint(step, planned, state)
                case Generate():
                    for value in self.terms.value(step.functor, bound):
                        if bound.get(step.variable, value) == value:
                            yield Match({**bound, step.variable: value}, state.rows, state.folds)
                case Fold():
                    yield from self._fold(planned.literal, step, state)
                case Scan():
                    yield from self._scan(planned, step, state)
        except EvaluationError:
            return

    def _constraint(self, step: Constraint, planned: Planned, state: Match) -> Iterator[Match]:
        if planned.test:
            if self.terms.holds(step, state.bound):
                yield state
            return
        source, target = (step.right, step.left) if planned.swapped else (step.left, step.right)
        now = dict(state.bound)
        if self.terms.unify(target, self.terms.value(source, now), now):
            yield Match(now, state.rows, state.folds)

    def candidates(self, atom: Atom, columns: tuple[int, ...], bound: Bound) -> Iterator[tuple[Row, Bound]]:
        """The rows that an atom matches, with the bindings after it."""
        key = tuple([self.terms.value(atom.args[c], bound) for c in columns])
        rest = [i for i in range(len(atom.args)) if i not in columns]
        for row in self.store.matching(atom.name, columns, key):
            now = dict(bound)
            if all(self.terms.unify(atom.args[i], row[i], now) for i in rest):
                yield row, now

    def _scan(self, planned: Planned, step: Scan, state: Match) -> Iterator[Match]:
        if len(planned.columns) == len(step.atom.args):
            row = tuple([self.terms.value(a, state.bound) for a in step.atom.args])
            if self.store.has(step.atom.name, row):
                yield Match(state.bound, {**state.rows, planned.literal: row}, state.folds)
            return
        for row, now in self.candidates(step.atom, planned.columns, state.bound):
            yield Match(now, {**state.rows, planned.literal: row}, state.folds)

    def blocking(self, atom: Atom, bound: Bound) -> Row | None:
        """A row that makes a negated atom false."""
        columns = tuple(i for i, a in enumerate(atom.args) if not isinstance(a, Unnamed))
        if len(columns) == len(atom.args):
            row = tuple([self.terms.value(a, bound) for a in atom.args])
            return row if self.store.has(atom.name, row) else None
        return next((row for row, _ in self.candidates(atom, columns, bound)), None)

    # -- aggregates ---------------------------------------------------------------------------------

    def _fold(self, literal: int, step: Fold, state: Match) -> Iterator[Match]:
        folded = self.folded(step, state.bound)
        if folded is None or state.bound.get(step.variable, folded.value) != folded.value:
            return
        folds = {**state.folds, literal: (*state.folds.get(literal, ()), folded)}
        yield Match({**state.bound, step.variable: folded.value}, state.rows, folds)

    def folded(self, step: Fold, bound: Bound) -> Folded | None:
        """The value of an aggregate; None when it has none."""
        inner = {k: v for k, v in bound.items() if k in step.inputs}
        names = {s.atom.name for s in step.steps if isinstance(s, Scan)}
        outside = set(step.distinct) | (variables(step.target) if step.target is not None else set())
        numbered = list(enumerate(step.steps))
        plan = self._order(numbered, set(inner), outside, names)
        values: list[Any] = []
        seen: set[Any] = set()
        sources: list[tuple[Any, list[Contribution]]] = []
        for found in self.run(plan, 0, Match(inner), None):
            if step.distinct:
                key = tuple(found.bound[v] for v in step.distinct if v)
                if key in seen:
                    continue
                seen.add(key)
            value = 1 if step.target is None else self.terms.value(step.target, found.bound)
            values.append(value)
            parts = [Contribution(s.atom.name, found.rows[n]) for n, s in numbered if isinstance(s, Scan)]
            sources.append((value, parts))
        result = self._combined(step, values)
        if result is None:
            return None
        extreme = step.aggregate.op in ("min", "max")
        rows = dict.fromkeys(part for value, parts in sources if not extreme or value == result for part in parts)
        return Folded(step.aggregate, result, tuple(rows))

    def _combined(self, step: Fold, values: Sequence[Any]) -> Any:
        kind = self.terms.expressions.kind(step.aggregate)
        numbers = domain(self.types.bits)
        match step.aggregate.op:
            case "count":
                return len(values)
            case "min" | "max" as op:
                return (min(values) if op == "min" else max(values)) if values else None
            case "mean":
                return numbers.single(math.fsum(values) / len(values)) if values else None
            case _ if kind == "f":
                return numbers.single(math.fsum(values))
            case _:
                total = sum(values)
                return numbers.wrap(total) if kind == "i" else numbers.wrap_unsigned(total)


def _parts(term: Record | Branch, value: Any) -> list[tuple[Argument, Any]] | None:
    """The arguments of a record with their values; None when the value is of another shape."""
    if isinstance(term, Branch):
        return list(zip(term.args, value[1:], strict=True)) if value[0] == term.name else None
    return None if value is None else list(zip(term.args, value, strict=True))


def _is_pattern(term: Argument) -> bool:
    return isinstance(term, (Variable, Unnamed, Record, Branch))


def _used(step: Step) -> set[str]:
    """The variables that a step reads or binds."""
    match step:
        case Scan() | Absent():
            return {v for a in step.atom.args for v in variables(a)}
        case Generate():
            return {step.variable, *variables(step.functor)}
        case Fold():
            return {step.variable, *step.inputs}
        case Constraint():
            return variables(step)
        case _:
            return set()


def _bound_by(step: Step) -> set[str]:
    """The variables that have a value after a step."""
    match step:
        case Scan():
            return _used(step)
        case Constraint() if step.op == "=":
            return _used(step)
        case Generate() | Fold():
            return {step.variable}
        case _:
            return set()


def _place(step: Step) -> Any:
    return getattr(step, "location", None) or getattr(getattr(step, "atom", None), "location", None)
