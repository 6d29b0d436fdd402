"""Claims that are not made because not all of the world that they speak of was seen."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from rosarch.findings.model import Finding
from rosarch.models.openness import OpenPart


@dataclass(frozen=True)
class Withheld:
    """What would be a finding if there were no more than was seen; `because` is what was not seen."""

    finding: Finding
    because: tuple[OpenPart, ...]


def withheld(claimed: Collection[Finding], possible: Iterable[Finding], unseen: Iterable[OpenPart]) -> tuple[Withheld, ...]:
    """Those of the `possible` findings of a closed world that are not `claimed`, with what of `unseen` may be the reason.

    That is what was not seen of the nodes that a finding names; when all of these were seen, what was not seen of others.
    """
    made = {_identity(finding) for finding in claimed}
    parts = tuple(unseen)
    return tuple(Withheld(finding, _because(finding, parts)) for finding in possible if _identity(finding) not in made)


def _identity(finding: Finding) -> tuple[object, ...]:
    return finding.check.id, finding.message, finding.place


def _because(finding: Finding, unseen: tuple[OpenPart, ...]) -> tuple[OpenPart, ...]:
    words = {word.strip(",;:()") for step in finding.evidence for word in (*finding.message.split(), *step.text.split())}
    return tuple(part for part in unseen if part.node in words) or unseen
