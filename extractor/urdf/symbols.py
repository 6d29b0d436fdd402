"""The properties and macros that are known at a place of a document, and how xacro takes texts for values."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable
from typing import Any

from rosarch.extractor.launch.unknowns import cleaned
from rosarch.extractor.urdf.model import Dialect, XacroError


class Table:
    """Names of one scope within those of the scope around it."""

    def __init__(self, parent: Table | None = None, is_namespace: bool = False) -> None:
        self.parent, self.is_namespace = parent, is_namespace
        self.values: dict[str, Any] = {}

    def owner(self, name: str) -> Table | None:
        """The innermost scope that has `name`."""
        table: Table | None = self
        while table is not None and name not in table.values:
            table = table.parent
        return table

    def __contains__(self, name: str) -> bool:
        return self.owner(name) is not None

    def get(self, name: str) -> Any:
        """What `name` stands for, unevaluated; None when it is not defined."""
        owner = self.owner(name)
        return None if owner is None else owner.values[name]

    def top(self) -> Table:
        """The outermost scope."""
        table = self
        while table.parent is not None:
            table = table.parent
        return table


class Symbols(Table):
    """The properties of a scope. The text of a property is evaluated when it is first asked for, in the scope that has it."""

    parent: Symbols | None

    def __init__(self, dialect: Dialect, parent: Symbols | None = None, is_namespace: bool = False) -> None:
        super().__init__(parent, is_namespace)
        self.dialect = dialect
        self.lazy: set[str] = set()
        self.resolving: list[str] = []

    def scope(self, is_namespace: bool = False) -> Symbols:
        """A scope within this one."""
        return Symbols(self.dialect, self, is_namespace)

    def set(self, name: str, value: Any, lazy: bool) -> None:
        """Define a property."""
        value = literal(value, self.dialect)
        self.values[name] = value
        if lazy and isinstance(value, str):
            self.lazy.add(name)
        else:
            self.lazy.discard(name)

    def remove(self, name: str) -> None:
        """Forget a property, here and in all scopes around."""
        table: Symbols | None = self
        while table is not None:
            table.values.pop(name, None)
            table.lazy.discard(name)
            table = table.parent

    def value(self, name: str, evaluate: Callable[[str, Symbols], Any]) -> Any:
        """The value of a property.

        Raises:
            KeyError: there is none.
            XacroError: it is defined by itself.
        """
        owner = self.owner(name)
        if not isinstance(owner, Symbols):
            raise KeyError(name)
        if name in owner.lazy:
            if name in owner.resolving:
                raise XacroError(f"property `{name}` is defined by itself: {' -> '.join([*owner.resolving, name])}")
            owner.resolving.append(name)
            try:
                owner.values[name] = literal(evaluate(owner.values[name], owner), self.dialect)
            finally:
                owner.resolving.pop()
            owner.lazy.discard(name)
        return owner.values[name]


def literal(value: Any, dialect: Dialect) -> Any:
    """A text as the number, Boolean or quoted text that it looks like; other values as they are."""
    if not isinstance(value, str):
        return value
    return _modern_literal(value) if dialect.prefixed else _python_literal(value)


def _modern_literal(text: str) -> Any:
    if len(text) >= 2 and text[0] == text[-1] == "'":
        return text[1:-1]
    if "_" in text:
        return text
    for convert in (int, float, boolean):
        try:
            return convert(text)
        except ValueError:
            pass
    return text


def _python_literal(text: str) -> Any:
    try:
        value = _evaluated(text.strip())
    except ValueError:
        return text
    return text if isinstance(value, (list, dict, tuple)) else value


def _evaluated(text: str) -> Any:
    """The value of a Python literal; ValueError for what is none."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            value = ast.literal_eval(text)
    except (SyntaxError, TypeError, RecursionError, MemoryError) as error:
        raise ValueError(str(error)) from None
    return cleaned(value) if isinstance(value, str) else value


def boolean(text: str) -> bool:
    """`true`, `false` or a whole number as a Boolean.

    Raises:
        ValueError: it is none of them.
    """
    if text in ("true", "True"):
        return True
    if text in ("false", "False"):
        return False
    return bool(int(text))


def truth(value: Any, condition: str, dialect: Dialect) -> bool:
    """What a condition comes to.

    Raises:
        XacroError: it is a text that is no Boolean.
    """
    if not isinstance(value, str):
        return bool(value)
    try:
        if dialect.prefixed or value in ("true", "false"):
            return boolean(value)
        return bool(_evaluated(value))
    except ValueError:
        raise XacroError(f"condition `{condition}` is `{value}`, which is not a Boolean") from None
