"""`rosarch rules test`: what rules derive, against what sources and folders of facts expect."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rosarch.cli.derivations import datalog_errors, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_engine, check_folder, read_input
from rosarch.cli.options import Engine, path_argument
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.systems import SystemInputs, load_shared_facts, load_systems
from rosarch.cli.terminal import emit, progress, show_diagnostics

if TYPE_CHECKING:
    from rosarch.analysis.systems.shared import Launch, SharedFacts
    from rosarch.datalog import Program
    from rosarch.evaluation.expectations.run import CaseOutcome
    from rosarch.findings.configuration import Configuration
    from rosarch.findings.model import Finding
    from rosarch.models.component import ComponentModel
    from rosarch.rule_programs.sets import RuleSet


@asks("defines")
def test(
    reading: ReadingOptions,
    paths: Annotated[
        list[Path] | None,
        typer.Argument(
            parser=path_argument,
            metavar="[PATH]...",
            help="C++ or Python files, workspaces, or folders of them; by default the current folder.",
        ),
    ] = None,
    coverage: Annotated[
        bool, typer.Option("--coverage/--no-coverage", help="List the clauses that never fired in tests that are folders of facts.")
    ] = True,
) -> None:
    """Run the tests at and below each PATH; exit code 1 when one fails.

    Tests are sources with comments `expect: ...`, and folders with facts/*.facts and expected/*.csv.
    """
    from rosarch.evaluation.expectations.cases import find_cases
    from rosarch.evaluation.expectations.grammar import ExpectationError
    from rosarch.evaluation.expectations.run import Running, run_cases

    given = [checked_path(path) for path in paths or [Path()]]
    check_engine(reading.engine.value)
    rules = reading.rules()
    try:
        found = find_cases(given)
        if not (found.cases or found.rules):
            told = "a test is a source with comments `expect: ...`, or a folder with facts/*.facts and expected/*.csv"
            raise InputError(f"{', '.join(map(str, given))}: no tests; {told}")
        with datalog_errors(), progress() as report:
            how = Running(systems_of(rules, reading), reading.method(rules).reporting_to(report))
            outcomes = list(run_cases(found.cases, how))
    except ExpectationError as error:
        raise InputError(str(error)) from None
    met = _report(outcomes, reading.verbose)
    with datalog_errors():
        passed = [_run_folder(folder, rules, reading.engine, coverage) for folder in found.rules]
    if not (met and all(passed)):
        raise typer.Exit(1)


def checked_path(path: Path) -> Path:
    """A file or folder that can be read."""
    if os.path.isdir(path):
        return check_folder(path)
    read_input(path)
    return path


@dataclass(frozen=True)
class WorkspaceSystems:
    """The systems of a workspace, as `rosarch check` has them with its configuration."""

    inputs: SystemInputs
    rules: RuleSet

    @property
    def program(self) -> Program:
        from rosarch.rule_programs.sets import system_rules

        return system_rules(self.rules).program

    @cached_property
    def _configuration(self) -> Configuration:
        from rosarch.cli.check_options import load_configuration
        from rosarch.rule_programs.sets import system_rules

        return load_configuration(self.inputs.folder, None, system_rules(self.rules).checks)

    @cached_property
    def around(self) -> tuple[SharedFacts, list[Launch]]:
        """The launches, and what is known around them."""
        return load_shared_facts(self.inputs, self._configuration)

    def findings(self, _models: Sequence[ComponentModel]) -> Sequence[Finding]:
        return load_systems(self.inputs, self._configuration).findings

    def findings_with(self, models: Sequence[ComponentModel]) -> Sequence[Finding]:
        from rosarch.analysis.systems.analysis import findings_in

        shared, launches = self.around
        return findings_in(shared.with_models(launches, models), launches, self.inputs.method)

    def rows(self) -> Sequence[dict[str, list[tuple[Any, ...]]]]:
        shared, launches = self.around
        return [{name: list(rows) for name, rows in shared.rows(launch).items()} for launch in launches]


def systems_of(rules: RuleSet, reading: ReadingOptions) -> Callable[[Path], WorkspaceSystems]:
    """Gives the systems of a workspace."""
    return lambda folder: WorkspaceSystems(reading.systems_in(folder, None, rules), rules)


def _report(outcomes: Sequence[CaseOutcome], verbose: bool) -> bool:
    """Whether all expectations of sources are met, and which are not."""
    from rosarch.reports.expectations import file_text, total_text

    for outcome in outcomes:
        show_diagnostics(outcome.diagnostics, verbose)
    files = [file for outcome in outcomes for file in outcome.files]
    emit("".join([*map(file_text, files), *([total_text(files)] if files else [])]))
    return not any(file.unmet for file in files)


def _run_folder(folder: Path, rules: RuleSet, engine: Engine, coverage: bool) -> bool:
    """Whether the tests below a folder that are facts and expected rows pass."""
    from rosarch.datalog.inspection.rule_tests import outcome_text, report_text, run_rule_tests
    from rosarch.rule_programs.sets import component_program

    program = component_program(rules)
    report = run_rule_tests(folder, program, engine=engine.value, progress=lambda outcome: emit(outcome_text(outcome)))
    emit(report_text(report, shorten=shorten, unfired=coverage))
    return report.ok
