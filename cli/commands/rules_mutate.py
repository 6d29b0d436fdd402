"""`rosarch rules mutate`: would a test notice if a rule were another?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rosarch.cli.commands.rules_test import checked_path, systems_of
from rosarch.cli.derivations import datalog_errors, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.options import path_argument
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.terminal import emit, progress


@asks("engine", "defines", "verbose")
def mutate(
    reading: ReadingOptions,
    paths: Annotated[
        list[Path] | None,
        typer.Argument(parser=path_argument, metavar="[PATH]...", help="The tests, as for `rosarch rules test`."),
    ] = None,
    sample: Annotated[int | None, typer.Option("--sample", metavar="N", min=1, help="Only N mutants, chosen at random.")] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="The seed of the choice.")] = 0,
) -> None:
    """Change rules of components a literal at a time and list the changes that no test notices; those of --rules, or rosarch's own.

    Exit code 1 when there are any.
    """
    from rosarch.datalog.inspection.mutation import MutationTest, survivors_text
    from rosarch.evaluation.expectations.cases import find_cases
    from rosarch.evaluation.expectations.grammar import ExpectationError
    from rosarch.evaluation.expectations.mutation import mutation_cases
    from rosarch.evaluation.expectations.run import Running
    from rosarch.rule_programs.mutation import drop_in_cases, judge_all, mutants_of
    from rosarch.rule_programs.own_files import own_files
    from rosarch.rule_programs.sets import component_program

    given = [checked_path(path) for path in paths or [Path()]]
    rules = reading.rules()
    try:
        found = find_cases(given)
        with datalog_errors(), progress() as report:
            program = component_program(rules)
            how = Running(systems_of(rules, reading), reading.method(rules))
            cases = [*(c for folder in found.rules for c in drop_in_cases(program, folder)), *mutation_cases(program, found.cases, how)]
            if not cases:
                raise InputError(f"{', '.join(map(str, given))}: no tests of rules of components")
            test = MutationTest(program, cases)
            verdicts = judge_all(test, mutants_of(test, own_files(rules.own), sample, seed), jobs=reading.jobs, progress=report)
    except ExpectationError as error:
        raise InputError(str(error)) from None
    emit(survivors_text(verdicts, shorten=shorten))
    if any(not verdict.killed_by for verdict in verdicts):
        raise typer.Exit(1)
