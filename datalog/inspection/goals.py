"""Goals: one row, or the pattern of some, as a user writes it: `rel(a, "b c", 3, [x, nil], $Branch(1), _)`.

A word without quotes is a symbol, up to the next comma or closing bracket, so that rows can be pasted as they are
printed; `_` stands for any value.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rosarch.datalog.engine.expressions import number_value
from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location, did_you_mean
from rosarch.datalog.language.show import show_term
from rosarch.datalog.language.syntax import Relation
from rosarch.datalog.language.tree import ESCAPES
from rosarch.datalog.language.types import Types

GOAL = "<goal>"
_WORD = re.compile(r"\s*([\w?.]+)\s*\(")
_QUOTED = re.compile(r'"((?:\\.|[^"\\])*)"', re.DOTALL)
_BRANCH = re.compile(r"\$([\w?.]+)\s*")
_KINDS = {"i": "number", "u": "unsigned number", "f": "float"}


class _Any:
    def __repr__(self) -> str:
        return "_"


ANY: Any = _Any()


@dataclass(frozen=True)
class Goal:
    """A relation and a pattern per column: a value, `ANY`, or a tuple of patterns."""

    relation: str
    args: tuple[Any, ...]

    @property
    def ground(self) -> bool:
        """Whether the goal is one row."""
        return is_ground(self.args)

    def matches(self, row: Sequence[Any]) -> bool:
        """Whether a row fits."""
        return all(fits(pattern, value) for pattern, value in zip(self.args, row, strict=True))


def is_ground(pattern: Any) -> bool:
    """Whether a pattern is a value."""
    return pattern is not ANY and not (isinstance(pattern, tuple) and not all(map(is_ground, pattern)))


def fits(pattern: Any, value: Any) -> bool:
    """Whether a value is one of those a pattern stands for."""
    if pattern is ANY:
        return True
    if isinstance(pattern, tuple) and isinstance(value, tuple):
        return len(pattern) == len(value) and all(map(fits, pattern, value))
    return bool(pattern == value)


def show_goal(goal: Goal, type_names: Sequence[str], types: Types) -> str:
    """A goal as text."""
    return f"{goal.relation}({', '.join(show_pattern(p, t, types) for p, t in zip(goal.args, type_names, strict=True))})"


def show_pattern(pattern: Any, type_name: str, types: Types) -> str:
    """A pattern as text."""
    if pattern is ANY:
        return "_"
    if not isinstance(pattern, tuple) or is_ground(pattern):
        return show_term(pattern, type_name, types)
    found = types.root(type_name)
    if found.kind == "+":
        fields = dict(found.branches)[pattern[0]]
        return f"${pattern[0]}({', '.join(show_pattern(p, t, types) for p, t in zip(pattern[1:], fields, strict=True))})"
    return f"[{', '.join(show_pattern(p, t, types) for p, t in zip(pattern, found.fields, strict=True))}]"


def parse_goal(text: str, relations: Mapping[str, Relation], types: Types) -> Goal:
    """The goal that a text shows; DatalogError with its place where it does not fit the declarations."""
    return _Parser(text, relations, types).goal()


class _Parser:
    def __init__(self, text: str, relations: Mapping[str, Relation], types: Types) -> None:
        self.text = text
        self.relations = relations
        self.types = types
        self.position = 0

    def fail(self, message: str, position: int | None = None, hint: str = "") -> DatalogError:
        at = self.position if position is None else position
        line = self.text.count("\n", 0, at) + 1
        column = at - (self.text.rfind("\n", 0, at) + 1) + 1
        return DatalogError([Diagnostic(message, Location(GOAL, line, column), hint, self.text.split("\n")[line - 1])])

    def skip(self) -> None:
        while self.text[self.position : self.position + 1].isspace():
            self.position += 1

    def at(self, token: str) -> bool:
        self.skip()
        return self.text.startswith(token, self.position)

    def expect(self, token: str) -> None:
        if not self.at(token):
            found = self.text[self.position : self.position + 1]
            raise self.fail(f"expected `{token}`, found {f'`{found}`' if found else 'the end'}")
        self.position += len(token)

    def goal(self) -> Goal:
        head = _WORD.match(self.text)
        if head is None:
            raise self.fail("expected a goal of the form `relation(value, ...)`", 0)
        name = head[1]
        relation = self.relations.get(name)
        if relation is None:
            raise self.fail(f"unknown relation `{name}`", head.start(1), did_you_mean(name, self.relations))
        self.position = head.end()
        type_names = tuple(a.type for a in relation.attributes)
        declared = f"{name}({', '.join(f'{a.name}: {a.type}' for a in relation.attributes)})"
        args = self.list(")", type_names, f"`{name}`", f"declared `{declared}`", head.start(1))
        self.skip()
        if self.text.startswith(".", self.position):
            self.position += 1
        self.skip()
        if self.position != len(self.text):
            raise self.fail(f"unexpected `{self.text[self.position]}` after the goal")
        return Goal(name, args)

    def list(self, end: str, type_names: Sequence[str], owner: str, hint: str, start: int) -> tuple[Any, ...]:
        """The patterns up to a closing bracket, which is passed."""
        found: list[Any] = []
        while not self.at(end):
            if found:
                self.expect(",")
            if len(found) == len(type_names):
                raise self.arity(owner, len(type_names), "more", hint, start)
            found.append(self.pattern(type_names[len(found)]))
        self.position += 1
        if len(found) < len(type_names):
            raise self.arity(owner, len(type_names), str(len(found)), hint, start)
        return tuple(found)

    def arity(self, owner: str, expected: int, given: str, hint: str, start: int) -> DatalogError:
        what = "attribute" if owner[0] == "`" and owner[1] != "$" else "field"
        return self.fail(f"{owner} has {expected} {what}{'s' * (expected != 1)}, given {given}", start, hint)

    def pattern(self, type_name: str) -> Any:
        self.skip()
        start = self.position
        if self.position >= len(self.text):
            raise self.fail("expected a value, found the end")
        if re.match(r"_(?=\s*[,)\]]|\s*$)", self.text[start:]):
            self.position += 1
            return ANY
        found = self.types.root(type_name)
        if found.kind == "r":
            return self.record(type_name, found.fields)
        if found.kind == "+":
            return self.branch(type_name, dict(found.branches))
        quoted = _QUOTED.match(self.text, start)
        if quoted:
            self.position = quoted.end()
            value = re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], m[1]), quoted[1], flags=re.DOTALL)
            if found.kind != "s":
                raise self.fail(f"`{quoted[0]}` is not a {_KINDS[found.kind]}", start, f"the column is of type `{type_name}`")
            return value
        return self.word(type_name, found.kind)

    def word(self, type_name: str, kind: str) -> Any:
        start, depth = self.position, 0
        while self.position < len(self.text):
            char = self.text[self.position]
            if char in "([":
                depth += 1
            elif char in ")]":
                if not depth:
                    break
                depth -= 1
            elif char == "," and not depth:
                break
            self.position += 1
        cell = self.text[start : self.position].strip()
        if kind == "s":
            return cell
        try:
            return number_value(cell.removesuffix("u") if kind == "u" else cell, kind)
        except ValueError:
            raise self.fail(f"`{cell}` is not a {_KINDS[kind]}", start, f"the column is of type `{type_name}`") from None

    def record(self, type_name: str, fields: Sequence[str]) -> Any:
        if re.match(r"nil(?=\s*[,)\]]|\s*$)", self.text[self.position :]):
            self.position += 3
            return None
        start = self.position
        if not self.at("["):
            raise self.fail(f"expected a record of type `{type_name}`", start, f"write `[{', '.join('_' * len(fields))}]`")
        self.position += 1
        return self.list("]", fields, f"record `{type_name}`", "", start)

    def branch(self, type_name: str, branches: Mapping[str, Sequence[str]]) -> Any:
        start = self.position
        match = _BRANCH.match(self.text, start)
        if match is None or match[1] not in branches:
            given = match[1] if match else ""
            hint = did_you_mean(given, branches) or f"one of {', '.join(f'`${b}`' for b in branches)}"
            raise self.fail(f"expected a branch of `{type_name}`", start, hint)
        self.position = match.end()
        fields = branches[match[1]]
        if not self.text.startswith("(", self.position):
            if fields:
                raise self.arity(f"`${match[1]}`", len(fields), "0", "", start)
            return (match[1],)
        self.position += 1
        return (match[1], *self.list(")", fields, f"`${match[1]}`", "", start))
