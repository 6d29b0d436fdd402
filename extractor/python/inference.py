"""What expressions may stand for: modules, classes, functions, objects of classes. The order of assignments is not looked at."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable
from typing import TypeVar

from rosarch.extractor.python.assumed import assume_classes
from rosarch.extractor.python.containers import DEEPEST, Path, index_of, taken_from, written_parts
from rosarch.extractor.python.handing import handed_on
from rosarch.extractor.python.model import (
    NOTHING,
    Class,
    ClassValue,
    ExternalValue,
    Function,
    FunctionValue,
    InstanceValue,
    Module,
    ModuleValue,
    Scope,
    Source,
    Symbol,
    Value,
    Values,
    Variable,
)
from rosarch.extractor.python.program import Program, instance, names_class
from rosarch.extractor.python.shapes import arguments_of, by_name, field_of, last_name, name_of_value, place, returned, super_of
from rosarch.extractor.python_syntax import import_call

Key = TypeVar("Key")
_ROUNDS = 8
_ANYTHING = frozenset({"Any", "object", "Callable", "None"})
_MOST_VALUES = 16
_CONTAINERS = {
    ast.List: "list",
    ast.ListComp: "list",
    ast.Tuple: "tuple",
    ast.Dict: "dict",
    ast.DictComp: "dict",
    ast.Set: "set",
    ast.SetComp: "set",
}


class Inference:
    """Values of expressions of one program: the least that all its assignments, calls and returns ask for, found in rounds."""

    def __init__(self, program: Program, modules: Iterable[Module]) -> None:
        self.program = program
        self._modules = list(modules)
        self._values: dict[Variable | Function, dict[Path, Values]] = defaultdict(lambda: {(): NOTHING})
        """What is known about variables and about what functions return: of these themselves, and of their parts that were asked for."""
        self._expressions: dict[tuple[ast.expr, Scope], Values] = {}
        self._taken_for: dict[tuple[ast.expr, Scope], Values] = {}
        self._rounds()
        while assume_classes(self, self._modules):
            self._rounds()

    def _rounds(self) -> None:
        """Add all that follows from what is known."""
        for _ in range(_ROUNDS):
            if not self._round():
                break
        self._expressions.clear()

    def _round(self) -> bool:
        """Add what follows from what is known; whether anything was new."""
        self._expressions.clear()
        new = self._asked = False
        for module in self._modules:
            for target, source in module.outer_targets:
                self._outer_target(module, target, source)
            holders: list[Variable | Function] = [*module.variables, *module.functions.values()]
            for holder in holders:
                new |= self._learn(holder)
            for call, scope in module.calls:
                new |= self._passes(call, scope)
            for subscript, scope in module.subscripts:
                self.values(subscript, scope)
        return new or self._asked

    def _learn(self, holder: Variable | Function) -> bool:
        """Add what `holder` gets, and those parts of it that are asked for; whether any is new."""
        known = self._values[holder]
        new = False
        for path in list(known):
            if isinstance(holder, Function):
                values = self._returned(holder, path)
            else:
                values = frozenset().union(*(self._source(source, path) for source in holder.sources))
            new |= _grow(known, path, values)
        return new

    def _passes(self, call: ast.Call, scope: Scope) -> bool:
        """The parameters of the functions that `call` may enter get its arguments; a list gets what is appended."""
        new = False
        if isinstance(call.func, ast.Attribute) and call.func.attr in ("append", "add", "appendleft") and len(call.args) == 1:
            for variable in self.named(call.func.value, scope):
                _add_source(variable, Source(call.args[0], scope, "inside"))
        for function in self.callees(call, scope):
            if function.own:
                for parameter, argument in arguments_of(call, function).items():
                    known = self._values[parameter]
                    for path in list(known):
                        new |= _grow(known, path, self.part(argument, path, scope))
            elif function.node is not None:
                for parameter, values in handed_on(self, call, function, scope):
                    new |= _grow(self._values[parameter], (), values)
        return new

    def callees(self, call: ast.Call, scope: Scope) -> list[Function]:
        """The functions that `call` may enter, constructors too."""
        found: list[Function] = []
        for value in by_name(self.callee_values(call, scope)):
            match value:
                case FunctionValue(function, _):
                    found.append(function)
                case ClassValue(cls):
                    found += cls.entered()
                case InstanceValue(cls):
                    called = cls.find("__call__")
                    found += [called] if isinstance(called, Function) else []
        return found

    def _outer_target(self, module: Module, target: ast.expr, source: Source | None) -> None:
        """`object.name = value`, `list[index] = value`."""
        if source is None:
            return
        if isinstance(target, ast.Subscript):
            for variable in self.named(target.value, source.scope):
                _add_source(variable, source.inside())
        elif isinstance(target, ast.Attribute):
            for value in self.values(target.value, source.scope):
                if isinstance(value, InstanceValue) and value.cls.own:
                    symbol = value.cls.find(target.attr)
                    if symbol is None:
                        name = f"{value.cls.name}::{target.attr}"
                        symbol = Variable(name, target.attr, "field", module, *place(target), owner=value.cls)
                        value.cls.fields[target.attr] = symbol
                        module.variables.append(symbol)
                    if isinstance(symbol, Variable):
                        _add_source(symbol, source)

    def named(self, node: ast.expr, scope: Scope) -> list[Variable]:
        """The variables that `node` may name."""
        if isinstance(node, ast.Name):
            symbol = self.program.lookup(node.id, scope)
            return [symbol] if isinstance(symbol, Variable) else []
        return self.fields(node, scope) if isinstance(node, ast.Attribute) else []

    def values(self, node: ast.expr | None, scope: Scope) -> Values:
        """What the value of `node` may be, as far as it is known."""
        if node is None:
            return NOTHING
        key = (node, scope)
        found = self._expressions.get(key)
        if found is None:
            found = self._expressions[key] = self._infer(node, scope) or self._taken_for.get(key, NOTHING)
        return found

    def take_for(self, node: ast.expr, scope: Scope, cls: Class) -> bool:
        """Take what `node` stands for, of which nothing is known, for an object of `cls`; whether this is new."""
        variables = [variable for variable in self.named(node, scope) if variable.module is not None and not variable.module.stub]
        if not variables:
            self._expressions.pop((node, scope), None)
            return _grow(self._taken_for, (node, scope), instance(cls))
        self._expressions.clear()
        return any([_grow(self._values[variable], (), instance(cls)) for variable in variables])

    def variable(self, variable: Variable) -> Values:
        """What a variable may hold."""
        return self._held(variable, ())

    def _held(self, holder: Variable | Function, path: Path) -> Values:
        """The part at `path` of what a variable holds, or a function returns; it is known from the round after it was first asked for."""
        if holder.module is not None and holder.module.stub:
            if isinstance(holder, Function):
                return self._returned(holder, path)
            return frozenset().union(*(self._source(source, path) for source in holder.sources if source.part == "annotation"))
        known = self._values[holder]
        if path not in known and len(path) <= DEEPEST:
            known[path] = NOTHING
            self._asked = True
        return known.get(path, NOTHING)

    def _source(self, source: Source, path: Path) -> Values:
        if source.part == "annotation":
            return self.annotated(source.expr, source.scope, path)
        if source.part == "entered" and (entering := self.entering(source.expr, source.scope)):
            return frozenset().union(*(self._held(function, (*source.path, *path)) for function in entering))
        if source.part == "inside":
            return self.part(source.expr, (*source.path, *path[1:]), source.scope) if path else NOTHING
        return self.part(source.expr, (*source.path, *path), source.scope)

    def part(self, node: ast.expr, path: Path, scope: Scope) -> Values:
        """What the part of the value of `node` at `path` may be."""
        found: set[Value] = set()
        waiting = [(node, path)]
        while waiting:
            node, path = waiting.pop()
            if not path:
                found |= self.values(node, scope)
                continue
            waiting += written_parts(node, path)
            holders: Iterable[Variable | Function] = ()
            match node:
                case ast.Name() | ast.Attribute():
                    holders = self.named(node, scope)
                case ast.Call(func=ast.Attribute(value=above, attr="__subclasses__"), args=[]) if len(path) == 1:
                    found |= self._subclasses(self.values(above, scope))
                case ast.Call(func=ast.Name(id="range" | "xrange")):
                    found |= instance(self._builtin("int"))
                case ast.Call():
                    holders = self.callees(node, scope)
            for holder in holders:
                found |= self._held(holder, path)
        return frozenset(found)

    def _subclasses(self, classes: Values) -> Values:
        """The classes of the program that derive from one of `classes` directly."""
        above = {value.cls for value in classes if isinstance(value, ClassValue)}
        own = (cls for module in self._modules for cls in module.classes.values())
        return frozenset(ClassValue(cls) for cls in own if not above.isdisjoint(cls.bases))

    def annotated(self, node: ast.expr | None, scope: Scope, path: Path = ()) -> Values:
        """Objects of the class that an annotation names, or of those that it names for the part at `path`."""
        match node:
            case ast.Constant(value=str(text)):
                try:
                    return self.annotated(ast.parse(text, mode="eval").body, scope, path)
                except (SyntaxError, ValueError, RecursionError, MemoryError):
                    return NOTHING
            case ast.BinOp(left=left, op=ast.BitOr(), right=right):
                return self.annotated(left, scope, path) | self.annotated(right, scope, path)
            case ast.Subscript(value=outer, slice=inner):
                if last_name(outer) in ("Optional", "Final", "ClassVar", "Annotated"):
                    return self.annotated(inner.elts[0] if isinstance(inner, ast.Tuple) else inner, scope, path)
                if last_name(outer) == "Union" and isinstance(inner, ast.Tuple):
                    return frozenset().union(*(self.annotated(part, scope, path) for part in inner.elts))
                if not path:
                    return self.annotated(outer, scope)
                parts = inner.elts if isinstance(inner, ast.Tuple) else [inner]
                if last_name(outer) in ("Tuple", "tuple") and path[0] is not None:
                    parts = parts[path[0] : path[0] + 1] or parts
                return frozenset().union(*(self.annotated(part, scope, path[1:]) for part in parts))
            case ast.Name() | ast.Attribute() if path or last_name(node) in _ANYTHING:
                return NOTHING
            case ast.Name() | ast.Attribute():
                named = self.program.dotted(node, scope)
                return frozenset(self.object_of(value) for value in named if not isinstance(value, (ModuleValue, FunctionValue)))
        return NOTHING

    def object_of(self, value: Value) -> Value:
        """An object of the class that `value` is."""
        if isinstance(value, ExternalValue):
            return InstanceValue(self.program.external_class(value.path))
        return InstanceValue(value.cls) if isinstance(value, ClassValue) else value

    def fields(self, node: ast.Attribute, scope: Scope) -> list[Variable]:
        """The data members that `object.name` may name."""
        found = []
        for value in sorted(self.values(node.value, scope), key=name_of_value):
            if isinstance(value, (InstanceValue, ClassValue)):
                symbol = value.cls.find(node.attr)
                if isinstance(symbol, Variable):
                    found.append(field_of(value.cls, symbol))
            elif isinstance(value, ModuleValue):
                symbol = self.program.symbol_of(value.path, node.attr)
                if isinstance(symbol, Variable):
                    found.append(symbol)
        return list(dict.fromkeys(found))

    def _infer(self, node: ast.expr, scope: Scope) -> Values:
        match node:
            case ast.Name(id=name):
                return self._name(name, scope)
            case ast.Attribute():
                return self._attribute(node, scope)
            case ast.Call():
                return self._call(node, scope)
            case ast.Constant(value=value):
                return NOTHING if value is None or value is Ellipsis else instance(self._builtin(type(value).__name__))
            case ast.JoinedStr():
                return instance(self._builtin("str"))
            case ast.Lambda():
                function = scope.module.functions.get(node)
                return frozenset({FunctionValue(function)}) if function else NOTHING
            case ast.IfExp(body=yes, orelse=no):
                return self.values(yes, scope) | self.values(no, scope)
            case ast.BoolOp(values=parts):
                return frozenset().union(*(self.values(part, scope) for part in parts))
            case ast.Compare() | ast.UnaryOp(op=ast.Not()):
                return instance(self._builtin("bool"))
            case ast.UnaryOp(operand=inner) | ast.NamedExpr(value=inner) | ast.Await(value=inner):
                return self.values(inner, scope)
            case ast.BinOp(left=left, right=right):
                return self._binary(self.values(left, scope), self.values(right, scope))
            case ast.Subscript(value=inner, slice=ast.Slice()):
                return self.values(inner, scope)
            case ast.Subscript(value=inner, slice=index):
                return self.part(inner, (index_of(index),), scope)
        kind = _CONTAINERS.get(type(node))
        return instance(self._builtin(kind)) if kind else NOTHING

    def _builtin(self, name: str) -> Class | None:
        found = self.program.builtin(name)
        return found if isinstance(found, Class) else None

    def _binary(self, left: Values, right: Values) -> Values:
        """Numbers with numbers are numbers; of other objects, the first decides."""
        names = {value.cls.name for value in left | right if isinstance(value, InstanceValue)}
        if names and names <= {"int", "float", "bool"}:
            return instance(self._builtin("float" if "float" in names else "int"))
        return left or right

    def _name(self, name: str, scope: Scope) -> Values:
        function = scope.function
        outer: Scope | None = scope
        while outer is not None and name not in outer.names:
            function = outer.function if outer.kind == "function" else None
            if function is not None and function.receiver == name and function.owner is not None:
                return frozenset({ClassValue(function.owner) if function.of_class else InstanceValue(function.owner)})
            outer = outer.parent
        symbol = self.program.lookup(name, scope)
        if symbol is None:
            return NOTHING
        if isinstance(symbol, Variable):
            return self.variable(symbol)
        return self.program.values_of(symbol)

    def _attribute(self, node: ast.Attribute, scope: Scope) -> Values:
        found: set[Value] = set()
        for value in self.values(node.value, scope):
            match value:
                case InstanceValue(cls):
                    found |= self.of_object(cls, node.attr)
                case ModuleValue(path, _):
                    symbol = self.program.symbol_of(path, node.attr)
                    found |= self.variable(symbol) if isinstance(symbol, Variable) else self.program.of_module(path, node.attr)
                case ClassValue(cls):
                    symbol = cls.find(node.attr)
                    if isinstance(symbol, Variable):
                        found |= instance(cls) if cls.enumeration else self.variable(symbol)
                    else:
                        found |= self.program.member(value, node.attr)
                case ExternalValue():
                    found |= self.program.member(value, node.attr)
        return frozenset(found)

    def of_object(self, cls: Class, name: str) -> Values:
        """What `name` of an object of `cls` stands for."""
        return self._of_member(cls, cls.find(name), name)

    def _of_member(self, cls: Class, symbol: Symbol | None, name: str) -> Values:
        if isinstance(symbol, Function):
            return self.returns(symbol) if symbol.is_property else frozenset({FunctionValue(symbol, bound=symbol.kind != "static_method")})
        if isinstance(symbol, Variable):
            # until it is set, an object has the method that its class inherits under this name
            covered = cls.find(name, above=True) if cls.member(name) is symbol else None
            inherited = {FunctionValue(covered, bound=True)} if isinstance(covered, Function) and covered.kind == "method" else NOTHING
            return self.variable(field_of(cls, symbol)) | inherited
        return frozenset({ClassValue(symbol)}) if isinstance(symbol, Class) else NOTHING

    def callee_values(self, node: ast.Call, scope: Scope) -> Values:
        """What a call calls."""
        cls = super_of(node.func, scope)
        if cls is not None and isinstance(node.func, ast.Attribute):
            name = node.func.attr
            return frozenset(value for symbol in cls.above(name) for value in self._of_member(cls, symbol, name))
        return self.values(node.func, scope)

    def _call(self, node: ast.Call, scope: Scope) -> Values:
        if isinstance(node.func, ast.Name) and node.func.id == "super" and scope.owner is not None:
            return NOTHING  # see `super_of`
        imported = import_call(node, scope.module.package)
        if imported is not None:
            return frozenset({ModuleValue(imported[1], self.program.module(imported[1]))})
        container = taken_from(node)
        result = set(self.part(container, (None,), scope) if container is not None else NOTHING)
        if container is not None and len(node.args) > 1:  # what is given when nothing is there
            result |= self.values(node.args[1], scope)
        for value in self.callee_values(node, scope):
            match value:
                case ClassValue(cls):
                    result |= self.returns(cls.factory) if cls.factory else {InstanceValue(cls)}
                case FunctionValue(function, _):
                    result |= self.returns(function)
                case ExternalValue(path):
                    if names_class(path):
                        result.add(InstanceValue(self.program.external_class(path)))
                case InstanceValue(cls):
                    called = cls.find("__call__")
                    result |= self.returns(called) if isinstance(called, Function) else NOTHING
        return frozenset(result)

    def entering(self, node: ast.expr, scope: Scope) -> list[Function]:
        """The methods `__enter__` of the workspace that `with` may call on the value of `node`."""
        objects = (value.cls for value in by_name(self.values(node, scope)) if isinstance(value, InstanceValue))
        found = (cls.find("__enter__") or cls.find("__aenter__") for cls in objects)
        return [symbol for symbol in found if isinstance(symbol, Function) and symbol.own]

    def returns(self, function: Function) -> Values:
        """What a function returns."""
        return self._held(function, ())

    def _returned(self, function: Function, path: Path) -> Values:
        if function.node is None or function.scope is None:
            return NOTHING
        if isinstance(function.node, ast.Lambda):
            return self.part(function.node.body, path, function.scope)
        if function.node.returns is not None:
            return self.annotated(function.node.returns, function.scope.parent or function.scope, path)
        return frozenset().union(*(self.part(value, path, function.scope) for value in returned(function)))


def _add_source(variable: Variable, source: Source) -> None:
    if source not in variable.sources:
        variable.sources.append(source)


def _grow(table: dict[Key, Values], key: Key, values: Values) -> bool:
    """Add `values` to an entry; whether any is new."""
    known = table.get(key, NOTHING)
    if values <= known or len(known) > _MOST_VALUES:
        return False
    table[key] = known | values
    return True
