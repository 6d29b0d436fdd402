"""`.pragma "override"`, and files that an `.include` takes instead of others."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from rosarch.datalog import DatalogError, load_program

BASE = """.decl edge(a: symbol, b: symbol)
edge("a", "b"). edge("b", "c").
.decl path(a: symbol, b: symbol)
.output path
path(X, Y) :- edge(X, Y).   // "path(" in a comment. And 1.5
path(X, Z) :-
    path(X, Y), edge(Y, Z), "." != "path(X).".
.decl far(a: symbol)
.output far
far(X) :- path(X, "c").
"""
ENGINES = [
    "embedded",
    pytest.param("souffle", marks=pytest.mark.skipif(shutil.which("souffle") is None, reason="there is no souffle on PATH")),
]


@pytest.fixture
def base(tmp_path: Path) -> Path:
    path = tmp_path / "base.dl"
    path.write_text(BASE, encoding="utf-8")
    return path


def own(tmp_path: Path, text: str, name: str = "own.dl") -> Path:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("engine", ENGINES)
def test_the_clauses_of_other_files_are_dropped(base: Path, tmp_path: Path, engine: str) -> None:
    file = own(tmp_path, '.pragma "override" "path"\npath(Y, X) :- edge(X, Y).\n')
    program = load_program([base, file])
    result = program.evaluate({}, engine=engine)
    assert result.rows("path") == [("b", "a"), ("c", "b")]
    assert result.rows("far") == []
    (told,) = program.overridden
    assert (told.relation, told.location.line, [place.line for place in told.dropped]) == ("path", 1, [5, 6])


def test_it_is_as_before_without(base: Path) -> None:
    program = load_program(base)
    assert program.overridden == ()
    assert program.evaluate({}).rows("path") == [("a", "b"), ("a", "c"), ("b", "c")]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('.pragma "override" "pth"\n', 'own.dl:1:9: `pth` is overridden, but there is no such relation, did you mean `path`?'),
        ('.pragma "override" "new"\n.decl new(a: symbol)\nnew("a").\n', "own.dl:1:9: `new` is overridden, but no other file has clauses of it"),
    ],
)  # fmt: skip
def test_errors(base: Path, tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(DatalogError) as raised:
        load_program([base, own(tmp_path, text)])
    assert raised.value.diagnostics[0].headline == f"{tmp_path}/{message}"


def test_two_files_cannot_override_one_relation(base: Path, tmp_path: Path) -> None:
    first, second = (own(tmp_path, '.pragma "override" "far, path"\nfar("x"). path("x", "x").\n', name) for name in ("one.dl", "two.dl"))
    with pytest.raises(DatalogError) as raised:
        load_program([base, first, second])
    assert raised.value.diagnostics[0].headline == f"{second}:1:9: `far` is overridden in `{first}` already"


def test_an_include_takes_another_file(tmp_path: Path) -> None:
    own(tmp_path, '.decl said(what: symbol)\n.output said\n.include "part.dl"\n', "root.dl")
    part, other = own(tmp_path, 'said("part").\n', "part.dl"), own(tmp_path, 'said("other").\n', "other.dl")
    assert load_program(tmp_path / "root.dl").evaluate({}).rows("said") == [("part",)]
    assert load_program(tmp_path / "root.dl", instead={part: other}).evaluate({}).rows("said") == [("other",)]
