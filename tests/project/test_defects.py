"""What the tools before this one got wrong; each with a node that shows it.

Guards of several callers are the subject of the behaviour rules, remappings of launch files that of the system rules.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

HEAD = """#include <functional>
#include <string>
#include <vector>
#include <ros/ros.h>
#include <std_msgs/String.h>
typedef std_msgs::String M;
"""


@pytest.fixture
def model(rosarch: Callable, workspace: Path) -> Callable[[str], dict[str, Any]]:
    """The model of a node with the given code, in its file after `HEAD`."""

    def analyse(code: str) -> dict[str, Any]:
        (workspace / "talker/talker.cpp").write_text(HEAD + code)
        outcome = rosarch("analyze", workspace, "--format", "json")
        assert (outcome.code, outcome.err) == (0, "")
        (found,) = json.loads(outcome.out)
        return dict(found)

    return analyse


def main(body: str) -> str:
    return f'int main(int argc, char** argv)\n{{\n  ros::init(argc, argv, "talker");\n  ros::NodeHandle nh;\n{body}\n}}\n'


def names(found: dict[str, Any]) -> list[str]:
    return sorted(port["name"] for port in found["ports"])


def test_a_name_read_from_a_parameter_through_an_out_argument(model: Callable) -> None:
    found = model(main('std::string topic; nh.param<std::string>("topic", topic, "scan");\nros::Publisher p = nh.advertise<M>(topic, 1);'))
    (port,) = found["ports"]
    assert (port["name"], port["from_param"]) == ("scan", "topic")


@pytest.mark.parametrize(
    ("declared", "body", "expected"),
    [
        ('struct N { std::string t = "a"; void go(ros::NodeHandle& nh) { nh.advertise<M>(t, 1); } };', "N n; n.go(nh);", ["a"]),
        ("void go(ros::NodeHandle& nh, std::string t) { nh.advertise<M>(t, 1); }", 'go(nh, "a"); go(nh, "b");', ["a", "b"]),
        ("", 'std::string t = "a"; t += "b"; nh.advertise<M>(t + "/c", 1);', ["ab/c"]),
        ("", 'for (const std::string& t : std::vector<std::string>{"a", "b"}) nh.advertise<M>(t, 1);', ["a", "b"]),
    ],
    ids=["member", "argument", "built", "list"],
)
def test_names_that_are_no_literal_of_the_call(model: Callable, declared: str, body: str, expected: list[str]) -> None:
    assert names(model(f"{declared}\n{main(body)}")) == expected


def test_a_handle_with_a_namespace(model: Callable) -> None:
    assert names(model(main('ros::NodeHandle ns("ns"); ns.advertise<M>("topic", 1);'))) == ["ns/topic"]


def test_an_absolute_name_on_a_private_handle(model: Callable) -> None:
    assert names(model(main('ros::NodeHandle p("~"); p.advertise<M>("/topic", 1); p.advertise<M>("own", 1);'))) == ["/topic", "~own"]


def test_a_remapping_replaces_whole_names(model: Callable) -> None:
    body = 'ros::M_string r; r["odom"] = "pose"; ros::NodeHandle h("", r); h.advertise<M>("odom", 1); h.advertise<M>("odometry", 1);'
    assert names(model(main(body))) == ["odometry", "pose"]


def test_recursion_terminates(model: Callable) -> None:
    code = 'std::string path(int n) { return n ? path(n - 1) + "/x" : "root"; }\n'
    code += "void spread(ros::NodeHandle& nh, std::string t, int n) { if (n) spread(nh, t + t, n - 1); nh.advertise<M>(t, 1); }\n"
    assert names(model(code + main('nh.advertise<M>(path(argc), 1); spread(nh, "a", 3);'))) == ["?", "a", "root"]


STATEMENTS = [
    "switch (argc) {{ case 1: {0} break; default: break; }}",
    "for (int i = 0; i < 1; ++i) {{ {0} }}",
    "do {{ {0} }} while (argc > 2);",
    "std::vector<int> v(2); for (int i : v) {{ {0} }}",
    "try {{ {0} }} catch (const std::exception& e) {{ }}",
    "try {{ }} catch (const std::exception& e) {{ {0} }}",
    "auto f = [&]() {{ {0} }}; f();",
    "std::function<void()> f = [&]() {{ {0} }}; f();",
    'argc > 1 ? (void)nh.advertise<M>("x", 1) : (void)0;',
]


@pytest.mark.parametrize("statement", STATEMENTS)
def test_a_port_in_any_statement(model: Callable, statement: str) -> None:
    assert names(model(main(statement.format('nh.advertise<M>("x", 1);')))) == ["x"]


def test_overloads_templates_and_virtual_calls(model: Callable) -> None:
    code = """struct Base { virtual ~Base() {} virtual void go(ros::NodeHandle& nh) {} };
struct Used : Base { void go(ros::NodeHandle& nh) override { nh.advertise<M>("used", 1); } };
struct Unused : Base { void go(ros::NodeHandle& nh) override { nh.advertise<M>("unused", 1); } };
void add(ros::NodeHandle& nh, int) { nh.advertise<M>("int", 1); }
void add(ros::NodeHandle& nh, const char*) { nh.advertise<M>("text", 1); }
template <class T> void make(ros::NodeHandle& nh) { nh.advertise<T>("template", 1); }
"""
    found = model(code + main("Base* base = new Used; base->go(nh); add(nh, 1); make<M>(nh);"))
    assert names(found) == ["int", "template", "used"]
    assert {port["type"] for port in found["ports"]} == {"std_msgs/String"}


CALLBACKS = [
    ("#include <message_filters/subscriber.h>", 'message_filters::Subscriber<M> s(nh, "x", 1); s.registerCallback(cb);'),
    (
        "#include <message_filters/subscriber.h>\n#include <tf2_ros/transform_listener.h>\n#include <tf2_ros/message_filter.h>",
        'tf2_ros::Buffer b; message_filters::Subscriber<M> s(nh, "x", 1); tf2_ros::MessageFilter<M> f(s, b, "map", 1, nh); f.registerCallback(cb);',
    ),
    ("", 'ros::Subscriber s = nh.subscribe<M>("x", 1, boost::bind(cb, _1));'),
]


@pytest.mark.parametrize(("includes", "body"), CALLBACKS)
def test_a_callback_of_a_filter_is_a_callback(model: Callable, includes: str, body: str) -> None:
    found = model(f"{includes}\nvoid cb(const std_msgs::StringConstPtr& m) {{}}\n{main(body)}")
    assert [(port["name"], port["callback"]) for port in found["ports"] if port["kind"] == "subscriber" and not port.get("implicit")] == [
        ("x", "cb")
    ]


def test_a_bad_file_costs_that_file(rosarch: Callable, workspace: Path) -> None:
    cmake = workspace / "talker/CMakeLists.txt"
    cmake.write_text(cmake.read_text() + "add_executable(broken broken.cpp)\nadd_executable(other other.cpp)\n")
    (workspace / "talker/broken.cpp").write_bytes(b"#include <ros/ros.h>\nint main() { ros::NodeHandle nh; \0\xff }}}} class {\n")
    (workspace / "talker/other.cpp").write_text((workspace / "talker/talker.cpp").read_text().replace("chatter", "other"))
    outcome = rosarch("analyze", workspace, "--format", "json")
    assert outcome.code == 0
    found = {model["component"]: names(model) for model in json.loads(outcome.out)}
    assert (found["talker"], found["other"]) == (["chatter"], ["other"])
    assert "broken.cpp" in outcome.err
