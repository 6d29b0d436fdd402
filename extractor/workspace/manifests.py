"""Find and read `package.xml` files.

Sources: REP 127, REP 140, REP 149 (formats 1 to 3); the crawl follows catkin_pkg.packages and colcon: a folder with an ignore marker is
skipped with everything below it. They do not look below a package, unless users ask for it (colcon by base paths, others by their own
calls of CMake): packages below packages come last here, and a package of the same name elsewhere hides them.
"""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

from catkin_pkg.condition import evaluate_condition
from catkin_pkg.package import Dependency, InvalidPackage, parse_package_string

from rosarch.base.boundary import is_inside
from rosarch.base.diagnostics import Diagnostic, unreadable
from rosarch.base.files import LARGEST_PARSED, file_name, is_folder, read_file, text_or_nothing
from rosarch.base.xml_reader import XmlError, read_tree
from rosarch.extractor.package_names import HEAVY_FOLDERS, IGNORE_MARKERS, NO_PACKAGES
from rosarch.extractor.workspace.options import DEFAULT_AMENT_DISTRO, DEFAULT_DISTRO, initial_environment

LEADS_OUT = "a link out of the workspace, which is not followed unless its target is in ROS_PACKAGE_PATH"
_GENERATED_MARKERS = frozenset({".catkin", ".built_by", "CMakeCache.txt"})


def find_manifests(root: Path, problems: list[Diagnostic], *, ignored: bool = False) -> list[str]:
    """Paths of all manifests below `root`, sorted, those below other packages last; with `ignored`, also those that ignore markers hide.

    Folders reached twice through links are visited once. `problems` gets the folders that cannot be read and links that lead to themselves.
    """
    outer: list[str] = []
    inner: list[str] = []
    visited: set[str] = set()
    stack = [(str(root), False)]
    while stack:
        folder, inside = stack.pop()
        try:
            with os.scandir(folder) as scan:
                entries = list(scan)
        except OSError as error:
            if not inside:
                problems.append(unreadable(folder, error))
            continue
        names = {entry.name for entry in entries}
        if (names & IGNORE_MARKERS and not ignored) or (names & _GENERATED_MARKERS and folder != str(root)):
            continue
        if "package.xml" in names:
            (inner if inside else outer).append(f"{folder}/package.xml")
            inside = True
        for entry in entries:
            if entry.name.startswith(".") or entry.name in (NO_PACKAGES if inside else HEAVY_FOLDERS) or not is_folder(entry):
                if entry.is_symlink() and not inside and _is_loop(entry.path):
                    problems.append(Diagnostic("unreadable", Path(entry.path), 1, 1, "a link that leads to itself"))
                continue
            if entry.is_symlink():
                real = os.path.realpath(entry.path)
                if inside:
                    continue
                if not is_inside(real):
                    problems.append(Diagnostic("outside", Path(entry.path), 1, 1, LEADS_OUT))
                    continue
                if real in visited or f"{folder}/".startswith(real + "/"):
                    continue
                visited.add(real)
            stack.append((entry.path, inside))
    return sorted(outer) + sorted(inner)


def _is_loop(path: str) -> bool:
    try:
        os.stat(path)
    except OSError as error:
        return error.errno == errno.ELOOP
    return False


@dataclass(frozen=True)
class Manifest:
    """What a `package.xml` says."""

    name: str
    path: Path
    version: str = ""
    build_type: str = "catkin"
    depends: tuple[str, ...] = ()
    build_depends: tuple[str, ...] = ()
    is_metapackage: bool = False
    plugin_exports: tuple[tuple[str, Path], ...] = ()


def read_manifest(path: Path, distro: str | None = None) -> tuple[Manifest | None, list[Diagnostic]]:
    """Parse a manifest; without a distribution, with the conditions of the version of ROS that it is for.

    One that catkin_pkg rejects but that is XML is kept, with the refusal as a diagnostic.
    """
    try:
        data = read_file(path, LARGEST_PARSED)
        tree = read_tree(data)
    except XmlError as error:
        return None, [Diagnostic("manifest", path, error.line, error.column, error.message)]
    except OSError as error:
        return None, [unreadable(path, error)]
    name = (tree.findtext("name") or "").strip()
    if tree.tag != "package" or not name:
        message = "no <name>" if tree.tag == "package" else f"root element is <{tree.tag}>, not <package>"
        return None, [Diagnostic("manifest", path, 1, 1, message)]
    if name != file_name(name):
        return None, [Diagnostic("manifest", path, 1, 1, f"not a package name: {name!r}")]
    problems: list[Diagnostic] = []
    environment = initial_environment(distro or (DEFAULT_DISTRO if ros_version(path) == 1 else DEFAULT_AMENT_DISTRO))
    try:
        build, run = _strict_depends(data, path, environment)
    except (InvalidPackage, ValueError, AssertionError) as error:
        build, run = _texts(tree, _BUILD_TAGS, environment), _texts(tree, _RUN_TAGS, environment)
        problems.append(Diagnostic("manifest", path, 1, 1, f"not a valid manifest, read leniently: {_reason(error)}"))
    manifest = Manifest(
        name=name,
        path=path,
        version=(tree.findtext("version") or "").strip(),
        build_type=_build_type(tree, environment),
        depends=tuple(dict.fromkeys((*build, *run))),
        build_depends=build,
        is_metapackage=tree.find("export/metapackage") is not None,
        plugin_exports=_plugin_exports(tree, path.parent),
    )
    return manifest, problems


_BUILD_TAGS = ("depend", "build_depend", "build_export_depend", "buildtool_depend", "buildtool_export_depend", "run_depend")
_RUN_TAGS = ("exec_depend",)


def ros_version(path: Path) -> int:
    """The version of ROS that a manifest is for; without a tool of either, 1.

    One that names the tools of both is for that of its CMakeLists.txt: for 2, unless that knows only those of ROS 1.
    """
    tools = _tools(path)
    if len(tools) > 1:
        tools = _tools(path.parent / "CMakeLists.txt") or tools
    return 2 if "ament" in tools else 1


def _tools(path: Path) -> set[str]:
    return set(re.findall(r"\b(ament|catkin)", text_or_nothing(path)))


def _strict_depends(data: bytes, path: Path, environment: Mapping[str, str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Build and run dependencies as catkin_pkg reads them, conditions (REP 149) evaluated."""
    package = parse_package_string(data, str(path), warnings=[])
    package.evaluate_conditions(environment)
    build = (
        *package.build_depends,
        *package.build_export_depends,
        *package.buildtool_depends,
        *package.buildtool_export_depends,
    )
    return _names(build), _names(package.exec_depends)


def _names(depends: Iterable[Dependency]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(depend.name for depend in depends if depend.evaluated_condition is not False))


def _reason(error: Exception) -> str:
    """catkin_pkg's messages name the file and span lines; that of a format that it does not know says how to update it."""
    if isinstance(error, AssertionError):
        return "its format is not known"
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return "; ".join(line for line in lines if "package.xml" not in line) or lines[0]


def _texts(tree: Element, tags: tuple[str, ...], environment: Mapping[str, str]) -> tuple[str, ...]:
    found = ((element.text or "").strip() for tag in tags for element in tree.findall(tag) if _holds(element, environment))
    return tuple(dict.fromkeys(text for text in found if text))


def _build_type(tree: Element, environment: Mapping[str, str]) -> str:
    """`<export><build_type>`; without one, what the tools say."""
    for element in tree.findall("export/build_type"):
        if element.text and _holds(element, environment):
            return element.text.strip()
    tools = _texts(tree, ("buildtool_depend",), environment)
    return "ament_cmake" if any(tool.startswith("ament_cmake") for tool in tools) and "catkin" not in tools else "catkin"


def _holds(element: Element, environment: Mapping[str, str]) -> bool:
    """Whether the condition of an element holds (REP 149); one that cannot be read does."""
    try:
        return bool(evaluate_condition(element.get("condition"), environment))
    except ValueError:
        return True


def _plugin_exports(tree: Element, folder: Path) -> tuple[tuple[str, Path], ...]:
    """`<export><base_package plugin="${prefix}/file.xml"/>`: base package and file (pluginlib documentation)."""
    result: list[tuple[str, Path]] = []
    for export in tree.findall("export"):
        for element in export:
            plugin = element.get("plugin")
            if plugin and isinstance(element.tag, str):
                name = plugin.replace("${prefix}", str(folder))
                result.append((element.tag, Path(os.path.normpath(os.path.join(folder, name)))))
    return tuple(result)
