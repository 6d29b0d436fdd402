"""Definitions: properties and macros, and how a call finds its macro."""

from __future__ import annotations

import keyword
import re
from dataclasses import dataclass
from typing import Any

from rosarch.extractor.urdf.document import Element
from rosarch.extractor.urdf.expressions import Texts
from rosarch.extractor.urdf.model import PREFIX, Dialect, XacroError
from rosarch.extractor.urdf.symbols import Symbols, Table, truth

_MODERN = re.compile(r"""\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?(\$\{.*?\}|\$\(.*?\)|(?:'[^']*'|"[^"]*"|[^\s'"])+|)(?:\s+|$)(.*)""")
_OLD = re.compile(r"""\s*([^\s:=]+?):?=(\^\|?)?((?:'[^']*'|[^\s'"])*)(?:\s+|$)(.*)""")


@dataclass(frozen=True)
class Parameter:
    """A parameter. Its default is a text, with `forwards` the caller's property of the same name before that."""

    name: str
    forwards: bool = False
    default: str | None = None

    @property
    def is_block(self) -> bool:
        """Whether it takes an element of the call."""
        return self.name.startswith("*")


@dataclass(frozen=True, eq=False)
class Macro:
    """A macro; `body` is the element that defines it."""

    name: str
    parameters: tuple[Parameter, ...]
    body: Element


def parse_parameters(text: str, dialect: Dialect) -> tuple[Parameter, ...]:
    """The parameters that `params` of a macro lists."""
    found = []
    rest = text.strip()
    while rest:
        match = (_MODERN if dialect.prefixed else _OLD).match(rest)
        if match:
            name, forward, default, rest = match.groups()
            found.append(Parameter(name, bool(forward), default or None))
        else:
            name, _, rest = rest.partition(" ")
            found.append(Parameter(name))
        rest = rest.lstrip()
    return tuple(found)


def find(name: str, macros: Table, symbols: Symbols, dialect: Dialect) -> tuple[Macro, Table, Symbols] | None:
    """The macro that `name`, with the namespaces it is in, names, and the scopes its call is evaluated in."""
    *namespaces, last = name.split(".")
    for namespace in namespaces:
        inner, properties = macros.get(namespace), symbols.get(namespace)
        if not isinstance(inner, Table):
            return None
        macros = inner
        if dialect.prefixed and isinstance(properties, Symbols):
            symbols = properties
    found = macros.get(last)
    return (found, macros, symbols) if isinstance(found, Macro) else None


def define_macro(node: Element, macros: Table, dialect: Dialect) -> None:
    """Define the macro that `node` describes.

    Raises:
        XacroError: it has no name, or one that is reserved.
    """
    name = required(node, "name").removeprefix(PREFIX)
    if dialect.prefixed and (name == "call" or "." in name):
        raise XacroError(f"`{name}` cannot name a macro", name)
    macros.values[name] = Macro(name, parse_parameters(node.attributes.get("params", ""), dialect), node)


def define_property(node: Element, symbols: Symbols, texts: Texts) -> None:
    """Define the property that `node` describes.

    Raises:
        XacroError: it cannot be defined so.
    """
    name, attributes = required(node, "name"), node.attributes
    modern = texts.dialect.prefixed
    name = texts.text(name, symbols) if modern else name
    if not name.isidentifier() or keyword.iskeyword(name) or (modern and name.startswith("__")):
        raise XacroError(f"`{name}` cannot name a property", name)
    remove = modern and _flag(attributes.get("remove", "false"), symbols, texts)
    value: Any = attributes.get("value")
    default = attributes.get("default")
    if (value is not None) + (default is not None) + remove > 1:
        raise XacroError(f"property `{name}` must have only one of value, default and remove", name)
    if remove and name in symbols:
        symbols.remove(name)
        return
    if default is not None:
        if not texts.dialect.in_order:
            raise XacroError(f"property `{name}` has a default, which needs --inorder", name)
        if name in symbols:
            return
        value = default
    if value is None:
        name, value = f"**{name}", node
    lazy = not modern or _flag(attributes.get("lazy_eval", "true"), symbols, texts)
    _store(name, value, symbols, attributes.get("scope"), lazy, texts)


def _flag(text: str, symbols: Symbols, texts: Texts) -> bool:
    """An attribute that is true or false."""
    return truth(texts.value(text, symbols), text, texts.dialect)


def _store(name: str, value: Any, symbols: Symbols, scope: str | None, lazy: bool, texts: Texts) -> None:
    """Set a property in the scope that is asked for."""
    target: Symbols | None = symbols
    if scope == "global":
        top = symbols.top()
        target, lazy = (top if isinstance(top, Symbols) else symbols), False
    elif scope == "parent":
        target, lazy = symbols.parent, False
        while texts.dialect.prefixed and not symbols.is_namespace and target is not None and target.is_namespace:
            target = target.parent
    if target is None and texts.dialect.prefixed:
        raise XacroError(f"property `{name}` is for a scope that is not there", name)
    if target is None:
        return
    if not lazy and isinstance(value, str):
        value = texts.value(value, symbols)
    target.set(name, value, lazy)


def required(node: Element, name: str) -> str:
    """An attribute that must be there, as written.

    Raises:
        XacroError: it is not there.
    """
    if name not in node.attributes:
        raise XacroError(f"<{node.tag}> has no attribute `{name}`", name)
    return node.attributes[name]
