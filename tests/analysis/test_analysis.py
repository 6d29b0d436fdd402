"""From a workspace and its launch files to the models of systems."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import SystemAnalysis, analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.base.places import Place
from rosarch.extractor.settings import Settings
from rosarch.models.system.build import evaluate, system_model
from rosarch.models.system.model import Connector, Inclusion
from rosarch.models.system.rows import merged
from rosarch.rule_programs.sets import system_rules

pytestmark = pytest.mark.slow

LAUNCH = """<launch>
<arg name="debug"/>
<group ns="robot">
  <node pkg="talker" type="talker" name="one"><remap from="chatter" to="/words"/></node>
</group>
<node pkg="topic_tools" type="relay" name="relay" args="words heard"/>
<node pkg="nodelet" type="nodelet" name="manager" args="manager"/>
<node pkg="gone" type="gone" name="gone" if="$(arg debug)"/>
<include file="$(find talker)/part.launch"/>
<include file="$(find talker)/missing.launch"/>
</launch>
"""


@pytest.fixture
def analysis(workspace: Path) -> SystemAnalysis:
    (workspace / "talker" / "main.launch").write_text(LAUNCH)
    (workspace / "talker" / "part.launch").write_text('<launch>\n<node pkg="talker" type="talker" name="two"/>\n</launch>')
    where = LaunchEnvironment(workspace, (workspace,), {})
    return analyze_systems(workspace, given([parse_request("talker/main.launch")], where), Method(sources=Settings(jobs=1)))


def test_nodes(analysis: SystemAnalysis) -> None:
    (system,) = analysis.systems
    assert (system.name, system.launch) == ("talker/main.launch", ("talker/main.launch",))
    assert [(node.name, node.origin, node.component, node.open, node.conditions) for node in system.nodes] == [
        ("/gone", "unknown", None, True, ("if $(arg debug)",)),
        ("/manager", "library", None, False, ()),
        ("/relay", "library", "topic_tools/relay", False, ()),
        ("/robot/one", "source", "talker/talker", False, ()),
        ("/two", "source", "talker/talker", False, ()),
    ]
    assert [str(place) for place in system.nodes[-1].lines] == ["talker/main.launch:9", "talker/part.launch:2"]


def test_ports(analysis: SystemAnalysis) -> None:
    one = next(node for node in analysis.systems[0].nodes if node.name == "/robot/one")
    (port,) = one.ports
    assert (port.kind, port.name, port.written, port.type) == ("publisher", "/words", "chatter", "std_msgs/String")
    assert port.at == Place("talker/talker.cpp", 8, 24)  # of the call


def test_connectors(analysis: SystemAnalysis) -> None:
    connectors = {connector.name: connector for connector in analysis.systems[0].connectors}
    one, two, relay = ({node.name: node.ports for node in analysis.systems[0].nodes}[name] for name in ("/robot/one", "/two", "/relay"))
    inner = {port.kind: port.id for port in relay}
    assert connectors["/words"] == Connector(
        "topic", "/words", ("std_msgs/String",), (("/robot/one", one[0].id),), (("/relay", inner["subscriber"]),), open=True
    )  # a file that is not there may start others
    assert connectors["/chatter"].sources == (("/two", two[0].id),)
    assert connectors["/heard"].sinks == ()


def test_inclusions_and_diagnostics(analysis: SystemAnalysis, workspace: Path) -> None:
    assert analysis.systems[0].inclusions == (
        Inclusion(Place("talker/main.launch", 9, 1), "talker/part.launch", "talker/part.launch"),
        Inclusion(Place("talker/main.launch", 10, 1), "", None),
    )
    assert [str(diagnostic).replace(f"{workspace}/", "") for diagnostic in analysis.diagnostics] == [
        "talker/main.launch:8:1: argument `debug` must be passed, it has no value",
        "talker/main.launch:10:1: no such file: talker/missing.launch",
    ]
    assert [model.component for model in analysis.models] == ["talker"]


def test_what_a_viewer_shows_is_of_the_types_of_its_displays(workspace: Path) -> None:
    config = "Visualization Manager:\n  Displays:\n  - {Class: rviz/LaserScan, Topic: /scan}\n  Tools:\n  - {Class: rviz/SetGoal, Topic: /goal}\n"
    (workspace / "talker" / "demo.rviz").write_text(config)
    node = '<node pkg="rviz" type="rviz" name="rviz" args="-d $(find talker)/demo.rviz"/>'
    (workspace / "talker" / "view.launch").write_text(f"<launch>{node}</launch>")
    launches = given([parse_request("talker/view.launch")], LaunchEnvironment(workspace, (workspace,), {}))
    (system,) = analyze_systems(workspace, launches, Method(sources=Settings(jobs=1))).systems
    types = {"/scan": "sensor_msgs/LaserScan", "/goal": "geometry_msgs/PoseStamped"}
    assert {port.name: port.type for port in system.nodes[0].ports if port.name in types} == types
    assert {connector.name: connector.types for connector in system.connectors if connector.name in types} == {
        name: (type_,) for name, type_ in types.items()
    }


def test_a_controller_goes_by_the_name_of_its_class(workspace: Path) -> None:
    kind = "position_controllers/GripperActionController"  # of the package gripper_controllers
    (workspace / "talker" / "c.yaml").write_text(f"controller_manager:\n  ros__parameters:\n    gripper: {{type: {kind}}}\n")
    manager = '<node pkg="controller_manager" exec="ros2_control_node"><param from="$(find-pkg-share talker)/c.yaml"/></node>'
    spawner = '<node pkg="controller_manager" exec="spawner" args="gripper"/>'
    (workspace / "talker" / "arm.launch.xml").write_text(f"<launch>{manager}{spawner}</launch>")
    launches = given([parse_request("talker/arm.launch.xml")], LaunchEnvironment(workspace, (workspace,), {}))
    (system,) = analyze_systems(workspace, launches, Method(sources=Settings(jobs=1))).systems
    (gripper,) = (node for node in system.nodes if node.name == "/gripper")
    assert (gripper.origin, gripper.component) == ("library", f"gripper_controllers/{kind}")
    assert [port.name for port in gripper.ports if not port.implicit] == ["/gripper/gripper_cmd"]


def test_one_system_that_fails_costs_that_system(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("a", "b"):
        (workspace / "talker" / f"{name}.launch").write_text('<launch><node pkg="talker" type="talker" name="t"/></launch>')
    launches = given([parse_request("talker/a.launch"), parse_request("talker/b.launch")], LaunchEnvironment(workspace, (workspace,), {}))

    def broken(name: str, *rest: object) -> object:
        if name == "talker/a.launch":
            raise MemoryError
        return system_model(name, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr("rosarch.models.system.build.system_model", broken)
    found = analyze_systems(workspace, launches, Method(sources=Settings(jobs=1)))
    assert [system.name for system in found.systems] == ["talker/b.launch"]
    assert [diagnostic.message.partition(":")[0] for diagnostic in found.diagnostics] == ["talker/a.launch not composed"]


def test_rows_are_united() -> None:
    assert merged([{"a": {(1,)}, "b": {(2,)}}, {"a": {(3,)}}]) == {"a": {(1,), (3,)}, "b": {(2,)}}


def test_an_empty_system() -> None:
    rules = system_rules()
    system = system_model("none", (), {}, evaluate(rules, {}), {})
    assert (system.nodes, system.connectors, system.inclusions) == ((), (), ())
    assert {"topic-type-mismatch", "missing-file"} <= {check.id for check in rules.checks}


def test_what_another_launch_file_starts_of_the_library_may_send_a_frame(workspace: Path) -> None:
    """The fixed frame of rviz is not called one that nobody sends where the other launch file starts what makes a map."""
    package = workspace / "talker"
    (package / "talker.cpp").write_text(
        "#include <ros/ros.h>\n#include <sensor_msgs/LaserScan.h>\n"
        'int main(int argc, char** argv) {\n  ros::init(argc, argv, "talker");\n  ros::NodeHandle nh;\n'
        '  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);\n  ros::Rate rate(10);\n'
        '  while (ros::ok()) {\n    sensor_msgs::LaserScan scan;\n    scan.header.frame_id = "laser";\n'
        "    scan.header.stamp = ros::Time::now();\n    pub.publish(scan);\n    rate.sleep();\n  }\n}\n"
    )
    (package / "demo.rviz").write_text(
        "Visualization Manager:\n  Displays:\n  - {Class: rviz/LaserScan, Topic: /scan}\n  Global Options:\n    Fixed Frame: map\n"
    )
    (package / "view.launch").write_text(
        '<launch><node pkg="talker" type="talker" name="talker"/>'
        '<node pkg="tf2_ros" type="static_transform_publisher" name="tf" args="0 0 0 0 0 0 base laser"/>'
        '<node pkg="rviz" type="rviz" name="rviz" args="-d $(find talker)/demo.rviz"/></launch>'
    )
    (package / "map.launch").write_text('<launch><node pkg="gmapping" type="slam_gmapping" name="gmapping"/></launch>')

    def checks(*files: str) -> set[str]:
        requests = [parse_request(f"talker/{file}") for file in files]
        analysis = analyze_systems(
            workspace, given(requests, LaunchEnvironment(workspace, (workspace,), {})), Method(sources=Settings(jobs=1))
        )
        return {finding.check.id for finding in analysis.findings}

    assert "fixed-frame-not-sent" in checks("view.launch")
    assert "fixed-frame-not-sent" not in checks("view.launch", "map.launch")


def test_a_robot_description_that_does_not_exist_is_one_finding_and_none_outside_of_the_workspace(workspace: Path) -> None:
    package = workspace / "talker"
    for name, path in (("in", "$(find talker)/robot.xacro"), ("out", "/srv/robots/robot.xacro")):
        (package / f"{name}.launch").write_text(
            f'<launch>\n<param name="robot_description" command="$(find xacro)/xacro {path}"/>\n<param name="p" value="1"/>\n</launch>'
        )
    requests = [parse_request("talker/in.launch"), parse_request("talker/out.launch")]
    launches = given(requests, LaunchEnvironment(workspace, (workspace,), {}))
    found = analyze_systems(workspace, launches, Method(sources=Settings(jobs=1))).findings
    about = [(each.check.id, str(each.place), each.message) for each in found if each.severity != "note" and "package" not in each.check.id]
    assert about == [("missing-file", "talker/in.launch:2", "talker/robot.xacro does not exist")]
