"""Bags of ROS 1 (http://wiki.ros.org/Bags/Format/2.0), read from the beginning to where they break; their index is not needed."""

from __future__ import annotations

import struct
from bz2 import BZ2Decompressor
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

from lz4.frame import LZ4FrameDecompressor

from rosarch.observation.recording import Channel, Damage, Item, begins_with_header, plain_type
from rosarch.observation.wire import WireError, unpacked_fields

MAGIC = b"#ROSBAG V2.0\n"
_MESSAGE, _CHUNK, _CONNECTION = 2, 5, 7
_LENGTH = struct.Struct("<I")
_TIME = struct.Struct("<II")
_FIRST = 0
_DECOMPRESSORS: dict[bytes, Any] = {b"bz2": BZ2Decompressor, b"lz4": LZ4FrameDecompressor}
_MOST = 1 << 28
"""No header, chunk or message has so many bytes."""


class _BrokenError(Exception):
    """The text says what is wrong with a record."""


class Bag1:
    """A bag of ROS 1."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._channels: dict[int, Channel] = {}

    def messages(self, damage: Damage) -> Iterator[Item]:
        """All messages, chunk by chunk; a chunk that is damaged is left at the damage, and the next one is read."""
        with self._path.open("rb") as file:
            file.seek(len(MAGIC))
            size = self._path.stat().st_size
            while (at := file.tell()) < size:
                try:
                    header, data = _record(file, size - at)
                except _BrokenError as error:
                    damage.lines.append(f"{self._path}: byte {at} of {size}: {error}; what comes after it is not read")
                    return
                try:
                    if _code(header) == _CHUNK:
                        yield from self._inside(_unpacked(header, data))
                    else:
                        yield from self._item(header, data)
                except _BrokenError as error:
                    damage.lines.append(f"{self._path}: chunk at byte {at}: {error}; the rest of it is not read")

    def _inside(self, chunk: bytes) -> Iterator[Item]:
        """The messages of a chunk."""
        at, end = 0, len(chunk)
        while at < end:
            if at + 4 > end:
                raise _BrokenError("a record that is cut off")
            (length,) = _LENGTH.unpack_from(chunk, at)
            begin = at + 4 + length
            if begin + 4 > end:
                raise _BrokenError("a record that is cut off")
            (size,) = _LENGTH.unpack_from(chunk, begin)
            if begin + 4 + size > end:
                raise _BrokenError("a record that is cut off")
            yield from self._item(chunk[at + 4 : begin], memoryview(chunk)[begin + 4 : begin + 4 + size])
            at = begin + 4 + size

    def _item(self, header: bytes, data: bytes | memoryview) -> Iterator[Item]:
        code = _code(header)
        if code == _MESSAGE:
            number, time = _numbers(header)
            channel = self._channels.get(number)
            if channel is None:
                raise _BrokenError(f"a message of the connection {number}, which was not told of")
            yield channel, time, data
        elif code == _CONNECTION:
            self._connect(_fields(header), _fields(bytes(data)))

    def _connect(self, header: dict[str, bytes], told: dict[str, bytes]) -> None:
        number = int.from_bytes(header.get("conn", b""), "little")
        if number in self._channels:
            return
        told["topic"] = header.get("topic", told.get("topic", b""))
        text = {name: value.decode("utf-8", "replace") for name, value in told.items()}
        definition = text.get("message_definition", "")
        self._channels[number] = Channel(
            number=number,
            topic=text["topic"],
            type=plain_type(text.get("type", "?")),
            sender=text.get("callerid"),
            stamped=_FIRST if begins_with_header(definition) else None,
            defined=bool(definition.strip()),
            latched=text.get("latching") == "1",
        )


def _record(file: BinaryIO, left: int) -> tuple[bytes, bytes]:
    """The next record of a file in which so many bytes are left: its header and its data."""
    parts = []
    for name in ("header", "data"):
        if left < 4:
            raise _BrokenError("the length of a record is cut off")
        (length,) = _LENGTH.unpack(file.read(4))
        left -= 4
        if length > left:
            raise _BrokenError(f"the {name} of a record should have {length} bytes and has {left}")
        if length > _MOST:
            raise _BrokenError(f"the {name} of a record claims {length} bytes")
        parts.append(file.read(length))
        left -= length
    return parts[0], parts[1]


def _unpacked(header: bytes, data: bytes) -> bytes:
    """The content of a chunk."""
    fields = _fields(header)
    compression, size = fields.get("compression", b"none"), int.from_bytes(fields.get("size", b""), "little")
    if compression == b"none":
        return data
    if compression not in _DECOMPRESSORS:
        raise _BrokenError(f"compressed as {compression.decode('utf-8', 'replace')}, which is not known")
    if size > _MOST:
        raise _BrokenError(f"claims {size} bytes")
    try:
        return bytes(_DECOMPRESSORS[compression]().decompress(data, max_length=size))
    except (OSError, RuntimeError, ValueError, EOFError) as error:
        raise _BrokenError(f"not decompressed ({error})") from None


def _fields(data: bytes) -> dict[str, bytes]:
    try:
        return unpacked_fields(data)
    except WireError as error:
        raise _BrokenError(str(error)) from None


def _code(header: bytes) -> int:
    at = _places(header)[0]
    if len(header) > at and header[at - 3 : at] == b"op=":
        return header[at]
    found = _fields(header).get("op", b"")
    if len(found) != 1:
        raise _BrokenError("a record without a kind")
    return found[0]


def _numbers(header: bytes) -> tuple[int, int]:
    """Connection and time of a message, found where writers usually put them, or else by name."""
    _, number, time = _places(header)
    if len(header) == time + _TIME.size and header[number - 5 : number] == b"conn=" and header[time - 5 : time] == b"time=":
        seconds, nanoseconds = _TIME.unpack_from(header, time)
        return _LENGTH.unpack_from(header, number)[0], seconds * 10**9 + nanoseconds
    fields = _fields(header)
    try:
        seconds, nanoseconds = _TIME.unpack(fields["time"])
        return _LENGTH.unpack(fields["conn"])[0], seconds * 10**9 + nanoseconds
    except (KeyError, struct.error):
        raise _BrokenError("a message without connection or time") from None


def _places(header: bytes) -> tuple[int, int, int]:
    """Where the values of op, connection and time are in the header of a message, in the order of C++ or of Python."""
    return (20, 9, 30) if header[4:9] == b"conn=" else (7, 17, 30)
