"""What was seen beside what the rules derive: elements of each kind, what fills the unknown, and contradictions."""

from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import dataclass, field

from rosarch.base.places import Place
from rosarch.findings.model import Finding
from rosarch.findings.of_systems import findings
from rosarch.models.system.asking import Port
from rosarch.models.system.build import evaluate
from rosarch.models.system.rows import Rows, merged
from rosarch.rule_programs.sets import SystemRules

CONFIRMED, FILLED, MISSED, UNSEEN = "confirmed", "filled", "missed", "unseen"
_ORDER = (
    "node", "topic", "publisher", "subscriber", "service_server", "service_client", "action_server", "action_client", "parameter",
    "connection",
)  # fmt: skip


@dataclass(frozen=True, order=True)
class Element:
    """Part of a system: its kind, its owner ("" for none), its name, whether it was predicted and seen, and reasons for the difference."""

    kind: str
    owner: str
    name: str
    outcome: str
    reasons: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.name} of {self.owner}" if self.owner else self.name


@dataclass(frozen=True)
class Accuracy:
    """How much of a kind of elements was predicted and seen; a name that was unknown and is filled was not predicted.

    Unless what was looked at is `complete` in this kind, what was not seen may have been there.
    """

    kind: str
    confirmed: int
    filled: int
    missed: int
    unseen: int
    complete: bool

    @property
    def predicted(self) -> int:
        """How many the model has."""
        return self.confirmed + self.unseen

    @property
    def observed(self) -> int:
        """How many were seen."""
        return self.confirmed + self.filled + self.missed

    @property
    def under(self) -> float | None:
        """The share of what was seen that the model does not have."""
        return (self.filled + self.missed) / self.observed if self.observed else None

    @property
    def over(self) -> float | None:
        """The share of what the model has that was not seen."""
        return self.unseen / self.predicted if self.predicted and self.complete else None


@dataclass(frozen=True)
class Filled:
    """Something that the model does not know and that was seen: `what` (name or rate) of `subject` is `value`."""

    what: str
    subject: str
    value: str
    provenance: str = "observed"


@dataclass(frozen=True)
class Comparison:
    """A system beside what was seen of it; `contradictions` have the proofs of both sides."""

    system: str
    elements: tuple[Element, ...]
    filled: tuple[Filled, ...] = ()
    contradictions: tuple[Finding, ...] = ()
    complete: frozenset[str] = field(default_factory=frozenset)

    def accuracies(self) -> list[Accuracy]:
        """How much of each kind was predicted and seen, of those kinds that were looked at."""
        counted: dict[str, Counter[str]] = defaultdict(Counter)
        for element in self.elements:
            counted[element.kind][element.outcome] += 1
        return [_accuracy(kind, counted[kind], kind in self.complete) for kind in _ORDER if kind in counted]


def _accuracy(kind: str, counted: Counter[str], complete: bool) -> Accuracy:
    return Accuracy(kind, counted[CONFIRMED], counted[FILLED], counted[MISSED], counted[UNSEEN], complete)


_KEPT = ("compared", "compared_because", "name_observed", "rate_observed", "port_node")
_PREFIX = "observed_"


def expected_pairs(rules: SystemRules, rows: Rows, engine: str) -> set[tuple[str, str]]:
    """The topics of which what passes through the first sets off what passes through the second."""
    result = rules.program.evaluate(rows, engine=engine, keep=("expected_answer",))
    return {(source, sink) for _, source, sink, _ in result.rows("expected_answer")}


def compare(rules: SystemRules, system: str, rows: Rows, seen: Rows, engine: str) -> Comparison:
    """Compare the system that `rows` are the facts of with the facts about what was `seen`."""
    together = merged([rows, seen])
    result = evaluate(rules, together, engine, keep=_KEPT)
    reasons: dict[tuple[str, ...], set[str]] = defaultdict(set)
    for *element, reason in result.rows("compared_because"):
        reasons[tuple(element)].add(reason)
    elements = [Element(k, owner, name, how, tuple(sorted(reasons[k, owner, name]))) for k, owner, name, how in result.rows("compared")]
    nodes: dict[Port, str] = dict(result.rows("port_node"))
    places = {row[0]: Place(*row[1:]) for row in together.get("place", ())}
    at = dict(together.get("interface_port_at", ()))
    names = [
        Filled("name", f"the {kind} of {nodes[port]} at {places[at[port[1]]]}" if port[1] in at else f"the {kind} of {nodes[port]}", name)
        for port, kind, _, name in result.rows("name_observed")
    ]
    rates = [Filled("rate", topic, f"{hz:g} Hz") for topic, hz in result.rows("rate_observed")]
    checks = [check for check in rules.checks if check.relation.startswith(_PREFIX)]
    found = findings(checks, result, places, system)
    return Comparison(
        system, tuple(sorted(elements)), tuple(sorted((*names, *rates), key=lambda each: (each.what, each.subject, each.value))),
        tuple(sorted(found, key=lambda finding: (finding.place, finding.check.id, finding.message))), _kinds(seen),
    )  # fmt: skip


def _kinds(seen: Rows) -> frozenset[str]:
    return frozenset(kind for (kind,) in seen.get("observed_kind", ()))
