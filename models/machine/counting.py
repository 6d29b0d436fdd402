"""Numbers that are counted: what expressions come to that are made of one variable and whole numbers, and how far a variable is counted."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import lcm

from rosarch.models.machine.conditions import REMEMBERED, compact, number, single, strip
from rosarch.models.machine.logic import OTHER

MOST_VALUES = 128
_PATH = r"[A-Za-z_][\w:]*(?![\w:(])(?:(?:\.|->)[A-Za-z_]\w*(?![\w(]))*(?:(?:\.|->)(?:size|length)\(\))?"
_OPERAND = re.compile(rf"(?<![\w.])(?P<before>\+\+|--)?(?:len\((?P<list>{_PATH})\)|(?P<name>{_PATH}))(?P<after>\+\+|--)?")
_NUMBER = re.compile(r"(?<![\w.])(\d+)[uUlL]*(?![\w.])")
_CAST = re.compile(r"\((?:unsigned|signed|int|long|size_t|std::size_t|u?int\d+_t)\)")
_SIGNS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Mod: operator.mod}
_AFTER = {"++": "(n-1)", "--": "(n+1)", None: "n"}
_REST = re.compile(r"\(?n(?:[+-]\d+)?\)?%(\d+)|\(\(n[+-]1\)(?:[+-]\d+)?\)%(\d+)|\(n[+-]1\)%(\d+)")
_ADDS_ONE = re.compile(r"(.+?)(?:\.|->)(?:push|push_back|push_front|emplace|emplace_back|emplace_front|append|appendleft)\(")
_TAKES_ONE = re.compile(r"(.+?)(?:\.|->)(?:pop|pop_back|pop_front|popleft)\(")
COMPARE: dict[str, Callable[[float, float], bool]] = {
    "==": operator.eq, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip


@dataclass(frozen=True)
class Arithmetic:
    """A calculation with whole numbers, in which `name` is the one variable, "" where there is none; `text` calls it n.

    Of what counts on the way (`++n`, `n--`) it is the value where that has been counted already.
    """

    name: str
    text: str

    def at(self, n: int) -> int | None:
        """What it comes to; None where languages differ: with what is negative."""
        try:
            return _value(ast.parse(self.text, mode="eval").body, n)
        except (SyntaxError, ValueError, RecursionError):
            return None

    @property
    def numbers(self) -> list[int]:
        """The numbers that are written in it."""
        return [int(digits) for digits in re.findall(r"\d+", self.text)]

    @property
    def modulus(self) -> int | None:
        """What it is the rest of a division by, where it is nothing else."""
        match = _REST.fullmatch(self.text)
        return int(next(filter(None, match.groups()))) or None if match else None


@lru_cache(maxsize=REMEMBERED)
def arithmetic(text: str) -> Arithmetic | None:
    """The calculation that a text describes, if it is one; it names one variable at most."""
    names: set[str] = set()

    def called(match: re.Match[str]) -> str:
        names.add(f"{match['list']}.size()" if match["list"] else str(match["name"]))
        return "n" if match["before"] else _AFTER[match["after"]]

    plain = _NUMBER.sub(r"\1", _CAST.sub("", compact(strip(text))))
    if len(plain) > 120 or re.search(r"[\"'\[\],&|<>=!?]", plain.replace("->", ".")):
        return None
    short = _OPERAND.sub(called, plain)
    if len(names) > 1 or not re.fullmatch(r"[\dn+\-*%()]+", short) or "**" in short:
        return None
    found = Arithmetic(next(iter(names), ""), short)
    return found if found.at(1) is not None or found.at(0) is not None else None


def step(text: str) -> Arithmetic | None:
    """The calculation that gives a variable its next value: `++n`, `n += 2` as `n + 2`, `(n + 1) % 4`."""
    plain = compact(text)
    match = re.fullmatch(r"(\+\+|--)(.+)|(.+?)(\+\+|--)", plain)
    return arithmetic(f"{match[2] or match[3]}{(match[1] or match[4])[0]}1" if match else plain)


def whole(text: object) -> int | None:
    """The whole number that a text is."""
    size = None if text is None else number(strip(str(text)))
    return int(size) if size is not None and size == int(size) else None


def calculated(left: str, right: str) -> tuple[Arithmetic, int] | None:
    """A comparison of a calculation that has a variable with a whole number."""
    asked, limit = arithmetic(left), arithmetic(right)
    size = limit.at(0) if limit and not limit.name else None
    return (asked, size) if asked and asked.name and size is not None else None


def stepped(text: str, sized: bool) -> Arithmetic | None:
    """What an assignment makes of the number that a variable is, or of the number of elements that a container has."""
    if not sized:
        return step(text)
    if match := _ADDS_ONE.match(text):
        return arithmetic(f"{match[1]}.size() + 1")
    if match := _TAKES_ONE.match(text):
        return arithmetic(f"{match[1]}.size() - 1")
    return None


def _value(part: ast.expr, n: int) -> int:
    if isinstance(part, ast.Constant) and isinstance(part.value, int):
        return part.value
    if isinstance(part, ast.Name) and part.id == "n":
        return n
    if isinstance(part, ast.UnaryOp) and isinstance(part.op, ast.USub):
        return -_value(part.operand, n)
    if isinstance(part, ast.BinOp) and type(part.op) in _SIGNS:
        left, right = _value(part.left, n), _value(part.right, n)
        if isinstance(part.op, ast.Mod) and (left < 0 or right <= 0):
            raise ValueError(part)
        found: int = _SIGNS[type(part.op)](left, right)
        if abs(found) < 10**9:
            return found
    raise ValueError(part)


@dataclass(frozen=True)
class Counting:
    """The whole numbers that are distinguished for a counted variable: from `least` to `most`.

    `above` and `below` say that it may be more, or less, than that. With a `modulus` it stands for the rest that it leaves, as nothing
    else is asked of it. One that `wraps` continues at its other end when it has gone too far beyond; where that is stays open.
    """

    least: int
    most: int
    above: bool = False
    below: bool = False
    modulus: int | None = None
    wraps: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """What its values are called, without what is beyond."""
        return tuple(f"{number}{self._rest}" for number in range(self.least, self.most + 1))

    @property
    def _rest(self) -> str:
        return f" of {self.modulus}" if self.modulus else ""

    def number(self, name: str) -> int | None:
        """The number that a value stands for, None for what is beyond."""
        digits = name.removesuffix(self._rest)
        return int(digits) if re.fullmatch(r"-?\d+", digits) else None

    def name(self, number: int) -> str:
        """What a number is called."""
        if self.modulus:
            return f"{number % self.modulus}{self._rest}"
        return str(number) if self.least <= number <= self.most else OTHER

    def holds(self, op: str, asked: Arithmetic, limit: int, name: str) -> bool | None:
        """Whether a condition holds of a value; None where that is not known."""
        number = self.number(name)
        if number is None and (self.above is self.below or "%" in asked.text):
            return None
        left = asked.at(self.most + 1 if self.above else self.least - 1) if number is None else asked.at(number + (self.modulus or 0))
        return None if left is None else COMPARE[op](left, limit)

    def after(self, step: Arithmetic, name: str) -> list[str]:
        """The values that one may be after a step."""
        number = self.number(name)
        if number is not None:
            reached = step.at(number)
            return [*self.names, *self.beyond] if reached is None else [self.name(reached)]
        far = self.most + 1 if self.above else self.least - 1
        reached = None if self.above is self.below else step.at(far)
        onward = reached is not None and (reached >= far if self.above else reached <= far)
        return [OTHER] if onward and not self.wraps and re.fullmatch(r"n[+-]\d+|n", _bare(step.text)) else [*self.names, OTHER]

    @property
    def beyond(self) -> tuple[str, ...]:
        """What stands for the numbers that are not distinguished."""
        return (OTHER,) if self.above or self.below else ()


def _bare(text: str) -> str:
    return text[1:-1] if text.startswith("(") and text.endswith(")") and text.count("(") == 1 else text


@dataclass(frozen=True)
class Width:
    """How many bits an integer has: numbers below zero, or of more bits, continue at the other end."""

    bits: int
    signed: bool

    @property
    def narrow(self) -> bool:
        """Whether a counter soon has gone round."""
        return self.bits <= 16


WIDE = Width(64, True)
_WHOLE = re.compile(r"(?:(?:unsigned|signed|short|long|int|char|u?int\d+_t|size_t)\b ?)+")
_BITS = (
    (r"\bu?int(8|16|32|64)_t\b", 0),
    (r"\bchar\b|\bbyte\b", 8), (r"\bshort\b", 16), (r"\bsize_t\b|\blong\b", 64), (r"\bint\b|\bunsigned\b", 32),
)  # fmt: skip


def width(type_: str) -> Width:
    """The width of a type of C++; Python's numbers, which have no declared type, have all the bits that they need."""
    signed = not re.search(r"\bunsigned\b|\buint|\bsize_t\b|\bbyte\b", type_)
    found = ((match, bits) for pattern, bits in _BITS if (match := re.search(pattern, type_)))
    return next((Width(bits or int(match[1]), signed) for match, bits in found), WIDE)


def is_integer(type_: str) -> bool:
    """Whether a type of C++ is one of whole numbers."""
    return bool(_WHOLE.fullmatch(type_))


def stored(type_: str, text: str) -> str:
    """A literal number as a variable of a type keeps it: without its fraction, with as many bits as there are; other texts as they are."""
    size, kept = number(strip(text)), width(type_)
    if size is not None and type_ == "float":
        return repr(single(size))
    if size is None or not is_integer(type_):
        return text
    rest = int(size) % 2**kept.bits
    return str(rest - 2**kept.bits if kept.signed and rest >= 2 ** (kept.bits - 1) else rest)


def _falls(step: Arithmetic, number: int) -> bool:
    after = step.at(number)
    return after is not None and after < number


def counting(
    first: int,
    given: Iterable[int],
    steps: Sequence[Arithmetic],
    asked: Sequence[tuple[Arithmetic, int]],
    *,
    rests: bool = True,
    width: Width = WIDE,
    sized: bool = False,
) -> Counting | None:
    """How a variable is counted that begins with `first`, may be `given` numbers and take `steps`.

    Conditions compare what is `asked` with limits.
    Where nothing else is asked, it is enough to know its `rests`. None: there are too many numbers.
    What is `sized` is the size of a container: nothing is taken from an empty one.
    """
    starts = {first, *given}
    moduli = [left.modulus for left, _ in asked]
    if rests and None not in moduli and min(starts) >= 0 and all(re.fullmatch(r"n(\+\d+)?", _bare(step.text)) for step in steps):
        modulus = lcm(*(modulus for modulus in moduli if modulus))
        if not width.narrow or (not width.signed and 2**width.bits % modulus == 0):
            return Counting(0, modulus - 1, modulus=modulus) if modulus <= MOST_VALUES else None
    far = [abs(limit) + sum(left.numbers) for left, limit in asked]
    far += [max(step.numbers, default=0) for step in steps if "%" in step.text]
    falls = any(_falls(step, number) for step in steps for number in (max([*starts, *far]), first))
    negative = [-number for number in far] if min(starts) < 0 or (falls and width.signed and not sized) else []
    least, most = min([*starts, *negative]), max([*starts, *far])
    if falls:
        least = min(least, 0)
        most += 1  # a sliding window has one more for a moment
    if most - least >= MOST_VALUES:
        return None
    reached, waiting, above, below = set(starts), list(starts), False, False
    while waiting:
        number = waiting.pop()
        for step in steps:
            after = step.at(number)
            if after is None:
                return None
            if sized and after < 0:
                continue
            above, below = above or after > most, below or after < least
            if least <= after <= most and after not in reached:
                reached.add(after)
                waiting.append(after)
    above = above or (below and not width.signed)  # below zero are the greatest numbers
    below = below or (above and width.narrow and least > (-(2 ** (width.bits - 1)) if width.signed else 0))  # where it begins again
    return Counting(least if below else min(reached), most if above else max(reached), above, below, wraps=width.narrow)
