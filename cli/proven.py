"""The proofs that a report brings with it: why components have what they have, and why findings are ones."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from rosarch.cli.derivations import facts_of, shorten
from rosarch.cli.inputs import extraction_cache
from rosarch.cli.options import parse_defines
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.systems import load_surrounding
from rosarch.cli.terminal import progress

if TYPE_CHECKING:
    from rosarch.datalog import Program
    from rosarch.models.configuration import Configuration
    from rosarch.models.derivations import Derivations
    from rosarch.models.policy import Reported
    from rosarch.models.rule_choice import RuleSet
    from rosarch.models.selection import SelectedComponent


@dataclass(frozen=True)
class _Task:
    """The proofs of a component or system; `key` tells of all that they depend on, where that is known."""

    name: str
    prove: Callable[[], Derivations]
    key: str | None = None


def prove(question: SystemQuestion, rules: RuleSet, configuration: Configuration, reported: Reported) -> Mapping[str, Derivations]:
    """By the names of components and systems, in worker processes, or as they were; what takes too long is left out."""
    from rosarch.extractor.limits import LIMITS
    from rosarch.extractor.pool import Failure, default_jobs, run_tasks
    from rosarch.models.derivations import Derivations, component_derivations
    from rosarch.models.rule_sets import component_program
    from rosarch.models.selection import select

    program, engine = component_program(rules), question.engine.value
    tasks = _about_systems(question, rules, configuration, reported)
    found: dict[str, Derivations] = {}
    cache = extraction_cache(question.cached)
    with (
        progress() as report,
        select(
            question.folder,
            jobs=question.jobs,
            timeout=question.timeout,
            defines=parse_defines(question.defines),
            cache=cache,
            progress=report,
        ) as selection,
    ):

        def prove_component(component: SelectedComponent) -> Derivations:
            return component_derivations(program, facts_of(component, program), engine, shorten)

        tasks += [_Task(each.title, partial(prove_component, each), _key(program, engine, each)) for each in selection.components]
        waiting = []
        for task in tasks:
            known = cache.load_value(task.key, Derivations) if cache and task.key else None
            if known is None:
                waiting.append(task)
            else:
                found[task.name] = known

        def work(index: int) -> Derivations:
            return waiting[index].prove()

        for index, outcome in run_tasks(work, range(len(waiting)), jobs=question.jobs or default_jobs(), timeout=LIMITS.evaluation):
            task = waiting[index]
            if not isinstance(outcome, Failure):
                found[task.name] = outcome
                if cache and task.key:
                    cache.store_value(task.key, outcome)
            if report:
                report("proofs", len(found), len(tasks))
    if cache and waiting:
        cache.trim()
    return found


def _key(program: Program, engine: str, component: SelectedComponent) -> str | None:
    from rosarch.extractor.cache import hash_of
    from rosarch.models.cache import models_version

    return hash_of(["proofs", models_version(), program.hash, engine, component.title, component.key]) if component.key else None


def _about_systems(question: SystemQuestion, rules: RuleSet, configuration: Configuration, reported: Reported) -> list[_Task]:
    """A task for each system, for its connectors and the findings that it is the first to have."""
    from rosarch.models.derivations import system_derivations
    from rosarch.models.rule_sets import system_rules

    systems, engine = system_rules(rules), question.engine.value
    asked: dict[str, set[str]] = defaultdict(set)
    for finding in (*reported.shown, *reported.known):
        for system in finding.systems[:1]:
            asked[system].add(finding.fingerprint)
    shared, launches = load_surrounding(question.inputs(rules), configuration)

    def prove_in(index: int) -> Derivations:
        launch = launches[index]
        return system_derivations(systems, shared.rows(launch), launch.name, asked[launch.name], engine, shorten)

    return [_Task(launch.name, partial(prove_in, index)) for index, launch in enumerate(launches)]
