"""What rules keep to besides being legal."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.datalog import load_program
from rosarch.datalog.inspection.conventions import unconventional

FACTS = """\
/// `x` is there. Must.
.decl given(x: symbol)
.input given
/// `x` may be there. May.
.decl guessed(x: symbol)
.input guessed
/// `x` is asked for. Demand.
.decl asked(x: symbol)
.input asked
/// `x` is on the list.
.decl listed(x: symbol)
listed("a").
"""
OUT = ".output own\n"


def messages(tmp_path: Path, text: str) -> list[str]:
    (tmp_path / "facts.dl").write_text(FACTS)
    own = tmp_path / "own.dl"
    own.write_text('.include "facts.dl"\n' + text)
    program = load_program(own)
    return [f"{d.location.line if d.location else 0}: {d.message}" for d in unconventional(program, str(own).__eq__)]


@pytest.mark.parametrize(
    "text",
    [
        "/// `x` is there and listed. Must.\n.decl own(x: symbol)\nown(X) :- given(X), listed(X).\n",
        "/// `x` is there and asked for. Must. Misses: others.\n.decl own(x: symbol)\nown(X) :- given(X), asked(X).\n",
        "/// `x` is there, and no guess. Must.\n.decl own(x: symbol)\nown(X) :- given(X), !guessed(X).\n",
        "/// `x` may be there. May.\n.decl own(x: symbol)\nown(X) :- guessed(X).\n",
        "/// `y` is the text of `x`. Must, given `x`.\n.decl own(x: symbol, y: symbol)\nown(X, Y) :- guessed(X), given(Y).\n",
        "/// `y` is the text of `x`. Must, given\n/// `x`.\n.decl own(x: symbol, y: symbol)\nown(X, Y) :- guessed(X), given(Y).\n",
        ".type Pair = [a: symbol, b: symbol]\n/// `y` is a part of `x`. Must, given `x`.\n.decl own(x: Pair, y: symbol)\n"
        "own(X, Y) :- given(Z), X = [Z, Y], guessed(Y).\n",
        "/// Whatever is `x`, listed or not.\n.decl own(x: symbol)\nown(X) :- listed(X).\n",
    ],
)
def test_rules_that_keep_to_it(tmp_path: Path, text: str) -> None:
    """A certain row rests on certain ones, on what is asked for, on what is given, on the absence of what is possible, on the program's facts."""
    assert messages(tmp_path, text + OUT) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (".decl own(x: symbol)\nown(X) :- given(X).\n", "2: `own` has no `///` comment that says when a row holds"),
        ("/// Some are. Must.\n.decl own(x: symbol)\nown(X) :- given(X).\n", "3: the comment of `own` does not say what `x` is"),
        (
            "/// `x` is.\n.decl own(x: symbol)\nown(X) :- given(X).\n",
            "3: the comment of `own` does not end in `Must.`, `May.` or `Demand.`",
        ),
        ("/// `x`. Must.\n.decl own(x: symbol)\nown(X) :- guessed(X).\n", "4: `own` is a Must, and rests on `guessed`, which is a May"),
        (
            "/// `y` of `x`. Must, given `x`.\n.decl own(x: symbol, y: symbol)\nown(X, Y) :- given(X), guessed(Y).\n",
            "4: `own` is a Must, and rests on `guessed`, which is a May",
        ),
        (
            "/// `x`. Must, given `z`.\n.decl own(x: symbol)\nown(X) :- given(X).\n",
            "3: `own` has no attribute `z`, which its comment takes as given",
        ),
        ("/// `xY`. Must.\n.decl own(xY: symbol)\nown(X) :- given(X).\n", "3: `xY` is not written in snake_case"),
    ],
)
def test_rules_that_do_not(tmp_path: Path, text: str, message: str) -> None:
    """Each departure is told with its line."""
    assert messages(tmp_path, text + OUT) == [message]


def test_relations_of_no_use(tmp_path: Path) -> None:
    """A relation that nothing reads but itself, and nobody is shown, is dead; assertions are looked at by their name."""
    text = "/// `x`. Must.\n.decl own(x: symbol)\nown(X) :- given(X).\nown(X) :- own(X), listed(X).\n"
    assert messages(tmp_path, text) == ["3: `own` is read by no other relation and put out by none"]
    assert messages(tmp_path, text.replace("own(", "assert_own(")) == []
