"""Files to one syntax tree: resolves `.include`, each file once."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .errors import DatalogError, Diagnostic, Location, Report
from .parser import parse_text
from .syntax import (
    AdtDecl,
    Clause,
    Component,
    Directive,
    FunctorDecl,
    Init,
    RecordDecl,
    Relation,
    SubsetDecl,
    UnionDecl,
    Unit,
)  # fmt: skip
from .tree import ComponentBody, Include, Item, Override, Pragma

EXTRA_SOURCE = "<extra>"


@dataclass(slots=True)
class Sources:
    """The text of every file of a program, in the order of inclusion."""

    texts: dict[str, str] = field(default_factory=dict)
    order: list[str] = field(default_factory=list)

    def add(self, path: str, text: str) -> None:
        """Remember the text of a file."""
        self.texts[path] = text
        self.order.append(path)


def digest(text: str) -> str:
    """The content hash of one file."""
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


class _Loader:
    def __init__(self, report: Report, sources: Sources) -> None:
        self.report = report
        self.sources = sources
        self.entered: set[str] = set()

    def parse_file(self, path: Path, shown: str, included_at: Location | None) -> list[Item]:
        """The items of a file with its includes spliced in; nothing when the file was already entered."""
        identity = str(path.resolve())
        if identity in self.entered:
            return []
        self.entered.add(identity)
        try:
            text = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
            self.report.error(f"cannot read `{shown}`: {reason}", included_at)
            return []
        return self.parse(text, shown, path.parent)

    def parse(self, text: str, shown: str, folder: Path) -> list[Item]:
        """The items of a text."""
        self.sources.add(shown, text)
        return self._splice(parse_text(text, shown, self.report), folder)

    def _splice(self, items: Sequence[Item], folder: Path) -> list[Item]:
        result: list[Item] = []
        for item in items:
            match item:
                case Include():
                    target = folder / item.path
                    result.extend(self.parse_file(target, str(target), item.location))
                case ComponentBody():
                    unit = collect(self._splice(item.items, folder), self.report)
                    result.append(Component(item.type, item.bases, unit))
                case _:
                    result.append(item)
        return result


def collect(items: Sequence[Item], report: Report) -> Unit:
    """Sort items by kind."""
    unit = Unit()
    for item in items:
        match item:
            case Relation():
                unit.relations.append(item)
            case Clause():
                unit.clauses.append(item)
            case Directive():
                unit.directives.append(item)
            case SubsetDecl() | UnionDecl() | RecordDecl() | AdtDecl():
                unit.types.append(item)
            case Component():
                unit.components.append(item)
            case Init():
                unit.inits.append(item)
            case Override():
                unit.overrides.append(item.name)
            case Pragma():
                unit.pragmas.append((item.key, item.value))
            case FunctorDecl():
                unit.functors.append(item)
            case _:
                raise DatalogError(f"unexpected item {item!r}")
    return unit


def read_program(paths: Sequence[Path], extra_source: str = "") -> tuple[Unit, Sources, Report]:
    """Parse root files, everything they include, and `extra_source` after them.

    Each file is parsed once, wherever and however often it is included (souffle needs `.once` for that).
    Includes are relative to the including file.
    """
    sources = Sources()
    report = Report(sources.texts)
    loader = _Loader(report, sources)
    items: list[Item] = []
    for path in paths:
        if not path.is_file():
            raise DatalogError([Diagnostic(f"no such file: `{path}`")])
        items.extend(loader.parse_file(path, str(path), None))
    if extra_source:
        items.extend(loader.parse(extra_source, EXTRA_SOURCE, Path.cwd()))
    return collect(items, report), sources, report
