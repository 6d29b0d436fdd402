"""Running the cases that expectations make."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from rosarch.analysis.method import PLAIN, Method
from rosarch.base.hints import hint
from rosarch.datalog import Program
from rosarch.evaluation.expectations.actual import ActualWorkspace, Systems, is_source, require_query
from rosarch.evaluation.expectations.alone import Alone
from rosarch.evaluation.expectations.cases import Case
from rosarch.evaluation.expectations.elements import FINDING
from rosarch.evaluation.expectations.grammar import Expectation, ExpectationError
from rosarch.evaluation.expectations.judgement import Unmet, unmet
from rosarch.extractor.pipeline import extract
from rosarch.extractor.survey import Survey
from rosarch.extractor.workspace import Diagnostic, loose_workspace
from rosarch.rule_programs.sets import RuleSet, component_program, system_rules


@dataclass(frozen=True)
class FileOutcome:
    """What became of the expectations of a file."""

    path: Path
    expected: int
    unmet: tuple[Unmet, ...]


@dataclass(frozen=True)
class CaseOutcome:
    """What became of a case, file by file, and what was not understood on the way."""

    files: tuple[FileOutcome, ...]
    diagnostics: tuple[Diagnostic, ...]


@dataclass(frozen=True)
class Running:
    """How cases are run; `systems` are those of a workspace."""

    systems: Callable[[Path], Systems]
    method: Method = PLAIN


def run_cases(cases: Sequence[Case], how: Running) -> Iterator[CaseOutcome]:
    """Run cases one by one; nothing is run when an expectation asks for what there is not.

    Raises:
        ExpectationError: a relation or check does not exist; all of these are reported.
        DatalogError: the rules are wrong.
    """
    program = component_program(how.method.rules)
    _require_valid(cases, program, how.method.rules)
    for case in cases:
        yield _run(case, program, how)


def _require_valid(cases: Sequence[Case], program: Program, rules: RuleSet) -> None:
    asked = [(case, expectation) for case in cases for expectation in case.expectations]
    found = [expectation.kind is not None and expectation.kind.name == FINDING for _, expectation in asked]
    checks = [check.id for check in system_rules(rules).checks] if any(found) else []
    problems = []
    for (case, expectation), is_finding in zip(asked, found, strict=True):
        if expectation.kind is None:
            asked_of = program if is_source(expectation.marked.path) else system_rules(rules).program
            wrong = require_query(asked_of, expectation.marked, expectation.query)
        else:
            wrong = _unknown_check(expectation, checks) if is_finding else ""
        if wrong:
            problems.append(f"{case.root / expectation.marked.path}{wrong.removeprefix(expectation.marked.path)}")
    if problems:
        raise ExpectationError("\n".join(dict.fromkeys(problems)))


def _unknown_check(expectation: Expectation, checks: Sequence[str]) -> str:
    name = dict(expectation.wanted).get("check", "*")
    marked = expectation.marked
    if any(fnmatchcase(check, name) for check in checks):
        return ""
    column = marked.text_column + max(0, marked.text.find(name))
    return f"{marked.path}:{marked.line}:{column}: unknown check `{name}`{hint(name, checks)}"


@contextmanager
def observed(case: Case, program: Program, how: Running) -> Iterator[ActualWorkspace]:
    """What is found in the sources of a case."""
    loose = case.sources is not None
    surveyed = None
    if loose:
        sources = [source.absolute() for source in case.sources or ()]
        surveyed = Survey.of(loose_workspace(case.root.absolute(), sources), unused=how.method.sources.whole)
    systems = Alone(case.root, how.method.rules, how.method.engine) if loose else how.systems(case.root)
    with extract(case.root, settings=how.method.sources, surveyed=surveyed) as extraction:
        yield ActualWorkspace(case.root, extraction, program, how.method.engine, systems)


def _run(case: Case, program: Program, how: Running) -> CaseOutcome:
    with observed(case, program, how) as found:
        by_file: dict[str, list[Expectation]] = {}
        for expectation in case.expectations:
            by_file.setdefault(expectation.marked.path, []).append(expectation)
        files = []
        for path, expectations in by_file.items():
            judged = [unmet(expectation, found, expectations) for expectation in expectations]
            files.append(FileOutcome(case.root / path, len(expectations), tuple(each for each in judged if each)))
        return CaseOutcome(tuple(files), tuple(found.extraction.diagnostics))
