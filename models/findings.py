"""Checks and what they find."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

from rosarch.models.places import Place

SEVERITIES = ("error", "warning", "note")
LEVELS = ("high", "medium", "low")


@dataclass(frozen=True)
class Check:
    """A check, as the block of fields at the head of its file `rules/checks/<id>.dl` describes it.

    `message` has the columns of the relation `relation` in braces. `evidence` are columns that have a place, each with a text of the same
    form ("" for the usual one): first that of the fault, then those that tell how it comes about. `columns` are names and types.
    """

    id: str
    title: str
    help: str
    impact: str
    confidence: str
    description: str
    scenario: str
    recommendation: str
    message: str
    evidence: tuple[tuple[str, str], ...]
    relation: str
    columns: tuple[tuple[str, str], ...]
    path: str

    @property
    def severity(self) -> str:
        """From impact and confidence: an error is bad and sure, a note is neither."""
        worst = max(LEVELS.index(self.impact), LEVELS.index(self.confidence))
        return "error" if (self.impact, self.confidence) == ("high", "high") else "note" if worst == 2 else "warning"


@dataclass(frozen=True)
class Evidence:
    """A step of the chain that a finding rests on."""

    text: str
    place: Place


@dataclass(frozen=True)
class Finding:
    """What a check found. The first of `evidence` is where the fault lies; `systems` are the systems (launch files) that have it."""

    check: Check
    severity: str
    message: str
    evidence: tuple[Evidence, ...]
    systems: tuple[str, ...] = ()

    @property
    def place(self) -> Place:
        """Where the fault lies."""
        return self.evidence[0].place

    @property
    def fingerprint(self) -> str:
        """Equal for the same finding after lines were shifted: made from the check, the message and the file."""
        identity = "\0".join((self.check.id, self.message, self.place.path))
        return hashlib.sha256(identity.encode("utf-8", "backslashreplace")).hexdigest()[:32]
