"""What times and intervals come to, in memory that does not grow with their number."""

from __future__ import annotations

import heapq
import math
from dataclasses import dataclass, field

_PRECISION = 0.01
_GROWTH = math.log((1 + _PRECISION) / (1 - _PRECISION))
_LEAST = 1e-9
_KEPT = 10
_GAP = 3.0
"""An interval of more than so many times the median is a gap."""


@dataclass
class Distribution:
    """Seconds, counted in buckets that are each 2 % wider than the last; quantiles are right within 1 %."""

    count: int = 0
    total: float = 0.0
    squares: float = 0.0
    least: float = math.inf
    most: float = -math.inf
    buckets: dict[int, int] = field(default_factory=dict)

    def add(self, seconds: float) -> None:
        """One more."""
        self.count += 1
        self.total += seconds
        self.squares += seconds * seconds
        if seconds < self.least:
            self.least = seconds
        if seconds > self.most:
            self.most = seconds
        bucket = math.ceil(math.log(seconds) / _GROWTH) if seconds > _LEAST else _NOTHING
        self.buckets[bucket] = self.buckets.get(bucket, 0) + 1

    @property
    def mean(self) -> float:
        """The arithmetic mean; 0 of none."""
        return self.total / self.count if self.count else 0.0

    @property
    def deviation(self) -> float:
        """The standard deviation."""
        return math.sqrt(max(0.0, self.squares / self.count - self.mean**2)) if self.count else 0.0

    def quantile(self, share: float) -> float:
        """What `share` of them do not exceed; 0 of none."""
        left = max(1, math.ceil(share * self.count))
        for bucket in sorted(self.buckets):
            left -= self.buckets[bucket]
            if left <= 0:
                return min(max(self._middle(bucket), self.least), self.most)
        return 0.0

    @staticmethod
    def _middle(bucket: int) -> float:
        return 0.0 if bucket == _NOTHING else math.exp(bucket * _GROWTH) * (1 - _PRECISION)


_NOTHING = math.ceil(math.log(_LEAST) / _GROWTH) - 1


@dataclass
class Arrivals:
    """The times at which messages of one sender came on one topic, and what is between them."""

    first: float = 0.0
    last: float = 0.0
    count: int = 0
    intervals: Distribution = field(default_factory=Distribution)
    longest: list[tuple[float, float]] = field(default_factory=list)

    def add(self, time: float) -> None:
        """One more, at a time that is not before the others."""
        if self.count:
            interval = max(0.0, time - self.last)
            self.intervals.add(interval)
            if len(self.longest) < _KEPT:
                heapq.heappush(self.longest, (interval, self.last))
            elif interval > self.longest[0][0]:
                heapq.heapreplace(self.longest, (interval, self.last))
        else:
            self.first = time
        self.last = time
        self.count += 1

    @property
    def hz(self) -> float | None:
        """Messages per second; None when there are fewer than two."""
        return (self.count - 1) / (self.last - self.first) if self.count > 1 and self.last > self.first else None

    def gaps(self) -> list[tuple[float, float]]:
        """The longest intervals that are much longer than most: when each begins, and its length; by time."""
        usual = self.intervals.quantile(0.5)
        return sorted((begin, length) for length, begin in self.longest if usual > 0 and length > _GAP * usual)
