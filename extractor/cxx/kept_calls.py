"""Which calls clang found in two parses of a unit, and whether the second is to replace the first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.libclang_library import Cursor
from rosarch.extractor.cxx.unit import Span, UnitFacts

_GAIN = 4

CallPlaces = Counter[tuple[str, int]]


def keeps_calls(first: CallPlaces, healed: CallPlaces) -> bool:
    """Whether of the calls that clang had found in the first place none is lost, or few, and many more are found."""
    return (first - healed).total() * _GAIN <= (healed - first).total()


def call_places(facts: UnitFacts, declarations: Iterable[Cursor]) -> CallPlaces:
    """How many calls begin where in files of the workspace."""
    places: CallPlaces = Counter()
    for declaration in declarations:
        if facts.locate(libclang.location(declaration))[0].key is None:
            continue
        for call in libclang.calls_below(declaration):
            span = facts.span(call)
            if not _is_operator(facts, call, span):
                places[str(span.file.path), span.begin] += 1
    return places


def _is_operator(facts: UnitFacts, call: Cursor, span: Span) -> bool:
    """Whether clang takes an operator for a call: where it does not know which, nothing opens after the first operand."""
    name = libclang.spelling(call)
    if name:
        return name.startswith("operator") and name != "operator()"
    callee = facts.span(next(iter(libclang.children(call)), call))
    return span.file.data[callee.end : span.end].lstrip()[:1] not in (b"(", b"{", b"<")
