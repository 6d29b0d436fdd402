"""Why things of reports are as they are: the proofs of rows, to a certain depth, as tables of steps that may be shared."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.datalog import Program, RowStore
from rosarch.datalog.clauses import rules_of
from rosarch.datalog.errors import DatalogError
from rosarch.datalog.proofs import Absent, AggregateValue, Condition
from rosarch.datalog.prover import Node, Prover
from rosarch.models.behavior import variable_names
from rosarch.models.places import Place
from rosarch.models.rule_sets import SystemRules
from rosarch.models.system.findings import findings_with_rows
from rosarch.models.system.rows import Rows

DEPTH = 5
"""Steps below the row that is asked about; what lies deeper, `rosarch explain` tells."""
Row = tuple[Any, ...]


@dataclass(frozen=True)
class ProofStep:
    """A row or condition, the rule that it follows from (or what else it is), and the numbers of the steps it rests on; `cut`: not all."""

    text: str
    rule: str
    premises: tuple[int, ...] = ()
    cut: bool = False


@dataclass(frozen=True)
class Derivations:
    """The proofs of a component or system: `roots` are the steps of the things that were asked about."""

    steps: tuple[ProofStep, ...]
    roots: Mapping[str, int]


def derivations(program: Program, store: RowStore, wanted: Iterable[tuple[str, str, Row]], shorten: Callable[[str], str]) -> Derivations:
    """The proofs of `wanted`, keys with relation and row, as far as there are any; `shorten` makes paths of rule files shorter."""
    table = _Table(Prover(rules_of(program), store), shorten)
    roots: dict[str, Node] = {}
    for key, relation, row in wanted:
        if key not in roots and store.has(relation, row) and table.is_provable((relation, row)):
            roots[key] = relation, row
    return table.steps_of(roots)


class _Table:
    """All steps up to `DEPTH` below a root, each row once. What lies deeper is not looked for, which is most of the work."""

    def __init__(self, prover: Prover, shorten: Callable[[str], str]) -> None:
        self.prover = prover
        self.shorten = shorten
        self.numbers: dict[Node, int] = {}

    def is_provable(self, node: Node) -> bool:
        try:
            self.prover.derivation(node)
        except DatalogError:
            return False  # it would take too long
        return True

    def steps_of(self, roots: Mapping[str, Node]) -> Derivations:
        level = list(dict.fromkeys(roots.values()))
        self.numbers = {node: number for number, node in enumerate(level)}
        steps: list[ProofStep | None] = [None] * len(level)
        for depth in range(DEPTH + 1):
            below: list[Node] = []
            for node in level:
                steps[self.numbers[node]] = self._step(node, depth, steps, below)
            level = below
        return Derivations(tuple(step for step in steps if step), {key: self.numbers[node] for key, node in roots.items()})

    def _step(self, node: Node, depth: int, steps: list[ProofStep | None], below: list[Node]) -> ProofStep:
        """The step of a row; what it rests on gets numbers, rows that have none yet are to be proven in the level below."""
        text = self.prover.text(*node)
        if not self.is_provable(node):
            return ProofStep(text, "unexplained")
        derivation = self.prover.derivation(node)
        at = derivation.rule.location if derivation.rule else None
        rule = f"{self.shorten(at.path)}:{at.line}" if at else derivation.kind
        if depth >= DEPTH:
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


def _leaf(premise: Absent | Condition | AggregateValue) -> ProofStep:
    if isinstance(premise, Absent):
        return ProofStep(premise.text, "absent")
    if isinstance(premise, Condition):
        return ProofStep(premise.values, "condition")
    return ProofStep(f"{premise.text} = {premise.value}", "aggregate")


def component_rows(store: RowStore, places: Mapping[str, Place]) -> Iterator[tuple[str, str, Row]]:
    """What of a component is proven: keys, as the report makes them of the model, with relation and row."""

    def port(record: Row) -> str:
        site, kind, name = record
        return f"{kind} {name} {places.get(site)}"

    names = variable_names({"variable_display": store.rows("variable_display")})
    for row in sorted(store.rows("port"), key=repr):
        yield f"port {port(row[0])}", "port", row
    for row in sorted(store.rows("reacts"), key=repr):
        yield f"reacts {port(row[0])} > {port(row[1])}", "reacts", row
    for row in sorted(store.rows("reacts_deferred"), key=repr):
        yield f"kept {port(row[0])} > {port(row[1])} in {names.get(row[2])}", "reacts_deferred", row
    for row in sorted(store.rows("sends_once"), key=repr):
        yield f"once {places.get(row[0])} > {port(row[1])}", "sends_once", row
    for relation in ("state_variable", "configuration_variable"):
        for row in sorted(store.rows(relation), key=repr):
            yield f"variable {places.get(row[0])}", relation, row
    for row in sorted(store.rows("periodic"), key=repr):
        yield f"periodic {places.get(row[0])}", "periodic", row
    for row in sorted(store.rows("transition"), key=repr):
        yield f"transition {places.get(row[0])}", "transition", row
    for row in sorted(store.rows("parameter_access"), key=repr):
        yield f"parameter {row[1]} {row[2]} {places.get(row[0])}", "parameter_access", row


def component_derivations(program: Program, facts: Mapping[str, Any], engine: str, shorten: Callable[[str], str]) -> Derivations:
    """Why a component has its ports, parameters and behaviour."""
    store = RowStore(program.evaluate(facts, engine=engine, keep="all"), facts)
    places = {row[0]: Place(*row[1:]) for row in store.rows("node_location")}
    return derivations(program, store, component_rows(store, places), shorten)


def system_derivations(
    rules: SystemRules, rows: Rows, system: str, wanted: Collection[str], engine: str, shorten: Callable[[str], str]
) -> Derivations:
    """Why a system has its connectors, by their ends, and the findings whose fingerprints are `wanted`."""
    result = rules.program.evaluate(rows, engine=engine, keep="all")
    places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
    found = findings_with_rows(rules.checks, result, places, system)
    asked = [(finding.fingerprint, finding.check.relation, row) for row, finding in found if finding.fingerprint in wanted]
    facts = {relation: list(own) for relation, own in rows.items()}
    implicit = {port for (port,) in rows.get("interface_port_implicit", ())}
    ends = sorted((row for row in result.rows("joins_connector") if row[3][1] not in implicit), key=repr)
    asked += [(_end_key(name, *port), "joins_connector", (kind, name, side, port)) for kind, name, side, port in ends]
    return derivations(rules.program, RowStore(result, facts), asked, shorten)


def _end_key(name: str, node: str, port: str, parameter: str) -> str:
    return f"end {name} {node} {port}{f':{parameter}' if parameter else ''}"
