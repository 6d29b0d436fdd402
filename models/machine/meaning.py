"""The meaning of conditions and assigned values: the source's text as formulas over the cells and inputs of a node."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from rosarch.base.logic import FALSE, TRUE, All, Any, Not, conjuncts
from rosarch.models.machine.cells import EMPTIES, EMPTY, Cell, Document, Domains, condition_of, nonzero, part_text
from rosarch.models.machine.conditions import (
    MIRRORED,
    NULL,
    Comparison,
    Condition,
    Operand,
    as_truth,
    boolean_sides,
    choice,
    chosen_sides,
    compact,
    constant,
    is_name,
    number,
    parse_condition,
)
from rosarch.models.machine.counting import calculated, stepped
from rosarch.models.machine.limits import NO_NUMBER, are_ranges, compares, is_path
from rosarch.models.machine.logic import (
    BOOLEAN,
    OTHER,
    Formula,
    Is,
    Subject,
    conjunction,
    negation,
)
from rosarch.models.machine.pointers import is_field, is_something

_CHARACTER = re.compile(r"'(\\.|[^\\])'")
_INCREMENT = re.compile(r"(?P<name>.+?)\s*(?P<sign>[-+])\s*(?P<step>\d+)")
_FILLING = re.compile(r"\.(push|push_back|push_front|emplace|emplace_back|emplace_front|insert|append)\(")
_OPPOSITE = {"==": "!=", "is": "is not", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
_COMPARE = {"==": operator.eq, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
Table = tuple[tuple[Formula, str], ...]


@dataclass(frozen=True)
class Assignment:
    """A cell takes the first value whose condition holds; the conditions are exclusive and one of them holds."""

    cell: Cell
    table: Table


def _may_be_same(value: str, other: str, characters: bool) -> bool:
    """Whether one is a name, or a character where these are numbers, and the other a number."""
    named = [is_name(text) or (characters and _CHARACTER.fullmatch(text) is not None) for text in (value, other)]
    return (named[0] and number(other) is not None) or (named[1] and number(value) is not None)


class Meaning:
    """Translates the texts of one component."""

    def __init__(self, domains: Domains) -> None:
        self._domains = domains
        self._comparisons: dict[str, Subject] = {}

    def conjuncts(self, text: str | None, owner: str) -> tuple[Formula, ...]:
        """A condition as the parts that all have to hold, outermost first; `None` always holds."""
        if not text:
            return ()
        return tuple(self.formula(part, owner) for part in conjuncts(parse_condition(text)))

    def guard(self, row: Document, key: str, owner: str) -> tuple[Formula, ...]:
        """The guard of a row as the parts that all have to hold, one for each condition where the row has them one by one."""
        if "meant" not in row:
            return self.conjuncts(condition_of(row, key), owner)
        return tuple(TRUE if text == "true" else self.formula(parse_condition(text), owner) for text in row["meant"])

    def formula(self, condition: Condition, owner: str) -> Formula:
        """A condition as a formula."""
        if isinstance(condition, Not):
            return negation(self.formula(condition.inner, owner))
        if isinstance(condition, All | Any):
            parts = tuple(self.formula(part, owner) for part in condition.parts)
            return conjunction(parts) if isinstance(condition, All) else Any(parts)
        if isinstance(condition, Operand):
            asked = self._domains.tested(condition.text, owner)
            found = self._counted("==", asked, "0", owner)
            return negation(found) if found else self._test(asked, owner)
        if isinstance(condition, Comparison):
            return self._comparison(condition, owner)
        raise TypeError(condition)

    def _comparison(self, condition: Comparison, owner: str) -> Formula:
        size, limit = number(condition.left), number(condition.right)
        if size is not None and limit is not None and condition.op in _COMPARE:  # of parameters and constants whose values are known
            return TRUE if _COMPARE[condition.op](size, limit) else FALSE
        if found := self._counted(condition.op, condition.left, condition.right, owner):
            return found
        if choices := chosen_sides(condition):
            return Any(tuple(self.formula(part, owner) for part in choices))
        if sides := boolean_sides(condition):
            one, other = (self.formula(side, owner) for side in sides)
            return Any((conjunction((one, other)), conjunction((negation(one), negation(other)))))
        return self._equality(condition, owner) if condition.op in ("==", "is") else self._order(condition, owner)

    def assignments(
        self, variable: str, suffix: str, value: str | None, owner: str, messages: frozenset[str] = frozenset()
    ) -> list[Assignment]:
        """What assigning `value` to a variable or to its field does to each of the variable's cells.

        `messages` is what messages are called there.
        """
        found = []
        for cell in self._domains.cells_of(variable):
            if cell.suffix == suffix:
                found.append(Assignment(cell, self._table(cell, value, owner, messages)))
            elif suffix in ("", cell.suffix[: len(suffix)]):
                rest = cell.suffix[len(suffix) :]
                found.append(Assignment(cell, self._part(cell, value, rest, owner, messages)))
            elif suffix.startswith(cell.suffix):
                found.append(Assignment(cell, self._unknown(cell)))
        return found

    def _counted(self, op: str, left: str, right: str, owner: str) -> Formula | None:
        """A comparison of a variable that is counted, or of what it comes to, with a number."""
        asked = calculated(left, right)
        cell = self._domains.cell(self._domains.locator.locate(asked[0].name, owner)) if asked else None
        if asked is None or cell is None or cell.counting is None:
            return None
        known = {value: cell.counting.holds(op, *asked, value) for value in cell.subject.values}
        true = Is(cell.subject, frozenset(value for value, truth in known.items() if truth))
        rest = frozenset(value for value, truth in known.items() if truth is None)
        if not rest:
            return true
        return Any((true, All((Is(cell.subject, rest), self._compared(Comparison(op, left, right))))))

    def _test(self, operand: str, owner: str) -> Formula:
        cell = self._domains.cell(self._domains.locator.locate(operand, owner))
        subject = cell.subject if cell else self._domains.input(operand)
        if cell and cell.counting:
            return Is(subject, frozenset({cell.counting.name(0)})) if cell.suffix == EMPTY else self._opaque(operand)
        if subject.values == BOOLEAN:
            if cell and operand.replace(" ", "").endswith((".size()", ".length()")):
                return Is(subject, frozenset({"false"}))
            return Is(subject, frozenset({"true"}))
        true = nonzero(subject.values)
        return self._opaque(operand) if true is None else Is(subject, true)

    def _equality(self, condition: Comparison, owner: str) -> Formula:
        cell = self._domains.cell(self._domains.locator.locate(condition.left, owner))
        if condition.op == "==" and condition.right in ("True", "False"):
            return self._equal_to_truth(condition, cell.subject if cell else self._domains.input(condition.left), owner)
        if cell and cell.counting:
            return self._compared(condition)
        limit = number(condition.right)
        if cell and limit is not None and cell.suffix.endswith(EMPTY) and not condition.left.rstrip().endswith(EMPTY[1:]):
            return self._size(cell, lambda size: size == limit, condition, limit)
        value = self._domains.constant(condition.right, owner)
        if value is None:
            other = self._domains.cell(self._domains.locator.locate(condition.right, owner))
            one = cell.subject if cell else self._domains.input(condition.left)
            two = other.subject if other else self._domains.input(condition.right)
            alike = (one.values == BOOLEAN) is (two.values == BOOLEAN)
            return self._same(one, two, condition) if (cell or other) and alike else self._compared(condition)
        subject = cell.subject if cell else self._domains.input(condition.left)
        known = cell.value_of(condition.right) if cell else value
        if known not in subject.values or known == OTHER:
            return self._compared(condition)
        characters = bool(cell and cell.type)  # which are numbers in C++
        unlike = frozenset(v for v in subject.values if v != OTHER and _may_be_same(v, str(known), characters))
        same = Is(subject, frozenset({str(known)}))
        return Any((same, All((Is(subject, unlike), self._compared(condition))))) if unlike else same

    def _equal_to_truth(self, condition: Comparison, subject: Subject, owner: str) -> Formula:
        """Whether something equals Python's True or False, which are one and zero among numbers, and no other value."""
        alike = ("true", "1") if condition.right == "True" else ("false", "0")
        as_number = replace(condition, right=alike[1])
        if found := self._counted("==", condition.left, alike[1], owner):
            return found
        if are_ranges(subject.values):
            return self._equality(as_number, owner)
        same = Is(subject, frozenset(value for value in subject.values if value in alike))
        unsure = frozenset(value for value in subject.values if value == OTHER or is_name(value))
        return Any((same, All((Is(subject, unsure), self._compared(condition))))) if unsure else same

    def _same(self, one: Subject, two: Subject, condition: Comparison) -> Formula:
        """Two operands are equal."""
        shared = [value for value in one.values if value in two.values and value not in (OTHER, NO_NUMBER)]
        parts: list[Formula] = [All((Is(one, frozenset({value})), Is(two, frozenset({value})))) for value in shared]
        if OTHER in one.values and OTHER in two.values:
            rest = frozenset({OTHER})
            parts.append(All((Is(one, rest), Is(two, rest), self._compared(condition))))
        return Any(tuple(parts))

    def _order(self, condition: Comparison, owner: str) -> Formula:
        """A comparison by size, decided for the values that are numbers."""
        cell = self._domains.cell(self._domains.locator.locate(condition.left, owner))
        limit = number(condition.right)
        subject = cell.subject if cell else self._domains.input(condition.left)
        if limit is not None and are_ranges(subject.values):
            truths = {value: compares(condition.op, value, limit) for value in subject.values}
            if None not in truths.values():
                return Is(subject, frozenset(value for value, truth in truths.items() if truth))
        if cell is None or limit is None or cell.counting:
            return self._compared(condition)

        def holds(value: float) -> bool:
            return bool(_COMPARE[condition.op](value, limit))

        if cell.suffix.endswith(EMPTY):
            return self._size(cell, holds, condition, limit)
        known = {v: holds(size) for v in cell.subject.values if (size := number(v)) is not None}
        rest = frozenset(v for v in cell.subject.values if v not in known)
        true = Is(cell.subject, frozenset(v for v, truth in known.items() if truth))
        return Any((true, All((Is(cell.subject, rest), self._compared(condition))))) if rest else true

    def _size(self, cell: Cell, holds: Callable[[float], bool], condition: Comparison, limit: float) -> Formula:
        """A comparison of a container's size with a limit, decided where 0 and more differ."""
        answers = [holds(0.0), *(holds(size) for size in (1.0, limit, 1e9) if size >= 1)]
        if len(set(answers[1:])) == 1:
            return Is(cell.subject, frozenset(v for v, truth in (("true", answers[0]), ("false", answers[1])) if truth))
        empty = frozenset({"true"})
        rest = All((Is(cell.subject, frozenset({"false"})), self._compared(condition)))
        return Any((Is(cell.subject, empty), rest)) if answers[0] else rest

    def _compared(self, condition: Comparison) -> Formula:
        """A comparison about which nothing is known; `a < b` and `b > a` are one, and `a >= b` their opposite."""
        left, op, right = condition.left, condition.op, condition.right
        spellings = [(left, op, right), (right, MIRRORED.get(op, op), left)]
        for one, sign, two in spellings:
            if subject := self._comparisons.get(compact(f"{one} {sign} {two}")):
                return Is(subject, frozenset({"true"}))
            if subject := self._comparisons.get(compact(f"{one} {_OPPOSITE[sign]} {two}")):
                return Is(subject, frozenset({"false"}))
        text = f"{left} {op} {right}"
        subject = Subject(compact(text), text, negative=f"{left} {_OPPOSITE[op]} {right}")
        self._comparisons[subject.key] = subject
        return Is(subject, frozenset({"true"}))

    @staticmethod
    def _opaque(text: str) -> Formula:
        return Is(Subject(compact(text), text), frozenset({"true"}))

    def _table(self, cell: Cell, value: str | None, owner: str, messages: frozenset[str]) -> Table:
        if value is None:
            return self._unknown(cell)
        known = cell.value_of(value)
        if known is not None and not (constant(value) and self._domains.constant(value, owner) is None):
            return ((TRUE, known),)
        if cell.counting:
            return self._counted_on(cell, value)
        if chosen := choice(value):
            return self._chosen(cell, chosen, owner, messages)
        if cell.suffix.endswith(EMPTY):
            return self._filled(cell, value)
        if cell.subject.values == BOOLEAN:
            holds = self.formula(parse_condition(as_truth(value)), owner)
            return ((holds, "true"), (negation(holds), "false"))
        source = self._domains.cell(self._domains.locator.locate(value, owner))
        if source:
            return self._copied(cell, source.subject)
        if are_ranges(cell.subject.values):
            return self._copied(cell, self._domains.input(value)) if is_path(compact(value)) else self._unknown(cell)
        if is_something(cell.type, value, messages) or (set(cell.subject.values) == {NULL, OTHER} and is_field(value, messages)):
            return ((TRUE, OTHER),)
        return self._stepped(cell, value, owner) or self._copied(cell, self._domains.input(value))

    def _chosen(self, cell: Cell, chosen: tuple[str, str, str], owner: str, messages: frozenset[str]) -> Table:
        """What a condition chooses between."""
        condition, then, otherwise = chosen
        holds = self.formula(parse_condition(condition), owner)
        first = [(conjunction((holds, here)), value) for here, value in self._table(cell, then, owner, messages)]
        second = [(conjunction((negation(holds), here)), value) for here, value in self._table(cell, otherwise, owner, messages)]
        return (*first, *second)

    def _part(self, cell: Cell, value: str | None, rest: str, owner: str, messages: frozenset[str]) -> Table:
        """A cell inside something that is assigned as a whole."""
        if value is None:
            return self._unknown(cell)
        if rest == EMPTY:
            return self._counted_on(cell, value) if cell.counting else self._filled(cell, value)
        part = part_text(value, rest)
        return self._table(cell, part, owner, messages) if part else self._unknown(cell)

    def _counted_on(self, cell: Cell, value: str) -> Table:
        """The next number, from each of the values."""
        sized = cell.suffix == EMPTY
        taken = stepped(value, sized)
        if sized and EMPTIES.search(value) and cell.counting:
            return ((TRUE, cell.counting.name(0)),)
        if taken is None or cell.counting is None:
            return self._unknown(cell)
        rows: list[tuple[Formula, str]] = []
        for current in cell.subject.values:
            rows += self._choice(cell, Is(cell.subject, frozenset({current})), cell.counting.after(taken, current))
        return tuple(rows)

    def _filled(self, cell: Cell, value: str) -> Table:
        if EMPTIES.search(value):
            return ((TRUE, "true"),)
        return ((TRUE, "false"),) if _FILLING.search(value) else self._unknown(cell)

    def _copied(self, cell: Cell, source: Subject) -> Table:
        """The value of another variable or of an input; what this cell does not distinguish may be anything."""
        rows: list[tuple[Formula, str]] = []
        for value in source.values:
            here = Is(source, frozenset({value}))
            near = cell.nearest(value)
            if value == OTHER or near is None:
                others = [v for v in cell.subject.values if v not in source.values or v == OTHER]
                rows += self._choice(cell, here, others or list(cell.subject.values))
            else:
                rows.append((here, near))
        return tuple(rows)

    def _stepped(self, cell: Cell, value: str, owner: str) -> Table | None:
        """`x++`, `x + 1` and the like, from each of the values."""
        text = re.sub(r"^(\+\+|--)(.*)$|^(.*)(\+\+|--)$", lambda m: f"{m[2] or m[3]} {(m[1] or m[4])[0]} 1", compact(value))
        match = _INCREMENT.fullmatch(text)
        if not match or self._domains.cell(self._domains.locator.locate(match["name"], owner)) != cell:
            return None
        step = float(match["step"]) * (1 if match["sign"] == "+" else -1)
        numbers = {v: size for v in cell.subject.values if (size := number(v)) is not None}
        rows: list[tuple[Formula, str]] = []
        for current in cell.subject.values:
            here = Is(cell.subject, frozenset({current}))
            if current in numbers:
                reached = constant(repr(numbers[current] + step)) or OTHER
                rows.append((here, cell.nearest(reached) or current))
            elif current == OTHER:  # which may be on either side of each number
                rows += self._choice(cell, here, [*numbers, current])
            else:  # which number a name stands for is not known
                rows += self._choice(cell, here, list(cell.subject.values))
        return tuple(rows)

    def _unknown(self, cell: Cell) -> Table:
        return tuple(self._choice(cell, TRUE, list(cell.subject.values)))

    @staticmethod
    def _choice(cell: Cell, here: Formula, values: list[str]) -> list[tuple[Formula, str]]:
        """Any of the values, when `here` holds: the source does not say which."""
        if len(values) == 1:
            return [(here, values[0])]
        hidden = Subject(f"next {cell.subject.key} of {'|'.join(values)}", f"next {cell.subject.text}", tuple(values), hidden=True)
        return [(conjunction((here, Is(hidden, frozenset({value})))), value) for value in values]
