"""`rosarch check`: what is wrong with the systems that a workspace starts."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from rosarch.cli.check_options import (
    BaselineFile,
    ConfigFile,
    Errors,
    ExitZero,
    Failing,
    Ignored,
    NewBaseline,
    Notes,
    ShowWithheld,
    Talkative,
    Warnings,
    load_configuration,
    make_policy,
)
from rosarch.cli.check_outputs import Formats, Outputs, judge, parse_destinations, write_reports
from rosarch.cli.inputs import check_sources
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.repairs import ROUNDS, Diff, Fix, check_repairs, fixed, show_diff
from rosarch.cli.systems import check_systems, text_reader
from rosarch.cli.terminal import show_remaining

if TYPE_CHECKING:
    from rosarch.analysis.systems.check_result import CheckResult
    from rosarch.findings.policy import Reported
    from rosarch.findings.withheld import Withheld
    from rosarch.rule_programs.checks import Check
    from rosarch.rule_programs.choice import RuleSet


@asks("verbose")
def check(
    question: SystemQuestion,
    config: ConfigFile = None,
    output_format: Formats = "text",
    outputs: Outputs = None,
    errors: Errors = None,
    warnings: Warnings = None,
    notes: Notes = None,
    ignored: Ignored = None,
    fail_on: Failing = None,
    exit_zero: ExitZero = False,
    baseline: BaselineFile = None,
    write_baseline: NewBaseline = None,
    withheld: ShowWithheld = False,
    fix: Fix = False,
    diff: Diff = False,
    verbose: Talkative = False,
) -> None:
    """Check the systems that launch files below DIR start: report names, types, parameters and files that do not fit together."""
    from rosarch.reports.findings import scope_text
    from rosarch.rule_programs.choice import closed_world

    folder = check_sources(question.folder)
    destinations = parse_destinations(output_format, outputs)
    check_repairs(fix, diff)
    rules = question.rules()
    checks = _checks(rules)
    configuration = load_configuration(folder, config, checks)
    policy = make_policy(
        configuration, checks, errors=errors, warnings=warnings, notes=notes, ignored=ignored, fail_on=fail_on, exit_zero=exit_zero
    )
    known = baseline or (Path(configuration.baseline) if configuration.baseline and write_baseline is None else None)
    inputs = question.inputs(rules)
    read = text_reader(inputs, configuration)
    since = time.time_ns()
    checked = check_systems(inputs, configuration)

    def judged() -> Reported:
        from rosarch.extractor.suppressions import find_suppressions

        return judge(
            checked.findings,
            policy,
            find_suppressions(checked.files, read),
            checks=checks,
            baseline=known,
            new_baseline=write_baseline,
            complete=not question.launches,
        )

    reported = judged()
    if diff:
        raise typer.Exit(int(show_diff(reported.shown, folder, since)))
    for _ in range(ROUNDS if fix else 0):
        if not fixed(reported.shown, folder, since):
            break
        since = time.time_ns()
        checked = check_systems(inputs, configuration)
        reported = judged()
    show_remaining(checked, folder, verbose)
    if withheld:
        reported = replace(reported, withheld=_withheld(checked, check_systems(question.inputs(closed_world(rules)), configuration)))
    underlay = inputs.method.sources.underlay
    scope = scope_text(checked.scope, underlay)
    write_reports(reported, destinations, folder, read, notes=verbose, scope=scope, underlay=underlay, rules=_description(rules))
    if reported.exit_code:
        raise typer.Exit(reported.exit_code)


def _withheld(checked: CheckResult, closed: CheckResult) -> tuple[Withheld, ...]:
    """What would be claimed of these systems in a closed world, and is not."""
    from rosarch.findings.withheld import withheld

    return withheld(checked.findings, closed.findings, checked.unseen)


def _checks(rules: RuleSet) -> tuple[Check, ...]:
    """All checks; the user's own must be rules that make sense."""
    from rosarch.rule_programs.choice import SHIPPED

    if rules == SHIPPED:
        from rosarch.rule_programs.checks import shipped_checks

        return shipped_checks()
    from rosarch.cli.derivations import datalog_errors
    from rosarch.rule_programs.sets import system_rules

    with datalog_errors():
        return system_rules(rules).checks


def _description(rules: RuleSet) -> Mapping[str, Any]:
    """What reports say about the rules, unless they are those that ship."""
    from rosarch.rule_programs.choice import SHIPPED

    if rules == SHIPPED:
        return {}
    from rosarch.rule_programs.sets import described

    return described(rules)
