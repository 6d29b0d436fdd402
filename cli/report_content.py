"""What a report is about, gathered: components, systems, findings, rates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from rosarch.cli.check_options import load_configuration, make_policy
from rosarch.cli.derivations import datalog_errors, shorten
from rosarch.cli.inputs import check_sources
from rosarch.cli.questions import SystemQuestion
from rosarch.cli.report_proofs import prove_components
from rosarch.cli.systems import load_systems_in_detail, text_reader

if TYPE_CHECKING:
    from rosarch.analysis.systems.analysis import SystemAnalysis
    from rosarch.findings.configuration import Configuration
    from rosarch.findings.policy import Reported
    from rosarch.reports.html.document import Subject
    from rosarch.rule_programs.choice import RuleSet


def load_subject(question: SystemQuestion, link: str | None, *, chains: bool, proofs: bool) -> Subject:
    """Analyse and check what a report is about; `chains` of cause and effect take longer than the rest."""
    from rosarch.reports.html.document import Subject
    from rosarch.rule_programs.sets import system_rules

    folder = check_sources(question.folder)
    rules = question.rules()
    with datalog_errors():
        checks = system_rules(rules).checks
    configuration = load_configuration(folder, None, checks)
    analysis = question.analysis(rules, folder, None)
    followed = replace(rules, flows=chains)
    inputs = question.inputs(followed)
    composed, details = load_systems_in_detail(inputs, configuration, shorten if proofs else None)
    read = text_reader(inputs, configuration)
    reported = _judged(question, rules, configuration, composed, read)
    return Subject(
        title=folder.resolve().name,
        folder=folder,
        read=read,
        models=analysis.models,
        systems=composed.systems,
        reported=reported,
        diagnostics=tuple(dict.fromkeys((*analysis.diagnostics, *composed.diagnostics))),
        details=details,
        derivations=prove_components(question, followed) if proofs else {},
        link=link,
    )


def _judged(
    question: SystemQuestion, rules: RuleSet, configuration: Configuration, composed: SystemAnalysis, read: Callable[[str], str | None]
) -> Reported:
    """The findings as the configuration wants them, those that comments suppress apart."""
    from rosarch.analysis.systems.check_result import checked
    from rosarch.extractor.suppressions import find_suppressions
    from rosarch.findings.policy import apply_policy
    from rosarch.rule_programs.sets import system_rules

    checks = system_rules(rules).checks
    comments = find_suppressions(checked(composed).files, read)
    policy = make_policy(configuration, checks)
    return apply_policy(composed.findings, policy, comments, checks=checks, complete=not question.launches)
