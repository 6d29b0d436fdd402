"""Source locations, diagnostics and the one exception of the package."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

LONGEST_LINE = 200  # characters of a source line that a message shows


class Location(NamedTuple):
    """A position in a rule file; `line` and `column` count from 1."""

    path: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.path}:{self.line}:{self.column}"


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One error or warning; `source` is the text of the line it points at."""

    message: str
    location: Location | None = None
    hint: str = ""
    source: str = ""
    severity: str = "error"

    @property
    def headline(self) -> str:
        """`path:line:col: message`, with the hint after a comma."""
        label = "warning: " if self.severity == "warning" else ""
        place = f"{self.location}: " if self.location else ""
        hint = f", {self.hint}" if self.hint else ""
        return f"{place}{label}{self.message}{hint}"

    def __str__(self) -> str:
        if not self.source or self.location is None:
            return self.headline
        source, at = self.source, self.location.column - 1
        if len(source) > LONGEST_LINE:
            start = max(0, at - LONGEST_LINE // 2)
            source, at = source[start : start + LONGEST_LINE], at - start
        pad = "".join("\t" if c == "\t" else " " for c in source[:at])
        return f"{self.headline}\n    {source}\n    {pad}^"


class DatalogError(Exception):
    """A program that cannot be loaded or evaluated; carries every diagnostic found."""

    def __init__(self, diagnostics: Sequence[Diagnostic] | str) -> None:
        if isinstance(diagnostics, str):
            diagnostics = [Diagnostic(diagnostics)]
        self.diagnostics = list(diagnostics)
        super().__init__("\n".join(str(d) for d in self.diagnostics))

    def __reduce__(self) -> tuple[type[DatalogError], tuple[list[Diagnostic]]]:
        return type(self), (self.diagnostics,)


def with_lines(error: DatalogError, sources: dict[str, str]) -> DatalogError:
    """The error with the source lines of its places."""
    report = Report(sources)
    for diagnostic in error.diagnostics:
        report.error(diagnostic.message, diagnostic.location, diagnostic.hint)
    return DatalogError(report.errors)


def parse_location(text: str) -> Location:
    """The location that `path:line:col` shows."""
    path, line, column = text.rsplit(":", 2)
    return Location(path, int(line), int(column))


def closest(name: str, known: Iterable[str]) -> str:
    """The name that a misspelled one may have been meant to be, or an empty string when nothing known is close."""
    return next(iter(difflib.get_close_matches(name, list(known), n=1, cutoff=0.7)), "")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """The hint for a misspelled `name`, or an empty string when nothing known is close."""
    close = closest(name, known)
    return f"did you mean `{close}`?" if close else ""


class Report:
    """Collects diagnostics and fills in the source lines they point at."""

    def __init__(self, sources: dict[str, str]) -> None:
        self.sources = sources
        self._lines: dict[str, list[str]] = {}
        self._seen: set[tuple[str, Location | None]] = set()
        self.refused = 0
        self.errors: list[Diagnostic] = []
        self.warnings: list[Diagnostic] = []

    def _source_line(self, location: Location | None) -> str:
        if location is None or location.path not in self.sources:
            return ""
        if location.path not in self._lines:
            self._lines[location.path] = self.sources[location.path].splitlines()
        lines = self._lines[location.path]
        return lines[location.line - 1] if 0 < location.line <= len(lines) else ""

    def _add(self, message: str, location: Location | None, hint: str, severity: str) -> None:
        if (message, location) in self._seen:
            return
        self._seen.add((message, location))
        target = self.errors if severity == "error" else self.warnings
        target.append(Diagnostic(message, location, hint, self._source_line(location), severity))

    def error(self, message: str, location: Location | None, hint: str = "") -> None:
        """Record an error; one message is kept once per place, but counts whenever it is reported: a clause may have copies."""
        self.refused += 1
        self._add(message, location, hint, "error")

    def warning(self, message: str, location: Location | None, hint: str = "") -> None:
        """Record a warning."""
        self._add(message, location, hint, "warning")

    def raise_errors(self) -> None:
        """Raise all errors recorded so far, in source order."""
        if self.errors:
            raise DatalogError(sorted(self.errors, key=lambda d: d.location or Location("", 0, 0)))
