"""Findings that a comment in the source suppresses, and comments that are not as they should be."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable
from dataclasses import dataclass

from rosarch.base.hints import hint
from rosarch.base.places import Place
from rosarch.extractor.suppressions import Suppression
from rosarch.findings.model import Evidence, Finding
from rosarch.rule_programs.checks import Check

_SCENARIO = '// rosarch: ignore[{}]{}\nsub_ = nh.subscribe("odom", 1, &Node::onOdom, this);'


def _about_comments(identifier: str, title: str, about: str, description: str, scenario: str, recommendation: str) -> Check:
    """A check that no rule makes."""
    return Check(
        id=identifier,
        title=title,
        help=about,
        impact="low",
        confidence="high",
        description=description,
        scenario=scenario,
        recommendation=recommendation,
        message="",
        evidence=(),
        relation="",
        columns=(),
        path="",
    )


UNUSED_SUPPRESSION = _about_comments(
    "unused-suppression",
    "Suppression comment that suppresses nothing",
    "A `rosarch: ignore[...]` comment names a check that finds nothing there.",
    "The fault was repaired, the code moved, or the id is misspelt. A comment left behind hides the next true finding.",
    _SCENARIO.format("topic-typ-mismatch", " the simulator converts"),
    "Remove the id from the comment, or correct it.",
)
SUPPRESSION_WITHOUT_REASON = _about_comments(
    "suppression-without-reason",
    "Suppression comment without a reason",
    "A `rosarch: ignore[...]` comment does not say why.",
    "Whoever reads the code next cannot judge whether the finding may still be ignored.",
    _SCENARIO.format("topic-type-mismatch", ""),
    "Write the reason behind the bracket.",
)
COMMENT_CHECKS = (UNUSED_SUPPRESSION, SUPPRESSION_WITHOUT_REASON)


@dataclass(frozen=True)
class Suppressed:
    """A finding, and the comment that suppresses it."""

    finding: Finding
    suppression: Suppression


def suppress(
    findings: Iterable[Finding], suppressions: Collection[Suppression], known: Collection[str], *, complete: bool
) -> tuple[list[Finding], list[Suppressed], list[Finding]]:
    """The findings that stay, those that are suppressed, and those about the comments.

    `known` are the ids of all checks. Unless all is `complete`, what a comment suppresses may not have been looked for.
    """
    covering: dict[tuple[str, int, str], list[Suppression]] = defaultdict(list)
    for suppression in suppressions:
        for line in range(suppression.first, suppression.last + 1):
            for check in suppression.checks:
                covering[suppression.path, line, check].append(suppression)
    staying, suppressed = [], []
    used: set[tuple[Suppression, str]] = set()
    for finding in findings:
        comments = covering.get((finding.place.path, finding.place.line, finding.check.id), [])
        used.update((comment, finding.check.id) for comment in comments)
        if comments:
            suppressed.append(Suppressed(finding, min(comments)))
        else:
            staying.append(finding)
    about = [finding for suppression in suppressions for finding in _judge(suppression, used, known, complete)]
    return staying, suppressed, about


def _judge(suppression: Suppression, used: Collection[tuple[Suppression, str]], known: Collection[str], complete: bool) -> list[Finding]:
    if not suppression.checks:
        message = "the comment names no check: write `rosarch: ignore[check-id] reason`"
        return [_finding(UNUSED_SUPPRESSION, suppression, message)]
    found = []
    for check in suppression.checks:
        if check not in known:
            message = f"no check is called `{check}`{hint(check, known)}"
        elif complete and (suppression, check) not in used:
            message = f"no finding of `{check}` is here to be suppressed"
        else:
            continue
        found.append(_finding(UNUSED_SUPPRESSION, suppression, message))
    if not suppression.reason:
        ids = ", ".join(f"`{check}`" for check in suppression.checks)
        found.append(_finding(SUPPRESSION_WITHOUT_REASON, suppression, f"findings of {ids} are suppressed without a reason"))
    return found


def _finding(check: Check, suppression: Suppression, message: str) -> Finding:
    place = Place(suppression.path, suppression.line, suppression.column)
    return Finding(check, check.severity, message, (Evidence("", place),))
