"""Why things of reports are as they are: the proofs of rows, to a certain depth, as tables of steps that may be shared."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.datalog import Program, RowStore
from rosarch.datalog.clauses import rules_of
from rosarch.datalog.errors import DatalogError
from rosarch.datalog.proofs import Absent, AggregateValue, Condition, Premise, Proof
from rosarch.datalog.prover import Prover
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
    prover = Prover(rules_of(program), store)
    proofs: dict[str, Proof] = {}
    for key, relation, row in wanted:
        if key not in proofs and store.has(relation, row):
            try:
                proofs[key] = prover.prove(relation, row)
            except DatalogError:
                continue  # it would take too long
    return _table(proofs, shorten)


def _table(proofs: Mapping[str, Proof], shorten: Callable[[str], str]) -> Derivations:
    """All steps up to `DEPTH` below a root, each once."""
    numbers: dict[int, int] = {}
    found: list[tuple[Premise, int]] = []
    waiting: deque[tuple[Premise, int]] = deque((proof, 0) for proof in proofs.values())
    while waiting:
        premise, depth = waiting.popleft()
        if id(premise) in numbers:
            continue
        numbers[id(premise)] = len(found)
        found.append((premise, depth))
        if isinstance(premise, Proof) and depth < DEPTH:
            waiting.extend((inner, depth + 1) for inner in premise.premises)
    steps = tuple(_step(premise, depth, numbers, shorten) for premise, depth in found)
    return Derivations(steps, {key: numbers[id(proof)] for key, proof in proofs.items()})


def _step(premise: Premise, depth: int, numbers: Mapping[int, int], shorten: Callable[[str], str]) -> ProofStep:
    if isinstance(premise, Absent):
        return ProofStep(premise.text, "absent")
    if isinstance(premise, Condition):
        return ProofStep(premise.values, "condition")
    if isinstance(premise, AggregateValue):
        return ProofStep(f"{premise.text} = {premise.value}", "aggregate")
    rule = f"{shorten(premise.location.path)}:{premise.location.line}" if premise.location else premise.kind
    if depth >= DEPTH:
        return ProofStep(premise.text, rule, cut=bool(premise.premises))
    return ProofStep(premise.text, rule, tuple(numbers[id(inner)] for inner in premise.premises))


def component_rows(store: RowStore, places: Mapping[str, Place]) -> Iterator[tuple[str, str, Row]]:
    """What of a component is proven: keys, as the report makes them of the model, with relation and row."""

    def port(record: Row) -> str:
        site, kind, name = record
        return f"{kind} {name} {places.get(site)}"

    for row in sorted(store.rows("port"), key=repr):
        yield f"port {port(row[0])}", "port", row
    for row in sorted(store.rows("reacts"), key=repr):
        yield f"reacts {port(row[0])} > {port(row[1])}", "reacts", row
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


def finding_derivations(
    rules: SystemRules, rows: Rows, system: str, wanted: Collection[str], engine: str, shorten: Callable[[str], str]
) -> Derivations:
    """Why a system has the findings whose fingerprints are `wanted`."""
    result = rules.program.evaluate(rows, engine=engine, keep="all")
    places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
    found = findings_with_rows(rules.checks, result, places, system)
    asked = [(finding.fingerprint, finding.check.relation, row) for row, finding in found if finding.fingerprint in wanted]
    facts = {relation: list(own) for relation, own in rows.items()}
    return derivations(rules.program, RowStore(result, facts), asked, shorten)
