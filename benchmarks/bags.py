"""Write a bag of ROS 1 of a given size, and report how long its summary takes and how much memory: `benchmarks/bags.py --mib 1024`."""

from __future__ import annotations

import argparse
import resource
import struct
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from rosarch.observation.recording import open_recording
from rosarch.observation.summary import summarise
from rosarch.observation.wire import packed_fields

HEADED = "Header header\nuint8[] data\n"
CHUNK = 768 * 1024
# topic, type, sender, bytes, messages per second: as on a robot with a camera, a laser scanner and wheels
TOPICS = (
    ("/camera/image", "sensor_msgs/Image", "/camera", 300_000, 15),
    ("/points", "sensor_msgs/PointCloud2", "/lidar", 500_000, 10),
    ("/scan", "sensor_msgs/LaserScan", "/laser", 4_000, 40),
    ("/imu", "sensor_msgs/Imu", "/imu", 320, 400),
    ("/odom", "nav_msgs/Odometry", "/base", 720, 100),
    ("/tf", "tf2_msgs/TFMessage", "/base", 110, 200),
    ("/joint_states", "sensor_msgs/JointState", "/base", 250, 200),
    ("/cmd_vel", "geometry_msgs/Twist", "/controller", 48, 20),
)


def field(name: str, value: bytes) -> bytes:
    """A field of a header."""
    return struct.pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value


def record(header: bytes, data: bytes) -> bytes:
    """A record of a bag."""
    return struct.pack("<I", len(header)) + header + struct.pack("<I", len(data)) + data


def messages() -> Iterator[tuple[int, int]]:
    """The times of messages in nanoseconds, each with the number of its topic."""
    following = [(0, number) for number in range(len(TOPICS))]
    while True:
        at, number = min(following)
        yield at, number
        following[number] = (at + 10**9 // TOPICS[number][4], number)


def write(file: BinaryIO, size: int) -> int:
    """Write a bag of so many bytes; the number of its messages."""
    file.write(b"#ROSBAG V2.0\n")
    head = field("op", b"\3") + field("index_pos", bytes(8)) + field("conn_count", bytes(4)) + field("chunk_count", bytes(4))
    file.write(record(head, b" " * (4096 - 8 - len(head))))
    chunk, sequences = bytearray(), [0] * len(TOPICS)
    for number, (topic, type_, sender, _, _) in enumerate(TOPICS):
        told = packed_fields({"topic": topic, "type": type_, "md5sum": "*", "callerid": sender, "message_definition": HEADED})
        chunk += record(field("conn", struct.pack("<I", number)) + field("op", b"\7") + field("topic", topic.encode()), told)
    for count, (at, number) in enumerate(messages(), 1):
        seconds, rest = divmod(1_700_000_000 * 10**9 + at, 10**9)
        stamp = struct.pack("<II", seconds, rest)
        sequences[number] += 1
        data = struct.pack("<I", sequences[number]) + stamp + bytes(TOPICS[number][3] - 12)
        chunk += record(field("conn", struct.pack("<I", number)) + field("op", b"\2") + field("time", stamp), data)
        if len(chunk) > CHUNK:
            head = field("compression", b"none") + field("op", b"\5") + field("size", struct.pack("<I", len(chunk)))
            file.write(record(head, bytes(chunk)))
            chunk.clear()
            if file.tell() >= size:
                return count
    raise AssertionError("messages do not end")


def main() -> None:
    """Write, read, report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mib", type=int, default=1024)
    mib = parser.parse_args().mib
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run.bag"
        with path.open("wb") as file:
            count = write(file, mib << 20)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        begin, used = time.monotonic(), time.process_time()
        found = summarise(open_recording(path))
        seconds, cpu = time.monotonic() - begin, time.process_time() - used
    read = sum(stream.arrivals.count for stream in found.streams.values())
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    print(f"{mib} MiB, {count} messages, {found.seconds:.0f} s recorded")
    print(f"{read} read in {seconds:.1f} s ({cpu:.1f} s CPU), {grown:.0f} MiB of memory")


if __name__ == "__main__":
    main()
