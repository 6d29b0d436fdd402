"""Files to one syntax tree: resolves `.include`, each file once per scope, after the C preprocessor where that is asked for."""

from __future__ import annotations

import errno
import hashlib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location, Report
from rosarch.datalog.language.overrides import Overridden, drop_overridden
from rosarch.datalog.language.parser import parse_text
from rosarch.datalog.language.preprocess import Loading, expand
from rosarch.datalog.language.syntax import (
    AdtDecl,
    Clause,
    Component,
    Directive,
    FunctorDecl,
    Init,
    Pragma,
    RecordDecl,
    Relation,
    SubsetDecl,
    UnionDecl,
    Unit,
)  # fmt: skip
from rosarch.datalog.language.tree import ComponentBody, Include, Item, Override

TOO_DEEP = "a term is nested too deeply"
MANY_BRACKETS = 50  # nested; with fewer it is a chain of operators that is deep
EXTRA_SOURCE = "<extra>"


@dataclass(slots=True)
class Sources:
    """The text of every file of a program, and of those of `#include`; `parsed` has the texts that went to the parser, in order."""

    texts: dict[str, str] = field(default_factory=dict)
    parsed: dict[str, str] = field(default_factory=dict)
    overridden: tuple[Overridden, ...] = ()


def digest(text: str) -> str:
    """The content hash of one file."""
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def read_text(path: Path, shown: str, included_at: Location | None, report: Report) -> str | None:
    """The text of a rule file; None, and an error where the byte or the `.include` stands, when it cannot be read."""
    try:
        if path.is_char_device() or path.is_fifo():  # may have no end
            raise OSError(errno.EINVAL, "Not a regular file")
        data = path.read_bytes()
    except OSError as error:
        report.error(f"cannot read `{shown}`: {error.strerror}", included_at)
        return None
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = len(data[data.rfind(b"\n", 0, error.start) + 1 : error.start].decode("utf-8", "replace")) + 1
        report.error(f"not UTF-8 text: byte 0x{data[error.start]:02x}", Location(shown, line, column))
        return None


_NOTHING: Mapping[str, str] = {}


class _Loader:
    def __init__(self, report: Report, sources: Sources, reading: Loading, edited: Mapping[str, str] = _NOTHING) -> None:
        self.report = report
        self.sources = sources
        self.reading = reading
        self.edited = edited
        self.instead = {old.resolve(): new for old, new in reading.instead}

    def parse_file(self, path: Path, shown: str, included_at: Location | None, entered: set[str]) -> list[Item]:
        """The items of a file with its includes spliced in; nothing when the file was already entered."""
        identity = str(path.resolve())
        if identity in entered:
            return []
        entered.add(identity)
        text = self.edited.get(identity)
        if text is None:
            text = read_text(path, shown, included_at, self.report)
        return [] if text is None else self.parse(text, shown, entered)

    def parse(self, text: str, shown: str, entered: set[str]) -> list[Item]:
        """The items of a text."""
        texts, reading = self.sources.texts, self.reading
        texts[shown] = text
        if reading.preprocess:
            text = expand(text, shown, self.report, texts, macros=reading.macros, folders=reading.folders)
        self.sources.parsed[shown] = text
        try:
            items = remembered(text, shown, self.report, texts)
        except RecursionError:
            self.report.error(TOO_DEEP, deepest({shown: text}))
            return []
        return self._splice(items, entered)

    def _splice(self, items: Sequence[Item], entered: set[str]) -> list[Item]:
        result: list[Item] = []
        for item in items:
            match item:
                case Include():
                    target = self.find(item)
                    result.extend(self.parse_file(target, str(target), item.location, entered))
                case ComponentBody():  # two components may include the same file
                    unit = collect(self._splice(item.items, set(entered)))
                    result.append(Component(item.type, item.bases, unit))
                case _:
                    result.append(item)
        return result

    def find(self, item: Include) -> Path:
        """The file that an `.include` names: beside the including file, or in one of the folders."""
        including = item.location.path
        beside = (Path() if including == EXTRA_SOURCE else Path(including).parent) / item.path
        found = next((p for p in (beside, *(f / item.path for f in self.reading.folders)) if p.is_file()), beside)
        return self.instead.get(found.resolve(), found) if self.instead else found


_BRACKETS = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/|[\[({]|[\])}]', re.DOTALL)


def deepest(texts: Mapping[str, str]) -> Location:
    """Where the brackets of some texts are nested most deeply."""
    found = (0, Location(next(iter(texts), ""), 1, 1))
    for path, text in texts.items():
        depth = 0
        for token in _BRACKETS.finditer(text):
            depth += (token[0] in "[({") - (token[0] in "])}")
            if depth > found[0]:
                at = token.start()
                found = depth, Location(path, text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at))
    if found[0] >= MANY_BRACKETS:
        return found[1]
    path, lines = max(((p, t.splitlines()) for p, t in texts.items()), key=lambda item: max(map(len, item[1]), default=0))
    return Location(path, max(range(len(lines)), key=lambda i: len(lines[i]), default=0) + 1, 1)


def collect(items: Sequence[Item]) -> Unit:
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
                unit.pragmas.append(item)
            case FunctorDecl():
                unit.functors.append(item)
            case _:
                raise DatalogError(f"unexpected item {item!r}")
    return unit


_MEMORY: dict[str, tuple[str, Sequence[Item], Report]] = {}
_MOST = 1000  # files that are remembered


def remembered(text: str, shown: str, report: Report, texts: dict[str, str]) -> Sequence[Item]:
    """The items of a text, with its errors in the report, as `parse_text`: the same again for a text that the file had the last time.

    Programs share most of their files: those that are edited, with each other, with their variants, and with the rules behind them.
    """
    if "#line " in text:  # its places depend on other files
        return parse_text(text, shown, report, texts)
    known = _MEMORY.pop(shown, None)
    if known is None or known[0] != text:
        own = Report(texts)
        known = text, parse_text(text, shown, own, texts), own
    _MEMORY[shown] = known
    if len(_MEMORY) > _MOST:
        del _MEMORY[next(iter(_MEMORY))]
    for diagnostic in known[2].errors:
        report.error(diagnostic.message, diagnostic.location, diagnostic.hint)
    return known[1]


def read_program(
    paths: Sequence[Path], extra_source: str = "", reading: Loading | None = None, *, edited: Mapping[str, str] = _NOTHING
) -> tuple[Unit, Sources, Report]:
    """Parse root files, everything they include, and `extra_source` after them.

    Each file is parsed once, wherever and however often it is included (souffle needs `.once` for that); within each component, once more.
    `edited` are texts to take instead of files, by resolved path.
    """
    sources = Sources()
    report = Report(sources.texts)
    loader = _Loader(report, sources, reading or Loading(), edited)
    items: list[Item] = []
    entered: set[str] = set()
    for path in paths:
        if not path.is_file() and str(path.resolve()) not in edited:
            raise DatalogError([Diagnostic(f"no such file: `{path}`")])
        items.extend(loader.parse_file(path, str(path), None, entered))
    if extra_source:
        items.extend(loader.parse(extra_source, EXTRA_SOURCE, entered))
    unit = collect(items)
    sources.overridden = drop_overridden(unit, sources.parsed, report)
    return unit, sources, report
