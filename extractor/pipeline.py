"""From a workspace to the facts of each component.

Translation units are read first, each once however many components share it, in worker processes; the facts of a
component are the union of those of its units.
"""

from __future__ import annotations

import errno
import marshal
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.extractor.cache import Cache, extractor_version
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, Problem, build_prelude, extract_unit, unit_key
from rosarch.extractor.cxx.unit import file_key, merge
from rosarch.extractor.facts import Rows, write_component
from rosarch.extractor.files import path_text
from rosarch.extractor.manifest import write_manifest
from rosarch.extractor.messages import MessageClass, header_text, load_messages, message_classes
from rosarch.extractor.pool import Failure, default_jobs, run_tasks
from rosarch.extractor.workspace import Component, Diagnostic, Workspace, components, discover, include_path, programs, without_library
from rosarch.extractor.workspace.compile_commands import CompileCommands, read_compile_commands
from rosarch.extractor.workspace.graph import BROUGHT

Progress = Callable[[str, int, int], None]
PRELUDE_BYTES = 64 << 20
"""More than the precompiled declarations take."""
PRELUDE_SECONDS = 60.0
"""A limit for what is done once and takes a second."""


@dataclass(frozen=True)
class ComponentFacts:
    """One component: the files that hold the rows of its translation units, and its own rows."""

    name: str
    package: str
    kind: str
    sources: tuple[str, ...]
    units: tuple[Path, ...]
    own: Rows

    def rows(self) -> Rows:
        """All facts of the component; message classes and configurations that its sources never name are left out."""
        merged = merge([*(marshal.loads(marshal.loads(path.read_bytes())[1]) for path in self.units), self.own])
        classes = {row[0] for row in merged["class"]} | {row[1] for row in merged["type_class"]}
        merged["message_class"] = {row for row in merged["message_class"] if row[0] in classes}
        types = {row[2] for row in merged["message_class"]}
        merged["config_parameter"] = {row for row in merged["config_parameter"] if row[0] in types}
        return merged


@dataclass
class Extraction:
    """The facts of all components; use as a context manager, its temporary files go with it.

    `seconds` is the time that each source took, `built` the number of sources that a compile command tells of, `installed` the packages
    of the workspace that count as installed, `programs` package and name of all executables that targets build.
    """

    root: Path
    components: tuple[ComponentFacts, ...] = ()
    diagnostics: list[Diagnostic] = field(default_factory=list)
    seconds: dict[Path, float] = field(default_factory=dict)
    built: int = 0
    installed: tuple[str, ...] = ()
    programs: frozenset[tuple[str, str]] = frozenset()
    _stack: ExitStack = field(default_factory=ExitStack)

    def __enter__(self) -> Extraction:
        return self

    def __exit__(self, *_exception: object) -> None:
        self._stack.close()

    def write(self, out: Path) -> None:
        """Write one folder of facts per component below `out`, and a manifest."""
        out.mkdir(parents=True, exist_ok=True)
        entries, sources = [], []
        for component in self.components:
            rows = component.rows()
            sources += [str(path) for _, path in rows["source_file"]]
            entries.append(write_component(out, component.package, component.name, component.kind, component.sources, rows))
        write_manifest(out, self.root, entries, sources, self.diagnostics)


def extract(
    root: Path,
    packages: Collection[str] | None = None,
    *,
    jobs: int | None = None,
    timeout: float = 60.0,
    defines: Mapping[str, str] | None = None,
    cache: Cache | None = None,
    progress: Progress | None = None,
    only: Callable[[Component], bool] | None = None,
) -> Extraction:
    """Extract the facts of the components of `packages` (all by default) below `root`, or of those that `only` tells.

    `timeout` is the limit in seconds for one source. `defines` are CMake cache variables. With a `cache`, only what has
    changed since an earlier extraction is read again. Sources that fail and whatever else was not understood is in
    `diagnostics`; nothing raises for bad input below `root`.
    """
    workspace = discover(root, packages, defines=defines, timeout=timeout)
    store = load_messages(workspace.packages)
    extraction = Extraction(workspace.root, diagnostics=[*workspace.diagnostics, *store.diagnostics], programs=programs(workspace))
    scratch = Path(extraction._stack.enter_context(tempfile.TemporaryDirectory(prefix="rosarch-")))
    found = [component for component in components(workspace, extraction.diagnostics) if only is None or only(component)]
    commands = read_compile_commands(workspace.root)
    extraction.diagnostics += (*commands.diagnostics, *without_library(workspace))
    units_of = {component: compile_units(workspace, component, commands) for component in found}
    units = sorted({unit for own in units_of.values() for unit in own}, key=repr)
    extraction.built = sum(commands.find(unit.source, "") is not None for unit in units)
    extraction.installed = tuple(sorted(BROUGHT & {package.name for package in workspace.packages}))
    reader = _UnitReader(workspace.root, HeaderFinder(workspace.root, scratch, lambda name: header_text(store, name)), scratch, cache)
    files = _extract_units(units, reader, jobs or default_jobs(), timeout, progress, extraction)
    classes = {
        (name, row.role or row.kind, _message_type(row))
        for row in message_classes(store)
        for name in (row.cxx_class, row.cxx_class.rstrip("_"))  # the struct, and the name that code knows it by
    }
    configs = {
        (f"{config.name}Config", p.name, p.type, _default(p.default)) for config in store.configs.values() for p in config.parameters
    }
    extraction.components = tuple(
        _component_facts(component, units_of[component], workspace.root, files, classes, configs)
        for component in sorted(found, key=lambda c: (c.package, c.name))
    )
    return extraction


def compile_units(workspace: Workspace, component: Component, commands: CompileCommands) -> list[CompileUnit]:
    """The sources of a component, those of a library as the library's own target compiles them."""
    target = component.target.name if component.target else component.name
    own = [_unit(source, target, component.include_dirs, component.definitions, commands) for source in component.sources]
    wanted = set(component.library_sources)
    linked = [
        _unit(source, library.name, include_path(workspace, library), library.definitions, commands)
        for library in component.libraries
        for source in library.sources
        if source in wanted
    ]
    return list(dict.fromkeys([*own, *linked]))


def _unit(
    source: Path, target: str, include_dirs: tuple[Path, ...], definitions: tuple[str, ...], commands: CompileCommands
) -> CompileUnit:
    """How a target compiles a source: as a build did it when there was one, else as its CMake files say."""
    command = commands.find(source, target)
    if command is None:
        return CompileUnit(source, include_dirs, definitions)
    folders = tuple(dict.fromkeys((*command.include_dirs, *include_dirs)))
    return CompileUnit(source, folders, command.definitions, command.installed)


@dataclass(frozen=True)
class _Read:
    """A unit that was extracted: the file with its rows, whether it was in the cache, how long it took, the errors that lost code."""

    path: Path
    known: bool
    seconds: float
    problems: list[Problem]


@dataclass(frozen=True)
class _UnitReader:
    """Extracts units into files below `scratch`, or takes them from the cache."""

    root: Path
    finder: HeaderFinder
    scratch: Path
    cache: Cache | None

    def prepare(self) -> None:
        """What all units share: the precompiled declarations."""
        data = self.cache.load(extractor_version()) if self.cache else None
        if data is not None:
            self._prelude.write_bytes(data)
            return
        build_prelude(self._prelude)
        if self.cache:
            self.cache.store(extractor_version(), self._prelude.read_bytes())

    @property
    def _prelude(self) -> Path:
        return self.scratch / "prelude.pch"

    def read(self, unit: CompileUnit) -> _Read:
        """Extract one unit.

        Its file holds the errors that lost code and, apart from them, the rows.
        """
        start = time.perf_counter()
        sys.setrecursionlimit(20_000)
        includes = self.finder.closure(unit.source, unit.include_dirs, unit.installed)
        key = unit_key(unit, self.root, includes, self.finder)
        cache = self.cache if includes.predictable else None
        data = known = cache.load(key) if cache else None
        if data is None:
            problems: list[Problem] = []
            rows = extract_unit(unit, self.root, self.finder, self._prelude, includes=includes, heal=True, problems=problems)
            data = marshal.dumps((problems, marshal.dumps(dict(rows))))
            if cache:
                cache.store(key, data)
        path = self.scratch / f"{key}.unit"
        path.write_bytes(data)
        return _Read(path, known is not None, time.perf_counter() - start, marshal.loads(data)[0])


def _extract_units(
    units: Sequence[CompileUnit],
    reader: _UnitReader,
    jobs: int,
    timeout: float,
    progress: Progress | None,
    extraction: Extraction,
) -> dict[CompileUnit, Path | Failure]:
    """Extract every unit into a file; return the files, and for units that failed why."""
    if not units:
        return {}
    _prepare(reader, timeout)
    diagnostics = extraction.diagnostics
    known = True
    files: dict[CompileUnit, Path | Failure] = {}
    lost: set[Diagnostic] = set()  # a header's are found by every source that includes it
    largest = sorted(range(len(units)), key=lambda index: -_size(units[index].source))  # long ones first: even ends
    ordered = [units[index] for index in largest]
    diagnostics += [problem for source in sorted({unit.source for unit in units}) for problem in _odd_source(source)]
    for done, (index, outcome) in enumerate(run_tasks(reader.read, ordered, jobs=jobs, timeout=timeout)):
        if isinstance(outcome, Failure):
            _refuse_full_disk(outcome)
            diagnostics.append(Diagnostic("source", ordered[index].source, 1, 1, f"not analysed: {outcome.reason} ({outcome.detail})"))
            files[ordered[index]] = outcome
        else:
            source = ordered[index].source
            files[ordered[index]] = outcome.path
            known &= outcome.known
            extraction.seconds[source] = max(outcome.seconds, extraction.seconds.get(source, 0.0))
            lost.update(Diagnostic("source", Path(path), line, column, message) for path, line, column, message in outcome.problems)
        if progress:
            progress("sources", done + 1, len(units))
    if reader.cache and not known:
        reader.cache.trim()
    diagnostics += lost
    diagnostics.sort(key=str)
    return files


def _prepare(reader: _UnitReader, timeout: float) -> None:
    """Precompile the declarations, in a worker: without room on the disk, clang ends its process."""
    for _, outcome in run_tasks(lambda _task: reader.prepare(), [None], jobs=1, timeout=max(timeout, PRELUDE_SECONDS)):
        if isinstance(outcome, Failure):
            _refuse_full_disk(outcome)
            full = shutil.disk_usage(reader.scratch).free < PRELUDE_BYTES
            raise OSError(errno.ENOSPC if full else errno.EIO, os.strerror(errno.ENOSPC) if full else outcome.detail, str(reader.scratch))


def _refuse_full_disk(failure: Failure) -> None:
    """Facts that cannot be kept are no bad input: going on would lose most of them without a word."""
    if failure.reason == "disk full":
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), failure.detail)


_SELF_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)


def _odd_source(path: Path) -> list[Diagnostic]:
    """What a reader would want to know of a source before wondering why little was found in it: one diagnostic."""
    try:
        data = path.read_bytes()
    except OSError:
        return []  # reported where it is read
    if not data.strip():
        return [Diagnostic("source", path, 1, 1, "empty source")]
    if b"\0" in data:
        return [_at(path, data, data.index(b"\0"), "not a text file")]
    for match in _SELF_INCLUDE.finditer(data):
        if match.group(1).decode("utf-8", "replace") == path.name and (path.parent / path.name).samefile(path):
            return [_at(path, data, match.start(), "the source includes itself")]
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        return [_at(path, data, error.start, f"not UTF-8 (byte 0x{data[error.start]:02x}); read as it is")]
    return []


def _at(path: Path, data: bytes, offset: int, message: str) -> Diagnostic:
    start = data.rfind(b"\n", 0, offset) + 1
    return Diagnostic("source", path, data.count(b"\n", 0, offset) + 1, offset - start + 1, message)


def _size(path: Path) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0


def _message_type(row: MessageClass) -> str:
    """What a class stands for: a service for its request and response, else its own type."""
    if row.kind == "config":
        return f"{row.type}Config"
    return row.owner if row.owner and row.role in ("request", "response") else row.type


def _default(text: str | None) -> str:
    """The default of a configuration's parameter, Python text, as the value that C++ would have."""
    if text is None:
        return "?"
    return {"True": "true", "False": "false"}.get(text, text[1:-1] if text[:1] in "'\"" else text)


def _component_facts(
    component: Component,
    units: Sequence[CompileUnit],
    root: Path,
    files: Mapping[CompileUnit, Path | Failure],
    classes: set[tuple[str, str, str]],
    configs: set[tuple[str, str, str, str]],
) -> ComponentFacts:
    own: dict[str, set[tuple[str | int, ...]]] = {
        "component": {(component.name, component.package, component.kind)},
        "message_class": set(classes),
        "config_parameter": set(configs),
        "component_source": set(),
        "source_file": set(),
        "source_failed": set(),
    }
    if component.entry_class:
        own["component_class"] = {(component.entry_class,)}
    if component.plugin_name or component.base_class:
        own["component_plugin"] = {(component.plugin_name or component.entry_class or component.name, component.base_class or "")}
    for unit in units:
        if unit.source.is_relative_to(root):
            relative = path_text(unit.source.relative_to(root))
            origin = "own" if unit.source in component.sources else "library"
            own["source_file"].add((file_key(relative), relative))
            own["component_source"].add((file_key(relative), origin))
            if isinstance(failure := files[unit], Failure):
                own["source_failed"].add((file_key(relative), failure.reason))
    return ComponentFacts(
        component.name,
        component.package,
        component.kind,
        tuple(path_text(source.relative_to(root)) for source in component.sources if source.is_relative_to(root)),
        tuple(file for unit in units if isinstance(file := files[unit], Path)),
        own,
    )
