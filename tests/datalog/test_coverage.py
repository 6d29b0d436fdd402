"""Rule coverage and drop-in rule tests."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from rosarch.datalog import Program, coverage, run_rule_tests
from rosarch.datalog.inspection.rule_tests import outcome_text, report_text

PROGRAM = (
    ".decl e(x: number)\n.input e\n.decl r(x: number)\n"
    "r(X) :- e(X), X > 0.\nr(X) :- e(X), (X < -5; X = 0).\nr(0 - X) :- r(X), X > 9,\n    !e(X). // never\n"
)


def test_clauses_that_never_fired(load: Callable[[str], Program]) -> None:
    program = load(PROGRAM)
    found = coverage(program, [{"e": [(1,)]}, {"e": [(0,)]}])
    assert (found.clauses, found.fired) == (4, 2)
    assert [(c.location.line, c.relation, c.text) for c in found.unfired] == [
        (5, "r", "r(X) :- e(X), X < -5."),
        (6, "r", "r(0 - X) :- r(X), X > 9, !e(X)."),
    ]


def test_all_features(graph: Program, graph_facts: Any) -> None:
    assert coverage(graph, [graph_facts]).unfired == ()
    assert coverage(graph, []).fired == 0


def write(folder: Path, facts: str, expected: str, program: str = "", known: str = "") -> None:
    (folder / "facts").mkdir(parents=True)
    (folder / "expected").mkdir()
    (folder / "facts" / "e.facts").write_text(facts)
    (folder / "expected" / "r.csv").write_text(expected)
    if program:
        (folder / "program.dl").write_text(program)
    if known:
        (folder / "known_failure.txt").write_text(known)


def test_drop_in_tests(tmp_path: Path) -> None:
    tests = tmp_path / "tests"
    (tmp_path / "rules.dl").write_text(PROGRAM)
    write(tests / "a" / "right", "1\n2\n", "2\n1\n")
    write(tests / "a" / "wrong", "1\n2\n", "1\n3\n")
    write(tests / "b" / "broken", "1\n", "1\n", program="r(X) :- e(X).\n")
    write(tests / "b" / "known", "1\n", "7\n", known="needs subtraction\n")
    write(tests / "b" / "mended", "1\n", "1\n", known="once upon a time\n")
    write(tests / "b" / "own", "4\n", "16\n", program=".decl e(x: number)\n.input e\n.decl r(x: number)\nr(X * X) :- e(X).\n")
    report = run_rule_tests(tests, [tmp_path / "rules.dl"])
    assert not report.ok
    assert "".join(map(outcome_text, report.outcomes)).replace(f"{tmp_path}/", "") == (
        "ok       a/right\n"
        "FAILED   a/wrong\n  r:\n    missing     3\n    unexpected  2\n"
        "FAILED   b/broken\n"
        "  tests/b/broken/program.dl:1:1: unknown relation `r`\n      r(X) :- e(X).\n      ^\n"
        "  tests/b/broken/program.dl:1:9: unknown relation `e`\n      r(X) :- e(X).\n              ^\n"
        "known    b/known: needs subtraction\n"
        "FAILED   b/mended: passes now, remove known_failure.txt\n"
        "ok       b/own\n"
    )
    assert report_text(report).replace(f"{tmp_path}/", "") == (
        "coverage of rules.dl: 1 of 4 clauses fired (25 %)\n"
        "never fired:\n"
        "  rules.dl:5: r(X) :- e(X), X < -5.\n"
        "  rules.dl:5: r(X) :- e(X), X = 0.\n"
        "  rules.dl:6: r(0 - X) :- r(X), X > 9, !e(X).\n"
        "coverage of tests/b/own/program.dl: 1 of 1 clauses fired (100 %)\n"
        "6 tests, 3 failed\n"
    )


def test_an_expected_file_without_a_relation(tmp_path: Path) -> None:
    (tmp_path / "rules.dl").write_text(PROGRAM)
    write(tmp_path / "case", "", "")
    (tmp_path / "case" / "expected" / "q.csv").write_text("")
    report = run_rule_tests(tmp_path, [tmp_path / "rules.dl"])
    assert report.outcomes[0].error == f"{tmp_path}/case/expected/q.csv: there is no relation `q`"
