"""Property files: formulas and templates, with names from a composed system."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from lark import Lark, Token, Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedEOF, UnexpectedInput, UnexpectedToken

from rosarch.base.hints import hint
from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.behavior.composition.names import Names, UnknownNameError
from rosarch.behavior.composition.system import System
from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Formula


class PropertyError(Exception):
    """Something is wrong with a property file; a line `path:line:col: message` for each mistake."""


@dataclass(frozen=True)
class Property:
    """A property, the line that it begins in, and its text on one line."""

    name: str
    formula: Formula
    text: str
    line: int


@cache
def _parser() -> Lark:
    grammar = files("rosarch.behavior.verification").joinpath("properties.lark").read_text("utf-8")
    return Lark(grammar, parser="lalr", propagate_positions=True, maybe_placeholders=False)


def read_properties(text: str, path: str, system: System) -> list[Property]:
    """The properties in a text, about a system.

    Raises:
        PropertyError: the text does not say what it should, or asks for what the system does not have.
    """
    try:
        whole = _parser().parse(text)
    except UnexpectedInput as error:
        raise PropertyError(f"{path}:{_at(error, text)}: {_reason(error, text)}") from None
    reader = _Reader(path, Names(system))
    found: dict[str, Property] = {}
    for item in whole.children:
        tree = _tree(item)
        name = str(tree.children[0])
        formula = reader.formula(tree.children[1])
        source = " ".join(text[tree.meta.start_pos : tree.meta.end_pos].partition(":")[2].split())
        if name in found:
            reader.problem(tree.children[0], f"there is a property `{name}` already, in line {found[name].line}")
        found[name] = Property(name, formula, source, tree.meta.line)
    if reader.problems:
        raise PropertyError("\n".join(reader.problems))
    if not found:
        raise PropertyError(f"{path}:1:1: no property; one is written as `name: always (node.variable == VALUE)`")
    return list(found.values())


def _tree(item: object) -> Tree[Token]:
    if not isinstance(item, Tree):
        raise TypeError(item)
    return item


def _at(error: UnexpectedInput, text: str) -> str:
    if isinstance(error, UnexpectedEOF) or (isinstance(error, UnexpectedToken) and error.token.type == "$END"):
        lines = text.rstrip().split("\n")
        return f"{len(lines)}:{len(lines[-1]) + 1}"
    return f"{error.line}:{error.column}"


def _reason(error: UnexpectedInput, text: str) -> str:
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        return f"`{error.token}` does not fit here"
    if isinstance(error, UnexpectedCharacters):
        return f"`{text[error.pos_in_stream or 0]}` does not fit here"
    return "the formula ends too early"


def _absence(p: Formula) -> Formula:
    return ltl.always(Not(p))


def _response(p: Formula, q: Formula) -> Formula:
    return ltl.always(ltl.implication(p, ltl.eventually(q)))


def _precedence(p: Formula, q: Formula) -> Formula:
    return ltl.weak_until(Not(q), p)


def _left(p: Formula) -> Formula:
    return _response(p, Not(p))


TEMPLATES: Mapping[str, Callable[..., Formula]] = {
    "universality": ltl.always,
    "absence": _absence,
    "existence": ltl.eventually,
    "response": _response,
    "precedence": _precedence,
    "left": _left,
}
"""Formulas by name: `response(p, q)`, q follows p; `precedence(p, q)`, no q before a p; `left(p)`, p does not last."""

_ARGUMENTS = {"response": 2, "precedence": 2}
_EVENTS = {"sent": (1, 2), "received": (2, 2), "dropped": (2, 2), "ignored": (2, 2), "used": (2, 2)}


class _Reader:
    """Turns trees into formulas and keeps what is wrong."""

    def __init__(self, path: str, names: Names) -> None:
        self.path = path
        self.names = names
        self.problems: list[str] = []

    def problem(self, at: object, message: str) -> None:
        """Something is wrong with a part of the text."""
        place = at.meta if isinstance(at, Tree) else at
        self.problems.append(f"{self.path}:{getattr(place, 'line', 1)}:{getattr(place, 'column', 1)}: {message}")

    def formula(self, item: object) -> Formula:
        """The formula of a tree; true where something is wrong."""
        tree = _tree(item)
        children = tree.children
        if tree.data == "truth":
            return TRUE if str(children[0]) == "true" else FALSE
        if tree.data == "negated":
            return Not(self.formula(children[1]))
        if tree.data == "temporal":
            make = {"always": ltl.always, "G": ltl.always, "eventually": ltl.eventually, "F": ltl.eventually}.get(
                str(children[0]), ltl.Next
            )
            return make(self.formula(children[1]))
        if tree.data in ("implied", "bound"):
            return self._binary(str(children[1]), self.formula(children[0]), self.formula(children[2]))
        if tree.data in ("either", "both"):
            found = self.formula(children[0])
            for part in children[2::2]:
                found = (Any if tree.data == "either" else All)((found, self.formula(part)))
            return found
        return self._state(tree) if tree.data == "state" else self._call(tree)

    def _binary(self, operator: str, left: Formula, right: Formula) -> Formula:
        if operator in ("<->", "<=>", "iff"):
            return All((ltl.implication(left, right), ltl.implication(right, left)))
        if operator in ("until", "U"):
            return ltl.Until(left, right)
        if operator in ("unless", "W"):
            return ltl.weak_until(left, right)
        return ltl.Release(left, right) if operator in ("releases", "R") else ltl.implication(left, right)

    def _state(self, tree: Tree[Token]) -> Formula:
        variable, value = tree.children[0], tree.children[2] if len(tree.children) > 1 else None
        try:
            atom = ltl.InState(*self.names.state(str(variable), None if value is None else str(value)))
        except UnknownNameError as error:
            self.problem(value if error.of_value else variable, str(error))
            return TRUE
        return Not(atom) if value is not None and str(tree.children[1]) == "!=" else atom

    def _call(self, tree: Tree[Token]) -> Formula:
        name, arguments = str(tree.children[0]), [_tree(child).children[0] for child in tree.children[1:]]
        if name in TEMPLATES:
            if len(arguments) != (wanted := _ARGUMENTS.get(name, 1)) or any(isinstance(a, Token) for a in arguments):
                self.problem(tree, f"`{name}` takes {'two formulas' if wanted == 2 else 'a formula'}")
                return TRUE
            return TEMPLATES[name](*(self.formula(argument) for argument in arguments))
        if name not in _EVENTS:
            self.problem(tree, f"there is no `{name}(...)`{hint(name, [*TEMPLATES, *_EVENTS])}")
            return TRUE
        least, most = _EVENTS[name]
        tokens = [argument for argument in arguments if isinstance(argument, Token)]
        if not least <= len(arguments) <= most or len(tokens) < len(arguments):
            self.problem(tree, f"`{name}` takes {'a topic, or a node and a topic' if least == 1 else 'a node and a topic'}")
            return TRUE
        return self._event(name, tokens)

    def _event(self, name: str, arguments: list[Token]) -> Formula:
        try:
            if name == "used":  # a template about two events
                dropped, ignored = (ltl.Happens(self.names.event(kind, *map(str, arguments))) for kind in ("dropped", "ignored"))
                return Not(Any((dropped, ignored)))
            return ltl.Happens(self.names.event(name, *map(str, arguments)))
        except UnknownNameError as error:
            self.problem(arguments[min(error.argument, len(arguments) - 1)], str(error))
            return TRUE
