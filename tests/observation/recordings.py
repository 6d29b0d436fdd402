"""Small recordings."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from bags import field, record

from rosarch.observation.wire import packed_fields

FLOAT = "float32 data\n"
STAMPED = "Header header\nfloat32 data\n================\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
BEGIN = 1_700_000_000


@dataclass(frozen=True)
class Line:
    """What one node sends on one topic: at which seconds; with a stamp, messages have a header of the same second."""

    topic: str
    type: str
    sender: str
    times: Iterable[float]
    definition: str = FLOAT
    delay: float = 0.0


def write(path: Path, lines: list[Line], per_chunk: int = 50) -> Path:
    """A bag of ROS 1 without index, as `rosbag record` leaves it when it is killed."""
    head = field("op", b"\3") + field("index_pos", bytes(8)) + field("conn_count", bytes(4)) + field("chunk_count", bytes(4))
    data = bytearray(b"#ROSBAG V2.0\n" + record(head, b" " * (4096 - 8 - len(head))))
    chunk = b"".join(_connection(number, line) for number, line in enumerate(lines))
    counted = [0] * len(lines)
    sent = sorted((time + line.delay, number, time) for number, line in enumerate(lines) for time in line.times)
    for count, (arrived, number, stamped) in enumerate(sent, 1):
        counted[number] += 1
        body = struct.pack("<I", counted[number]) + _time(stamped) + bytes(8) if lines[number].definition == STAMPED else bytes(4)
        chunk += record(field("conn", struct.pack("<I", number)) + field("op", b"\2") + field("time", _time(arrived)), body)
        if count % per_chunk == 0 or count == len(sent):
            data += record(field("compression", b"none") + field("op", b"\5") + field("size", struct.pack("<I", len(chunk))), chunk)
            chunk = b""
    path.write_bytes(bytes(data))
    return path


def _connection(number: int, line: Line) -> bytes:
    told = {"topic": line.topic, "type": line.type, "md5sum": "*", "callerid": line.sender, "message_definition": line.definition}
    return record(field("conn", struct.pack("<I", number)) + field("op", b"\7") + field("topic", line.topic.encode()), packed_fields(told))


def _time(seconds: float) -> bytes:
    return struct.pack("<II", BEGIN + int(seconds), round(seconds % 1 * 10**9))


def every(period: float, begin: float, end: float) -> list[float]:
    """The seconds from `begin` until `end`, one each period."""
    return [round(begin + number * period, 6) for number in range(round((end - begin) / period))]
