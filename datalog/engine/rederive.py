"""Deriving again after an edit of the rules: only what the edit can reach, from the rows that were there before.

Relations that no changed clause feeds keep their rows; the others become a program of their own, with the kept relations as its input.
So do, at first, the relations alone whose clauses have changed: mostly they have the rows that they had, and then all others have, too.
Nothing is approximated: the rows are those of the whole program. (Maintaining rows under changes of facts, as by Gupta, Mumick and
Subrahmanian, 1993, is another matter: facts do not change here, rules do.)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, fields, is_dataclass, replace
from pathlib import Path
from typing import Any

from rosarch.datalog.engine.slices import slice_unit
from rosarch.datalog.language.components import instantiate
from rosarch.datalog.language.errors import Report
from rosarch.datalog.language.preprocess import Loading
from rosarch.datalog.language.semantics import check
from rosarch.datalog.language.sources import Sources, read_program
from rosarch.datalog.language.strata import components, dependencies, reachable, turned_around
from rosarch.datalog.language.syntax import Directive, Relation, Unit
from rosarch.datalog.program import Program, RelationDecl, compile_unit, declarations


@dataclass(frozen=True, slots=True)
class Part:
    """A program of some relations; the others that they read, `needed`, are its input."""

    program: Program
    names: frozenset[str]
    needed: frozenset[str]


@dataclass(frozen=True)
class Edit:
    """What separates a program from the one whose rows are known.

    `relations` are all that are declared now, `affected` those that may have other rows. `first` derives, from rows that are known, those
    that were edited themselves: where they have the rows that they had, all others have, too. None when nothing is affected. `part`
    gives what derives affected relations, all that lead to some of them, from rows that are known.
    """

    relations: Mapping[str, RelationDecl]
    affected: frozenset[str]
    first: Part | None
    part: Callable[[Collection[str]], Part]
    _reads: Mapping[str, Collection[str]]

    def leading_to(self, names: Collection[str]) -> frozenset[str]:
        """The affected relations that some relations are derived from, themselves included."""
        return self.affected & reachable(self.affected.intersection(names), self._reads)


class RuleHistory:
    """The rules of a program while they are edited. Raises DatalogError when they are wrong; parameters as of `load_program`."""

    def __init__(
        self, roots: Sequence[Path], *, extra_source: str = "", instead: Mapping[Path, Path] | None = None, bits: int = 32
    ) -> None:  # fmt: skip
        self.roots = tuple(roots)
        self.extra_source = extra_source
        self.reading = Loading(instead=tuple(sorted((instead or {}).items())))
        self.bits = bits
        self._base: Unit | None = None

    def whole(self) -> Program:
        """The whole program as it is now, from which edits are distinguished from here on."""
        unit, sources, report = self._read()
        program = compile_unit(copy(unit), sources, report, self.bits)
        self._base = unit
        return program

    def edit(self) -> Edit | None:
        """What has changed since `whole`; None when what all clauses rest on has."""
        unit, sources, report = self._read()
        changed = _changed(self._base, unit) if self._base else None
        if self._base is None or changed is None:
            return None
        declared = {r.name for r in unit.relations}
        reads = dependencies(declared, (c for c in unit.clauses if c.head.name in declared)).reads
        readers = turned_around(reads)
        affected = frozenset(reachable(changed, readers) & declared)
        within = {*_differing(self._base.relations, unit.relations), *_inline(unit)}  # whose change is one of their readers' clauses
        first = reachable(changed, {name: readers.get(name, ()) for name in within}) & declared
        recursive = components({name: reads[name] & affected for name in affected})
        first |= {name for names in recursive if not first.isdisjoint(names) for name in names}
        clauses = [c for c in unit.clauses if c.head.name in first or c.head.name not in declared]
        types = check(replace(unit, clauses=clauses), report, self.bits).types  # all that an edit can have broken

        def part(names: Collection[str]) -> Part:
            own = _with_inlined(names, unit, reads)
            sliced, needed = slice_unit(unit, own, [c for c in unit.clauses if c.head.name in own])
            return Part(compile_unit(sliced, sources, report, self.bits), frozenset(names), needed)

        return Edit(declarations(unit, types), affected, part(first) if first else None, part, reads)

    def _read(self) -> tuple[Unit, Sources, Report]:
        unit, sources, report = read_program(self.roots, self.extra_source, self.reading)
        return instantiate(unit, report), sources, report


def _with_inlined(names: Collection[str], unit: Unit, reads: Mapping[str, Collection[str]]) -> set[str]:
    """The relations, and the inline ones that they read: these have no rows, so that their clauses are needed."""
    inline = _inline(unit)
    return set(names) | reachable(names, {name: (other for other in read if other in inline) for name, read in reads.items()})


def _inline(unit: Unit) -> set[str]:
    return {r.name for r in unit.relations if "inline" in r.qualifiers}


def _changed(before: Unit, now: Unit) -> set[str] | None:
    """The relations whose declaration, clauses or files differ; None when types, functors or pragmas do."""
    general = ("types", "functors", "pragmas")
    if any(_shape(getattr(before, part)) != _shape(getattr(now, part)) for part in general):
        return None
    changed = {name for part in ("relations", "directives") for name in _differing(getattr(before, part), getattr(now, part))}
    old = {id(c) for c in before.clauses}
    new = {id(c) for c in now.clauses}
    gone = Counter(_shape(c) for c in before.clauses if id(c) not in new)
    come = Counter(_shape(c) for c in now.clauses if id(c) not in old)
    return changed | {shape[1][1] for shape in ((gone - come) + (come - gone))}


def _differing(before: Iterable[Relation | Directive], now: Iterable[Relation | Directive]) -> Iterator[str]:
    """The names of the relations whose declarations or directives are not the same."""
    old, new = ({(_relation(item), _shape(_undocumented(item))) for item in items} for items in (before, now))
    yield from (name for name, _ in old ^ new)


def _relation(item: Relation | Directive) -> str:
    return item.name if isinstance(item, Relation) else item.relation


def _undocumented(item: Relation | Directive) -> Relation | Directive:
    return replace(item, doc="") if isinstance(item, Relation) else item


def _shape(node: Any) -> Any:
    """A node, or a list of them, without places: equal for what is written alike."""
    if isinstance(node, (tuple, list)):
        return tuple(_shape(item) for item in node)
    if is_dataclass(node):
        return type(node).__name__, *(_shape(getattr(node, f.name)) for f in fields(node) if f.name != "location")
    return node
