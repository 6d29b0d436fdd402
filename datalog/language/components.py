"""Components: `.comp` bodies copied to where `.init` names them (souffle's ComponentInstantiation.cpp).

A relation, type or nested instance `x` of the instance `i` becomes `i.x`. Inside the instance the short name is
meant; names of the enclosing scopes stay visible. `.override r` drops the clauses of an inherited `r`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from rosarch.datalog.language.errors import Report, did_you_mean
from rosarch.datalog.language.rewrite import Rewriter
from rosarch.datalog.language.syntax import (
    AdtDecl,
    AttributeDecl,
    BranchDecl,
    Clause,
    Component,
    ComponentType,
    Directive,
    Init,
    RecordDecl,
    Relation,
    SubsetDecl,
    TypeDecl,
    UnionDecl,
    Unit,
)  # fmt: skip

MAX_DEPTH = 200
# New names of relations, of types and branches, and of nested instances.
Names = tuple[Mapping[str, str], Mapping[str, str], Mapping[str, str]]


@dataclass(slots=True)
class _Scope:
    """Component declarations and type parameters visible at one point."""

    components: dict[str, tuple[Component, _Scope]] = field(default_factory=dict)
    parameters: dict[str, str] = field(default_factory=dict)
    parent: _Scope | None = None

    def find(self, name: str) -> tuple[Component, _Scope] | None:
        found = self.components.get(name)
        return found if found or self.parent is None else self.parent.find(name)

    def names(self) -> list[str]:
        return [*self.components, *(self.parent.names() if self.parent else ())]

    def parameter(self, name: str) -> str:
        found = self.parameters.get(name)
        return found if found is not None else self.parent.parameter(name) if self.parent else name


@dataclass(slots=True)
class _Content:
    """The members of a component with those of its bases; each with the scope it was written in."""

    types: list[TypeDecl] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)
    clauses: list[Clause] = field(default_factory=list)
    directives: list[Directive] = field(default_factory=list)
    inits: list[tuple[Init, _Scope]] = field(default_factory=list)


def instantiate(unit: Unit, report: Report) -> Unit:
    """The program without components: every instance expanded under its name."""
    _check_clashes(unit, report)
    if not unit.components and not unit.inits:
        return unit
    scope = _Scope()
    scope.components = {c.type.name: (c, scope) for c in unit.components}
    for index, component in enumerate(unit.components):
        if any(c.type.name == component.type.name for c in unit.components[:index]):
            report.error(f"component `{component.type.name}` is already declared", component.type.location)
    result = Unit(
        list(unit.types),
        list(unit.relations),
        list(unit.clauses),
        list(unit.directives),
        list(unit.functors),
        unit.pragmas,
    )
    expander = _Expander(result, report)
    expander.check_overrides(unit.components, scope)
    pending: list[Clause] = []
    for init in unit.inits:
        expander.expand(init, scope, "", ({}, {}, {}), pending, 0)
    result.clauses.extend(pending)
    types = {t.name for t in result.types}
    for relation in result.relations:
        if relation.name in types:
            report.error(f"`{relation.name}` is a relation and a type", relation.location)
    return result


def _check_clashes(unit: Unit, report: Report) -> None:
    """Types, relations, components and instances of one scope have names of their own."""
    kinds = {t.name: "type" for t in unit.types}
    for relation in unit.relations:
        if kinds.get(relation.name) == "type":
            report.error(f"`{relation.name}` is a relation and a type", relation.location)
    kinds.update((r.name, "relation") for r in unit.relations)
    for component in unit.components:
        if component.type.name in kinds:
            report.error(f"`{component.type.name}` is a component and a {kinds[component.type.name]}", component.type.location)
        _check_clashes(component.unit, report)
    kinds.update((c.type.name, "component") for c in unit.components)
    for init in unit.inits:
        if init.name in kinds:
            report.error(f"`{init.name}` is an instance and a {kinds[init.name]}", init.location)


class _Expander:
    def __init__(self, result: Unit, report: Report) -> None:
        self.result = result
        self.report = report

    def expand(self, init: Init, scope: _Scope, prefix: str, outer: Names, orphans: list[Clause], depth: int) -> None:
        """Add the members of an instance to the program. `outer` maps names of enclosing instances."""
        if depth > MAX_DEPTH:
            self.report.error(f"instances of `{init.component.name}` contain each other without end", init.location)
            return
        content = _Content()
        inner = self._collect(init.component, scope, content, [])
        if inner is None:
            return
        name = f"{prefix}{init.name}"
        local = {r.name: f"{name}.{r.name}" for r in content.relations}
        types = {t.name: f"{name}.{t.name}" for t in content.types}
        branches = {b.name: f"{name}.{b.name}" for t in content.types if isinstance(t, AdtDecl) for b in t.branches}
        instances = {i.name: f"{name}.{i.name}" for i, _ in content.inits}
        renamer = Renamer({**outer[0], **local}, {**outer[1], **types, **branches}, {**outer[2], **instances})
        self.result.types.extend(renamer.type_decl(t) for t in content.types)
        self.result.relations.extend(renamer.relation(r) for r in content.relations)
        self.result.directives.extend(replace(d, relation=renamer.name(d.relation)) for d in content.directives)
        self.result.clauses.extend(renamer.clause(c) for c in content.clauses)
        for nested, nested_scope in content.inits:
            self.expand(nested, nested_scope, f"{name}.", renamer.maps, orphans, depth + 1)

    def _collect(
        self, wanted: ComponentType, scope: _Scope, content: _Content, active: list[str]
    ) -> _Scope | None:  # fmt: skip
        """Add the members of a component and of its bases to `content`; returns its scope."""
        name = scope.parameter(wanted.name)
        found = scope.find(name)
        if found is None:
            self.report.error(f"unknown component `{name}`", wanted.location, did_you_mean(name, scope.names()))
            return None
        component, home = found
        if name in active:
            self.report.error(f"component `{name}` inherits from itself", wanted.location)
            return None
        expected, given = component.type.params, wanted.params
        if len(expected) != len(given):
            self.report.error(f"component `{name}` has {len(expected)} parameters, given {len(given)}", wanted.location)
            return None
        inner = _Scope(parent=home)
        inner.parameters = {p: scope.parameter(g) for p, g in zip(expected, given, strict=True)}
        inner.components = {c.type.name: (c, inner) for c in component.unit.components}
        inherited = _Content()
        for base in component.bases:
            base_scope = self._collect(base, inner, inherited, [*active, name])
            if base_scope is not None:
                for key, value in base_scope.components.items():
                    inner.components.setdefault(key, value)
        self._override(component, inherited)
        parameters = {p: g for p, g in inner.parameters.items() if p != g}
        rename = Renamer(parameters, parameters, {})
        unit = component.unit
        content.types.extend([*inherited.types, *(rename.type_decl(t) for t in unit.types)])
        content.relations.extend([*inherited.relations, *(rename.relation(r) for r in unit.relations)])
        content.clauses.extend([*inherited.clauses, *(rename.clause(c) for c in unit.clauses)])
        directives = [replace(d, relation=rename.name(d.relation)) for d in unit.directives]
        content.directives.extend([*inherited.directives, *directives])
        content.inits.extend([*inherited.inits, *((i, inner) for i in unit.inits)])
        return inner

    def check_overrides(self, components: Iterable[Component], scope: _Scope) -> None:
        """Report overrides of what cannot be overridden; components with a parameter as base are not known well enough."""
        for component in components:
            inner = _Scope({c.type.name: (c, scope) for c in component.unit.components}, {}, scope)
            self.check_overrides(component.unit.components, inner)
            inherited = self._inherited(component, scope, [])
            for name in component.unit.overrides:
                if inherited is None:
                    break
                if name not in inherited:
                    self.report.error(f"relation `{name}` is overridden, but not inherited", component.type.location)
                elif "overridable" not in inherited[name].qualifiers:
                    self.report.error(f"relation `{name}` is overridden, but not declared overridable", component.type.location)

    def _inherited(self, component: Component, scope: _Scope, active: list[Component]) -> dict[str, Relation] | None:
        """The relations of the bases of a component; None when a base is not known before it is instantiated."""
        result: dict[str, Relation] = {}
        for base in component.bases:
            found = None if base.name in component.type.params else scope.find(base.name)
            if found is None or found[0] in active:
                return None
            more = self._inherited(found[0], found[1], [*active, component])
            if more is None:
                return None
            result.update(more)
            result.update((r.name, r) for r in found[0].unit.relations)
        return result

    def _override(self, component: Component, inherited: _Content) -> None:
        """Drop the inherited clauses of overridden relations."""
        dropped = set(component.unit.overrides)
        inherited.clauses[:] = [c for c in inherited.clauses if c.head.name not in dropped]


class Renamer(Rewriter):
    """Copies declarations and clauses under other names; `i.x` follows the name of the instance `i`."""

    def __init__(self, names: Mapping[str, str], type_names: Mapping[str, str], instances: Mapping[str, str]) -> None:
        self.maps: Names = (names, type_names, instances)

    def _renamed(self, name: str, names: Mapping[str, str]) -> str:
        if name in names:
            return names[name]
        head, dot, rest = name.partition(".")
        return self.maps[2][head] + dot + rest if dot and head in self.maps[2] else name

    def name(self, name: str) -> str:
        """The new name of a relation."""
        return self._renamed(name, self.maps[0])

    def type_name(self, name: str) -> str:
        """The new name of a type or branch."""
        return self._renamed(name, self.maps[1])

    def fields(self, fields: Iterable[AttributeDecl]) -> tuple[AttributeDecl, ...]:
        """Fields or attributes with their types renamed."""
        return tuple(replace(f, type=self.type_name(f.type)) for f in fields)

    def type_decl(self, decl: TypeDecl) -> TypeDecl:
        """A type declaration, renamed."""
        name = self.type_name(decl.name)
        match decl:
            case SubsetDecl():
                return replace(decl, name=name, base=self.type_name(decl.base))
            case UnionDecl():
                return replace(decl, name=name, members=tuple(self.type_name(m) for m in decl.members))
            case RecordDecl():
                return replace(decl, name=name, fields=self.fields(decl.fields))
            case AdtDecl():
                branches = tuple(BranchDecl(self.type_name(b.name), self.fields(b.fields), b.location) for b in decl.branches)
                return replace(decl, name=name, branches=branches)

    def relation(self, relation: Relation) -> Relation:
        """A relation declaration, renamed."""
        return replace(relation, name=self.name(relation.name), attributes=self.fields(relation.attributes))
