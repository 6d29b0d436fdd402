"""What targets of CMake include and are given, as rows of `rules/schema/build.dl`: headers of packages, those of their own interfaces."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from rosarch.analysis.systems.builds.sources import included_in, without_comments
from rosarch.base.files import text_or_nothing
from rosarch.extractor.workspace.built import Built
from rosarch.extractor.workspace.model import EXECUTABLE, MODULE, SCOPES, SHARED, STATIC, Target

_INTERFACES = re.compile(r"_(?:msgs|srvs|interfaces|actions)$")
_TYPE = re.compile(r"[ \t]*([A-Za-z]\w*)/[A-Z]\w*(?:\[[^\]]*\])?[ \t]+\w")
_NAMED = re.compile(r"\$\{(\w+)_(?:INCLUDE(?:_DIR)?S|TARGETS|LIBRARIES)\}")
_OPTIONS = frozenset({"LIBRARY_NAME", "ADD_LINTER_TESTS", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"})
_OTHER_WAYS = re.compile(r"ament_auto|AMENT_|CPM|FetchContent|include_directories\s*\(\s*(?:SYSTEM\s+)?/")


@dataclass(frozen=True)
class Use:
    """At `line` of `path` the package `used` is included by `target`, asked for ("": by none), or named in an interface."""

    path: Path
    line: int
    target: str
    used: str


@dataclass(frozen=True)
class Uses:
    """What the targets and interfaces of a package use, and what they are given; `given_at` is where a target is."""

    includes: tuple[Use, ...] = ()
    given: frozenset[tuple[str, str]] = frozenset()
    given_at: tuple[tuple[str, Path, int], ...] = ()
    asks: tuple[Use, ...] = ()
    finds: frozenset[str] = frozenset()
    interfaces: tuple[Use, ...] = ()
    interfaces_given: frozenset[str] = frozenset()


@lru_cache(maxsize=256)
def uses(package: Built) -> Uses:
    """The uses of a package whose build files are understood and simple; of one of ROS 1 those of its interfaces, of any other none."""
    text = without_comments(package.folder / "CMakeLists.txt") if package.build_type == "ament_cmake" else ""
    if package.build_type not in ("ament_cmake", "catkin") or package.unsure or _OTHER_WAYS.search(text):
        return Uses()
    interfaces, told = _generated(package)
    if package.build_type == "catkin":
        return Uses(interfaces=interfaces, interfaces_given=told)
    targets = {one.name: one for one in package.targets if one.kind in (EXECUTABLE, SHARED, STATIC, MODULE)}
    named = _NAMED.findall(text)
    includes = [use for one in targets.values() for use in _included(package, one)]
    given = {(one.name, used) for one in targets.values() for used in (*_given(one, targets), *named)}
    asks = tuple(
        Use(call.path, call.line, "", name)
        for call in package.called("ament_target_dependencies")
        for name in call.words[1:]
        if call.words[0] in targets and "$" not in name and name not in SCOPES
    )
    asks += tuple(
        Use(call.path, call.line, "", name)
        for call in package.called("rosidl_generate_interfaces")
        for name in _dependencies(call.words)
        if "$" not in name and name != package.name
    )
    at = tuple((one.name, one.cmake_file, one.given_line) for one in targets.values())
    return Uses(tuple(includes), frozenset(given), at, asks, package.finds, interfaces, told)


def _generated(package: Built) -> tuple[tuple[Use, ...], frozenset[str]]:
    """What the interfaces of a package use, and what those who generate them are given; nothing is used where that is not known."""
    calls = package.called("rosidl_generate_interfaces", "generate_messages")
    told = frozenset(word for call in calls for word in _dependencies(call.words))
    return (tuple(_of_interfaces(package)) if calls and all(call.is_known for call in calls) else ()), told


def _dependencies(words: Sequence[str]) -> Sequence[str]:
    """The packages that a call which generates interfaces is given."""
    behind = itertools.takewhile(lambda word: word not in _OPTIONS, words[(*words, "DEPENDENCIES").index("DEPENDENCIES") + 1 :])
    return list(behind)


def _given(target: Target, targets: dict[str, Target]) -> Iterator[str]:
    """The packages that a target is given, by itself or by the libraries of its own package that it is linked with."""
    seen: set[str] = set()
    waiting = [target]
    while waiting:
        one = waiting.pop()
        if one.name not in seen:
            seen.add(one.name)
            yield from one.uses_packages
            yield from (link.partition("::")[0] for link in one.links)
            waiting += (targets[link] for link in one.links if link in targets)


def _included(package: Built, target: Target) -> Iterator[Use]:
    """The headers of other packages that the sources of a target include, under no condition, and those headers of its own that they do."""
    folders = [package.folder / "include", *target.include_dirs]
    waiting, seen = list(target.sources), set(target.sources)
    while waiting:
        path = waiting.pop()
        for name, line in included_in(str(path)):
            own = next((one for one in (path.parent / name, *(folder / name for folder in folders)) if os.path.isfile(one)), None)
            used = name.partition("/")[0]
            if own is not None:
                waiting += {own} - seen
                seen.add(own)
            elif "/" in name and (used in package.finds or _INTERFACES.search(used)) and used != package.name:
                yield Use(path, line, target.name, used)


def _of_interfaces(package: Built) -> Iterator[Use]:
    """The packages whose types the interfaces of a package have fields of."""
    for path in package.interfaces:
        for number, line in enumerate(text_or_nothing(path).split("\n"), 1):
            match = _TYPE.match(line)
            if match is not None and match[1] != package.name:
                yield Use(path, number, "", match[1])
