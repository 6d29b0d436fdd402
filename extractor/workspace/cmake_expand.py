"""Variable references, escapes, lists and generator expressions.

Sources: cmake-language(7) "Variable References", "Escape Sequences", "Lists"; cmake-generator-expressions(7).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

Lookup = Callable[[str, str], str]
"""From the reference's kind (`""`, `ENV`, `CACHE`) and name to its value."""

_ESCAPES = {"n": "\n", "t": "\t", "r": "\r"}
_PIECE = re.compile(r"\\(.)|\$(ENV|CACHE|)\{|([{}])", re.DOTALL)


def expand(text: str, lookup: Lookup) -> str:
    r"""Replace references and escapes. `\;` stays escaped: in unquoted text it must not split a list."""
    if "$" not in text and "\\" not in text:
        return text
    open_references: list[tuple[str, str, list[str]]] = []  # how each is written, its kind, and what stands before it
    pieces: list[str] = []
    depths = [0]
    position = 0
    for match in _PIECE.finditer(text):
        pieces.append(text[position : match.start()])
        position = match.end()
        escaped, kind, brace = match.groups()
        if escaped is not None:
            pieces.append(_escape(escaped))
        elif kind is not None:
            open_references.append((match.group(), kind, pieces))
            pieces = []
            depths.append(0)
        elif brace == "}" and open_references and not depths[-1]:
            _, kind, before = open_references.pop()
            depths.pop()
            before.append(lookup(kind, "".join(pieces)))
            pieces = before
        else:
            depths[-1] += 1 if brace == "{" else -1
            pieces.append(brace)
    pieces.append(text[position:])
    return "".join([part for written, _, before in open_references for part in (*before, written)] + pieces)


def _escape(character: str) -> str:
    if character == ";":
        return "\\;"
    if character == "\n":
        return ""
    return _ESCAPES.get(character, character)


def split_list(text: str, keep_empty: bool = False) -> list[str]:
    r"""The elements of a CMake list; `\;` and `;` within brackets do not separate."""
    if ";" not in text:
        return [text] if text or keep_empty else []
    if "\\" not in text and "[" not in text:
        return text.split(";") if keep_empty else [element for element in text.split(";") if element]
    result: list[str] = []
    current: list[str] = []
    depth = 0
    position = 0
    while position < len(text):
        character = text[position]
        if character == "\\" and text[position + 1 : position + 2] == ";":
            current.append(";")
            position += 2
            continue
        if character == ";" and depth == 0:
            result.append("".join(current))
            current = []
        else:
            depth += (character == "[") - (character == "]")
            depth = max(depth, 0)
            current.append(character)
        position += 1
    result.append("".join(current))
    return result if keep_empty else [element for element in result if element]


def join_list(elements: Iterable[str]) -> str:
    """A CMake list of `elements`."""
    return ";".join(elements)


_TRUE = frozenset({"1", "ON", "YES", "TRUE", "Y"})
_FALSE = frozenset({"", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"})
_NUMBER = re.compile(r"[+-]?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?$")


def is_true(text: str) -> bool | None:
    """What a constant means in a condition; None when `text` is not a constant (cmake command `if`, "Basic Expressions")."""
    upper = text.upper()
    if upper in _TRUE:
        return True
    if upper in _FALSE or upper.endswith("-NOTFOUND"):
        return False
    if _NUMBER.match(text):
        return float(text) != 0
    return None


def generator_expression(text: str) -> str:
    """Evaluate the generator expressions whose value does not need a build; others stay as written.

    Linux, GCC, C++, no build type, in the build tree: the way a developer's machine sees a package.
    """
    while True:
        start = text.rfind("$<")
        if start < 0:
            return _restore(text)
        end = _closing_angle(text, start + 2)
        if end < 0:
            return _restore(text)
        text = text[:start] + _evaluate(text[start + 2 : end]) + text[end + 1 :]


_KEPT_OPEN, _KEPT_CLOSE = "\x01", "\x02"


def _restore(text: str) -> str:
    return text.replace(_KEPT_OPEN, "$<").replace(_KEPT_CLOSE, ">")


def _closing_angle(text: str, start: int) -> int:
    return text.find(">", start)


_UNCHANGED = frozenset({"BUILD_INTERFACE", "BUILD_LOCAL_INTERFACE", "LINK_ONLY", "TARGET_NAME_IF_EXISTS", "TARGET_NAME", "1", "GENEX_EVAL"})
_DROPPED = frozenset({"INSTALL_INTERFACE", "0"})
_PLATFORM = {
    "PLATFORM_ID": "Linux", "CXX_COMPILER_ID": "GNU", "C_COMPILER_ID": "GNU", "COMPILE_LANGUAGE": "CXX",
    "LINK_LANGUAGE": "CXX", "CONFIG": "",
}  # fmt: skip


def _evaluate(body: str) -> str:
    name, colon, rest = body.partition(":")
    if name in _UNCHANGED:
        return rest
    if name in _DROPPED:
        return ""
    if name in _PLATFORM:
        return "01"[_PLATFORM[name] in rest.split(",")] if colon else _PLATFORM[name]
    if name == "COMPILE_LANG_AND_ID":
        language, *compilers = rest.split(",")
        return "01"[language == "CXX" and "GNU" in compilers]
    value = _logic(name, rest)
    return f"{_KEPT_OPEN}{body}{_KEPT_CLOSE}" if value is None else value


def _logic(name: str, rest: str) -> str | None:
    parts = rest.split(",")
    if name == "BOOL":
        return "01"[is_true(rest) is not False]
    if name == "NOT":
        return "10"[rest == "1"]
    if name == "AND":
        return "01"[all(part == "1" for part in parts)]
    if name == "OR":
        return "01"["1" in parts]
    if name in ("STREQUAL", "EQUAL") and len(parts) == 2:
        return "01"[parts[0] == parts[1]]
    if name == "IF" and len(parts) >= 3:
        return parts[1] if parts[0] == "1" else ",".join(parts[2:])
    if name in ("SEMICOLON", "COMMA", "ANGLE-R"):
        return {"SEMICOLON": ";", "COMMA": ",", "ANGLE-R": _KEPT_CLOSE}[name]
    if name in ("LOWER_CASE", "UPPER_CASE"):
        return rest.lower() if name == "LOWER_CASE" else rest.upper()
    return None
