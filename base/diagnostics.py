"""What was not understood of the input, with its place."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

SourceProblem = tuple[str, int, int, str]
"""What was not understood of a source, as it is kept with its facts: path, line, column and message."""


@dataclass(frozen=True)
class Diagnostic:
    """Something that was not understood, with its place; `str()` is `path:line:col: message`."""

    kind: str
    path: Path
    line: int
    column: int
    message: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}:{self.column}: {self.message}"


def source_diagnostic(problem: SourceProblem) -> Diagnostic:
    """A problem of a source as a diagnostic."""
    path, line, column, message = problem
    return Diagnostic("source", Path(path), line, column, message)


def shortened(text: str, most: int = 60) -> str:
    """A text as a message quotes it: in one line, with no more characters than that."""
    line = " ".join(text.split())
    return line if len(line) <= most else line[: most - 3] + "..."


def unreadable(path: str | Path, error: OSError) -> Diagnostic:
    """The diagnostic for a file or folder that cannot be read."""
    return Diagnostic("unreadable", Path(path), 1, 1, f"cannot be read: {why(error)}")


def why(error: OSError) -> str:
    """What the system says is wrong with a file, as the rest of a sentence."""
    text = error.strerror or str(error)
    return text[:1].lower() + text[1:]
