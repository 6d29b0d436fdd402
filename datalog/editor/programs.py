"""Programs as they would be with the texts being edited: which files belong together, what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from rosarch.datalog.editor.occurrences import Names, names_of
from rosarch.datalog.engine.preparation import prepare
from rosarch.datalog.language.errors import DatalogError, Diagnostic, Report
from rosarch.datalog.language.preprocess import Loading
from rosarch.datalog.language.sources import TOO_DEEP, deepest, read_program, read_text


@dataclass(frozen=True, slots=True)
class Entry:
    """A program: its root files, and files that take the place of others that it includes, as for `load_program`."""

    roots: tuple[Path, ...]
    instead: tuple[tuple[Path, Path], ...] = ()


Candidates: TypeAlias = Callable[[Path], Sequence[Entry]]


@dataclass(frozen=True, slots=True)
class CheckResult:
    """A program after its checks: the text of each of its files by resolved path, and what was found, errors first."""

    entry: Entry
    texts: Mapping[str, str]
    diagnostics: tuple[Diagnostic, ...]

    def of(self, path: Path) -> list[Diagnostic]:
        """What was found in one file, or nowhere in particular."""
        return [d for d in self.diagnostics if d.location is None or _resolved(d.location.path) == str(path)]

    def holds(self, path: Path) -> bool:
        """Whether the file is part of the program."""
        return str(path) in self.texts

    @property
    def errors(self) -> int:
        """How many errors there are."""
        return sum(d.severity == "error" for d in self.diagnostics)


class Programs:
    """The programs that edited files are part of. What did not change is not parsed again.

    `candidates` gives the programs that a file may be part of, the likeliest first.
    """

    def __init__(self, candidates: Candidates) -> None:
        self.candidates = candidates
        self.edited: dict[str, str] = {}
        self._names: dict[str, tuple[str, Names]] = {}
        self._entries: dict[Path, Entry] = {}
        self._checked: dict[Entry, CheckResult] = {}

    def edit(self, path: Path, text: str) -> None:
        """Take this text instead of the file."""
        self.edited[str(path)] = text
        self._stale(path)

    def close(self, path: Path) -> None:
        """Take the file again."""
        self.edited.pop(str(path), None)
        self._entries.pop(path, None)
        self._stale(path)

    def saved(self, path: Path) -> None:
        """A file has changed on disk: what it belongs to may have changed too."""
        self._entries.clear()
        self._stale(path)

    def _stale(self, path: Path) -> None:
        """Forget what the file is part of, and programs that are incomplete: they may lack just this file."""
        self._checked = {entry: c for entry, c in self._checked.items() if not c.holds(path) and not c.errors}

    def program(self, path: Path) -> CheckResult:
        """The program that a file is part of: of those that could be meant, the one with the fewest errors."""
        entry = self._entries.get(path)
        if entry is not None:
            return self.check(entry)
        best: CheckResult | None = None
        for candidate in self.candidates(path):
            found = self.check(candidate)
            if found.holds(path) and (best is None or found.errors < best.errors):
                best = found
            if best is not None and not best.errors:
                break
        if best is None:
            best = self.check(Entry((path,)))
        self._entries[path] = best.entry
        return best

    def check(self, entry: Entry) -> CheckResult:
        """Check a program."""
        if entry not in self._checked:
            self._checked[entry] = self._check(entry)
        return self._checked[entry]

    def _check(self, entry: Entry) -> CheckResult:
        try:
            reading = Loading(instead=entry.instead)
            unit, sources, report = read_program(entry.roots, reading=reading, edited=self.edited)
        except DatalogError as error:
            return CheckResult(entry, {}, tuple(error.diagnostics))
        texts = {_resolved(p): text for p, text in sources.texts.items()}
        errors = list(report.errors)
        try:
            prepare(unit, report)
        except DatalogError as error:
            errors += [d for d in error.diagnostics if d not in errors]
        except RecursionError:
            errors.append(Diagnostic(TOO_DEEP, deepest(sources.parsed)))
        return CheckResult(entry, texts, (*errors, *report.warnings))

    def text(self, path: Path) -> str:
        """The text of a file as it is being edited, or as it is on disk; empty when it cannot be read."""
        found = self.edited.get(str(path))
        return found if found is not None else read_text(path, str(path), None, Report({})) or ""

    def names(self, path: Path) -> Names:
        """The names in a file."""
        text = self.text(path)
        known = self._names.get(str(path))
        if known is None or known[0] != text:
            known = self._names[str(path)] = text, names_of(text)
        return known[1]

    def closure(self, path: Path) -> set[Path]:
        """The file and all that it includes."""
        found: set[Path] = set()
        work = [path]
        while work:
            file = work.pop()
            if file not in found:
                found.add(file)
                work.extend(
                    target for o in self.names(file).occurrences if o.kind == "file" and (target := included(file, o.name)).is_file()
                )
        return found


def included(including: Path, literal: str) -> Path:
    """The file that an `.include` of a string literal names."""
    return (including.parent / literal.strip('"')).resolve()


def includers(programs: Programs, path: Path, files: Iterable[Path]) -> list[Path]:
    """Those of some files that include a file, directly or not, and that none of the others includes."""
    found = [f for f in files if f != path and path in programs.closure(f)]
    inner = {g for f in found for g in programs.closure(f) - {f}}
    return [f for f in found if f not in inner]


def _resolved(path: str) -> str:
    return str(Path(path).resolve())
