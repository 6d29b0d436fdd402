"""Fixes: where exactly in a file the changes of findings are, and files with them carried out.

A change is carried out only where its text is certain: where what begins at its place (an element of XML, a call, a line) has the text
exactly once. All else of a file stays as it is, byte for byte.
"""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import LARGEST, read_file
from rosarch.base.whole import write_whole
from rosarch.findings.model import Change, Finding

_TAG = re.compile(r"<(?P<name>[\w.:-]+)[^<>\"']*(?:(?:\"[^\"]*\"|'[^']*')[^<>\"']*)*>")
_TOKEN = re.compile(r"\"\"\"|'''|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|#[^\n]*|[()\[\]{}\n]")
_PLAIN = re.compile(r"[^\r\n\"'<>&{}]+")
_ELEMENT = re.compile(r"([ \t]*)<(\w+)(?:\s[^<>]*)?>[^<>]*</\2>[ \t]*(?:<!--(?:(?!--).)*-->[ \t]*)?")
_NEWLINE = re.compile(r"\r\n|\n|\r")
_BEFORE, _AFTER = r"(?<![\w./:~-])", r"(?![\w./~-]|:[\w:])"


@dataclass(frozen=True, order=True)
class Edit:
    """The characters of a text from `start` to `end` become `text`."""

    start: int
    end: int
    text: str


@dataclass(frozen=True)
class Repair:
    """A file with its changes carried out: what it was and what it is to be; `count` is how many changes that takes."""

    path: str
    before: bytes
    after: bytes
    count: int


@dataclass(frozen=True)
class Unchanged:
    """A change that is not carried out, and why."""

    change: Change
    why: str


def edits_of(finding: Finding, read: Callable[[str], str | None]) -> tuple[tuple[Change, str, Edit], ...]:
    """The changes that fix a finding, each with the text of its file and where it is in that; all of them or none."""
    found = []
    for change in finding.fix:
        text = read(change.place.path)
        edit = None if text is None else edit_for(change, text)
        if text is None or edit is None:
            return ()
        found.append((change, text, edit))
    return tuple(found)


def edit_for(change: Change, text: str) -> Edit | None:
    """Where in the text of its file a change is; None where that is not certain."""
    starts = [0, *(match.end() for match in _NEWLINE.finditer(text))]
    if not 0 < change.place.line <= len(starts):
        return None
    start = starts[change.place.line - 1]
    if not change.written:
        return _new_line(change.meant, text, start)
    if not _PLAIN.fullmatch(change.written) or not _PLAIN.fullmatch(change.meant):
        return None
    pattern = re.compile(f"{_BEFORE}{re.escape(change.written)}{_AFTER}")
    for first, last in _extents(text, start, max(0, change.place.column - 1), change.place.path):
        found = list(pattern.finditer(text, first, last))
        if found:
            return Edit(*found[0].span(), change.meant) if len(found) == 1 else None
    return None


def _new_line(meant: str, text: str, start: int) -> Edit | None:
    """The line below an element that has a line for itself, indented like it; None without such an element, or with such a line."""
    end = _NEWLINE.search(text, start)
    anchor = _ELEMENT.fullmatch(text[start : end.start() if end else len(text)])
    if anchor is None or end is None or "\n" in meant or "\r" in meant or f"\n{anchor[1]}{meant}" in text:
        return None
    return Edit(end.end(), end.end(), f"{anchor[1]}{meant}{end[0]}")


def _extents(text: str, line: int, column: int, path: str) -> Iterator[tuple[int, int]]:
    """From where to where what begins there is: the tag of an element, all of it; a call with its arguments, or else the line."""
    newline = _NEWLINE.search(text, line)
    end = newline.start() if newline else len(text)
    start = min(line + column, end)
    if path.endswith((".yaml", ".yml")):
        yield line, end
    elif text.lstrip("\ufeff \t\r\n").startswith("<"):
        tag = _TAG.search(text, start, end) or _TAG.match(text, start)
        if tag:
            yield tag.span()
            yield tag.start(), _end_of_element(text, tag)
    else:
        yield start, _end_of_call(text, start)


def _end_of_element(text: str, tag: re.Match[str]) -> int:
    """Where the element of a tag ends; without one of its name inside it, there."""
    name = re.escape(tag["name"])
    if tag[0].endswith("/>"):
        return tag.end()
    inside = re.compile(f"<{name}[\\s>]|</{name}\\s*>").search(text, tag.end())
    return inside.start() if inside else tag.end()


def _end_of_call(text: str, start: int) -> int:
    """Where the call ends that begins there, or else the line; the start when that is not certain."""
    depth = 0
    for token in _TOKEN.finditer(text, start):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(token[0], 0)
        if token[0] in ('"""', "'''") or depth < 0 or (depth == 0 and token[0] in ")]}\n"):
            return token.start()
    return len(text) if depth == 0 else start


def repairs(findings: Iterable[Finding], folder: Path, since: int) -> tuple[list[Repair], list[Unchanged]]:
    """The files below `folder` with what fixes these findings, and what is not carried out.

    `since` is when the reading of the files began: a file that was changed later (in ns) is left alone.
    """
    by_path: dict[str, list[Change]] = defaultdict(list)
    for change in dict.fromkeys(change for finding in findings for change in finding.fix):
        by_path[change.place.path].append(change)
    made, left = [], []
    for path, changes in sorted(by_path.items()):
        try:
            before = _content(folder, path, since)
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else str(error)
            left += [Unchanged(change, why or "cannot be read") for change in changes]
            continue
        text = before.decode("utf-8", "surrogateescape")
        edits = {change: edit_for(change, text) for change in changes}
        left += [Unchanged(change, "the text that is to be changed is not certain") for change, edit in edits.items() if edit is None]
        chosen = _apart(edit for edit in edits.values() if edit is not None)
        after = carried_out(chosen, text).encode("utf-8", "surrogateescape")
        if after != before:
            made.append(Repair(path, before, after, len(chosen)))
    return made, left


def carried_out(edits: Iterable[Edit], text: str) -> str:
    """A text with edits that do not overlap carried out."""
    for edit in sorted(edits, reverse=True):
        text = text[: edit.start] + edit.text + text[edit.end :]
    return text


def write(repair: Repair, folder: Path) -> None:
    """Write a file that was repaired, in one step and with its permissions; OSError when it is not what it was, or cannot be written."""
    real = Path(os.path.realpath(folder / repair.path))
    if read_file(real) != repair.before:
        raise OSError(0, "it has changed since it was read", str(real))
    if not os.access(real, os.W_OK):
        raise OSError(0, "it is read-only", str(real))
    mode = os.stat(real).st_mode
    write_whole(real, repair.after)
    os.chmod(real, mode & 0o7777)


def _apart(edits: Iterable[Edit]) -> list[Edit]:
    """Edits of which none overlaps another: of two that do, the first."""
    chosen: list[Edit] = []
    for edit in sorted(set(edits)):
        if not chosen or edit.start >= chosen[-1].end:
            chosen.append(edit)
    return chosen


def _content(folder: Path, path: str, since: int) -> bytes:
    """The content of a file below a folder; ValueError when it is not to be changed."""
    top, real = os.path.realpath(folder), os.path.realpath(folder / path)
    if os.path.commonpath([top, real]) != top:
        raise ValueError("it is outside of the workspace")
    if os.stat(real).st_mtime_ns > since:
        raise ValueError("it has changed since it was read")
    return read_file(real, LARGEST)


def unified(made: Iterable[Repair]) -> Iterator[str]:
    """What repairs change, as `patch -p1` and `git apply` read it from the folder."""
    from difflib import unified_diff

    for repair in made:
        before, after = (_lines(data) for data in (repair.before, repair.after))
        for line in unified_diff(before, after, f"a/{repair.path}", f"b/{repair.path}"):
            yield line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"


def _lines(data: bytes) -> list[str]:
    """The lines of a file with their ends; only a line feed ends one for `patch`."""
    return re.findall(r"[^\n]*\n|[^\n]+", data.decode("utf-8", "surrogateescape"))


def region_of(text: str, edit: Edit) -> tuple[int, int, int, int]:
    """Where an edit of a text begins and ends: line, column, line, column, from 1."""
    first, last = (len(text[:at].rpartition("\n")[2]) for at in (edit.start, edit.end))
    return 1 + text.count("\n", 0, edit.start), 1 + first, 1 + text.count("\n", 0, edit.end), 1 + last
