"""Why nothing arrives on a topic: the chain back to the first broken link, from findings, rates and what was not seen."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.findings.model import Finding
from rosarch.findings.of_systems import findings_with_rows
from rosarch.models.openness import reason_text
from rosarch.models.system.asking import Port, find_topic
from rosarch.models.system.build import evaluate
from rosarch.models.system.rows import Rows
from rosarch.rule_programs.sets import SystemRules

RELATIONS = (
    "joins_connector", "port_node", "port_place", "silences", "fed_by", "sends_never", "near_topic", "sender_unseen", "started_name",
)  # fmt: skip


@dataclass(frozen=True)
class Unseen:
    """What of `node`, which may have a sender, was not understood, and where."""

    node: str
    reason: str
    place: Place | None


@dataclass(frozen=True)
class Sender:
    """A port of `node` that sends on a topic.

    `findings` say why nothing is sent through it, or does not arrive, `perhaps` those that concern a part of the node; `never`: its rate is
    zero. `inputs` are the topics that it is made from, each with why nothing arrives there.
    """

    node: str
    place: Place | None
    never: bool
    findings: tuple[Finding, ...]
    perhaps: tuple[Finding, ...]
    inputs: tuple[Silence, ...]

    @property
    def stuck(self) -> bool:
        """Whether nothing comes from it, as far as was seen."""
        return self.never or bool(self.findings) or (bool(self.inputs) and all(each.stuck for each in self.inputs))

    @property
    def broken(self) -> bool:
        """Whether nothing comes from it, though all that it is made from was seen."""
        return self.never or bool(self.findings) or (bool(self.inputs) and all(each.broken for each in self.inputs))


@dataclass(frozen=True)
class Silence:
    """What was found about a topic: senders, readers, without senders the similar names, and what was not seen. `seen`: it is above."""

    topic: str
    readers: tuple[str, ...] = ()
    senders: tuple[Sender, ...] = ()
    near: tuple[tuple[str, str], ...] = ()
    unseen: tuple[Unseen, ...] = ()
    findings: tuple[Finding, ...] = ()
    perhaps: tuple[Finding, ...] = ()
    seen: bool = False

    @property
    def stuck(self) -> bool:
        """Whether nothing arrives, as far as was seen: there is no sender, or each has a reason, or what arrives is not taken."""
        return (not self.seen and all(sender.stuck for sender in self.senders)) or bool(self.findings)

    @property
    def broken(self) -> bool:
        """Whether nothing arrives, and nothing was left unseen that might send."""
        return (not self.seen and not self.unseen and all(sender.broken for sender in self.senders)) or bool(self.findings)


def ask_silence(rules: SystemRules, rows: Rows, topic: str, system: str, engine: str) -> Silence:
    """Why nothing arrives on a topic of the system that `rows` are the facts of.

    Raises:
        QuestionError: there is no such topic.
    """
    result = evaluate(rules, rows, engine, RELATIONS)
    asked = _Asked(rules, rows, result, system)
    return asked.silence(find_topic(topic, sorted(asked.topics)), ())


class _Asked:
    """What is asked of one system."""

    def __init__(self, rules: SystemRules, rows: Rows, result: Result, system: str) -> None:
        self.places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
        self.result = result
        self.nodes: dict[Port, str] = dict(result.rows("port_node"))
        self.at: dict[Port, Any] = dict(sorted(result.rows("port_place"), key=repr))
        self.sides: dict[tuple[str, str], list[Port]] = defaultdict(list)
        self.topic_of: dict[Port, str] = {}
        for kind, name, side, port in result.rows("joins_connector"):
            if kind == "topic":
                self.sides[name, side].append(port)
                self.topic_of[port] = name
        self.topics = set(self.topic_of.values())
        self.never = {port for (port,) in result.rows("sends_never")}
        self.fed: dict[Port, list[Port]] = defaultdict(list)
        for port, source in result.rows("fed_by"):
            self.fed[port].append(source)
        self.findings = self._findings(rules, system)

    def _findings(self, rules: SystemRules, system: str) -> Mapping[tuple[str, Any], Sequence[Finding]]:
        """The findings that explain silence: whether of a port, a node or a part of one, and of which."""
        explains: dict[str, str] = dict(self.result.rows("silences"))
        checks = [check for check in rules.checks if check.id in explains]
        found: dict[tuple[str, Any], list[Finding]] = defaultdict(list)
        for row, finding in findings_with_rows(checks, self.result, self.places, system):
            what = explains[finding.check.id]
            for value in row:
                port = isinstance(value, tuple)
                if port or what != "port":
                    found[what, value if what == "port" or not port else value[0]].append(finding)
        return found

    def _about(self, port: Port, *whats: str) -> list[Finding]:
        return [each for what in whats for each in self.findings.get((what, port if what == "port" else port[0]), ())]

    def silence(self, topic: str, above: tuple[str, ...]) -> Silence:
        """What was found about a topic; for one that is `above` in the chain, nothing again."""
        readers = tuple(sorted({self.nodes[port] for port in self.sides[topic, "sink"]}))
        if topic in above:
            return Silence(topic, readers, seen=True)
        senders = tuple(self._sender(port, (*above, topic)) for port in sorted(self.sides[topic, "source"], key=repr))
        unseen = {
            Unseen(self._start(node), reason_text(*reason), self.places.get(place))
            for name, node, reason, place in self.result.rows("sender_unseen")
            if name == topic
        }
        near = sorted({(other, reason) for name, other, reason in self.result.rows("near_topic") if name == topic})
        found: list[Finding] = []
        perhaps: list[Finding] = []
        if not above or not senders:
            told = {each for sender in senders for each in (*sender.findings, *sender.perhaps)}
            for port in self.sides[topic, "sink"]:
                found += [each for each in self._about(port, "port", "node") if each not in told]
                perhaps += [each for each in self._about(port, "part") if each not in told]
        return Silence(topic, readers, senders, tuple(near), tuple(sorted(unseen, key=repr)), _ordered(found), _ordered(perhaps))

    def _start(self, node: Any) -> str:
        return next((str(name) for start, name, _ in self.result.rows("started_name") if start == node), str(node))

    def _sender(self, port: Port, above: tuple[str, ...]) -> Sender:
        inputs = sorted({self.topic_of[source] for source in self.fed[port] if source in self.topic_of})
        return Sender(
            self.nodes[port],
            self.places.get(self.at.get(port)),
            port in self.never,
            _ordered(self._about(port, "port", "node")),
            _ordered(self._about(port, "part")),
            tuple(self.silence(each, above) for each in inputs),
        )


def _ordered(found: Sequence[Finding]) -> tuple[Finding, ...]:
    return tuple(sorted(dict.fromkeys(found), key=lambda each: (each.place, each.message)))
