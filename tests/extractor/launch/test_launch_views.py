"""Configuration files of viewers that nodes are given, and the rows that they become."""

from __future__ import annotations

from pathlib import Path

from launch_builder import composed

from rosarch.extractor.launch.facts import launch_rows

_NODE = '<node pkg="rviz" type="rviz" name="rviz" args="-d $(find here)/demo.rviz"/>'
_VIEW = """Panels:
  - Class: rviz/Displays
Visualization Manager:
  Displays:
    - Class: rviz/LaserScan
      Enabled: true
      Topic: /scan
    - Class: rviz/Group
      Displays:
        - Class: rviz_default_plugins/Map
          Topic:
            Depth: 5
            Durability Policy: Transient Local
            Reliability Policy: Best Effort
            Value: /map
      Enabled: true
    - Class: rviz/Group
      Displays:
        - {Class: rviz/Path, Enabled: true, Topic: /path}
      Enabled: false
    - {Class: rviz/Image, Enabled: true, Image Topic: ""}
  Tools:
    - {Class: rviz/SetGoal, Topic: /goal}
  Global Options:
    Fixed Frame: map
"""


def test_parts_and_topics(tmp_path: Path) -> None:
    rows = launch_rows(composed(tmp_path, _NODE, demo_rviz=_VIEW), tmp_path)
    assert rows["view_given"] == {("/rviz", "here/demo.rviz")}
    assert {row[1:3] for row in rows["view_part"]} == {
        *(("display", name) for name in ("rviz/LaserScan", "rviz/Group", "rviz_default_plugins/Map", "rviz/Image")),
        *(("panel", "rviz/Displays"), ("tool", "rviz/SetGoal")),
    }
    assert rows["view_frame"] == {("/rviz", "map", "here/demo.rviz:25:18")}
    scan, map_, goal = (f"/rviz#here/demo.rviz:{place}" for place in ("7:14", "15:20", "23:36"))
    assert rows["view_topic"] == {
        ("/rviz", scan, "rviz/LaserScan", "Topic"),
        ("/rviz", map_, "rviz_default_plugins/Map", "Topic"),
        ("/rviz", goal, "rviz/SetGoal", "Topic"),
    }
    assert rows["interface_port"] == {
        ("/rviz", scan, "subscriber", "/scan"),
        ("/rviz", map_, "subscriber", "/map"),
        ("/rviz", goal, "publisher", "/goal"),
    }
    assert rows["interface_port_quality"] == {(map_, "durability", "transient_local"), (map_, "reliability", "best_effort")}


def test_what_is_no_configuration(tmp_path: Path) -> None:
    assert "view_given" not in launch_rows(composed(tmp_path, _NODE, demo_rviz="a: [b"), tmp_path)
    assert "view_given" not in launch_rows(composed(tmp_path, _NODE), tmp_path)
    assert launch_rows(composed(tmp_path, _NODE, demo_rviz="- a"), tmp_path)["view_given"] == {("/rviz", "here/demo.rviz")}
