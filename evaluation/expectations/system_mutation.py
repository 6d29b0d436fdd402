"""What is expected of systems as cases of the mutation of their rules."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.datalog.inspection.mutation import Case as MutationCase
from rosarch.datalog.inspection.rows import Row
from rosarch.evaluation.expectations.cases import Case
from rosarch.evaluation.expectations.elements import Element, finding_element
from rosarch.evaluation.expectations.grammar import Expectation
from rosarch.evaluation.expectations.judgement import PlacedRow, unmet
from rosarch.evaluation.expectations.mutation import is_finding
from rosarch.evaluation.expectations.run import Running
from rosarch.findings.model import Finding
from rosarch.findings.of_systems import findings
from rosarch.models.system.build import finding_relations
from rosarch.models.system.rows import Rows
from rosarch.rule_programs.sets import SystemRules, system_rules


@dataclass(frozen=True)
class System:
    """A system: the facts about it, and the rows of all relations."""

    rules: SystemRules
    facts: Rows
    rows: Mapping[str, Collection[Row]]

    @classmethod
    def of(cls, rules: SystemRules, facts: Rows) -> System:
        """What the rules derive of a system."""
        return cls(rules, facts, rules.program.evaluate(facts, keep="all").all_rows())

    def with_rows(self, changed: Mapping[str, Collection[Row]]) -> System:
        """The system, if some relations had these rows."""
        return replace(self, rows={**self.rows, **changed})

    @property
    def result(self) -> Result:
        """The rows of all relations."""
        return Result.of(self.rows, self.rules.program)

    @property
    def places(self) -> Mapping[str, Place]:
        """All places that facts are about."""
        return {row[0]: Place(*row[1:]) for row in self.facts.get("place", ())}

    @property
    def findings(self) -> Sequence[Finding]:
        """What checks find in it."""
        return findings(self.rules.checks, self.result, self.places, "")


def finding_cases(cases: Sequence[Case], how: Running) -> Iterator[MutationCase]:
    """A case for each system of the workspaces in which checks are expected to find something, or nothing."""
    rules = system_rules(how.method.rules)
    for case in cases:
        about = list(filter(is_finding, case.expectations))
        systems = how.systems(case.root).rows() if about and case.sources is None else ()
        composed = [System.of(rules, facts) for facts in systems]
        for number, system in enumerate(composed):
            others = [finding for other in composed if other is not system for finding in other.findings]
            fails = partial(_fails, system, others, about)
            yield MutationCase(f"{case.root}: {number}", system.rows, frozenset(finding_relations(rules)), fails)


def _fails(system: System, others: Sequence[Finding], about: Sequence[Expectation], rows: Mapping[str, Collection[Row]]) -> bool:
    """Whether an expectation is not met when some relations of a system have these rows; `others` is what is found in the other systems."""
    try:
        found = _Findings((*others, *system.with_rows(rows).findings))
    except (LookupError, ValueError):
        return True  # nothing can be determined with such rows
    return any(unmet(expectation, found, about) is not None for expectation in about)


class _Findings:
    """What checks found, and nothing else."""

    def __init__(self, found: Sequence[Finding]) -> None:
        self._elements = tuple(map(finding_element, found))

    def findings(self) -> Sequence[Element]:
        return self._elements

    def elements(self, _path: str) -> Sequence[Element]:
        return ()

    def rows(self, *_asked: object) -> Sequence[str]:
        return ()

    def placed_rows(self, *_asked: object) -> Sequence[PlacedRow]:
        return ()

    def near_rows(self, *_asked: object) -> Sequence[str]:
        return ()
