"""Defects of packages that show in their build files, scripts and interfaces alone, as rows of `rules/schema/build.dl`."""

from __future__ import annotations

import configparser
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from rosarch.analysis.systems.build_uses import GENERATES, own_header, without_comments
from rosarch.base.files import read_file, text_or_nothing
from rosarch.extractor.launch.model import Composition, ProgramNamed
from rosarch.extractor.package_names import NO_PACKAGES, quick_text
from rosarch.extractor.python_syntax import parse_python
from rosarch.extractor.workspace.built import INSTALLED_FIRST, Built, package_of
from rosarch.extractor.workspace.installs import line_with
from rosarch.extractor.workspace.model import TEST

_PROJECT = re.compile(r"^[ \t]*project[ \t]*\([ \t]*([A-Za-z][\w-]*)", re.MULTILINE | re.IGNORECASE)
_TYPESUPPORT = re.compile(r"rosidl_get_typesupport_target|rosidl_target_interfaces|__rosidl_typesupport_cpp|__rosidl_generator_cpp")
_MADE_FIRST = re.compile(r"EXPORTED_TARGETS|_generate_messages|_gencpp")
_GENERATED = re.compile(r"\.generate\s*\([^()]*[\"'](\w+)[\"']\s*\)")
_ADDED = ("message", "service", "action")
_ADDS = re.compile(rf"^[ \t]*add_({'|'.join(_ADDED)})_files\s*\(([^()]*)\)", re.MULTILINE)
_INTERFACE = re.compile(r"(?:msg|srv|action)/(\w+)\.(?:msg|srv|action)")
_FIELD = re.compile(r"[ \t]*[\w/]+(?:<=\d+)?(?:\[(?:<=)?\d*\])?[ \t]+(\w+)[ \t]*(=?)")
_FIELD_NAME = re.compile(r"[a-z](?:_?[a-z0-9])*")
_KINDS = ("msg", "srv", "action")


@dataclass(frozen=True)
class Defect:
    """What is wrong at `line` of `path`: `kind` names it, `about` what it concerns."""

    path: Path
    line: int
    kind: str
    about: str


def defects(composition: Composition, builds: Sequence[Built]) -> Iterator[tuple[str, Defect]]:
    """The defects of packages, each with the name of its package, as far as a composition has to do with them."""
    for package in builds:
        yield from ((package.name, one) for one in (*of_interfaces(package), *of_build(package), *of_own_headers(package)))
    programs = {(named.package, named.type) for named in composition.references if isinstance(named, ProgramNamed)}
    for name, program in sorted(programs):
        for package in (one for one in builds if one.name == name):
            yield from ((name, one) for one in _of_script(package, program, composition.ros))
            yield from ((name, one) for one in _of_setup(package, program))
    if composition.ros == 2:
        yield from _of_launch_files(composition, builds)


@lru_cache(maxsize=256)
def of_interfaces(package: Built) -> tuple[Defect, ...]:
    """What keeps the interfaces of a package from being generated."""
    cmake = package.folder / "CMakeLists.txt"
    text = without_comments(cmake)
    if package.build_type == "catkin":
        return tuple(_of_catkin_interfaces(package, cmake, text))
    found = GENERATES.search(text)
    if found is None or package.build_type != "ament_cmake":
        return ()
    line = 1 + text.count("\n", 0, found.start(1))
    manifest = package.folder / "package.xml"
    result = []
    if "rosidl_interface_packages" not in (quick_text(str(manifest)) or "rosidl_interface_packages"):
        result.append(Defect(manifest, 1, "interface group", ""))
    for match in re.finditer(r"[^\s\"]+", found[1]):
        name = match.group().removeprefix("${PROJECT_SOURCE_DIR}/").removeprefix("${CMAKE_CURRENT_SOURCE_DIR}/")
        if re.fullmatch(_INTERFACE, name) and not os.path.isfile(package.folder / name):
            result.append(Defect(cmake, line + found[1].count("\n", 0, match.start()), "interface file", name))
    for kind in _KINDS:
        for path in sorted((package.folder / kind).glob(f"*.{kind}")):
            result += _of_interface(package, cmake, line, path, known="${" not in found[1].replace("${PROJECT_NAME}", ""))
    return tuple(result)


@lru_cache(maxsize=256)
def of_build(package: Built) -> tuple[Defect, ...]:
    """What keeps a package of ROS 2 from being built, and its libraries, or any plug-ins, from being loaded."""
    result = [Defect(one.path, one.line, one.kind, one.about) for one in package.obstacles if one.kind.startswith("description")]
    if package.build_type not in INSTALLED_FIRST:
        return tuple(result)
    build = package.folder / ("setup.py" if package.build_type == "ament_python" else "CMakeLists.txt")
    if not os.path.exists(build):
        manifest = package.folder / "package.xml"
        return (*result, Defect(manifest, line_with(manifest, "<build_type"), "build file", build.name))
    if not package.unsure:
        result += [Defect(one.path, one.line, one.kind, one.about) for one in package.obstacles if one.kind.endswith("source")]
        left_out = {(*one.library_at, one.library) for one in package.promised if not one.installed and package.build_type == "ament_cmake"}
        result += [Defect(path, line, "library left out", library) for path, line, library in sorted(left_out)]
    if build.suffix == ".txt" and not package.unsure and not re.search(r"\bament_(auto_)?package\s*\(", text_or_nothing(build)):
        result.append(Defect(build, 1, "not registered", ""))
    project = _PROJECT.search(without_comments(build)) if build.suffix == ".txt" else None
    if project is not None and project[1] != package.name:
        result.append(Defect(build, line_with(build, project[0].strip()), "project name", project[1]))
    return tuple(result)


@lru_cache(maxsize=256)
def of_own_headers(package: Built) -> tuple[Defect, ...]:
    """Headers that the build makes of a package's own interfaces and parameters, where they are not made, or not for certain in time."""
    text = without_comments(package.folder / "CMakeLists.txt")
    if package.unsure or package.build_type not in ("catkin", "ament_cmake"):
        return ()
    result = []
    for target in (one for one in package.targets if one.kind != TEST):
        if package.build_type == "ament_cmake":
            found = own_header(package, target, r"(?:msg|srv|action)/(\w+)\.hpp") if GENERATES.search(text) else None
            if found is not None and not _TYPESUPPORT.search(text) and "ament_auto" not in text:
                result.append(Defect(target.cmake_file, target.line, "own interfaces", target.name))
            continue
        found = own_header(package, target, r"(\w+)Config\.h")
        if found is not None and found[2] not in _configurations(package):
            result.append(Defect(found[0], found[1], "configuration not made", f"{package.name}/{found[2]}Config.h"))
        found = own_header(package, target, r"(\w+)\.h")
        made = {path.stem for path in package.interfaces}
        if found is not None and re.sub("Request$|Response$", "", found[2]) in made and not _MADE_FIRST.search(text):
            result.append(Defect(target.cmake_file, target.line, "interfaces later", target.name))
    return tuple(result)


def _configurations(package: Built) -> set[str]:
    """The names of the configurations that the build generates."""
    return {name for path in package.configurations for name in _GENERATED.findall(text_or_nothing(path))}


def _of_catkin_interfaces(package: Built, cmake: Path, text: str) -> Iterator[Defect]:
    """Interfaces of ROS 1 that no call lists, and lists of which nothing is made."""
    calls = list(_ADDS.finditer(text))
    for call in calls:
        line, kind = 1 + text.count("\n", 0, call.start(1)), _KINDS[_ADDED.index(call[1])]
        for path in sorted((package.folder / kind).glob(f"*.{kind}")) if len(calls) == len({one[1] for one in calls}) else ():
            if "${" not in call[2] and not package.unsure and not package.brings(f"share/{package.name}/{kind}/{path.name}"):
                yield Defect(cmake, line, "interface left out", f"{package.name}/{path.stem}")
    if calls and not re.search(r"\bgenerate_messages\s*\(", text) and not package.unsure:
        yield Defect(cmake, 1 + text.count("\n", 0, calls[0].start(1)), "interfaces not made", "")


def _of_interface(package: Built, cmake: Path, line: int, path: Path, *, known: bool) -> Iterator[Defect]:
    name = f"{path.parent.name}/{path.name}"
    if not package.brings(f"share/{package.name}/{name}"):
        if known and not package.unsure:
            yield Defect(cmake, line, "interface left out", f"{package.name}/{path.stem}")
        return
    for number, written in enumerate(text_or_nothing(path).splitlines(), 1):
        field = _FIELD.match(written)
        if field is not None and not field[2] and not _FIELD_NAME.fullmatch(field[1]):
            yield Defect(path, number, "field name", field[1])


def _of_script(package: Built, program: str, ros: int) -> Iterator[Defect]:
    """A script that the system cannot run.

    Its first line names no interpreter, or one that ends in a carriage return; it is in Python 2, which ROS 2 and python3 do not run.
    """
    for path in _files_called(package.folder, program):
        data = read_file(path) if os.path.isfile(path) else b""
        first = data.split(b"\n", 1)[0]
        if not first.startswith(b"#!"):
            yield Defect(path, 1, "no interpreter", program)
        elif first.endswith(b"\r"):
            yield Defect(path, 1, "carriage return", program)
        elif ros == 2 or b"python3" in first:
            yield from (Defect(path, line, "python 2", program) for line in _python2(data))
        yield from _of_imports(package, path, data.decode("utf-8", "replace"))


def _of_imports(package: Built, path: Path, text: str) -> Iterator[Defect]:
    """Modules of its own package that a script imports in vain: it has the name itself, or the build does not set them up."""
    found = re.search(rf"^(?:from|import)[ \t]+{re.escape(package.name)}\b", text, re.MULTILINE)
    if found is None or path.parent.name == package.name:
        return
    line = 1 + text.count("\n", 0, found.start())
    modules = package.folder / "src" / package.name
    cmake = without_comments(package.folder / "CMakeLists.txt")
    if path.stem == package.name:
        yield Defect(path, line, "hides its package", path.name)
    elif (
        package.build_type == "catkin"
        and not package.unsure
        and os.path.isfile(modules / "__init__.py")
        and "catkin_python_setup" not in cmake
    ):
        yield Defect(path, line, "modules not set up", package.name)


def _python2(data: bytes) -> Iterator[int]:
    """The line of the first statement that only Python 2 has."""
    try:
        parse_python(data)
    except SyntaxError as error:
        if re.match(r"Missing parentheses in call to|multiple exception types must be parenthesized", error.msg):
            yield error.lineno or 1


@lru_cache(maxsize=1024)
def _files_called(folder: Path, name: str) -> tuple[Path, ...]:
    """The scripts of Python of this name in a package."""
    found = []
    for here, folders, names in os.walk(folder):
        folders[:] = [one for one in folders if not one.startswith(".") and one not in NO_PACKAGES and not _is_package(here, one)]
        if name in names and name.endswith(".py"):
            found.append(Path(here, name))
    return tuple(found) if len(found) == 1 else ()


def _is_package(folder: str, name: str) -> bool:
    return os.path.isfile(os.path.join(folder, name, "package.xml"))


def _of_setup(package: Built, program: str) -> Iterator[Defect]:
    """Programs that are installed where nobody looks for them, since `setup.cfg` does not say where."""
    if package.build_type != "ament_python" or program not in {one.name for one in package.entry_points if one.is_command}:
        return
    if "install_scripts" in text_or_nothing(package.folder / "setup.py"):
        return
    config = package.folder / "setup.cfg"
    text = text_or_nothing(config)
    reader = configparser.ConfigParser(interpolation=None)
    try:
        reader.read_string(text)
    except configparser.Error:
        return  # that is reported where it is read
    given = reader.get("install", "install_scripts", fallback=None) or reader.get("install", "install-scripts", fallback=None)
    if given is None or given.strip().rstrip("/") != f"$base/lib/{package.name}":
        line = next((n for n, written in enumerate(text.splitlines(), 1) if re.match(r"install[-_]scripts", written)), 1)
        yield Defect(config if os.path.isfile(config) else package.folder / "setup.py", line, "programs elsewhere", f"lib/{package.name}")


def _of_launch_files(composition: Composition, builds: Sequence[Built]) -> Iterator[tuple[str, Defect]]:
    """Launch files in a folder of a package from which its build, of which all is known, installs nothing."""
    told = [one for one in builds if one.build_type in INSTALLED_FIRST and not one.unsure]
    for file in sorted({node.lines[0].path for node in composition.nodes if node.lines}):
        package = package_of(file, told)
        if package is not None and os.path.dirname(file) != str(package.folder):
            path = os.path.relpath(file, package.folder)
            folder = os.path.dirname(path)
            beside = (f"{folder}/{name}" for name in os.listdir(os.path.dirname(file)))
            share = f"share/{package.name}"
            if not any(package.brings(f"{share}/{one}") or package.brings(f"{share}/{os.path.basename(one)}") for one in beside):
                build = "setup.py" if package.build_type == "ament_python" else "CMakeLists.txt"
                yield package.name, Defect(package.folder / build, 1, "launch file left out", path)
