"""The conventions of rules, asked of the shipped ones or of the user's own, in whichever program they are part of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from rosarch.datalog.inspection.conventions import unconventional
from rosarch.datalog.language.errors import Diagnostic
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.checks import evidence_of, shown_as
from rosarch.rule_programs.own_files import own_files
from rosarch.rule_programs.sets import RuleSet, chosen_variants, component_program, other_variants, rule_set, system_rules


def lint_rules(own: Sequence[Path] = ()) -> list[Diagnostic]:
    """What files of rules do not keep to, by place; by default those of rosarch.

    Raises:
        RuleSetError: a path that does not exist, or a file that fits no program.
        CheckError: a check is not as it should be.
        DatalogError: the rules are wrong.
    """
    found = _lint(rule_set(own), own)
    for chosen in () if own else other_variants():
        files = {str(path) for decision, path in chosen_variants(chosen) if path != decision.default}
        found += [diagnostic for diagnostic in _lint(chosen) if diagnostic.location and diagnostic.location.path in files]
    return sorted(set(found), key=lambda diagnostic: diagnostic.location or ("", 0, 0))


def _lint(rules: RuleSet, own: Sequence[Path] = ()) -> list[Diagnostic]:
    folder = rules_folder()
    files = {str(path) for path in own_files(own)} if own else {str(path) for path in folder.rglob("*.dl")}
    system, component = system_rules(rules), component_program(replace(rules, flows=True))
    types = {type_ for check in system.checks for _, type_ in check.columns}
    shown = {name for check in system.checks for name in (check.relation, check.fix_relation)}
    shown |= {name for type_ in types for name in (evidence_of(type_), shown_as(type_))}
    options = {name for name in component.relations if name.startswith("option")}
    return [
        *unconventional(component, files.__contains__, options),
        *unconventional(system.program, files.__contains__, shown | options),
    ]
