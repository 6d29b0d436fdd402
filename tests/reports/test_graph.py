"""The system graph in all its formats."""

from __future__ import annotations

import io
import json
import re
import shutil
import stat
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import networkx
import pytest
from jsonschema import Draft202012Validator
from systems import made, node, port, small, system

from rosarch.models.system.links import KINDS
from rosarch.models.system.view import Selection, View, build_view
from rosarch.reports import graph_dot, graph_graphml, graph_json, graph_mermaid
from rosarch.reports.graph_svg import DrawingError, svg_text

needs_graphviz = pytest.mark.skipif(shutil.which("dot") is None, reason="needs Graphviz")
HOSTILE = 'a"b\\n<i>&amp;]}\n\x1b%--> $(env X) \u202e'


def pair() -> View:
    """Two nodes, one of them without a model, on a topic; and a service that no one calls."""
    nodes = (
        node("/a", [port("publisher", "/x", "std_msgs/String", written="out"), port("service_server", "/go", "std_srvs/Empty")]),
        node("/b", [port("subscriber", "/x", "std_msgs/String")], conditions=("arg debug",)),
        node("/c", origin="unknown"),
    )
    return build_view(system(nodes), Selection())


def hostile() -> View:
    nodes = (
        node(f"/{HOSTILE}", [port("publisher", HOSTILE, HOSTILE, written=HOSTILE + "x")], package=HOSTILE, conditions=(HOSTILE,)),
        node("/b", [port("subscriber", HOSTILE, "T")]),
    )
    return build_view(system(nodes, name=HOSTILE, launch=(HOSTILE,)), Selection(group="package"))


def views() -> list[View]:
    options = (
        {},
        {"kinds": KINDS, "implicit": True},
        {"collapse": "namespace"},
        {"connectors": False},
        {"group": "package"},
        {"nodes": ("/x",)},
    )
    return [*(build_view(s, Selection(**o)) for s in (small(), made(30)) for o in options), pair(), hostile()]  # type: ignore[arg-type]


VIEWS = views()


def test_dot() -> None:
    lines = graph_dot.graph_text(pair(), ports=True).splitlines()
    assert lines[0] == 'digraph "robot" {'
    assert lines[5:] == [
        '  "node:/a" [label="/a", shape=ellipse, style="filled", color="#303030", fillcolor="#ffffff", tooltip="pkg/a"];',
        '  "node:/b" [label="/b\\nif arg debug", shape=ellipse, style="filled", color="#303030", fillcolor="#ffffff", tooltip="pkg/b"];',
        '  "node:/c" [label="/c", shape=ellipse, style="filled,dashed", color="#303030", fillcolor="#ffffff", tooltip="pkg/c, no model, may have more ports"];',
        '  "service:/go" [label="/go\\nstd_srvs/Empty", shape=hexagon, style="filled,dashed", color="#b03a2e", fillcolor="#e3eefb", tooltip="std_srvs/Empty"];',
        '  "topic:/x" [label="/x\\nstd_msgs/String", shape=box, style="filled", color="#404040", fillcolor="#f2f2f2", tooltip="std_msgs/String"];',
        '  "node:/a" -> "topic:/x" [color="#404040", tooltip="out", label="out", fontcolor="#404040"];',
        '  "service:/go" -> "node:/a" [color="#1f5fa8", tooltip="/go"];',
        '  "topic:/x" -> "node:/b" [color="#404040", tooltip="/x", style=dashed];',
        "}",
    ]
    legend = re.findall(r"<TD[^>]*>(?:<B>)?([^<]+)", lines[4])
    assert legend == ["robot", "node", "node without model", "topic", "service", "one side only"]
    assert "label=<" not in graph_dot.graph_text(pair(), with_legend=False)


def test_several_ports_on_one_edge() -> None:
    nodes = (node("/a", [port("publisher", "/x", "T", written=name) for name in ("b", "c")]), node("/d", [port("subscriber", "/x", "T")]))
    found = build_view(system(nodes), Selection())
    assert 'penwidth=1.5, label="2x", fontcolor' in graph_dot.graph_text(found)
    assert 'label="2x\\nb\\nc"' in graph_dot.graph_text(found, ports=True)
    assert '==>|"2x"| ' in graph_mermaid.graph_text(found)


def test_groups_in_boxes() -> None:
    found = build_view(small(), Selection(group="namespace"))
    dot = graph_dot.graph_text(found)
    box = dot[dot.index("subgraph") : dot.index("  }")]
    assert re.findall(r'^    "(\S+)" \[', box, re.MULTILINE) == ["node:/base/driver", "node:/base/odometry", "topic:/base/ticks"]
    mermaid = graph_mermaid.graph_text(found)
    assert re.findall(r'"([^"]+)"', mermaid[mermaid.index("subgraph") : mermaid.index("  end")]) == [
        "/base",
        "/base/driver",
        "/base/odometry",
        "/base/ticks",
    ]


def test_what_is_merged_is_named() -> None:
    nodes = (
        node("/a", [port("publisher", f"/t{number}", "T") for number in range(6)]),
        node("/b", [port("subscriber", f"/t{number}", "T") for number in range(6)]),
    )
    assert 'label="6 topics\\n/t0\\n/t1\\n/t2\\n..."' in graph_dot.graph_text(
        build_view(system(nodes), Selection(collapse="package", packages=("*",), nodes=("/a",)))
    )
    between = graph_dot.graph_text(build_view(system(nodes), Selection(connectors=False)))
    assert 'tooltip="/t0, /t1, /t2, /t3, /t4, /t5"' in between
    assert 'label="6 topics"' in between


def test_what_is_not_shown_is_told() -> None:
    assert "not shown: 2 implicit, 1 of transforms" in graph_dot.graph_text(build_view(small(), Selection()))
    assert "not shown: 2 implicit, 1 service, 1 of transforms" in graph_mermaid.graph_text(
        build_view(small(), Selection(kinds=("topic", "action")))
    )


@needs_graphviz
@pytest.mark.parametrize("view", VIEWS, ids=range(len(VIEWS)))
def test_graphviz_reads_it(view: View) -> None:
    for ports in (False, True):
        text = graph_dot.graph_text(view, ports=ports)
        done = subprocess.run(["dot", "-Tjson0"], input=text, capture_output=True, text=True, check=True, timeout=60)
        assert done.stderr == ""
        read = json.loads(done.stdout)
        clusters = {node.group for node in view.nodes} - {None}
        assert len(read.get("objects", ())) - len(clusters) == len(view.nodes) + len(view.connectors)
        assert sum(1 for edge in read.get("edges", ()) if edge.get("style") != "invis") == len(view.edges)


def test_mermaid() -> None:
    assert graph_mermaid.graph_text(pair()).splitlines()[:25] == [
        "---",
        'title: "robot"',
        "---",
        "flowchart LR",
        '  n0(["/a"]):::node',
        '  n1(["/b<br/>if arg debug"]):::node',
        '  n2(["/c"]):::unknown',
        '  n3{{"/go"}}:::service_one_sided',
        '  n4["/x"]:::topic',
        "  n0 --> n4",
        "  n3 --> n0",
        "  n4 -.-> n1",
        "  linkStyle 0,2 stroke:#404040",
        "  linkStyle 1 stroke:#1f5fa8",
        '  subgraph legend["legend"]',
        '    l0(["node"])',
        "    style l0 fill:#ffffff,stroke:#303030",
        '    l1(["node without model"])',
        "    style l1 fill:#ffffff,stroke:#303030,stroke-dasharray:4",
        '    l2["topic"]',
        "    style l2 fill:#f2f2f2,stroke:#404040",
        '    l3["service"]',
        "    style l3 fill:#e3eefb,stroke:#1f5fa8",
        '    l4["one side only"]',
        "    style l4 fill:#ffffff,stroke:#b03a2e,stroke-dasharray:4",
    ]


def test_mermaid_escapes_what_means_something() -> None:
    text = graph_mermaid.graph_text(hostile(), ports=True)
    labels = re.findall(r'"([^"]*)"', text)
    assert all(re.fullmatch(r"(?:[\w\s.,/~!=&()+*?:-]|#\d+;|<br/>)*", label) for label in labels)
    assert not re.search(r"[\x1b\u202e]", text)
    assert text.count('"') == 2 * len(labels)


@pytest.mark.parametrize("view", VIEWS, ids=range(len(VIEWS)))
def test_graphml_is_read_by_networkx(view: View) -> None:
    graph = networkx.read_graphml(io.BytesIO(graph_graphml.graph_text(view).encode()), force_multigraph=True)
    assert graph.is_directed()
    assert (graph.number_of_nodes(), graph.number_of_edges()) == (len(view.nodes) + len(view.connectors), len(view.edges))


def test_graphml_values() -> None:
    graph = networkx.read_graphml(io.BytesIO(graph_graphml.graph_text(pair()).encode()))
    assert graph.nodes["n0"] == {"label": "/a", "kind": "node", "package": "pkg", "type": "a", "origin": "source", "open": False}
    assert graph.nodes["n1"]["condition"] == "arg debug"
    assert graph.nodes["n3"] == {"label": "/go", "kind": "service", "type": "std_srvs/Empty", "one_sided": True}
    assert graph.edges["n0", "n4"] == {"label": "out", "kind": "topic", "count": 1, "conditional": False, "id": "e0"}


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(graph_json.graph_schema())


@pytest.mark.parametrize("view", VIEWS, ids=range(len(VIEWS)))
def test_json_follows_its_schema(view: View) -> None:
    (data,) = json.loads(graph_json.graphs_text([view]))
    Draft202012Validator(graph_json.graph_schema()).validate(data)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("nodes", 0, "origin"), "elsewhere"),
        (("edges", 0, "count"), 0),
        (("edges", 0, "kind"), "wire"),
        (("more",), 1),
        (("connectors", 0, "names"), []),
    ],
)
def test_the_schema_refuses_what_is_wrong(path: tuple[str | int, ...], value: object) -> None:
    data = graph_json.graph_data(pair())
    inner: object = data
    for key in path[:-1]:
        inner = inner[key]  # type: ignore[index]
    inner[path[-1]] = value  # type: ignore[index]
    assert not Draft202012Validator(graph_json.graph_schema()).is_valid(data)


def test_json_values() -> None:
    data = graph_json.graph_data(build_view(small(), Selection(nodes=("/base/driver",), collapse=None)))
    assert (data["system"], data["launch"], data["hidden"]) == ("robot", ["launch/robot.launch"], {"implicit": 1})
    assert data["nodes"] == [
        {
            "id": "node:/base/driver", "name": "/base/driver", "package": "base_driver", "type": "driver", "origin": "source",
            "component": "base_driver/driver", "open": False, "conditions": [], "lines": ["launch/robot.launch:3", "launch/base.launch:4"],
            "group": None, "members": [],
        }
    ]  # fmt: skip
    assert data["connectors"][0] == {
        "id": "service:/base/reset", "kind": "service", "names": ["/base/reset"], "types": ["std_srvs/Trigger"], "one_sided": False, "group": None,
    }  # fmt: skip
    assert data["edges"][0] == {
        "source": "node:/base/driver", "target": "topic:/base/ticks", "kind": "topic", "count": 1, "ports": ["ticks"], "names": [], "conditional": False,
    }  # fmt: skip


@needs_graphviz
@pytest.mark.parametrize("view", [pair(), hostile()], ids=["pair", "hostile"])
def test_svg(view: View) -> None:
    root = ElementTree.fromstring(svg_text(graph_dot.graph_text(view, ports=True)))
    kinds = [group.get("class") for group in root.iter("{http://www.w3.org/2000/svg}g")]
    assert (kinds.count("node"), kinds.count("edge")) == (len(view.nodes) + len(view.connectors), len(view.edges))


def program(folder: Path, text: str) -> Path:
    path = folder / "dot"
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def test_without_graphviz(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(DrawingError) as caught:
        svg_text("digraph {}")
    assert str(caught.value) == "SVG needs Graphviz: there is no `dot` on PATH; the formats dot and mermaid need no installation"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("echo first >&2; echo second >&2; exit 3", "Graphviz could not draw this: first"),
        ("exit 3", "Graphviz could not draw this: exit code 3"),
        ("exec /bin/sleep 9", "Graphviz did not finish within 0.2 s; show less of the system, or merge the nodes of each namespace"),
    ],
)
def test_a_graphviz_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, message: str) -> None:
    program(tmp_path, text)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(DrawingError) as caught:
        svg_text("digraph {}", seconds=0.2)
    assert str(caught.value) == message
