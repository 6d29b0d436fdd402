"""From a workspace and its launch files to systems and findings."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.facts import launch_rows, library_name, started
from rosarch.extractor.launch.model import Composition
from rosarch.extractor.launch.packages import PackagePath
from rosarch.extractor.launch.scripts import script_rows
from rosarch.extractor.pool import Failure, default_jobs, run_tasks
from rosarch.library import Library, LibraryComponent, load
from rosarch.models.analysis import COMPONENT_TIMEOUT, Analysis, analyze
from rosarch.models.component import ComponentModel
from rosarch.models.findings import Finding
from rosarch.models.places import Place
from rosarch.models.rule_sets import SHIPPED, RuleSet, SystemRules, system_rules
from rosarch.models.system.build import Rows, evaluate, merged, system_model
from rosarch.models.system.findings import findings
from rosarch.models.system.interfaces import library_rows, model_rows
from rosarch.models.system.model import SystemModel
from rosarch.models.system.workspace import programs_named, shared_rows, source_rows, workspace_rows

if TYPE_CHECKING:
    from rosarch.extractor.cache import Cache
    from rosarch.extractor.units import Progress
    from rosarch.extractor.workspace import Component, Diagnostic


@dataclass(frozen=True)
class Launch:
    """What is started together: `name` tells it from the other launches of a workspace, `words` are its launch files and arguments."""

    name: str
    words: tuple[str, ...]
    composition: Composition
    packages: PackagePath


@dataclass(frozen=True)
class SystemAnalysis:
    """The systems of a workspace, the findings about them (each once, with the systems that have it), and what was not understood."""

    systems: tuple[SystemModel, ...]
    findings: tuple[Finding, ...]
    models: tuple[ComponentModel, ...]
    diagnostics: tuple[Diagnostic, ...]


@dataclass(frozen=True)
class Surrounding:
    """What all launches of a workspace share: the rows about components and files, the models, and what was not understood."""

    root: Path
    interfaces: tuple[Rows, ...]
    models: tuple[ComponentModel, ...]
    diagnostics: tuple[Diagnostic, ...]

    def rows(self, launch: Launch) -> dict[str, set[tuple[Any, ...]]]:
        """The facts about one system."""
        return merged([launch_rows(launch.composition, self.root), script_rows(launch.composition, launch.packages), *self.interfaces])


def surrounding(
    root: Path,
    launches: Sequence[Launch],
    *,
    library: Sequence[Path] = (),
    rules: RuleSet = SHIPPED,
    engine: str = "embedded",
    jobs: int | None = None,
    timeout: float = 60.0,
    defines: Mapping[str, str] | None = None,
    cache: Cache | None = None,
    progress: Progress | None = None,
) -> Surrounding:
    """Analyse the components that `launches` start: those below `root`, of others those of the library (that in `library` first)."""
    needed = _Needed(launches)
    diagnostics: list[Diagnostic] = [d for launch in launches for d in launch.composition.diagnostics()]
    options: dict[str, Any] = {"jobs": jobs, "timeout": timeout, "defines": defines, "cache": cache}

    def analyzed(packages: Collection[str] | None, only: Callable[[Component], bool]) -> Analysis:
        found = analyze(root, packages, rules=rules, engine=engine, progress=progress, only=only, **options)
        diagnostics.extend(found.diagnostics)
        return found

    models: tuple[ComponentModel, ...] = ()
    programs: frozenset[tuple[str, str]] = frozenset()
    packages = _packages_below(root, needed.packages)
    if packages:
        found = analyzed(packages, needed.is_needed)
        models, programs = found.models, found.programs
    if any(model.loads or model.loads_any for model in models):
        models += analyzed(None, lambda component: is_loaded(component, models) and not needed.is_needed(component)).models
    known = load(library)
    diagnostics += known.problems
    compositions = [launch.composition for launch in launches]
    around = (workspace_rows(root, compositions, programs, known), source_rows(root, compositions, models), shared_rows(models))
    interfaces = (*map(model_rows, models), *map(library_rows, needed.of(known, models)), *around)
    return Surrounding(root, interfaces, models, tuple(dict.fromkeys(diagnostics)))


def analyze_systems(
    root: Path,
    launches: Sequence[Launch],
    *,
    rules: RuleSet = SHIPPED,
    library: Sequence[Path] = (),
    engine: str = "embedded",
    jobs: int | None = None,
    timeout: float = 60.0,
    defines: Mapping[str, str] | None = None,
    cache: Cache | None = None,
    progress: Progress | None = None,
) -> SystemAnalysis:
    """Compose the nodes that `launches` start from their components, and check each system, by `rules`.

    See `surrounding` for the components.
    """
    from rosarch.extractor.workspace import Diagnostic

    checked = system_rules(rules)
    shared = surrounding(
        root,
        launches,
        library=library,
        rules=rules,
        engine=engine,
        jobs=jobs,
        timeout=timeout,
        defines=defines,
        cache=cache,
        progress=progress,
    )

    def work(launch: Launch) -> tuple[SystemModel, list[Finding]]:
        gc.disable()
        return _system(checked, launch, shared.rows(launch), engine)

    systems: list[SystemModel] = []
    raised: list[Finding] = []
    diagnostics = list(shared.diagnostics)
    for done, (index, outcome) in enumerate(run_tasks(work, launches, jobs=jobs or default_jobs(), timeout=COMPONENT_TIMEOUT)):
        if isinstance(outcome, Failure):
            detail = f"{launches[index].name} not composed: {outcome.reason} ({outcome.detail})"
            diagnostics.append(Diagnostic("launch", root, 1, 1, detail))
        else:
            systems.append(outcome[0])
            raised += outcome[1]
        if progress:
            progress("systems", done + 1, len(launches))
    systems.sort(key=lambda system: system.name)
    return SystemAnalysis(tuple(systems), _together(raised), shared.models, tuple(diagnostics))


def _system(rules: SystemRules, launch: Launch, rows: Rows, engine: str) -> tuple[SystemModel, list[Finding]]:
    result = evaluate(rules, rows, engine)
    places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
    return system_model(launch.name, launch.words, rows, result), findings(rules.checks, result, places, launch.name)


class _Needed:
    """Which components the launches start."""

    def __init__(self, launches: Sequence[Launch]) -> None:
        asked = [item for launch in launches for item in started(launch.composition)]
        self.executables = {(package, type_) for package, type_, _ in asked}
        worlds = [plugin for launch in launches for world in launch.composition.worlds for plugin in world.plugins]
        robots = [plugin for launch in launches for setting in launch.composition.params for plugin in setting.plugins]
        self.plugins = {library_name(plugin.filename) for plugin in (*worlds, *robots)}
        self.words = {word for _, _, words in asked for word in words}
        self.packages = {package for package, _ in self.executables} | {word.partition("/")[0] for word in self.words if "/" in word}
        self.packages |= {package for package, _ in programs_named(launch.composition for launch in launches)}

    def is_needed(self, component: Component) -> bool:
        """Whether a node is started from this executable, or with an argument that names this class."""
        return (component.package, component.name) in self.executables or component.plugin_name in self.words

    def of(self, library: Library, models: Sequence[ComponentModel]) -> list[LibraryComponent]:
        """The components of the library that are started, and those that these load, unless they are among `models`."""
        own = {(model.package, model.plugin.name if model.plugin else model.component) for model in models}
        found = [library.find(package, type_) for package, type_ in sorted(self.executables)]
        found += [library.find(None, word) for word in sorted(self.words) if "/" in word]
        found += [library.find(None, file) for file in sorted(self.plugins)]
        started = [component for component in found if component is not None and (component.package, component.component) not in own]
        return [part for component in started for part in library.with_loaded(component)]


def is_loaded(component: Component, models: Sequence[ComponentModel]) -> bool:
    """Whether one of `models` loads this plug-in, by its name or because it takes all that are derived from a class."""
    return any(component.plugin_name in model.loads or component.base_class in model.loads_any for model in models)


def _packages_below(root: Path, names: Collection[str]) -> list[str]:
    known = PackagePath([os.path.abspath(root)]).packages
    return sorted(name for name in names if name in known)


def _together(found: Sequence[Finding]) -> tuple[Finding, ...]:
    """Findings that several systems have, once."""
    first: dict[tuple[str, str, Place], Finding] = {}
    for finding in found:
        key = (finding.check.id, finding.message, finding.place)
        other = first.get(key)
        first[key] = replace(other, systems=tuple(sorted({*other.systems, *finding.systems}))) if other else finding
    return tuple(sorted(first.values(), key=lambda finding: (finding.place, finding.check.id, finding.message)))
