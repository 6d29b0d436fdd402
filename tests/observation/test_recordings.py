"""Recordings: what they show, and what is told of those that are damaged."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from recordings import STAMPED, Line, every, write

from rosarch.observation.observed import delays
from rosarch.observation.recording import RecordingError, begins_with_header, open_recording
from rosarch.observation.statistics import Distribution
from rosarch.observation.summary import Summary, summarise

SCAN = Line("/scan", "sensor_msgs/LaserScan", "/laser", every(0.1, 0, 10), STAMPED)
CLEAN = Line("/clean", "sensor_msgs/LaserScan", "/filter", every(0.1, 0, 10), STAMPED, delay=0.02)


def read(path: Path, *pairs: tuple[str, str]) -> Summary:
    return summarise(open_recording(path), pairs)


def test_rates_gaps_and_lost_messages(tmp_path: Path) -> None:
    times = [*every(0.1, 0, 5), *every(0.1, 7, 10)]
    found = read(write(tmp_path / "run.bag", [Line("/a", "demo/A", "/driver", times), Line("/b", "demo/B", "/driver", [3.0])]))
    stream, single = found.streams.values()
    assert (stream.topic, stream.type, stream.sender, stream.arrivals.count) == ("/a", "demo/A", "/driver", 80)
    assert stream.arrivals.hz == pytest.approx(79 / 9.9)
    assert stream.arrivals.gaps() == [(pytest.approx(4.9), pytest.approx(2.1))]
    assert stream.arrivals.intervals.quantile(0.5) == pytest.approx(0.1, rel=0.02)
    assert (single.arrivals.hz, single.arrivals.gaps()) == (None, [])
    assert found.seconds == pytest.approx(9.9)


def test_delays_by_stamp_number_and_order(tmp_path: Path) -> None:
    found = read(write(tmp_path / "run.bag", [SCAN, CLEAN]), ("/scan", "/clean"))
    told = {(source, sink, how): (spread.count, spread.quantile(0.5)) for source, sink, how, spread in delays(found)}
    assert told == {("/scan", "/clean", how): (100, pytest.approx(0.02, rel=0.02)) for how in ("stamp", "sequence", "order")}
    assert (found.ordered["/scan", "/clean"].inputs, found.ordered["/scan", "/clean"].answered) == (100, 100)


def test_what_one_node_stamps_alike_is_no_delay(tmp_path: Path) -> None:
    info = Line("/info", "sensor_msgs/CameraInfo", "/laser", every(0.1, 0, 10), STAMPED, delay=0.001)
    assert read(write(tmp_path / "run.bag", [SCAN, info])).stamped == {}


def test_messages_that_sequence_numbers_leave_out(tmp_path: Path) -> None:
    path = write(tmp_path / "run.bag", [Line("/scan", "s/S", "/laser", every(0.1, 0, 1), STAMPED)], per_chunk=1)
    data = path.read_bytes()
    chunks = [match.start() - 4 for match in re.finditer(rb"....\x10\0\0\0compression=none", data, re.DOTALL)]
    path.write_bytes(data[: chunks[3]] + data[chunks[5] :])
    (stream,) = read(path).streams.values()
    assert (stream.arrivals.count, stream.lost) == (8, 2)


def test_a_recording_that_is_cut_off_is_read_up_to_there(tmp_path: Path) -> None:
    path = write(tmp_path / "run.bag", [SCAN])
    data = path.read_bytes()
    path.write_bytes(data[:-100])
    found = read(path)
    (stream,) = found.streams.values()
    assert stream.arrivals.count == 50
    (line,) = found.damage.lines
    assert re.fullmatch(
        rf"{path}: byte \d+ of {len(data) - 100}: the data of a record should have \d+ bytes and has \d+; what comes after it is not read",
        line,
    )


def test_a_chunk_that_is_damaged_is_left_out(tmp_path: Path) -> None:
    path = write(tmp_path / "run.bag", [SCAN], per_chunk=20)
    data = bytearray(path.read_bytes())
    middle = [match.start() for match in re.finditer(rb"compression=none", data)][2]
    at = data.index(b"conn=", middle) - 8  # the length of the header of the first message
    data[at : at + 4] = b"\xff\xff\xff\x7f"
    path.write_bytes(bytes(data))
    found = read(path)
    (stream,) = found.streams.values()
    assert stream.arrivals.count == 80
    (line,) = found.damage.lines
    assert re.fullmatch(rf"{path}: chunk at byte \d+: a record that is cut off; the rest of it is not read", line)


def test_a_type_without_definition_is_told(tmp_path: Path) -> None:
    found = read(write(tmp_path / "run.bag", [Line("/a", "demo/A", "/driver", [1.0], "")]))
    assert found.undefined == {"demo/A"}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "no recording of ROS"),
        (b"#ROSBAG V1.2\n", "an older format of ROS 1, see `rosbag migrate`"),
        (b"PK\3\4", "no recording of ROS"),
    ],
)
def test_what_is_no_recording_is_refused(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "run.bag"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=f"^{re.escape(f'{path}: {message}')}$"):
        open_recording(path)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"gone.bag: No such file or directory$"):
        open_recording(tmp_path / "gone.bag")


@pytest.mark.parametrize("compression", ["none", "bz2", "lz4"])
def test_bags_of_rosbags(compression: str, tmp_path: Path) -> None:
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS1_NOETIC)
    path = tmp_path / "run.bag"
    writer = Writer(path)
    if compression != "none":
        writer.set_compression(Writer.CompressionFormat[compression.upper()])
    with writer:
        connection = writer.add_connection("/flag", "std_msgs/msg/Bool", typestore=store, callerid="/switch")
        for second in range(12):
            writer.write(connection, second * 10**9 + 1, b"\1")
    (stream,) = read(path).streams.values()
    assert (stream.topic, stream.type, stream.sender, stream.arrivals.hz) == ("/flag", "std_msgs/Bool", "/switch", 1.0)


@pytest.mark.parametrize("storage", ["SQLITE3", "MCAP"])
def test_bags_of_ros_2(storage: str, tmp_path: Path) -> None:
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    header = store.types["std_msgs/msg/Header"](store.types["builtin_interfaces/msg/Time"](5, 0), "map")
    point = store.types["geometry_msgs/msg/Point"](0.0, 0.0, 0.0)
    message = store.types["geometry_msgs/msg/PointStamped"](header, point)
    with Writer(tmp_path / "run", version=9, storage_plugin=StoragePlugin[storage]) as writer:
        connection = writer.add_connection("/goal", "geometry_msgs/msg/PointStamped", typestore=store)
        for second in range(12):
            writer.write(connection, (second + 6) * 10**9, store.serialize_cdr(message, "geometry_msgs/msg/PointStamped"))
    found = read(tmp_path / "run")
    (stream,) = found.streams.values()
    assert (stream.topic, stream.type, stream.sender, stream.arrivals.hz) == ("/goal", "geometry_msgs/PointStamped", None, 1.0)
    assert (stream.ages.least, stream.ages.most) == (1.0, 12.0)
    (file,) = [file for file in (tmp_path / "run").iterdir() if file.suffix in (".db3", ".mcap")]
    file.write_bytes(file.read_bytes()[:2000])
    with pytest.raises(RecordingError, match=r"run: not readable: "):
        read(tmp_path / "run")


@pytest.mark.parametrize(
    ("definition", "expected"),
    [
        ("Header header\n", True),
        ("# what\nuint8 ON=1\nstd_msgs/Header head # stamp\nint32 x", True),
        ("std_msgs/msg/Header header", True),
        ("int32 x\nHeader header", False),
        ("Header[] headers", False),
        ("================\nMSG: std_msgs/Header\nHeader header", False),
        ("", False),
    ],
)
def test_definitions_that_begin_with_a_header(definition: str, expected: bool) -> None:
    assert begins_with_header(definition) is expected


def test_quantiles_are_right_within_a_hundredth() -> None:
    found = Distribution()
    for number in range(1, 1001):
        found.add(number / 1000)
    assert [found.quantile(share) for share in (0.5, 0.99, 1.0)] == [pytest.approx(each, rel=0.011) for each in (0.5, 0.99, 1.0)]
    assert (found.least, found.most, found.count) == (0.001, 1.0, 1000)
    assert len(found.buckets) < 400
    assert Distribution().quantile(0.5) == 0.0


def test_a_folder_without_metadata_or_with_a_part_of_it(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r": no recording of ROS 2: it has no metadata.yaml$"):
        read(tmp_path)
    (tmp_path / "metadata.yaml").write_text("rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n")
    with pytest.raises(RecordingError, match=r": not readable: metadata.yaml has no `\w+`$"):
        read(tmp_path)
