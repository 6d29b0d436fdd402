"""The component model, made from hand-written relations."""

from __future__ import annotations

import json
import random
from collections.abc import Iterable
from typing import Any

import pytest

from rosarch.models.component import ComponentModel, build_model, build_models, distinct, to_json

NAMES = (
    "port", "port_type", "port_parameter", "port_in_namespace", "port_callback", "port_handler", "port_queue", "port_latched", "port_quality", "port_unknown", "port_made_through", "port_made_for", "port_via",
    "implicit_port", "implicit_port_callback", "node_location",
    "function_display", "lambda_within", "parameter_access", "parameter_access_default", "parameter_access_type",
    "reconfigure_parameter", "node_name", "node_element", "port_of_other_node", "unseen", "port_unreached", "component_middleware", "managed_node",
    "reacts", "always_reacts", "periodic", "period", "period_for_sink", "sends_periodically", "state_variable", "configuration_variable",
    "transition", "done_for_others", "initial_value", "assignment_parts", "activity", "activity_part", "activity_enters", "guard_step",
    "loop_condition", "silent_condition", "switch_case",
    "node_block", "node_text", "node_value", "variable_display", "reacts_deferred", "constant_node", "stable_condition",
    "settled_local", "named_number", "timer_callback", "sends_once", "always_sends_once",
    "component_plugin", "component_executable", "plugin_load", "plugin_load_any",
    "plugin_argument", "inner_node", "inner_namespace", "inner_given", "tree_file", "tree_host", "own_name_call", "own_namespace_call", "asks_command_line", "plugin_asked", "plugin_result", "decided_in",
    "switched", "switches", "at_times", "in_transition", "sent_while_starting",
    "round_of_loop", "undecided_by_texts",
)  # fmt: skip
FIELDS = [
    "system",
    "component",
    "package",
    "kind",
    "middleware",
    "node_name",
    "sources",
    "ports",
    "params",
    "periodic",
    "reactive",
    "state_variables",
    "configuration",
    "transitions",
    "reactive_deferred",
    "one_shot",
    "open",
]
PORT_FIELDS = ["id", "kind", "name", "from_param", "type", "queue", "latched", "callback", "via", "at", "conditional"]

OUT = ("c1", "publisher", "out")
IN = ("c2", "subscriber", "in")
RELATIONS: dict[str, list[tuple[Any, ...]]] = {
    "port": [(IN,), (OUT,)],
    "port_type": [(OUT, "std_msgs/Bool"), (IN, "std_msgs/Empty")],
    "port_parameter": [(OUT, "~topic")],
    "port_callback": [(IN, "N::on_in@n.cpp:3")],
    "port_handler": [(IN, "N::on_in@n.cpp:3")],
    "port_queue": [(OUT, "10")],
    "port_latched": [(OUT,)],
    "port_via": [(OUT, "plain"), (IN, "plain")],
    "node_location": [("c1", "pkg/n.cpp", 7, 3), ("c2", "pkg/n.cpp", 8, 3), ("c3", "pkg/n.cpp", 9, 3)],
    "function_display": [("N::on_in@n.cpp:3", "ns::N", "ns::N::on_in")],
    "parameter_access": [("c3", "read", "~topic")],
    "parameter_access_default": [("c3", "~topic", "out")],
    "parameter_access_type": [("c3", "~topic", "std::basic_string<char>")],
    "node_name": [("driver",)],
}


def model(**relations: Iterable[tuple[Any, ...]]) -> ComponentModel:
    return build_model("sys", "n", "pkg", "node", ("pkg/n.cpp",), {name: relations.get(name, ()) for name in NAMES})


def place(*sites: str) -> list[tuple[Any, ...]]:
    return [(site, "pkg/n.cpp", 10 + index, 1) for index, site in enumerate(sites)]


def test_the_whole_document() -> None:
    assert to_json(model(**RELATIONS)) == {
        "system": "sys", "component": "n", "package": "pkg", "kind": "node", "middleware": None, "node_name": "driver", "sources": ["pkg/n.cpp"],
        "ports": [
            {"id": "p1", "kind": "publisher", "name": "out", "from_param": "~topic", "type": "std_msgs/Bool", "queue": 10, "latched": True, "callback": None, "via": "plain", "at": "pkg/n.cpp:7", "conditional": None},
            {"id": "p2", "kind": "subscriber", "name": "in", "from_param": None, "type": "std_msgs/Empty", "queue": None, "latched": False, "callback": "N::on_in", "via": "plain", "at": "pkg/n.cpp:8", "conditional": None},
        ],
        "params": [{"name": "~topic", "op": "read", "type": "string", "default": "out", "at": "pkg/n.cpp:9"}],
        "periodic": [], "reactive": [], "state_variables": [], "configuration": [], "transitions": [], "reactive_deferred": [], "one_shot": [], "open": [],
    }  # fmt: skip


def test_the_order_of_fields() -> None:
    document = to_json(model(**RELATIONS))
    assert list(document) == FIELDS
    assert [list(port) for port in document["ports"]] == [PORT_FIELDS, PORT_FIELDS]
    assert list(document["params"][0]) == ["name", "op", "type", "default", "at"]


def test_an_empty_component_has_all_fields() -> None:
    document = to_json(model())
    assert list(document) == FIELDS
    assert (document["ports"], document["params"], document["node_name"]) == ([], [], None)
    assert json.loads(json.dumps(document)) == document


@pytest.mark.parametrize("seed", range(5))
def test_the_order_of_rows_changes_nothing(seed: int) -> None:
    relations = {
        **RELATIONS, "port_type": [*RELATIONS["port_type"], (OUT, "a/Other"), (OUT, "z/Last")], "node_name": [("driver",), ("another",)],
        "parameter_access_default": [("c3", "~topic", "out"), ("c3", "~topic", "5"), ("c3", "~topic", "image")],
    }  # fmt: skip
    shuffled = {name: random.Random(seed).sample(rows, len(rows)) for name, rows in relations.items()}
    assert to_json(model(**shuffled)) == to_json(model(**relations))


def test_of_several_types_none_is_known() -> None:
    found = model(**{**RELATIONS, "port_type": [*RELATIONS["port_type"], (OUT, "a/Other")]})
    assert {port.kind: port.type for port in found.ports if port.kind in ("publisher", "subscriber")} == {
        "publisher": None,
        "subscriber": "std_msgs/Empty",
    }


def test_ids_follow_the_source() -> None:
    sites = place("c3", "c1", "c2")
    found = model(port=[((site, "publisher", site),) for site in ("c1", "c2", "c3")], node_location=sites)
    assert [(port.id, port.name) for port in found.ports] == [("p1", "c3"), ("p2", "c1"), ("p3", "c2")]


def test_ids_count_on_over_names_of_one_call_and_implicit_ports() -> None:
    ports = [(("c1", "publisher", name),) for name in ("b", "a")]
    implicit = [(("c1", "publisher", "a/status"), "x/Status"), (("c1", "subscriber", "a/goal"), "x/Goal")]
    found = model(port=ports, implicit_port=implicit, node_location=place("c1"))
    assert [(port.id, port.name, port.implicit) for port in found.ports] == [
        ("p1", "a", False),
        ("p2", "b", False),
        ("p3", "a/status", True),
        ("p4", "a/goal", True),
    ]


def test_qualities_that_are_told() -> None:
    rows = [
        (OUT, "reliability", "reliable"),
        (OUT, "durability", "volatile"),
        (OUT, "durability", "transient_local"),
        (OUT, "history", "keep_last"),
        (OUT, "deadline", "(250)/(1000.0)"),
        (OUT, "lifespan", "unknown"),
    ]
    document = to_json(model(**RELATIONS, port_quality=rows))
    told = {"deadline": "0.25", "history": "keep_last", "lifespan": "unknown", "reliability": "reliable"}
    assert [port.get("qos") for port in document["ports"]] == [told, None]


def test_the_middleware_and_managed_nodes() -> None:
    document = to_json(model(component_middleware=[("ROS 2",)], managed_node=[("c1",)]))
    assert (document["middleware"], document["kind"]) == ("ROS 2", "lifecycle_node")
    assert to_json(model(component_middleware=[("ROS 2",), ("ROS 1",)]))["middleware"] == "ROS 1 and ROS 2"


def test_implicit_and_unknown_ports_are_marked() -> None:
    hole = ("c1", "publisher", "?")
    document = to_json(
        model(
            port=[(hole,)],
            port_unknown=[(hole, "named by parameter ~topic")],
            implicit_port=[(("c1", "publisher", "x/status"), "x/Status")],
            node_location=place("c1"),
        )
    )
    unknown, implicit = document["ports"]
    assert (unknown["name"], unknown["unknown"]) == ("?", "named by parameter ~topic")
    assert "implicit" not in unknown
    assert (implicit["implicit"], implicit["type"]) == (True, "x/Status")
    assert "unknown" not in implicit


@pytest.mark.parametrize(
    ("via", "function", "display", "callback", "shown"),
    [
        ("plain", "free@n.cpp:1", ("", "ns::free"), "free", "plain"),
        ("plain", "N::m@n.cpp:1", ("a::b::N", "a::b::N::m"), "N::m", "plain"),
        ("lambda", "lambda@n.cpp:1:2", ("", "lambda"), "lambda", "lambda"),
        ("lambda", "lambda@n.cpp:1:2", ("", "N::m"), "m", "lambda"),
        ("message_filters", "lambda@n.cpp:1:2", ("", "lambda"), "lambda", "message_filters"),
    ],
)
def test_callbacks(via: str, function: str, display: tuple[str, str], callback: str, shown: str) -> None:
    (port,) = model(
        port=[(IN,)],
        port_callback=[(IN, function)],
        port_handler=[(IN, function)],
        function_display=[(function, *display)],
        port_via=[(IN, via)],
        node_location=place("c2"),
    ).ports
    assert (port.callback, port.via) == (callback, shown)


def test_a_callback_without_a_name_is_told_by_the_function_that_it_is_written_in() -> None:
    (port,) = model(
        port=[(IN,)],
        port_handler=[(IN, "lambda@n.cpp:1:2")],
        function_display=[("lambda@n.cpp:1:2", "", "lambda"), ("N::N@n.cpp:1", "ns::N", "ns::N::N")],
        lambda_within=[("lambda@n.cpp:1:2", "N::N@n.cpp:1")],
        node_location=place("c2"),
    ).ports
    assert port.callback == "lambda in N::N"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", True),
        ("false", False),
        ("5", 5),
        ("-5", -5),
        ("2.5", 2.5),
        ("1e3", 1000.0),
        ("image", "image"),
        ("", ""),
        ("5m", "5m"),
        ("[0.5, a]", [0.5, "a"]),
        ("[]", []),
    ],
)
def test_defaults_are_typed(text: str, value: object) -> None:
    (parameter,) = to_json(
        model(parameter_access=[("c1", "read", "p")], parameter_access_default=[("c1", "p", text)], node_location=place("c1"))
    )["params"]
    assert parameter["default"] == value
    assert type(parameter["default"]) is type(value)


@pytest.mark.parametrize("text", ["nan", "inf", "-inf", "infinity"])
def test_a_default_is_valid_json(text: str) -> None:
    (parameter,) = to_json(
        model(parameter_access=[("c1", "read", "p")], parameter_access_default=[("c1", "p", text)], node_location=place("c1"))
    )["params"]
    assert json.loads(json.dumps(parameter, allow_nan=False))["default"] == text


@pytest.mark.parametrize("text", ["1_000", "٣", " 5 "])
def test_a_text_that_only_python_takes_for_a_number_stays_text(text: str) -> None:
    (parameter,) = to_json(
        model(parameter_access=[("c1", "read", "p")], parameter_access_default=[("c1", "p", text)], node_location=place("c1"))
    )["params"]
    assert parameter["default"] == text


@pytest.mark.parametrize("text", ["007", "1.50", "true"])
def test_a_string_parameter_keeps_its_text(text: str) -> None:
    """A default of a string parameter that looks like a number is still a string."""
    access = {
        "parameter_access": [("c1", "read", "p")],
        "parameter_access_default": [("c1", "p", text)],
        "parameter_access_type": [("c1", "p", "std::basic_string<char>")],
    }
    (parameter,) = to_json(model(**access, node_location=place("c1")))["params"]
    assert (parameter["type"], parameter["default"]) == ("string", text)


@pytest.mark.parametrize(
    ("cxx", "shown"),
    [
        ("std::basic_string<char>", "string"),
        ("float", "double"),
        ("double", "double"),
        ("int", "int"),
        ("boolean", "bool"),
        ("std::vector<int>", "std::vector<int>"),
        ("unsigned char", "int"),
        ("long", "int"),
    ],
)
def test_parameter_types(cxx: str, shown: str) -> None:
    (parameter,) = model(parameter_access=[("c1", "read", "p")], parameter_access_type=[("c1", "p", cxx)], node_location=place("c1")).params
    assert parameter.type == shown


def test_parameters_are_sorted_and_distinct() -> None:
    access = [("c2", "read", "b"), ("c2", "read", "a"), ("c1", "write", "z"), ("c2", "read", "a")]
    found = model(parameter_access=access, node_location=place("c1", "c2"))
    assert [(p.name, p.op, str(p.at)) for p in found.params] == [
        ("z", "write", "pkg/n.cpp:10"),
        ("a", "read", "pkg/n.cpp:11"),
        ("b", "read", "pkg/n.cpp:11"),
    ]


def test_a_site_without_place_is_left_out() -> None:
    found = model(port=[(OUT,), (IN,)], implicit_port=[(("c9", "publisher", "x"), "t")], node_location=place("c2"))
    assert [port.name for port in found.ports] == ["in"]


def test_a_parameter_access_without_place_is_left_out() -> None:
    assert model(parameter_access=[("c9", "read", "p")], node_location=place("c2")).params == ()


def test_nodes_of_a_program_have_what_is_theirs_and_what_is_nobodys() -> None:
    sites = place("c1", "c2", "c3", "c4")
    relations = {
        "port": [(("c1", "publisher", "out"),), (("c2", "subscriber", "in"),), (("c3", "publisher", "both"),)],
        "parameter_access": [("c4", "read", "~rate")],
        "node_location": sites,
        "node_name": [("first",), ("second",)],
        "node_element": [("first", "c1"), ("second", "c2"), ("second", "c4")],
    }
    program = ("sys", "n", "pkg", "node", ("pkg/n.cpp",))
    whole, first, second = build_models(*program, {name: relations.get(name, []) for name in NAMES})
    assert [port.name for port in whole.ports] == ["out", "in", "both"]
    assert ([port.name for port in first.ports], first.params, first.node_name, first.executable) == (["out", "both"], (), "first", "n")
    assert ([port.name for port in second.ports], second.params) == (["in", "both"], whole.params)
    assert "executable" not in to_json(whole)
    assert to_json(second)["executable"] == "n"
    assert build_models(*program, {name: RELATIONS.get(name, []) for name in NAMES}) == (model(**RELATIONS),)


def test_nodes_that_are_called_alike_tell_their_programs() -> None:
    def named(component: str, executable: str | None = None) -> ComponentModel:
        return ComponentModel("sys", component, "pkg", "node", None, (), (), (), executable=executable)

    found = distinct([named("b", "two"), named("two"), named("b", "one"), named("c", "one"), named("d"), named("d", "one")])
    assert [each.component for each in found] == ["c", "d", "one.b", "one.d", "two", "two.b"]
