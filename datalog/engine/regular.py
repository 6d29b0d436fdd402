"""Regular expressions of `match`: ECMAScript's, as souffle has them, matched in bounded time.

Python's matcher backtracks. It is used for expressions with which that cannot take long, and RE2, whose time is linear in the text, for
all others. RE2 has no backward references and no looking ahead or behind: expressions with these that may take long are rejected.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from rosarch.datalog.language.domain import EvaluationError

Matcher = Callable[[str], Any]
MAX_REPEATS = 2  # unbounded repetitions side by side that backtracking may try: cubic in the text
_FLAGS = re.DOTALL | re.ASCII
_POSIX_CLASSES = {
    "alnum": "a-zA-Z0-9", "alpha": "a-zA-Z", "blank": r" \t", "digit": "0-9", "lower": "a-z", "space": r"\s",
    "upper": "A-Z", "xdigit": "0-9a-fA-F", "punct": r"!-/:-@\[-`{-~", "w": r"\w", "d": r"\d", "s": r"\s",
}  # fmt: skip
_TOKEN = re.compile(
    r"""
    (?P<escape>\\.)
    | (?P<set>\[\^?\]?(?:\\.|[^\]\\])*\])
    | (?P<open>\((?:\?(?:<?[=!]|P?<\w+>|[a-zA-Z-]*:|>)?)?)
    | (?P<close>\))
    | (?P<choice>\|)
    | (?P<repeat>(?:[*+?]|\{(?P<low>\d+)(?P<more>,(?P<high>\d*))?\})[?+]?)
    | (?P<other>.)
    """,
    re.VERBOSE | re.DOTALL,
)


@lru_cache(maxsize=4096)
def full_match(pattern: str) -> Matcher | None:
    """What gives None for a text that the expression does not match as a whole; None when the expression is not valid.

    Raises EvaluationError for an expression whose matching cannot be bounded.
    """
    translated = re.sub(r"\[:(\w+):\]", lambda m: _POSIX_CLASSES.get(m[1], m[0]), pattern)
    tokens = list(_TOKEN.finditer(translated))
    if any(token["other"] == "{" for token in tokens):
        return None
    try:
        compiled = re.compile(translated, _FLAGS)
    except (re.error, OverflowError, RecursionError):
        return None
    return compiled.fullmatch if _unbounded(tokens) <= MAX_REPEATS else _linear(tokens, pattern)


@dataclass
class _Sequence:
    """What was read of a sequence: the repetitions that backtracking may have to try, of its last item too, and whether these vary."""

    repeats: int = 0
    varies: bool = False
    last: tuple[int, bool] = (0, False)

    def add(self, repeats: int, varies: bool) -> None:
        """One item more."""
        self.repeats += repeats
        self.varies |= varies
        self.last = repeats, varies

    def repeat(self, low: int, high: int | None) -> None:
        """The last item may come between `low` and `high` times: repetitions within others multiply."""
        inner, varies = self.last
        if low != high and (high is None or high > 8):
            found = 100 if inner or varies else 1
        elif high is not None and high > 1:
            found = inner * min(high, 100) + (varies and high > 8)
        else:
            found = inner
        self.repeats -= inner
        self.add(found, varies or low != high)


def _unbounded(tokens: Iterable[re.Match[str]]) -> int:
    """How many repetitions a backtracking matcher may have to try against each other; many when one is inside of another."""
    open_ = [_Sequence()]
    for token in tokens:
        if token.lastgroup == "open":
            open_.append(_Sequence())
        elif token.lastgroup == "close" and len(open_) > 1:
            inner = open_.pop()
            open_[-1].add(inner.repeats, inner.varies)
        elif token.lastgroup == "choice":
            open_[-1].varies = True
        elif token.lastgroup == "repeat":
            open_[-1].repeat(*_times(token))
        else:
            open_[-1].add(0, False)
    return open_[0].repeats


def _times(token: re.Match[str]) -> tuple[int, int | None]:
    """How often at least and at most; None for without end."""
    if token["low"] is None:
        return {"*": (0, None), "+": (1, None), "?": (0, 1)}[token[0][0]]
    low = int(token["low"])
    return low, low if token["more"] is None else int(token["high"]) if token["high"] else None


def _linear(tokens: Iterable[re.Match[str]], pattern: str) -> Matcher:
    """The same by RE2."""
    import re2  # what has no such expressions need not load it

    options = re2.Options()
    options.dot_nl = options.never_capture = True
    options.log_errors = False
    try:
        compiled = re2.compile("".join(map(_for_re2, tokens)).encode(errors="surrogatepass"), options)
    except re2.error:
        reason = "with a backward reference, a look-ahead or too many repetitions"
        raise EvaluationError(f"regular expression that may take for ever, {reason}: `{pattern[:60]}`") from None
    return lambda text: compiled.fullmatch(text.encode(errors="surrogatepass"))


def _for_re2(token: re.Match[str]) -> str:
    """A token as RE2 spells it, to which a vertical tab is no space."""
    if token.lastgroup == "set":
        return re.sub(r"\\.", lambda escape: {r"\s": "[:space:]", r"\S": "[:^space:]"}.get(escape[0], escape[0]), token[0])
    return {r"\s": "[[:space:]]", r"\S": "[[:^space:]]", r"\Z": r"\z"}.get(token[0], token[0])
