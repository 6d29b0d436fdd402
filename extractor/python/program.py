"""A Python program: its modules, and where names lead, through imports and inheritance."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path

from rosarch.extractor.python.messages import message_of
from rosarch.extractor.python.model import (
    NOTHING,
    Class,
    ClassValue,
    ExternalValue,
    Function,
    FunctionValue,
    Import,
    InstanceValue,
    Module,
    ModuleValue,
    Scope,
    Symbol,
    Value,
    Values,
    Variable,
)
from rosarch.extractor.python.scopes import open_module
from rosarch.extractor.python.shapes import field_of

STUBS = Path(__file__).parent / "stubs"
"""Declarations of the client libraries, and of some modules of Python: what headers are for C++."""
_LONGEST_NAME = 200
"""Of a module that is declared."""


class Program:
    """The modules of the workspace that a component consists of, and declarations of others as they are asked for."""

    def __init__(self, modules: Mapping[str, Module]) -> None:
        self.modules: dict[str, Module | None] = dict(modules)
        self._external: dict[str, Class] = {}
        self._functions: dict[str, Function] = {}
        self._resolve_bases(modules.values())

    def _resolve_bases(self, modules: Iterable[Module]) -> None:
        """Find the bases of all classes of `modules`."""
        for module in modules:
            for node, cls in module.classes.items():
                outer = cls.scope.parent if cls.scope else None
                for base in node.bases:
                    found = self.dotted(base, outer or module.scope)
                    cls.bases += [value.cls for value in found if isinstance(value, ClassValue) and cls not in value.cls.ancestors()]
                    cls.bases += [self.external_class(value.path) for value in found if isinstance(value, ExternalValue)]
                for above in cls.bases:
                    above.derived.append(cls)
        for module in modules:
            for cls in module.classes.values():
                for variable in list(cls.fields.values()):
                    inherited = field_of(cls, variable)
                    if inherited is not variable:
                        inherited.sources += variable.sources

    def module(self, name: str) -> Module | None:
        """The module called `name`, of the workspace or declared."""
        if name not in self.modules:
            self.modules[name] = None
            stub = _stub(name)
            if stub is not None:
                module = self.modules[name] = Module(name, stub[0], is_package=stub[1])
                open_module(module)
                self._resolve_bases([module])
        return self.modules[name]

    def builtin(self, name: str) -> Class | Function | None:
        """A built-in class or function."""
        module = self.module("builtins")
        symbol = module.scope.names.get(name) if module else None
        return symbol if isinstance(symbol, (Class, Function)) else None

    def external_class(self, path: str) -> Class:
        """The class of a module that is not declared."""
        name = external_name(path)
        if name not in self._external:
            self._external[name] = Class(name)
        return self._external[name]

    def external_function(self, name: str, owner: Class | None = None) -> Function:
        """A function that is known by name alone."""
        if name not in self._functions:
            constructs = owner is not None and name == f"{owner.name}::__init__"
            self._functions[name] = Function(name, name, "constructor" if constructs else "method" if owner else "function", owner=owner)
        return self._functions[name]

    def values_of(self, symbol: Symbol) -> Values:
        """What a symbol that is no variable stands for."""
        match symbol:
            case Function():
                return frozenset({FunctionValue(symbol)})
            case Class():
                return frozenset({ClassValue(symbol)})
            case Import(path, ""):
                return frozenset({ModuleValue(path, self.module(path))})
            case Import(path, member):
                return self.of_module(path, member)
        return NOTHING

    def of_module(self, path: str, member: str) -> Values:
        """What the module `path` calls `member`, when it is no variable."""
        module = self.module(path)
        symbol = self.symbol_of(path, member)
        if isinstance(symbol, Import) and (symbol.path, symbol.member) == (path, member):
            symbol = None  # `from . import member` in the package: the module below it
        if isinstance(symbol, (Function, Class)):
            return self.values_of(symbol)
        if isinstance(symbol, Import) and symbol.member:
            return self.of_module(symbol.path, symbol.member)  # where the imports lead no further
        if isinstance(symbol, Import) and not symbol.member:
            return frozenset({ModuleValue(symbol.path, self.module(symbol.path))})
        whole = f"{path}.{member}"
        if symbol is None and self.module(whole) is not None:
            return frozenset({ModuleValue(whole, self.module(whole))})
        if symbol is None and (module is None or module.stub):
            return frozenset({ExternalValue(whole)})
        return NOTHING

    def symbol_of(self, path: str, member: str, seen: set[tuple[str, str]] | None = None) -> Symbol | None:
        """The symbol that the module `path` calls `member`, imports followed as far as they lead; `seen` have been looked at."""
        seen = set() if seen is None else seen
        module = self.module(path)
        if module is None or (path, member) in seen:
            return None
        seen.add((path, member))
        symbol = module.scope.names.get(member)
        if symbol is None:
            found = (self.symbol_of(star, member, seen) for star in module.scope.stars)
            return next((symbol for symbol in found if symbol is not None), None)
        return self._followed(symbol, module.scope, member, seen)

    def _followed(self, symbol: Symbol, scope: Scope, name: str, seen: set[tuple[str, str]]) -> Symbol | None:
        if isinstance(symbol, Variable) and scope.module.stub and isinstance(symbol.first, ast.Assign):
            value = symbol.first.value  # another name
            return (self.symbol_of(scope.module.name, value.id, seen) if isinstance(value, ast.Name) else None) or symbol
        if not isinstance(symbol, Import):
            return symbol
        choices = [symbol, *scope.other_imports.get(name, ())]
        for choice in choices:
            if choice.member:
                found = self.symbol_of(choice.path, choice.member, seen)
                if found is not None:
                    return found
        known = next((choice for choice in choices if not choice.member and self.module(choice.path) is not None), None)
        return known or symbol

    def lookup(self, name: str, scope: Scope) -> Symbol | None:
        """What `name` means in `scope`: variables, functions, classes of the program, else what is left of an import."""
        symbol = scope.lookup(name)
        if symbol is None:
            stars = (self.symbol_of(star, name) for star in scope.module.scope.stars)
            symbol = next((found for found in stars if found is not None), None) or self.builtin(name)
            if symbol is None and scope.module.scope.stars:
                unknown = next((star for star in scope.module.scope.stars if self.module(star) is None), None)
                symbol = Import(unknown, name) if unknown else None
            return symbol
        return self._followed(symbol, scope if name in scope.names else scope.module.scope, name, set())

    def dotted(self, node: ast.expr, scope: Scope) -> Values:
        """What a name, or names with dots between them, stands for when no variable is involved."""
        match node:
            case ast.Name(id=name):
                symbol = self.lookup(name, scope)
                return self.values_of(symbol) if symbol is not None else NOTHING
            case ast.Attribute(value=inner, attr=name):
                return frozenset().union(*(self.member(value, name) for value in self.dotted(inner, scope)))
            case ast.Subscript(value=inner):  # Generic[T]
                return self.dotted(inner, scope)
        return NOTHING

    def member(self, value: Value, name: str) -> Values:
        """What `name` of a module or class stands for, when it is no variable."""
        match value:
            case ModuleValue(path, _):
                return self.of_module(path, name)
            case ExternalValue(path):
                return frozenset({ExternalValue(f"{path}.{name}")})
            case ClassValue(cls):
                symbol = cls.find(name)
                if isinstance(symbol, (Function, Class)):
                    return self.values_of(symbol)
                if symbol is None and not all(ancestor.own for ancestor in cls.ancestors()):
                    return frozenset({ExternalValue(f"{cls.name.replace('::', '.')}.{name}")}) if cls.module is None else NOTHING
        return NOTHING


def external_name(path: str) -> str:
    """How facts name something of a module that is not declared: the module ends where a class begins, else before the last name."""
    parts = path.split(".")
    first = next((index for index, part in enumerate(parts) if part[:1].isupper()), len(parts) - 1)
    first = max(first, 1)
    return "::".join([".".join(parts[:first]), *parts[first:]]) if len(parts) > 1 else path


def names_class(path: str) -> bool:
    """Whether an unknown name is that of a class, by Python's conventions."""
    module, _, name = path.rpartition(".")
    if message_of(f"{module}::{name}") is not None:
        return True  # of messages, whatever they are called
    last = name.lstrip("_")
    return last[:1].isupper() and not (len(last) > 1 and last.isupper() and "_" in last)


@lru_cache(maxsize=256)
def _stub(name: str) -> tuple[ast.Module, bool] | None:
    base = STUBS.joinpath(*name.split("."))
    if len(name) > _LONGEST_NAME:
        return None
    for path, package in ((base.with_name(f"{base.name}.pyi"), False), (base / "__init__.pyi", True)):
        if path.is_file() and path.is_relative_to(STUBS):
            return ast.parse(path.read_text(encoding="utf-8")), package
    return None


def instance(cls: Class | None) -> Values:
    """An object of a class."""
    return frozenset({InstanceValue(cls)}) if cls is not None else NOTHING
