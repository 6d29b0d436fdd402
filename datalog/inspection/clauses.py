"""The rules behind a compiled program, as syntax: what explanations, coverage and the reference work on.

A compiled program keeps the text of its files; they are parsed again here, and kept on disk as the program is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from rosarch.datalog import cache
from rosarch.datalog.engine.engine import collector_paused
from rosarch.datalog.engine.preparation import prepare
from rosarch.datalog.language.clause_text import TOKEN
from rosarch.datalog.language.errors import Location, Report
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.preprocess import Loading
from rosarch.datalog.language.sources import Sources, _Loader, collect, remembered
from rosarch.datalog.language.strata import dependencies
from rosarch.datalog.language.syntax import Clause, Relation, Unit
from rosarch.datalog.language.tree import Include, Item
from rosarch.datalog.language.types import Types

if TYPE_CHECKING:
    from rosarch.datalog.inspection.match import Lifted
    from rosarch.datalog.program import Program

_LIMIT = 8  # programs that are kept
_LONGEST = 200  # lines of a clause
_kept_rules: dict[tuple[str, ...], Rules] = {}
_ENTRY = "rules"


@dataclass(frozen=True)
class Rule:
    """One clause; `text` is as written, `number` counts the clauses of the program from 0."""

    clause: Clause
    types: ClauseTypes
    number: int
    text: str
    generated: bool  # by a qualifier of its relation, not by a line of its own

    @property
    def location(self) -> Location:
        """Where the clause starts."""
        return self.clause.location

    @property
    def place(self) -> str:
        """`path:line` of the clause."""
        return f"{self.location.path}:{self.location.line}"

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "types": self.types.in_order(self.clause)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state, types=ClauseTypes.of_ordered(state["types"], state["clause"]))


@dataclass(frozen=True, eq=False)
class Rules:
    """All clauses of a program, with components instantiated and types inferred."""

    unit: Unit
    relations: Mapping[str, Relation]
    types: Types
    strata: tuple[tuple[str, ...], ...]
    by_head: Mapping[str, tuple[Rule, ...]]
    lifted: dict[int, Lifted] = field(default_factory=dict)
    """By number, what matching has made of rules."""

    @cached_property
    def all(self) -> tuple[Rule, ...]:
        """Every clause, in source order."""
        return tuple(sorted((r for rules in self.by_head.values() for r in rules), key=lambda r: r.number))

    @cached_property
    def inputs(self) -> frozenset[str]:
        """The relations whose rows may be given."""
        return frozenset(directive.relation for directive in self.unit.directives if directive.kind == "input")

    @cached_property
    def reads(self) -> Mapping[str, frozenset[str]]:
        """The relations that the clauses of a relation name."""
        graph = dependencies(self.relations, self.unit.clauses)
        return {name: frozenset(read) for name, read in graph.reads.items()}

    @cached_property
    def recursive(self) -> Mapping[str, frozenset[str]]:
        """For every recursive relation, all that it is recursive with, itself included."""
        found: dict[str, frozenset[str]] = {}
        for names in self.strata:
            if len(names) > 1 or names[0] in self.reads[names[0]]:
                found.update(dict.fromkeys(names, frozenset(names)))
        return found


class _TextLoader(_Loader):
    """Reads the files of a program from memory, as they went to the parser."""

    def __init__(self, texts: Mapping[str, str], report: Report, sources: Sources) -> None:
        super().__init__(report, sources, Loading())
        self.contents = texts

    def parse_file(self, path: Path, shown: str, included_at: Location | None, entered: set[str]) -> list[Item]:
        """The items of a file that has not been entered yet."""
        if shown in entered or shown not in self.contents:
            return []
        entered.add(shown)
        return self._splice(remembered(self.contents[shown], shown, self.report, self.sources.texts), entered)

    def find(self, item: Include) -> Path:
        """The file among these that an `.include` names."""
        found = super().find(item)
        ending = f"/{item.path}"
        return found if str(found) in self.contents else Path(next((p for p in self.contents if p.endswith(ending)), str(found)))


def rules_of(program: Program) -> Rules:
    """The rules of a program."""
    key = (program.hash, *program.sources)  # the hash is one of contents only
    found = _kept_rules.get(key)
    if found is None:
        found = _kept(program)
        while len(_kept_rules) >= _LIMIT:
            _kept_rules.pop(next(iter(_kept_rules)))
        _kept_rules[key] = found
    return found


def _kept(program: Program) -> Rules:
    """The rules as they were when this program was read last."""
    files = list(map(Path, program.sources))
    with collector_paused():
        known = cache.load(files, _ENTRY)
    if known is not None and known[0] == program.hash:
        return cast(Rules, known[1])
    with collector_paused():
        found = _read(program)
    cache.store(files, _ENTRY, {}, (program.hash, found))
    return found


def _read(program: Program) -> Rules:
    report = Report(program.sources)
    loader = _TextLoader(program.parsed, report, Sources(dict(program.sources)))
    items: list[Item] = []
    entered: set[str] = set()
    for shown in program.parsed:
        items.extend(loader.parse_file(Path(shown), shown, None, entered))
    checked, written = prepare(collect(items), report, program.types.bits)
    unit = checked.unit
    numbers = {id(clause): number for number, clause in enumerate(unit.clauses)}
    lines = {path: text.splitlines() for path, text in program.sources.items()}
    by_head = {
        name: tuple(
            Rule(clause, types, numbers[id(clause)], _text(clause, lines), numbers[id(clause)] >= written) for clause, types in clauses
        )
        for name, clauses in checked.clauses.items()
    }
    return Rules(unit, checked.relations, checked.types, tuple(map(tuple, checked.strata)), by_head)


def _text(clause: Clause, lines: Mapping[str, list[str]]) -> str:
    """The clause as written, on one line and without comments: from where it starts to the dot that ends it."""
    at = clause.location
    rest = "\n".join(lines.get(at.path, [])[at.line - 1 : at.line + _LONGEST])[at.column - 1 :]
    parts: list[str] = []
    position = 0
    for token in TOKEN.finditer(rest):
        parts.append(rest[position : token.start()])
        position = token.end()
        if token[0] == ".":
            return "".join(parts).strip() + "."
        comment = token[0].startswith(("//", "/*"))
        parts.append("" if comment else " " if token[0].isspace() else token[0])
    return ""
