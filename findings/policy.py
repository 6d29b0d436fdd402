"""What becomes of findings: how severe each is, which are reported, and when the run has failed."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase

from rosarch.base.path_patterns import path_matches
from rosarch.extractor.suppressions import Suppression
from rosarch.findings.baseline import Baseline, BaselineEntry, compare
from rosarch.findings.model import Finding
from rosarch.findings.suppressions import COMMENT_CHECKS, Suppressed, suppress
from rosarch.findings.withheld import Withheld
from rosarch.rule_programs.checks import SEVERITIES, Check

IGNORE = "ignore"
CHOICES = (*SEVERITIES, IGNORE)
NEVER = "never"
THRESHOLDS = (*SEVERITIES, NEVER)

Severities = tuple[tuple[str, str], ...]
"""Pairs of a check id, in which `*` and `?` are wildcards, and one of `CHOICES`."""


@dataclass(frozen=True)
class Policy:
    """What a team or a user wants reported.

    Of the layers of `severities` a later one overrules an earlier one: the command line the configuration file. In a layer the pattern that
    says most about the id decides, of equal ones the last.
    """

    severities: tuple[Severities, ...] = ()
    ignored_paths: tuple[str, ...] = ()
    fail_on: str = "warning"
    exit_zero: bool = False

    def severity(self, finding: Finding) -> str:
        """The severity of a finding, or `ignore`."""
        for layer in reversed(self.severities):
            rules = [(_weight(pattern), severity) for pattern, severity in layer if fnmatchcase(finding.check.id, pattern)]
            if rules:
                heaviest = max(weight for weight, _ in rules)
                return [severity for weight, severity in rules if weight == heaviest][-1]
        return finding.severity

    def ignores(self, path: str) -> bool:
        """Whether findings in a file are not reported."""
        return any(path_matches(pattern, path) for pattern in self.ignored_paths)

    def fails(self, finding: Finding) -> bool:
        """Whether a finding makes the run fail."""
        return self.fail_on != NEVER and SEVERITIES.index(finding.severity) <= SEVERITIES.index(self.fail_on)


@dataclass(frozen=True)
class Reported:
    """Findings as they are reported, sorted by place.

    `shown` are reported; `suppressed` by comments; `in_baseline` are also in the baseline, `gone` are only there; both are
    empty without a baseline (`compared`). `checks` are all that were made. `withheld` is None unless it was asked for.
    """

    policy: Policy
    checks: tuple[Check, ...]
    shown: tuple[Finding, ...]
    suppressed: tuple[Suppressed, ...] = ()
    in_baseline: tuple[Finding, ...] = ()
    gone: tuple[BaselineEntry, ...] = ()
    compared: bool = False
    withheld: tuple[Withheld, ...] | None = None

    @property
    def failed(self) -> bool:
        """Whether something was found that must not be."""
        return any(map(self.policy.fails, self.shown))

    @property
    def exit_code(self) -> int:
        """0 for clean, 1 for findings."""
        return int(self.failed and not self.policy.exit_zero)

    @property
    def baseline(self) -> Baseline:
        """A baseline after which nothing is new."""
        return Baseline.of((*self.shown, *self.in_baseline))


def apply_policy(
    findings: Iterable[Finding],
    policy: Policy,
    suppressions: Iterable[Suppression] = (),
    baseline: Baseline | None = None,
    *,
    checks: Iterable[Check],
    complete: bool = True,
) -> Reported:
    """Sort out what is reported.

    `checks` are all that were made; `suppressions` those of every file whose comments are to be judged. When only a part of the workspace
    was checked, it is not `complete`, no suppression is called unused and nothing of the baseline gone.
    """
    checks = (*sorted(checks, key=lambda check: check.id), *COMMENT_CHECKS)
    comments = [comment for comment in sorted(set(suppressions)) if not policy.ignores(comment.path)]
    staying, suppressed, about = suppress(findings, comments, identifiers(checks), complete=complete)
    active: list[Finding] = []
    hidden = [each.finding for each in suppressed]
    for finding in (*staying, *about):
        severity = policy.severity(finding)
        if severity == IGNORE or policy.ignores(finding.place.path):
            hidden.append(finding)
        else:
            active.append(replace(finding, severity=severity))
    active.sort(key=_order)
    new, known, gone = compare(baseline, active, hidden) if baseline is not None else (active, [], [])
    reported = [Suppressed(replace(each.finding, severity=policy.severity(each.finding)), each.suppression) for each in suppressed]
    reported = [each for each in reported if each.finding.severity != IGNORE]
    reported.sort(key=lambda each: _order(each.finding))
    return Reported(policy, checks, tuple(new), tuple(reported), tuple(known), tuple(gone if complete else ()), baseline is not None)


def identifiers(checks: Iterable[Check]) -> list[str]:
    """The ids of checks, and of those that are made of suppression comments."""
    return sorted({check.id for check in (*checks, *COMMENT_CHECKS)})


def unmatched(patterns: Iterable[str], checks: Collection[str]) -> list[str]:
    """The patterns that no check's id matches."""
    return [pattern for pattern in patterns if not any(fnmatchcase(check, pattern) for check in checks)]


def _weight(pattern: str) -> tuple[int, bool]:
    literal = re.sub(r"\[[^\]]*\]|[*?]", "", pattern)
    return len(literal), literal == pattern


def _order(finding: Finding) -> tuple[object, ...]:
    return (finding.place, SEVERITIES.index(finding.severity), finding.check.id, finding.message)
