"""Generated components, what is laid over them by hand, and the order of folders."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.library import LibraryComponent, find, load


def write(folder: Path, made: str, *components: dict[str, Any], name: str = "demo.json", **fields: Any) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    head = {"package": "demo", "origin": f"https://{folder.name}", "revision": "1", "made": made, **fields}
    (folder / name).write_text(json.dumps({**head, "components": components}))
    return folder


def node(**fields: Any) -> dict[str, Any]:
    return {"component": "n", "kind": "node", **fields}


def publisher(name: str, **fields: Any) -> dict[str, Any]:
    return {"kind": "publisher", "name": name, **fields}


def ports(component: LibraryComponent | None) -> list[tuple[str | None, str | None]]:
    assert component
    return [(port.name, port.type) for port in component.ports]


@pytest.mark.slow
def test_by_hand_is_laid_over_generated(tmp_path: Path) -> None:
    base = node(
        node_name="base", open=True, ports=[publisher("a", type="x/A"), publisher("b", type="x/B")], params=[{"name": "~p", "default": 1}]
    )
    overlay = node(
        open=False, ports=[publisher("b", type="x/C"), publisher("c")], params=[{"name": "~p", "default": 2}, {"pattern": "~q.*"}]
    )
    folder = write(tmp_path / "own", "generated", base)
    write(folder, "by hand", overlay, name="more.json")
    found = find("demo", "n", [folder])
    assert ports(found) == [("a", "x/A"), ("b", "x/C"), ("c", None)]
    assert found and (found.node_name, found.open, found.made) == ("base", False, "generated, completed by hand")
    assert found.path == folder / "demo.json"
    assert [(p.name, p.pattern, p.default) for p in found.params] == [("~p", None, 2), (None, "~q.*", None)]


def test_replace_leaves_nothing_of_the_base(tmp_path: Path) -> None:
    folder = write(tmp_path / "own", "generated", node(node_name="base", ports=[publisher("a")]))
    write(folder, "by hand", node(replace=True, ports=[publisher("b")]), name="more.json")
    found = find("demo", "n", [folder])
    assert ports(found) == [("b", None)]
    assert found and (found.node_name, found.made, found.path) == (None, "by hand", folder / "more.json")


def test_each_version_of_ros_has_its_own(tmp_path: Path) -> None:
    folder = write(tmp_path / "own", "generated", node(ports=[publisher("a")]), ros=[1])
    write(folder, "generated", node(ports=[publisher("b")]), name="second.json", ros=[2])
    write(folder, "by hand", node(ports=[publisher("both")]), name="more.json")
    library = load([folder])
    assert [(found.ros, ports(found)) for found in library.components if found.package == "demo"] == [
        ((1,), [("a", None), ("both", None)]),
        ((2,), [("b", None), ("both", None)]),
    ]
    assert ports(library.find("demo", "n", 2)) == ports(library.find(None, "n", 2)) == [("b", None), ("both", None)]
    assert ports(library.find("demo", "n")) == ports(library.find("demo", "n", 1)) == [("a", None), ("both", None)]


def test_earlier_folders_come_first(tmp_path: Path) -> None:
    first = write(tmp_path / "first", "generated", node(ports=[publisher("a", type="x/First")]))
    second = write(tmp_path / "second", "generated", node(ports=[publisher("a", type="x/Second"), publisher("b")]))
    assert ports(find("demo", "n", [first, second])) == [("a", "x/First")]
    write(first, "by hand", node(ports=[publisher("c", type="x/First")]), name="more.json")
    write(second, "by hand", node(ports=[publisher("c", type="x/Second")]), name="more.json")
    assert ports(find("demo", "n", [second, first])) == [("a", "x/Second"), ("b", None), ("c", "x/Second")]


def test_users_come_before_what_is_shipped(tmp_path: Path) -> None:
    own = {"component": "joy_node", "kind": "node", "ports": [publisher("sticks", type="x/Sticks")]}
    folder = write(tmp_path / "own", "generated", own, name="joy.json", package="joy")
    assert ports(find("joy", "joy_node", [folder])) == [("sticks", "x/Sticks")]
    assert ("joy", "sensor_msgs/Joy") in ports(find("joy", "joy_node"))


def test_one_bad_file_costs_that_file(tmp_path: Path) -> None:
    folder = write(tmp_path / "own", "by hand", node(ports=[publisher("a")]))
    (folder / "bad.json").write_text("{")
    library = load([folder])
    assert [str(problem) for problem in library.problems] == [
        f"{folder / 'bad.json'}:1:2: broken JSON: expecting property name enclosed in double quotes"
    ]
    assert ports(library.find("demo", "n")) == [("a", None)]
    assert library.find("joy", "joy_node")


def test_what_may_be_more(tmp_path: Path) -> None:
    opened = {"a": True, "b": False, "c": "ports", "d": "params"}
    folder = write(tmp_path / "own", "by hand", *({"component": name, "kind": "node", "open": value} for name, value in opened.items()))
    found = {name: find("demo", name, [folder]) for name in opened}
    assert {name: (c.open, c.open_ports, c.open_params) for name, c in found.items() if c} == {
        "a": (True, True, True),
        "b": (False, False, False),
        "c": (True, True, False),
        "d": (True, False, True),
    }


def test_the_document_keeps_what_is_said(tmp_path: Path) -> None:
    component = node(
        loads=["demo/other"],
        ports=[publisher("a", queue=0), {"kind": "subscriber", "from_arg": 1}],
        params=[{"name": "~p", "default": False}, {"pattern": "~q.*"}],
    )
    found = find("demo", "n", [write(tmp_path / "own", "by hand", component)])
    assert found
    document = found.document()
    assert document["loads"] == ["demo/other"]
    assert document["ports"] == [
        {"id": "p1", "kind": "publisher", "name": "a", "via": "plain", "queue": 0},
        {"id": "p2", "kind": "subscriber", "name": "?", "via": "plain", "from_arg": 1},
    ]
    assert document["params"] == [{"name": "~p", "op": "read", "default": False}, {"name": "?", "op": "read", "pattern": "~q.*"}]


def test_what_is_loaded_comes_along(tmp_path: Path) -> None:
    loaded = [{"component": f"demo/{name}", "kind": "nodelet", "loads": [f"demo/{name}", "demo/b", "demo/none"]} for name in "ab"]
    library = load([write(tmp_path / "own", "by hand", node(loads=["demo/a"]), *loaded)])
    found = library.find("demo", "n")
    assert found and [component.component for component in library.with_loaded(found)] == ["n", "demo/a", "demo/b"]


def test_what_has_no_name_goes_by_what_tells_it(tmp_path: Path) -> None:
    imus, odometry = ({"kind": "subscriber", "param_pattern": f"~{name}[0-9]+"} for name in ("imu", "odom"))
    lower = write(tmp_path / "lower", "by hand", node(ports=[imus, odometry], params=[{"pattern": "~a.*"}, {"pattern": "~b.*"}]))
    upper = write(tmp_path / "upper", "by hand", node(ports=[{**imus, "type": "x/Imu"}], params=[{"pattern": "~a.*", "type": "int"}]))
    found = find("demo", "n", [upper, lower])
    assert found and [(port.param_pattern, port.type) for port in found.ports] == [("~odom[0-9]+", None), ("~imu[0-9]+", "x/Imu")]
    assert [(parameter.pattern, parameter.type) for parameter in found.params] == [("~b.*", None), ("~a.*", "int")]


@pytest.mark.slow
def test_nodes_that_others_make(tmp_path: Path, rosarch: Callable) -> None:
    costmap = {
        "component": "costmap",
        "kind": "node",
        "ports": [
            publisher("grid"),
            {"kind": "service_server", "name": "clear_{node}"},
            {"kind": "subscriber", "param_pattern": "~[^.]+[.]topic"},
        ],
    }
    host = node(makes={"local/costmap": "demo/costmap"}, ports=[publisher("cmd_vel")])
    library = write(tmp_path / "own", "by hand", host, costmap, ros=[2])
    package = tmp_path / "ws" / "here"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>here</name></package>")
    (package / "main.launch.xml").write_text(
        '<launch><node pkg="demo" exec="n" name="host" namespace="arm"><param from="$(dirname)/p.yaml"/></node></launch>'
    )
    (package / "p.yaml").write_text("/arm/local/costmap:\n  ros__parameters:\n    scan: {topic: /scan}\n")
    graph = ("show", "graph", tmp_path / "ws", "--launch", "here/main.launch.xml", "--format", "json", "--library", library)
    (found,) = json.loads(rosarch(*graph).out)
    assert sorted(node["name"] for node in found["nodes"]) == ["/arm/host", "/arm/local/costmap"]
    assert sorted((edge["source"], edge["target"]) for edge in found["edges"]) == [
        ("node:/arm/host", "topic:/arm/cmd_vel"),
        ("node:/arm/local/costmap", "topic:/arm/local/grid"),
        ("service:/arm/local/clear_costmap", "node:/arm/local/costmap"),
        ("topic:/scan", "node:/arm/local/costmap"),
    ]


def test_what_is_made_must_be_a_component(tmp_path: Path) -> None:
    folder = write(tmp_path / "own", "by hand", node(makes={"a": "costmap"}))
    assert [problem.message for problem in load([folder]).problems] == [
        "components[0]: `makes` must map names of nodes to `PACKAGE/COMPONENT`"
    ]
