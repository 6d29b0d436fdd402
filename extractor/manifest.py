"""`manifest.json`: what a folder of facts was made from, so that a stale or damaged one is rejected."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import rosarch.rules
from rosarch.base.files import file_name, read_file
from rosarch.base.whole import write_whole

if TYPE_CHECKING:
    from rosarch.base.diagnostics import Diagnostic

NAME = "manifest.json"
FORMAT = 1


class ManifestError(Exception):
    """A folder of facts that cannot be trusted; the text says why and what to do."""


@dataclass(frozen=True)
class FactsEntry:
    """One component's folder: `rows` per relation, and a hash over all files."""

    package: str
    component: str
    kind: str
    folder: str
    sources: tuple[str, ...]
    rows: Mapping[str, int]
    digest: str


@dataclass(frozen=True)
class Manifest:
    """All components of a folder of facts. `hashes` are those of the sources' contents."""

    root: str
    entries: tuple[FactsEntry, ...]
    hashes: Mapping[str, str]
    diagnostics: tuple[Diagnostic, ...]


def rules_folder() -> Path:
    """The folder of the shipped rules."""
    return Path(next(iter(rosarch.rules.__path__)))


@lru_cache(maxsize=1)
def schema_hash() -> str:
    """A hash of the fact schema: facts written under another one are of no use."""
    digest = hashlib.sha256()
    for path in sorted((rules_folder() / "schema").glob("*.dl")):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def content_hash(path: Path) -> str:
    """A hash of a file's content; empty when it cannot be read."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    except OSError:
        return ""


def folder_digest(folder: Path) -> str:
    """A hash over the names and contents of all fact files of a folder."""
    digest = hashlib.sha256()
    for path in sorted(path for path in folder.glob("*.facts") if os.path.isfile(path)):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def write_manifest(out: Path, root: Path, entries: Sequence[FactsEntry], sources: Sequence[str], diagnostics: Sequence[Diagnostic]) -> None:
    """Write `out`/manifest.json."""
    data = {
        "format": FORMAT,
        "schema": schema_hash(),
        "root": str(root),
        "components": [asdict(entry) for entry in entries],
        "sources": {source: content_hash(root / source) for source in sorted(set(sources))},
        "diagnostics": [{**asdict(diagnostic), "path": str(diagnostic.path)} for diagnostic in diagnostics],
    }
    write_whole(out / NAME, (json.dumps(data, indent=1, sort_keys=True) + "\n").encode())


def facts_folder(folder: Path) -> Path | None:
    """The folder of facts that `folder` is, or is a package's or component's part of; None when it is none.

    A manifest decides; where it is damaged or gone, facts where components have theirs.
    """
    if _is_manifest(folder / NAME) or next(folder.glob("*/*/*.facts"), None) is not None:
        return folder
    here = folder.resolve()
    for above in (here.parent, here.parent.parent):
        if _is_manifest(above / NAME) and any(
            Path(entry["folder"]).is_relative_to(here.relative_to(above)) for entry in _json(above / NAME)["components"]
        ):
            return above
    return None


def entries_below(manifest: Manifest, top: Path, folder: Path) -> list[FactsEntry]:
    """The components of the facts in `top` that lie in or below `folder`."""
    part = folder.resolve().relative_to(top.resolve())
    return [entry for entry in manifest.entries if Path(entry.folder).is_relative_to(part)]


def _json(path: Path) -> Any:
    try:
        return json.loads(read_file(path))
    except (OSError, ValueError, RecursionError):
        return None


def _is_manifest(path: Path) -> bool:
    """Whether a file is a manifest of facts, of any format, rather than one of the many other files of this name."""
    data = _json(path)
    return isinstance(data, dict) and {"components", "schema", "sources"} <= data.keys() and isinstance(data["components"], list)


def _entry(data: dict[str, Any]) -> FactsEntry:
    """An entry as it was written; its names become paths, so that others are rejected."""
    entry = FactsEntry(**{**data, "sources": tuple(data["sources"])})
    for name in (entry.package, entry.component):
        if name != file_name(name):
            raise ValueError(f"{name!r} is no name of a package or component")
    if entry.folder != f"{entry.package}/{entry.component}":
        raise ValueError(f"{entry.folder!r} is not the folder of {entry.package}/{entry.component}")
    return entry


def read_manifest(folder: Path) -> Manifest:
    """Read and check `folder`/manifest.json.

    Raises `ManifestError` when it is missing or damaged, was written under another schema, when fact files were
    changed since, or when a source that is still there has changed.
    """
    path = folder / NAME
    from rosarch.base.diagnostics import Diagnostic

    try:
        data: dict[str, Any] = json.loads(read_file(path).decode("utf-8"))
        entries = tuple(_entry(entry) for entry in data["components"])
        diagnostics = tuple(Diagnostic(**{**entry, "path": Path(entry["path"])}) for entry in data["diagnostics"])
        manifest = Manifest(data["root"], entries, dict(data["sources"]), diagnostics)
        if not isinstance(manifest.root, str):
            raise TypeError("the root is no path")
        schema = data["schema"]
    except OSError:
        raise ManifestError(f"{path}: no such file; is this a folder of facts?") from None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise ManifestError(f"{path}: damaged ({error}); extract the facts again") from None
    if data.get("format") != FORMAT or schema != schema_hash():
        raise ManifestError(f"{path}: the facts were written under another schema; extract them again")
    for entry in entries:
        if folder_digest(folder / entry.folder) != entry.digest:
            raise ManifestError(f"{folder / entry.folder}: the facts are incomplete or were changed; extract them again")
    require_unchanged(Path(manifest.root), manifest.hashes)
    return manifest


def require_unchanged(root: Path, hashes: Mapping[str, str]) -> None:
    """Reject facts of sources that are still there and have other contents now; `hashes` are those they had, by path from `root`.

    Raises:
        ManifestError: a source has changed.
    """
    for source, digest in hashes.items():
        if os.path.isfile(root / source) and content_hash(root / source) != digest:
            raise ManifestError(f"{root / source}: changed since the facts were extracted; extract them again")
