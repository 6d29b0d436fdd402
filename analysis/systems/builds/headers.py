"""Headers that the build makes of a package's own interfaces and configurations."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.analysis.systems.builds.sources import included_in, without_comments
from rosarch.base.files import text_or_nothing
from rosarch.extractor.workspace.built import Built
from rosarch.extractor.workspace.model import TEST, Target

_CONFIGURES = re.compile(r"\.generate\s*\([^()]*[\"'](\w+)[\"']\s*\)")
_MADE_FIRST = re.compile(r"EXPORTED_TARGETS|_generate_messages|_gencpp")


@lru_cache(maxsize=256)
def of_own_headers(package: Built) -> tuple[Defect, ...]:
    """Headers that the build makes of a package's own interfaces and parameters, where they are not made, or not for certain in time."""
    own = {"catkin": _made_by_catkin, "ament_cmake": _made_by_rosidl}.get(package.build_type)
    if own is None or package.unsure:
        return ()
    return tuple(defect for target in package.targets if target.kind != TEST for defect in own(package, target))


def _made_by_rosidl(package: Built, target: Target) -> Iterator[Defect]:
    """A target that is not linked with what is made of the interfaces it includes; that others are may be how it gets them."""
    included = _own_header(package, target, r"(?:msg|srv|action)/(\w+)\.hpp")
    links = any("__rosidl_" in link for one in package.targets for link in one.links)
    linking = package.called("rosidl_get_typesupport_target", "rosidl_target_interfaces", "ament_auto_find_build_dependencies")
    if included is not None and package.called("rosidl_generate_interfaces") and not links and not linking:
        yield Defect(target.cmake_file, target.line, "own interfaces", target.name)


def _made_by_catkin(package: Built, target: Target) -> Iterator[Defect]:
    included = _own_header(package, target, r"(\w+)Config\.h")
    if included is not None and included[2] not in _configurations(package):
        yield Defect(included[0], included[1], "configuration not made", f"{package.name}/{included[2]}Config.h")
    included = _own_header(package, target, r"(\w+)\.h")
    made = {path.stem for path in package.interfaces}
    text = without_comments(package.folder / "CMakeLists.txt")
    if included is not None and re.sub("Request$|Response$", "", included[2]) in made and not _MADE_FIRST.search(text):
        yield Defect(target.cmake_file, target.line, "interfaces later", target.name)


def _configurations(package: Built) -> set[str]:
    """The names of the configurations that the build generates."""
    return {name for path in package.configurations for name in _CONFIGURES.findall(text_or_nothing(path))}


def _own_header(package: Built, target: Target, pattern: str) -> tuple[Path, int, str] | None:
    """Where the sources of a target include a header of their package whose name, below it, matches: the first place."""
    for path in target.sources:
        for name, line in included_in(str(path)):
            found = re.fullmatch(rf"{re.escape(package.name)}/{pattern}", name)
            if found is not None and not os.path.isfile(package.folder / "include" / name):
                return path, line, found[1]
    return None
