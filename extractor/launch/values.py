"""Text to parameter values, as roslaunch converts them."""

from __future__ import annotations

from typing import Any

from rosarch.base.diagnostics import shortened
from rosarch.extractor.launch.unknowns import is_known


class Binary(bytes):
    """The content of a `binfile`, or of a YAML `!!binary`."""


def automatic(text: str) -> Any:
    """`text` as the number or Boolean it looks like."""
    try:
        if "." in text:
            return float(text)
        if "_" not in text:
            return int(text)
    except ValueError:
        pass
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    return text


def boolean(text: str) -> bool:
    """`true`, `1`, `false` or `0` in any case.

    Raises:
        ValueError: it is none of them.
    """
    lowered = text.lower().strip()
    if lowered in ("true", "1"):
        return True
    if lowered in ("false", "0"):
        return False
    raise ValueError(f"`{text}` is not a Boolean")


def convert(text: str, kind: str) -> Any:
    """`text` as a value of type `kind`: int, double, str, bool or auto (`yaml` is converted where YAML is read).

    A text with unknown parts stays as it is.

    Raises:
        ValueError: the text is no such value, or there is no such type.
    """
    kind = kind.lower()
    if kind not in _KINDS:
        raise ValueError(f"unknown type `{kind}`")
    if kind in ("str", "string") or not is_known(text):
        return text
    if kind == "auto":
        return automatic(text)
    if kind in ("bool", "boolean"):
        return boolean(text)
    try:
        return int(text) if kind == "int" else float(text)
    except ValueError:
        raise ValueError(f"`{shortened(text, 40)}` is not {'an int' if kind == 'int' else 'a double'}") from None


_KINDS = frozenset({"auto", "str", "string", "int", "double", "bool", "boolean", "yaml"})
