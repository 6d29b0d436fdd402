"""Deriving again after an edit gives the rows of the whole program."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from rosarch.datalog import DatalogError
from rosarch.datalog.engine.rederive import Edit, Part, RuleHistory

BASE = """\
.decl edge(x: symbol, y: symbol)
.input edge
.decl path(x: symbol, y: symbol)
path(X, Y) :- edge(X, Y).
path(X, Z) :- path(X, Y), edge(Y, Z).
.decl reverse(x: symbol, y: symbol) inline
reverse(X, Y) :- path(Y, X).
.decl node(x: symbol)
node(X) :- edge(X, _).
node(X) :- edge(_, X).
.decl pair(x: symbol, y: symbol)
pair(X, Y) :- node(X), node(Y).
.decl lone(x: symbol)
lone(X) :- node(X), !path(X, X).
"""
FACTS = {"edge": [("a", "b"), ("b", "c"), ("c", "b"), ("c", "d")]}


def rederived(history: RuleHistory, base: dict[str, list[tuple[str, ...]]], edit: Edit) -> dict[str, list[tuple[str, ...]]]:
    """The rows after an edit: those of the affected relations, the others as they were."""
    if edit.first is None:
        return base
    first, whole = (derived(part, base) for part in (edit.first, edit.part(edit.affected)))
    if all(base.get(name) == rows for name, rows in first.items()):
        assert all(base.get(name) == rows for name, rows in whole.items())  # all others have the rows that they had
    return {**base, **whole}


def derived(part: Part, base: dict[str, list[tuple[str, ...]]]) -> dict[str, list[tuple[str, ...]]]:
    found = part.program.evaluate({name: base[name] for name in part.needed}, keep=part.names)
    return {name: found.rows(name) for name in found.names()}


def rows_of(program: object, facts: object) -> dict[str, list[tuple[str, ...]]]:
    result = program.evaluate(facts, keep="all")  # type: ignore[attr-defined]
    return result.all_rows()


def start(tmp_path: Path, text: str = BASE) -> tuple[Path, RuleHistory, dict[str, list[tuple[str, ...]]]]:
    file = tmp_path / "rules.dl"
    file.write_text(text)
    history = RuleHistory([file])
    return file, history, rows_of(history.whole(), FACTS)


def test_only_what_is_reached_is_derived_again(tmp_path: Path) -> None:
    """A new clause affects its relation and what reads it; comments and blank lines affect nothing."""
    file, history, base = start(tmp_path)
    file.write_text("// a comment\n\n" + BASE)
    edit = history.edit()
    assert edit is not None and edit.first is None and not edit.affected

    file.write_text(BASE + 'lone("z").\n')
    edit = history.edit()
    assert edit is not None and edit.first and edit.affected == {"lone"} and edit.first.needed == {"node", "path"}
    assert rederived(history, base, edit)["lone"] == [("a",), ("d",), ("z",)]


def test_relations_come_and_go(tmp_path: Path) -> None:
    """A new relation reads old ones, through inline ones too; a removed one is not derived any more."""
    file, history, base = start(tmp_path)
    file.write_text(BASE + '.decl back(x: symbol)\nback(X) :- reverse(X, "a").\n')
    edit = history.edit()
    assert edit is not None and edit.first and edit.affected == {"back"} and edit.first.needed == {"path"}
    assert rederived(history, base, edit)["back"] == [("b",), ("c",), ("d",)]

    file.write_text(BASE.replace(".decl pair(x: symbol, y: symbol)\npair(X, Y) :- node(X), node(Y).\n", ""))
    edit = history.edit()
    assert edit is not None and not edit.affected and edit.first is None


def test_what_cannot_be_told_apart_is_derived_as_a_whole(tmp_path: Path) -> None:
    """A changed type is no edit of a part."""
    file, history, _ = start(tmp_path)
    file.write_text(BASE + ".type T <: symbol\n")
    assert history.edit() is None


def test_what_leads_to_relations(tmp_path: Path) -> None:
    """Of what an edit reaches, only that is derived which leads to what is asked for; at first what was edited, with what is recursive with it."""
    file, history, _ = start(tmp_path)
    file.write_text(BASE.replace("path(X, Y) :- edge(X, Y).", "path(X, Y) :- edge(X, Y), X != Y."))
    edit = history.edit()
    assert edit is not None and edit.first is not None
    assert (edit.affected, edit.first.names) == ({"path", "reverse", "lone"}, {"path"})
    assert (edit.leading_to(["lone"]), edit.leading_to(["pair"])) == ({"path", "lone"}, set())
    file.write_text(
        BASE.replace("reverse(X, Y) :- path(Y, X).", "reverse(X, Y) :- path(X, Y).") + ".decl end(x: symbol)\nend(X) :- reverse(X, _).\n"
    )
    history = RuleHistory([file])
    history.whole()
    file.write_text(file.read_text().replace("path(X, Y).", "path(Y, X)."))
    edit = history.edit()
    assert edit is not None and edit.first is not None and edit.first.names == {"reverse", "end"}  # as it is inlined


@pytest.mark.parametrize(
    ("added", "message"),
    [
        ("lone(X) :- nod(X).", "15:12: unknown relation `nod`, did you mean `node`?"),
        ("lon(X) :- node(X).", "15:1: unknown relation `lon`, did you mean `lone`?"),
        ("lone(X) :- node(X)", "syntax error, unexpected end of file"),
        ("node(X) :- node(X), !lone(X).", "cycl"),
        (".decl lone(x: symbol)", "relation `lone` is already declared"),
    ],
)
def test_errors_are_those_of_the_whole_program(tmp_path: Path, added: str, message: str) -> None:
    """A wrong edit is refused with its place, and the next right one works."""
    file, history, base = start(tmp_path)
    file.write_text(BASE + added + "\n")
    with pytest.raises(DatalogError) as caught:
        _ = history.edit() or history.whole()
    with pytest.raises(DatalogError) as whole:
        RuleHistory([file]).whole()
    assert message in str(caught.value) and str(caught.value) == str(whole.value)
    file.write_text(BASE + 'lone("z").\n')
    edit = history.edit()
    assert edit is not None and ("z",) in rederived(history, base, edit)["lone"]


@pytest.mark.slow
def test_random_edits(tmp_path: Path) -> None:
    """Any subset of the clauses gives, from the rows of any other, what it gives from nothing."""
    chance = random.Random(7)
    lines = BASE.splitlines(keepends=True)
    clauses = [i for i, line in enumerate(lines) if not line.startswith(".")]
    sliced = 0
    for _ in range(60):
        keep = [set(chance.sample(clauses, chance.randint(3, len(clauses)))) for _ in range(2)]
        texts = ["".join(line for i, line in enumerate(lines) if i not in clauses or i in kept) for kept in keep]
        file, history, base = start(tmp_path, texts[0])
        file.write_text(texts[1])
        edit = history.edit()
        if edit is not None:
            sliced += 1
            assert rederived(history, base, edit) == rows_of(RuleHistory([file]).whole(), FACTS)
    assert sliced > 10
