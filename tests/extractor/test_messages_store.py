from __future__ import annotations

from pathlib import Path

import pytest
from rosbags.typesys import get_types_from_msg
from workspace_builder import package, write

from rosarch.extractor.messages import Field, MessageStore, load_messages, message_classes
from rosarch.extractor.messages.common_interfaces import common_interfaces, stored_messages
from rosarch.extractor.messages.message_fields import MessageFields
from rosarch.extractor.messages.model import PRIMITIVES
from rosarch.extractor.messages.parse import parse_message
from rosarch.extractor.workspace import Diagnostic, discover
from rosarch.extractor.workspace.model import ROS1, ROS2


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(folder))
    return folder


def store_of(root: Path, files: dict[str, str | bytes], cmake: str = "") -> MessageStore:
    package(root / "ws", "demo", cmake, files)
    return load_messages(discover(root / "ws").packages)


def shown(store: MessageStore, root: Path) -> list[str]:
    return [str(diagnostic).replace(f"{root}/ws/", "") for diagnostic in store.diagnostics]


def types(fields: tuple[Field, ...]) -> list[tuple[str, str, int | None]]:
    return [(field.name, field.type, field.array) for field in fields]


def test_message(tmp_path: Path) -> None:
    text = (
        "# comment\nHeader header\nuint8 A=1\nuint32 lower = 0x10 # why\nstring S= a # b \n"
        "float64[36] cov\nOther[] others # x\ngeometry_msgs/Pose pose\nstring<=10 bounded\nint32[<=3] few\nint32 count 7\n\n"
    )
    store = store_of(tmp_path, {"msg/Thing.msg": text, "msg/Other.msg": "bool a\n"})
    message = store.messages["demo/Thing"]
    assert types(message.fields) == [
        ("header", "std_msgs/Header", None),
        ("cov", "float64", 36),
        ("others", "demo/Other", -1),
        ("pose", "geometry_msgs/Pose", None),
        ("bounded", "string", None),
        ("few", "int32", -1),
        ("count", "int32", None),
    ]
    assert [(one.name, one.type, one.value) for one in message.constants] == [
        ("A", "uint8", "1"),
        ("lower", "uint32", "0x10"),
        ("S", "string", "a # b"),
    ]
    assert store.diagnostics == ()


def test_service_and_action(tmp_path: Path) -> None:
    files = {"srv/Ask.srv": "int32 a\n---\nbool ok\n", "action/Go.action": "int32 goal\n---\nbool done\n---\nfloat32 part\n"}
    store = store_of(tmp_path, files)
    service = store.services["demo/Ask"]
    assert types(store.messages[service.request].fields) == [("a", "int32", None)]
    assert types(store.messages[service.response].fields) == [("ok", "bool", None)]
    assert "demo/Go" in store.actions
    derived = sorted(name for name, message in store.messages.items() if message.owner == "demo/Go")
    parts = ["Action", "ActionFeedback", "ActionGoal", "ActionResult", "Feedback", "Goal", "Result"]
    assert derived == [f"demo/Go{part}" for part in parts]
    assert types(store.messages["demo/GoActionResult"].fields) == [
        ("header", "std_msgs/Header", None),
        ("status", "actionlib_msgs/GoalStatus", None),
        ("result", "demo/GoResult", None),
    ]


@pytest.mark.parametrize(
    ("files", "message"),
    [
        ({"msg/T.msg": "int32 a\n  Pose p\n"}, "demo/msg/T.msg:2:3: unknown type demo/Pose of field p, did you mean `geometry_msgs/Pose`?"),
        ({"msg/T.msg": "int32 a\nint33 b\n"}, "demo/msg/T.msg:2:1: unknown type demo/int33 of field b"),
        ({"msg/T.msg": "int32 a\n  what?\n"}, "demo/msg/T.msg:2:3: not a field: `what?`"),
        ({"srv/T.srv": "int32 a\n"}, "demo/srv/T.srv:1:1: 1 `---` expected, 0 found"),
        ({"action/T.action": "---\n"}, "demo/action/T.action:1:1: 2 `---` expected, 1 found"),
        ({"msg/T.msg": b"int32 a\nint32 b # \xff\n"}, "demo/msg/T.msg:2:1: not UTF-8"),
    ],
)
def test_trouble(tmp_path: Path, files: dict[str, str | bytes], message: str) -> None:
    assert shown(store_of(tmp_path, files), tmp_path) == [message]


def test_a_field_of_unknown_type_is_kept(tmp_path: Path) -> None:
    store = store_of(tmp_path, {"msg/T.msg": "int32 a\nnone_msgs/None b\n"})
    assert [(field.name, field.type_exists) for field in store.messages["demo/T"].fields] == [("a", True), ("b", False)]


def test_workspace_definition_wins(tmp_path: Path) -> None:
    package(tmp_path / "ws", "std_msgs", "add_message_files(FILES Bool.msg)", {"msg/Bool.msg": "int8 own\n"})
    store = load_messages(discover(tmp_path / "ws").packages)
    assert types(store.messages["std_msgs/Bool"].fields) == [("own", "int8", None)]


def test_common_definitions_are_closed() -> None:
    messages, services, actions = common_interfaces()
    unknown = {
        field.type for one in messages.values() for field in one.fields if field.type not in PRIMITIVES and field.type not in messages
    }
    assert unknown == set()
    assert {"std_srvs/Empty", "std_srvs/SetBool", "nav_msgs/GetMap", "dynamic_reconfigure/Reconfigure"} <= set(services)
    assert {"move_base_msgs/MoveBase", "control_msgs/FollowJointTrajectory"} <= set(actions)


def test_store_is_cached_and_a_broken_cache_is_replaced(cache: Path) -> None:
    fresh = stored_messages()
    (file,) = (path for path in cache.rglob("*") if path.is_file())
    assert stored_messages() == fresh
    file.write_text("{broken")
    assert stored_messages() == fresh


def test_unwritable_cache_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {"file": ""})
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "file" / "below"))
    assert "std_msgs/Header" in stored_messages()


@pytest.mark.parametrize(
    "text",
    [
        "int32 a\nfloat64[3] b\nstring[] c\n",
        "uint8 A=1\nstring S=text\n\n# c\ngeometry_msgs/Pose[2] p # d\n",
        "time t\nduration d\nbyte b\nchar c\n",
    ],
)
def test_agrees_with_the_rosbags_parser(text: str) -> None:
    problems: list[Diagnostic] = []
    ours = parse_message(text, "demo/T", Path("T.msg"), problems)
    constants, fields = get_types_from_msg(text, "demo/msg/T")["demo/msg/T"]
    assert [field.name for field in ours.fields] == [name for name, _ in fields]
    assert [constant.name for constant in ours.constants] == [name for name, _, _ in constants]
    assert problems == []


def test_classes(tmp_path: Path) -> None:
    store = store_of(tmp_path, {"action/Go.action": "---\n---\n"})
    found = {one.cxx_class: one for one in message_classes(store)}
    assert (found["std_msgs::Bool_"].type, found["std_msgs::Bool_"].kind) == ("std_msgs/Bool", "message")
    assert (found["std_srvs::Empty"].type, found["std_srvs::Empty"].kind) == ("std_srvs/Empty", "service")
    request = found["std_srvs::EmptyRequest_"]
    assert (request.type, request.kind, request.role, request.owner) == ("std_srvs/EmptyRequest", "message", "request", "std_srvs/Empty")
    assert (found["demo::GoAction_"].kind, found["demo::GoAction_"].owner) == ("action", "demo/Go")
    assert (found["demo::GoGoal_"].kind, found["demo::GoGoal_"].role) == ("message", "goal")


@pytest.mark.parametrize("damage", [b"", b"{}", b"[1,2]", b"x" * 100])
def test_a_damaged_cache_of_common_messages_is_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, damage: bytes) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path))
    known = stored_messages()
    (entry,) = (path for path in tmp_path.rglob("*") if path.is_file())
    whole = entry.read_bytes()
    entry.write_bytes(damage)
    assert stored_messages() == known
    assert entry.read_bytes() == whole
    assert "std_msgs/Header" in known


def test_message_fields(tmp_path: Path) -> None:
    """Those of messages that are used, and of what these are made of; nothing of a file with a line that was not understood."""
    files = {
        "msg/Cup.msg": "uint8 FULL=1\nstd_msgs/Header header\nfloat64[] past\n",
        "msg/Odd.msg": "int32 a\n%\n",
        "srv/Fill.srv": "bool on\n---\n",
    }
    known = MessageFields.of(store_of(tmp_path, files), (), ROS1)
    found = known.used([("", "message", "demo/Cup"), ("", "message", "demo/Odd"), ("", "service", "demo/Fill")])
    assert found["message_known"] == {("demo/Cup",), ("std_msgs/Header",), ("demo/FillRequest",), ("demo/FillResponse",)}
    assert {row[1:] for row in found["message_field"] if row[0] == "demo/Cup"} == {
        ("header", "std_msgs/Header", "one"),
        ("past", "float64", "many"),
        ("FULL", "constant", "one"),
    }
    assert ("std_msgs/Header", "stamp", "time", "one") in found["message_field"]


def test_message_fields_of_ros2() -> None:
    known = MessageFields.of(load_messages([], middleware=ROS2), (), ROS2)
    assert ("std_msgs/Header", "stamp", "builtin_interfaces/Time", "one") in known.rows["std_msgs/Header"]
    assert "control_msgs/JointControllerState" not in known.rows  # it is that of ROS 1
    assert MessageFields.of(None, (), ROS1).rows == {}


def test_defaults_of_fields(tmp_path: Path) -> None:
    """Those that are neither zero nor empty; what ROS 1 would take for one is no definition."""
    files = {"msg/Mode.msg": 'int32 mode 5\nint32 number 0\nfloat64 part 0.0\nbool on true\nstring name ""\nint32 plain\n'}
    assert MessageFields.of(store_of(tmp_path, files), (), ROS2).defaults == {"mode", "on"}
    assert MessageFields.of(store_of(tmp_path, files), (), ROS1).defaults == frozenset()
