"""What the manifests of a workspace declare, and what its files show that packages need, as rows of `rules/schema/manifests.dl`."""

from __future__ import annotations

import os
import re
import sys
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from glob import escape, glob
from pathlib import Path
from typing import Any

from rosarch.base.files import read_file, text_or_nothing
from rosarch.base.xml_reader import XmlError, read_tree
from rosarch.extractor.launch.facts import path_below
from rosarch.extractor.launch.model import Composition, PackageNamed
from rosarch.extractor.package_names import NO_PACKAGES, name_in, quick_text, without_comments
from rosarch.extractor.workspace.built import package_of

_DEPENDENCY = re.compile(r"<(\w*depend)[^<>]*>\s*([^<\s]+)\s*</")

# at the first column: an import below a `try` or a condition may be one that the package can do without
_IMPORT = re.compile(
    r"^(?:from[ \t]+([A-Za-z]\w*)((?:\.\w+)*)[ \t]+import\b|import[ \t]+([A-Za-z][\w.]*)[ \t]*(?:as\b.*|#.*)?$)", re.MULTILINE
)
_TEXT = re.compile(r'"""(?:[^"\\]|\\.|"(?!""))*"""|\'\'\'(?:[^\'\\]|\\.|\'(?!\'\'))*\'\'\'', re.DOTALL)
_INCLUDE = re.compile(r'[ \t]*#[ \t]*(?:(?P<opens>if\w*)|(?P<closes>endif)|include[ \t]*[<"](?P<name>[a-z]\w*)/)')
_FORMAT = re.compile(r"<package\s[^<>]*\bformat\s*=\s*[\"'](\d)[\"']")
_METAPACKAGE = re.compile(r"<metapackage\s*/?>")
_FILE = re.compile(r"\$\(find\s+([\w-]+)\)|\bpackage://([\w-]+)/")
_MESSAGES = re.compile(r"_(?:msgs|srvs|interfaces|actions)$")
_INTERFACES = frozenset({"msg", "srv", "action"})
_COMPILED = (".cpp", ".cc", ".cxx")
_SOURCES = (*_COMPILED, ".hpp", ".h", ".hh")
_LISTED_BY_PATTERN = re.compile(r"\bGLOB|aux_source_directory|[*}][\w./-]*\.(?:cpp|cc|cxx)\b", re.IGNORECASE)
_TESTS = ("test_dep", "doc_dep", "group_dep", "member_of")
_OTHER_USE = NO_PACKAGES | {"doc", "docs", "build", "cmake"}


@dataclass(frozen=True)
class Need:
    """What a file of a package uses: the module or package `name`; `how` is code, interfaces, header or file."""

    name: str
    how: str
    path: str
    line: int


@dataclass(frozen=True)
class Declared:
    """What the manifest of a package in `folder` declares, by the `format` of REP 149; `line` is that of its last dependency.

    `kinds` are the kinds of its dependencies, each with the line of the last one, `aside` those that are only in a comment, `after` the
    lines of the dependencies that it is built or used with, not only tested.
    `needs` have no dependency of their name. `is_meta`: it is a metapackage. `flaws` keep it from being built: each has its line, its kind
    and what it is about.
    """

    name: str
    folder: str
    format: int
    line: int
    kinds: tuple[tuple[str, int], ...]
    depends: frozenset[str]
    aside: frozenset[str]
    after: tuple[tuple[str, int], ...]
    needs: tuple[Need, ...]
    is_meta: bool = False
    flaws: tuple[tuple[int, str, str], ...] = ()


def declared(root: Path) -> tuple[Declared, ...]:
    """The manifests below `root`. Those that ignore markers hide are there, but nobody builds them: they need nothing."""
    from rosarch.extractor.workspace.manifests import find_manifests

    root = Path(os.path.abspath(root))  # launch files are compared with it by their absolute paths
    paths = find_manifests(root, [], ignored=True)
    folders = {os.path.dirname(path) for path in paths}
    built = set(find_manifests(root, []))
    found = [one for path in paths if (one := _read(path, folders, path in built)) is not None]
    first = {one.name: one for one in reversed(found)}  # of several of a name the first counts
    for one in (one for one in found if f"{one.folder}/package.xml" in built):
        other = first[one.name]
        if _built_together(one, other, folders, root):
            twice = (_line_of_name(other.folder), "name twice", os.path.relpath(one.folder, root))
            first[one.name] = replace(other, flaws=(*other.flaws, twice))
    return tuple(first.values())


def _built_together(one: Declared, other: Declared, folders: set[str], root: Path) -> bool:
    """Whether two packages of one name are in one workspace, below its folder `src`: a tool for one version of ROS finds both there."""
    above = os.path.relpath(os.path.commonpath((one.folder, other.folder)), root.parent)
    alone = all(str(upper) not in folders for package in (one, other) for upper in Path(package.folder).parents)
    return one.folder != other.folder and alone and "src" in Path(above).parts and _version(one) == _version(other)


def _version(one: Declared) -> int:
    from rosarch.extractor.workspace.manifests import ros_version

    return ros_version(Path(one.folder, "package.xml"))


def _line_of_name(folder: str) -> int:
    text = quick_text(f"{folder}/package.xml") or ""
    return 1 + text.count("\n", 0, text.find("<name>"))


def _read(path: str, folders: set[str], is_built: bool) -> Declared | None:
    text = quick_text(path)
    name = name_in(text or "")
    if text is None or name is None:
        return None  # where the package is read, that is reported
    found = [(match[1], match[2], 1 + text.count("\n", 0, match.start(2))) for match in _DEPENDENCY.finditer(text)]
    last = found[-1][2] if found else 1 + text.count("\n", 0, text.index("<name>"))
    depends = frozenset(dependency for _, dependency, _ in found)
    after = {dependency: line for tag, dependency, line in reversed(found) if not tag.startswith(_TESTS)}
    folder = os.path.dirname(path)
    aside = frozenset(match[2] for match in _DEPENDENCY.finditer(text_or_nothing(path))) - depends
    needs = tuple(_needs(folder, folders, depends | {name})) if is_built else ()
    kinds = {tag: line for tag, _, line in found}
    broken = _broken(path) if is_built else None
    given = _FORMAT.search(text)
    return Declared(
        name,
        folder,
        int(given[1]) if given else 1,
        last,
        tuple(kinds.items()),
        depends,
        aside,
        tuple(after.items()),
        needs,
        _METAPACKAGE.search(text) is not None,
        (broken,) if broken else (),
    )


def _broken(path: str) -> tuple[int, str, str] | None:
    """Where a manifest is no XML."""
    try:
        read_tree(read_file(path))
    except XmlError as error:
        return error.line, "manifest broken", error.message
    return None


def _needs(folder: str, packages: set[str], depends: frozenset[str]) -> Iterator[Need]:
    """The first use of each module and package in the sources and robot descriptions of a package, but for those that it depends on."""
    seen: set[str] = set()
    own: set[str] = set()
    found: list[Need] = []
    builds = glob(f"{escape(folder)}/cmake/*.cmake")
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and name not in _OTHER_USE and f"{here}/{name}" not in packages
        )
        own.update(folders)
        for name in sorted(names):
            own.add(name.partition(".")[0])
            if name == "CMakeLists.txt":
                builds.append(f"{here}/{name}")
            reader = next((reader for ends, reader in _READERS if name.endswith(ends)), None)
            if reader is not None and name != "setup.py":
                path = f"{here}/{name}"
                found += (Need(used, how, path, line) for used, how, line in reader(text_or_nothing(path)) if used not in depends)
    is_built = _building(builds)
    for need in found:
        if need.name not in own and need.name not in seen and is_built(need.path):
            seen.add(need.name)
            yield need


def _building(files: Sequence[str]) -> Callable[[str], bool]:
    """Whether CMake may build a source: none that its `files` do not mention, unless they name no sources or name some by a pattern."""
    text = "\n".join(map(text_or_nothing, files))
    if not text or _LISTED_BY_PATTERN.search(text):
        return lambda _: True
    words = frozenset(re.findall(r"\w+", text))
    return lambda path: not path.endswith(_COMPILED) or words.issuperset(re.findall(r"\w+", os.path.basename(path).rpartition(".")[0]))


_Use = tuple[str, str, int]
"""A name, how it is used, and the line."""


def _of_python(text: str) -> Iterator[_Use]:
    text = _TEXT.sub(lambda found: "\n" * found[0].count("\n"), text)
    for match in _IMPORT.finditer(text):
        module, _, rest = match[3].partition(".") if match[3] else (match[1], "", match[2][1:])
        if module not in sys.stdlib_module_names:
            yield module, "interfaces" if rest.partition(".")[0] in _INTERFACES else "code", 1 + text.count("\n", 0, match.start())


def _of_cpp(text: str) -> Iterator[_Use]:
    """Headers that are included under no condition but the guard of the file."""
    depth = guard = 0
    for number, line in enumerate(text.split("\n"), 1):
        match = _INCLUDE.match(line)
        if match is None:
            continue
        if match["opens"]:
            depth += 1
            guard = 1 if match["opens"] == "ifndef" and depth == 1 and guard == 0 else guard
        elif match["closes"]:
            depth -= 1
        elif depth <= guard:
            yield match["name"], "header", number


def _of_description(text: str) -> Iterator[_Use]:
    text = without_comments(text)
    for match in _FILE.finditer(text):
        yield match[1] or match[2], "file", 1 + text.count("\n", 0, match.start())


_READERS = ((".py", _of_python), ((".xacro", ".urdf"), _of_description), (_SOURCES, _of_cpp))


def manifest_rows(
    composition: Composition, manifests: Sequence[Declared], root: Path, known: Collection[str]
) -> Mapping[str, set[tuple[Any, ...]]]:
    """The rows about one composition: of the packages whose launch files it reads, and of all whose sources need more than they say.

    `known` are the packages of the library.
    """
    rows: dict[str, set[tuple[Any, ...]]] = defaultdict(set)
    top = os.path.abspath(root)
    by_name = {one.name: one for one in manifests}
    there = {*by_name, *known}

    def place(one: Declared, line: int, path: str | None = None) -> str:
        shown = path_below(top, path or f"{one.folder}/package.xml")
        rows["place"].add((f"{shown}:{line}:1", shown, line, 1))
        return f"{shown}:{line}:1"

    wanted = {one for one in manifests if one.needs}
    for path in {*(named.place.path for named in composition.references), *(node.lines[-1].path for node in composition.nodes)}:
        holder = package_of(path, manifests)
        if holder is not None:
            rows["launch_file_of"].add((path_below(top, path), holder.name))
            wanted.add(holder)
    for one in wanted:
        rows["package_manifest"].add((one.name, place(one, one.line)))
        rows["manifest_format"].add((one.name, one.format))
        rows["manifest_kind"].update((one.name, kind, place(one, line)) for kind, line in one.kinds)
        rows["package_set_aside"].update((one.name, dependency) for dependency in one.aside)
        needs = [need for need in one.needs if need.how != "header" or need.name in there or _MESSAGES.search(need.name)]
        rows["package_needs"].update((place(one, need.line, need.path), one.name, need.name, need.how) for need in needs)
        rows["package_known"].update((name,) for name in (*(need.name for need in needs), *one.depends) if name in there)
    named = {named.package for named in composition.references if isinstance(named, PackageNamed)}
    used = named | {need.name for one in wanted for need in one.needs}
    for one in _with_dependencies(wanted | {by_name[name] for name in used if name in by_name}, by_name):
        rows["package_depends"].update((one.name, dependency) for dependency in one.depends)
    for one in wanted:
        rows["package_after"].update((one.name, name, place(one, line)) for name, line in one.after)
        rows["package_is_meta"].update((name,) for name in (one.name, *one.depends) if name in by_name and by_name[name].is_meta)
    for one in manifests:
        rows["build_defect"].update((place(one, line), one.name, kind, about) for line, kind, about in one.flaws)
    for number, one in enumerate(_unordered(by_name)):
        rows["package_unordered"].update((one.name, name, place(one, line), number) for name, line in one.after if name in by_name)
    return rows


def _with_dependencies(wanted: Iterable[Declared], by_name: Mapping[str, Declared]) -> set[Declared]:
    """Those packages, and all of the workspace that they depend on, however indirectly."""
    found: set[Declared] = set()
    waiting = list(wanted)
    while waiting:
        one = waiting.pop()
        if one not in found:
            found.add(one)
            waiting += (by_name[name] for name in one.depends if name in by_name)
    return found


def _unordered(by_name: Mapping[str, Declared]) -> list[Declared]:
    """The packages that are left when, again and again, those are taken away whose dependencies were."""
    left = dict(sorted(by_name.items()))
    while True:
        ready = [name for name, one in left.items() if not any(other in left for other, _ in one.after)]
        if not ready:
            return list(left.values())
        for name in ready:
            del left[name]
