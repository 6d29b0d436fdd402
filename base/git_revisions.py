"""Revisions of a git repository as folders, without letting anything of the repository run."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

LARGEST_FILE = 4 * 1024 * 1024  # what is larger is no source; it is there, but empty
_LINK = "120000"
# Hooks, filters and text conversions belong to commands that are not used. What is missing in a partial clone would be fetched by the
# program that the repository's configuration names: no protocol is allowed, and git gets an option not to try.
_ENVIRONMENT = {
    "GIT_ALLOW_PROTOCOL": "none",
    "GIT_NO_LAZY_FETCH": "1",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_TERMINAL_PROMPT": "0",
    "LC_ALL": "C",
}
_OPTIONS = ("--no-pager", "--no-replace-objects", "-c", "core.fsmonitor=false", "-c", "core.hooksPath=/dev/null")


class RevisionError(Exception):
    """A revision that cannot be had; the text says why."""


@dataclass(frozen=True)
class Exported:
    """What of a revision was written; submodules and files that the repository does not have were not, as paths show."""

    written: int
    submodules: tuple[str, ...]
    missing: tuple[str, ...]
    refused: tuple[str, ...]


@dataclass(frozen=True)
class _Entry:
    mode: str
    kind: str
    id: str
    path: str


def resolve(revision: str, repository: Path) -> str:
    """The commit that a revision of the repository around a folder names."""
    known = "not a folder" if os.path.exists(revision) else "no such folder"
    outcome = _git(repository, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if outcome.returncode == 0:
        return outcome.stdout.decode().strip()
    inside = _git(repository, "rev-parse", "--git-dir")
    if inside.returncode:
        message = inside.stderr.decode("utf-8", "replace").strip().partition("\n")[0]
        if "not a git repository" in message:
            raise RevisionError(f"{revision}: {known}, and no git repository here that could have a revision of this name")
        raise RevisionError(f"{revision}: {known}, and git says: {message}")
    raise RevisionError(f"{revision}: {known}, and no such revision of the git repository here")


def export(commit: str, repository: Path, out: Path) -> Exported:
    """Write the files of a commit below `out`, a new folder. Links that lead out of it are left out."""
    listing = _git(repository, "ls-tree", "-r", "-z", "--full-tree", commit)
    if listing.returncode:
        message = listing.stderr.decode("utf-8", "replace").strip().partition("\n")[0]
        raise RevisionError(f"{commit}: git cannot list its files: {message}")
    entries = [_entry(line) for line in listing.stdout.split(b"\0") if line]
    out.mkdir(parents=True, exist_ok=True)
    links: list[tuple[Path, bytes]] = []
    missing, refused, written = [], [], 0
    for entry, data in _contents(repository, [entry for entry in entries if entry.kind == "blob"]):
        if data is None:
            missing.append(entry.path)
        elif not _is_inside(entry.path):
            refused.append(entry.path)
        elif entry.mode == _LINK:
            links.append((out / entry.path, data))
        elif _write(out / entry.path, data):
            written += 1
        else:
            refused.append(entry.path)
    refused += [str(path.relative_to(out)) for path in _link(links, out)]
    submodules = tuple(entry.path for entry in entries if entry.kind == "commit")
    return Exported(written + len(links), submodules, tuple(missing), tuple(refused))


def _git(repository: Path, *arguments: str) -> subprocess.CompletedProcess[bytes]:
    try:
        return subprocess.run(_command(repository, *arguments), capture_output=True, check=False, env={**os.environ, **_ENVIRONMENT})
    except FileNotFoundError:
        raise RevisionError("revisions need git, which is not on PATH; two folders can be compared without it") from None


def _command(repository: Path, *arguments: str) -> list[str]:
    return ["git", "-C", str(repository), *_OPTIONS, *arguments]


def _entry(line: bytes) -> _Entry:
    meta, _, path = line.partition(b"\t")
    mode, kind, id_ = meta.decode("ascii").split()
    return _Entry(mode, kind, id_, os.fsdecode(path))


def _contents(repository: Path, entries: list[_Entry]) -> Iterator[tuple[_Entry, bytes | None]]:
    """The content of each file as git stores it, None when it does not have it."""
    command = _command(repository, "cat-file", "--batch")
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env={**os.environ, **_ENVIRONMENT}
    ) as process:
        if process.stdin is None or process.stdout is None:
            return
        for entry in entries:
            try:
                process.stdin.write(f"{entry.id}\n".encode("ascii"))
                process.stdin.flush()
                yield entry, _content(process.stdout)
            except (BrokenPipeError, EOFError):
                yield entry, None  # a repository that git gave up on
        process.stdin.close()


def _content(stream: IO[bytes]) -> bytes | None:
    header = stream.readline().split()
    if not header:
        raise EOFError
    if len(header) != 3:
        return None
    size = int(header[2])
    if size <= LARGEST_FILE:
        data = stream.read(size)
    else:
        data = b""
        while size:
            size -= len(stream.read(min(size, LARGEST_FILE))) or size
    stream.read(1)
    return data


def _is_inside(path: str) -> bool:
    """Whether a path stays below the folder that it starts from: git can store ones that do not."""
    return not path.startswith("/") and all(part not in ("", ".", "..") for part in path.split("/"))


def _write(path: Path, data: bytes) -> bool:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with open(path, "xb") as file:
            file.write(data)
    except (FileExistsError, NotADirectoryError, IsADirectoryError):
        return False
    return True


def _link(links: list[tuple[Path, bytes]], out: Path) -> list[Path]:
    """Make symbolic links when all files are there, so that none is written through them; the links that were not made."""
    made, refused = [], []
    for path, target in links:
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            os.symlink(os.fsdecode(target), path)
            made.append(path)
        except (OSError, ValueError):
            refused.append(path)
    root = os.path.realpath(out)
    outside = [path for path in made if os.path.commonpath((root, os.path.realpath(path))) != root]
    for path in outside:
        path.unlink()
    return refused + outside
