"""Differences as text, Markdown and JSON."""

from __future__ import annotations

import json

import pytest
from jsonschema import Draft202012Validator
from systems import at

from rosarch.analysis.comparison.changes import Change, Detail
from rosarch.reports.comparison import changes_json, changes_markdown, changes_schema, changes_text

CHANGES = (
    Change("port", "p/a", "lost", "publisher x", (Detail("type", "T", None),), at("a.cpp", 3), None),
    Change("port", "p/a", "renamed", "subscriber scan", (Detail("name", "scan", "laser"),), at("a.cpp", 4), at("a.cpp", 5)),
    Change("rate", "p/a", "changed", "timer sends x", (Detail("rate", "10 Hz", "20 Hz"), Detail("when", None, "a || b")), at("a.cpp", 6), at("a.cpp", 7)),
    Change("finding", "findings", "gained", "error near-miss: `x` <b>\n", (), None, at("a.launch", 2)),
)  # fmt: skip


def test_text() -> None:
    assert changes_text(CHANGES) == (
        "p/a\n"
        "  - port  publisher x      type T  a.cpp:3\n"
        "  > port  subscriber scan  name scan -> laser  a.cpp:5\n"
        "  ~ rate  timer sends x    rate 10 Hz -> 20 Hz, when none -> a || b  a.cpp:7\n"
        "\n"
        "findings\n"
        "  + finding  error near-miss: `x` <b>\\n  a.launch:2\n"
        "\n"
        "4 differences: 1 lost, 1 gained, 1 renamed, 1 changed\n"
    )


def test_markdown() -> None:
    assert changes_markdown(CHANGES[2:]) == (
        "## p/a\n"
        "\n"
        "| | what | | details | source |\n"
        "|---|---|---|---|---|\n"
        "| changed | rate | timer sends x | rate 10 Hz -> 20 Hz, when none -> a \\|\\| b | a.cpp:7 |\n"
        "\n"
        "## findings\n"
        "\n"
        "| | what | | details | source |\n"
        "|---|---|---|---|---|\n"
        "| gained | finding | error near-miss: \\`x\\` &lt;b>\\\\n |  | a.launch:2 |\n"
        "\n"
        "2 differences: 1 gained, 1 changed.\n"
    )


def test_none() -> None:
    assert (changes_text(()), changes_markdown(())) == ("no differences\n", "No differences.\n")
    assert json.loads(changes_json(())) == {"summary": {"lost": 0, "gained": 0, "renamed": 0, "changed": 0}, "changes": []}


def test_json() -> None:
    data = json.loads(changes_json(CHANGES))
    Draft202012Validator.check_schema(changes_schema())
    Draft202012Validator(changes_schema()).validate(data)
    assert data["summary"] == {"lost": 1, "gained": 1, "renamed": 1, "changed": 1}
    assert data["changes"][1] == {
        "subject": "port", "where": "p/a", "how": "renamed", "title": "subscriber scan",
        "details": [{"name": "name", "old": "scan", "new": "laser"}], "old_at": "a.cpp:4", "new_at": "a.cpp:5",
    }  # fmt: skip


@pytest.mark.parametrize(("field", "value"), [("how", "moved"), ("subject", "thing"), ("old_at", "a.cpp"), ("more", 1)])
def test_the_schema_refuses_what_is_wrong(field: str, value: object) -> None:
    data = json.loads(changes_json(CHANGES))
    data["changes"][0][field] = value
    assert not Draft202012Validator(changes_schema()).is_valid(data)
