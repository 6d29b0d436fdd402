"""Small ROS workspaces on disk for tests."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.workspace import Package, Target, Workspace, discover

HEAD = "cmake_minimum_required(VERSION 2.8.3)\nproject({name})\nfind_package(catkin REQUIRED COMPONENTS roscpp)\n"


def manifest(name: str, *, depends: tuple[str, ...] = (), export: str = "") -> str:
    """A valid `package.xml`."""
    lines = "".join(f"  <depend>{depend}</depend>\n" for depend in depends)
    return (
        f'<package format="2">\n  <name>{name}</name>\n  <version>1.2.3</version>\n  <description>x</description>\n'
        f'  <maintainer email="a@b.org">a</maintainer>\n  <license>BSD</license>\n  <buildtool_depend>catkin</buildtool_depend>\n'
        f"{lines}  <export>{export}</export>\n</package>\n"
    )


def write(root: Path, files: Mapping[str, str | bytes]) -> None:
    """Write files below `root`."""
    for name, content in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


def package(root: Path, name: str, cmake: str, files: Mapping[str, str | bytes] | None = None, **more: object) -> None:
    """Write a package with the usual head of `CMakeLists.txt`."""
    text = manifest(name, **more)  # type: ignore[arg-type]
    write(root / name, {"package.xml": text, "CMakeLists.txt": HEAD.format(name=name) + cmake, **(files or {})})


def evaluated(root: Path, cmake: str, files: Mapping[str, str | bytes] | None = None, **options: object) -> tuple[Package, Workspace]:
    """The only package of a workspace, evaluated."""
    package(root, "demo", cmake, files)
    workspace = discover(root, **options)  # type: ignore[arg-type]
    found = workspace.package("demo")
    assert found is not None
    return found, workspace


def target(found: Package, name: str) -> Target:
    """A target that must be there."""
    result = found.target(name)
    assert result is not None, [one.name for one in found.targets]
    return result


def names(one: Target) -> list[str]:
    """The file names of a target's sources."""
    return [path.name for path in one.sources]


def messages(workspace: Workspace, root: Path) -> list[str]:
    """Diagnostics with paths relative to `root`."""
    return [str(diagnostic).replace(f"{root}/", "").replace(f"{root}:", ".:") for diagnostic in workspace.diagnostics]
