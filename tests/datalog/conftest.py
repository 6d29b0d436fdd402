"""Fixtures for the Datalog tests."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

from rosarch.datalog import DatalogError, Program, load_program

Rows = Mapping[str, Iterable[tuple[Any, ...]]]


@pytest.fixture
def load(tmp_path: Path) -> Callable[[str], Program]:
    """Load a program from its text; the file is called `p.dl`."""

    def load_text(source: str) -> Program:
        path = tmp_path / "p.dl"
        path.write_text(source, encoding="utf-8")
        return load_program(path)

    return load_text


@pytest.fixture
def rows(load: Callable[[str], Program]) -> Callable[..., list[tuple[Any, ...]]]:
    """The rows of relation `r` of a program."""

    def evaluate(source: str, facts: Rows | None = None) -> list[tuple[Any, ...]]:
        return load(source).evaluate(facts or {}, keep=["r"]).rows("r")

    return evaluate


@pytest.fixture
def errors(load: Callable[[str], Program], tmp_path: Path) -> Callable[[str], str]:
    """The full text of the errors of a program, without the folder in front of `p.dl`."""

    def message(source: str) -> str:
        with pytest.raises(DatalogError) as caught:
            load(source)
        return str(caught.value).replace(f"{tmp_path}/", "")

    return message


GRAPH = """.decl edge(a: symbol, b: symbol)
.input edge
.decl blocked(a: symbol)
.input blocked
/// `b` can be reached from `a`. Must.
.decl path(a: symbol, b: symbol)
.output path
path(X, Y) :- edge(X, Y), !blocked(Y).
path(X, Z) :- path(X, Y), edge(Y, Z), !blocked(Z), X != Z.
.decl degree(a: symbol, n: number)
degree(X, N) :- edge(X, _), N = count : { edge(X, _) }.
.decl hub(a: symbol, next: number)
hub(X, N + 1) :- degree(X, N), N >= max M : { degree(_, M) }.
.decl start(a: symbol)
start("a").
"""


@pytest.fixture
def graph(load: Callable[[str], Program]) -> Program:
    """Paths in a graph: recursion, negation, aggregates."""
    return load(GRAPH)


@pytest.fixture
def graph_facts() -> dict[str, list[tuple[str, ...]]]:
    """A cycle a, b, c, and c to d to e, which is blocked."""
    return {"edge": [("a", "b"), ("b", "c"), ("c", "a"), ("c", "d"), ("d", "e")], "blocked": [("e",)]}
