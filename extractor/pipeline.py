"""From a workspace to the facts of each component.

Translation units are read first, each once however many components share it, in worker processes; the facts of a
component are the union of those of its units.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from rosarch.base import tracing
from rosarch.base.boundary import confined, ros_package_path
from rosarch.base.cache import hash_of
from rosarch.base.files import path_text, shown_path
from rosarch.base.pool import Failure
from rosarch.base.scratch import scratch_folder
from rosarch.base.whole import write_whole
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit
from rosarch.extractor.cxx.unit import file_key
from rosarch.extractor.cxx.units import UnitReader
from rosarch.extractor.facts import Rows, write_component
from rosarch.extractor.facts_text import facts_text
from rosarch.extractor.manifest import write_manifest
from rosarch.extractor.messages import Interfaces, MessageClass
from rosarch.extractor.messages.closed import closed_packages
from rosarch.extractor.messages.message_fields import MessageFields
from rosarch.extractor.python.units import PythonReader
from rosarch.extractor.settings import DEFAULT, Settings
from rosarch.extractor.sources import Sources, diagnostics
from rosarch.extractor.survey import Survey, survey
from rosarch.extractor.underlay import Underlay
from rosarch.extractor.unit_index import UnitIndex
from rosarch.extractor.unit_store import Makers, UnitRows
from rosarch.extractor.units import Outcome, UnitFile
from rosarch.extractor.workspace import Component, Diagnostic, Workspace
from rosarch.extractor.workspace.built import Built
from rosarch.extractor.workspace.graph import is_brought
from rosarch.extractor.workspace.model import ROS1, ROS2, UNUSED


@dataclass(frozen=True)
class ComponentFacts:
    """One component: the files that hold the rows of its translation units and of headers, and its own rows.

    `key` is a hash of all facts; None when some unit's are not known to be the same the next time.
    """

    name: str
    package: str
    kind: str
    sources: tuple[str, ...]
    units: tuple[Path, ...]
    own: Rows
    key: str | None = None
    fields: MessageFields = field(default_factory=lambda: MessageFields({}))

    @property
    def size(self) -> int:
        """The bytes of all that was read for it."""
        return sum(map(os.path.getsize, self.units))

    def rows(self, files: UnitRows | None = None) -> Rows:
        """The facts of the component; `files` are what its `units` hold, where that was read for another one.

        Code that nothing in it mentions and message classes and configurations that it never names are left out.
        """
        rows = (files or UnitRows(self.units)).of(self.own)
        classes = {row[0] for row in rows["class"]} | {row[1] for row in rows["type_class"]}
        rows["message_class"] = {row for row in rows["message_class"] if row[0] in classes}
        types = {row[2] for row in rows["message_class"]}
        rows["config_parameter"] = {row for row in rows["config_parameter"] if row[0] in types}
        rows["message_default"] = {(name,) for name in self.fields.defaults}
        if rows["source_language"]:  # what other languages are compiled
            rows.update(self.fields.used(rows["message_class"]))
        return rows

    def left_out(self, makers: Makers, files: UnitRows | None = None) -> list[tuple[str, str, int, int]]:
        """Where code that `rows` leaves out makes ports: the name of the function, then path, line and column. Of an unused source: all."""
        return sorted(set((files or UnitRows(self.units)).left_out(self.own, makers, unused=self.kind == UNUSED)))


@dataclass
class Extraction:
    """The facts of all components; use as a context manager, its temporary files go with it.

    `seconds` is the time that each source took, `built` the number of sources that a compile command names, `installed` the packages
    of the workspace that count as installed, `folders` those of the packages that were read, `programs` package and name of all executables
    that targets build and of the components that they register, `builds` what the packages that were read come to.
    """

    root: Path
    components: tuple[ComponentFacts, ...] = ()
    diagnostics: list[Diagnostic] = field(default_factory=list)
    seconds: dict[Path, float] = field(default_factory=dict)
    built: int = 0
    installed: tuple[str, ...] = ()
    folders: tuple[Path, ...] = ()
    programs: frozenset[tuple[str, str]] = frozenset()
    builds: tuple[Built, ...] = ()
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

    def write_text(self, out: Path) -> None:
        """Write one text with the facts of all components."""
        text = facts_text(self.root, self.components, self.diagnostics, out.absolute().parent)
        write_whole(out, text.encode("utf-8", "surrogateescape"))


def extract(
    root: Path,
    packages: Collection[str] | None = None,
    settings: Settings = DEFAULT,
    *,
    only: Callable[[Component], bool] | None = None,
    is_cached: Callable[[ComponentFacts], bool] | None = None,
    surveyed: Survey | None = None,
) -> Extraction:
    """Extract the facts of the components of `packages` (all by default) below `root`, or of those for which `only` holds.

    What was `surveyed` takes the place of what is found there. With a cache, components for which `is_cached` holds, by their key, may have
    no rows. Sources that fail and whatever else was not understood is in `diagnostics`; nothing raises for bad input below `root`.
    """
    cache, underlay = settings.cache, settings.underlay
    with ExitStack() as confinement, ExitStack() as unfinished:
        confinement.enter_context(confined([root, *ros_package_path(), *underlay.folders]))
        there = surveyed or survey(root, packages, settings)
        workspace, seen = there.workspace, there.rests_on
        index = UnitIndex.load(cache, there.asked, seen) if cache and is_cached and seen and not seen.uncertain else None
        extraction = Extraction(workspace.root, diagnostics=list(there.diagnostics), programs=there.programs, builds=there.builds)
        unfinished.push(extraction)  # its temporary files go also when this ends early
        scratch = extraction._stack.enter_context(scratch_folder())
        tracing.ignore(scratch)
        found = [component for component in there.components if only is None or only(component)]
        units_of = {one: there.units(one) for one in found}
        units = sorted({unit for own in units_of.values() for unit in own}, key=repr)
        compiled = [unit for unit in units if isinstance(unit, CompileUnit)]
        extraction.built = sum(there.commands.find(unit.source, "") is not None for unit in compiled)
        own = [package for package in workspace.packages if not package.installed]
        extraction.folders = tuple(package.path for package in own if package.name in workspace.selected)
        extraction.installed = tuple(sorted(package.name for package in own if is_brought(package)))
        confinement.enter_context(confined([scratch, *{folder for unit in compiled for folder in unit.installed}]))
        finder = HeaderFinder(workspace.root, scratch, there.interfaces.header_text, workspace.underlay, searched=workspace.searched)
        readers = UnitReader(workspace.root, finder, scratch, cache), PythonReader(workspace.root, scratch, cache)
        sources = Sources(*readers, settings)
        defined = _defined(there.interfaces, workspace)
        make = partial(_component_facts, workspace.root, workspace.underlay, sources.paths, defined, there.built)
        outcomes = index.read(units, sources.read) if index else sources.read(units)
        made = {one: make(one, outcomes.of(units_of[one])) for one in found}
        if is_cached and index:
            wanted = [one for one in found if not is_cached(made[one])]
            lost = {unit for one in wanted for unit in units_of[one] if sources.lacks(outcomes.files[unit])}
            outcomes.files.update(sources.read(sorted(lost, key=repr)).files)
            made.update((one, make(one, outcomes.of(units_of[one]))) for one in wanted)
        if units:
            extraction.diagnostics = sorted([*extraction.diagnostics, *diagnostics(outcomes)], key=str)
        unfinished.pop_all()
    extraction.seconds = outcomes.seconds
    extraction.components = tuple(made[one] for one in sorted(found, key=lambda each: (each.package, each.name)))
    return extraction


def _message_type(row: MessageClass) -> str:
    """What a class stands for: a service for its request and response, else its own type."""
    if row.kind == "config":
        return f"{row.type}Config"
    return row.owner if row.owner and row.role in ("request", "response") else row.type


def _constant(text: str | None) -> str:
    """What a configuration says of a parameter, a constant in Python, as the value that C++ would have."""
    if text is None:
        return "?"
    return {"True": "true", "False": "false"}.get(text, text[1:-1] if text[:1] in "'\"" else text)


@dataclass(frozen=True)
class _Defined:
    """The message classes and configurations of the workspace and of common packages, rows about those without others, a hash of all."""

    classes: set[tuple[str, str, str]]
    configs: set[tuple[str, ...]]
    closed: dict[str, set[tuple[str, ...]]]
    fields: Mapping[str, MessageFields]
    middleware: Mapping[str, str]
    digest: str


def _defined(interfaces: Interfaces, workspace: Workspace) -> _Defined:
    classes = {
        (name, row.role or row.kind, _message_type(row))
        for row in interfaces.classes()
        for name in (row.cxx_class, row.cxx_class.rstrip("_"))  # the struct, and the name that code knows it by
    }
    configs = {
        (f"{config.name}Config", p.name, p.type, *map(_constant, (p.default, p.minimum, p.maximum)))
        for config in interfaces.configs()
        for p in config.parameters
    }
    closed = closed_packages(workspace.packages)
    packages = workspace.packages
    fields = {kind: MessageFields.of(store, packages, kind) for kind, store in ((ROS1, interfaces.ros1), (ROS2, interfaces.ros2))}
    rows = [sorted(rows) for rows in closed.values()] + [sorted(known.rows.items()) for known in fields.values()]
    defaults = [sorted(known.defaults) for known in fields.values()]
    digest = hash_of(map(repr, (*sorted(classes), *sorted(configs), *rows, *defaults)))
    return _Defined(classes, configs, closed, fields, {package.name: package.middleware for package in packages}, digest)


def _component_facts(
    root: Path,
    underlay: Underlay,
    paths: Callable[[UnitFile], Iterable[Path]],
    defined: _Defined,
    programs: frozenset[tuple[str, str]],
    component: Component,
    outcomes: Sequence[Outcome],
) -> ComponentFacts:
    own: dict[str, set[tuple[str | int, ...]]] = {
        "component": {(component.name, component.package, component.kind)},
        "component_source": set(),
        "source_file": set(),
        "source_failed": set(),
    }
    if component.entry_class:
        own["component_class"] = {(component.entry_class,)}
    if component.plugin_name or component.base_class:
        own["component_plugin"] = {(component.plugin_name or component.entry_class or component.name, component.base_class or "")}
    run_alone = {component.name} if component.plugin_name and (component.package, component.name) in programs else set()
    own["component_executable"] = {(name,) for name in {*component.executables, *run_alone}}
    for together, outcome in outcomes:
        for source in together:
            if source.is_relative_to(root) or underlay.holds(str(source)):
                relative = path_text(shown_path(root, source))
                origin = "own" if source in component.sources else "library"
                own["source_file"].add((file_key(relative), relative))
                own["component_source"].add((file_key(relative), origin))
                if isinstance(outcome, Failure):
                    own["source_failed"].add((file_key(relative), outcome.reason))
    read = [outcome for _, outcome in outcomes if isinstance(outcome, UnitFile)]
    keys = [file.key for file in read if file.certain]
    facts = [f"{relation} {row!r}" for relation, rows in sorted(own.items()) for row in sorted(rows, key=repr)]
    certain = len(keys) == len(outcomes)  # a unit that failed may not do so the next time
    if not certain:
        tracing.uncertain()
    shown = (shown_path(root, source) for source in component.sources if source.is_relative_to(root) or underlay.holds(str(source)))
    sources = tuple(map(path_text, shown))
    return ComponentFacts(
        component.name,
        component.package,
        component.kind,
        sources,
        tuple(dict.fromkeys(path for file in read for path in paths(file))),
        {**own, "message_class": defined.classes, "config_parameter": defined.configs, **defined.closed},
        hash_of([*keys, "", *facts, "", *sources, "", defined.digest]) if certain else None,
        defined.fields[defined.middleware.get(component.package, ROS1)],
    )
