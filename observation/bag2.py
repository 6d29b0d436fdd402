"""Bags of ROS 2, SQLite or MCAP, through `rosbags`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from rosbags.interfaces import Connection, MessageDefinitionFormat, Nodetype
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore

from rosarch.observation.recording import Channel, Damage, Item, RecordingError, begins_with_header, plain_type

SUFFIXES = (".mcap", ".db3")
_METADATA = "metadata.yaml"
_FIRST = 4
"""Before the first field stands how the message is encoded."""
_HEADER = (Nodetype.NAME, "std_msgs/msg/Header")


class Bag2:
    """A bag of ROS 2."""

    def __init__(self, path: Path) -> None:
        self._path = path
        if path.is_dir() and not (path / _METADATA).exists():
            raise RecordingError(f"{path}: no recording of ROS 2: it has no {_METADATA}")
        try:
            self._reader = Reader(path)
            self._reader.open()
        except Exception as error:  # whatever a damaged file makes of SQLite, YAML, zstd and struct
            raise RecordingError(f"{path}: not readable: {_one_line(error)}") from None
        self._channels = {connection.id: _channel(connection) for connection in self._reader.connections}

    def messages(self, damage: Damage) -> Iterator[Item]:
        """All messages, by time."""
        count = 0
        try:
            for connection, time, data in self._reader.messages():
                count += 1
                yield self._channels[connection.id], time, data
        except Exception as error:  # as above
            damage.lines.append(f"{self._path}: after {count} messages: {_one_line(error)}; what comes after them is not read")
        finally:
            self._reader.close()


def _channel(connection: Connection) -> Channel:
    definition, common = connection.msgdef.data, _common().get(connection.msgtype)
    if common is not None:
        header = bool(common[1]) and common[1][0][1] == _HEADER
    else:
        header = connection.msgdef.format is MessageDefinitionFormat.MSG and begins_with_header(definition)
    defined = common is not None or bool(definition.strip())
    return Channel(connection.id, connection.topic, plain_type(connection.msgtype), None, _FIRST if header else None, defined)


@cache
def _common() -> Any:
    """The fields of common types."""
    return get_typestore(Stores.LATEST).fielddefs


def _one_line(error: Exception) -> str:
    text = re.sub(r"^A metadata key is missing KeyError\('(.*)'\)\.$", rf"{_METADATA} has no `\1`", str(error))
    return " ".join(text.split()) or type(error).__name__
