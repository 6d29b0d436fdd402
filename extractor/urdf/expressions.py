"""`${...}` and `$(...)` in the texts of xacro files.

An expression is Python, evaluated by the walker of `$(eval ...)`, which runs nothing; here it also sees properties, the namespaces of
included files, and the functions that xacro offers.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import yaml

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch.eval_functions import BUILTINS, MATH, TooLarge
from rosarch.extractor.launch.evaluation import EvalFailed, Evaluator, UnknownInvolved, Unsupported, is_known_value, no_name
from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.yaml_values import Loader, YamlError, load_yaml
from rosarch.extractor.urdf.context import Context
from rosarch.extractor.urdf.model import Dialect, XacroError
from rosarch.extractor.urdf.symbols import Symbols

MAX_TEXT = 1024 * 1024  # characters of one evaluated text
STEP = 16  # work of one step of an expression, in characters

_MODERN = re.compile(r"(?P<escape>\$\$+[{(])|(?P<expression>\$\{[^}]*\})|(?P<extension>\$\([^)]*\))|(?P<text>[^$]+|\$[^{($]+|\$\Z)")
_OLD = re.compile(r"(?P<escape>\$\$+\{)|(?P<expression>\$\{[^}]*\})|(?P<extension>\$\([^)]*\))|(?P<text>(?:[^$]|\$[^{(]|\$\Z)+)")


@lru_cache(maxsize=4096)
def tokens(text: str, dialect: Dialect) -> tuple[tuple[str, str], ...]:
    """The parts of a text, each with its kind.

    Raises:
        XacroError: a parenthesis or brace is not closed.
    """
    found, position, pattern = [], 0, _MODERN if dialect.prefixed else _OLD
    while position < len(text):
        match = pattern.match(text, position)
        if match is None and dialect.prefixed:
            raise XacroError(f"`{shortened(text[position:])}` is not closed")
        if match is None:
            break  # the rest is dropped without a word
        found.append((str(match.lastgroup), match[0]))
        position = match.end()
    return tuple(found)


class Texts:
    """Evaluates texts."""

    def __init__(self, context: Context, dialect: Dialect) -> None:
        self.context, self.dialect = context, dialect
        self.namespaces = _namespaces(self)
        plain = ("list", "dict", "map", "len", "str", "float", "int", "min", "max", "round", "sorted", "range")
        self.globals: dict[str, Any] = {**{name: BUILTINS[name] for name in plain}, **_MATH, **self.namespaces}
        self.globals.update((name, self.namespaces["xacro"][name]) for name in ("load_yaml", "abs_filename", "dotify"))

    def value(self, text: str, symbols: Symbols) -> Any:
        """The value of a text: that of its one expression, or else a text.

        Raises:
            XacroError: it is malformed, or an expression fails.
        """
        if "$" not in text:
            self.context.spend(len(text))
            return text
        values = [self._token(kind, token, symbols) for kind, token in tokens(text, self.dialect)]
        value = values[0] if len(values) == 1 else "".join(map(str, values))
        if isinstance(value, str):
            self.context.spend(len(value))
            if len(value) > MAX_TEXT:
                raise XacroError(f"a text of more than {MAX_TEXT // 2**20} Mi characters")
        return value

    def text(self, text: str, symbols: Symbols) -> str:
        """The value of a text, as text.

        Raises:
            XacroError: it is malformed, or an expression fails.
        """
        return str(self.value(text, symbols))

    def _token(self, kind: str, token: str, symbols: Symbols) -> Any:
        if kind == "expression":
            return self._expression(self.text(token[2:-1], symbols).strip(), symbols)
        if kind == "extension":
            return self.context.evaluate_extension(self.text(token[2:-1], symbols))
        return token[1:] if kind == "escape" else token

    def _expression(self, expression: str, symbols: Symbols) -> Any:
        evaluator = _Expressions(self, symbols)
        unknown = f"${{{self.context.unknowns.render(expression)}}}"
        try:
            value = evaluator.evaluate(expression)
            if isinstance(value, str) or is_known_value(value):
                return value
        except EvalFailed as error:
            raise XacroError(f"${{{shortened(expression)}}}: {error}", expression) from None
        except Unsupported as error:
            self.context.report(LaunchError("eval-unsupported", expression, f"${{{shortened(expression)}}} stays unknown: {error}"), False)
        except UnknownInvolved:
            pass
        finally:
            self.context.spend(STEP * evaluator.steps)
        return self.context.unknowns.mark(unknown)

    def load_yaml(self, path: str) -> Any:
        """The value of a YAML file."""
        path = self.context.beside(path)
        try:
            text = self.context.files.read_text(path)
            self.context.read.setdefault(path)
            self.context.spend(STEP * len(text))
            return load_yaml(text, _YamlLoader)
        except LaunchError as error:
            if error.kind != "made":
                raise XacroError(error.message, error.subject) from None
            self.context.report(error, fatal=False)
            raise UnknownInvolved from None
        except YamlError as error:
            raise XacroError(f"invalid YAML at {path}:{error.line}:{error.column}: {error.message}", path) from None


class _Expressions(Evaluator):
    """Evaluates expressions that see the properties of a scope."""

    def __init__(self, texts: Texts, symbols: Symbols) -> None:
        super().__init__(lambda name: symbols.value(name, texts.value), {})
        self.texts = texts

    def named(self, name: str) -> Any:
        try:
            return self.lookup(name)
        except KeyError:
            pass
        if name in self.texts.globals:
            return self.texts.globals[name]
        if self.texts.context.incomplete:
            return self.texts.context.unknowns.mark(f"${{{name}}}")
        raise EvalFailed(f"name '{name}' is not defined")

    def attribute(self, value: Any, name: str) -> Any:
        if name.startswith("__"):
            raise EvalFailed(f"`{name}` must not be used")
        found = self._member(value, name)
        return super().attribute(value, name) if found is None else found

    def method(self, value: Any, name: str) -> Any:
        found = None if isinstance(value, dict) and not isinstance(value, _Functions) else self._member(value, name)
        return super().method(value, name) if found is None else found

    def _member(self, value: Any, name: str) -> Any:
        """A property of an included file's namespace, a function of a module, or an entry of a YAML map."""
        if isinstance(value, Symbols):
            if not value.is_namespace or name not in value:
                raise EvalFailed(f"name '{name}' is not defined")
            return value.value(name, self.texts.value)
        if isinstance(value, dict):
            if name not in value:
                raise EvalFailed(f"there is no entry '{name}'")
            return list(value[name]) if isinstance(value[name], list) else value[name]  # a new list each time that it is asked for
        return None


class _Functions(dict[str, Any]):
    """A module that expressions see."""


_MATH = {name: value for name, value in MATH.items() if hasattr(math, name)}


def _namespaces(texts: Texts) -> dict[str, _Functions]:
    """The modules that expressions see."""

    def fatal(*words: Any) -> Any:
        raise XacroError(" ".join(map(str, words)))

    def silent(*_words: Any, **_named: Any) -> str:
        return ""

    own: dict[str, Callable[..., Any]] = {
        "load_yaml": texts.load_yaml,
        "abs_filename": texts.context.beside,
        "dotify": dict,
        "arg": lambda name: texts.context.evaluate_extension(f"arg {name}"),
        "tokenize": _tokenize,
        "fatal": fatal,
        **dict.fromkeys(("message", "warning", "error", "print_location"), silent),
    }
    return {"math": _Functions(_MATH), "python": _Functions(BUILTINS), "xacro": _Functions(own)}


def _tokenize(text: str, sep: str = ",; ", skip_empty: bool = True) -> list[str]:
    """The parts of a text between separators."""
    if not re.fullmatch(r"[^\\\]^\[-]*", sep) or not sep:
        raise TooLarge(f"the separators `{sep}` are not evaluated")
    return [part for part in re.split(f"[{sep}]", text) if part or not skip_empty]


class _YamlLoader(Loader):
    """YAML with units of length and angle."""


def _scaled(factor: float) -> Callable[[_YamlLoader, yaml.Node], float]:
    def construct(loader: _YamlLoader, node: yaml.Node) -> float:
        text = str(loader.construct_scalar(node))  # type: ignore[arg-type]
        try:
            return float(Evaluator(no_name, _MATH).evaluate(text.strip())) * factor
        except (EvalFailed, Unsupported, TypeError, ValueError):
            raise yaml.constructor.ConstructorError(None, None, f"invalid expression: {text}", node.start_mark) from None

    return construct


_UNITS = {"radians": 1.0, "degrees": math.pi / 180.0, "meters": 1.0, "millimeters": 0.001, "foot": 0.3048, "inches": 0.0254}
for _unit, _factor in _UNITS.items():
    _YamlLoader.add_constructor(f"!{_unit}", _scaled(_factor))
