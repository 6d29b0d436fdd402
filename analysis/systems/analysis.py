"""From a workspace and its launch files to systems and findings."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from rosarch.analysis.method import PLAIN, Method, rules_hash
from rosarch.analysis.systems.shared import Launch, SharedFacts, SystemFacts, shared_facts
from rosarch.base.cache import Cache, hash_of
from rosarch.base.diagnostics import Diagnostic
from rosarch.base.memo import Memo, stage_version
from rosarch.base.places import Place
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.findings.model import Finding
from rosarch.models.component import ComponentModel
from rosarch.models.system.model import SystemModel
from rosarch.models.system.rows import Rows

if TYPE_CHECKING:
    from rosarch.datalog import Result
    from rosarch.rule_programs.sets import SystemRules


@dataclass(frozen=True)
class SystemAnalysis:
    """The systems of a workspace, the findings about them (each once, with the systems that have it), and what was not understood."""

    systems: tuple[SystemModel, ...]
    findings: tuple[Finding, ...]
    models: tuple[ComponentModel, ...]
    diagnostics: tuple[Diagnostic, ...]


Composed = tuple[SystemModel, list[Finding]]
"""A system, and what checks find in it."""
Made = TypeVar("Made")
Maker = Callable[["SystemRules", Launch, Rows, Method], Made]


def analyze_systems(root: Path, launches: Sequence[Launch], method: Method = PLAIN, memo: Memo | None = None) -> SystemAnalysis:
    """Compose the nodes that `launches` start from their components, and check each system, by `method`.

    See shared_facts for the components.
    """
    shared = shared_facts(root, launches, method, memo)
    found: dict[int, Composed | Failure] = {}
    for index, outcome in each_system("system", shared, launches, method, _system):
        found[index] = outcome
        if method.sources.progress:
            method.sources.progress("systems", len(found), len(launches))
    return gathered(shared, launches, found)


def gathered(shared: SharedFacts, launches: Sequence[Launch], found: Mapping[int, Composed | Failure]) -> SystemAnalysis:
    """What was found of launches, by their indices, as one."""
    made = {index: outcome for index, outcome in found.items() if not isinstance(outcome, Failure)}
    diagnostics = list(shared.diagnostics)
    for index, outcome in found.items():
        if isinstance(outcome, Failure):
            detail = f"{launches[index].name} not composed: {outcome.reason} ({outcome.detail})"
            diagnostics.append(Diagnostic("launch", shared.root, 1, 1, detail))
    systems = sorted((system for system, _ in made.values()), key=lambda system: system.name)
    raised = [finding for index in sorted(made) for finding in made[index][1]]
    return SystemAnalysis(tuple(systems), _together(raised), shared.models, tuple(diagnostics))


def findings_in(shared: SharedFacts, launches: Sequence[Launch], method: Method) -> tuple[Finding, ...]:
    """What checks find in the systems of `launches`; all in this process, and nothing is kept."""
    from rosarch.rule_programs.sets import system_rules

    rules = system_rules(method.rules)
    return _together([found for launch in launches for found in _system(rules, launch, shared.rows(launch), method)[1]])


def each_system(
    stage: str,
    shared: SharedFacts,
    launches: Sequence[Launch],
    method: Method,
    make: Maker[Made],
    before: Callable[[SystemRules], object] | None = None,
) -> Iterator[tuple[int, Made | Failure]]:
    """What `make` makes of each launch, by its index: as it was when all facts are the same, else worked out in worker processes.

    `stage` names in the cache what is made; `before` is called with the rules before there are workers, which then have what it reads.
    """
    kept = SystemCache(method.sources.cache, stage, rules_hash(method.rules), method.engine) if method.sources.cache else None
    facts = list(map(shared.facts, launches))
    waiting = []
    for index, launch in enumerate(launches):
        known = kept.load(launch, facts[index]) if kept else None
        if known is None:
            waiting.append(index)
        else:
            yield index, known
    if not waiting:
        return
    from rosarch.base.limits import LIMITS
    from rosarch.rule_programs.sets import system_rules

    rules = system_rules(method.rules)
    if before:
        before(rules)

    def work(index: int) -> Made:
        return make(rules, launches[index], facts[index].rows(), method)

    for done, outcome in run_tasks(work, waiting, jobs=method.sources.jobs or default_jobs(), timeout=LIMITS.evaluation):
        if kept and not isinstance(outcome, Failure):
            kept.store(launches[waiting[done]], facts[waiting[done]], outcome)
        yield waiting[done], outcome
    if kept:
        kept.cache.trim()


@dataclass(frozen=True)
class SystemCache:
    """What rules make of systems; `rules` is a hash of those that do not ship."""

    cache: Cache
    stage: str
    rules: str
    engine: str

    def load(self, launch: Launch, facts: SystemFacts) -> Any:
        """What was made of a system, found by a hash of all its facts; None when there is nothing."""
        return self.cache.load_value(self._key(launch, facts), object)

    def store(self, launch: Launch, facts: SystemFacts, made: object) -> None:
        """Keep what was made of a system."""
        self.cache.store_value(self._key(launch, facts), made)

    def _key(self, launch: Launch, facts: SystemFacts) -> str:
        words = (launch.name, "", *launch.words, "")
        return hash_of([self.stage, stage_version(), self.rules, self.engine, *words, facts.digest()])


def _system(rules: SystemRules, launch: Launch, rows: Rows, method: Method) -> Composed:
    from rosarch.models.system.build import evaluate

    return composed(rules, launch, rows, evaluate(rules, rows, method.engine))


def composed(rules: SystemRules, launch: Launch, rows: Rows, result: Result) -> Composed:
    """The model of a system and its findings, from what rules derived: those about the workspace."""
    from rosarch.findings.of_systems import findings
    from rosarch.models.system.build import system_model

    places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
    found = findings(rules.checks, result, places, launch.name, launch.packages.underlay.holds)
    return system_model(launch.name, launch.words, rows, result, places), found


def _together(found: Sequence[Finding]) -> tuple[Finding, ...]:
    """Findings that several systems have, or several nodes by one line of a source, once."""
    alike: dict[tuple[str, str, Place], list[Finding]] = defaultdict(list)
    for finding in sorted(found, key=lambda finding: finding.message):
        alike[finding.check.id, finding.fault or finding.message, finding.place].append(finding)
    once = _of_configurations(sorted(map(_joined, alike.values()), key=attrgetter("place")))
    return tuple(sorted(once, key=lambda finding: (finding.place, finding.check.id, finding.message)))


def _of_configurations(found: Iterable[Finding]) -> Iterator[Finding]:
    """Findings about one node, one where no two of them are in one system: there, another configuration has it at another line."""
    same: dict[tuple[str, str, str], list[Finding]] = defaultdict(list)
    for finding in found:
        same[finding.check.id, finding.message, finding.place.path].append(finding)
    for alike in same.values():
        systems = [system for one in alike for system in one.systems]
        if len(alike) == 1 or not alike[0].node or len(set(systems)) < len(systems):
            yield from alike
        else:
            evidence = tuple(dict.fromkeys([*alike[0].evidence, *(one.evidence[0] for one in alike)]))
            yield replace(_joined(alike), evidence=evidence)


def _joined(alike: Sequence[Finding]) -> Finding:
    first = alike[0]
    systems, changes = ({each for one in alike for each in part(one)} for part in (attrgetter("systems"), attrgetter("changes")))
    nodes = ", ".join(dict.fromkeys(one.node for one in alike if one.node != first.node))
    message = f"{first.message} (also: {nodes})" if nodes else first.message
    return replace(first, message=message, systems=tuple(sorted(systems)), changes=tuple(sorted(changes)))
