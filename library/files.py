"""What others include of a package, as data: launch files, parameters, interfaces, robot descriptions.

Below `ros1/share` and `ros2/share` there is a folder for each package, laid out as where it is installed: it is found and read like one. No
code is in it: a launch file of Python is the description that it makes, files of XML and YAML and interfaces are what their parsers keep.
`origin.yaml` says where all that is from.
"""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import yaml

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import path_below, read_file
from rosarch.base.whole import write_whole
from rosarch.base.xml_reader import XmlError, read_tree
from rosarch.base.yaml_loader import BoundedLoader
from rosarch.extractor.launch.files import DESCRIBED
from rosarch.extractor.launch_ros2.described import Describer, NotDescribedError
from rosarch.extractor.workspace.model import ROS2, Package
from rosarch.library.model import Source
from rosarch.library.reading import SHARE

ORIGIN = "origin.yaml"
_LARGEST = 200_000
"""Bytes of a file: worlds and descriptions that have more are data of one robot."""
_XML = (".launch", ".xml", ".urdf", ".xacro", ".sdf", ".world", ".model")
_YAML = (".yaml", ".yml", ".rviz")
_INTERFACES = (".msg", ".srv", ".action")
_LEFT_OUT = frozenset({"test", "tests", "doc", "docs", "build", "install", "node_modules", "maps", "resource"})
_NAMESPACES = {"xacro": "http://www.ros.org/wiki/xacro"}
_SET_BY_BUILD = re.compile(r"@\w+@")


def write_files(packages: Iterable[Package], root: Path, source: Source, out: Path) -> tuple[list[Path], list[Diagnostic]]:
    """Write what others include of packages below `root` to `out`; the files written, and why others are left out."""
    describer = Describer(root)
    written: list[Path] = []
    problems: list[Diagnostic] = []
    for package in packages:
        files = dict(_files(package, describer, problems))
        if not files:
            continue
        files["package.xml"] = _manifest(package)
        files[ORIGIN] = _dumped(
            {**_head(package), "origin": source.origin, "revision": source.revision, "distributions": list(source.distributions)}
        )
        for name, text in files.items():
            path = path_below(out, f"ros{_ros(package)}", SHARE, package.name, *name.split("/"))
            write_whole(path, text.encode("utf-8", "backslashreplace"))
            written.append(path)
    return written, problems


def _head(package: Package) -> dict[str, object]:
    return {
        "package": package.name,
        "version": package.version,
        "licence": list(_licences(package)),
        "ros": _ros(package),
    }


def _ros(package: Package) -> int:
    return 2 if package.middleware == ROS2 else 1


def _licences(package: Package) -> Iterator[str]:
    for element in read_tree(read_file(package.manifest)).findall("license"):
        yield " ".join((element.text or "").split())


def _manifest(package: Package) -> str:
    """The part of the manifest that says what a package needs."""
    root = ElementTree.Element("package", format="3")
    for tag, text in (("name", package.name), ("version", package.version or "0.0.0"), *(("depend", name) for name in package.depends)):
        ElementTree.SubElement(root, tag).text = text
    export = ElementTree.SubElement(root, "export")
    ElementTree.SubElement(export, "build_type").text = package.build_type
    return _serialized(root)


def _files(package: Package, describer: Describer, problems: list[Diagnostic]) -> Iterator[tuple[str, str]]:
    """The paths and contents of what is kept of a package."""
    for path in sorted(_below(package.path)):
        relative = path.relative_to(package.path)
        try:
            text = _kept(path, relative, describer)
        except (OSError, XmlError, yaml.YAMLError, NotDescribedError, ValueError, RecursionError) as error:
            problems.append(Diagnostic("library", path, 1, 1, f"left out: {str(error).splitlines()[0]}"))
            continue
        name = None if text is None else _installed_as(package, path)
        if text is not None and name is not None:
            yield (f"{name}{DESCRIBED}" if name.endswith(".py") else name), text


def _installed_as(package: Package, path: Path) -> str | None:
    """Where a file is below the share folder of its package; None when it is known not to be there."""
    if path.suffix in _INTERFACES:
        return f"{path.suffix[1:]}/{path.name}"
    share = f"share/{package.name}/"
    for install in package.installs:
        if install.folder and path.is_relative_to(install.source):
            there = posixpath.normpath(posixpath.join(install.path, path.relative_to(install.source).as_posix()))
        else:
            there = install.path if path == install.source else ""
        if there.startswith(share) and install.brings(there):
            return there.removeprefix(share).removesuffix(".in")
    is_known = any(install.path.startswith(share) and install.source != package.manifest for install in package.installs)
    if is_known and not package.unsure and not path.name.endswith(".in"):
        return None
    return path.relative_to(package.path).as_posix().removesuffix(".in")


def _below(folder: Path) -> Iterator[Path]:
    for here, folders, names in os.walk(folder):
        inner = (name for name in folders if not name.startswith(".") and name not in _LEFT_OUT)
        folders[:] = sorted(name for name in inner if not os.path.isfile(os.path.join(here, name, "package.xml")))
        for name in names:
            path = Path(here, name)
            if not path.is_symlink() and path.stat().st_size <= _LARGEST:
                yield path


def _kept(path: Path, relative: Path, describer: Describer) -> str | None:
    """What is kept of a file; None when it is of no kind that others include."""
    name = path.name.removesuffix(".in")
    if len(relative.parts) == 1 and not name.endswith((".launch", *_INTERFACES)):
        return None
    text = read_file(path).decode(errors="replace")
    if path.name.endswith(".in"):
        text = _SET_BY_BUILD.sub("", text)
    if name.endswith(".py"):
        return describer.described(str(path), text) if "launch" in name or "launch" in relative.parts[:-1] else None
    if name.endswith(_INTERFACES):
        return "".join(f"{line}\n" for line in map(_without_comment, text.splitlines()) if line)
    if name.endswith(_XML):
        return _serialized(read_tree(text))
    if name.endswith(_YAML):
        return _dumped(yaml.load(text, BoundedLoader))
    return None


def _without_comment(line: str) -> str:
    """A line of an interface; a text constant may hold a `#`."""
    return line.rstrip() if re.match(r"\s*w?string\s+\w+\s*=", line) else line.partition("#")[0].rstrip()


def _serialized(root: ElementTree.Element) -> str:
    """XML without comments, and without space that only indents; prefixes are declared where it begins."""
    names = [name for element in root.iter() for name in (element.tag, *element.attrib)]
    for prefix in sorted({name.partition(":")[0] for name in names if ":" in name} - {"xmlns", "xml"}):
        root.attrib.setdefault(f"xmlns:{prefix}", _NAMESPACES.get(prefix, prefix))
    for element in root.iter():
        for attribute in ("text", "tail"):
            if not (getattr(element, attribute) or "").strip():
                setattr(element, attribute, None)
    ElementTree.indent(root, " ")
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def _dumped(value: object) -> str:
    return yaml.dump(value, Dumper=yaml.SafeDumper, sort_keys=False, allow_unicode=True, width=140)
