"""What of a system is drawn."""

from __future__ import annotations

import pytest
from systems import made, node, port, small, system

from rosarch.models.system.links import KINDS
from rosarch.models.system.view import Selection, UnknownName, View, build_view


def shown(view: View) -> tuple[set[str], set[str]]:
    return {n.name for n in view.nodes}, {name for connector in view.connectors for name in connector.names}


def arrows(view: View) -> set[str]:
    return {f"{edge.source} > {edge.target}" for edge in view.edges}


def view(**options: object) -> View:
    return build_view(small(), Selection(**options))  # type: ignore[arg-type]


def test_all_but_implicit_ones_and_transforms() -> None:
    found = view()
    assert shown(found) == (
        {"/base/driver", "/base/odometry", "/planner", "/mission", "/viewer"},
        {"/base/ticks", "/cmd_vel", "/odom", "/plan", "/base/reset", "/battery"},
    )
    assert found.hidden == {"implicit": 2, "tf": 1}


def test_calls_lead_to_the_server() -> None:
    assert {"node:/mission > service:/base/reset", "service:/base/reset > node:/base/driver"} <= arrows(view())
    assert {"node:/mission > action:/plan", "action:/plan > node:/planner"} <= arrows(view())


def test_everything() -> None:
    found = view(implicit=True, kinds=KINDS)
    assert {"/tf", "/plan/status", "/diagnostics"} < shown(found)[1]
    assert {c.id: c.kind for c in found.connectors}["tf:/tf"] == "tf"
    assert found.hidden == {}


def test_an_implicit_topic_that_someone_asks_for_is_shown() -> None:
    nodes = (
        node("/a", [port("publisher", "/plan/status", "T", implicit=True)]),
        node("/b", [port("subscriber", "/plan/status", "T")]),
    )
    assert shown(build_view(system(nodes), Selection()))[1] == {"/plan/status"}


@pytest.mark.parametrize(
    ("options", "nodes"),
    [
        ({"nodes": ("/base/*",)}, {"/base/driver", "/base/odometry"}),
        ({"nodes": ("/planner", "/m*")}, {"/planner", "/mission"}),
        ({"exclude": ("/base/*", "*er")}, {"/mission"}),
        ({"namespaces": ("base",)}, {"/base/driver", "/base/odometry"}),
        ({"namespaces": ("/",)}, {"/base/driver", "/base/odometry", "/planner", "/mission", "/viewer"}),
        ({"packages": ("base_*",)}, {"/base/driver", "/base/odometry"}),
        ({"packages": ("other",)}, {"/viewer"}),
    ],
)
def test_chosen_nodes(options: dict[str, tuple[str, ...]], nodes: set[str]) -> None:
    assert shown(view(**options))[0] == nodes


@pytest.mark.parametrize(
    ("options", "connectors"),
    [
        ({"names": ("/base/*",)}, {"/base/ticks", "/base/reset"}),
        ({"exclude": ("/base/ticks", "/od*")}, {"/cmd_vel", "/plan", "/base/reset", "/battery"}),
        ({"kinds": ("service",)}, {"/base/reset"}),
        ({"leaves": False}, {"/base/ticks", "/cmd_vel", "/odom", "/plan", "/base/reset"}),
    ],
)
def test_chosen_connectors(options: dict[str, tuple[str, ...]], connectors: set[str]) -> None:
    assert shown(view(**options))[1] == connectors


def test_the_other_side_may_be_out_of_sight() -> None:
    found = {c.names[0]: c.one_sided for c in view(nodes=("/mission",)).connectors}
    assert found == {"/plan": False, "/base/reset": False, "/battery": True}


def test_leaves_are_those_of_what_is_seen() -> None:
    found = view(nodes=("/base/*",), leaves=False)
    assert shown(found)[1] == {"/base/ticks"}
    assert found.hidden["one-sided"] == 3


@pytest.mark.parametrize(
    ("focus", "hops", "nodes", "connectors"),
    [
        ("/mission", 0, {"/mission"}, {"/plan", "/base/reset", "/battery"}),
        ("mission", 1, {"/mission", "/planner", "/base/driver"}, {"/plan", "/base/reset", "/battery", "/cmd_vel"}),
        ("*mission", 2, {"/mission", "/planner", "/base/driver", "/base/odometry"}, {"/plan", "/base/reset", "/battery", "/cmd_vel", "/odom", "/base/ticks"}),
        ("/viewer", 3, {"/viewer"}, set()),
    ],
)  # fmt: skip
def test_focus(focus: str, hops: int, nodes: set[str], connectors: set[str]) -> None:
    assert shown(view(focus=(focus,), hops=hops)) == (nodes, connectors)


def test_an_unknown_focus() -> None:
    with pytest.raises(UnknownName, match="missing") as caught:
        view(focus=("missing",))
    assert caught.value.candidates == {"/base/driver", "/base/odometry", "/planner", "/mission", "/viewer"}


def test_a_namespace_as_one_node() -> None:
    found = view(collapse="namespace")
    (base,) = (n for n in found.nodes if n.members)
    assert (base.id, base.name, base.members, base.origin) == ("namespace:/base", "/base", ("/base/driver", "/base/odometry"), "source")
    assert shown(found)[1] == {"/cmd_vel", "/odom", "/plan", "/base/reset", "/battery"}
    assert found.hidden["inside"] == 1
    assert "namespace:/base > topic:/odom" in arrows(found)


def test_packages_as_nodes_with_what_is_between_them_counted() -> None:
    nodes = (
        node("/a", [port("publisher", "/x", "T"), port("publisher", "/y", "T")], package="one"),
        node("/b", [port("publisher", "/x", "T")], package="one", origin="unknown"),
        node("/c", [port("subscriber", "/x", "U"), port("subscriber", "/y", "T", conditional="debug")], package="two"),
    )
    found = build_view(system(nodes), Selection(collapse="package"))
    assert [(n.id, n.package, n.origin, n.open) for n in found.nodes] == [
        ("package:one", "one", "mixed", True),
        ("package:two", "two", "source", False),
    ]
    assert [(c.names, c.types) for c in found.connectors] == [(("/x", "/y"), ("T", "U"))]
    assert [(e.source, e.target, e.count, e.conditional) for e in found.edges] == [
        ("package:one", "topic:/x", 3, False),
        ("topic:/x", "package:two", 2, False),
    ]


def test_from_node_to_node() -> None:
    found = view(connectors=False)
    assert found.connectors == ()
    assert {(e.source, e.target, e.kind, e.names, e.conditional) for e in found.edges} == {
        ("node:/base/driver", "node:/base/odometry", "topic", ("/base/ticks",), False),
        ("node:/base/odometry", "node:/planner", "topic", ("/odom",), False),
        ("node:/planner", "node:/base/driver", "topic", ("/cmd_vel",), False),
        ("node:/mission", "node:/planner", "action", ("/plan",), True),
        ("node:/mission", "node:/base/driver", "service", ("/base/reset",), True),
    }


def test_no_arrow_from_a_group_to_itself() -> None:
    nodes = [node(f"/n/{name}", [port("publisher", "/x", "T"), port("subscriber", "/x", "T")]) for name in "ab"]
    nodes.append(node("/c", [port("subscriber", "/x", "T")]))
    assert arrows(build_view(system(nodes), Selection(collapse="namespace", connectors=False))) == {"namespace:/n > node:/c"}
    assert "node:/n/a > node:/n/a" in arrows(build_view(system(nodes), Selection(connectors=False)))


def test_nodes_that_share_a_name() -> None:
    nodes = [node("/a", [port("publisher", "/x", "T")], id_=id_) for id_ in ("s1", "s2")]
    assert arrows(build_view(system(nodes), Selection())) == {"node:/a > topic:/x", "node:/a#2 > topic:/x"}


def test_groups() -> None:
    nodes = [
        node("/a/b/c", [port("publisher", "/x", "T"), port("publisher", "/y", "T")]),
        node("/a/b/d", [port("subscriber", "/x", "T")]),
        node("/e", [port("subscriber", "/y", "T")]),
    ]
    for depth, group in ((1, "/a"), (2, "/a/b"), (9, "/a/b")):
        found = build_view(system(nodes), Selection(group="namespace", depth=depth))
        assert {n.name: n.group for n in found.nodes} == {"/a/b/c": group, "/a/b/d": group, "/e": None}
        assert {c.names: c.group for c in found.connectors} == {("/x",): group, ("/y",): None}


@pytest.mark.parametrize("size", [1, 50, 300])
@pytest.mark.parametrize("options", [{}, {"collapse": "namespace"}, {"collapse": "package", "connectors": False}, {"focus": ("*node0",)}])
def test_edges_lead_from_and_to_what_is_there(size: int, options: dict[str, object]) -> None:
    found = build_view(made(size), Selection(implicit=True, kinds=KINDS, **options))  # type: ignore[arg-type]
    ids = [item.id for item in (*found.nodes, *found.connectors)]
    assert len(ids) == len(set(ids))
    assert {end for edge in found.edges for end in (edge.source, edge.target)} <= set(ids)
    assert len({(edge.source, edge.target, edge.kind) for edge in found.edges}) == len(found.edges)
    assert found == build_view(made(size), Selection(implicit=True, kinds=KINDS, **options))  # type: ignore[arg-type]
