"""Read `.cfg` files of dynamic_reconfigure without running them.

Source: https://wiki.ros.org/dynamic_reconfigure/Tutorials/HowToWriteYourFirstCfgFile. A `.cfg` file is a Python program; calls of `add`,
`const` and `generate` with constant arguments are read from its syntax tree, also in functions of Python modules of the workspace that get
the generator as an argument. A file that is not Python 3 is read with a regular expression.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.files import read_file
from rosarch.extractor.messages.model import Config, ConfigConstant, ConfigParameter
from rosarch.extractor.python_syntax import parse_python
from rosarch.extractor.workspace.model import Package

MAX_CALLS = 10
MAX_WORK = 200_000  # statements, expressions and characters of values: a program may have loops within loops
MAX_SIZE = 10_000  # characters of a value
TYPES = {"int_t": "int", "double_t": "double", "str_t": "string", "bool_t": "bool"}
_ADD_NAMES = ("name", "paramtype", "level", "description", "default", "min", "max", "edit_method")
_CONST_NAMES = ("name", "type", "value", "descr")


def parse_config(text: str, package: Package, path: Path, packages: Iterable[Package], problems: list[Diagnostic]) -> Config | None:
    """The configuration a `.cfg` file generates; None, with a diagnostic, when it names none."""
    try:
        tree = parse_python(text)
    except SyntaxError as error:
        problems.append(Diagnostic("config-syntax", path, error.lineno or 1, 1, "not Python 3, read by pattern"))
        return _by_pattern(text, package.name, path, problems)
    reader = _Reader(list(packages))
    try:
        reader.statements(tree.body)
    except (_TooMuch, RecursionError):
        problems.append(Diagnostic("config-limit", path, 1, 1, "too much to evaluate, the rest is left out"))
    if reader.generated is None:
        problems.append(Diagnostic("config", path, 1, 1, "no call of generate with a constant name"))
        return None
    return Config(f"{package.name}/{reader.generated}", path, tuple(reader.parameters.values()), tuple(reader.constants.values()))


class _TooMuch(Exception):
    """The program does more than a `.cfg` file needs."""


class _Reader:
    """The calls a `.cfg` program makes, in order."""

    def __init__(self, packages: list[Package]) -> None:
        self.packages = packages
        self.names: dict[str, object] = {}
        self.functions: dict[str, ast.FunctionDef] = {}
        self.parameters: dict[str, ConfigParameter] = {}
        self.constants: dict[str, ConfigConstant] = {}
        self.generated: str | None = None
        self.depth = 0
        self.work = 0

    def spend(self, work: int) -> None:
        self.work += work
        if self.work > MAX_WORK:
            raise _TooMuch

    def statements(self, body: Iterable[ast.stmt]) -> None:
        for statement in body:
            self.spend(1)
            if isinstance(statement, ast.FunctionDef):
                self.functions[statement.name] = statement
            elif isinstance(statement, ast.ImportFrom) and statement.module:
                self.imported(statement.module)
            elif isinstance(statement, ast.For):
                self.loop(statement)
            elif isinstance(statement, (ast.If, ast.While, ast.With, ast.Try)):
                self.statements([node for node in ast.iter_child_nodes(statement) if isinstance(node, ast.stmt)])
            else:
                self.simple(statement)

    def simple(self, statement: ast.stmt) -> None:
        for node in _calls(statement):
            self.call(node)
        if isinstance(statement, ast.Assign) and len(statement.targets) == 1 and isinstance(statement.targets[0], ast.Name):
            value = self.value(statement.value)
            if value is not None:
                self.names[statement.targets[0].id] = value

    def loop(self, statement: ast.For) -> None:
        """A loop over a constant list or range; others are left out."""
        values = self.value(statement.iter)
        if isinstance(values, (list, tuple, range)) and isinstance(statement.target, ast.Name):
            for value in list(values)[:1000]:
                self.names[statement.target.id] = value
                self.statements(statement.body)

    def imported(self, module: str) -> None:
        """Functions of a Python module below some package's `src`."""
        relative = module.replace(".", "/")
        for package in self.packages:
            for path in (package.path / "src" / relative / "__init__.py", package.path / "src" / f"{relative}.py"):
                if os.path.isfile(path):
                    try:
                        tree = parse_python(read_file(path).decode(errors="replace"))
                    except (SyntaxError, OSError):
                        return
                    self.functions.update({node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)})
                    return

    def call(self, node: ast.Call) -> None:
        if isinstance(node.func, ast.Name) and node.func.id in self.functions and self.depth < MAX_CALLS:
            self.depth += 1
            self.statements(self.functions[node.func.id].body)
            self.depth -= 1
        elif isinstance(node.func, ast.Attribute):
            handler = {"add": self.add, "const": self.const, "generate": self.generate}.get(node.func.attr)
            if handler is not None:
                handler(node)

    def add(self, node: ast.Call) -> None:
        given = self.arguments(node, _ADD_NAMES)
        kind = given.get("paramtype")
        name = self.text(given.get("name"))
        if name is None or not isinstance(kind, ast.Name) or kind.id not in TYPES:
            return
        self.parameters[name] = ConfigParameter(
            name,
            TYPES[kind.id],
            self.shown(given.get("default")),
            self.shown(given.get("min")),
            self.shown(given.get("max")),
            self.text(given.get("description")) or "",
            node.lineno,
        )

    def const(self, node: ast.Call) -> None:
        given = self.arguments(node, _CONST_NAMES)
        name, kind, value = self.text(given.get("name")), given.get("type"), self.shown(given.get("value"))
        if name and value is not None and isinstance(kind, ast.Name) and kind.id in TYPES:
            self.constants[name] = ConfigConstant(name, TYPES[kind.id], value)

    def generate(self, node: ast.Call) -> None:
        if len(node.args) >= 3:
            self.generated = self.text(node.args[2]) or self.generated

    @staticmethod
    def arguments(node: ast.Call, names: tuple[str, ...]) -> dict[str, ast.expr]:
        """Arguments by parameter name."""
        given = dict(zip(names, node.args, strict=False))
        given.update({keyword.arg: keyword.value for keyword in node.keywords if keyword.arg})
        return given

    def text(self, node: ast.expr | None) -> str | None:
        value = self.value(node) if node is not None else None
        return value if isinstance(value, str) else None

    def shown(self, node: ast.expr | None) -> str | None:
        value = self.value(node) if node is not None else None
        try:
            return None if value is None else value if isinstance(value, str) else repr(value)
        except ValueError:  # a number of more digits than Python writes
            return None

    def value(self, node: ast.expr) -> object | None:
        """The value of a constant expression, unless it is large."""
        self.spend(1)
        value = self.evaluated(node)
        if isinstance(value, int) and value.bit_length() > MAX_SIZE:
            return None
        if isinstance(value, (str, bytes, list, tuple, set, dict)):
            self.spend(len(value) // 16)
            return value if len(value) <= MAX_SIZE else None
        return value

    def evaluated(self, node: ast.expr) -> object | None:
        """The value of a constant expression."""
        if isinstance(node, ast.Name):
            return self.names.get(node.id)
        if isinstance(node, ast.BinOp):
            left, right = self.value(node.left), self.value(node.right)
            if isinstance(node.op, ast.Add) and isinstance(left, str) and isinstance(right, str):
                return left + right
            if isinstance(left, (int, float)) and isinstance(right, (int, float)):
                return _arithmetic(node.op, left, right)
            if isinstance(node.op, ast.Mod) and isinstance(left, str) and right is not None:
                return _formatted(left, right)
            return None
        if isinstance(node, ast.Attribute) and node.attr == "pi":
            return 3.141592653589793
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "range":
            numbers = [value for argument in node.args if isinstance(value := self.value(argument), int)]
            return range(*numbers) if 1 <= len(numbers) <= 3 and numbers[2:] != [0] else None
        try:
            constant: object = ast.literal_eval(node)
            return constant
        except (ValueError, TypeError, SyntaxError, MemoryError):
            return None


def _calls(statement: ast.stmt) -> Iterator[ast.Call]:
    """Calls in evaluation order, as far as `.cfg` files care."""
    return (node for node in ast.walk(statement) if isinstance(node, ast.Call))


def _arithmetic(operator: ast.operator, left: float, right: float) -> float | None:
    try:
        if isinstance(operator, ast.Add):
            return left + right
        if isinstance(operator, ast.Sub):
            return left - right
        if isinstance(operator, ast.Mult):
            return left * right
        return left / right if isinstance(operator, ast.Div) else None
    except (ZeroDivisionError, OverflowError):
        return None


_WIDE = re.compile(r"\d{4,}|\*")


def _formatted(template: str, values: object) -> str | None:
    if _WIDE.search(template):
        return None  # a width that takes all memory
    try:
        return str(template % values)
    except (TypeError, ValueError):
        return None


_ADD = re.compile(
    r"""\.add\s*\(\s*(["'])(?P<name>\w+)\1\s*,\s*(?P<type>int_t|double_t|str_t|bool_t)\s*,\s*[^,]*,\s*(["'])(?:\\.|(?!\4).)*\4"""
    r"""(?:\s*,\s*(?P<default>[^,)]+))?(?:\s*,\s*(?P<min>[^,)]+))?(?:\s*,\s*(?P<max>[^,)]+))?""",
    re.DOTALL,
)
_GENERATE = re.compile(r"""\.generate\s*\([^,]+,[^,]+,\s*["'](\w+)["']\s*\)""")


def _by_pattern(text: str, package: str, path: Path, problems: list[Diagnostic]) -> Config | None:
    text = re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)
    generated = _GENERATE.search(text)
    if not generated:
        problems.append(Diagnostic("config", path, 1, 1, "no call of generate with a constant name"))
        return None
    parameters = {}
    for match in _ADD.finditer(text):
        default, low, high = (match[key] and match[key].strip().strip("\"'") for key in ("default", "min", "max"))
        line = text.count("\n", 0, match.start()) + 1
        parameters[match["name"]] = ConfigParameter(match["name"], TYPES[match["type"]], default, low, high, line=line)
    return Config(f"{package}/{generated.group(1)}", path, tuple(parameters.values()))
