"""The functions and methods that `$(eval ...)` may use, with bounds on what they make."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

from rosarch.extractor.launch.unknowns import cleaned

MAX_SIZE = 200_000  # characters of a text, or of all texts and items of a list
MAX_BITS = 20_000
MAX_ARGUMENT = 10_000  # of functions whose result grows fast with their argument: range, factorial, a width

Function = Callable[..., Any]


class TooLarge(Exception):
    """A value that is too large to be worth computing."""


def size_of(value: Any) -> int:
    """About how many characters and items a value has, those within it included.

    Raises:
        TooLarge: more than a launch file may need.
    """
    size, stack = 0, [value]
    while stack:
        item = stack.pop()
        if isinstance(item, (str, bytes, range)):
            size += len(item)
        elif isinstance(item, int):
            size += item.bit_length() * MAX_SIZE // MAX_BITS
        elif isinstance(item, (list, tuple, set, dict)):
            size += len(item)
            if size <= MAX_SIZE:
                stack.extend(item.values() if isinstance(item, dict) else item)
                stack.extend(item if isinstance(item, dict) else ())
        if size > MAX_SIZE:
            raise TooLarge("the value is too large")
    return size


def _small(function: Function) -> Function:
    """`function`, for numbers up to `MAX_ARGUMENT` only."""

    def call(*arguments: Any) -> Any:
        if any(isinstance(item, int) and abs(item) > MAX_ARGUMENT for item in arguments):
            raise TooLarge("the argument is too large")
        return function(*arguments)

    return call


_WIDE = re.compile(r"\d{5,}|\*")
_FIELD = re.compile(r"[A-Za-z_0-9]*(![rsa])?(:[^{}]*)?")


def format_text(text: str, values: Any) -> str:
    """`text % values`, without widths that take the memory."""
    if _WIDE.search(text):
        raise TooLarge("the width is too large")
    return cleaned(text % values)


def _format(text: str, *values: Any, **named: Any) -> str:
    """`text.format(...)` with plain fields: no attributes, items or computed widths."""
    for field in re.findall(r"\{([^{}]*)", text.replace("{{", "").replace("}}", "")):
        if not _FIELD.fullmatch(field):
            raise TooLarge(f"the format field `{field}` is not evaluated")
    if _WIDE.search(text):
        raise TooLarge("the width is too large")
    return cleaned(text.format(*values, **named))


def _power(base: Any, exponent: Any, *modulus: Any) -> Any:
    if isinstance(base, int) and isinstance(exponent, int) and base.bit_length() * max(exponent, 0) > MAX_BITS:
        raise TooLarge("the number is too large")
    return pow(base, exponent, *modulus)


def _round(number: Any, digits: Any = None) -> Any:
    return round(number, digits) if digits is None or abs(digits) < MAX_ARGUMENT else number


_QUICK_GROWING = ("comb", "factorial", "perm")
MATH: dict[str, Any] = {
    **{name: value for name, value in vars(math).items() if not name.startswith("_") and name not in _QUICK_GROWING},
    **{name: _small(getattr(math, name)) for name in _QUICK_GROWING},
    "true": True,
    "false": False,
}
BUILTINS: dict[str, Any] = {
    **{f.__name__: f for f in (abs, all, any, bool, dict, divmod, float, hex, int, len, list, max, min, oct, ord, repr)},
    **{f.__name__: f for f in (set, sorted, str, sum, tuple)},
    "bin": bin,
    "chr": lambda number: cleaned(chr(number)),
    "map": lambda function, *items: [function(*each) for each in zip(*items, strict=False)],
    "pow": _power,
    "range": _small(range),
    "round": _round,
    "zip": lambda *items: list(zip(*items, strict=False)),
    "enumerate": lambda items, start=0: list(enumerate(items, start)),
    "reversed": lambda items: list(reversed(items)),
}
_PLAIN_TEXT = (
    *(
        "capitalize",
        "casefold",
        "count",
        "endswith",
        "find",
        "index",
        "isalnum",
        "isalpha",
        "isdecimal",
        "isdigit",
        "isidentifier",
        "islower",
    ),
    *("isnumeric", "isspace", "istitle", "isupper", "lower", "lstrip", "partition", "rfind", "rindex", "rpartition", "rsplit", "rstrip"),
    *("split", "splitlines", "startswith", "strip", "swapcase", "title", "upper"),
)
METHODS: dict[type, dict[str, Function]] = {
    str: {
        **{name: getattr(str, name) for name in _PLAIN_TEXT},
        **{name: _small(getattr(str, name)) for name in ("center", "expandtabs", "ljust", "rjust", "zfill")},
        "format": _format,
        "join": lambda text, items: text.join(_joinable(text, items)),
        "replace": lambda text, old, new, *count: _replace(text, old, new, *count),
    },
    list: {name: getattr(list, name) for name in ("append", "clear", "copy", "count", "index", "insert", "pop", "remove", "reverse")},
    tuple: {name: getattr(tuple, name) for name in ("count", "index")},
    dict: {
        "get": dict.get,
        "items": lambda mapping: list(mapping.items()),
        "keys": lambda mapping: list(mapping.keys()),
        "values": lambda mapping: list(mapping.values()),
    },
    int: {"bit_length": int.bit_length},
    float: {name: getattr(float, name) for name in ("is_integer", "hex")},
}


def _joinable(text: str, items: Any) -> list[Any]:
    parts = list(items)
    if sum(len(part) for part in parts) + len(text) * len(parts) > MAX_SIZE:
        raise TooLarge("the text is too large")
    return parts


def _replace(text: str, old: str, new: str, *count: Any) -> str:
    if (text.count(old) + 1) * len(new) + len(text) > MAX_SIZE:
        raise TooLarge("the text is too large")
    return text.replace(old, new, *count)
