"""What is recorded of a simulated run, and the figures made of it."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise


@dataclass(frozen=True)
class Event:
    """At `time`, `actor` has `sent` or `received` a message of the topic `subject`, lost one (`dropped`) or `changed` a variable."""

    time: float
    kind: str
    actor: str
    subject: str
    detail: str = ""


@dataclass(frozen=True)
class Work:
    """A reaction of a node, from `start` to `end`, to a message or a loop."""

    node: str
    cause: str
    start: float
    end: float


@dataclass(frozen=True)
class Distribution:
    """Figures of a sample."""

    number: int
    least: float
    mean: float
    median: float
    high: float
    most: float


@dataclass
class Record:
    """Everything about a run; `notes` say what was not known, `guessed` how often a condition was decided by lot for want of better."""

    system: str
    seed: int
    duration: float
    events: list[Event] = field(default_factory=list)
    work: list[Work] = field(default_factory=list)
    times: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    dropped: Counter[tuple[str, str]] = field(default_factory=Counter)
    latencies: dict[tuple[str, str], list[float]] = field(default_factory=lambda: defaultdict(list))
    lengths: dict[tuple[str, str], list[tuple[float, int]]] = field(default_factory=lambda: defaultdict(list))
    guessed: Counter[tuple[str, str]] = field(default_factory=Counter)
    notes: list[str] = field(default_factory=list)

    def sent(self, topic: str, time: float, origins: Mapping[str, float]) -> None:
        """A message was sent."""
        self.times[topic].append(time)
        for origin, begun in origins.items():
            if origin != topic:
                self.latencies[origin, topic].append(time - begun)

    def handled(self, node: str, time: float, origins: Mapping[str, float]) -> None:
        """A node has come to the end of its reaction to a message."""
        for origin, begun in origins.items():
            self.latencies[origin, node].append(time - begun)

    def queued(self, node: str, topic: str, length: int, time: float) -> None:
        """So many messages wait now."""
        self.lengths[node, topic].append((time, length))

    def ran(self, node: str, cause: str, start: float, end: float) -> None:
        """A node has reacted."""
        self.work.append(Work(node, cause, start, end))


@dataclass(frozen=True)
class Rate:
    """How often messages were sent on a topic: how many, a second on the whole, and the shortest and longest time between two."""

    topic: str
    number: int
    hz: float
    shortest: float | None
    longest: float | None


@dataclass(frozen=True)
class QueueFigures:
    """How many messages waited for a node, at most and on average, and how many were lost."""

    node: str
    topic: str
    most: int
    mean: float
    dropped: int


def rates(record: Record) -> list[Rate]:
    """Of each topic that something was sent on."""
    found = []
    for topic, times in sorted(record.times.items()):
        gaps = [after - before for before, after in pairwise(times)]
        found.append(Rate(topic, len(times), len(times) / record.duration, min(gaps, default=None), max(gaps, default=None)))
    return found


def queues(record: Record) -> list[QueueFigures]:
    """Of each queue that a message was put into."""
    found = []
    for (node, topic), lengths in sorted(record.lengths.items()):
        ends = [*(time for time, _ in lengths[1:]), record.duration]
        waited = sum(length * (end - time) for (time, length), end in zip(lengths, ends, strict=True))
        most = max(length for _, length in lengths)
        found.append(QueueFigures(node, topic, most, waited / record.duration, record.dropped[node, topic]))
    return found


def latencies(record: Record) -> dict[tuple[str, str], Distribution]:
    """From where a message comes from to the topics it leads to and the nodes that handle it: the seconds in between."""
    return {ends: distribution(sample) for ends, sample in sorted(record.latencies.items())}


def busy(record: Record) -> dict[str, float]:
    """The part of the time that each node was at work."""
    found: dict[str, float] = defaultdict(float)
    for work in record.work:
        found[work.node] += (work.end - work.start) / record.duration
    return dict(sorted(found.items()))


def distribution(sample: Sequence[float]) -> Distribution:
    """The figures of a sample that is not empty; `high` is what 95 of 100 are below."""
    ordered = sorted(sample)

    def at(part: float) -> float:
        return ordered[min(len(ordered) - 1, int(part * len(ordered)))]

    return Distribution(len(ordered), ordered[0], sum(ordered) / len(ordered), at(0.5), at(0.95), ordered[-1])
