"""The relation reference."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.datalog import Program, reference, reference_text
from rosarch.datalog.inspection.relation_reference import list_text

SOURCE = """/// `a` is joined to `b`; in one direction. Must.
.decl edge(a: symbol, b: symbol)
.input edge
/// `b` can be reached from `a`. Must.
.decl path(a: symbol, b: symbol)
.output path
path(X, Y) :- _step(X, Y).
path(X, Z) :- path(X, Y), _step(Y, Z).
.decl _step(a: symbol, b: symbol)
_step(X, Y) :- edge(X, Y), !_barred(Y).
.decl _barred(a: symbol)
_barred("x").
.decl even(x: number)
.decl odd(x: number)
even(0).
even(X + 1) :- odd(X), X < 9.
odd(X + 1) :- even(X), X < 9.
"""


def name(path: str) -> str:
    return Path(path).name


def test_entries(load: Callable[[str], Program]) -> None:
    found = {e.name: e for e in reference(load(SOURCE))}
    assert (found["path"].uses, found["path"].used_by, found["path"].recursive_with) == (("edge",), (), ("path",))
    assert (found["edge"].uses, found["edge"].used_by, found["edge"].kind) == ((), ("path",), "input")
    assert (found["even"].recursive_with, found["even"].rules, found["even"].facts) == (("even", "odd"), 1, 1)
    assert (found["_barred"].kind, found["_barred"].private) == ("facts", True)


def test_markdown(load: Callable[[str], Program]) -> None:
    assert (
        reference_text(reference(load(SOURCE)), shorten=name)
        == """# Relations

- [p.dl](#pdl): [`edge`](#edge), [`path`](#path), [`even`](#even), [`odd`](#odd)

## p.dl

### edge

`edge(a: symbol, b: symbol)` · input, line 2

`a` is joined to `b`; in one direction. Must.

- Used by: [`path`](#path)

### path

`path(a: symbol, b: symbol)` · output, line 5

`b` can be reached from `a`. Must.

- Uses: [`edge`](#edge)
- Recursive with: itself

### even

`even(x: number)` · derived, line 13

- Uses: [`odd`](#odd)
- Used by: [`odd`](#odd)
- Recursive with: [`odd`](#odd)

### odd

`odd(x: number)` · derived, line 14

- Uses: [`even`](#even)
- Used by: [`even`](#even)
- Recursive with: [`even`](#even)
"""
    )


def test_private_relations_on_request(load: Callable[[str], Program]) -> None:
    assert "### _step" in reference_text(reference(load(SOURCE)), private=True)


def test_list(load: Callable[[str], Program]) -> None:
    assert list_text(reference(load(SOURCE))[:2], shorten=name) == (
        "input    edge(a: symbol, b: symbol)  p.dl:2\n         `a` is joined to `b`\n"
        "output   path(a: symbol, b: symbol)  p.dl:5\n         `b` can be reached from `a`.\n"
    )


@pytest.mark.slow
def test_every_rule_of_rosarch_has_its_text() -> None:
    from rosarch.datalog import load_program
    from rosarch.datalog.inspection.clauses import rules_of
    from rosarch.extractor.manifest import rules_folder

    rules = rules_of(load_program(rules_folder() / "component.dl"))
    assert [r.place for r in rules.all if not (r.text.endswith(").") or r.text.endswith((".", '".'))) or "\n" in r.text] == []
    assert {r.text.split("(")[0] for r in rules.by_head["port"]} == {"port"}
