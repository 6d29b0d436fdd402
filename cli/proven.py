"""The proofs that a report brings with it: why components have what they have, and why findings are ones."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from rosarch.cli.derivations import facts_of, shorten
from rosarch.cli.inputs import extraction_cache
from rosarch.cli.options import parse_defines
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.systems import load_surrounding
from rosarch.cli.terminal import progress

if TYPE_CHECKING:
    from rosarch.models.configuration import Configuration
    from rosarch.models.derivations import Derivations
    from rosarch.models.policy import Reported
    from rosarch.models.rule_choice import RuleSet
    from rosarch.models.selection import SelectedComponent

Task = tuple[str, Callable[[], "Derivations"]]


def prove(question: SystemQuestion, rules: RuleSet, configuration: Configuration, reported: Reported) -> Mapping[str, Derivations]:
    """By the names of components and systems, in worker processes; what takes too long is left out."""
    from rosarch.extractor.limits import LIMITS
    from rosarch.extractor.pool import Failure, default_jobs, run_tasks
    from rosarch.models.derivations import component_derivations
    from rosarch.models.rule_sets import component_program
    from rosarch.models.selection import select

    program, engine = component_program(rules), question.engine.value
    tasks = _about_findings(question, rules, configuration, reported)
    found: dict[str, Derivations] = {}
    with (
        progress() as report,
        select(
            question.folder,
            jobs=question.jobs,
            timeout=question.timeout,
            defines=parse_defines(question.defines),
            cache=extraction_cache(question.cached),
            progress=report,
        ) as selection,
    ):

        def prove_component(component: SelectedComponent) -> Derivations:
            return component_derivations(program, facts_of(component, program), engine, shorten)

        tasks += [(each.title, partial(prove_component, each)) for each in selection.components]

        def work(index: int) -> Derivations:
            return tasks[index][1]()

        for index, outcome in run_tasks(work, range(len(tasks)), jobs=question.jobs or default_jobs(), timeout=LIMITS.evaluation):
            if not isinstance(outcome, Failure):
                found[tasks[index][0]] = outcome
            if report:
                report("proofs", len(found), len(tasks))
    return found


def _about_findings(question: SystemQuestion, rules: RuleSet, configuration: Configuration, reported: Reported) -> list[Task]:
    """A task for each system that is the first to have a finding."""
    from rosarch.models.derivations import finding_derivations
    from rosarch.models.rule_sets import system_rules

    systems, engine = system_rules(rules), question.engine.value
    asked: dict[str, set[str]] = defaultdict(set)
    for finding in (*reported.shown, *reported.known):
        for system in finding.systems[:1]:
            asked[system].add(finding.fingerprint)
    if not asked:
        return []
    shared, launches = load_surrounding(question.inputs(rules), configuration)

    def prove_in(index: int) -> Derivations:
        launch = launches[index]
        return finding_derivations(systems, shared.rows(launch), launch.name, asked[launch.name], engine, shorten)

    return [(launch.name, partial(prove_in, index)) for index, launch in enumerate(launches) if launch.name in asked]
