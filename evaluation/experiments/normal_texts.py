"""When two texts of a model say the same: C++ names without namespaces, expressions without spaces, guards as sets of conjuncts."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import PurePath
from typing import Any

_AT = re.compile(r"(.*?):(\d+)(?::\d+)?$")
_SPACES = re.compile(r"\s+")
_SUFFIX_OF_NUMBER = re.compile(r"(?<=\d)[fFuUlL]+\b")
_TRIVIAL = frozenset({"true", "ok()", "1"})


def line_of(at: Any) -> tuple[str, int]:
    """Name of the file and line of `dir/file.cpp:12[:3]`, or of the first of a list of these."""
    if isinstance(at, list):
        at = at[0] if at else ""
    match = _AT.match(str(at or ""))
    return (PurePath(match[1]).name, int(match[2])) if match else (str(at), 0)


def short(name: Any) -> str:
    """A C++ name as `Class::member`, or the bare name of what is in no class."""
    return _short(str(name or ""))


@lru_cache(maxsize=10_000)
def _short(name: str) -> str:
    parts = [part for part in name.split("::") if part and "anonymous" not in part]
    return "::".join(parts[-2:])


def same_name(one: Any, other: Any) -> bool:
    """Whether two C++ names may mean the same: equal when shortened, or one without a class has the last word of the other."""
    one, other = short(one), short(other)
    return one == other or (("::" not in one or "::" not in other) and one.split("::")[-1] == other.split("::")[-1])


def normal(value: Any) -> str:
    """An expression without spaces, quotes, brackets around it and suffixes of numbers."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return _normal(str(value))


@lru_cache(maxsize=10_000)
def _normal(value: str) -> str:
    text = _SUFFIX_OF_NUMBER.sub("", _SPACES.sub("", value)).strip("\"'")
    while text.startswith("(") and text.endswith(")") and _balanced(text[1:-1]):
        text = text[1:-1]
    try:
        return repr(float(text))
    except ValueError:
        return text


def conjuncts(guard: Any) -> set[str]:
    """The conjuncts of a guard, each normal and without what is always true."""
    source = re.sub(r"\band\b", "&&", re.sub(r"\s+", " ", str(guard or "")))
    found: set[str] = set()
    for part in _parts(source):
        item = normal(part)
        if _balanced(item) and "&&" in item and item != re.sub(r"\s+", "", source):
            found |= conjuncts(item)
        elif (plain := _plain(item)) and plain not in _TRIVIAL:
            found.add(plain)
    return found


def jaccard(one: set[str], other: set[str]) -> float:
    """The share of what both have in what either has."""
    return len(one & other) / len(one | other) if one | other else 1.0


def _parts(source: str) -> list[str]:
    """The text between the `&&` that are in no brackets."""
    parts, depth, start = [], 0, 0
    for index, char in enumerate(source):
        depth += {"(": 1, ")": -1}.get(char, 0)
        if depth == 0 and source.startswith("&&", index):
            parts.append(source[start:index])
            start = index + 2
    return [*parts, source[start:]]


def _plain(condition: str) -> str:
    """A condition without comparisons to true and false, negated equality and the words that say nothing."""
    condition = re.sub(r"(==true|!=false)$", "", condition)
    condition = re.sub(r"^(.*?)(==false|!=true)$", r"!\1", condition)
    condition = re.sub(r"^!\((.*)==(.*)\)$", r"\1!=\2", condition)
    condition = re.sub(r"^!\((.*)!=(.*)\)$", r"\1==\2", condition)
    return re.sub(r"^!!", "", re.sub(r"this->|std::|ros::", "", condition))


def _balanced(expression: str) -> bool:
    depth = 0
    for char in expression:
        depth += {"(": 1, ")": -1}.get(char, 0)
        if depth < 0:
            return False
    return depth == 0
