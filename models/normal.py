"""Conditions in negation normal form: local variables replaced by what they stand for, `x == true` as `x`, constants folded."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from rosarch.base.logic import FALSE, TRUE, All, Any, Not, alternatives, normal, opposite, truth
from rosarch.models.formula import Condition as Item
from rosarch.models.formula import Formula, both, condition, either, loosest, text
from rosarch.models.machine.conditions import (
    NULL,
    Comparison,
    Condition,
    Leaf,
    Operand,
    constant,
    is_name,
    parse_condition,
)

DEEPEST = 4  # definitions of variables within definitions of variables
LONGEST = 1000  # characters that a condition may grow to
WORD = re.compile(r"\w+")
_LOOSE = ("&&", "||", "?", ",", "=")
_NAME = re.compile(r"(?!True$|False$|None$)[A-Z]\w*[a-z]\w*")
_ALONE = re.compile(r"(?<![\w.>:])\w+(?!\w|::)")


def expanded(node: str, texts: Mapping[str, str], locals_: Mapping[str, Iterable[tuple[str, str]]], depth: int = DEEPEST) -> str:
    """The text of `node` with its local variables replaced; `locals_` has their names and values by node."""
    found = texts[node]
    for name, value in locals_.get(node, ()) if depth else ():
        if value in texts:
            inner = expanded(value, texts, locals_, depth - 1)
            found = replaced(found, name, inner)
    return found


def replaced(source: str, name: str, value: str) -> str:
    """`source` with `value` in the place of `name`, a variable or a call, where that stands by itself, unless it grew too long."""
    named = re.compile(rf"(?<![\w.>:]){re.escape(name)}(?!\w)")
    longer = _bracketed(value).join(named.split(source))
    return longer if len(longer) <= LONGEST else source


def with_values(source: str, values: Mapping[str, str]) -> str:
    """`source` with values in the places of names that stand by themselves, all at once."""
    if not values or values.keys().isdisjoint(WORD.findall(source)):
        return source
    longer = _ALONE.sub(lambda match: _bracketed(values[match.group()]) if match.group() in values else match.group(), source)
    return longer if len(longer) <= LONGEST else source


def _bracketed(value: str) -> str:
    return f"({value})" if loosest(value) or _compares(value) else value


def _compares(value: str) -> bool:
    return any(sign in value for sign in "<>=") and isinstance(parse_condition(value), Comparison)


def truth_of(source: str) -> bool | None:
    """Whether a condition holds, where constants alone decide that.

    Constants with different names are different ones, but a name and a number need not be; names that might be those of variables or
    classes (`Idle`) decide nothing.
    """
    return truth(parse_condition(source), _decided)


def _decided(leaf: Leaf) -> bool | None:
    if not isinstance(leaf, Comparison) or leaf.op != "==":
        return None
    left, right = (None if _NAME.fullmatch(side) else constant(side) for side in (leaf.left, leaf.right))
    return None if left is None or right is None or _is_name(left) is not _is_name(right) else left == right


def _is_name(known: str) -> bool:
    """Whether it is a name, also that of null, which may be zero."""
    return is_name(known) or known == NULL


def folded(source: str) -> str:
    """A condition without those of its parts that constants alone decide."""
    parsed = parse_condition(source)
    shorter = _folded(parsed)
    return source if shorter == parsed else _written(shorter)


def _folded(parsed: Condition) -> Condition:
    known = truth(parsed, _decided)
    if known is not None:
        return TRUE if known else FALSE
    if isinstance(parsed, Not):
        return opposite(_folded(parsed.inner))
    if isinstance(parsed, All | Any):
        return type(parsed)(tuple(_folded(part) for part in parsed.parts))
    return parsed


def normal_text(formula: Formula) -> str | None:
    """The formula's conditions by what they stand for, as a text in negation normal form; None when it is true."""
    source = text(either(_meant(conjunction) for conjunction in alternatives(formula)))
    if source is None:
        return None
    written = _written(parse_condition(source))
    return None if written == "true" else written


def _meant(items: Iterable[Item]) -> Formula:
    found: Formula = TRUE
    for item in items:
        meant = item.meaning or item.text
        found = both(found, condition(meant, item.holds, stable=item.stable, words=item.words, through=item.through))
    return found


def _written(parsed: Condition) -> str:
    """A condition with negations at its leaves only."""
    return _text(normal(parsed, True, lambda atom, holds: atom if holds else Not(atom)))


def _text(formula: Condition, holds: bool = True) -> str:
    """A condition in negation normal form, or a leaf that does not hold."""
    if isinstance(formula, Not):
        return _text(formula.inner, False)
    if isinstance(formula, All | Any):
        return _joined([_text(part) for part in formula.parts], isinstance(formula, All))
    if isinstance(formula, Comparison):
        return _comparison(formula, holds)
    if isinstance(formula, Operand):
        return _operand(formula, holds)
    raise TypeError(formula)


def _operand(operand: Operand, holds: bool) -> str:
    loose = loosest(operand.text)
    if holds:
        return f"({operand.text})" if loose in ("||", "?", ",", "=") else operand.text
    return f"!({operand.text})" if loose else f"!{operand.text}"


def _comparison(parsed: Comparison, holds: bool) -> str:
    left, right = (f"({side})" if loosest(side) in _LOOSE or _compares(side) else side for side in (parsed.left, parsed.right))
    if parsed.op == "is":
        return f"{left} {'is' if holds else 'is not'} {right}"
    if parsed.op == "==":
        return f"{left} {'==' if holds else '!='} {right}"
    source = f"{left} {parsed.op} {right}"
    return source if holds else f"!({source})"  # not the opposite sign: neither holds for what is no number


def _joined(parts: list[str], conjunction: bool) -> str:
    """The parts joined; those that change nothing are left out, and one that decides is all."""
    neutral, deciding = ("true", "false") if conjunction else ("false", "true")
    kept = [part for part in dict.fromkeys(parts) if part != neutral]
    if deciding in kept:
        return deciding
    if len(kept) < 2:
        return kept[0] if kept else neutral
    sign = "&&" if conjunction else "||"
    return f" {sign} ".join(f"({part})" if _binds_less(part, conjunction) else part for part in kept)


def _binds_less(part: str, conjunction: bool) -> bool:
    return loosest(part) == ("||" if conjunction else "&&")
