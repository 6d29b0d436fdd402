"""What was seen, of whatever source, and the facts that the rules compare with the model."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from rosarch.models.system.rows import Rows
from rosarch.observation.graph import Snapshot
from rosarch.observation.summary import Answers, Stream, Summary

_GRAPH = ("node", "topic", "publisher", "subscriber", "service_server", "parameter", "connection")
"""Of these, a live graph shows all that are there."""
_GRAPH_OF_ROS2 = (*(kind for kind in _GRAPH if kind != "connection"), "service_client", "action_server", "action_client")
_UNTOLD = "?"
_FEWEST = 10
"""Of fewer intervals no rate is reported, of fewer inputs no answers."""


@dataclass(frozen=True)
class Recorded:
    """A recording called `name`, and what passed through its topics."""

    name: str
    summary: Summary

    @property
    def problems(self) -> Sequence[str]:
        """What could not be read."""
        without = [f"{self.name}: no definition of {type_}: headers are not read" for type_ in sorted(self.summary.undefined)]
        return [*self.summary.damage.lines, *without]


@dataclass(frozen=True)
class Watched:
    """A live graph at `uri`, and what it looked like, once or several times; one of ROS 2 has a `domain` for it."""

    uri: str
    snapshots: tuple[Snapshot, ...]
    domain: int | None = None

    @property
    def problems(self) -> Sequence[str]:
        """Nodes that did not answer."""
        return sorted({f"{node}: {reason}" for snapshot in self.snapshots for node, reason in snapshot.silent.items()})


class _Facts:
    def __init__(self, source: str) -> None:
        self.rows: dict[str, set[tuple[Any, ...]]] = defaultdict(set)
        self._source = source

    def sight(self, number: int, text: str) -> str:
        """The key of what the source shows at `number`, which is taken for a line."""
        key = f"{self._source}:{number}"
        self.rows["place"].add((key, self._source, number, 1))
        self.rows["sight"].add((key, text, key))
        return key

    def add(self, relation: str, *row: Any) -> None:
        """A row."""
        self.rows[f"observed_{relation}"].add(row)


def recorded_rows(recorded: Recorded) -> Rows:
    """The facts of a recording."""
    facts = _Facts(f"recording {recorded.name}")
    facts.add("kind", "topic")
    by_topic: dict[str, list[tuple[str, Stream]]] = defaultdict(list)
    for number, stream in recorded.summary.streams.items():
        sight = facts.sight(number + 1, _stream_text(stream))
        by_topic[stream.topic].append((sight, stream))
        if stream.sender is not None:
            facts.add("node", stream.sender, sight)
        facts.add("port", stream.sender or _UNTOLD, "publisher", stream.topic, sight)
        facts.add("type", "topic", stream.topic, stream.type, sight)
    for topic, streams in by_topic.items():
        rate = _rate_of([stream for _, stream in streams])
        if rate is not None:
            facts.add("rate", topic, rate, streams[0][0])
    for (source, sink), answers in recorded.summary.ordered.items():
        if answers.inputs >= _FEWEST and sink in by_topic:
            facts.add("answers", source, sink, answers.inputs, answers.answered, by_topic[sink][0][0])
    return facts.rows


def _rate_of(streams: Sequence[Stream]) -> float | None:
    """Messages per second of all senders of a topic together; None when there are too few for a rate."""
    if any(stream.latched for stream in streams) or sum(stream.arrivals.count for stream in streams) <= _FEWEST:
        return None
    rates = [stream.arrivals.hz for stream in streams if stream.arrivals.count > 1]
    return float(f"{sum(rate for rate in rates if rate is not None):.6g}")


def _stream_text(stream: Stream) -> str:
    hz = stream.arrivals.hz
    sender = f" of {stream.sender}" if stream.sender else ""
    return f"{stream.arrivals.count} messages on {stream.topic}{sender}" + (f", {hz:.3g} a second" if hz else "")


def watched_rows(watched: Watched) -> Rows:
    """The facts of a live graph: what was there at any time."""
    facts = _Facts(f"graph {watched.uri}")
    for kind in _GRAPH if watched.domain is None else _GRAPH_OF_ROS2:
        facts.add("kind", kind)
    for number, snapshot in enumerate(watched.snapshots, 1):
        state = snapshot.state
        counts = f"{len(state.nodes())} nodes after {snapshot.at:g} s"
        sight = facts.sight(number, counts)
        for node in state.nodes():
            facts.add("node", node, sight)
        for kind, node, name in state.ports():
            facts.add("port", node, kind, name, sight)
        for (kind, name), type_ in snapshot.types.items():
            facts.add("type", kind, name, type_, sight)
        for sender, reader, topic in snapshot.connections:
            facts.add("connection", topic, sender, reader, sight)
        for name in snapshot.parameters:
            facts.add("parameter", name, sight)
    return facts.rows


def delays(summary: Summary) -> Iterator[tuple[str, str, str, Any]]:
    """Delays between what arrives on one topic and what is sent on another: the topics, how they were found, and the seconds."""
    for (source, sink), found in sorted(summary.stamped.items()):
        yield source, sink, "stamp", found
    for (source, sink), answers in sorted(summary.ordered.items()):
        if _kept_distance(answers):
            yield source, sink, "sequence", answers.numbered
        if answers.delays.count:
            yield source, sink, "order", answers.delays


def _kept_distance(answers: Answers) -> bool:
    """Whether nearly each output belongs to an input by its number."""
    return answers.numbered.count >= max(_FEWEST, 0.9 * answers.inputs)
