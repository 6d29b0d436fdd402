"""`explain`: the proof of a row, from the rules and the rows of any engine's result.

A rule is run backwards: its head takes the values of the row, and its body is matched against the rows that are there.
For a recursive relation that is not enough, as a row must not support itself: all rows that may support it are
visited in breadth, until some chain of them rests on rows of other relations. Every row is proven once.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from rosarch.datalog.inspection.clauses import Rule, Rules, rules_of
from rosarch.datalog.inspection.goals import Goal, parse_goal, show_goal
from rosarch.datalog.inspection.match import HEAD, Body, Folded, Match
from rosarch.datalog.inspection.proofs import Absent, AggregateValue, Condition, Proof, RowRef
from rosarch.datalog.inspection.rows import Given, Row, RowStore, row_store
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.show import Writer, show_row, show_term
from rosarch.datalog.language.syntax import Aggregate, Atom, Constraint, Negation, Truth, variables

if TYPE_CHECKING:
    from rosarch.datalog.program import Program

LIMIT = 1_000_000
Node: TypeAlias = tuple[str, Row]


@dataclass(frozen=True, slots=True, eq=False)
class Derivation:
    """How a row comes about: the rule and a match of its body. Without a rule it was given."""

    kind: str
    rule: Rule | None = None
    match: Match | None = None


@dataclass(slots=True, eq=False)
class _Instance:
    """A match that waits for rows it rests on."""

    head: Node
    derivation: Derivation
    waiting: int


def explain(program: Program, rows: Given, goal: str, *, engine: str = "embedded", limit: int = LIMIT) -> Proof:
    """The proof of the first row that a goal matches.

    `rows`: a result with the rows of all relations (`keep="all"`), or facts to evaluate.
    Raises DatalogError when there is no such row, or when no proof is found within `limit` matches of rules.
    """
    store = row_store(program, rows, engine=engine)
    rules = rules_of(program)
    wanted = parse_goal(goal, rules.relations, rules.types)
    return next(iter(_proofs(rules, store, wanted, limit)))


def explain_all(
    program: Program, rows: Given, goal: str, *, engine: str = "embedded", limit: int = LIMIT, most: int | None = None
) -> list[Proof]:
    """The proofs of all rows that a goal matches, of the first `most` if given."""
    store = row_store(program, rows, engine=engine)
    rules = rules_of(program)
    found: list[Proof] = []
    for proof in _proofs(rules, store, parse_goal(goal, rules.relations, rules.types), limit):
        found.append(proof)
        if len(found) == most:
            break
    return found


def check_goal(program: Program, goal: str) -> None:
    """Raise DatalogError when a goal does not fit the declarations. Needs no rows."""
    rules = rules_of(program)
    parse_goal(goal, rules.relations, rules.types)


def has_rows(program: Program, store: RowStore, goal: str) -> bool:
    """Whether there is a row that a goal matches."""
    rules = rules_of(program)
    return any(True for _ in matching_rows(store, parse_goal(goal, rules.relations, rules.types)))


def no_row(program: Program, goal: str) -> DatalogError:
    """The error for a goal without a row."""
    rules = rules_of(program)
    return _no_row(rules, parse_goal(goal, rules.relations, rules.types))


def _no_row(rules: Rules, goal: Goal) -> DatalogError:
    text = show_goal(goal, [a.type for a in rules.relations[goal.relation].attributes], rules.types)
    return DatalogError([Diagnostic(f"there is no row {text}", hint="`why-not` shows what is missing")])


def matching_rows(store: RowStore, goal: Goal) -> Iterator[Row]:
    """The rows that a goal matches."""
    if goal.ground:
        if store.has(goal.relation, goal.args):
            yield goal.args
        return
    yield from (row for row in store.rows(goal.relation) if goal.matches(row))


def _proofs(rules: Rules, store: RowStore, goal: Goal, limit: int) -> Iterator[Proof]:
    prover = Prover(rules, store, limit)
    found = False
    for row in matching_rows(store, goal):
        found = True
        yield prover.prove(goal.relation, row)
    if not found:
        raise _no_row(rules, goal)


class Prover:
    """Proves rows; what was proven is kept."""

    def __init__(self, rules: Rules, store: RowStore, limit: int = LIMIT) -> None:
        self.rules = rules
        self.store = store
        self.limit = limit
        self.bodies: dict[int, Body] = {}
        self.derivations: dict[Node, Derivation] = {}
        self.proofs: dict[Node, Proof] = {}

    # -- derivations --------------------------------------------------------------------------------

    def body(self, rule: Rule) -> Body:
        """The body of a rule, prepared once."""
        if rule.number not in self.bodies:
            self.bodies[rule.number] = Body.of(rule, self.rules, self.store)
        return self.bodies[rule.number]

    def clauses(self, relation: str) -> list[Rule]:
        """The clauses that derive rows of a relation."""
        return [r for r in self.rules.by_head.get(relation, ()) if r.clause.dominating is None]

    def derivation(self, node: Node) -> Derivation:
        """A derivation of a row that does not rest on the row itself."""
        if node not in self.derivations:
            given = self._given(node)
            if given is not None:
                self.derivations[node] = given
            elif node[0] in self.rules.recursive:
                self._search(node)
            else:
                self.derivations[node] = self._first(node, self.clauses(node[0])) or self._unfounded(node)
        return self.derivations[node]

    def _given(self, node: Node) -> Derivation | None:
        """The derivation of a row that is there from the start."""
        is_input = node[0] in self.rules.inputs
        if is_input and self.store.given(*node):
            return Derivation("input")
        facts = self._first(node, [r for r in self.clauses(node[0]) if not r.clause.body])
        if facts is None and is_input and not self.clauses(node[0]):
            return Derivation("input")
        return facts

    def _first(self, node: Node, rules: Iterable[Rule]) -> Derivation | None:
        for rule in rules:
            for match in self.body(rule).matches(node[1]):
                return Derivation("rule" if rule.clause.body else "fact", rule, match)
        return None

    def _unfounded(self, node: Node) -> Derivation:
        """What is left: facts that are not known, or a derivation through rows that are gone."""
        is_input = node[0] in self.rules.inputs
        return Derivation("input" if is_input and self.store.given(*node) is None else "unexplained")

    def _search(self, goal: Node) -> None:
        """Derive a row of a recursive relation, and on the way rows that it rests on."""
        group = self.rules.recursive[goal[0]]
        waiting: dict[Node, list[_Instance]] = defaultdict(list)
        level, seen, tried = [goal], {goal}, 0
        while level and goal not in self.derivations:
            ready: deque[tuple[Node, Derivation]] = deque()
            below: list[Node] = []
            for node in level:
                if node in self.derivations:
                    continue
                start = self._given(node) or self._first(node, [r for r in self.clauses(node[0]) if not self._recursive_atoms(r, group)])
                if start is not None:
                    ready.appendleft((node, start))
                    continue
                for instance, needs in self._instances(node, group):
                    tried += 1
                    if tried > self.limit:
                        raise DatalogError(f"no proof of {self.text(*goal)} within {self.limit} matches of rules")
                    missing = [n for n in needs if n not in self.derivations]
                    if not missing:
                        ready.append((node, instance.derivation))
                        break
                    instance.waiting = len(missing)
                    for need in missing:
                        waiting[need].append(instance)
                    fresh = [n for n in missing if n not in seen]
                    seen.update(fresh)
                    below += fresh
            self._settle(ready, waiting)
            level = below
        self.derivations.setdefault(goal, self._unfounded(goal))

    @staticmethod
    def _recursive_atoms(rule: Rule, group: frozenset[str]) -> list[int]:
        return [i for i, literal in enumerate(rule.clause.body) if isinstance(literal, Atom) and literal.name in group]

    def _instances(self, node: Node, group: frozenset[str]) -> Iterator[tuple[_Instance, list[Node]]]:
        """The matches of recursive rules that derive a row, one for each set of rows they rest on."""
        for rule in self.clauses(node[0]):
            atoms = self._recursive_atoms(rule, group)
            known: set[tuple[Row, ...]] = set()
            for match in self.body(rule).matches(node[1], group) if atoms else ():
                rows = tuple(match.rows[i] for i in atoms)
                needs = list(dict.fromkeys((rule.clause.body[i].name, match.rows[i]) for i in atoms))  # type: ignore[union-attr]
                if rows not in known and node not in needs:
                    known.add(rows)
                    yield _Instance(node, Derivation("rule", rule, match), 0), needs

    def _settle(self, ready: deque[tuple[Node, Derivation]], waiting: dict[Node, list[_Instance]]) -> None:
        """Record derivations, and those of rows that waited for them; in breadth, so that proofs are low."""
        while ready:
            node, derivation = ready.popleft()
            if node in self.derivations:
                continue
            self.derivations[node] = derivation
            for instance in waiting.pop(node, ()):
                instance.waiting -= 1
                if not instance.waiting:
                    ready.append((instance.head, instance.derivation))

    # -- proofs -------------------------------------------------------------------------------------

    def prove(self, relation: str, row: Row) -> Proof:
        """The proof of a row that is there."""
        goal = (relation, row)
        work = [goal]
        while work:
            node = work[-1]
            if node in self.proofs:
                work.pop()
                continue
            derivation = self.derivation(node)
            missing = [n for n in self._rests_on(derivation) if n not in self.proofs]
            if missing:
                work.extend(reversed(missing))
            else:
                self.proofs[node] = self._proof(node, derivation)
                work.pop()
        return self.proofs[goal]

    @staticmethod
    def _rests_on(derivation: Derivation) -> list[Node]:
        if derivation.rule is None or derivation.match is None:
            return []
        body, rows = derivation.rule.clause.body, derivation.match.rows
        return [(literal.name, rows[i]) for i, literal in enumerate(body) if isinstance(literal, Atom)]

    def text(self, relation: str, row: Row) -> str:
        """A row as an atom."""
        return show_row(relation, row, [a.type for a in self.rules.relations[relation].attributes], self.rules.types)

    def _proof(self, node: Node, derivation: Derivation) -> Proof:
        rule, match = derivation.rule, derivation.match
        if rule is None or match is None:
            return Proof(*node, self.text(*node), derivation.kind)
        writer = Writer(self.rules.types, rule.types, match.bound)
        names = {v for literal in (rule.clause.head, *rule.clause.body) for v in variables(literal)}
        bindings = tuple((name, writer.value(name)) for name in sorted(names & set(match.bound)) if "+" not in name)
        premises = tuple(self.proofs[p] if isinstance(p, tuple) else p for p in self.premises(derivation))
        return Proof(*node, self.text(*node), derivation.kind, rule.location, rule.text, bindings, premises)

    def premises(self, derivation: Derivation) -> Iterator[Node | Absent | Condition | AggregateValue]:
        """What a derivation rests on, rows unproven; follows the literals of the rule."""
        rule, match = derivation.rule, derivation.match
        if rule is None or match is None:
            return
        writer = Writer(self.rules.types, rule.types, match.bound)
        plain = Writer(self.rules.types, rule.types)
        folded = {id(f.aggregate): self._folded(f, rule) for folds in match.folds.values() for f in folds}
        computed = Writer(self.rules.types, rule.types, match.bound, folded)
        for number, literal in enumerate(rule.clause.body):
            yield from self._aggregates(match.folds.get(number, ()), rule, writer)
            match literal:
                case Atom():
                    yield literal.name, match.rows[number]
                case Negation():
                    yield Absent(writer.literal(literal), literal.atom.name, literal.location)
                case Constraint() if not (literal.op == "=" and _says_nothing(literal, writer)):
                    yield Condition(plain.literal(literal), computed.literal(literal), literal.location)
                case Truth() | Constraint():
                    continue
        yield from self._aggregates(match.folds.get(HEAD, ()), rule, writer)

    def _folded(self, folded: Folded, rule: Rule) -> str:
        found = sorted(rule.types.of(folded.aggregate) or ())
        return show_term(folded.value, next(iter(found), ""), self.rules.types)

    def _aggregates(self, folds: Sequence[Folded], rule: Rule, writer: Writer) -> Iterator[AggregateValue]:
        for folded in folds:
            rows = tuple(RowRef(c.relation, c.row, self.text(c.relation, c.row)) for c in folded.rows)
            yield AggregateValue(writer.aggregate(folded.aggregate), self._folded(folded, rule), rows, folded.aggregate.location)


def _says_nothing(equation: Constraint, writer: Writer) -> bool:
    """Whether an equation only names a value, of an aggregate for one, that is seen elsewhere."""
    sides = equation.left, equation.right
    return any(isinstance(side, Aggregate) for side in sides) or writer.term(sides[0]) == writer.term(sides[1])
