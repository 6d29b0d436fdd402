"""What the workspace has of what launch files name, as rows of `rules/schema/launch.dl`."""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from rosarch.analysis.systems.manifests import Declared
from rosarch.base.files import read_file
from rosarch.extractor.launch.facts import path_below, starts
from rosarch.extractor.launch.model import Composition, PackageNamed, ProgramNamed
from rosarch.models.component import ComponentModel
from rosarch.models.system.rows import Rows

Dependencies = tuple[set[str], set[str]]
"""Packages that manifests depend on, and those that they are of."""

_SOURCES = (".c", ".cc", ".cpp", ".cxx", ".cu", ".h", ".hh", ".hpp", ".hxx", ".cuh", ".ipp", ".inl", ".cfg")
_TEXT_OR_COMMENT = re.compile(r'"((?:[^"\\\n]|\\.)*)"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_WORD = re.compile(r"\w+")
_SUBMODULE = re.compile(r"^[ \t]*path[ \t]*=[ \t]*(\S+)", re.MULTILINE)
_REPOSITORY = re.compile(r"^[ \t]+['\"]?([\w./-]+)['\"]?:[ \t]*$|\blocal-name:[ \t]*['\"]?([\w./-]+)", re.MULTILINE)
_LISTS = re.compile(r"\.gitmodules|.*\.(?:repos|rosinstall)")
_IMAGES = re.compile(r"(?:.*\.)?[Dd]ockerfile(?:\..*)?|(?:docker-)?compose\.ya?ml")
_HOME = re.compile(r"(?<![\w./-])/home/[\w.-]+")
_DEPTH_OF_LISTS = 2


def programs_named(compositions: Iterable[Composition]) -> set[tuple[str, str]]:
    """Package and type of the nodes in all branches that no file of the package is called like."""
    named = (reference for composition in compositions for reference in composition.references)
    return {(named.package, named.type) for named in named if isinstance(named, ProgramNamed) and not named.mentioned}


def workspace_rows(
    depends: Dependencies,
    compositions: Sequence[Composition],
    programs: Collection[tuple[str, str]],
    known: Collection[str],
    brought: Collection[str] = (),
    homes: Collection[str] = (),
) -> Rows:
    """Which programs and packages that launch files name there are, or are expected: those `known` or `brought`, and those needed here.

    `homes` are the home folders of containers.
    """
    named = (reference for composition in compositions for reference in composition.references)
    absent = {reference.package for reference in named if isinstance(reference, PackageNamed) and reference.folder is None}
    absent |= {problem.subject for composition in compositions for problem in composition.problems}
    shipped = {*known, *brought}
    depended, own = depends if absent - shipped else (set[str](), set[str]())
    expected = absent & (shipped | depended | own) | {package for package in absent if any(_names(path, package) for path in brought)}
    return {
        "program_built": set(programs),
        "package_expected": {(package,) for package in expected},
        "container_home": {(home,) for home in homes},
        "package_unknown": {(package,) for package in (depended | set(brought)) - set(known) - own},
    }


def _names(repository: str, package: str) -> bool:
    """Whether the name of a repository has that of a package in it, as whole words."""
    return f"_{package}_".replace("-", "_") in f"_{repository}_".replace("-", "_")


def first_rows(compositions: Iterable[Composition], root: Path) -> Rows:
    """Which packages launch files of the workspace name, which are not found, and the first file, by its name, that names one of these."""
    top = os.path.abspath(root)
    files = defaultdict(set)
    everywhere: set[tuple[str, str]] = set()
    for composition in compositions:
        everywhere |= {(one.package, path_below(top, one.place.path)) for one in composition.references if isinstance(one, PackageNamed)}
        named = {(one.package, one.place.path) for one in composition.references if isinstance(one, PackageNamed) and one.folder is None}
        named |= {(problem.subject, problem.place.path) for problem in composition.problems if problem.kind == "package"}
        for package, path in named:
            files[package].add(path_below(top, path))
    inside = {package: sorted(path for path in paths if not os.path.isabs(path)) for package, paths in files.items()}
    return {
        "package_named_somewhere": set(everywhere),
        "package_absent_somewhere": {(package,) for package in files},
        "package_first_named": {(package, paths[0]) for package, paths in inside.items() if paths},
    }


def fetched(root: Path) -> set[str]:
    """What git or vcstool brings into the workspace, which need not be there yet: what the paths in its lists end with.

    Lists (`.gitmodules`, `.repos`, `.rosinstall`) lie in the workspace or in a repository of it, or one folder further down.
    """
    found: set[str] = set()
    for name, text in _near_the_top(root, _LISTS):
        pattern = _SUBMODULE if name == ".gitmodules" else _REPOSITORY
        found.update(path.rstrip("/").rpartition("/")[2] for match in pattern.finditer(text) for path in match.groups() if path)
    return found


def container_homes(root: Path) -> set[str]:
    """The home folders that the images of containers have whose descriptions lie in the workspace, or one folder further down."""
    return {home for _, text in _near_the_top(root, _IMAGES) for home in _HOME.findall(text)}


def _near_the_top(root: Path, wanted: re.Pattern[str]) -> Iterator[tuple[str, str]]:
    """Name and text of the files called as wanted."""
    top = os.path.abspath(root)
    for here, folders, names in os.walk(top):
        deep = here.count(os.sep) - top.count(os.sep) >= _DEPTH_OF_LISTS
        folders[:] = [] if deep else sorted(name for name in folders if not name.startswith("."))
        for name in filter(wanted.fullmatch, names):
            with suppress(OSError):
                yield name, read_file(os.path.join(here, name)).decode("utf-8", "replace")


def dependencies(manifests: Iterable[Declared]) -> Dependencies:
    """All that manifests depend on, and their own packages: of these, only ignored ones are not found."""
    found = tuple(manifests)
    return set().union(*(one.depends for one in found)), {one.name for one in found}


def shared_rows(models: Sequence[ComponentModel]) -> Rows:
    """What all systems see of the workspace's components: their ports, and parameters that they read by absolute names."""
    return {
        "port_anywhere": {(model.title, port.kind, port.name) for model in models for port in model.ports if not port.implicit},
        "read_absolutely": {
            (parameter.name, model.title)
            for model in models
            for parameter in model.params
            if parameter.op == "read" and parameter.name.startswith("/")
        },
    }


def set_rows(compositions: Sequence[Composition], models: Sequence[ComponentModel]) -> Rows:
    """Which of the parameters that components read by absolute names the launch files set."""
    names = {name for name, _ in shared_rows(models)["read_absolutely"]}
    set_ = {setting.name for composition in compositions for setting in composition.params}
    return {"set_somewhere": {(name,) for name in names & {above for param in set_ for above in (param, *_namespaces(param))}}}


def container_rows(compositions: Sequence[Composition]) -> Rows:
    """Which of the nodes that launch files start may be what others are loaded into: by the last part of their name."""
    nodes = [found for composition in compositions for found in starts(composition)]
    named = {node.container or "" for _, node in nodes} | {word for _, node in nodes for word in node.args.split()}
    wanted = {name.rpartition("/")[2] for name in named}
    names = {start.partition("#")[0] for start, _ in nodes}
    return {"started_somewhere": {(name,) for name in names if name.rpartition("/")[2] in wanted}}


def _namespaces(name: str) -> Iterator[str]:
    """The namespaces that an absolute name is in, but for the outermost."""
    while (name := name.rpartition("/")[0]) != "":
        yield name


def words_said(root: Path, models: Sequence[ComponentModel]) -> dict[str, frozenset[str]]:
    """The words of all texts in the sources of each component's package, comments left out."""
    said: dict[str, frozenset[str]] = {}
    found: dict[str, frozenset[str]] = {}
    for model in models:
        folders = sorted({_package_folder(root, source) for source in model.sources})
        said.update((folder, _words_said(root / folder)) for folder in folders if folder not in said)
        # a script need not have the name of one
        scripts = [source for source in model.sources if not source.endswith(_SOURCES)]
        words = [*(said[folder] for folder in folders), *(frozenset(_words_of(str(root / source))) for source in scripts)]
        found[model.title] = words[0] if len(words) == 1 else frozenset[str]().union(*words)  # one object, kept once
    return found


def named_by(composition: Composition, rows: Rows) -> Rows:
    """Of what the workspace has of what some launch files name, what those of one composition name."""
    packages = {reference.package for reference in composition.references if isinstance(reference, PackageNamed)}
    packages |= {problem.subject for problem in composition.problems}
    return {
        **rows,
        **{name: {row for row in rows.get(name, ()) if row[0] in packages} for name in ("package_expected", "package_first_named")},
    }


def source_rows(composition: Composition, components: Iterable[str], said: Mapping[str, frozenset[str]]) -> Rows:
    """Which of the last words of parameters' names the sources of `components`, which say the words `said`, say."""
    words = {word for setting in composition.params for word in _WORD.findall(setting.name)[-1:]}
    return {"source_says": {(component, word) for component in components for word in words & said.get(component, frozenset())}}


def _package_folder(root: Path, source: str) -> str:
    """The folder with a manifest that `source` is in, relative to the root."""
    folders = Path(source).parents
    return str(next((folder for folder in folders if os.path.isfile(root / folder / "package.xml")), folders[0]))


def _words_said(folder: Path) -> frozenset[str]:
    """The words of all texts in the sources below a folder, comments left out."""
    found: set[str] = set()
    for here, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        for name in names:
            if name.endswith(_SOURCES):
                found.update(_words_of(os.path.join(here, name)))
    return frozenset(found)


def _words_of(source: str) -> Iterator[str]:
    try:
        text = read_file(source).decode(errors="replace")
    except OSError:
        return  # where it is analysed, that is reported
    for said in _TEXT_OR_COMMENT.findall(text):
        yield from _WORD.findall(said)
