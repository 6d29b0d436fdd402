"""The facts of a Python program in work, and a function body in work."""

from __future__ import annotations

import ast
import re
import sys
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

from rosarch.extractor.flow import Flow
from rosarch.extractor.python.fitting import positional_arguments
from rosarch.extractor.python.inference import Inference
from rosarch.extractor.python.messages import message_of
from rosarch.extractor.python.model import Class, Function, InstanceValue, Module, Scope, Values, Variable
from rosarch.extractor.python.program import Program
from rosarch.extractor.python.shapes import place

TEXT_LIMIT = 2000
_NUMBERS = ("float", "int", "bool")
_PLAIN = frozenset({*_NUMBERS, "str", "list", "dict", "tuple", "set", "bytes"})
ANY = "object"
"""The type of what may be anything."""


@dataclass
class Members:
    """What modules bind to names, the names that code mentions otherwise, and what may fail; made when it is first asked for."""

    bound: dict[str, set[str]] = field(default_factory=dict)
    named: set[str] = field(default_factory=set)
    guarded: set[ast.AST] = field(default_factory=set)

    def __bool__(self) -> bool:
        return bool(self.bound)


@dataclass
class Facts:
    """Rows, and the identifiers given out so far."""

    program: Program
    inference: Inference
    rows: dict[str, set[tuple[str | int, ...]]] = field(default_factory=lambda: defaultdict(set))
    numbers: dict[ast.expr, int | float | None] = field(default_factory=dict)
    """What operations that were lowered come to, None for what is no arithmetic on literals."""
    members: Members = field(default_factory=Members)
    _ids: dict[str, int] = field(default_factory=dict)
    _declared: set[object] = field(default_factory=set)

    def add(self, relation: str, *row: str | int) -> None:
        """Add one row to `relation`."""
        self.rows[relation].add(row)

    def node(self, module: Module, node: ast.AST, form: str) -> str:
        """Give out the identifier of a node of the syntax tree and record its location."""
        line, column = place(node)
        identifier = f"{module.key}:{line}:{column}:{form}"
        count = self._ids[identifier] = self._ids.get(identifier, 0) + 1
        if count > 1:
            identifier = f"{identifier}'{count}"
        self.add("location", identifier, module.key, line, column)
        return identifier

    def function(self, function: Function) -> str:
        """Declare a function."""
        if function in self._declared:
            return function.identifier
        self._declared.add(function)
        name = function.identifier
        self.add("function", name, function.kind)
        self.add("function_name", name, function.name)
        if function.own and function.module is not None:
            self.add("location", name, function.module.key, *place(function.node or function.module.tree))
        if function.owner is not None and function.kind != "lambda":
            self.add("function_class", name, self.cls(function.owner))
            self._overrides(function, function.owner)
        if function.own:
            for index, parameter in enumerate(function.parameters):
                self.add("function_parameter", name, index, self.variable(parameter))
            if function.node is not None:
                self.add("function_takes", name, *positional_arguments(function))
        elif function.undeclared and function.name.partition("::")[0].partition(".")[0] not in sys.stdlib_module_names:
            self.add("function_undeclared", name)
        return name

    def _overrides(self, function: Function, owner: Class) -> None:
        if function.kind == "constructor":
            return
        short = function.name.rpartition("::")[2]
        # in objects of a class that derives from others, too, it hides what these have behind its own class
        behind = dict.fromkeys(cls for derived in (owner, *owner.joined()) for cls in derived.following(owner))
        for cls in behind:
            above = cls.member(short)
            if isinstance(above, Function):
                self.add("function_overrides", function.identifier, self.function(above))

    def cls(self, cls: Class) -> str:
        """Declare a class."""
        if cls not in self._declared:
            self._declared.add(cls)
            self.add("class", cls.name, "enum" if cls.enumeration else "class")
            self.add("class_by_reference", cls.name)
            self.add("type_class", cls.name, cls.name)
            if cls.node is None:
                self.add("class_undeclared", cls.name)
            if cls.own and cls.module is not None and cls.node is not None:
                self.add("location", cls.name, cls.module.key, *place(cls.node))
            for base in cls.bases:
                self.add("class_base", cls.name, self.cls(base))
            message = message_of(cls.name)
            if message is not None:
                self.add("message_class", cls.name, *message)
        return cls.name

    def variable(self, variable: Variable) -> str:
        """Declare a variable."""
        if variable in self._declared:
            return variable.identifier
        self._declared.add(variable)
        name = variable.identifier
        self.add("variable", name, variable.kind)
        self.add("variable_name", name, variable.name)
        self.add("variable_type", name, self.type(self.inference.variable(variable)))
        if variable.owner is not None:
            self.add("field_class", name, self.cls(variable.owner))
        if variable.function is not None:
            self.add("variable_function", name, variable.function.identifier)
        if variable.module is not None and not variable.module.stub:
            self.add("location", name, variable.module.key, variable.line, variable.column)
        return name

    def unknown_member(self, name: str) -> str:
        """A data member of an object that nothing is known about."""
        identifier = f"?::{name}"
        self.add("variable", identifier, "field")
        self.add("variable_name", identifier, name)
        self.add("field_class", identifier, "?")
        self.add("variable_type", identifier, ANY)
        return identifier

    def type(self, values: Values) -> str:
        """The type of a variable that may hold `values`: that of numbers, or the one class; of several, the workspace's own first."""
        classes = {value.cls.name: value.cls for value in values if isinstance(value, InstanceValue)}
        numbers = [name for name in _NUMBERS if name in classes]
        if numbers and len(numbers) == len(classes):
            return numbers[0]
        if not classes:
            return ANY
        cls = min(classes.values(), key=lambda cls: (cls.name in _PLAIN, not cls.own, cls.name))
        self.cls(cls)
        if cls.name in _PLAIN:
            return cls.name
        name = f"{cls.name} object"
        self.add("type_inner", name, "object", cls.name)
        return name


@dataclass
class Body:
    """The function whose body is read; `function` is empty for what is evaluated when a class or function is defined."""

    facts: Facts
    module: Module
    scope: Scope
    flow: Flow
    function: str = ""
    finally_: list[tuple[Sequence[ast.stmt], int]] = field(default_factory=list)
    """What each `try` around does in any case, and in how many loops that is."""

    @property
    def inference(self) -> Inference:
        """What expressions stand for."""
        return self.facts.inference

    def node(self, node: ast.AST, form: str) -> str:
        """Give out the identifier of an expression."""
        identifier = self.facts.node(self.module, node, form)
        if self.function:
            self.facts.add("expr_function", identifier, self.function)
        return identifier

    def operator(self, node: ast.AST, name: str, *operands: str, form: str = "op") -> str:
        """Record an operator with its operands."""
        expr = self.node(node, form)
        self.facts.add("operator", expr, name)
        for index, operand in enumerate(operands):
            self.facts.add("operand", expr, index, operand)
        return expr

    def text(self, node: ast.AST) -> str:
        """The source text of a node, folded and cut."""
        first, last = getattr(node, "lineno", 0), getattr(node, "end_lineno", 0)
        lines = self.module.lines[first - 1 : last]
        if not lines:
            return ""
        begin, end = getattr(node, "col_offset", 0), getattr(node, "end_col_offset", 0)
        written = lines[0][begin:end] if len(lines) == 1 else b"\n".join((lines[0][begin:], *lines[1:-1], lines[-1][:end]))
        text = _folded(written[: 2 * TEXT_LIMIT])  # of a long expression each part has a text: none is looked at as a whole
        text = text if len(text) > TEXT_LIMIT else _folded(written)
        return text if len(text) <= TEXT_LIMIT else text[: TEXT_LIMIT - 3] + "..."

    def written(self, expr: str, node: ast.AST) -> str:
        """Record how `expr` is written."""
        self.facts.add("expr_text", expr, self.text(node))
        return expr


_QUOTED = re.compile(r"'(?:\\.|[^'\\])*'|\"([^\"'\\]*)\"")


def _folded(written: bytes) -> str:
    """On one line, with one kind of quotes, so that equal texts are written alike: what joins lines in the source is left out."""
    joined = written.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ")
    text = " ".join(joined.decode("utf-8", "replace").split())
    return _QUOTED.sub(lambda quoted: quoted[0] if quoted[1] is None else f"'{quoted[1]}'", text)
