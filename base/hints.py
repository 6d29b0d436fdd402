"""Hints for names that are nearly right."""

from __future__ import annotations

from collections.abc import Iterable


def hint(name: str, known: Iterable[str]) -> str:
    """`, did you mean ...?` when a known name is close, to follow a message about an unknown one."""
    from difflib import get_close_matches

    close = get_close_matches(name, sorted(known), n=1)
    return f", did you mean `{close[0]}`?" if close else ""


def hint_or_all(name: str, known: Iterable[str]) -> str:
    """The same, or else all names that are known, when they are few."""
    names = sorted(known)
    return hint(name, names) or (f", there are {', '.join(names)}" if 0 < len(names) <= FEW else "")


FEW = 12


def only_candidate(name: str, known: Iterable[str]) -> str | None:
    """The known name that is close, when it is the only one: what was certainly meant."""
    from difflib import get_close_matches

    close = get_close_matches(name, sorted(known), n=2, cutoff=0.75)
    return close[0] if len(close) == 1 else None
