"""Conducting an experiment: every variant on every component of every subject."""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from importlib.metadata import version
from typing import TYPE_CHECKING

from rosarch.base.pool import Failure
from rosarch.evaluation.experiments.comparison import EXTRA, FINDINGS, HIT, MISSED, OPTIONAL, Comparison, Element, Key, compare
from rosarch.evaluation.experiments.plan import Experiment
from rosarch.evaluation.experiments.results import Component, Outcome, Results
from rosarch.evaluation.experiments.run import Cell, Configuration, Evaluated, Runner
from rosarch.evaluation.experiments.subjects import OpenSubject, Subject, about, digest_of, opened
from rosarch.evaluation.experiments.truth import TruthError
from rosarch.extractor.settings import Settings
from rosarch.findings.model import Finding
from rosarch.rule_programs.sets import RuleSet, system_rules

if TYPE_CHECKING:
    from rosarch.extractor.workspace import Diagnostic


Check = Callable[[Subject, RuleSet], Sequence[Finding]]


def conduct(experiment: Experiment, settings: Settings, runner: Runner, check: Check) -> tuple[Results, tuple[Diagnostic, ...]]:
    """Extract the facts of all subjects, then evaluate what was not evaluated before; also what was not understood.

    `check` makes the findings in the systems of a subject.

    Raises:
        TruthError: truth is of a component that does not exist.
        ManifestError: a folder of facts is stale or damaged.
    """
    configurations = experiment.variants
    with ExitStack() as stack:
        subjects = _opened(experiment, settings, stack)
        cells = [Cell(subject, facts, each) for subject in subjects for each in configurations for facts in subject.components]
        evaluated: dict[tuple[str, Component], Evaluated | None] = {}
        diagnostics = [diagnostic for subject in subjects for diagnostic in subject.diagnostics]
        for cell, outcome in runner.run(cells):
            component = _component(cell)
            if isinstance(outcome, Failure):
                diagnostics.append(_failed(cell, outcome))
            evaluated[cell.configuration.name, component] = None if isinstance(outcome, Failure) else outcome
    outcomes = {
        each.name: {
            component: outcome
            for cell in cells
            if cell.configuration is each
            for component, outcome in _outcomes(cell, evaluated[each.name, _component(cell)])
        }
        for each in configurations
    }
    for subject in experiment.subjects:
        for each in configurations if subject.checked else ():
            outcomes[each.name][Component(subject.name, "")] = _findings(subject, check(subject, each.rules))
    return Results(experiment, outcomes, _provenance(experiment, configurations, subjects, runner.engine)), tuple(diagnostics)


def _opened(experiment: Experiment, settings: Settings, stack: ExitStack) -> list[OpenSubject]:
    found = []
    problems = []
    for subject in experiment.subjects:
        try:
            found.append(stack.enter_context(opened(subject, settings)))
        except TruthError as error:
            problems.append(str(error))
    if problems:
        raise TruthError("\n".join(problems))
    return found


def _component(cell: Cell) -> Component:
    return Component(cell.subject.subject.name, f"{cell.facts.package}/{cell.facts.name}")


def _failed(cell: Cell, failure: Failure) -> Diagnostic:
    from rosarch.extractor.workspace import Diagnostic

    what = f"{_component(cell).title} not analysed as {cell.configuration.name}: {failure.reason} ({failure.detail})"
    return Diagnostic("component", cell.subject.subject.folder, 1, 1, what)


def _outcomes(cell: Cell, evaluated: Evaluated | None) -> Iterator[tuple[Component, Outcome]]:
    """The component, and its nodes that there is truth about: these have no rows and took no time of their own."""
    own = {truth.component: truth for truth in about(cell.subject.subject, cell.facts)}
    for name in dict.fromkeys((cell.facts.name, *own)):
        comparison: Comparison = compare(own[name].document if name in own else {}, evaluated.model(name) if evaluated else {})
        alone = evaluated if name == cell.facts.name else evaluated and Evaluated((), {}, 0.0)
        yield Component(cell.subject.subject.name, f"{cell.facts.package}/{name}"), Outcome(alone, comparison, name in own)


def _findings(subject: Subject, found: Sequence[Finding]) -> Outcome:
    """Findings against those that are true; a note may be there or not."""
    elements: dict[Key, Element] = {}
    for each in found:
        key = (each.check.id, str(each.place))
        true = subject.findings is not None and key in subject.findings
        verdict = HIT if true else OPTIONAL if each.severity == "note" else EXTRA
        elements[key] = Element(f"{each.check.id}: {each.message}", str(each.place), verdict)
    for check, at in sorted((subject.findings or frozenset()) - elements.keys()):
        elements[check, at] = Element(check, at, MISSED)
    return Outcome(Evaluated((), {}, 0.0), Comparison({FINDINGS: elements}), subject.findings is not None)


def _provenance(
    experiment: Experiment, configurations: Sequence[Configuration], subjects: list[OpenSubject], engine: str
) -> tuple[tuple[str, str], ...]:
    """Versions, seeds and hashes: the same ones give the same results, but for the time they take."""
    found = [
        ("rosarch", version("rosarch")),
        ("python", platform.python_version()),
        ("engine", engine),
        ("experiment", experiment.digest),
        ("seed", str(experiment.seed)),
        ("samples", str(experiment.samples)),
    ]
    found += [(f"rules of {each.name}", each.program.hash) for each in configurations]
    if any(each.subject.checked for each in subjects):
        found += [(f"rules of systems of {each.name}", system_rules(each.rules).program.hash) for each in configurations]
    for each in subjects:
        found.append((f"facts of {each.subject.name}", digest_of([facts.key for facts in each.components])))
        if each.subject.truths:
            found.append((f"truth of {each.subject.name}", digest_of([truth.digest for truth in each.subject.truths])))
        if each.subject.findings is not None:
            found.append((f"findings of {each.subject.name}", digest_of([" ".join(finding) for finding in each.subject.findings])))
    return tuple(found)
