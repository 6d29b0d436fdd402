"""Conditions as the source has them, in C++ or Python, read as far as state machines need it.

Only the logical skeleton is understood: `and`, `or`, `not`, brackets, comparisons, and which operands are constants. Everything else
stays the text that it is, a condition of its own that may hold or not. So no condition is an error, and a condition in a notation
that is not known costs precision, not the machine.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from rosarch.base.logic import FALSE, TRUE, All, Any, Formula, conjuncts, opposite


@dataclass(frozen=True)
class Leaf:
    """What a condition is made of: an `Operand` or a `Comparison`."""


@dataclass(frozen=True)
class Operand(Leaf):
    """An operand taken as a truth value, or a text that could not be read further."""

    text: str


@dataclass(frozen=True)
class Comparison(Leaf):
    """`left op right`, where `op` is `==`, `<`, `<=`, `>` or `>=`; a constant, if there is one, stands on the right.

    Python's `x is True` and `x == True`, where `op` is `is` or `==`, are not so of everything that counts as true.
    """

    op: str
    left: str
    right: str


Condition: TypeAlias = Formula[Leaf]
"""A condition; `and` and `or` are in the order of the source."""

REMEMBERED = 1 << 14
"""How many texts are read once: those of a component come again with each of its variables and triggers."""
NULL = "null"
MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
_LONGEST, _DEEPEST = 5000, 50  # tokens, brackets: beyond, a text is taken as a whole
_TOKEN = re.compile(
    r"""\s*(?:
    (?P<text>(?:u8|[uULRrbf])?"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
    | (?P<number>(?:0[xX][0-9a-fA-F]+|0[bBoO]\d+|(?:\d+(?:['_]\d+)*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[fFuUlL]*)
    | (?P<name>(?:::)?[A-Za-z_]\w*(?:::~?[A-Za-z_]\w*)*)
    | (?P<sign>&&|\|\||==|!=|<=|>=|->|<<|>>|\+\+|--|\+=|-=|\S)
    )""",
    re.VERBOSE,
)
_LITERAL = re.compile(
    r"(?P<sign>[-+]?)\s*(?P<digits>0[xX][0-9a-fA-F]+|0[bBoO]\d+|(\d+(['_]\d+)*\.?\d*|\.\d+)([eE][-+]?\d+)?)(?P<suffix>[fFuUlL]*)"
)
_BRACKETS = {"(": ")", "[": "]", "{": "}"}
_WORDS = {"and": "&&", "or": "||", "not": "!"}
_RELATIONS = ("==", "!=", "<=", ">=", "<", ">", "is")
_TOO_HARD = {"?", "=", ",", "lambda", "if", "else", "+=", "-="}
_CAST = re.compile(r"(?:static|const|reinterpret|dynamic)_cast")


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    start: int
    end: int
    closing: int = -1  # the index of the bracket that ends what this one begins


@lru_cache(maxsize=REMEMBERED)
def parse_condition(text: str) -> Condition:
    """Read a condition; what is not understood becomes an `Operand` of its text."""
    tokens = _tokens(text)
    if not tokens or len(tokens) > _LONGEST:
        return Operand(spaced(text))
    return _disjunction(tokens, 0, len(tokens), text)


def as_truth(text: str) -> str:
    """A value of truth values with `||` for `|` and `&&` for `&`, which are the same there."""
    tokens = _tokens(text) or []
    signs = _top_level(tokens, 0, len(tokens), lambda token: token.text in ("|", "&"))
    if any(token.text in ("not", "~", "^") for token in tokens):
        return text  # which bind otherwise
    for index in reversed([index for index in signs if 0 < index < len(tokens) - 1]):
        token = tokens[index]
        text = text[: token.start] + token.text * 2 + text[token.end :]
    return text


def boolean_sides(condition: Comparison) -> tuple[Condition, Condition] | None:
    """Both sides of an equality one of which is a condition itself: `(n > 3) == ready`."""
    if condition.op != "==":
        return None
    sides = parse_condition(condition.left), parse_condition(condition.right)
    return None if all(isinstance(side, Operand) or side in (TRUE, FALSE) for side in sides) else sides


def chosen_sides(condition: Comparison) -> tuple[Condition, Condition] | None:
    """`(c ? a : b) == x` as `c && a == x` or `!c && b == x`, the two ways in which it may hold."""
    for side, other, is_left in ((condition.left, condition.right, True), (condition.right, condition.left, False)):
        if "?" not in side and " if " not in side:
            continue
        if found := choice(side):
            asked = parse_condition(found[0])
            parts = [_normal(condition.op, part, other) if is_left else _normal(condition.op, other, part) for part in found[1:]]
            return All((asked, parts[0])), All((opposite(asked), parts[1]))
    return None


@lru_cache(maxsize=REMEMBERED)
def choice(text: str) -> tuple[str, str, str] | None:
    """Of `a ? b : c`, or `b if a else c`, the condition and what is chosen between; nothing when it is no such choice."""
    text = strip(text)
    tokens = _tokens(text) or []
    marks = _top_level(tokens, 0, len(tokens), lambda token: token.text in ("?", ":", "if", "else", "lambda", ","))
    signs = [tokens[mark].text for mark in marks]
    if "lambda" in signs or "," in signs or len(signs) < 2:
        return None
    if signs[0] == "?":
        depth, end = 0, -1
        for mark, sign in zip(marks, signs, strict=True):
            depth += {"?": 1, ":": -1}.get(sign, 0)
            if depth == 0:
                end = mark
                break
        spans = [] if end < 0 else [(0, marks[0]), (marks[0] + 1, end), (end + 1, len(tokens))]
    elif signs[:2] == ["if", "else"]:
        spans = [(marks[0] + 1, marks[1]), (0, marks[0]), (marks[1] + 1, len(tokens))]
    else:
        spans = []
    parts = [_text(tokens, start, end, text) for start, end in spans]
    return (parts[0], parts[1], parts[2]) if len(parts) == 3 and all(parts) else None


def spaced(text: str) -> str:
    """A text on one line with single spaces."""
    return " ".join(text.split())


@lru_cache(maxsize=REMEMBERED)
def compact(text: str) -> str:
    """The same for texts that differ in white space, redundant brackets, casts that change no value, or `this->` and `self.` alone."""
    text = re.sub(r"(?<!\w)this\s*->\s*|(?<![\w.>])self\s*\.\s*(?=\w)", "", strip(text))
    return re.sub(r"\s+(?!\w)|(?<!\w)\s+", "", text)


@lru_cache(maxsize=REMEMBERED)
def strip(text: str) -> str:
    """An operand without the brackets and named casts around it."""
    tokens = _tokens(text)
    start, end = 0, len(tokens or ())
    while tokens and start < end:
        first, last = tokens[start], tokens[end - 1]
        if first.text == "(" and first.closing == end - 1:
            start, end = start + 1, end - 1
        elif _CAST.fullmatch(first.text) and last.text == ")" and (opening := _after_template(tokens, start + 1)) > 0:
            if tokens[opening].closing != end - 1:
                break
            start, end = opening + 1, end - 1
        else:
            break
    return spaced(text[tokens[start].start : tokens[end - 1].end]) if tokens and start < end else spaced(text)


@lru_cache(maxsize=REMEMBERED)
def constant(text: str) -> str | None:
    """The constant that a text denotes, in one spelling: `true`, `false`, `null`, a number, a quoted text, or an enumerator's last name.

    A plain name counts as a constant when it is written as one: `IDLE`, `kIdle`, `Idle`, or qualified, `Mode::idle`.
    """
    text = strip(text)
    if text in ("true", "True", "false", "False"):
        return text.lower()
    if text in ("NULL", "nullptr", "None", "null", "nullopt", "std::nullopt", "boost::none"):
        return NULL
    if re.fullmatch(r"""[uULRrbf]?8?("(\\.|[^"\\])*"|'(\\.|[^'\\])*')""", text):
        return text
    if (value := number(text)) is not None:
        return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)
    if re.fullmatch(r"(::)?\w+((::|\.)\w+)*", text) and re.fullmatch(r"[A-Z]\w*|k[A-Z]\w*", re.split(r"::|\.", text)[-1]):
        return re.split(r"::|\.", text)[-1]
    if re.fullmatch(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)+", text):
        return text.rsplit("::", 1)[-1]
    return None


def is_name(known: str) -> bool:
    """Whether a constant is a name: which number or text that is, it does not say."""
    return known.isidentifier() and known not in ("true", "false", NULL)


def single(value: float) -> float:
    """A number with as few digits as a `float` keeps."""
    return float(struct.unpack("f", struct.pack("f", value))[0]) if abs(value) < 1e38 else value


def number(text: str) -> float | None:
    """The value of a literal number."""
    match = _LITERAL.fullmatch(text.strip())
    if not match:
        return None
    digits = re.sub("['_]", "", match["digits"])
    based = digits.lower() if re.fullmatch(r"0[xXbBoO].*", digits) else f"0o{digits}" if re.fullmatch(r"0\d+", digits) else ""
    try:
        value = float(int(based, 0)) if based else single(float(digits)) if match["suffix"][:1] in ("f", "F") else float(digits)
    except ValueError:
        return None
    return -value if match["sign"] == "-" else value


def _tokens(text: str) -> list[_Token] | None:
    """The tokens of a text with matched brackets, nothing when they do not match."""
    found: list[_Token] = []
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup or "sign"
        found.append(_Token(kind, match.group(kind), match.start(kind), match.end(kind)))
    opened: list[int] = []
    for index, token in enumerate(found):
        if token.text in _BRACKETS:
            opened.append(index)
            if len(opened) > _DEEPEST:
                return None
        elif token.text in _BRACKETS.values():
            if not opened or _BRACKETS[found[opened[-1]].text] != token.text:
                return None
            start = opened.pop()
            found[start] = _Token("sign", found[start].text, found[start].start, found[start].end, index)
    return None if opened else found


def _after_template(tokens: Sequence[_Token], index: int) -> int:
    """Where the bracket after template arguments beginning at `index` is, 0 when there are none."""
    if index >= len(tokens) or tokens[index].text != "<":
        return 0
    depth = 0
    for position in range(index, len(tokens)):
        token = tokens[position]
        depth += {"<": 1, ">": -1, ">>": -2}.get(token.text, 0)
        if depth <= 0:
            return position + 1 if position + 1 < len(tokens) and tokens[position + 1].text == "(" else 0
        if token.kind not in ("name", "number") and token.text not in ("<", ">", ",", "*", "&"):
            return 0
    return 0


def _top_level(tokens: Sequence[_Token], start: int, end: int, wanted: Callable[[_Token], bool]) -> list[int]:
    """The indices of the wanted tokens that lie in no bracket and in no template arguments."""
    found, index = [], start
    while index < end:
        token = tokens[index]
        if wanted(token):
            found.append(index)
        opening = _after_template(tokens, index + 1) if token.kind == "name" else 0
        index = opening if 0 < opening < end else max(token.closing, index) + 1
    return found


def _split(tokens: Sequence[_Token], start: int, end: int, sign: str) -> list[tuple[int, int]]:
    cuts = _top_level(tokens, start, end, lambda token: _WORDS.get(token.text, token.text) == sign)
    return list(zip([start, *(cut + 1 for cut in cuts)], [*cuts, end], strict=True))


def _disjunction(tokens: Sequence[_Token], start: int, end: int, text: str) -> Condition:
    if start >= end or _top_level(tokens, start, end, lambda token: token.text in _TOO_HARD):
        return Operand(_text(tokens, start, end, text))
    parts = [_conjunction(tokens, first, last, text) for first, last in _split(tokens, start, end, "||")]
    return parts[0] if len(parts) == 1 else Any(tuple(parts))


def _conjunction(tokens: Sequence[_Token], start: int, end: int, text: str) -> Condition:
    parts: list[Condition] = []
    for first, last in _split(tokens, start, end, "&&"):
        parts += conjuncts(_negation(tokens, first, last, text))
    return parts[0] if len(parts) == 1 else All(tuple(parts))


def _negation(tokens: Sequence[_Token], start: int, end: int, text: str) -> Condition:
    first = start
    while first < end and _WORDS.get(tokens[first].text, tokens[first].text) == "!":
        first += 1
    if start < first < end and not _relations(tokens, start, end):
        inner = _negation(tokens, first, end, text)
        return opposite(inner) if (first - start) % 2 else inner
    if start < end and tokens[start].text == "(" and tokens[start].closing == end - 1:
        return _disjunction(tokens, start + 1, end - 1, text)
    return _comparison(tokens, start, end, text)


def _relations(tokens: Sequence[_Token], start: int, end: int) -> list[int]:
    return _top_level(tokens, start, end, lambda token: token.text in _RELATIONS)


def _membership(tokens: Sequence[_Token], start: int, end: int, text: str) -> Condition | None:
    """`x in (A, B)` of Python, or `x not in ...`: one of several, where these are written out."""
    found = next((index for index in range(start + 1, end - 1) if tokens[index].text == "in" and _is_value(tokens[index - 1])), None)
    if found is None or tokens[found + 1].text not in _BRACKETS or tokens[found + 1].closing != end - 1:
        return None
    negated = tokens[found - 1].text == "not"
    last = found - negated
    first = _text(tokens, start, last, text)
    cuts = _top_level(tokens, found + 2, end - 1, lambda token: token.text == ",")
    if not cuts and tokens[found + 1].text == "(":
        return None  # a text in brackets, or what is calculated
    spans = zip([found + 2, *(cut + 1 for cut in cuts)], [*cuts, end - 1], strict=True)
    members = [_text(tokens, begin, stop, text) for begin, stop in spans if begin < stop]
    if not first or not members or _relations(tokens, start, last):
        return None
    parts = tuple(_normal("==", first, member) for member in members)
    inner = parts[0] if len(parts) == 1 else Any(parts)
    return opposite(inner) if negated else inner


def _is_value(token: _Token) -> bool:
    """Whether something ends with a token that may be a member: in C++ `in` may be a name."""
    return token.kind in ("name", "number", "text") or token.text in _BRACKETS.values()


def _comparison(tokens: Sequence[_Token], start: int, end: int, text: str) -> Condition:
    if (member := _membership(tokens, start, end, text)) is not None:
        return member
    found = _relations(tokens, start, end)
    whole = _text(tokens, start, end, text)
    if not found:
        value = constant(whole)
        return TRUE if value == "true" else FALSE if value == "false" else Operand(strip(whole))
    if len(found) > 1 or found[0] in (start, end - 1):
        return Operand(whole)
    op, rest = tokens[found[0]].text, found[0] + 1
    left, right = _text(tokens, start, found[0], text), _text(tokens, rest, end, text)
    if op == "is":
        right = right.removeprefix("not ") if (negated := tokens[rest].text == "not") else right
        same = Comparison("is", strip(left), right) if right in ("True", "False") and _is_operand(left) else _normal("==", left, right)
        return opposite(same) if negated else same
    return _normal(op, left, right)


def _is_operand(text: str) -> bool:
    """Whether a text is no condition itself."""
    return isinstance(parse_condition(text), Operand)


def _normal(op: str, left: str, right: str) -> Condition:
    left, right = strip(left), strip(right)
    if op == "!=":
        return opposite(_normal("==", left, right))
    if constant(left) is not None and constant(right) is None:
        left, op, right = right, MIRRORED.get(op, op), left
    if op == "==" and constant(right) in ("true", "false") and not (right in ("True", "False") and _is_operand(left)):
        inner = parse_condition(left)
        return inner if constant(right) == "true" else opposite(inner)
    return Comparison(op, left, right)


def _text(tokens: Sequence[_Token], start: int, end: int, text: str) -> str:
    return spaced(text[tokens[start].start : tokens[end - 1].end]) if start < end else ""
