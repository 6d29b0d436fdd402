"""Measure how well the tests pin the rules of components: clauses that fire, and mutants that are noticed.

    benchmarks/rule_mutation.py [--sample N] [--seed N] [--list]

The cases are the drop-in tests of `tests/rules`, the sources there that say what is expected of them, and the workspaces of `examples`
whose models are written by hand. Exit code 1 below the figures to reach: 95 % of the clauses fire, 80 % of the mutants are killed.
"""

from __future__ import annotations

import argparse
import sys
from functools import partial
from pathlib import Path

from rosarch.datalog import Result
from rosarch.datalog.mutation import MutationTest, summary, survivors_text
from rosarch.datalog.rule_coverage import coverage
from rosarch.expectations.alone import Alone
from rosarch.expectations.cases import find_cases
from rosarch.expectations.mutation import mutation_cases
from rosarch.expectations.run import Running
from rosarch.models.rule_mutation import drop_in_cases, judge_all, mutants_of, workspace_cases
from rosarch.models.rule_sets import SHIPPED, component_program, rule_set

TOP = Path(__file__).resolve().parents[1]
TESTS = TOP / "tests" / "rules"
FIRED, KILLED = 0.95, 0.80


def main() -> int:
    """Print both figures; with `--list`, what is not pinned."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, help="as many mutants, chosen at random; all by default")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--list", action="store_true", help="clauses that never fire and mutants that survive")
    given = parser.parse_args()
    program = component_program()
    cases = list(drop_in_cases(program, TESTS))
    for folder, rules in (
        (TESTS / "sources", SHIPPED),
        (TESTS / "packages", SHIPPED),
        (TESTS / "hints", rule_set([TESTS / "hints" / "hints.dl"])),
    ):
        how = Running(rules, partial(Alone, rules=rules, engine="embedded"), jobs=given.jobs)
        cases += mutation_cases(component_program(rules), find_cases([folder]).cases, how)
    for workspace in sorted(path.parent for path in (TOP / "examples").glob("*/expected")):
        cases += workspace_cases(program, workspace)
    fired = coverage(program, (Result.of(case.rows, program) for case in cases))
    test = MutationTest(program, cases)
    verdicts = judge_all(test, mutants_of(test, (), given.sample, given.seed), jobs=given.jobs)
    if given.list:
        for clause in fired.unfired:
            print(f"{Path(clause.location.path).relative_to(TOP)}:{clause.location.line}: never fires: {clause.text}")
        print(survivors_text(verdicts, shorten=lambda path: str(Path(path).relative_to(TOP))))
    killed = sum(bool(v.killed_by) for v in verdicts) / max(len(verdicts), 1)
    print(f"{fired.fired} of {fired.clauses} clauses fire ({fired.fired / fired.clauses:.1%}) in {len(cases)} cases; {summary(verdicts)}")
    return 0 if fired.fired >= FIRED * fired.clauses and killed >= KILLED else 1


if __name__ == "__main__":
    sys.exit(main())
