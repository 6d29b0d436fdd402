"""Files that robot descriptions name as meshes."""

from __future__ import annotations

from pathlib import Path

from rosarch.extractor.launch import Files, PackagePath, compose
from rosarch.extractor.launch.model import FileMeant, FileNamed

URDF = """<robot name="lamp" xmlns:xacro="http://ros.org/wiki/xacro">
  <xacro:arg name="part" default="{}"/>
  <link name="base"><visual><geometry>
    <mesh filename="package://lamp/meshes/$(arg part).stl"/>
  </geometry></visual><collision><geometry>
    <mesh filename="package://elsewhere/meshes/base.stl"/><mesh filename="meshes/base.stl"/><mesh filename="package://lamp"/>
  </geometry></collision></link>
</robot>"""


def named(root: Path, part: str, launch: str, others: tuple[str, ...] = ("base.stl",)) -> list[tuple[str, str, str, int]]:
    package = root / part / "lamp"
    (package / "meshes").mkdir(parents=True)
    (package / "package.xml").write_text("<package format='2'><name>lamp</name></package>")
    for name in others:
        (package / "meshes" / name).touch()
    (package / "lamp.urdf").write_text(URDF.format(part) if "xacro" in launch else URDF.format("").replace("$(arg part)", part))
    (package / "lamp.launch").write_text(f"<launch><param name='robot_description' {launch}/></launch>")
    composition = compose([package / "lamp.launch"], files=Files(PackagePath([root / part])))
    found = [one for one in composition.references if isinstance(one, (FileNamed, FileMeant)) and one.role == "mesh"]
    return [(type(one).__name__, Path(one.file).name, Path(one.place.path).name, one.place.line) for one in found]


def test_meshes(tmp_path: Path) -> None:
    for launch in ("command='xacro $(find lamp)/lamp.urdf'", "textfile='$(find lamp)/lamp.urdf'"):
        folder = tmp_path / launch[:4]
        assert named(folder, "base", launch) == [("FileMeant", "base.stl", "lamp.urdf", 4)]
        assert named(folder, "bse", launch) == [("FileNamed", "bse.stl", "lamp.urdf", 4)]
        assert named(folder, "Base", launch) == [("FileNamed", "Base.stl", "lamp.urdf", 4)]
        assert named(folder, "wheel", launch) == []
        assert named(folder, "large", launch, ()) == []
