"""The summary of what was not understood."""

from __future__ import annotations

from pathlib import Path

from rosarch.extractor.workspace import Diagnostic
from rosarch.reports.diagnostics import diagnostics_summary, diagnostics_text

HERE = Path("/ws")


def cmake(number: int) -> list[Diagnostic]:
    return [Diagnostic("cmake", HERE / "a" / "CMakeLists.txt", line, 1, "unknown command x") for line in range(1, number + 1)]


def test_nothing_to_tell() -> None:
    assert diagnostics_text([], HERE) == ""


def test_paths_are_relative_to_the_current_folder() -> None:
    found = [*cmake(1), Diagnostic("source", Path("/else/b.cpp"), 3, 7, "not analysed: crash")]
    assert diagnostics_text(found, HERE) == (
        "cmake: 1\n"
        "  a/CMakeLists.txt:1:1: unknown command x\n"
        "source: 1\n"
        "  /else/b.cpp:3:7: not analysed: crash\n"
        "2 diagnostics\n"
    )  # fmt: skip


def test_twenty_are_shown_and_every_kind_is_among_them() -> None:
    text = diagnostics_text([*cmake(100), Diagnostic("source", HERE / "b.cpp", 1, 1, "crash")], HERE)
    assert text.startswith("cmake: 100\n")
    assert "source: 1\n  b.cpp:1:1: crash\n" in text
    assert text.count("\n  ") == 20
    assert text.endswith("101 diagnostics; 20 shown, -v shows all\n")


def test_all_are_shown_when_asked_for() -> None:
    text = diagnostics_text(cmake(100), HERE, complete=True)
    assert text.count("\n  ") == 100
    assert text.endswith("\n100 diagnostics\n")


def test_only_the_first_line_of_a_long_message() -> None:
    assert diagnostics_text([Diagnostic("source", HERE / "b.cpp", 1, 1, "error\nmore\nmore")], HERE) == (
        "source: 1\n  b.cpp:1:1: error\n1 diagnostic\n"
    )


def test_a_summary_has_a_line_for_each_message() -> None:
    found = [
        *cmake(3),
        Diagnostic("source", HERE / "b.cpp", 1, 1, "crash"),
        Diagnostic("launch-env", HERE / "a.launch", 2, 3, "`X` is not set"),
    ]
    assert diagnostics_summary(found, HERE) == (
        "unknown command x (3 places)\na.launch:2:3: `X` is not set\nb.cpp:1:1: crash\n5 diagnostics; -v shows all\n"
    )
    assert diagnostics_summary(found[3:], HERE) == "a.launch:2:3: `X` is not set\nb.cpp:1:1: crash\n2 diagnostics\n"
    assert diagnostics_summary([], HERE) == ""


def test_a_summary_is_short() -> None:
    many = [Diagnostic("source", HERE / "b.cpp", line, 1, f"message {line:02}") for line in range(1, 21)]
    lines = diagnostics_summary(many, HERE).splitlines()
    assert (len(lines), lines[0], lines[-1]) == (6, "b.cpp:1:1: message 01", "20 diagnostics; -v shows all")
