"""The names that modules, classes and functions bind: a first pass over the syntax tree of a module."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from rosarch.extractor.python.messages import interface_module
from rosarch.extractor.python.model import Class, Function, FunctionNode, Import, Module, Scope, Source, Symbol, Variable
from rosarch.extractor.python.shapes import defaults_of, place
from rosarch.extractor.python_syntax import absolute_name

_OF_CLASS = frozenset({"__new__", "__init_subclass__", "__class_getitem__"})
"""Methods of the class itself, without a decorator that says so."""
_ENUMERATIONS = frozenset({"Enum", "IntEnum", "Flag", "IntFlag", "StrEnum"})


def open_module(module: Module) -> None:
    """Make the scope of a module and of all that is in it."""
    identifier = f"{module.name}@{module.key}" if module.key else module.name
    module.function = Function(identifier, module.name, "function", module=module)
    module.scope = module.function.scope = Scope("module", module, None, function=module.function)
    _Binder(module.scope).statements(module.tree.body)


class _Binder:
    """Records what the statements of one scope bind."""

    def __init__(self, scope: Scope) -> None:
        self.scope, self.module = scope, scope.module

    def statements(self, body: Sequence[ast.stmt]) -> None:
        for node in _statements(body):
            if isinstance(node, (ast.Global, ast.Nonlocal)):
                self.scope.elsewhere.update(dict.fromkeys(node.names, "global" if isinstance(node, ast.Global) else "nonlocal"))
        for node in _statements(body):
            self._statement(node)

    def _statement(self, node: ast.stmt) -> None:
        match node:
            case ast.FunctionDef() | ast.AsyncFunctionDef():
                self._function(node, node.name)
            case ast.ClassDef():
                self._class(node)
            case ast.Import():
                for alias in node.names:
                    self._bind(
                        alias.asname or alias.name.partition(".")[0], Import(alias.name if alias.asname else alias.name.partition(".")[0])
                    )
            case ast.ImportFrom():
                self._import_from(node)
            case ast.Assign():
                for target in node.targets:
                    self._target(target, node.value, node)
            case ast.AnnAssign():
                self._target(node.target, node.value, node)
                self._source(node.target, Source(node.annotation, self.scope, "annotation"), node)
            case ast.AugAssign():
                self._target(node.target, None, node)
            case ast.For() | ast.AsyncFor():
                self._source(node.target, Source(node.iter, self.scope).at(None), None)
            case ast.With() | ast.AsyncWith():
                for item in node.items:
                    if item.optional_vars is not None:
                        self._source(item.optional_vars, Source(item.context_expr, self.scope, "entered"), None)
            case ast.Try():
                for handler in node.handlers:
                    if handler.name:
                        self._variable(handler.name, handler)
        for expression in _expressions(node):
            self._inner(expression)

    def _inner(self, node: ast.expr) -> None:
        """Lambdas, and names that are bound within expressions."""
        match node:
            case ast.Call():
                self.module.calls.append((node, self.scope))
            case ast.Subscript():
                self.module.subscripts.append((node, self.scope))
            case ast.Lambda():
                self._function(node, f"<lambda {node.lineno}:{node.col_offset + 1}>")
            case ast.NamedExpr():
                self._target(node.target, node.value, None)
            case ast.ListComp() | ast.SetComp() | ast.GeneratorExp() | ast.DictComp():
                for generator in node.generators:
                    self._source(generator.target, Source(generator.iter, self.scope).at(None), None)

    def _bind(self, name: str, symbol: Symbol) -> None:
        known = self.scope.names.get(name)
        if isinstance(known, Import) and isinstance(symbol, Import):
            self.scope.other_imports.setdefault(name, []).append(symbol)
        elif known is None or isinstance(known, Variable):
            self.scope.names[name] = symbol

    def _import_from(self, node: ast.ImportFrom) -> None:
        path = interface_module(absolute_name(node.module or "", node.level, self.module.package))
        for alias in node.names:
            if alias.name == "*":
                self.scope.stars.append(path)
            else:
                self._bind(alias.asname or alias.name, Import(path, alias.name))

    def _function(self, node: FunctionNode, name: str) -> None:
        module, owner = self.module, self.scope.owner if self.scope.kind == "class" else None
        if owner is not None:
            qualified = f"{owner.name}::{name}"
        elif self.scope.kind == "module":
            qualified = module.member(name)
        else:
            qualified = f"{self.scope.function.name if self.scope.function else module.name}::{name}"
        line, column = place(node)
        if isinstance(node, ast.Lambda):
            identifier = f"lambda@{module.key}:{line}:{column}"
        else:
            identifier = f"{qualified}@{module.key}:{line}:{column}" if module.key else qualified
        function = Function(identifier, "lambda" if isinstance(node, ast.Lambda) else qualified, _kind(node, owner), node, module, owner)
        function.is_property = not isinstance(node, ast.Lambda) and any(
            _decorator(d) in ("property", "cached_property") for d in node.decorator_list
        )
        function.of_class = not isinstance(node, ast.Lambda) and (
            name in _OF_CLASS or any(_decorator(d) == "classmethod" for d in node.decorator_list)
        )
        function.is_context = not isinstance(node, ast.Lambda) and any(
            _decorator(d).rpartition(".")[2] in ("contextmanager", "asynccontextmanager") for d in node.decorator_list
        )
        function.is_factory = name == "__new__" and not _calls(node, "__new__")
        module.functions[node] = function
        scope = function.scope = Scope("function", module, self.scope, function=function, owner=self.scope.owner)
        self._parameters(function, scope, node.args)
        if isinstance(node, ast.Lambda):
            inner = _Binder(scope)
            for expression in _within(node.body):
                inner._inner(expression)
            return
        accessor = any(_decorator(decorator).endswith((".setter", ".deleter")) for decorator in node.decorator_list)
        if not accessor and not any(_decorator(decorator).endswith("overload") for decorator in node.decorator_list):
            self.scope.names[name] = function
        getter = self.scope.names.get(name)
        if isinstance(getter, Function) and any(_decorator(decorator).endswith(".setter") for decorator in node.decorator_list):
            getter.setter = function
        for default in [*node.args.defaults, *node.args.kw_defaults, *node.decorator_list]:
            if default is not None:
                for expression in _within(default):
                    self._inner(expression)
        _Binder(scope).statements(node.body)

    def _parameters(self, function: Function, scope: Scope, arguments: ast.arguments) -> None:
        named = [*arguments.posonlyargs, *arguments.args]
        if function.owner is not None and function.kind != "static_method" and named:
            function.receiver = named.pop(0).arg
        defaults = defaults_of(arguments)
        outer = scope.parent or scope
        for index, argument in enumerate([*named, *arguments.kwonlyargs]):
            variable = Variable(
                f"{function.identifier}#{index}", argument.arg, "parameter", self.module, *place(argument), function=function
            )
            variable.positional = index < len(named)
            if argument.annotation is not None:
                variable.sources.append(Source(argument.annotation, outer, "annotation"))
            if argument.arg in defaults:
                variable.sources.append(Source(defaults[argument.arg], outer))
            function.parameters.append(variable)
            self.module.variables.append(variable)
            scope.names[argument.arg] = variable
        for rest in (arguments.vararg, arguments.kwarg):
            if rest is not None:
                scope.names[rest.arg] = Variable(
                    f"{function.identifier}#{rest.arg}", rest.arg, "local", self.module, *place(rest), function=function
                )

    def _class(self, node: ast.ClassDef) -> None:
        outer = self.scope.owner if self.scope.kind == "class" else None
        if outer is not None:
            name = f"{outer.name}::{node.name}"
        elif self.scope.kind == "module":
            name = self.module.member(node.name)
        else:
            name = f"{self.scope.function.name if self.scope.function else self.module.name}::{node.name}"
        cls = Class(name, self.module, node)
        cls.enumeration = any(_decorator(base).rpartition(".")[2] in _ENUMERATIONS for base in node.bases)
        self.module.classes[node] = cls
        cls.scope = Scope("class", self.module, self.scope, function=self.scope.function, owner=cls)
        self.scope.names[node.name] = cls
        _Binder(cls.scope).statements(node.body)
        for member, symbol in cls.scope.names.items():
            if isinstance(symbol, Variable):
                cls.fields[member] = symbol

    def _target(self, target: ast.expr, value: ast.expr | None, statement: ast.stmt | None) -> None:
        """`target` is assigned `value`."""
        self._source(target, Source(value, self.scope) if value is not None else None, statement)

    def _source(self, target: ast.expr, source: Source | None, statement: ast.stmt | None) -> None:
        match target:
            case ast.Name():
                variable = self._variable(target.id, target, statement)
            case ast.Attribute(value=ast.Name(id=name)) if self._is_receiver(name) and self.scope.owner is not None:
                variable = self._field(self.scope.owner, target)
            case ast.Tuple() | ast.List():
                self._parts(target.elts, source)
                return
            case _:
                self.module.outer_targets.append((target, source))
                return
        if source is not None and variable is not None:
            variable.sources.append(source)

    def _parts(self, targets: Sequence[ast.expr], source: Source | None) -> None:
        """Each of `targets` is given its part; a starred one a list of what the others leave."""
        starred = False
        for index, target in enumerate(targets):
            starred |= isinstance(target, ast.Starred)
            part = source.at(None if starred else index) if source is not None else None
            if isinstance(target, ast.Starred):
                self._source(target.value, part.inside() if part is not None else None, None)
            else:
                self._source(target, part, None)

    def _is_receiver(self, name: str) -> bool:
        scope: Scope | None = self.scope
        while scope is not None and scope.kind == "function":
            if scope.function is not None and scope.function.receiver:
                return scope.function.receiver == name and name not in self.scope.names
            scope = scope.parent
        return False

    def _field(self, owner: Class, target: ast.Attribute) -> Variable | None:
        known = owner.fields.get(target.attr)
        begins = self.scope.function is not None and self.scope.function.kind == "constructor"
        if known is None or (begins and known.kind == "field" and known.first is None):
            at = place(target)
            if known is None:
                known = owner.fields[target.attr] = Variable(
                    f"{owner.name}::{target.attr}", target.attr, "field", self.module, *at, owner=owner
                )
                self.module.variables.append(known)
            known.line, known.column = at
            known.first = target if begins else None
        elif known.kind == "static_field":
            known.kind = "field"  # a default that objects have until they get their own
        return known

    def _variable(self, name: str, node: ast.AST, statement: ast.stmt | None = None) -> Variable | None:
        scope = self.scope.holder(name)
        known = scope.names.get(name)
        if isinstance(known, Variable):
            return known
        if known is not None:
            return None
        line, column = place(node)
        if scope.kind == "module":
            variable = Variable(self.module.member(name), name, "global", self.module, line, column)
        elif scope.kind == "class" and scope.owner is not None:
            variable = Variable(f"{scope.owner.name}::{name}", name, "static_field", self.module, line, column, owner=scope.owner)
        else:
            identifier = f"{name}@{self.module.key}:{line}:{column}"
            variable = Variable(identifier, name, "local", self.module, line, column, function=scope.function)
        if isinstance(statement, (ast.Assign, ast.AnnAssign)) and scope is self.scope:
            variable.first = statement
        scope.names[name] = variable
        self.module.variables.append(variable)
        return variable


def _calls(node: ast.AST, name: str) -> bool:
    """Whether a method called `name` is called in `node`."""
    return any(isinstance(part, ast.Call) and isinstance(part.func, ast.Attribute) and part.func.attr == name for part in ast.walk(node))


def _kind(node: FunctionNode, owner: Class | None) -> str:
    if isinstance(node, ast.Lambda):
        return "lambda"
    if owner is None:
        return "function"
    if node.name == "__init__":
        return "constructor"
    names = {_decorator(decorator) for decorator in node.decorator_list}
    return "static_method" if "staticmethod" in names else "method"


def _decorator(node: ast.expr) -> str:
    """The dotted name that a decorator, or a base, is written with."""
    match node:
        case ast.Name():
            return node.id
        case ast.Attribute():
            return f"{_decorator(node.value)}.{node.attr}"
        case ast.Call():
            return _decorator(node.func)
    return ""


def _statements(body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """The statements of one scope, those in blocks too, in the order of the source."""
    for node in body:
        yield node
        if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            for block in _blocks(node):
                yield from _statements(block)


def _blocks(node: ast.stmt) -> Iterator[Sequence[ast.stmt]]:
    """The blocks of statements in a statement."""
    yield getattr(node, "body", ())
    yield from (handler.body for handler in getattr(node, "handlers", ()))
    yield getattr(node, "orelse", ())
    yield getattr(node, "finalbody", ())
    yield from (case.body for case in getattr(node, "cases", ()))


def _expressions(node: ast.stmt) -> Iterator[ast.expr]:
    """The expressions of a statement itself, of lambdas only these themselves."""
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        return
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.expr):
            yield from _within(child)
        elif isinstance(child, ast.withitem):
            yield from _within(child.context_expr)


def _within(node: ast.expr) -> Iterator[ast.expr]:
    waiting = [node]
    while waiting:
        node = waiting.pop()
        yield node
        if isinstance(node, ast.Lambda):
            continue
        inner: list[ast.expr] = []
        for child in ast.iter_child_nodes(node):
            parts = ast.iter_child_nodes(child) if isinstance(child, (ast.keyword, ast.comprehension)) else (child,)
            inner += [part for part in parts if isinstance(part, ast.expr)]
        waiting += reversed(inner)
