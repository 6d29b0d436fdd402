"""Comments by which an author says that a finding is not to be reported: `rosarch: ignore[check-id] reason`.

A comment that follows code is about that line; one that stands alone is about the next line with anything but comments. In XML, where
no comment fits into a tag, it is about every line of the tag.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

_MARK = re.compile(r"(?<![\w`-])rosarch:[ \t]*ignore\b[ \t]*(?:\[(?P<checks>[^\]\n]*)\])?(?P<reason>[^\n]*)")

_CPP = re.compile(
    r"""(?P<comment>//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z))
    |R"(?P<delimiter>[^\s()\\]{0,16})\(.*?(?:\)(?P=delimiter)"|\Z)
    |"(?:\\.|[^"\\\n])*"?
    |(?<!\w)\d[\w.]*(?:'\w+)*
    |'(?:\\.|[^'\\\n])*'?""",
    re.VERBOSE | re.DOTALL,
)
_XML = re.compile(
    r"""(?P<comment><!--.*?(?:-->|\Z))|<!\[CDATA\[.*?(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)|(?P<tag></?[A-Za-z_](?:[^<>"']+|"[^"]*"|'[^']*')*>?)""",
    re.DOTALL,
)
_PYTHON = re.compile(
    r"(?P<comment>\#[^\n]*)|(?P<quotes>'''|\"\"\")(?:\\.|.)*?(?:(?P=quotes)|\Z)|\"(?:\\.|[^\"\\\n])*\"?|'(?:\\.|[^'\\\n])*'?", re.DOTALL
)
_YAML = re.compile(r"(?P<comment>(?<!\S)\#[^\n]*)|(?<![^\s\[{,:])(?:\"(?:\\.|[^\"\\])*\"?|'(?:''|[^'])*'?)", re.DOTALL)
_CMAKE = re.compile(
    r"(?P<comment>\#\[(?P<more>=*)\[.*?(?:\](?P=more)\]|\Z)|\#[^\n]*)|\[(?P<equals>=*)\[.*?(?:\](?P=equals)\]|\Z)"
    r"|\"(?:\\.|[^\"\\])*\"?|\\.",
    re.DOTALL,
)
_PLAIN = re.compile(r"(?P<comment>\#[^\n]*)")

_SYNTAX = {
    **dict.fromkeys(
        (".c", ".cc", ".cpp", ".cxx", ".c++", ".cu", ".cuh", ".h", ".hh", ".hpp", ".hxx", ".h++", ".inl", ".ipp", ".tpp"), _CPP
    ),
    **dict.fromkeys((".launch", ".test", ".xml", ".xacro", ".urdf", ".sdf", ".world"), _XML),
    **dict.fromkeys((".py", ".cfg"), _PYTHON),
    **dict.fromkeys((".yaml", ".yml"), _YAML),
    **dict.fromkeys((".cmake",), _CMAKE),
    **dict.fromkeys((".msg", ".srv", ".action"), _PLAIN),
}
_NAMED = {"CMakeLists.txt": _CMAKE}


@dataclass(frozen=True, order=True)
class Suppression:
    """A comment that suppresses findings of `checks` on the lines `first` to `last` of `path`; it is at `line` and `column`."""

    path: str
    line: int
    column: int
    checks: tuple[str, ...]
    reason: str
    first: int
    last: int


@dataclass(frozen=True)
class Comment:
    """A comment with its marks, at `line` and `column`; it is about the lines `first` to `last`, and stands `beside` code or alone."""

    text: str
    line: int
    column: int
    first: int
    last: int
    beside: bool

    def place(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset in the text."""
        start = self.text.rfind("\n", 0, offset) + 1
        return self.line + self.text.count("\n", 0, offset), offset - start + (1 if start else self.column)


def comments(path: str, text: str) -> list[Comment]:
    """All comments of a file, none of one whose kind is not understood."""
    syntax = _syntax(path)
    return [] if syntax is None else list(_Source(text, syntax).subjects())


def has_suppressions(path: str) -> bool:
    """Whether a file is of a kind whose comments are understood."""
    return _syntax(path) is not None


def find_suppressions(paths: Iterable[str], read: Callable[[str], str | None]) -> tuple[Suppression, ...]:
    """All suppressions in files; `read` gives the text of one, or None."""
    found: list[Suppression] = []
    for path in sorted(set(filter(has_suppressions, paths))):
        text = read(path)
        if text is not None:
            found += suppressions_in(path, text)
    return tuple(found)


def suppressions_in(path: str, text: str) -> list[Suppression]:
    """The suppressions in one file."""
    syntax = _syntax(path)
    if syntax is None or "rosarch" not in text:
        return []
    return list(_Source(text, syntax).suppressions(path))


def without_end(line: str) -> str:
    """A line of a comment without the mark that ends the comment."""
    line = line.rstrip(" \t\r")
    end = next((end for end in ("*/", "-->", "--\\>") if line.endswith(end)), "")
    return line.removesuffix(end).rstrip(" \t\r")


def _syntax(path: str) -> re.Pattern[str] | None:
    name = PurePosixPath(path)
    return _NAMED.get(name.name) or _SYNTAX.get(name.suffix.lower())


class _Source:
    """The text of a file with its comments, and for each of them what it is about."""

    def __init__(self, text: str, syntax: re.Pattern[str]) -> None:
        self.text = text
        self.starts = [0, *(match.end() for match in re.finditer("\n", text))]
        tokens = list(syntax.finditer(text))
        self.comments = [match.span("comment") for match in tokens if match["comment"] is not None]
        self.tags = [match.span("tag") for match in tokens if match["tag"] is not None] if "tag" in syntax.groupindex else []
        self.before, self.after = _neighbours(text, self.comments)

    def line(self, offset: int) -> int:
        """The line of an offset, from 1."""
        return bisect_right(self.starts, offset)

    def suppressions(self, path: str) -> Iterator[Suppression]:
        """Those in all comments; each line of one may hold one."""
        for number, (start, end) in enumerate(self.comments):
            for mark in _MARK.finditer(self.text, start, end):
                checks = tuple(dict.fromkeys((mark["checks"] or "").replace(",", " ").split()))
                reason = without_end(mark["reason"]).strip(" \t:,-")
                line = self.line(mark.start())
                column = mark.start() - self.starts[line - 1] + 1
                yield Suppression(path, line, column, checks, reason, *self._subject(number))

    def subjects(self) -> Iterator[Comment]:
        """All comments with what they are about."""
        for number, (start, end) in enumerate(self.comments):
            line = self.line(start)
            beside = self.before[number] >= self.starts[line - 1]
            yield Comment(self.text[start:end], line, start - self.starts[line - 1] + 1, *self._subject(number), beside)

    def _subject(self, comment: int) -> tuple[int, int]:
        """The first and last line of what a comment is about: what stands before it on its line, else what comes next."""
        start = self.comments[comment][0]
        before, after = self.before[comment], self.after[comment]
        following = after if after < len(self.text) else start
        offset = before if before >= self.starts[self.line(start) - 1] else following
        tag = bisect_right(self.tags, (offset, len(self.text))) - 1
        first, end = self.tags[tag] if tag >= 0 and offset < self.tags[tag][1] else (offset, offset + 1)
        return self.line(first), self.line(end - 1)


def _neighbours(text: str, comments: Sequence[tuple[int, int]]) -> tuple[list[int], list[int]]:
    """For each comment the offsets of the last character of code before it (-1: none) and the first after it (the text's length: none)."""
    before, after = [], []
    last, position = -1, 0
    for start, end in comments:
        code = text[position:start].rstrip()
        last, position = position + len(code) - 1 if code else last, end
        before.append(last)
    first = position = len(text)
    for start, end in reversed(comments):
        code = text[end:position].lstrip()
        first, position = position - len(code) if code else first, start
        after.append(first)
    return before, after[::-1]
