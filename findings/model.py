"""Findings: what checks find, with the lines that show it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.rule_programs.checks import Check


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
