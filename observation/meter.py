"""How often messages really pass through topics of a live graph."""

from __future__ import annotations

import time
from collections.abc import Iterable

from rosarch.observation.peer import Heard, Peer
from rosarch.observation.statistics import Arrivals


def measure(peer: Peer, topics: Iterable[str], seconds: float) -> dict[str, Arrivals]:
    """What arrives on topics within so many seconds."""
    found = {topic: Arrivals() for topic in topics}
    for topic, arrivals in found.items():
        peer.subscribe(topic, _counted_by(arrivals))
    time.sleep(seconds)
    return found


def _counted_by(arrivals: Arrivals) -> Heard:
    return lambda _sender, at, _message: arrivals.add(at)
