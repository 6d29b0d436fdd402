"""The type system: base kinds, subtypes, unions, records and algebraic data types.

Follows souffle's ast/analysis/typesystem; see https://souffle-lang.github.io/types. Above each primitive type
stands the type of its constants, so that a literal fits every subtype of its primitive.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from rosarch.datalog.language.errors import Location, Report, did_you_mean
from rosarch.datalog.language.syntax import AdtDecl, RecordDecl, SubsetDecl, TypeDecl, UnionDecl

PRIMITIVES = {"number": "i", "unsigned": "u", "float": "f", "symbol": "s"}
CONSTANT_TYPES = {"i": "@number", "u": "@unsigned", "f": "@float", "s": "@symbol"}


@dataclass(frozen=True, slots=True)
class Type:
    """A resolved type. `kind` is `i u f s`, `r` for records, `+` for algebraic data types."""

    name: str
    kind: str
    base: str = ""  # of a subset type
    members: tuple[str, ...] = ()  # of a union type
    fields: tuple[str, ...] = ()  # of a record type: the types of its fields
    names: tuple[str, ...] = ()  # of a record type: the names of its fields
    branches: tuple[tuple[str, tuple[str, ...]], ...] = ()  # of an algebraic data type


@dataclass(slots=True)
class Types:
    """All types of a program, with aliases resolved, and the subtype relation between them."""

    table: dict[str, Type] = field(default_factory=dict)
    aliases: dict[str, str] = field(default_factory=dict)
    branch_owner: dict[str, str] = field(default_factory=dict)
    bits: int = 32  # the width of numbers
    _subtype: dict[tuple[str, str], bool] = field(default_factory=dict)
    _common: dict[tuple[str, str], frozenset[str]] = field(default_factory=dict)

    def resolve(self, name: str) -> str:
        """The name behind an alias."""
        return self.aliases.get(name, name)

    def exists(self, name: str) -> bool:
        """Whether a type of this name exists."""
        return self.resolve(name) in self.table

    def get(self, name: str) -> Type:
        """The type of this name."""
        return self.table[self.resolve(name)]

    def kind(self, name: str) -> str:
        """The base kind of a type."""
        return self.get(name).kind

    def root(self, name: str) -> Type:
        """The type a chain of subset types starts from, below its constant type."""
        found = self.get(name)
        while found.base and not found.base.startswith("@"):
            found = self.get(found.base)
        return found

    def field_names(self, name: str) -> tuple[str, ...]:
        """The names of the fields of a record type."""
        return self.root(name).names

    def is_subtype(self, a: str, b: str) -> bool:
        """Whether every value of `a` is a value of `b`, by declaration."""
        a, b = self.resolve(a), self.resolve(b)
        if a == b:
            return True
        known = self._subtype.get((a, b))
        if known is None:
            self._subtype[a, b] = False  # breaks cycles of unions
            ta, tb = self.table[a], self.table[b]
            known = bool(
                (ta.base and self.is_subtype(ta.base, b))
                or (ta.members and all(self.is_subtype(m, b) for m in ta.members))
                or (tb.members and any(self.is_subtype(a, m) for m in tb.members))
            )
            self._subtype[a, b] = known
        return known

    def common(self, a: str, b: str) -> frozenset[str]:
        """The greatest common subtypes of two types."""
        a, b = self.resolve(a), self.resolve(b)
        known = self._common.get((a, b))
        if known is None:
            if self.is_subtype(a, b):
                known = frozenset((a,))
            elif self.is_subtype(b, a):
                known = frozenset((b,))
            elif self.table[a].members and self.table[b].members:
                known = frozenset(self._within(a, b))
            else:
                known = frozenset()
            self._common[a, b] = known
        return known

    def _within(self, a: str, b: str) -> set[str]:
        if self.is_subtype(a, b):
            return {a}
        return {t for m in self.table[self.resolve(a)].members for t in self._within(self.resolve(m), b)}

    def common_sets(self, a: frozenset[str], b: frozenset[str]) -> frozenset[str]:
        """The pairwise greatest common subtypes of two sets of types."""
        return a if a == b and len(a) == 1 else frozenset(t for x in a for y in b for t in self.common(x, y))


def build_types(declarations: Iterable[TypeDecl], report: Report, bits: int = 32) -> Types:
    """Resolve type declarations; undefined, cyclic and clashing ones are reported and left out."""
    types = Types(bits=bits)
    for name, kind in PRIMITIVES.items():
        types.table[CONSTANT_TYPES[kind]] = Type(CONSTANT_TYPES[kind], kind)
        types.table[name] = Type(name, kind, base=CONSTANT_TYPES[kind])
    declared: dict[str, TypeDecl] = {}
    for decl in declarations:
        if decl.name in PRIMITIVES:
            report.error(f"redefinition of the predefined type `{decl.name}`", decl.location)
        elif decl.name in declared:
            report.error(f"type `{decl.name}` is already declared at {declared[decl.name].location}", decl.location)
        else:
            declared[decl.name] = decl
    _Builder(types, declared, report).run()
    return types


class _Builder:
    def __init__(self, types: Types, declared: dict[str, TypeDecl], report: Report) -> None:
        self.types = types
        self.declared = declared
        self.report = report
        self.active: list[str] = []
        self.failed: set[str] = set()

    def run(self) -> None:
        for name in self.declared:
            self.define(name)
        for decl in self.declared.values():
            match decl:
                case RecordDecl():
                    self._check_fields(decl.fields, f"type `{decl.name}`")
                case AdtDecl():
                    for branch in decl.branches:
                        self._check_fields(branch.fields, f"branch `{branch.name}`")

    def _check_fields(self, fields: Iterable, owner: str) -> None:  # type: ignore[type-arg]
        seen: set[str] = set()
        for f in fields:
            if not self.types.exists(f.type) and f.type not in self.failed:
                self.unknown(f.type, f.location)
            if f.name in seen:
                self.report.error(f"field `{f.name}` is declared twice in {owner}", f.location)
            seen.add(f.name)

    def unknown(self, name: str, location: Location) -> None:
        hint = did_you_mean(name, [*PRIMITIVES, *self.declared])
        self.report.error(f"unknown type `{name}`", location, hint)

    def define(self, name: str) -> bool:
        """Define a type after the types it is built from; false when it cannot be."""
        if self.types.exists(name):
            return True
        if name not in self.declared or name in self.failed:
            return False
        decl = self.declared[name]
        if name in self.active:
            self.report.error(f"type `{name}` is defined by itself", decl.location)
            return False
        self.active.append(name)
        found = self._define(decl)
        self.active.pop()
        if not found:
            self.failed.add(name)
        return found

    def _define(self, decl: TypeDecl) -> bool:
        table = self.types.table
        match decl:
            case RecordDecl():
                table[decl.name] = Type(decl.name, "r", fields=tuple(f.type for f in decl.fields), names=tuple(f.name for f in decl.fields))
            case AdtDecl():
                branches = tuple((b.name, tuple(f.type for f in b.fields)) for b in decl.branches)
                table[decl.name] = Type(decl.name, "+", branches=branches)
                for branch in decl.branches:
                    owner = self.types.branch_owner.setdefault(branch.name, decl.name)
                    if owner != decl.name or sum(b.name == branch.name for b in decl.branches) > 1:
                        self.report.error(f"branch `{branch.name}` is declared more than once", branch.location)
            case SubsetDecl():
                if not self._require(decl.base, decl):
                    return False
                base = self.types.get(decl.base)
                if base.members or base.kind == "r":
                    what = "union" if base.members else "record type"
                    self.report.error(f"subset type `{decl.name}` cannot derive from {what} `{decl.base}`", decl.location)
                    return False
                table[decl.name] = Type(decl.name, base.kind, base=base.name)
            case UnionDecl():
                return self._define_union(decl)
        return True

    def _define_union(self, decl: UnionDecl) -> bool:
        missing = [m for m in decl.members if not self._require(m, decl)]  # all of them are reported
        if missing:
            return False
        if len(decl.members) == 1:
            self.types.aliases[decl.name] = self.types.resolve(decl.members[0])
            return True
        kinds = {self.types.kind(m) for m in decl.members}
        for member in decl.members:
            if self.types.kind(member) in "r+":
                self.report.error(f"union type `{decl.name}` contains the non-primitive type `{member}`", decl.location)
                return False
        if len(kinds) > 1:
            roots = ", ".join(sorted(self.types.root(m).name for m in decl.members))
            self.report.error(f"union type `{decl.name}` mixes primitive types ({roots})", decl.location)
            return False
        members = tuple(self.types.resolve(m) for m in decl.members)
        self.types.table[decl.name] = Type(decl.name, kinds.pop(), members=members)
        return True

    def _require(self, name: str, decl: TypeDecl) -> bool:
        if self.define(name):
            return True
        if name not in self.declared:
            self.unknown(name, decl.location)
        return False
