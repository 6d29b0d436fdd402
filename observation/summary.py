"""What passed through topics, summarised while it is read: how often, with which gaps, lost messages, and delays."""

from __future__ import annotations

import struct
from collections import OrderedDict, deque
from collections.abc import Collection
from dataclasses import dataclass, field

from rosarch.observation.recording import Channel, Damage, Item, Recording
from rosarch.observation.statistics import Arrivals, Distribution

_HEADER = struct.Struct("<III")
_STAMP = struct.Struct("<iI")
_RECENT = 4096
"""Among how many earlier stamps the one of a message is looked for."""
_NUMBERS = 64
_SECOND = 10**9

Pair = tuple[str, str]
"""Two topics: of what arrives, and of what is sent."""


@dataclass
class Stream:
    """What one sender sent on one topic; `lost` are messages that its sequence numbers leave out, `ages` are from stamp to recording."""

    topic: str
    type: str
    sender: str | None
    latched: bool = False
    arrivals: Arrivals = field(default_factory=Arrivals)
    size: int = 0
    lost: int = 0
    sequence: int | None = None
    ages: Distribution = field(default_factory=Distribution)


@dataclass
class Answers:
    """How what is sent on one topic follows what arrives on another.

    `inputs` arrived, of which `answered` were followed by an output before the next one; `delays` are from these to the first output.
    `numbered` are those between messages whose sequence numbers keep the distance that they had at first.
    """

    inputs: int = 0
    answered: int = 0
    open_since: float | None = None
    delays: Distribution = field(default_factory=Distribution)
    numbered: Distribution = field(default_factory=Distribution)
    distance: int | None = None
    recent: deque[tuple[int, float]] = field(default_factory=lambda: deque(maxlen=_NUMBERS))

    def take(self, time: float, number: int | None) -> None:
        """An input."""
        self.inputs += 1
        self.open_since = time
        if number is not None:
            self.recent.append((number, time))

    def answer(self, time: float, number: int | None) -> None:
        """An output."""
        if self.open_since is not None:
            self.answered += 1
            self.delays.add(max(0.0, time - self.open_since))
            self.open_since = None
        if number is None or not self.recent:
            return
        if self.distance is None:
            self.distance = number - self.recent[-1][0]
        for known, then in reversed(self.recent):
            if known == number - self.distance:
                self.numbered.add(max(0.0, time - then))
                return


@dataclass
class Summary:
    """What was recorded from `begin`, in seconds of the epoch, for so many `seconds`.

    `stamped` are delays between messages of one stamp, `ordered` says of pairs that were asked about what follows what; `undefined` are
    types without definition, of whose messages the headers are not read.
    """

    streams: dict[int, Stream] = field(default_factory=dict)
    undefined: set[str] = field(default_factory=set)
    stamped: dict[Pair, Distribution] = field(default_factory=dict)
    ordered: dict[Pair, Answers] = field(default_factory=dict)
    damage: Damage = field(default_factory=Damage)
    begin: float | None = None
    end: float = 0.0

    @property
    def seconds(self) -> float:
        """How long it was recorded."""
        return self.end - self.begin if self.begin is not None else 0.0


def summarise(recording: Recording, pairs: Collection[Pair] = ()) -> Summary:
    """Read a recording once; of `pairs` the summary says how what is sent on the second follows what arrives on the first."""
    reader = _Reader(pairs)
    for item in recording.messages(reader.summary.damage):
        reader.add(item)
    return reader.summary


class _Reader:
    """Takes one message after the other."""

    def __init__(self, pairs: Collection[Pair]) -> None:
        self.summary = Summary(ordered={pair: Answers() for pair in sorted(set(pairs))})
        self._from = {topic: [pair for pair in self.summary.ordered if pair[0] == topic] for topic, _ in pairs}
        self._to = {topic: [pair for pair in self.summary.ordered if pair[1] == topic] for _, topic in pairs}
        self._stamps: OrderedDict[int, list[tuple[Channel, float]]] = OrderedDict()
        self._origin: int | None = None

    def add(self, item: Item) -> None:
        """One more message."""
        channel, nanoseconds, data = item
        summary = self.summary
        if self._origin is None:
            self._origin = nanoseconds
            summary.begin = summary.end = nanoseconds / _SECOND
        time = (nanoseconds - self._origin) / _SECOND
        summary.end = max(summary.end, nanoseconds / _SECOND)
        stream = summary.streams.get(channel.number)
        if stream is None:
            stream = summary.streams[channel.number] = Stream(channel.topic, channel.type, channel.sender, channel.latched)
            if not channel.defined:
                summary.undefined.add(channel.type)
        stream.arrivals.add(time)
        stream.size += len(data)
        if channel.stamped is not None:
            self._header(channel, channel.stamped, stream, nanoseconds, data)
        for pair in self._to.get(channel.topic, ()):
            summary.ordered[pair].answer(time, stream.sequence)
        for pair in self._from.get(channel.topic, ()):
            summary.ordered[pair].take(time, stream.sequence)

    def _header(self, channel: Channel, at: int, stream: Stream, nanoseconds: int, data: bytes | memoryview) -> None:
        """The header of a message: of ROS 1 a sequence number and a stamp, of ROS 2 a stamp."""
        if at == 0:
            if len(data) < _HEADER.size:
                return
            number, seconds, rest = _HEADER.unpack_from(data)
            if stream.sequence is not None and number > stream.sequence + 1:
                stream.lost += number - stream.sequence - 1
            stream.sequence = number
        else:
            if len(data) < at + _STAMP.size:
                return
            seconds, rest = _STAMP.unpack_from(data, at)
        stamp = seconds * _SECOND + rest
        if not stamp:
            return
        stream.ages.add((nanoseconds - stamp) / _SECOND)
        before, time = self._stamps.setdefault(stamp, []), stream.arrivals.last
        for other, then in before:
            if other.topic != channel.topic and (other.sender is None or other.sender != channel.sender):
                self.summary.stamped.setdefault((other.topic, channel.topic), Distribution()).add(time - then)
        if len(before) < len(self.summary.streams):
            before.append((channel, time))
        if len(self._stamps) > _RECENT:
            self._stamps.popitem(last=False)
