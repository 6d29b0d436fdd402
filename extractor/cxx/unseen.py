"""What of a unit's files clang does not see as their reader does: macros of absent headers, and bodies of functions that it lost."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.libclang_library import Location
from rosarch.extractor.cxx.recover import hide
from rosarch.extractor.cxx.undefined_macros import Macros, undefined_macros
from rosarch.extractor.cxx.unit import SourceFile, UnitFacts

_ERROR = 3
_CALL = re.compile(rb"\b([A-Za-z_]\w*)\s*(?:<[^;{}()]*>\s*)?\(")


@dataclass(frozen=True)
class Unseen:
    """What the texts of files say about macros that nothing defines; `defined` are those that are defined."""

    files: tuple[tuple[SourceFile, Macros], ...]
    defined: Set[str]

    def bodies(self, unknown: str) -> dict[str, str]:
        """See `Macros.bodies`."""
        return {name: body for _, macros in self.files for name, body in macros.bodies(unknown).items()}

    def add_facts(self, facts: UnitFacts, parsed: libclang.Unit) -> None:
        """Add what the walk of `parsed` did not meet: macros that stand for something, bodies of functions, and what these call."""
        met: dict[int, set[int]] = {}
        for function in facts.functions:
            met.setdefault(id(function.file), set()).add(function.begin)
        errors: Mapping[str, list[tuple[int, str]]] | None = None
        for file, macros in self.files:
            for use in macros.uses:
                facts.add("macro_undefined", str(file.key), file.line_column(use.offset)[0], use.name, use.scope)
            for begin, end in macros.bodies_of_functions:
                if begin not in met.get(id(file), ()):
                    errors = _errors(facts, parsed) if errors is None else errors
                    reason = _cause(errors.get(str(file.path), []), end)
                    facts.add("source_lost", str(file.key), file.line_column(begin)[0], file.line_column(end)[0], reason)
                    for call in _CALL.finditer(hide(file.data[begin:end])):
                        facts.add("lost_call", str(file.key), file.line_column(begin + call.start())[0], call.group(1).decode())


def unseen(facts: UnitFacts, parsed: libclang.Unit, paths: Iterable[str]) -> Unseen:
    """What the files of the workspace among `paths` use and `parsed`, which has read them, does not define."""
    macros = (cursor for cursor in libclang.children(parsed.cursor) if cursor.kind in (kinds.MACRO_DEFINITION, kinds.MACRO_EXPANSION))
    defined = frozenset(map(libclang.spelling, macros))
    skipped: dict[str, list[tuple[int, int]]] = {}
    for place in parsed.skipped_ranges():
        file, begin = facts.locate(Location(place.p0, place.p1, place.begin))
        _, end = facts.locate(Location(place.p0, place.p1, place.end))
        skipped.setdefault(str(file.path), []).append((begin, end))
    found = []
    for path in sorted(paths):
        file = facts.file(path)
        if file.key:
            text = file.data
            for begin, end in skipped.get(path, ()):
                text = text[:begin] + re.sub(rb"[^\n]", b" ", text[begin:end]) + text[end:]
            found.append((file, undefined_macros(text, hide(text), defined)))
    return Unseen(tuple(found), defined)


def _errors(facts: UnitFacts, parsed: libclang.Unit) -> Mapping[str, list[tuple[int, str]]]:
    """Where clang had trouble, and why, by file."""
    found: dict[str, list[tuple[int, str]]] = {}
    for severity, message, place in parsed.diagnostics:
        if severity >= _ERROR:
            file, offset = facts.locate(place)
            found.setdefault(str(file.path), []).append((offset, message))
    return {path: sorted(errors) for path, errors in found.items()}


def _cause(errors: list[tuple[int, str]], end: int) -> str:
    """The last error before the end of what is lost."""
    index = bisect_right(errors, (end, "\uffff"))
    return errors[index - 1][1] if index else "not in the syntax tree"
