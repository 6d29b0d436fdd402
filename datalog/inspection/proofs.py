"""Proofs: why a row is there. The tree, as data; `prover` makes it, `proof_printer` prints it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

from rosarch.datalog.language.errors import Location

Row = tuple[Any, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Absent:
    """A negated atom, with the values of its variables: no row of `relation` matches."""

    text: str
    relation: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Condition:
    """A constraint that holds: as written, and with the values of its variables."""

    text: str
    values: str
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class RowRef:
    """A row that is named, not proven."""

    relation: str
    row: Row
    text: str


@dataclass(frozen=True, slots=True, eq=False)
class AggregateValue:
    """The value of an aggregate and the rows it was made from; of `min` and `max` those that attain it."""

    text: str
    value: str
    rows: tuple[RowRef, ...]
    location: Location


@dataclass(frozen=True, slots=True, eq=False)
class Proof:
    """Why a row is there.

    `kind` is `input` (given as a fact), `fact` (written in the program), `rule`, or `unexplained` (derived through rows
    that were there for a time only, as with subsumption). Premises follow the literals of the rule, in its order.
    """

    relation: str
    row: Row
    text: str
    kind: str
    location: Location | None = None
    rule: str = ""
    bindings: tuple[tuple[str, str], ...] = ()
    premises: tuple[Premise, ...] = ()

    @property
    def derived(self) -> tuple[Proof, ...]:
        """The premises that are rows."""
        return tuple(p for p in self.premises if isinstance(p, Proof))

    def leaves(self) -> tuple[Proof, ...]:
        """The rows without premises that are rows, each once, in the order of the tree."""
        found: dict[int, Proof] = {}
        seen: set[int] = set()
        work: list[Proof] = [self]
        while work:
            proof = work.pop()
            if id(proof) in seen:
                continue
            seen.add(id(proof))
            if not proof.derived:
                found[id(proof)] = proof
            work.extend(reversed(proof.derived))
        return tuple(found.values())


Premise: TypeAlias = Proof | Absent | Condition | AggregateValue
