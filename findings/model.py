"""Findings: what checks find, with the lines that show it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.rule_programs.checks import Check


@dataclass(frozen=True)
class Evidence:
    """A step of the chain that a finding rests on."""

    text: str
    place: Place


@dataclass(frozen=True, order=True)
class Change:
    """A part of a fix: the text `written` in what begins at `place` is to be `meant`; where it is empty, `meant` is a new line below."""

    place: Place
    written: str
    meant: str

    def __str__(self) -> str:
        return f"`{self.written}` becomes `{self.meant}`" if self.written else added([self.meant])


def added(lines: Sequence[str]) -> str:
    """What to do where lines are missing."""
    return f"add the {'line' if len(lines) == 1 else 'lines'} {', '.join(f'`{line}`' for line in lines)} below"


@dataclass(frozen=True)
class Finding:
    """What a check found. The first of `evidence` is where the fault lies; `systems` are the systems (launch files) that have it.

    `changes` are what rules take for its fix. `node` is the one that it is about, if it is one, and `fault` is then the message without
    its name: what several nodes have by one line of a source is to be fixed once.
    """

    check: Check
    severity: str
    message: str
    evidence: tuple[Evidence, ...]
    systems: tuple[str, ...] = ()
    changes: tuple[Change, ...] = ()
    node: str = ""
    fault: str = ""

    @property
    def fix(self) -> tuple[Change, ...]:
        """The changes that fix it; none where one text would become several."""
        texts = [(change.place, change.written) for change in self.changes if change.written]
        return self.changes if len(set(texts)) == len(texts) else ()

    @property
    def place(self) -> Place:
        """Where the fault lies."""
        return self.evidence[0].place

    @property
    def fingerprint(self) -> str:
        """Equal for the same finding after lines were shifted: made from the check, the message and the file."""
        identity = "\0".join((self.check.id, self.message, self.place.path))
        return hashlib.sha256(identity.encode("utf-8", "backslashreplace")).hexdigest()[:32]
