"""Library files made from sources, and the commands."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from rosarch.base.places import Place
from rosarch.library import find
from rosarch.library.build import library_documents
from rosarch.library.model import Source
from rosarch.models.component import ComponentModel, Parameter
from rosarch.reports.library import library_schema

ORIGIN = ("--origin", "https://example.com/scan_filters.git", "--revision", "1.2")


@pytest.fixture
def built(rosarch: Callable, examples: Path, tmp_path: Path) -> Path:
    outcome = rosarch("library", "build", examples / "nodelet_filter", *ORIGIN, "-o", tmp_path / "own")
    assert (outcome.code, outcome.out, outcome.err) == (0, f"{tmp_path}/own/scan_filters.json\n", "")
    return tmp_path / "own"


@pytest.mark.slow
def test_a_workspace_becomes_a_library(built: Path, examples: Path) -> None:
    data = json.loads((built / "scan_filters.json").read_text())
    Draft202012Validator(library_schema()).validate(data)
    assert [component["component"] for component in data["components"]] == [
        "range_clip_node",
        "scan_filters/range_clip",
        "scan_filters/throttle",
    ]
    found = find(None, "scan_filters/range_clip", [built])
    assert found and (found.kind, found.origin, found.revision, found.made) == ("nodelet", ORIGIN[1], "1.2", "generated")
    expected = json.loads((examples / "nodelet_filter/expected/scan_filters/RangeClip.json").read_text())
    fields = ("kind", "name", "type", "queue", "latched", "from_param")
    assert [tuple(getattr(port, key) for key in fields) for port in found.ports] == [
        tuple(port[key] for key in fields) for port in expected["ports"]
    ]
    assert (found.base, found.document()["plugin"]) == ("nodelet::Nodelet", {"name": "scan_filters/range_clip", "base": "nodelet::Nodelet"})
    node = find("scan_filters", "range_clip_node", [built])
    assert node and node.loads == ("scan_filters/range_clip",) and not node.open
    assert {parameter.name for parameter in found.params} == {parameter["name"] for parameter in expected["params"]}


@pytest.mark.slow
def test_reconfigurable_parameters_are_parameters(rosarch: Callable, examples: Path, tmp_path: Path) -> None:
    assert rosarch("library", "build", examples / "services_and_actions", *ORIGIN, "-o", tmp_path).code == 0
    found = find("arm_control", "arm_server", [tmp_path])
    assert found
    assert {"kind": "dynamic_reconfigure_server", "name": "~", "type": "arm_control/ArmControlConfig"}.items() <= {
        key: value for port in found.ports if port.kind == "dynamic_reconfigure_server" for key, value in vars(port).items()
    }.items()
    config = (examples / "services_and_actions").rglob("*.cfg")
    assert any(parameter.name.lstrip("~") in next(config).read_text() for parameter in found.params if parameter.name)


@pytest.mark.slow
def test_unknown_names_leave_a_component_open(rosarch: Callable, examples: Path, tmp_path: Path) -> None:
    assert rosarch("library", "build", examples / "recording", *ORIGIN, "-o", tmp_path).code == 0
    found = find("recording", "record", [tmp_path])
    assert found and found.open_ports
    assert not [port for port in found.ports if "?" in (port.name or "")]


@pytest.mark.slow
def test_facts_are_as_good_as_sources(built: Path, rosarch: Callable, examples: Path, tmp_path: Path) -> None:
    assert rosarch("extract", examples / "nodelet_filter", "-o", tmp_path / "facts").code == 0
    assert rosarch("library", "build", tmp_path / "facts", *ORIGIN, "-o", tmp_path / "again").code == 0
    assert (tmp_path / "again" / "scan_filters.json").read_text() == (built / "scan_filters.json").read_text()


def test_list(built: Path, rosarch: Callable) -> None:
    outcome = rosarch("library", "list", "--library", built, "-p", "scan_filters")
    assert outcome.out == (
        "scan_filters/range_clip_node  node     4 ports  generated  https://example.com/scan_filters.git 1.2\n"
        "scan_filters/range_clip       nodelet  3 ports  generated  https://example.com/scan_filters.git 1.2\n"
        "scan_filters/throttle         nodelet  3 ports  generated  https://example.com/scan_filters.git 1.2\n"
        "\n3 components of 1 package\n"
    )
    documents = json.loads(rosarch("library", "list", "--library", built, "-p", "scan_filters", "--format", "json").out)
    assert [document["component"] for document in documents] == ["range_clip_node", "scan_filters/range_clip", "scan_filters/throttle"]


def test_show(rosarch: Callable) -> None:
    text = rosarch("library", "show", "topic_tools/throttle").out.splitlines()
    assert text[0] == "topic_tools/throttle  node"
    assert text[1].startswith("by hand: https://github.com/ros/ros_comm ")
    assert text[2].split() == ["subscriber", "(argument", "2)", "?"]
    assert text[3].split() == ["publisher", "{2}_throttle", "(argument", "4)", "?", "if", "argument", "1", "is", "messages"]
    assert rosarch("library", "show", "image_proc/debayer").out.startswith("image_proc/debayer  nodelet\n")
    assert json.loads(rosarch("library", "show", "topic_tools/throttle", "--format", "json").out)["ports"][0] == {
        "id": "p1",
        "kind": "subscriber",
        "name": "?",
        "via": "plain",
        "queue": 10,
        "from_arg": 2,
    }


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("show", "topic_tools/rely"), "the library has no component topic_tools/rely, did you mean `topic_tools/relay`?"),
        (("list", "-p", "nothing"), "the library has no package nothing"),
        (("list", "--library", "/nowhere"), "/nowhere: no such folder"),
        (("build", ".", "--origin", " ", "--revision", "1", "-o", "x"), "--origin: is empty"),
    ],
)
def test_wrong_usage(rosarch: Callable, arguments: tuple[str, ...], message: str) -> None:
    outcome = rosarch("library", *arguments)
    assert (outcome.code, outcome.err) == (2, f"rosarch: error: {message}\n")


def test_a_broken_file_is_told(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "bad.json").write_text("{}")
    outcome = rosarch("library", "list", "--library", tmp_path, "-p", "joy")
    assert outcome.code == 0
    assert outcome.err == f"library: 1\n  {tmp_path}/bad.json:1:1: file: `package` is missing\n1 diagnostic\n"


SOURCE = """
#include <ros/ros.h>
#include <std_msgs/Bool.h>
int main(int argc, char** argv) {
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  bool use_control;
  ros::param::param("~use_control", use_control, false);
  ros::Publisher always = nh.advertise<std_msgs::Bool>("always", 1);
  if (use_control) {
    ros::Publisher sometimes = nh.advertise<std_msgs::Bool>("sometimes", 1);
    ros::spin();
  }
  ros::spin();
}
"""


@pytest.mark.slow
def test_conditions_of_ports_are_kept(rosarch: Callable, tmp_path: Path) -> None:
    package = tmp_path / "ws" / "p"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>p</name><depend>roscpp</depend><depend>std_msgs</depend></package>")
    (package / "CMakeLists.txt").write_text("find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)\nadd_executable(n n.cpp)\n")
    (package / "n.cpp").write_text(SOURCE)
    assert rosarch("library", "build", tmp_path / "ws", *ORIGIN, "-o", tmp_path / "own").code == 0
    found = find("p", "n", [tmp_path / "own"])
    assert found and {port.name: port.conditional for port in found.ports} == {"always": None, "sometimes": "~use_control"}


CONFIGURED = """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
class N : public rclcpp::Node {
 public:
  N() : rclcpp::Node("n") {
    declare_parameter("tf.use", false);
    get_parameter("tf.use", use_);
    kind_ = declare_parameter("kind", std::string("a"));
    if (!use_) first_ = create_publisher<std_msgs::msg::Bool>("first", 1);
    if (use_ && kind_ == "b" && count_publishers("x") > 0) second_ = create_publisher<std_msgs::msg::Bool>("second", 1);
    if (use_ && (kind_ == "b" || count_publishers("x") > 0)) third_ = create_publisher<std_msgs::msg::Bool>("third", 1);
    if (use_ || kind_ == "b") fourth_ = create_publisher<std_msgs::msg::Bool>("fourth", 1);
  }
  bool use_;
  std::string kind_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr first_, second_, third_, fourth_;
};
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<N>());
}
"""


@pytest.mark.slow
def test_conditions_are_said_by_parameters_as_far_as_these_decide(rosarch: Callable, tmp_path: Path) -> None:
    package = tmp_path / "ws" / "p"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>p</name><depend>rclcpp</depend><depend>std_msgs</depend></package>")
    (package / "CMakeLists.txt").write_text(
        "find_package(rclcpp REQUIRED)\nadd_executable(n n.cpp)\nament_target_dependencies(n rclcpp std_msgs)\n"
    )
    (package / "n.cpp").write_text(CONFIGURED)
    assert rosarch("library", "build", tmp_path / "ws", *ORIGIN, "-o", tmp_path / "own").code == 0
    found = find("p", "n", [tmp_path / "own"])
    assert found and {port.name: port.conditional for port in found.ports if port.kind == "publisher" and not port.implicit} == {
        "first": "not ~tf.use",
        "second": '~tf.use and ~kind is b and use_ && kind_ == "b" && count_publishers("x") > 0',
        "third": '~tf.use and use_ && (kind_ == "b" || count_publishers("x") > 0)',
        "fourth": 'use_ || kind_ == "b"',
    }


NAMED_AFTER_ITSELF = """
#include <rclcpp/rclcpp.hpp>
#include <std_srvs/srv/trigger.hpp>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("keeper");
  auto answer = [](std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr) {};
  auto service = node->create_service<std_srvs::srv::Trigger>(std::string(node->get_name()) + "/is_active", answer);
  rclcpp::spin(node);
}
"""


@pytest.mark.slow
def test_names_made_of_the_own_one_are_for_any(rosarch: Callable, tmp_path: Path) -> None:
    package = tmp_path / "ws" / "p"
    package.mkdir(parents=True)
    manifest = "<package><name>p</name><depend>rclcpp</depend><depend>std_srvs</depend><export><build_type>ament_cmake</build_type></export></package>"
    (package / "package.xml").write_text(manifest)
    (package / "CMakeLists.txt").write_text("find_package(rclcpp REQUIRED)\nadd_executable(n n.cpp)\n")
    (package / "n.cpp").write_text(NAMED_AFTER_ITSELF)
    assert rosarch("library", "build", tmp_path / "ws", *ORIGIN, "-o", tmp_path / "own").code == 0
    found = find("p", "n", [tmp_path / "own"])
    assert found and found.node_name == "keeper"
    assert [port.name for port in found.ports if not port.implicit] == ["{node}/is_active"]


def test_the_distribution_says_for_which_ros_a_package_of_plugins_is() -> None:
    opened = Parameter("~max_effort", "read", "double", "1.0", Place("gripper.cpp", 1, 1))
    plugin = ComponentModel("system", "grippers/Gripper", "grippers", "plugin", None, (), (), (opened,))
    for distributions, expected in ((("jazzy",), [2]), (("noetic",), [1]), ((), [1])):
        source = Source("https://example.com/grippers.git", "1.0", distributions)
        assert library_documents([plugin], source)["grippers"]["ros"] == expected
