"""`why_not`: for a row that is not there, how far each rule gets, and what the first literal that fails came close to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rosarch.datalog.inspection.clauses import Rule, Rules, rules_of
from rosarch.datalog.inspection.goals import Goal, parse_goal, show_goal
from rosarch.datalog.inspection.match import HEAD, Body, Folded, Match, Planned
from rosarch.datalog.inspection.prover import matching_rows
from rosarch.datalog.inspection.rows import Given, Row, RowStore, row_store
from rosarch.datalog.language.errors import Location
from rosarch.datalog.language.ground import is_bound
from rosarch.datalog.language.normalise import Absent, Fold, Scan
from rosarch.datalog.language.show import Writer, show_row, show_term
from rosarch.datalog.language.syntax import Argument, Atom

if TYPE_CHECKING:
    from rosarch.datalog.program import Program

LIMIT = 200_000  # failed attempts per rule
MOST_ATTEMPTS = 50  # of equal depth, compared by their nearest rows
MOST_COMPARED = 2_000_000
MOST_NEAREST = 3


@dataclass(frozen=True, slots=True)
class RuleFailure:
    """How far one rule gets: the literals that hold, in the order tried, then the one that fails.

    `reason` is `head` (the head does not fit the row), `no row`, `present` (of a negation: `nearest` is the row that
    is there), `false` (a constraint), `value` (an aggregate has another value, or none), or `lost` (the body holds: a
    subsumption or a choice-domain removed the row). `attempts` is the number of bindings that got as far.
    """

    location: Location
    rule: str
    reason: str
    holds: tuple[str, ...] = ()
    failed: str = ""
    nearest: tuple[str, ...] = ()
    attempts: int = 1


@dataclass(frozen=True, slots=True)
class WhyNot:
    """Why a goal has no row; `rows` is not empty when it has. `nearest` are rows of the relation itself."""

    goal: str
    relation: str
    rows: tuple[str, ...]
    failures: tuple[RuleFailure, ...]
    nearest: tuple[str, ...]
    is_input: bool


class _Enough(Exception):
    """The limit of attempts is reached."""


def why_not(program: Program, rows: Given, goal: str, *, engine: str = "embedded") -> WhyNot:
    """How far every rule of a relation gets towards a row, or towards any that fits a pattern.

    `rows`: a result with the rows of all relations (`keep="all"`), or facts to evaluate.
    """
    store = row_store(program, rows, engine=engine)
    rules = rules_of(program)
    wanted = parse_goal(goal, rules.relations, rules.types)
    finder = _Finder(rules, store)
    type_names = [a.type for a in rules.relations[wanted.relation].attributes]
    present = tuple(finder.text(wanted.relation, row) for row in matching_rows(store, wanted))
    own = [r for r in rules.by_head.get(wanted.relation, ()) if r.clause.dominating is None]
    failures = () if present else tuple(finder.failure(rule, wanted) for rule in own)
    is_input = any(d.kind == "input" and d.relation == wanted.relation for d in rules.unit.directives)
    near = [] if present else finder.nearest(wanted.relation, dict(enumerate(wanted.args)))[1]
    text = show_goal(wanted, type_names, rules.types)
    return WhyNot(text, wanted.relation, present, _most_informative_first(failures), tuple(near), is_input)


def _most_informative_first(failures: Sequence[RuleFailure]) -> tuple[RuleFailure, ...]:
    """Rules that cannot make such a row, as their head shows, come last."""
    return tuple(sorted(failures, key=lambda f: f.reason == "head"))


class _Finder:
    def __init__(self, rules: Rules, store: RowStore) -> None:
        self.rules = rules
        self.store = store

    def text(self, relation: str, row: Row) -> str:
        return show_row(relation, row, [a.type for a in self.rules.relations[relation].attributes], self.rules.types)

    def failure(self, rule: Rule, goal: Goal) -> RuleFailure:
        body = Body.of(rule, self.rules, self.store)
        opened = body.open(goal.args)
        plain = Writer(self.rules.types, rule.types)
        if opened is None:
            return RuleFailure(rule.location, rule.text, "head", failed=plain.literal(rule.clause.head))
        bound, later = opened
        plan = body.plan(bound, written=True)
        deepest, attempts = -1, 0
        kept: list[Match] = []
        total = 0

        def failed(position: int, state: Match) -> None:
            nonlocal deepest, attempts, total, kept
            total += 1
            if position > deepest:
                deepest, attempts, kept = position, 0, []
            if position == deepest:
                attempts += 1
                if len(kept) < MOST_ATTEMPTS:
                    kept.append(state)
            if total >= LIMIT:
                raise _Enough

        whole: list[Match] = []
        try:
            for found in body.run(plan, 0, Match(dict(bound)), failed):
                whole.append(found)
                if all(body.agrees(term, value, found.bound) for term, value in later) or len(whole) >= LIMIT:
                    break
        except _Enough:
            pass
        if whole:
            return self._whole(rule, body, plan, whole, later)
        return self._stuck(rule, body, plan, deepest, kept, attempts)

    def _whole(
        self, rule: Rule, body: Body, plan: Sequence[Planned], found: list[Match], later: Sequence[tuple[Argument, Any]]
    ) -> RuleFailure:
        """The body holds, but gives other values, or the row was removed again."""
        last = found[-1]
        writer = Writer(self.rules.types, rule.types, last.bound)
        holds = self._holds(rule, plan, writer)
        for term, value in later:
            if not body.agrees(term, value, last.bound):
                wrong = Writer(self.rules.types, rule.types, found[0].bound)
                return RuleFailure(
                    rule.location, rule.text, "head", self._holds(rule, plan, wrong), wrong.literal(rule.clause.head), (), len(found)
                )
        return RuleFailure(rule.location, rule.text, "lost", holds, writer.literal(rule.clause.head))

    def _holds(self, rule: Rule, plan: Sequence[Planned], writer: Writer) -> tuple[str, ...]:
        numbers = dict.fromkeys(p.literal for p in plan)
        return tuple(writer.literal(rule.clause.body[n]) for n in numbers if n != HEAD)

    def _stuck(self, rule: Rule, body: Body, plan: Sequence[Planned], at: int, kept: list[Match], attempts: int) -> RuleFailure:
        planned = plan[at]
        best, near = kept[0], list[str]()
        reason = "false"
        match planned.step:
            case Scan(atom=atom):
                reason = "no row"
                best, near = self._nearest_attempt(body, atom, kept)
            case Absent(atom=atom):
                reason = "present"
                row = body.blocking(atom, best.bound)
                near = [self.text(atom.name, row)] if row is not None else []
            case Fold() as fold:
                reason = "value"
                folded = body.folded(fold, best.bound)
                near = ["its body has no rows" if folded is None else f"the aggregate is {self._value(rule, folded)}"]
        writer = Writer(self.rules.types, rule.types, best.bound)
        literal = rule.clause.body[planned.literal] if planned.literal != HEAD else rule.clause.head
        if reason == "false" and planned.literal in best.folds:
            reason, near = "value", [f"the aggregate is {self._value(rule, best.folds[planned.literal][-1])}"]
        open_literals = {p.literal for p in plan[at:]}
        done = [p for p in plan[:at] if p.literal not in open_literals]
        return RuleFailure(
            rule.location, rule.text, reason, self._holds(rule, done, writer), writer.literal(literal), tuple(near), attempts
        )

    def _value(self, rule: Rule, folded: Folded) -> str:
        names = sorted(rule.types.of(folded.aggregate) or ())
        return show_term(folded.value, next(iter(names), ""), self.rules.types)

    # -- nearest rows -------------------------------------------------------------------------------

    def _nearest_attempt(self, body: Body, atom: Atom, kept: list[Match]) -> tuple[Match, list[str]]:
        """Of several attempts the one whose wanted row comes closest to one that is there."""
        most = max(1, MOST_COMPARED // max(self.store.count(atom.name), 1))
        best: tuple[float, Match, list[str]] | None = None
        for state in kept[:most]:
            names = set(state.bound)
            wanted = {i: body.terms.value(a, state.bound) for i, a in enumerate(atom.args) if is_bound(a, names)}
            score, rows = self.nearest(atom.name, wanted)
            if best is None or score > best[0]:
                best = (score, state, rows)
        assert best is not None
        return best[1], best[2]

    def nearest(self, relation: str, wanted: dict[int, Any]) -> tuple[float, list[str]]:
        """The rows that agree with most of the wanted columns, and in how many; none when none agrees in any."""
        best, found = 0.0, list[Row]()
        for row in self.store.rows(relation):
            score = sum(_agreement(value, row[column]) for column, value in wanted.items())
            if score > best:
                best, found = score, []
            if score == best and score > 0 and len(found) < MOST_NEAREST:
                found.append(row)
        return best, [self.text(relation, row) for row in found]


def _agreement(wanted: Any, value: Any) -> float:
    """1 for equal values; for records the share of equal fields, always less."""
    if wanted == value:
        return 1.0
    if isinstance(wanted, tuple) and isinstance(value, tuple) and len(wanted) == len(value) > 0:
        return 0.9 * sum(_agreement(a, b) for a, b in zip(wanted, value, strict=True)) / len(wanted)
    return 0.0


def why_not_text(found: WhyNot, shorten: Any = str) -> str:
    """What was found, rule by rule."""
    if found.rows:
        more = f" and {len(found.rows) - 1} more" if len(found.rows) > 1 else ""
        return f"{found.rows[0]}{more} is there; `explain` shows why\n"
    lines = [f"{found.goal} is not there" + _summary(found)]
    for failure in found.failures:
        lines.append(f"{shorten(failure.location.path)}:{failure.location.line}: {failure.rule}")
        lines += [f"  holds    {text}" for text in failure.holds]
        attempts = f"  (nearest of {failure.attempts} bindings)" if failure.attempts > 1 else ""
        lines += _explained(failure, attempts)
    if found.nearest:
        lines.append("nearest rows:")
        lines += [f"  {text}" for text in found.nearest]
    return "".join(f"{line}\n" for line in lines)


def _summary(found: WhyNot) -> str:
    if found.failures:
        return f"; {len(found.failures)} rule{'s' * (len(found.failures) != 1)} for `{found.relation}`:"
    return f"; `{found.relation}` is an input relation" if found.is_input else f"; `{found.relation}` has no rules"


def _explained(failure: RuleFailure, attempts: str) -> list[str]:
    match failure.reason:
        case "head":
            return [f"  differs  {failure.failed}{attempts}"]
        case "no row":
            return [f"  no row   {failure.failed}{attempts}", *(f"  nearest  {text}" for text in failure.nearest)]
        case "present":
            return [f"  fails    {failure.failed}{attempts}", *(f"  present  {text}" for text in failure.nearest)]
        case "lost":
            return [f"  removed  {failure.failed}, by subsumption or a choice-domain"]
        case _:
            return [f"  fails    {failure.failed}{attempts}", *(f"           {text}" for text in failure.nearest)]
