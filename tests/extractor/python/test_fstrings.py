"""f-strings of Python 3.12 (PEP 701) are read by older Pythons too."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from rosarch.extractor.python.source import Parsed, read_source
from rosarch.extractor.python_fstrings import with_older_fstrings
from rosarch.extractor.python_syntax import parse_python


@pytest.mark.parametrize(
    ("newer", "older"),
    [
        ('f"{a["b"]} {d("e")}"', 'f\'{a["b"]} {d("e")}\''),
        ('f"{f"{y}"}"', "f\"{f'{y}'}\""),
        ('f"{f"{y["k"]}"}"', "f'''{f\"{y['k']}\"}'''"),
        ('rf"\\d{n["a"]}"', "rf'\\d{n[\"a\"]}'"),
        ('f"{a["b"]}" "c"', "f'{a[\"b\"]}' 'c'"),
        ('f"{a["b"]!r:>{w["c"]}} {{q}}"', 'f\'{a["b"]!r:>{w["c"]}} {{q}}\''),
        ('f"{a != "c"}"', "f\"{a != 'c'}\""),
        ('f"{"" or d[""]}"', "f\"{'' or d['']}\""),
        ('f"\\N{BULLET}{a["b"]}"', "f'\\N{BULLET}{a[\"b\"]}'"),
        ('f"{a # the first\n}"', 'f"""{a \n}"""'),
        ('f"{call(\n    a) / 1e9:.0f}"', 'f"""{call(a) / 1e9:.0f}"""'),
    ],
)
def test_newer_fstrings_mean_what_they_say(newer: str, older: str) -> None:
    rewritten = with_older_fstrings(newer)
    assert rewritten is not None and rewritten.count("\n") == newer.count("\n")
    assert ast.dump(ast.parse(rewritten)) == ast.dump(ast.parse(older))
    assert ast.dump(parse_python(newer)) == ast.dump(ast.parse(older))


def test_a_text_with_a_backslash_within_braces_is_an_unknown_one() -> None:
    rewritten = with_older_fstrings("f\"{'\\n'.join(lines)}\"")
    assert rewritten == "f\"{'?'.join(lines)}\""
    other = "f'{\"\\n\".join(lines)}'"  # keeps the quotes that it has: they are not those around
    assert with_older_fstrings(other) == "f'{\"?\".join(lines)}'"


@pytest.mark.parametrize(
    "source",
    [
        "x = 1",
        "f'{a}'",
        "f\"{a['b']}\"  # it's",
        'f"""{a["b"]}"""',
        "f'{{no field}}'",
        "'f\"{'",
        'f"{a["b"]',  # no end
        "f'{a",
        "f'{a:",
        "f'{'",
        "f'\\N{",
        "f'",
        "'",
        'f"{f"{f"{f"{a["b"]}"}"}"}"',  # too deep
        'f"{a[\'\'\'b\'\'\']} {c["d"]} \\""""""',
    ],
)
def test_other_texts_stay(source: str) -> None:
    assert with_older_fstrings(source) is None


def test_a_source_with_newer_fstrings_is_read_to_its_end(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text('name = f"{parts["first"]}/{\n    second\n}"\nlast = 1\n', encoding="utf-8")
    parsed = read_source(path)
    assert isinstance(parsed, Parsed) and not parsed.problems and not parsed.left_out
    assert [node.lineno for node in parsed.tree.body] == [1, 4]
    assert parsed.data.count(b"\n") == 4
