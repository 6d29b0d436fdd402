"""The CMake command `string` (https://cmake.org/cmake/help/latest/command/string.html)."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Callable

from rosarch.extractor.workspace.cmake_expand import join_list
from rosarch.extractor.workspace.cmake_regex import compile_regex, find_all, replace
from rosarch.extractor.workspace.cmake_state import Call
from rosarch.extractor.workspace.evaluator import Evaluator, command


@command("string")
def _string(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    name = call.args[0]
    if name == "REGEX" and len(call.args) > 1:
        name = f"REGEX {call.args[1]}"
    rest = call.args[1 + name.startswith("REGEX ") :]
    handler = _STRING.get(name)
    if handler is None:
        if name.upper() not in _HASHES:
            run.complain(call.command, "unknown-command", f"unknown command string({name})")
            return
        run.set(rest[0], hashlib.new(name.lower().replace("sha3_", "sha3-"), os.fsencode(rest[1])).hexdigest())
        return
    try:
        handler(run, rest)
    except (IndexError, ValueError, OverflowError) as error:
        run.complain(call.command, "cmake-arguments", f"string({name}): {error}")


_HASHES = {"MD5", "SHA1", "SHA224", "SHA256", "SHA384", "SHA512"}


def _replace(run: Evaluator, rest: list[str]) -> None:
    text = "".join(rest[3:])
    run.charge(text.count(rest[0]) * len(rest[1]))
    run.set(rest[2], text.replace(rest[0], rest[1]))


def _regex_match(run: Evaluator, rest: list[str]) -> None:
    found = compile_regex(rest[0]).search("".join(rest[2:]))
    run.set(rest[1], found[0] if found else "")
    if found:
        run.set_matches(found)


def _regex_match_all(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[1], join_list(find_all(rest[0], "".join(rest[2:]))))


def _regex_replace(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[2], replace(rest[0], rest[1], "".join(rest[3:]), run.charge))


def _find(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[2], str(rest[0].rfind(rest[1]) if "REVERSE" in rest[3:] else rest[0].find(rest[1])))


def _substring(run: Evaluator, rest: list[str]) -> None:
    begin, length = int(rest[1]), int(rest[2])
    run.set(rest[3], rest[0][begin : None if length < 0 else begin + length])


_COMPARISONS: dict[str, Callable[[str, str], bool]] = {
    "EQUAL": lambda a, b: a == b,
    "NOTEQUAL": lambda a, b: a != b,
    "LESS": lambda a, b: a < b,
    "GREATER": lambda a, b: a > b,
    "LESS_EQUAL": lambda a, b: a <= b,
    "GREATER_EQUAL": lambda a, b: a >= b,
}


def _compare(run: Evaluator, rest: list[str]) -> None:
    if rest[0] not in _COMPARISONS:
        raise ValueError(f"unknown comparison {rest[0]}")
    run.set(rest[3], "01"[_COMPARISONS[rest[0]](rest[1], rest[2])])


def _configure(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[1], configure(run, rest[0], "@ONLY" in rest[2:]))


_AT = re.compile(r"@([A-Za-z0-9_./+-]+)@")
_BRACES = re.compile(r"\$\{([A-Za-z0-9_./+-]+)\}")


def configure(run: Evaluator, text: str, at_only: bool) -> str:
    """Replace `@VAR@` and, unless `at_only`, `${VAR}`."""
    text = _AT.sub(lambda match: run.lookup("", match.group(1)), text)
    return text if at_only else _BRACES.sub(lambda match: run.lookup("", match.group(1)), text)


def _concat(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[0], "".join(rest[1:]))


def _append(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[0], (run.get(rest[0]) or "") + "".join(rest[1:]))


def _prepend(run: Evaluator, rest: list[str]) -> None:
    run.set(rest[0], "".join(rest[1:]) + (run.get(rest[0]) or ""))


def _join(run: Evaluator, rest: list[str]) -> None:
    run.charge(len(rest[0]) * len(rest[2:]))
    run.set(rest[1], rest[0].join(rest[2:]))


def _repeat(run: Evaluator, rest: list[str]) -> None:
    run.charge(len(rest[0]) * int(rest[1]))
    run.set(rest[2], rest[0] * int(rest[1]))


def _make_c_identifier(run: Evaluator, rest: list[str]) -> None:
    name = re.sub(r"[^A-Za-z0-9_]", "_", rest[0])
    run.set(rest[1], "_" + name if name[:1].isdigit() else name)


def _constant(value: str) -> Callable[[Evaluator, list[str]], None]:
    return lambda run, rest: run.set(rest[0], value)


def _ascii(run: Evaluator, rest: list[str]) -> None:
    codes = [int(code) for code in rest[:-1]]
    if wrong := [code for code in codes if not 0 < code < 256]:
        raise ValueError(f"character with code {wrong[0]} does not exist")
    run.set(rest[-1], "".join(map(chr, codes)))


_STRING: dict[str, Callable[[Evaluator, list[str]], None]] = {
    "REPLACE": _replace,
    "REGEX MATCH": _regex_match,
    "REGEX MATCHALL": _regex_match_all,
    "REGEX REPLACE": _regex_replace,
    "FIND": _find,
    "SUBSTRING": _substring,
    "COMPARE": _compare,
    "CONFIGURE": _configure,
    "CONCAT": _concat,
    "APPEND": _append,
    "PREPEND": _prepend,
    "JOIN": _join,
    "MAKE_C_IDENTIFIER": _make_c_identifier,
    "TOUPPER": lambda run, rest: run.set(rest[1], rest[0].upper()),
    "TOLOWER": lambda run, rest: run.set(rest[1], rest[0].lower()),
    "LENGTH": lambda run, rest: run.set(rest[1], str(len(os.fsencode(rest[0])))),
    "STRIP": lambda run, rest: run.set(rest[1], rest[0].strip()),
    "GENEX_STRIP": lambda run, rest: run.set(rest[1], re.sub(r"\$<[^>]*>", "", rest[0])),
    "REPEAT": _repeat,
    "ASCII": _ascii,
    "TIMESTAMP": _constant("1970-01-01T00:00:00"),
    "RANDOM": lambda run, rest: run.set(rest[-1], "00000"),
    "UUID": _constant("00000000-0000-0000-0000-000000000000"),
}
