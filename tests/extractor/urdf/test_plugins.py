from __future__ import annotations

from pathlib import Path

from xacro_builder import expanded

from rosarch.extractor.launch.model import Place
from rosarch.extractor.urdf import SimulatorPlugin, plugins
from rosarch.extractor.urdf.document import parse

SDF = b"""<sdf version="1.6"><world name="w">
  <plugin name="clock" filename="libclock.so"/>
  <model name="m"><link name="base">
    <sensor name="front" type="camera">
      <plugin name="cam" filename="libcam.so">
        <ros><namespace>robot</namespace></ros>
        <topic> image </topic>
        <topic>other</topic><empty/>
      </plugin>
    </sensor>
  </link></model>
</world></sdf>"""


def test_plugins_of_a_world() -> None:
    found = plugins(parse(SDF, "a.world").root)
    leaves = (("ros/namespace", "robot"), ("topic", "image"), ("topic", "other"), ("empty", ""))
    places = tuple(Place("a.world", line, column) for line, column in ((6, 14), (7, 9), (8, 9), (8, 29)))
    assert found == (
        SimulatorPlugin("libclock.so", "clock", None, None, (), Place("a.world", 2, 3)),
        SimulatorPlugin("libcam.so", "cam", "base", "front", leaves, Place("a.world", 5, 7), places),
    )


def test_plugins_of_a_description_are_placed_where_they_are_written(tmp_path: Path) -> None:
    laser = (
        "ROBOT\n<xacro:macro name='laser' params='link topic'>\n<gazebo reference='${link}'><sensor name='${link}_ray' type='ray'>\n"
        " <plugin name='ray' filename='liblaser.so'><topicName>${topic}</topicName></plugin></sensor></gazebo></xacro:macro></robot>"
    )
    content = (
        "<xacro:include filename='laser.xacro'/><xacro:laser link='front' topic='scan'/><xacro:laser link='back' topic='$(arg t)'/>\n"
        "<gazebo><plugin filename='libdrive.so'/></gazebo>"
    )
    expansion = expanded(tmp_path, content, {"t": "/scan2"}, laser_xacro=laser)
    assert expansion.document is not None
    found = plugins(expansion.document.root)
    assert [
        (p.filename, p.name, p.reference, p.sensor, p.elements, Path(p.place.path).name, p.place.line, p.place.column) for p in found
    ] == [
        ("liblaser.so", "ray", "front", "front_ray", (("topicName", "scan"),), "laser.xacro", 4, 2),
        ("liblaser.so", "ray", "back", "back_ray", (("topicName", "/scan2"),), "laser.xacro", 4, 2),
        ("libdrive.so", "", None, None, (), "robot.xacro", 2, 9),
    ]
