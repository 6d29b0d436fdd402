"""Recordings of either generation of ROS: their channels, and the messages in the order in which they were written."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

Item = tuple["Channel", int, bytes | memoryview]
"""A message: on which channel, when (in nanoseconds), and its bytes."""


class RecordingError(Exception):
    """A file of which nothing can be read; the text is one line that says why."""


@dataclass(frozen=True, eq=False)
class Channel:
    """What one sender recorded on one topic; `sender` is None when the recording does not say.

    `stamped` is where a message has its header, None when its type has none or is not known.
    """

    number: int
    topic: str
    type: str
    sender: str | None
    stamped: int | None
    defined: bool
    latched: bool = False


@dataclass
class Damage:
    """What of a recording could not be read: where, and why."""

    lines: list[str] = field(default_factory=list)


class Recording(Protocol):
    """A recording that is open."""

    def messages(self, damage: Damage) -> Iterator[Item]:
        """All messages that can be read; what cannot is added to `damage`."""


_CONSTANT = re.compile(r"\w+(?:/\w+)?\s+\w+\s*=")
_HEADER = re.compile(r"(?:std_msgs/(?:msg/)?)?Header\s+\w+")


def begins_with_header(definition: str) -> bool:
    """Whether the first field of a message, by the text of its definition, is a header."""
    for line in definition.splitlines():
        text = line.partition("#")[0].strip()
        if text.startswith(("===", "MSG:")):
            return False
        if text and not _CONSTANT.match(text):
            return _HEADER.fullmatch(text) is not None
    return False


def plain_type(name: str) -> str:
    """A type as models call it: `std_msgs/String`, of whichever generation it is."""
    return name.replace("/msg/", "/").replace("/srv/", "/").replace("/action/", "/")


def open_recording(path: Path) -> Recording:
    """Open a bag of ROS 1 (a file) or ROS 2 (a folder, or a file of one).

    Raises:
        RecordingError: it is none, or its beginning is not readable.
    """
    from rosarch.observation.bag1 import MAGIC, Bag1
    from rosarch.observation.bag2 import SUFFIXES, Bag2

    try:
        if os.path.isdir(path) or path.suffix in SUFFIXES:
            return Bag2(path)
        with path.open("rb") as file:
            begin = file.read(len(MAGIC))
    except OSError as error:
        raise RecordingError(f"{path}: {error.strerror}") from None
    if begin == MAGIC:
        return Bag1(path)
    told = "an older format of ROS 1, see `rosbag migrate`" if begin.startswith(MAGIC[:9]) else "no recording of ROS"
    raise RecordingError(f"{path}: {told}")
