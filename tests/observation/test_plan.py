"""Plans of experiments, and the messages that they need; nothing runs here."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import pytest
from nodes import EXAMPLES

from rosarch.extractor.messages import MessageStore, load_messages
from rosarch.models.machine.logic import OTHER, Subject
from rosarch.observation.content import ContentError, encoded, needed
from rosarch.observation.plan import plan
from rosarch.observation.subject import Subject as Probed
from rosarch.reports.probe import plan_text

DOCKING = """Docking::state_ becomes State::APPROACHING  src/auto_docking/src/docking.cpp:51
  wait -> nothing
  /docking/dock -> /cmd_vel, /docking/state
  /beacon with beacon->point.x < range_ -> /cmd_vel, /docking/state
  /beacon with beacon->point.x < range_ -> /cmd_vel
    else it sends /cmd_vel, /docking/state
"""
LAMP = """::g_lit becomes !g_lit  src/auto_docking/src/dock_lamp.cpp:39
  wait -> nothing
  /charging with msg.data -> /lamp
  wait -> nothing
    else it sends /lamp
"""


@pytest.fixture(scope="module")
def store() -> MessageStore:
    return load_messages([])


def subject(example: str, path: str, store: MessageStore) -> Probed:
    """A component as its model was written by hand."""
    file = EXAMPLES / example / "expected" / path
    return Probed(json.loads(file.read_text(encoding="utf-8")), store, f"/{file.stem}")


@pytest.mark.parametrize(("component", "count", "part"), [("docking", 12, DOCKING), ("dock_lamp", 4, LAMP)])
def test_every_row_has_an_experiment(component: str, count: int, part: str, store: MessageStore) -> None:
    probed = subject("docking_states", f"auto_docking/{component}.json", store)
    found = plan(probed.machine, probed.rows)
    assert (len(found.experiments), found.unreached) == (count, ())
    text = plan_text(probed, found)
    assert text.startswith(f"/{component}: {count} of {count} can be settled\n")
    assert part in text


def test_what_cannot_be_reached_has_a_reason(store: MessageStore) -> None:
    document = json.loads((EXAMPLES / "docking_states/expected/auto_docking/docking.json").read_text())
    document["reactive"][0]["when"] = "lookUp(*beacon)"
    document["transitions"][4]["trigger"] = ["startup"]
    odd = Probed(document, store, "/docking")
    reasons = {row.index: reason for row, reason in plan(odd.machine, odd.rows).unreached if row.kind == "transitions"}
    assert reasons[4] == "nothing can be put into what triggers it"


def test_a_loop_that_is_left_out_leaves_other_rows_what_they_are(store: MessageStore) -> None:
    """A loop without a place is none: the rows of others are named by their own entries of the document."""
    document = json.loads((EXAMPLES / "docking_states/expected/auto_docking/docking.json").read_text())
    whole, odd = (Probed(each, store, "/docking") for each in (document, {**document, "periodic": [{"at": None}, *document["periodic"]]}))
    assert [odd.entry(row) for row in odd.rows] == [whole.entry(row) for row in whole.rows]
    assert plan_text(odd, plan(odd.machine, odd.rows)) == plan_text(whole, plan(whole.machine, whole.rows))
    assert {odd.index(row) for row in odd.rows if row.kind == "periodic"} == {1}


MODE = Subject("msg.mode", "msg.mode", ("AUTO", "3", OTHER))


@pytest.mark.parametrize(
    ("asked", "value", "expected"),
    [
        ("msg->data", "true", {"data": 1.0}),
        ("msg.header.seq", "false", {"header.seq": 0.0}),
        ("p->point.x < range_", "true", {"point.x": 1.0}),
        ("p->point.x < range_", "false", {"point.x": 2.0}),
        ("p->point.x >= 0.5f", "true", {"point.x": 0.5}),
        ("3 < cmd.speed", "true", {"speed": 4.0}),
        ("3 < cmd.speed", "false", {"speed": 3.0}),
        ("cmd.gear != 2", "false", {"gear": 2.0}),
        ("cmd.gear != 2", "true", {"gear": 3.0}),
        ("range_ > p->point.x", "true", {"point.x": 1.0}),
        ("cmd.gear <= 0x10", "false", {"gear": 17.0}),
        ("member_.x < 3", "true", None),
        ("lookUp(*msg)", "true", None),
        ("msg->ranges[i] < 3", "true", None),
        ("msg->x < limit()", "true", None),
    ],
)
def test_what_a_condition_needs(asked: str, value: str, expected: dict[str, float] | None) -> None:
    assert needed(Subject(asked, asked), value, {"member_", "range_"}, {"range_": 2.0}) == expected


@pytest.mark.parametrize(("value", "expected"), [("3", {"mode": 3.0}), ("AUTO", {"mode": 1.0}), (OTHER, {"mode": 100.0})])
def test_a_value_that_is_told_apart(value: str, expected: dict[str, float]) -> None:
    assert needed(MODE, value, (), {"AUTO": 1.0}) == expected


@pytest.mark.parametrize(
    "type_", ["std_msgs/Bool", "geometry_msgs/PoseWithCovarianceStamped", "sensor_msgs/CameraInfo", "nav_msgs/Odometry"]
)
def test_messages_are_as_others_write_them(type_: str, store: MessageStore) -> None:
    from rosbags.typesys import Stores, get_typestore

    data = encoded(store, type_, {})
    known = get_typestore(Stores.ROS1_NOETIC)
    name = type_.replace("/", "/msg/")
    assert bytes(known.serialize_ros1(known.deserialize_ros1(data, name), name)) == data


def test_a_message_with_values(store: MessageStore) -> None:
    data = encoded(store, "geometry_msgs/PointStamped", {"header.frame_id": "map", "point.y": 1.5})
    assert data == bytes(12) + struct.pack("<I3sddd", 3, b"map", 0, 1.5, 0)[:7] + struct.pack("<ddd", 0, 1.5, 0)


@pytest.mark.parametrize(
    ("type_", "values", "message"),
    [
        ("demo/Gone", {}, "demo/Gone has no definition"),
        ("std_msgs/Bool", {"value": 1}, "std_msgs/Bool has no field value"),
        ("std_msgs/UInt8", {"data": 300}, "300 is no uint8: ubyte format requires 0 <= number <= 255"),
    ],
)
def test_messages_that_cannot_be_made(type_: str, values: dict[str, float], message: str, store: MessageStore) -> None:
    with pytest.raises(ContentError, match=f"^{message}$"):
        encoded(store, type_, values)


@pytest.mark.slow
def test_a_plan_is_printed(rosarch: object, tmp_path: Path) -> None:
    outcome = rosarch("probe", EXAMPLES / "docking_states", "docking", "--plan")  # type: ignore[operator]
    assert outcome.code == 0
    assert DOCKING in outcome.out
