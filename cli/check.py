"""`rosarch check`: what is wrong with the systems that a workspace starts."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

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
    Talkative,
    Warnings,
    load_configuration,
    make_policy,
)
from rosarch.cli.check_outputs import Formats, Outputs, judge, parse_destinations, write_reports
from rosarch.cli.derivations import datalog_errors
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Folder, Jobs, Libraries, Timeout, parse_defines
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import Environment, Launches, PackagePath, SystemInputs, load_systems
from rosarch.cli.terminal import show_remaining

if TYPE_CHECKING:
    from rosarch.extractor.suppressions import Suppression
    from rosarch.models.system.analysis import SystemAnalysis


def check(
    folder: Folder,
    launches: Launches = None,
    package_path: PackagePath = None,
    environment: Environment = None,
    libraries: Libraries = None,
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
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Talkative = False,
) -> None:
    """Say what is wrong with the systems that launch files below DIR start: names, types, parameters, files that do not fit together."""
    from rosarch.models.rule_sets import system_rules
    from rosarch.reports.findings import scope_text

    check_folder(folder)
    destinations = parse_destinations(output_format, outputs)
    rules = parse_rules(own, variants, settings)
    with datalog_errors():
        checks = system_rules(rules).checks
    configuration = load_configuration(folder, config, checks)
    policy = make_policy(
        configuration, checks, errors=errors, warnings=warnings, notes=notes, ignored=ignored, fail_on=fail_on, exit_zero=exit_zero
    )
    known = baseline or (Path(configuration.baseline) if configuration.baseline and write_baseline is None else None)
    extraction = (engine, jobs, timeout, parse_defines(defines), cached)
    inputs = SystemInputs(folder, launches, package_path, environment, libraries, *extraction, rules)
    analysis = load_systems(inputs, configuration, required=True)
    show_remaining(analysis, folder, verbose)
    reported = judge(
        analysis.findings,
        policy,
        _suppressions(folder, analysis),
        checks=checks,
        baseline=known,
        new_baseline=write_baseline,
        complete=not launches,
    )
    write_reports(reported, destinations, folder, notes=verbose, scope=scope_text(analysis.systems))
    if reported.exit_code:
        raise typer.Exit(reported.exit_code)


def _suppressions(folder: Path, analysis: SystemAnalysis) -> Iterable[Suppression]:
    """The comments in all files that the analysis rests on."""
    from rosarch.extractor.files import folder_reader
    from rosarch.extractor.suppressions import find_suppressions

    paths = {path for model in analysis.models for path in model.sources}
    paths |= {evidence.place.path for finding in analysis.findings for evidence in finding.evidence}
    paths |= {place.path for system in analysis.systems for node in system.nodes for place in node.lines}
    return find_suppressions(sorted(paths), folder_reader(folder))
