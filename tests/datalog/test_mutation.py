"""Mutants of rules, and which of them tests notice."""

from __future__ import annotations

from pathlib import Path

from rosarch.datalog import load_program
from rosarch.datalog.inspection.mutation import Case, MutationTest, merged, mutants
from rosarch.datalog.program import Program

RULES = """\
.decl edge(x: symbol, y: symbol)
.input edge
.decl shut(x: symbol)
.input shut
.decl path(x: symbol, y: symbol)
path(X, Y) :- edge(X, Y), !shut(Y).
path(X, Z) :- path(X, Y), edge(Y, Z), !shut(Z).
.decl round(x: symbol)
.output round
round(X) :- path(X, X), edge(_, X).
.decl other(x: symbol)
.output other
other(X) :- shut(X), X != "z".
"""


def judged(tmp_path: Path, *cases: tuple[dict[str, list[tuple[str, ...]]], set[str]], rules: str = RULES) -> dict[str, str]:
    """The mutants by line and change, with the number of the case that killed each."""
    (tmp_path / "rules.dl").write_text(rules)
    program = load_program(tmp_path / "rules.dl")
    test = MutationTest(program, [case(program, str(n), facts, observed) for n, (facts, observed) in enumerate(cases)])
    found = ((m, test.judge(m)) for m in mutants(test.rules, test.demand))
    return {f"{m.location.line} {m.change}": v.killed_by for m, v in found if v is not None}


def case(program: Program, name: str, facts: dict[str, list[tuple[str, ...]]], observed: set[str]) -> Case:
    result = program.evaluate(facts, keep="all")
    return Case(name, result.all_rows(), frozenset(observed))


CYCLE = [("a", "b"), ("b", "c"), ("c", "a"), ("a", "d"), ("d", "a")]


def test_what_a_case_notices(tmp_path: Path) -> None:
    """A changed clause is noticed through what reads it; one whose rows no observed relation shows survives, as does one that changes none."""
    found = judged(tmp_path, ({"edge": CYCLE, "shut": [("c",)]}, {"round"}))
    assert found == {
        "6 without !shut(Y)": "0",
        "6 shut(Y) for !shut(Y)": "0",
        "7 without !shut(Z)": "0",
        "7 shut(Z) for !shut(Z)": "0",
        "10 without path(X, X)": "0",
        "10 !path(X, X) for path(X, X)": "0",
        "10 without edge(_, X)": "",
        "10 !edge(_, X) for edge(_, X)": "0",
        '13 without X != "z"': "",
        '13 X = "z" for X != "z"': "",
    }


def test_only_observed_relations_count(tmp_path: Path) -> None:
    """The same rows notice more when more relations are compared; the first case that notices is named."""
    facts = {"edge": CYCLE, "shut": [("c",), ("z",)]}
    only_round = judged(tmp_path, (facts, {"round"}))
    both = judged(tmp_path, (facts, {"round"}), (facts, {"other"}))
    assert only_round['13 X = "z" for X != "z"'] == "" and both['13 X = "z" for X != "z"'] == "1"
    assert {m: k for m, k in both.items() if not m.startswith("13")} == {m: k for m, k in only_round.items() if not m.startswith("13")}


def test_a_literal_that_adds_nothing_survives(tmp_path: Path) -> None:
    """Where a path ends an edge ends, too: the literal is redundant, and no case can tell."""
    found = judged(tmp_path, ({"edge": CYCLE, "shut": [("c",)]}, {"round", "other", "path"}))
    assert found["10 without edge(_, X)"] == ""
    assert found["6 without !shut(Y)"] == "0"


def test_mutants_that_are_no_programs_are_left_out(tmp_path: Path) -> None:
    """Without the literal that gives a variable its value there is no program, nor with a negation in a cycle."""
    found = judged(tmp_path, ({"edge": CYCLE, "shut": []}, {"round"}))
    assert not any(change.startswith(("6 without edge", "7 !path", "7 without path", "13 without shut")) for change in found)


ALTERNATIVES = """\
.decl edge(x: symbol, y: symbol)
.input edge
.decl end(x: symbol)
.output end
end(X) :- edge(A, B), A != B, (X = A; X = B, B != "z").
"""


def test_a_literal_that_alternatives_share_is_one(tmp_path: Path) -> None:
    """It is changed in all of them, and noticed when one of them shows it; what is in one alternative is changed there."""
    found = judged(tmp_path, ({"edge": [("a", "a"), ("a", "b"), ("b", "z")]}, {"end"}), rules=ALTERNATIVES)
    assert found == {
        "5 without A != B": "",
        "5 A = B for A != B": "0",
        '5 without B != "z"': "0",
        '5 B = "z" for B != "z"': "0",
    }


DEMAND = """\
.decl edge(x: symbol, y: symbol)
.input edge
/// `x` is asked for. Demand.
.decl asked(x: symbol)
asked("a").
asked(Y) :- asked(X), edge(X, Y), Y != "z".
/// `x` is asked for, and its absence tells something. Demand.
.decl named(x: symbol)
named(X) :- edge(X, _), X != "q".
.decl next(x: symbol, y: symbol)
next(X, Y) :- asked(X), edge(X, Y).
.decl found(x: symbol)
.output found
found(Y) :- next("a", Y), !named(Y).
"""


def test_demand_is_not_dropped(tmp_path: Path) -> None:
    """More demand is more work for the same rows: nothing could notice. Less is noticed, and so is what is asked for strictly."""
    found = judged(tmp_path, ({"edge": [("a", "b"), ("b", "c"), ("q", "z")]}, {"found"}), rules=DEMAND)
    assert not any(change.startswith(("6 without", "11 without asked")) for change in found)
    assert {change for change in found if change.startswith("9 ")} == {'9 without X != "q"', '9 X = "q" for X != "q"'}
    assert "11 !asked(X) for asked(X)" in found


INSTANCES = """\
.comp Far {
  .decl near(x: symbol, y: symbol)
  .decl far(x: symbol)
  far(X) :- near(_, X), X != "a".
}
.init there = Far
.init here = Far
.decl edge(x: symbol, y: symbol)
.input edge
there.near(X, Y) :- edge(X, Y).
here.near(X, X) :- edge(X, _).
.output there.far
.output here.far
"""


def test_instances_of_a_component_are_one_text(tmp_path: Path) -> None:
    """What is noticed in one instance is noticed, though no row tells it in the other."""
    (tmp_path / "rules.dl").write_text(INSTANCES)
    program = load_program(tmp_path / "rules.dl")
    test = MutationTest(program, [case(program, "0", {"edge": [("b", "a")]}, {"there.far", "here.far"})])
    changed = [mutant for mutant in mutants(test.rules) if mutant.location.line == 4]
    assert {mutant.written[1] for mutant in changed} == {
        "without near(_, X)",
        "!near(_, X) for near(_, X)",
        'without X != "a"',
        'X = "a" for X != "a"',
    }
    verdicts = [verdict for mutant in changed if (verdict := test.judge(mutant)) is not None]
    assert [v.killed_by for v in verdicts if v.mutant.change == 'without X != "a"'] == ["0", ""]
    assert [v.killed_by for v in merged(verdicts) if v.mutant.change == 'without X != "a"'] == ["0"]
