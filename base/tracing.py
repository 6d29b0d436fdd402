"""What a result rests on: all that was read, looked for and asked for while it was made, to check whether that is as it was.

A recording knows some folders, its *trees*: below these every name counts, looked at or not. Of files, the content that was read counts;
outside of the trees, what was looked for; of environment variables, those that were asked for. What is not recorded this way (a time limit)
makes a recording *uncertain*, and its result is good for once.
"""

from __future__ import annotations

import hashlib
import os
import re
import stat
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Generic, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")
Stamp = tuple[int, int, int, int]
Read = tuple[str, "Stamp | None"]
"""What was seen of a file that was read, see `Trace`."""

_BOOKKEEPING = frozenset({".git", ".hg", ".svn"})
"""Folders that change with no change of the sources."""
_UNCOVERED = re.compile(r"/(\.\.|\.git|\.hg|\.svn)(/|$)")
_SETTLED = 2_000_000_000
"""Nanoseconds after which another change of a file shows in its times, whatever the file system."""


@dataclass(frozen=True)
class Trace:
    """What was seen: `trees` with a hash of their names, files that were read, what lies at other paths, and variables.

    Files have a hash of their content, "" when they could not be read, and where it can be trusted a stamp that shows that they are as they
    were.
    """

    trees: Mapping[str, str]
    reads: Mapping[str, Read]
    probes: Mapping[str, str]
    variables: Mapping[str, str | None]


@dataclass
class Recording:
    """What was seen so far below and outside of `trees`, but for what is in folders that are `ignored`."""

    trees: Mapping[str, str] = field(default_factory=dict)
    reads: dict[str, Read] = field(default_factory=dict)
    probes: dict[str, str] = field(default_factory=dict)
    variables: dict[str, str | None] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()
    uncertain: bool = False

    def __post_init__(self) -> None:
        self._prefixes = tuple(f"{tree.rstrip('/')}/" for tree in self.trees)

    def add(self, other: Recording | Trace) -> None:
        """What was seen in a part of the work; when two parts do not agree, the whole is uncertain."""
        self.uncertain |= isinstance(other, Recording) and other.uncertain
        self.uncertain |= any(self.probes.setdefault(path, kind) != kind for path, kind in other.probes.items())
        self.uncertain |= any(self.variables.setdefault(name, value) != value for name, value in other.variables.items())
        self.uncertain |= any(self.reads.setdefault(path, seen)[0] != seen[0] for path, seen in other.reads.items())

    def trace(self) -> Trace:
        """What was seen, to be kept."""
        return Trace(dict(self.trees), dict(self.reads), dict(self.probes), dict(self.variables))

    def covers(self, path: str) -> bool:
        """Whether the names of a tree show what is at `path`."""
        return f"{path}/".startswith(self._prefixes) and not _UNCOVERED.search(path)


_recordings: list[Recording] = []


@contextmanager
def recording(trees: Mapping[str, str]) -> Iterator[Recording]:
    """Record what is seen from now on. It is part of what an outer recording sees, too."""
    found = Recording(trees, ignored=_recordings[-1].ignored if _recordings else ())
    _recordings.append(found)
    try:
        yield found
    finally:
        _recordings.pop()
        if _recordings:
            _recordings[-1].add(found)


def seen(trace: Trace) -> None:
    """A result was taken that rests on what was observed earlier."""
    if _recordings:
        _recordings[-1].add(trace)


def uncertain() -> None:
    """The result depends on what no recording shows."""
    if _recordings:
        _recordings[-1].uncertain = True


def ignore(folder: str | os.PathLike[str]) -> None:
    """What is in `folder` is made from what is seen elsewhere."""
    if _recordings:
        _recordings[-1].ignored += (f"{os.path.abspath(folder)}/",)


def read(path: str | os.PathLike[str], status: os.stat_result | None, content: bytes | None) -> None:
    """A file was read that had `status` just before; neither is given when it could not be read."""
    if not _recordings:
        return
    here, full = _recordings[-1], os.path.abspath(path)
    if full.startswith(here.ignored):
        return
    if full in here.reads and content is not None and status is not None and here.reads[full][1] == _stamp(status):
        return
    entry = (_digest(content), None if status is None else _trusted(status))
    here.uncertain |= here.reads.setdefault(full, entry)[0] != entry[0]


def probe(path: str | os.PathLike[str]) -> None:
    """Something was looked for at `path`."""
    if not _recordings:
        return
    here, path = _recordings[-1], os.fspath(path)
    if here.covers(path):
        return
    full = os.path.abspath(path)
    if not (full in here.probes or here.covers(full) or full.startswith(here.ignored)):
        here.probes[full] = _kind(full)


def names(folder: str | os.PathLike[str]) -> None:
    """It was asked which names there are in a folder, but not what is below its folders."""
    if not _recordings:
        return
    here, full = _recordings[-1], f"{os.path.abspath(folder)}/"
    if not (full in here.probes or here.covers(full) or full.startswith(here.ignored)):
        here.probes[full] = _kind(full)


def listed(folder: str | os.PathLike[str]) -> None:
    """It was asked what is below a folder, however deep."""
    if _recordings and not _recordings[-1].covers(os.path.abspath(folder)):
        _recordings[-1].uncertain = True


class Variables(Mapping[str, str]):
    """Environment variables that are recorded when they are asked for."""

    def __init__(self, values: Mapping[str, str]) -> None:
        self._values = dict(values)

    def __getitem__(self, name: str) -> str:
        if _recordings:
            _recordings[-1].variables[name] = self._values.get(name)
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


@dataclass(frozen=True)
class _Carried(Generic[Result]):
    """A result from another process, with what it rests on."""

    result: Result
    rests_on: Recording


def carried(function: Callable[[Task], Result]) -> Callable[[Task], Result | _Carried[Result]]:
    """The same function for work in another process: what that sees comes with its result, for `received`."""
    if not _recordings:
        return function
    trees = _recordings[-1].trees

    def work(task: Task) -> Result | _Carried[Result]:
        with recording(trees) as rests_on:
            result = function(task)
        return _Carried(result, replace(rests_on, trees={}))

    return work


def received(result: Result | _Carried[Result]) -> Result:
    """What `carried` came to; what it saw counts as seen here."""
    if not isinstance(result, _Carried):
        return result
    if _recordings:
        _recordings[-1].add(result.rests_on)
    return result.result


class Present:
    """The trees, files and variables as they are now; each tree is looked at once, and not if it is one of a recording under way."""

    def __init__(self, variables: Mapping[str, str]) -> None:
        self.variables = variables
        self._trees: dict[str, str] = {}

    def trees(self, folders: Iterable[str]) -> dict[str, str]:
        """Hashes of all names below some folders."""
        for folder in folders:
            if folder not in self._trees:
                known = _recordings[-1].trees if _recordings else {}
                self._trees[folder] = known.get(folder) or _names_digest(folder)
        return {folder: self._trees[folder] for folder in folders}

    def confirms(self, then: Trace) -> Trace | None:
        """The trace, with new stamps, when everything is as it was then; otherwise None."""
        if dict(then.trees) != self.trees(then.trees) or any(_kind(path) != kind for path, kind in then.probes.items()):
            return None
        if any(self.variables.get(name) != value for name, value in then.variables.items()):
            return None
        restamped: dict[str, Read] = {}
        for path, now in changes(then.reads):
            if now is None:
                return None
            restamped[path] = now
        return replace(then, reads={**then.reads, **restamped}) if restamped else then


def changes(reads: Mapping[str, Read]) -> Iterator[tuple[str, Read | None]]:
    """The files that are not as they were: None with those of another content, what is seen now with those of another stamp."""
    for path, (digest, stamp) in reads.items():
        status = _status(path)
        if stamp is not None and status is not None and _stamp(status) == stamp:
            continue
        if _digest(_content(path, status)) != digest:
            yield path, None
            continue
        trusted = None if status is None else _trusted(status)
        if trusted != stamp:
            yield path, (digest, trusted)


def _stamp(status: os.stat_result) -> Stamp:
    return status.st_mtime_ns, status.st_ctime_ns, status.st_size, status.st_ino


def _trusted(status: os.stat_result) -> Stamp | None:
    """The stamp of a file whose next change will change it: not of one that was changed just now."""
    return _stamp(status) if time.time_ns() - max(status.st_mtime_ns, status.st_ctime_ns) > _SETTLED else None


def _digest(content: bytes | None) -> str:
    return "" if content is None else hashlib.sha256(content).hexdigest()


def _status(path: str) -> os.stat_result | None:
    try:
        return os.stat(path)
    except (OSError, ValueError):
        return None


def _content(path: str, status: os.stat_result | None) -> bytes | None:
    if status is None or not stat.S_ISREG(status.st_mode):
        return None
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return None


def _kind(path: str) -> str:
    """What lies at a path, and where that really is; of a path that ends in a slash, the names in that folder."""
    if path.endswith("/"):
        return _digest("\0".join(_names(path)).encode("utf-8", "surrogateescape"))
    status = _status(path)
    return "" if status is None else f"{stat.S_IFMT(status.st_mode):o} {os.path.realpath(path)}"


def _names(folder: str) -> list[str]:
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def _names_digest(top: str) -> str:
    """A hash of all names below a folder, links followed, with what each is."""
    found = hashlib.sha256(os.path.realpath(top).encode("utf-8", "surrogateescape"))
    visited = {os.path.realpath(top)}
    stack = [top]
    while stack:
        folder = stack.pop()
        try:
            with os.scandir(folder) as scan:
                entries = sorted(scan, key=lambda entry: entry.name)
        except OSError as error:
            found.update(f"{folder}\0{error.errno}\n".encode("utf-8", "surrogateescape"))
            continue
        lines = [folder]
        for entry in entries:
            if entry.name in _BOOKKEEPING:
                continue
            is_link = entry.is_symlink()
            if is_link:
                lines.append(f"{entry.name}\0{_kind(entry.path)}")
            elif entry.is_file(follow_symlinks=False):
                lines.append(entry.name)
            else:
                lines.append(f"{entry.name}\0{entry.is_dir(follow_symlinks=False)}")
            if _is_folder(entry) and not (is_link and (real := os.path.realpath(entry.path)) in visited):
                if is_link:
                    visited.add(real)
                stack.append(entry.path)
        found.update("\n".join(lines).encode("utf-8", "surrogateescape") + b"\0\n")
    return found.hexdigest()


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:
        return False
