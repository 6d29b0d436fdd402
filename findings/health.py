"""How well a workspace was read: what was replaced, missing, unresolved, failed and slow."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.limits import LIMITS
from rosarch.base.places import Place
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.extractor.pipeline import ComponentFacts, extract
from rosarch.extractor.settings import DEFAULT, Settings
from rosarch.extractor.workspace.unused import unused_sources
from rosarch.rule_programs.sets import SHIPPED, RuleSet, component_program

SLOW = 2.0  # seconds for one source: beyond, a reader will want to know


@dataclass(frozen=True)
class UnknownName:
    """A port whose name the source does not give."""

    component: str
    kind: str
    name: str
    reason: str
    at: Place


@dataclass
class Health:
    """What an examination finds; paths are relative to the workspace, times in seconds."""

    components: int = 0
    sources: int = 0
    built: int = 0  # sources that a compile command names
    installed: tuple[str, ...] = ()  # packages of the workspace whose declarations rosarch brings
    missing: dict[str, set[str]] = field(default_factory=lambda: defaultdict(set))  # header to the files that include it
    macros: dict[str, set[Place]] = field(
        default_factory=lambda: defaultdict(set)
    )  # what nothing defines, with where it stands for something
    lost: list[tuple[Place, int, str]] = field(default_factory=list)  # bodies of functions that the parser lost: up to which line, and why
    calls: int = 0
    unbound: Counter[str] = field(default_factory=Counter)  # calls that the compiler could not bind, by reason
    unknown: list[UnknownName] = field(default_factory=list)
    violations: dict[str, int] = field(default_factory=dict)  # rows of relations that have to be empty
    slow: list[tuple[str, float]] = field(default_factory=list)
    empty: list[str] = field(default_factory=list)  # components without a source
    unused: list[str] = field(default_factory=list)  # sources that use ROS and belong to no component
    diagnostics: list[Diagnostic] = field(default_factory=list)

    @property
    def failed(self) -> bool:
        """Whether something that should have been analysed was not, or the rules contradict themselves."""
        return bool(self.violations) or any(d.kind == "component" or "not analysed" in d.message for d in self.diagnostics)


@dataclass(frozen=True)
class _ComponentHealth:
    """What the rows of one component say; calls are identified across components."""

    missing: tuple[tuple[str, str], ...]
    macros: tuple[tuple[str, Place], ...]
    lost: tuple[tuple[Place, int, str], ...]
    calls: frozenset[str]
    unbound: tuple[tuple[str, str], ...]
    unknown: tuple[UnknownName, ...]
    violations: tuple[tuple[str, int], ...]


def examine(
    root: Path,
    packages: Collection[str] | None = None,
    settings: Settings = DEFAULT,
    *,
    rules: RuleSet = SHIPPED,
) -> Health:
    """Read and analyse the components of `packages` below `root` from scratch, by `rules`, and report how well it went. See `extract`."""
    program, health = component_program(rules), Health()
    asserted = sorted(name for name in program.relations if name.startswith("assert_"))
    keep = ["port", "port_unknown", "node_location", *asserted]

    def work(component: ComponentFacts) -> _ComponentHealth:
        rows = component.rows()
        result = program.evaluate(rows, keep=keep)
        return _component_health(component, rows, {name: result.rows(name) for name in keep}, asserted)

    with extract(root, packages, settings) as extraction:
        health.components = len(extraction.components)
        health.sources, health.built, health.installed = len(extraction.seconds), extraction.built, extraction.installed
        health.empty = [f"{c.package}/{c.name}" for c in extraction.components if not c.sources]
        health.diagnostics = list(extraction.diagnostics)
        health.unused = [_relative(path, extraction.root) for path in unused_sources(extraction.folders, extraction.seconds)]
        slowest = sorted(extraction.seconds.items(), key=lambda item: -item[1])
        health.slow = [(_relative(path, extraction.root), seconds) for path, seconds in slowest if seconds > SLOW]
        seen: set[str] = set()
        unbound: set[tuple[str, str]] = set()
        lost: set[tuple[Place, int, str]] = set()
        for done, (index, outcome) in enumerate(
            run_tasks(work, extraction.components, jobs=settings.jobs or default_jobs(), timeout=LIMITS.evaluation)
        ):
            if isinstance(outcome, Failure):
                component = extraction.components[index]
                text = f"{component.package}/{component.name} not analysed: {outcome.reason} ({outcome.detail})"
                health.diagnostics.append(Diagnostic("component", root, 1, 1, text))
            else:
                for header, path in outcome.missing:
                    health.missing[header].add(path)
                for name, place in outcome.macros:
                    health.macros[name].add(place)
                lost |= set(outcome.lost)
                seen |= outcome.calls
                unbound |= set(outcome.unbound)
                health.unknown += outcome.unknown
                for name, count in outcome.violations:
                    health.violations[name] = health.violations.get(name, 0) + count
            if settings.progress:
                settings.progress("components", done + 1, len(extraction.components))
    health.lost = sorted(lost, key=lambda body: (body[0].path, body[0].line, body[2]))
    health.calls, health.unbound = len(seen), Counter(reason for _call, reason in unbound)
    health.unknown.sort(key=lambda port: (port.at.path, port.at.line, port.component, port.name))
    return health


def _component_health(
    component: ComponentFacts, rows: Mapping[str, Any], derived: Mapping[str, Any], asserted: Collection[str]
) -> _ComponentHealth:
    paths = dict(rows["source_file"])
    places = {row[0]: Place(*row[1:]) for row in derived["node_location"]}
    return _ComponentHealth(
        missing=tuple((header, paths[file]) for file, _line, header in rows.get("include_missing", ()) if file in paths),
        macros=tuple((name, Place(paths[file], line, 1)) for file, line, name, _scope in rows.get("macro_undefined", ()) if file in paths),
        lost=tuple(
            (Place(paths[file], first, 1), last, reason) for file, first, last, reason in rows.get("source_lost", ()) if file in paths
        ),
        calls=frozenset(call for call, _name in rows.get("call", ())),
        unbound=tuple(rows.get("call_unresolved", ())),
        unknown=tuple(
            UnknownName(f"{component.package}/{component.name}", kind, name, reason, places[site])
            for (site, kind, name), reason in derived["port_unknown"]
            if site in places
        ),
        violations=tuple((name, count) for name in asserted if (count := len(list(derived[name])))),
    )


def _relative(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix() if path.is_relative_to(root) else str(path)
