"""Modules, classes, functions and variables of a Python program, and what expressions may stand for."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import islice

from rosarch.extractor.python.containers import Path

FunctionNode = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


@dataclass(eq=False)
class Module:
    """A module: of the workspace (then `key` and `path` name its file), or a declaration (`stub`) of one that is elsewhere.

    `main` says that it is run as a program, and not imported. What stands from the line `left_out` on was not read (0: all was).
    `outer_targets` are assigned to, and neither names nor members of `self`.
    """

    name: str
    tree: ast.Module
    key: str = ""
    path: str = ""
    lines: tuple[bytes, ...] = ()
    main: bool = False
    is_package: bool = False
    left_out: int = 0
    scope: Scope = field(init=False)
    function: Function = field(init=False)
    functions: dict[ast.AST, Function] = field(default_factory=dict)
    classes: dict[ast.ClassDef, Class] = field(default_factory=dict)
    variables: list[Variable] = field(default_factory=list)
    calls: list[tuple[ast.Call, Scope]] = field(default_factory=list)
    subscripts: list[tuple[ast.Subscript, Scope]] = field(default_factory=list)
    outer_targets: list[tuple[ast.expr, Source | None]] = field(default_factory=list)

    @property
    def stub(self) -> bool:
        """Whether this is only a declaration."""
        return not self.key

    @property
    def package(self) -> str:
        """The package that the module is in, or is."""
        return self.name if self.is_package else self.name.rpartition(".")[0]

    def member(self, name: str) -> str:
        """The qualified name of what the module calls `name`."""
        return f"{self.name}::{name}" if self.name != "builtins" else name


@dataclass(eq=False)
class Class:
    """A class; one that no source declares has no `node` and no `module`. When its bases are `assumed`, how it is made is not known."""

    name: str
    module: Module | None = None
    node: ast.ClassDef | None = None
    scope: Scope | None = None
    bases: list[Class] = field(default_factory=list)
    derived: list[Class] = field(default_factory=list)
    fields: dict[str, Variable] = field(default_factory=dict)
    enumeration: bool = False
    assumed: bool = False

    @property
    def own(self) -> bool:
        """Whether the workspace defines it."""
        return self.module is not None and not self.module.stub

    def ancestors(self) -> Iterator[Class]:
        """The class and those it derives from, in the order in which members are looked for; each once.

        That is the C3 linearization (https://docs.python.org/3/howto/mro.html). Where there is none, Python rejects the class.
        """
        cls, seen = self, dict[int, Class]()
        while len(cls.bases) == 1 and id(cls) not in seen:
            seen[id(cls)] = cls
            yield cls
            cls = cls.bases[0]
        yield from (other for other in _linearization(cls) if id(other) not in seen)

    def joined(self) -> list[Class]:
        """The classes that derive from it and from others, each once: their objects may have other classes behind it."""
        found = {id(cls): cls for cls in self.derived}
        waiting = list(found.values())
        while waiting:
            more = {id(cls): cls for cls in waiting.pop().derived if id(cls) not in found}
            found |= more
            waiting += more.values()
        return [cls for cls in found.values() if len(cls.bases) > 1]

    def following(self, cls: Class) -> list[Class]:
        """Where objects of this class look for members after those of `cls`, one of its ancestors."""
        line = list(self.ancestors())
        return line[line.index(cls) + 1 :] if cls in line else []

    def above(self, name: str) -> list[Symbol]:
        """What `super().name` may be in its methods."""
        found: dict[int, Symbol] = {}
        for cls in (self, *self.joined()):
            symbol = _first(cls.following(self), name)
            if symbol is not None:
                found[id(symbol)] = symbol
        return list(found.values())

    def member(self, name: str) -> Symbol | None:
        """What the class itself, without its bases, calls `name`: a method, a nested class, a data member."""
        symbol = self.scope.names.get(name) if self.scope else None
        return symbol if isinstance(symbol, (Function, Class)) else self.fields.get(name)

    def find(self, name: str, *, above: bool = False) -> Symbol | None:
        """What objects of the class call `name`; from `above`, what they would without the class itself."""
        return _first(islice(self.ancestors(), 1 if above else 0, None), name)

    def entered(self) -> list[Function]:
        """What making an object enters: `__new__`, and then, unless it gives something else, `__init__`."""
        made = self.find("__new__")
        maker = [made] if isinstance(made, Function) else []
        first = self.find("__init__")
        return maker if maker and maker[0].is_factory else [*maker, *([first] if isinstance(first, Function) else [])]

    @property
    def factory(self) -> Function | None:
        """The `__new__` that gives something else than an object of the class."""
        made = self.find("__new__")
        return made if isinstance(made, Function) and made.is_factory else None


def _linearization(cls: Class) -> list[Class]:
    """A class and its ancestors; of circles, each once."""
    lines: dict[int, list[Class]] = {}
    waiting, entered = [cls], set[int]()
    while waiting:
        top = waiting[-1]
        if id(top) not in entered:
            entered.add(id(top))
            waiting += [base for base in top.bases if id(base) not in entered]
        else:
            if id(top) not in lines:
                lines[id(top)] = [top, *_merged([*(lines[id(base)] for base in top.bases if id(base) in lines), top.bases])]
            waiting.pop()
    return lines[id(cls)]


def _merged(lines: list[list[Class]]) -> Iterator[Class]:
    """All classes of some lines, each behind those that it is behind in any of them, if that can be."""
    while lines := [line for line in lines if line]:
        firsts = [line[0] for line in lines]
        behind = {id(cls) for line in lines for cls in line[1:]}
        chosen = next((first for first in firsts if id(first) not in behind), firsts[0])
        yield chosen
        lines = [[cls for cls in line if cls is not chosen] for line in lines]


def _first(classes: Iterable[Class], name: str) -> Symbol | None:
    """What the first of the classes that has one calls `name`."""
    for cls in classes:
        symbol = cls.member(name)
        if symbol is not None or (cls.assumed and name == "__init__"):
            return symbol
    return None


@dataclass(eq=False)
class Function:
    """A function with a body in the workspace, a declared one (of a stub), or one that is only known by name (no `node`).

    `of_class` says that its first parameter is the class; `is_factory`, that it is a `__new__` that makes no object of its class;
    `is_context`, that what it yields is what `with` gives. `setter` is what an assignment to a property calls.
    """

    identifier: str
    name: str
    kind: str
    node: FunctionNode | None = None
    module: Module | None = None
    owner: Class | None = None
    scope: Scope | None = None
    parameters: list[Variable] = field(default_factory=list)
    receiver: str = ""
    is_property: bool = False
    setter: Function | None = None
    of_class: bool = False
    is_factory: bool = False
    is_context: bool = False

    @property
    def undeclared(self) -> bool:
        """Whether nothing but its name is known: neither the workspace nor a stub declares it, nor its class."""
        return self.node is None and not (self.owner is not None and self.owner.node is not None)

    @property
    def own(self) -> bool:
        """Whether the workspace defines it."""
        return self.module is not None and not self.module.stub

    def index_of(self, name: str) -> int | None:
        """The index of the parameter called `name`."""
        return next((index for index, parameter in enumerate(self.parameters) if parameter.name == name), None)


@dataclass(frozen=True)
class Source:
    """What a variable gets in `scope`: by its `part` the value of `expr` at `path`, the same as an element (inside), or an annotation.

    Of what `with` enters, it is what the object gives (entered).
    """

    expr: ast.expr
    scope: Scope
    part: str = "value"
    path: Path = ()

    def at(self, step: int | None) -> Source:
        """What one element of the value is."""
        return replace(self, path=(*self.path, step))

    def inside(self) -> Source:
        """The same, for an element of the variable."""
        return replace(self, part="inside")


@dataclass(eq=False)
class Variable:
    """A variable; `sources` are what it gets, `first` the statement that declares it: its first assignment."""

    identifier: str
    name: str
    kind: str
    module: Module | None = None
    line: int = 0
    column: int = 0
    owner: Class | None = None
    function: Function | None = None
    sources: list[Source] = field(default_factory=list)
    first: ast.AST | None = None
    positional: bool = True


@dataclass(eq=False)
class Import:
    """A name that an import binds: the module `path`, or the member `member` of it."""

    path: str
    member: str = ""


Symbol = Variable | Function | Class | Import


@dataclass(eq=False)
class Scope:
    """The names of a module, a class or a function; `function` is the one whose body this is part of."""

    kind: str
    module: Module
    parent: Scope | None
    names: dict[str, Symbol] = field(default_factory=dict)
    function: Function | None = None
    owner: Class | None = None
    elsewhere: dict[str, str] = field(default_factory=dict)
    stars: list[str] = field(default_factory=list)
    other_imports: dict[str, list[Import]] = field(default_factory=dict)

    def lookup(self, name: str) -> Symbol | None:
        """What `name` means in this scope: classes are passed over from within functions."""
        if self.elsewhere.get(name) == "global":
            return self.module.scope.names.get(name)
        if name in self.names and self.elsewhere.get(name) != "nonlocal":
            return self.names[name]
        outer = self.parent
        while outer is not None:
            if outer.kind != "class" and name in outer.names:
                return outer.names[name]
            outer = outer.parent
        return None

    def holder(self, name: str) -> Scope:
        """The scope in which an assignment to `name` here takes place."""
        where = self.elsewhere.get(name)
        if where == "global":
            return self.module.scope
        outer = self.parent
        while where == "nonlocal" and outer is not None:
            if outer.kind == "function" and name in outer.names:
                return outer
            outer = outer.parent
        return self


# What an expression may stand for.


@dataclass(frozen=True)
class ModuleValue:
    """A module; `module` is None when it is neither in the workspace nor declared."""

    path: str
    module: Module | None


@dataclass(frozen=True)
class ExternalValue:
    """Something of a module that is not declared, by its dotted name."""

    path: str


@dataclass(frozen=True)
class ClassValue:
    """A class itself."""

    cls: Class


@dataclass(frozen=True)
class InstanceValue:
    """An object of a class."""

    cls: Class


@dataclass(frozen=True)
class FunctionValue:
    """A function; `bound` when its object is given with it."""

    function: Function
    bound: bool = False


Value = ModuleValue | ExternalValue | ClassValue | InstanceValue | FunctionValue
Values = frozenset[Value]
NOTHING: Values = frozenset()
