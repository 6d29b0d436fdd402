"""Messages, services and actions that are not generated."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from functools import cache, lru_cache, partial
from pathlib import Path

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.base.files import text_or_nothing
from rosarch.extractor.package_names import quick_text
from rosarch.extractor.workspace.built import Built
from rosarch.extractor.workspace.installs import line_with

_ADDED = {"msg": "add_message_files", "srv": "add_service_files", "action": "add_action_files"}
_BEFORE_EXPORT = ("generate_messages", "generate_dynamic_reconfigure_options")
"""What stops CMake where catkin_package() was called before it, in all versions of genmsg and dynamic_reconfigure."""
_INTERFACE = re.compile(r"(?:msg|srv|action)/(\w+)\.(?:msg|srv|action)")
_FIELD = re.compile(r"[ \t]*([\w/]+)(?:<=\d+)?(?:\[(?:<=)?\d*\])?[ \t]+(\w+)[ \t]*(=?)")
_BASIC = re.compile(r"bool|byte|char|w?string|float(?:32|64)|u?int(?:8|16|32|64)")
_FIELD_NAME = re.compile(r"[a-z](?:_?[a-z0-9])*")
_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")


@lru_cache(maxsize=256)
def of_interfaces(package: Built) -> tuple[Defect, ...]:
    """What keeps the interfaces of a package from being generated."""
    own = {"catkin": _of_catkin, "ament_cmake": _of_rosidl}.get(package.build_type)
    return tuple(own(package)) if own is not None else ()


def _of_rosidl(package: Built) -> Iterator[Defect]:
    """Interfaces of ROS 2 that do not exist, that no call lists, that have no proper name, or a field without a proper name or type."""
    calls = package.called("rosidl_generate_interfaces")
    if not calls:
        return
    manifest = package.folder / "package.xml"
    if "rosidl_interface_packages" not in (quick_text(str(manifest)) or "rosidl_interface_packages"):
        yield Defect(manifest, 1, "interface group", "")
    for call in calls:
        for word in call.words[1:]:
            path = call.path.parent / word
            name = os.path.relpath(path, package.folder)
            if _INTERFACE.fullmatch(name) and not os.path.isfile(path):
                yield Defect(call.path, line_with(call.path, os.path.basename(word)), "interface file", name)
    known = not package.unsure and all(call.is_known for call in calls)
    own = cache(partial(_names_below, package.folder))
    for kind in _ADDED:
        for path in sorted((package.folder / kind).glob(f"*.{kind}")):
            if package.brings(f"share/{package.name}/{kind}/{path.name}"):
                if not _NAME.fullmatch(path.stem):
                    yield Defect(calls[0].path, line_with(calls[0].path, path.name), "interface name", f"{kind}/{path.name}")
                yield from _of_fields(path, own)
            elif known:
                yield Defect(calls[0].path, calls[0].line, "interface left out", f"{package.name}/{path.stem}")


def _of_catkin(package: Built) -> Iterator[Defect]:
    """Interfaces of ROS 1 that no call lists, and lists of which nothing is made."""
    if package.unsure:
        return
    for kind, command in _ADDED.items():
        calls = package.called(command)
        for path in sorted((package.folder / kind).glob(f"*.{kind}")) if calls and all(call.is_known for call in calls) else ():
            if not package.brings(f"share/{package.name}/{kind}/{path.name}"):
                yield Defect(calls[0].path, calls[0].line, "interface left out", f"{package.name}/{path.stem}")
    added = package.called(*_ADDED.values())
    if added and not package.called("generate_messages"):
        yield Defect(added[0].path, added[0].line, "interfaces not made", "")
    exports = package.called("catkin_package")
    for call in package.called(*_BEFORE_EXPORT) if len(exports) == 1 else ():
        if exports[0].is_known and call.is_known and call.path == exports[0].path and call.line > exports[0].line:
            yield Defect(call.path, call.line, "after catkin_package", call.name)


def _names_below(folder: Path) -> frozenset[str]:
    """The names of all files in a package, without their endings: an interface may be made in any way."""
    return frozenset(path.name.partition(".")[0] for path in folder.rglob("*.*"))


def _of_fields(path: Path, own: Callable[[], frozenset[str]]) -> Iterator[Defect]:
    for number, written in enumerate(text_or_nothing(path).splitlines(), 1):
        field = _FIELD.match(written)
        if field is None:
            continue
        if not field[3] and not _FIELD_NAME.fullmatch(field[2]):
            yield Defect(path, number, "field name", field[2])
        if "/" not in field[1] and not _BASIC.fullmatch(field[1]) and field[1] not in own():
            yield Defect(path, number, "field type", field[1])
