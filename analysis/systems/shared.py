"""What the launches of a workspace share: the components that they start, and what the workspace has of what launch files name."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.analysis.method import Method
from rosarch.analysis.systems.builds.rows import build_rows
from rosarch.analysis.systems.instances import Configured, ModelIndex, Parts, configure
from rosarch.analysis.systems.manifests import Declared, declared, manifest_rows
from rosarch.analysis.systems.planning import Planner, configuring, made_by
from rosarch.analysis.systems.processes import with_inner, with_nodes
from rosarch.analysis.systems.settings import NodeSettings
from rosarch.analysis.systems.trees import Trees
from rosarch.analysis.systems.workspace import (
    container_homes,
    container_rows,
    dependencies,
    fetched,
    first_rows,
    named_by,
    programs_named,
    set_rows,
    shared_rows,
    source_rows,
    words_said,
    workspace_rows,
)
from rosarch.base.cache import hash_of, rows_digest
from rosarch.base.memo import Memo
from rosarch.extractor.launch.facts import launch_rows, library_name, started, starts
from rosarch.extractor.launch.model import Composition, FileMeant
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.scripts import script_rows
from rosarch.extractor.launch_ros2.registry import HELPER_PACKAGES
from rosarch.extractor.underlay import Underlay
from rosarch.models.component import ComponentModel
from rosarch.models.node_configuration import NodeConfiguration
from rosarch.models.system.rows import Rows, merged

if TYPE_CHECKING:
    from rosarch.analysis.components import Analysis
    from rosarch.extractor.stored_facts import Facts
    from rosarch.extractor.survey import Survey
    from rosarch.extractor.workspace import Component, Diagnostic
    from rosarch.extractor.workspace.built import Built
    from rosarch.library import Library, LibraryComponent


@dataclass(frozen=True)
class Launch:
    """What is started together: `name` is unique among the launches of a workspace, `words` are its launch files and arguments."""

    name: str
    words: tuple[str, ...]
    composition: Composition
    packages: PackagePath


@dataclass(frozen=True)
class Interface:
    """The rows of a component, and a hash of them."""

    rows: Rows
    digest: str

    @classmethod
    def of(cls, rows: Rows) -> Interface:
        """The interface that rows describe."""
        return cls(rows, rows_digest(rows))

    def all(self, relation: str, column: int) -> set[Any]:
        """The values of a column."""
        return {row[column] for row in self.rows.get(relation, ())}


@dataclass(frozen=True)
class Components:
    """The components that launches start, of sources and of the library: their models, their interfaces, and what all systems see of them.

    `interfaces` begin with those of `models`, in their order. `programs` are package and name of all executables that the workspace builds
    and of the components that it registers, `builds` what the packages come to, `expected` the packages that the library knows or that
    are in the `underlay`, `names` those that programs of the library give their nodes,
    `made` the nodes that these make as well.
    """

    root: Path
    underlay: Underlay
    models: tuple[ComponentModel, ...]
    programs: frozenset[tuple[str, str]]
    builds: tuple[Built, ...]
    expected: frozenset[str]
    names: Mapping[tuple[str, str], str]
    made: Mapping[tuple[str, str], Mapping[str, str]]
    interfaces: tuple[Interface, ...]
    shared: Interface
    diagnostics: tuple[Diagnostic, ...]

    def with_nodes(self, launch: Launch) -> tuple[Launch, Configured]:
        """The launch, with the nodes that programs make, by the names that their code has where no launch file names them; their models."""
        named = with_nodes(launch.composition, made_by(self.models), self.names)
        found = configure(NodeSettings(named), self._model_index)
        composition, inner = with_inner(found.composition, self.made)
        found = Configured(composition, {**found.parts, **{index: Parts((component,)) for index, component in inner.items()}})
        return replace(launch, composition=composition), found

    @cached_property
    def _model_index(self) -> ModelIndex:
        return ModelIndex.of(Trees(self.root, self.underlay), self.models)

    def with_models(self, models: Iterable[ComponentModel]) -> Components:
        """The same components; those that are among `models` have the models there."""
        from rosarch.analysis.systems.interfaces import model_rows

        told = {model.title: model for model in models}
        own = tuple(told.get(model.title, model) for model in self.models)
        changed = [number for number, (model, before) in enumerate(zip(own, self.models, strict=True)) if model != before]
        interfaces = list(self.interfaces)
        for number in changed:
            interfaces[number] = Interface.of(model_rows(own[number]))
        return replace(self, models=own, interfaces=tuple(interfaces), shared=_shared(own, interfaces)) if changed else self

    @cached_property
    def _named(self) -> Mapping[str | tuple[str, str], Collection[int]]:
        """The interfaces of components by the names that these go by: with their package, and alone."""
        found: dict[str | tuple[str, str], list[int]] = defaultdict(list)
        for number, each in enumerate(self.interfaces):
            for title, package, name, *_ in () if each.rows.get("interface_configured") else each.rows.get("interface", ()):
                for key in {(package, name), name, title}:
                    found[key].append(number)
        for number, model in enumerate(self.models):
            if model.configuration:
                found[model.title].append(number)
        return dict(found)

    def started(self, launch: Launch, titles: Iterable[str] = ()) -> list[Interface]:
        """The interfaces of those that a launch may start, with those that these load, and of configured components by their titles."""
        needed = _Needed([launch])
        names: set[str | tuple[str, str]] = {*needed.executables, *needed.words, *needed.plugins, *titles}
        found = {number: self.interfaces[number] for name in names for number in self._named.get(name, ())}
        waiting = list(found.values())
        while waiting:
            loads, bases = (waiting[-1].all(relation, 1) for relation in ("interface_loads", "interface_loads_any"))
            waiting.pop()
            for number, each in enumerate(self.interfaces) if loads or bases else ():
                if (
                    number not in found
                    and not each.rows.get("interface_configured")
                    and not (loads.isdisjoint(each.all("interface", 2)) and bases.isdisjoint(each.all("interface_base", 1)))
                ):
                    found[number] = each
                    waiting.append(each)
        return [found[number] for number in sorted(found)]


@dataclass(frozen=True)
class SharedFacts:
    """What all launches of a workspace share: its components, what launch files name of it, what was not understood, what users say.

    `said` are the words that the sources of each component say.
    """

    root: Path
    components: Components
    named: Rows
    said: Mapping[str, frozenset[str]]
    manifests: tuple[Declared, ...]
    diagnostics: tuple[Diagnostic, ...]
    given: Rows = field(default_factory=dict)

    @property
    def models(self) -> tuple[ComponentModel, ...]:
        """The models of the components of the workspace."""
        return self.components.models

    def facts(self, launch: Launch) -> SystemFacts:
        """The facts about one system."""
        launch, configured = self.components.with_nodes(launch)
        nodes = [start for start, _ in starts(launch.composition)]
        parts = [(nodes[index], part) for index, part in configured.parts.items()]
        models = {(node, title) for node, part in parts for title in part.titles}
        trees = {
            "tree_node_unseen": {(node, name) for node, part in parts for name in part.tree_nodes},
            "tree_unread": {(node, file) for node, part in parts for file in part.trees},
        }
        interfaces = self.components.started(launch, {title for _, title in models})
        titles = {title for interface in interfaces for title in interface.all("interface", 0)}
        composed = launch_rows(launch.composition, self.root), script_rows(launch.composition, launch.packages)
        named = named_by(launch.composition, self.named), source_rows(launch.composition, titles, self.said)
        builds = build_rows(launch.composition, self.components.builds, self.root)
        manifests = manifest_rows(launch.composition, self.manifests, self.root, self.components.expected)
        own = merged([*composed, *named, builds, manifests, self.given, {"started_as": models}, trees])
        return SystemFacts(own, (self.components.shared, *interfaces))

    def rows(self, launch: Launch) -> Rows:
        """The facts about one system."""
        return self.facts(launch).rows()

    def with_models(self, launches: Sequence[Launch], models: Iterable[ComponentModel]) -> SharedFacts:
        """What there is if the components that are among `models` have the models there."""
        components = self.components.with_models(models)
        named = {**self.named, **set_rows([launch.composition for launch in launches], components.models)}
        return self if components is self.components else replace(self, components=components, named=named)


@dataclass(frozen=True)
class SystemFacts:
    """The facts about one system: its `own`, and those about its components."""

    own: Rows
    interfaces: tuple[Interface, ...]

    def rows(self) -> Rows:
        """All of them."""
        return merged([self.own, *(interface.rows for interface in self.interfaces)])

    def digest(self) -> str:
        """A hash of them."""
        return hash_of([rows_digest(self.own), *(interface.digest for interface in self.interfaces)])


def shared_facts(root: Path, launches: Sequence[Launch], method: Method, memo: Memo | None = None) -> SharedFacts:
    """Analyse the components that `launches` start: those below `root`, of others those of the library (that in `method` first)."""
    needed = _Needed(launches)
    top = os.path.abspath(root)

    def find() -> Components:
        return _components(root, launches, needed, method)

    key = ["components", top, *needed.key(), *method.key(), hash_of(configuring(launch.composition) for launch in launches)]
    components = memo.recall(key, (top, *_absolute(method.library)), find) if memo else find()
    compositions = [launch.composition for launch in launches]

    def words() -> Mapping[str, frozenset[str]]:
        return words_said(root, components.models)

    sources = [repr((model.package, model.component, model.sources)) for model in components.models]
    said = memo.recall(["said", top, *sources], (top,), words) if memo else words()

    def read() -> tuple[Declared, ...]:
        return declared(root)

    def lists() -> tuple[set[str], set[str]]:
        return fetched(root), container_homes(root)

    manifests = memo.recall(["manifests", top], (top,), read) if memo else read()
    brought, homes = memo.recall(["fetched", top], (top,), lists) if memo else lists()
    there = workspace_rows(dependencies(manifests), compositions, components.programs, components.expected, brought, homes)
    named = merged([there, first_rows(compositions, root), set_rows(compositions, components.models), container_rows(compositions)])
    found = (*(d for composition in compositions for d in composition.diagnostics()), *components.diagnostics)
    given = {"rate_given": {(rate.topic, rate.low, rate.high) for rate in method.rates}}
    return SharedFacts(root, components, named, said, manifests, tuple(dict.fromkeys(found)), given)


def _absolute(folders: Sequence[Path]) -> list[str]:
    return [os.path.abspath(folder) for folder in folders]


_ROUNDS = 6


def _components(root: Path, launches: Sequence[Launch], needed: _Needed, method: Method) -> Components:
    from rosarch.analysis.components import ALONE, Wanted, analyze
    from rosarch.analysis.systems.interfaces import library_rows, model_rows
    from rosarch.extractor.survey import survey
    from rosarch.library import load

    diagnostics: list[Diagnostic] = []
    builds: dict[Path, Built] = {}
    own = PackagePath([root]).own
    underlay = method.sources.underlay.without(own)
    # where nothing is started, the packages show all the same what keeps them from being built
    asked = needed.packages if any(launch.composition.nodes for launch in launches) else set(own)

    @cache
    def surveyed(packages: tuple[str, ...] | None) -> Survey:
        return survey(root, packages, method.sources)

    def analyzed(packages: tuple[str, ...] | None, only: Callable[[Component], bool], wanted: Wanted = ALONE) -> Analysis:
        found = analyze(root, packages, method, only=only, wanted=wanted, surveyed=surveyed(packages))
        diagnostics.extend(found.diagnostics)
        # of packages that no launch file names, those whose plug-ins may be loaded
        builds.update((one.folder, one) for one in found.builds if packages is not None or one.described)
        # of those without sources nothing is known; of a program that makes several nodes there are these
        whole = {(model.package, model.executable) for model in found.models if model.executable and not model.configuration}
        kept = tuple(model for model in found.models if model.sources and (model.package, model.component) not in whole)
        return replace(found, models=kept)

    planner = Planner([launch.composition for launch in launches], Trees(root, underlay))
    packages = tuple(sorted(asked & (underlay.hidden | underlay.packages.keys())))
    found = analyzed(packages, needed.is_needed, Wanted(after=planner.after))
    models = found.models
    tried: dict[_Key, set[NodeConfiguration]] = defaultdict(set)
    for _ in range(_ROUNDS):
        wants = planner.wants(made_by(models))
        everything: list[tuple[_Key, set[NodeConfiguration]]] = [*wants.plugins.items(), *wants.components.items()]
        wanted = {key: left for key, all_ in everything if (left := all_ - tried[key])}
        if not wanted:
            break
        for key, configurations in wanted.items():
            tried[key] |= configurations
        more = _more(wanted, wants.in_namespaces, analyzed)
        models += more
        planner.index.add(more)
    by_themselves = planner.wants(made_by(models)).alone
    alone = [model for model in models if not model.configuration and model.title in by_themselves]
    if needed.plugins or any(model.loads or model.loads_any for model in alone):

        def is_plugin(component: Component) -> bool:
            return not needed.is_needed(component) and (is_loaded(component, alone) or component.plugin_name in needed.plugins)

        models += analyzed(None, is_plugin).models
    known = load(tuple(method.library))
    diagnostics += known.problems
    of_library = needed.of(known, models, underlay)
    names = {(one.package, one.component): one.node_name for one in of_library if one.node_name and 1 not in one.ros}
    made = {(one.package, one.component): one.makes for one in of_library if one.makes}
    interfaces = [Interface.of(rows) for rows in (*map(model_rows, models), *map(library_rows, of_library))]
    expected = known.packages | underlay.packages.keys() | HELPER_PACKAGES
    shared = _shared(models, interfaces)
    told = tuple(builds.values())
    return Components(root, underlay, models, found.programs, told, expected, names, made, tuple(interfaces), shared, tuple(diagnostics))


_Key = str | tuple[str, str]
"""What a plug-in is loaded by, or package and name of a component."""


def _more(
    wanted: Mapping[_Key, Collection[NodeConfiguration]],
    in_namespaces: Mapping[str, Collection[NodeConfiguration]],
    analyzed: Callable[..., Analysis],
) -> tuple[ComponentModel, ...]:
    """The models with the configurations that are wanted, of plug-ins and of the components that load them."""
    from rosarch.analysis.components import Wanted
    from rosarch.extractor.pipeline import ComponentFacts

    def first(component: ComponentFacts | Facts) -> Iterable[NodeConfiguration]:
        names = [str(row[0]) for row in component.own.get("component_plugin", ())] if isinstance(component, ComponentFacts) else []
        keys: tuple[_Key, ...] = (*names, (component.package, component.name))
        return sorted({each for key in keys for each in wanted.get(key, ())}, key=lambda found: found.key)

    def after(models: Sequence[ComponentModel]) -> Iterable[NodeConfiguration]:
        asking = {model.configuration for model in models if model.asks_namespace}
        return sorted({each for key in asking for each in in_namespaces.get(key, ())}, key=lambda found: found.key)

    def is_wanted(component: Component) -> bool:
        return component.plugin_name in wanted or (component.package, component.name) in wanted

    return analyzed(None, is_wanted, Wanted(first=first, after=after)).models


def _shared(models: Sequence[ComponentModel], interfaces: Iterable[Interface]) -> Interface:
    """What all systems see of these components."""
    by_themselves = [model for model in models if not model.configuration]
    told = [each.rows for each in interfaces if not each.rows.get("interface_configured")]
    rows = {row for each in told for row in each["interface"]}
    known = {row[0] for row in rows if row[-1] == "library"}
    ports = {(row[0], *row[2:]) for each in told for row in each.get("interface_port", ()) if row[0] in known}
    return Interface.of(merged([{"interface": rows, "port_anywhere": ports}, shared_rows(by_themselves)]))


class _Needed:
    """Which components the launches start."""

    def __init__(self, launches: Sequence[Launch]) -> None:
        asked = [item for launch in launches for item in started(launch.composition)]
        self.executables = {(package, type_) for package, type_, _ in asked}
        self.versions = {launch.composition.ros for launch in launches}
        worlds = [plugin for launch in launches for world in launch.composition.worlds for plugin in world.plugins]
        robots = [plugin for launch in launches for setting in launch.composition.params for plugin in setting.plugins]
        self.plugins = {library_name(plugin.filename) for plugin in (*worlds, *robots)}
        classes = {type_ for _, type_ in self.executables if "/" in type_}
        self.words = classes | {word for _, _, words in asked for word in words}
        self.words |= {one.plugin for launch in launches for one in launch.composition.hardware if "/" in one.plugin}
        self.plugins |= {word.removeprefix("-s") for word in self.words if word.endswith(".so")}
        self.packages = {package for package, _ in self.executables} | {word.partition("/")[0] for word in self.words if "/" in word}
        self.packages |= {package for package, _ in programs_named(launch.composition for launch in launches)}
        self.packages |= _packages_of_files(launches)

    def key(self) -> list[str]:
        """All that distinguishes these components from others."""
        return [repr(sorted(found)) for found in (self.executables, self.versions, self.plugins, self.words, self.packages)]

    def is_needed(self, component: Component) -> bool:
        """Whether a node is started from this executable, or with an argument that names this class."""
        names = (component.plugin_name, *(component.executables or (component.name,)))
        return any((component.package, name) in self.executables for name in names) or component.plugin_name in self.words

    def of(self, library: Library, models: Sequence[ComponentModel], underlay: Underlay) -> list[LibraryComponent]:
        """The components of the library that are started, and those that these load, unless they are among `models`.

        A package that is installed has no other programs than are there. A class that is loaded goes by its name alone, a plug-in of a
        simulator by its file: one that the workspace builds hides those of all packages.
        """
        own = {(model.package, type_) for model in models for type_ in (*model.types, model.executable)}
        built = {model.plugin.name for model in models if model.plugin}
        parts: dict[str, LibraryComponent] = {}
        programs = [one for one in sorted(self.executables) if not underlay.lacks(*one)]
        for ros in sorted(self.versions, reverse=True):
            found = [library.find(package, type_, ros) for package, type_ in programs]
            found += [library.find(None, word, ros) for word in sorted(self.words) if "/" in word]
            found += [library.find(None, file, ros) for file in sorted(self.plugins - built)]
            started = [component for component in found if component is not None and (component.package, component.component) not in own]
            # where launch files of both versions start a component, that of one version has no model
            for part in (part for component in started for part in library.with_loaded(component, ros)):
                parts.setdefault(part.title, part)
        return list(parts.values())


def is_loaded(component: Component, models: Sequence[ComponentModel]) -> bool:
    """Whether one of `models` loads this plug-in, by its name or because it takes all that are derived from a class."""
    return any(component.plugin_name in model.loads or component.base_class in model.loads_any for model in models)


def _packages_of_files(launches: Sequence[Launch]) -> set[str]:
    """The packages that launch files mean files in."""
    folders = {folder: name for launch in launches for name, folder in launch.packages.packages.items()}
    meant = {
        (reference.file, launch.packages)
        for launch in launches
        for reference in launch.composition.references
        if isinstance(reference, FileMeant)
    }
    found = (packages.of_file(file) for file, packages in meant)
    return {folders[folder] for folder in found if folder is not None}
