"""The proofs that a report brings with it of what components have; those of systems come with these."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from rosarch.cli.derivations import facts_of, shorten
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.terminal import progress

if TYPE_CHECKING:
    from rosarch.datalog import Program
    from rosarch.extractor.selection import SelectedComponent
    from rosarch.models.derivations import Derivations
    from rosarch.rule_programs.choice import RuleSet


def prove_components(question: SystemQuestion, rules: RuleSet) -> Mapping[str, Derivations]:
    """By the names of components, in worker processes, or as they were; what takes too long is left out."""
    from rosarch.base.limits import LIMITS
    from rosarch.base.pool import Failure, default_jobs, run_tasks
    from rosarch.datalog.inspection.clauses import rules_of
    from rosarch.extractor.selection import select
    from rosarch.models.derivations import Derivations, component_derivations
    from rosarch.rule_programs.sets import component_program

    program, engine, sources = component_program(rules), question.engine.value, question.sources()
    cache = sources.cache
    found: dict[str, Derivations] = {}
    with progress() as report, select(question.folder, settings=replace(sources, progress=report)) as selection:
        waiting: list[tuple[SelectedComponent, str | None]] = []
        for component in selection.components:
            key = _key(program, engine, component)
            known = cache.load_value(key, Derivations) if cache and key else None
            if known is None:
                waiting.append((component, key))
            else:
                found[component.title] = known
        if waiting:
            rules_of(program)  # once, for all workers

        def work(index: int) -> Derivations:
            return component_derivations(program, facts_of(waiting[index][0], program), engine, shorten)

        for index, outcome in run_tasks(work, range(len(waiting)), jobs=sources.jobs or default_jobs(), timeout=LIMITS.evaluation):
            component, key = waiting[index]
            if not isinstance(outcome, Failure):
                found[component.title] = outcome
                if cache and key:
                    cache.store_value(key, outcome)
            if report:
                report("proofs", len(found), len(selection.components))
    if cache and waiting:
        cache.trim()
    return found


def _key(program: Program, engine: str, component: SelectedComponent) -> str | None:
    from rosarch.analysis.cache import models_version
    from rosarch.base.cache import hash_of

    return hash_of(["proofs", models_version(), program.hash, engine, component.title, component.key]) if component.key else None
