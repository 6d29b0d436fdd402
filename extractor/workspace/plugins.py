"""Plug-in descriptions: nodelet and pluginlib XML files, and the macros in C++ sources that register classes.

Sources: https://wiki.ros.org/pluginlib, https://wiki.ros.org/nodelet, http://gazebosim.org/tutorials?tut=plugins_hello_world,
https://gazebosim.org/api/plugin (IGNITION_ before GZ_ in Gazebo up to Fortress), https://www.behaviortree.dev/docs/intro.
Description files have one `<library>`, several of them below `<class_libraries>`, or (against the rules, but read by pluginlib's
predecessor) several roots.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic, unreadable
from rosarch.base.files import LARGEST_PARSED, read_file, text_or_nothing
from rosarch.base.xml_reader import XmlError, read_tree
from rosarch.extractor.workspace.manifests import Manifest
from rosarch.extractor.workspace.model import PluginClass


def read_plugins(exports: Iterable[tuple[str, Path]], manifest: Manifest) -> tuple[list[PluginClass], list[Diagnostic]]:
    """The classes that description files declare."""
    classes: list[PluginClass] = []
    problems: list[Diagnostic] = []
    for base_package, path in dict.fromkeys(exports):
        try:
            text = read_file(path, LARGEST_PARSED).decode(errors="replace")
        except FileNotFoundError:
            message = f"plug-in description {path.name} for {base_package} does not exist"
            problems.append(Diagnostic("missing-plugin-file", manifest.path, 1, 1, message))
            continue
        except OSError as error:
            problems.append(unreadable(path, error))
            continue
        found, problem = parse_plugins(text, path)
        classes.extend(found)
        problems.extend(problem)
    return classes, problems


_DECLARATION = re.compile(r"^\s*<\?xml.*?\?>", re.DOTALL)
_VALUE = re.compile(r"""(?<==)\s*(?:"[^"]*"|'[^']*')""")
"""The value of an attribute: those who load plug-ins accept `<` in it, as in filters::FilterBase<T>."""


def parse_plugins(text: str, path: Path) -> tuple[list[PluginClass], list[Diagnostic]]:
    """The classes of one description file."""
    body = _DECLARATION.sub(lambda match: "\n" * match.group().count("\n"), text)
    body = _VALUE.sub(lambda match: match.group().replace("<", "&lt;"), body)
    try:
        root = read_tree(f"<several>{body}</several>")
    except XmlError as error:
        return [], [Diagnostic("plugin-xml", path, error.line, error.column, error.message)]
    result: list[PluginClass] = []
    for library in root.iter("library"):
        file = (library.get("path") or "").strip()
        for element in library.iter("class"):
            cxx = (element.get("type") or "").strip()
            name = (element.get("name") or cxx).strip()
            base = (element.get("base_class_type") or element.get("base_class") or "").strip()
            if cxx or name:
                result.append(PluginClass(name, cxx or name.replace("/", "::"), base, file, path, _line(text, cxx or name)))
    return result, []


def _line(text: str, word: str) -> int:
    place = text.find(f'"{word}"')
    return text.count("\n", 0, place) + 1 if place >= 0 else 1


@dataclass(frozen=True, slots=True)
class Registration:
    """A registration macro in a source file. A simulator loads its class by the file of the library, not by a name."""

    cxx_class: str
    base: str
    path: Path
    line: int
    name: str | None = None
    simulated: bool = False


_CODE_COMMENT = re.compile(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_MACRO = re.compile(
    r"^[ \t]*(PLUGINLIB_EXPORT_CLASS|PLUGINLIB_DECLARE_CLASS|PLUGINLIB_REGISTER_CLASS|CLASS_LOADER_REGISTER_CLASS|"
    r"NODELET_DECLARE_CLASS|RCLCPP_COMPONENTS_REGISTER_NODE|"
    r"GZ_REGISTER_(?:MODEL|WORLD|SENSOR|SYSTEM|VISUAL|GUI)_PLUGIN|(?:IGNITION|GZ)_ADD_PLUGIN)\s*\(([^;{]*?)\)",
    re.MULTILINE,
)


TREE_NODE = "BT::TreeNode"
"""The base of the nodes of behavior trees (https://www.behaviortree.dev), which libraries register under the names that trees use."""
REGISTERS_TREE_NODES = ("BT_RegisterNodesFromPlugin", "BT_RegisterRosNodeFromPlugin")
"""The functions of a library that register them: those of `BT_REGISTER_NODES` and of `CreateRosNodePlugin` of BehaviorTree.ROS2."""
_TREE_NODE = re.compile(
    r"\b(?:register(?:NodeType|Builder)\s*<\s*([\w:]+)\s*>\s*\(|CreateRosNodePlugin\s*\(\s*([\w:]+)\s*,)\s*\"([^\"\n]+)\""
)


def registrations(path: Path) -> list[Registration]:
    """The plug-in classes a source file registers, comments ignored."""
    return _registrations(text_or_nothing(path), path)  # one that cannot be read is reported where it is parsed


def _registrations(text: str, path: Path) -> list[Registration]:
    of_tree = any(word in text for word in ("BT_REGISTER_NODES", "CreateRosNodePlugin", *REGISTERS_TREE_NODES))
    if not of_tree and not any(word in text for word in ("_CLASS", "RCLCPP_COMPONENTS", "_PLUGIN")):
        return []
    text = _CODE_COMMENT.sub(_blank, text)
    found = [found for match in _MACRO.finditer(text) if (found := _registration(match, text, path))]
    for match in _TREE_NODE.finditer(text) if of_tree else ():
        line = text.count("\n", 0, match.start()) + 1
        found.append(Registration(_plain(match.group(1) or match.group(2)), TREE_NODE, path, line, match.group(3)))
    return found


_INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[ \t]*[\"<]([^\">\n]+)[\">]", re.MULTILINE)
_OTHER_MACRO = re.compile(
    r"\b(?!PLUGINLIB_|CLASS_LOADER_REGISTER_CLASS\b|RCLCPP_COMPONENTS_REGISTER_NODE\b|NODELET_|GZ_|IGNITION_)\w*(?:REGISTER|EXPORT_CLASS)\w*\s*\("
)
_MADE_OTHERWISE = re.compile(r"NodeFactory|class_loader::|#\s*include\s*[<\"][^>\"]+\.(?:c|cc|cpp|cxx|inc|def)[>\"]")


def included_names(source: Path) -> list[str]:
    """The names of the headers that a source file includes, without their folders."""
    return [name.rpartition("/")[2] for name in _INCLUDE.findall(text_or_nothing(source))]


@dataclass(frozen=True)
class Scan:
    """What a source file registers and includes, and whether it may register something in another way."""

    registrations: tuple[Registration, ...] = ()
    includes: tuple[str, ...] = ()
    may_be_more: bool = True


class Scans:
    """What the sources of packages register, each read once."""

    def __init__(self) -> None:
        self._of_files: dict[Path, Scan] = {}
        self._headers: dict[tuple[Path, tuple[Path, ...]], tuple[Path, ...]] = {}

    def of(self, path: Path) -> Scan:
        """What is in a file."""
        if path not in self._of_files:
            self._of_files[path] = _scan(path)
        return self._of_files[path]

    def own_headers(self, source: Path, folders: Iterable[Path], package: Path) -> tuple[Path, ...]:
        """The headers of the `package` that a source includes itself, from its own folder or `folders`: they may register its classes."""
        places = tuple(place for place in dict.fromkeys((source.parent, *folders)) if place.is_relative_to(package))
        if (source, places) not in self._headers:
            found = (next((path for place in places if os.path.isfile(path := place / name)), None) for name in self.of(source).includes)
            self._headers[source, places] = tuple(path for path in found if path is not None)
        return self._headers[source, places]


def _scan(path: Path) -> Scan:
    try:
        text = read_file(path).decode(errors="replace")
    except OSError:
        return Scan()
    may_be_more = _OTHER_MACRO.search(text) is not None or _MADE_OTHERWISE.search(text) is not None
    return Scan(tuple(_registrations(text, path)), tuple(_INCLUDE.findall(text)), may_be_more)


def _blank(match: re.Match[str]) -> str:
    found = match.group()
    return found if found.startswith('"') else "\n" * found.count("\n") or " "


def _registration(match: re.Match[str], text: str, path: Path) -> Registration | None:
    words = [word.strip() for word in match.group(2).split(",")]
    line = text.count("\n", 0, match.start(1)) + 1
    macro = match.group(1)
    if macro == "RCLCPP_COMPONENTS_REGISTER_NODE":
        return Registration(_plain(words[0]), "rclcpp_components", path, line)
    if macro.endswith("_PLUGIN"):
        kind = macro.split("_")[2].capitalize()
        base = f"gazebo::{kind}Plugin" if macro.startswith("GZ_REGISTER") else _plain(words[1] if len(words) > 1 else "")
        return Registration(_plain(words[0]), base, path, line, simulated=True)
    if len(words) == 2:
        return Registration(_plain(words[0]), _plain(words[1]), path, line)
    if len(words) == 4:
        return Registration(_plain(words[2]), _plain(words[3]), path, line, f"{words[0]}/{words[1]}")
    if len(words) == 3:
        return Registration(_plain(words[1]), _plain(words[2]), path, line, words[0])
    return None


def _plain(name: str) -> str:
    return re.sub(r"\s+", "", name).removeprefix("::")
