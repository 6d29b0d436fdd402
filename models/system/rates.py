"""How often topics of a system are sent on: the intervals that the rules derive, with the nodes that send."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

from rosarch.datalog import Result
from rosarch.models.system.asking import Port, Rate, find_topic
from rosarch.models.system.rows import Rows
from rosarch.rule_programs.sets import SystemRules

EVERY = "*"
"""All topics."""
RATE_RELATIONS = ("joins_connector", "port_node", "topic_high", "topic_low", "topic_unbounded")


@dataclass(frozen=True)
class TopicRate:
    """Between `low` and `high` messages per second pass through `topic`; without an upper bound `high` is None, `reasons` say why."""

    topic: str
    low: float
    high: float | None
    senders: tuple[str, ...]
    reasons: tuple[str, ...] = ()


def ask_rates(rules: SystemRules, rows: Rows, asked: Rate, engine: str) -> list[TopicRate]:
    """The rate of a topic, or of all of them, in the system that `rows` are the facts of.

    Raises:
        QuestionError: there is no such topic.
    """
    found = list(all_rates(rules.program.evaluate(rows, engine=engine, keep=RATE_RELATIONS)))
    if asked.topic == EVERY:
        return found
    topic = find_topic(asked.topic, [rate.topic for rate in found])
    return [rate for rate in found if rate.topic == topic]


def all_rates(result: Result) -> Iterator[TopicRate]:
    """The rate of every topic, by name, from the rows of `RATE_RELATIONS`."""
    nodes: dict[Port, str] = dict(result.rows("port_node"))
    senders: dict[str, set[str]] = defaultdict(set)
    topics: set[str] = set()
    for kind, name, side, port in result.rows("joins_connector"):
        if kind == "topic":
            topics.add(name)
            if side == "source":
                senders[name].add(nodes[port])
    low: dict[str, float] = dict(result.rows("topic_low"))
    high: dict[str, float] = dict(result.rows("topic_high"))
    reasons: dict[str, set[str]] = defaultdict(set)
    for topic, reason in result.rows("topic_unbounded"):
        reasons[topic].add(reason)
    for topic in sorted(topics):
        yield TopicRate(topic, low.get(topic, 0.0), high.get(topic), tuple(sorted(senders[topic])), tuple(sorted(reasons[topic])))
