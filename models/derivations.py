"""Why things of reports are as they are: the proofs of rows, to a certain depth, as tables of steps that may be shared."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

from rosarch.base.places import Place
from rosarch.datalog import Program, RowStore
from rosarch.datalog.inspection.clauses import rules_of
from rosarch.datalog.inspection.proofs import Absent, AggregateValue, Condition
from rosarch.datalog.inspection.prover import Node, Prover
from rosarch.datalog.language.errors import DatalogError
from rosarch.models.behavior import variable_names

DEPTH = 5
"""Steps below the row that is asked about; what lies deeper, `rosarch explain` shows."""
Row = tuple[Any, ...]


@dataclass(frozen=True)
class ProofStep:
    """A row or condition, the rule that it follows from (or what else it is), and the numbers of the steps it rests on; `cut`: not all.

    A fact says where what it is about lies, `at`.
    """

    text: str
    rule: str
    premises: tuple[int, ...] = ()
    cut: bool = False
    at: Place | None = None


@dataclass(frozen=True)
class Derivations:
    """The proofs of a component or system: `roots` are the steps of the things that were asked about."""

    steps: tuple[ProofStep, ...]
    roots: Mapping[str, int]


class Wanted(NamedTuple):
    """A row whose proof is wanted, down to a depth, and what the proof is found by."""

    key: str
    relation: str
    row: Row
    depth: int = DEPTH


def derivations(
    program: Program, store: RowStore, wanted: Iterable[Wanted], shorten: Callable[[str], str], places: Mapping[str, Place]
) -> Derivations:
    """The proofs of `wanted`, as far as there are any.

    `shorten` makes paths of rule files shorter, `places` says where things lie that facts are about.
    """
    table = _Table(Prover(rules_of(program), store), shorten, places)
    roots: dict[str, tuple[Node, int]] = {}
    for key, relation, row, depth in wanted:
        if key not in roots and store.has(relation, row) and table.is_provable((relation, row)):
            roots[key] = (relation, row), depth
    return table.steps_of(roots)


class _Table:
    """All steps up to some depth below a root, each row once. What lies deeper is not looked for, which is most of the work."""

    def __init__(self, prover: Prover, shorten: Callable[[str], str], places: Mapping[str, Place]) -> None:
        self.prover = prover
        self.shorten = lru_cache(maxsize=None)(shorten)
        self.places = places
        self.numbers: dict[Node, int] = {}

    def is_provable(self, node: Node) -> bool:
        try:
            self.prover.derivation(node)
        except DatalogError:
            return False  # it would take too long
        return True

    def steps_of(self, roots: Mapping[str, tuple[Node, int]]) -> Derivations:
        steps: list[ProofStep | None] = []
        level: list[Node] = []
        for left in range(max((depth for _, depth in roots.values()), default=-1), -1, -1):
            for node in dict.fromkeys(node for node, depth in roots.values() if depth == left and node not in self.numbers):
                self.numbers[node] = len(steps)
                steps.append(None)
                level.append(node)
            below: list[Node] = []
            for node in level:
                steps[self.numbers[node]] = self._step(node, left, steps, below)
            level = below
        return Derivations(tuple(step for step in steps if step), {key: self.numbers[node] for key, (node, _) in roots.items()})

    def _step(self, node: Node, left: int, steps: list[ProofStep | None], below: list[Node]) -> ProofStep:
        """The step of a row with `left` levels below it; what it rests on gets numbers, rows without one are proven in the next level."""
        text = self.prover.text(*node)
        if not self.is_provable(node):
            return ProofStep(text, "unexplained")
        derivation = self.prover.derivation(node)
        at = derivation.rule.location if derivation.rule else None
        rule = f"{self.shorten(at.path)}:{at.line}" if at else derivation.kind
        if derivation.kind == "input":
            return ProofStep(text, rule, at=place_in(node[1], self.places))
        if not left:
            return ProofStep(text, rule, cut=bool(derivation.rule and derivation.rule.clause.body))
        numbers = []
        for premise in self.prover.premises(derivation):
            known = self.numbers.get(premise) if isinstance(premise, tuple) else None
            if known is None:
                known = len(steps)
                steps.append(None if isinstance(premise, tuple) else _leaf(premise))
                if isinstance(premise, tuple):
                    self.numbers[premise] = known
                    below.append(premise)
            numbers.append(known)
        return ProofStep(text, rule, tuple(numbers))


def place_in(row: Row, places: Mapping[str, Place]) -> Place | None:
    """Where the first thing of a row lies that lies somewhere."""
    for value in row:
        found = place_in(value, places) if isinstance(value, tuple) else places.get(value)
        if found:
            return found
    return None


def _leaf(premise: Absent | Condition | AggregateValue) -> ProofStep:
    if isinstance(premise, Absent):
        return ProofStep(premise.text, "absent")
    if isinstance(premise, Condition):
        return ProofStep(premise.values, "condition")
    return ProofStep(f"{premise.text} = {premise.value}", "aggregate")


def component_rows(store: RowStore, places: Mapping[str, Place]) -> Iterator[Wanted]:
    """What of a component is proven: keys, as the report makes them of the model, with relation and row."""

    def port(record: Row) -> str:
        site, kind, name = record
        return f"{kind} {name} {places.get(site)}"

    names = variable_names({"variable_display": store.rows("variable_display")})
    for row in sorted(store.rows("port"), key=repr):
        yield Wanted(f"port {port(row[0])}", "port", row)
    for row in sorted(store.rows("reacts"), key=repr):
        yield Wanted(f"reacts {port(row[0])} > {port(row[1])}", "reacts", row)
    for row in sorted(store.rows("reacts_deferred"), key=repr):
        yield Wanted(f"kept {port(row[0])} > {port(row[1])} in {names.get(row[2])}", "reacts_deferred", row)
    for row in sorted(store.rows("sends_once"), key=repr):
        yield Wanted(f"once {places.get(row[0])} > {port(row[1])}", "sends_once", row)
    for relation in ("state_variable", "configuration_variable"):
        for row in sorted(store.rows(relation), key=repr):
            yield Wanted(f"variable {places.get(row[0])}", relation, row)
    for row in sorted(store.rows("periodic"), key=repr):
        yield Wanted(f"periodic {places.get(row[0])}", "periodic", row)
    for row in sorted(store.rows("transition"), key=repr):
        yield Wanted(f"transition {places.get(row[0])}", "transition", row)
    for row in sorted(store.rows("parameter_access"), key=repr):
        yield Wanted(f"parameter {row[1]} {row[2]} {places.get(row[0])}", "parameter_access", row)
    if "flows_analysed" in store.names:  # data flow is asked for
        for row in sorted(store.rows("port_flow"), key=repr):
            yield Wanted(f"flow {port(row[0])} > {port(row[1])}", "port_flow", row)


def component_derivations(program: Program, facts: Mapping[str, Any], engine: str, shorten: Callable[[str], str]) -> Derivations:
    """Why a component has its ports, parameters and behaviour."""
    store = RowStore(program.evaluate(facts, engine=engine, keep="all"), facts)
    places = {row[0]: Place(*row[1:]) for row in store.rows("node_location")}
    return derivations(program, store, component_rows(store, places), shorten, places)
