"""Expectations as cases of the mutation of rules: a changed rule is noticed when one of them is not met any more."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from rosarch.datalog import Program, Result
from rosarch.datalog.inspection.mutation import Case as MutationCase
from rosarch.datalog.inspection.rows import Row
from rosarch.evaluation.expectations.actual import ActualWorkspace, ObservedComponent, is_source
from rosarch.evaluation.expectations.cases import Case
from rosarch.evaluation.expectations.elements import FINDING
from rosarch.evaluation.expectations.grammar import Expectation
from rosarch.evaluation.expectations.judgement import unmet
from rosarch.evaluation.expectations.run import Running, observed
from rosarch.models.component import ComponentModel


def mutation_cases(program: Program, cases: Sequence[Case], how: Running) -> Iterator[MutationCase]:
    """A case for each component that its sources expect something of, or that findings are expected about."""
    for case in cases:
        with observed(case, program, how) as found:
            if any(map(is_finding, case.expectations)):
                found.systems.findings_with(())  # what is around the components is read here, once for all that judge mutants
            for component in found.components:
                own = [e for e in case.expectations if _is_about(e, component, found)]
                if own and component.rows:
                    looked_at = [relations_of(program, expectation) for expectation in own]
                    fails = partial(_fails, found, component, own, looked_at)
                    name = f"{case.root}: {component.facts.name}"
                    yield MutationCase(name, component.result.all_rows(), frozenset().union(*looked_at), fails)


def model_cases(
    program: Program, case: Case, how: Running, shown: Callable[[ComponentModel], object]
) -> Iterator[MutationCase]:  # fmt: skip
    """A case for each component of single sources, whose test compares what `shown` makes of its model."""
    with observed(case, program, how) as found:
        for component in found.components:
            rows = component.result.all_rows()
            fails = partial(_shows_other, component, shown, shown(component.model))
            yield MutationCase(f"{case.root}: {component.facts.name}", rows, frozenset(program.outputs), fails)


def _is_about(expectation: Expectation, component: ObservedComponent, found: ActualWorkspace) -> bool:
    """Whether an expectation is about a component; what checks find in systems may be about each in them."""
    if is_finding(expectation):
        return True
    return is_source(expectation.marked.path) and component in found.of(expectation.marked.path)


def is_finding(expectation: Expectation) -> bool:
    """Whether a check is expected to find something, or not to."""
    return expectation.kind is not None and expectation.kind.name == FINDING


def relations_of(program: Program, expectation: Expectation) -> frozenset[str]:
    """The relations that an expectation looks at: those in its query, or what models are made from where an element is expected."""
    if expectation.kind is not None:
        return frozenset(program.outputs)
    return frozenset(re.findall(r"[\w.]+", expectation.query)) & program.relations.keys()


def _fails(
    found: ActualWorkspace,
    component: ObservedComponent,
    expected: Sequence[Expectation],
    looked_at: Sequence[frozenset[str]],
    rows: Mapping[str, Collection[Row]],
) -> bool:
    """Whether an expectation that is met is not when some relations of the component have these rows."""
    changed = _with_rows(component, rows)
    seen = found.with_component(component, changed)
    asked = [e for e, relations in zip(expected, looked_at, strict=True) if not relations.isdisjoint(rows)]
    try:
        if any(map(is_finding, asked)) and changed.model == component.model:
            asked = [e for e in asked if not is_finding(e)]
        return any(unmet(e, seen, expected) is not None for e in asked)
    except (LookupError, ValueError):
        return True  # no model can be made of such rows


def _shows_other(
    component: ObservedComponent, shown: Callable[[ComponentModel], object], usual: object, rows: Mapping[str, Collection[Row]]
) -> bool:  # fmt: skip
    try:
        return shown(_with_rows(component, rows).model) != usual
    except (LookupError, ValueError):
        return True


def _with_rows(component: ObservedComponent, rows: Mapping[str, Collection[Row]]) -> ObservedComponent:
    changed = replace(component)
    changed.rows = component.rows  # the extraction is over
    changed.result = Result.of({**component.result.all_rows(), **rows}, component.program)
    return changed
