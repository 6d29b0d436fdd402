"""The shipped files, and the form of library files."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from rosarch.library import components, find, load
from rosarch.library.build import document_text
from rosarch.library.reading import LibraryFile, read_library_file
from rosarch.reports.library import library_schema

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = sorted((ROOT / "library").rglob("*.json"))
EXAMPLE = re.search(r"```json\n(.*?)```", (ROOT / "docs" / "library.md").read_text(), re.DOTALL)

FILE: dict[str, Any] = {"package": "p", "origin": "o", "revision": "r", "made": "by hand", "components": []}
NODE: dict[str, Any] = {"component": "n", "kind": "node"}


def of(**component: Any) -> dict[str, Any]:
    return {**FILE, "components": [{**NODE, **component}]}


def port(**fields: Any) -> dict[str, Any]:
    return of(ports=[{"kind": "publisher", "name": "a", **fields}])


def test_the_schema_is_a_schema() -> None:
    Draft202012Validator.check_schema(library_schema())


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_shipped_files_are_as_they_should_be(path: Path) -> None:
    found = read_library_file(path)
    assert isinstance(found, LibraryFile), found
    data = json.loads(path.read_text())
    Draft202012Validator(library_schema()).validate(data)
    assert path.stem == found.package
    assert found.made == ("by hand" if path.parent.name.endswith("by_hand") else "generated")
    assert found.ros == ((2,) if path.parent.name.startswith("ros2_") else (1,))
    assert found.origin.startswith("https://")
    if found.made == "generated":
        assert path.read_text() == document_text(data), "not as `rosarch library build` writes it"


def test_no_shipped_file_is_left_out() -> None:
    assert load().problems == ()
    assert len(list(components())) > 50


def test_the_example_of_the_documentation_is_valid(tmp_path: Path) -> None:
    assert EXAMPLE
    path = tmp_path / "demo.json"
    path.write_text(EXAMPLE.group(1))
    assert isinstance(read_library_file(path), LibraryFile)
    Draft202012Validator(library_schema()).validate(json.loads(EXAMPLE.group(1)))


WRONG = [
    ([], "file: must be an object"),
    ({**FILE, "origin": 3}, "file: `origin` must be a text that is not empty"),
    ({**FILE, "revison": "1"}, "file: unknown field `revison`, did you mean `revision`?"),
    ({key: value for key, value in FILE.items() if key != "revision"}, "file: `revision` is missing"),
    ({**FILE, "made": "magic"}, 'file: `made` "magic" is none of generated, by hand'),
    ({**FILE, "components": {}}, "file: `components` must be a list"),
    ({**FILE, "components": [3]}, "components[0]: must be an object"),
    ({**FILE, "components": [{"component": "n"}]}, "components[0]: `kind` is missing"),
    ({**FILE, "components": [NODE, NODE]}, "components[1]: n is there twice"),
    (of(kind="nod"), 'components[0]: `kind` "nod" is none of node, nodelet, component, plugin, gazebo_plugin, did you mean `node`?'),
    (of(open="yes"), 'components[0]: `open` must be true, false, "ports" or "params"'),
    (of(options=[1]), "components[0]: `options` must be a list of texts"),
    (of(elements={"topic": 1}), "components[0]: `elements` must map names of elements to their default text, or to null"),
    (port(kind="publsher"), 'n: ports[0]: `kind` "publsher" is none of publisher, subscriber, service_server, service_client, action_server, '
     "action_client, tf_broadcaster, tf_listener, dynamic_reconfigure_server, did you mean `publisher`?"),
    (port(kind=[]), "n: ports[0]: `kind` [] is none of publisher, subscriber, service_server, service_client, action_server, "
     "action_client, tf_broadcaster, tf_listener, dynamic_reconfigure_server"),
    (of(ports=[{"kind": "publisher"}]), "n: ports[0]: nothing names it: give `name`, `from_param`, `from_arg` or `param_pattern`"),
    (port(queue=True), "n: ports[0]: `queue` must be a whole number of 0 or more"),
    (port(from_arg=0), "n: ports[0]: `from_arg` must be a whole number of 1 or more"),
    (port(rest=True), "n: ports[0]: `rest` needs `from_arg`"),
    (port(latched="yes"), "n: ports[0]: `latched` must be true or false"),
    (port(if_arg={"x": "y"}), 'n: ports[0]: `if_arg` must map numbers of arguments to regular expressions, as in {"1": "messages"}'),
    (port(param_pattern="~(a"), "n: ports[0]: `param_pattern` is no regular expression (missing ), unterminated subpattern at position 1)"),
    (port(name="{x}"), "n: ports[0]: {x} is no number of an argument"),
    (of(kind="gazebo_plugin", elements={"topicName": "a"}, ports=[{"kind": "publisher", "name": "{topicNam}"}]),
     "n: ports[0]: `topicNam` is none of the component's `elements`, did you mean `topicName`?"),
    (of(params=[{"op": "read"}]), "n: params[0]: needs either `name` or `pattern`"),
    (of(params=[{"name": "~x", "default": {}}]), "n: params[0]: `default` must be a single value"),
]  # fmt: skip


@pytest.mark.parametrize(("data", "message"), WRONG, ids=lambda value: value[:40] if isinstance(value, str) else "")
def test_what_is_wrong_is_said(tmp_path: Path, data: Any, message: str) -> None:
    path = tmp_path / "p.json"
    path.write_text(json.dumps(data))
    assert str(read_library_file(path)) == f"{path}:1:1: {message}"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b'{"package":\n  oops}', "2:3: broken JSON: expecting value"),
        (b'"\xff"', "1:1: is not UTF-8"),
        (b"[" * 100_000, "1:1: is nested too deeply"),
        (b'{"package": NaN}', "1:1: broken JSON: NaN is no number of JSON"),
    ],
)
def test_files_that_are_no_json(tmp_path: Path, text: bytes, message: str) -> None:
    path = tmp_path / "p.json"
    path.write_bytes(text)
    assert str(read_library_file(path)) == f"{path}:{message}"


def test_names_that_only_a_launch_file_tells() -> None:
    relay = find("topic_tools", "relay")
    assert relay and [(p.kind, p.from_arg, p.name) for p in relay.ports] == [("subscriber", 1, None), ("publisher", 2, "{1}_relay")]
    ekf = find("robot_localization", "ekf_localization_node")
    assert ekf and ekf.made == "generated, completed by hand"
    patterns = {p.param_pattern: p.type for p in ekf.ports if p.param_pattern}
    assert patterns["~imu[0-9]+"] == "sensor_msgs/Imu" and patterns["~odom[0-9]+"] == "nav_msgs/Odometry"
    assert ("publisher", "odometry/filtered") in {(p.kind, p.name) for p in ekf.ports}


def test_plugins_are_found_without_a_package() -> None:
    debayer = find(None, "image_proc/debayer")
    assert debayer and debayer == find("image_proc", "image_proc/debayer")
    assert ("subscriber", "image_raw", "sensor_msgs/Image") in {(p.kind, p.name, p.type) for p in debayer.ports}
    assert find("image_proc", "image_proc/debayr") is None
