"""Text of the input in reports: visible, on its line, without power over the terminal."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from rosarch.extractor.workspace import Diagnostic
from rosarch.models.component import ComponentModel, Parameter, Place, Port
from rosarch.reports.diagnostics import diagnostics_text
from rosarch.reports.markdown import ports_text
from rosarch.reports.printable import all_printable, printable
from rosarch.reports.table import models_text

EVIL = "a\n[red]|\x1b[31mR\u202e"
SHOWN = "a\\n[red]|\\x1b[31mR\\u202e"
PORT = Port("p1", "publisher", EVIL, EVIL, EVIL, 1, False, EVIL, "plain", Place(EVIL, 1, 1), unknown=EVIL)
MODEL = ComponentModel("s", EVIL, EVIL, "node", EVIL, (EVIL,), (PORT,), (Parameter(EVIL, "get", "string", EVIL, Place(EVIL, 1, 1)),))


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain größe 車", "plain größe 車"),
        (EVIL, SHOWN),
        ("\0\t\r\x7f\x85\x9b", "\\x00\\t\\r\\x7f\\x85\\x9b"),
        ("\u2028\u2066\u200b\ufeff", "\\u2028\\u2066\\u200b\\ufeff"),
        ("a\udcff", "a\\xff"),
    ],
)
def test_what_cannot_be_seen_is_escaped(text: str, shown: str) -> None:
    assert printable(text) == shown
    assert shown.isprintable()


def test_every_text_of_a_model() -> None:
    assert all_printable(MODEL) == ComponentModel(
        "s", SHOWN, SHOWN, "node", SHOWN, (SHOWN,),
        (replace(PORT, name=SHOWN, from_param=SHOWN, type=SHOWN, callback=SHOWN, at=Place(SHOWN, 1, 1), unknown=SHOWN),),
        (Parameter(SHOWN, "get", "string", SHOWN, Place(SHOWN, 1, 1)),),
    )  # fmt: skip


def test_table() -> None:
    row = f"  publisher  {SHOWN} from {SHOWN} ({SHOWN})  {SHOWN}  queue 1  {SHOWN}  {SHOWN}:1\n"
    assert models_text([MODEL], parameters=True, terminal=False) == (
        f"{SHOWN}/{SHOWN}  node {SHOWN}\n{row}  parameters  {SHOWN}={SHOWN}\n\n"
    )  # fmt: skip


def test_markdown() -> None:
    cell = SHOWN.replace("|", "\\|")
    row = f"| publisher | `{cell}` from `{cell}` ({cell}) | {cell} | 1 | {cell} | {cell}:1 |"
    assert ports_text([MODEL]).splitlines()[2:] == [
        "| kind | name | type | queue | callback | source |",
        "|---|---|---|---|---|---|",
        row,
    ]


def test_diagnostics() -> None:
    found = [Diagnostic("source", Path("/ws/a\udcff.cpp"), 1, 1, "odd \x1b[31m")]
    assert diagnostics_text(found, Path("/ws")) == "source: 1\n  a\\xff.cpp:1:1: odd \\x1b[31m\n1 diagnostic\n"
