"""Measure how well the tests pin the rules: clauses that fire, and mutants that are noticed.

    benchmarks/rule_mutation.py [FILE...] [--systems] [--sample N] [--seed N] [--list]

The cases of the rules of components are those of `tests/rules/components`, sources in `tests` that say what is expected of them, and the
workspaces of `examples` whose models are written by hand. Those of the rules of systems and of checks are `tests/rules/systems` and
`tests/rules/checks`. Exit code 1 below the figures to reach: 95 % of the clauses fire, 80 % of the mutants are killed.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Collection, Iterator, Mapping
from functools import partial
from pathlib import Path

from rosarch.analysis.method import Method
from rosarch.base.places import Place
from rosarch.cli.commands.rules_test import systems_of
from rosarch.cli.questions import ReadingOptions
from rosarch.datalog import Program, Result
from rosarch.datalog.inspection.mutation import Case, MutationTest, summary, survivors_text
from rosarch.datalog.inspection.rows import Row
from rosarch.datalog.inspection.rule_coverage import coverage
from rosarch.evaluation.expectations.alone import Alone
from rosarch.evaluation.expectations.cases import Case as Sources
from rosarch.evaluation.expectations.cases import find_cases
from rosarch.evaluation.expectations.mutation import model_cases, mutation_cases
from rosarch.evaluation.expectations.run import Running
from rosarch.evaluation.expectations.system_mutation import System, finding_cases
from rosarch.extractor.settings import Settings
from rosarch.findings.of_systems import findings
from rosarch.models.component import ComponentModel, to_json
from rosarch.models.system.build import finding_relations, system_model
from rosarch.rule_programs.checks import Check, evidence_of, read_check, shown_as
from rosarch.rule_programs.mutation import judge_all, mutants_of, workspace_cases
from rosarch.rule_programs.sets import SHIPPED, component_program, rule_set, system_rules

TOP = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TOP / "tests" / folder) for folder in ("rules", "models")]
import rule_cases  # noqa: E402
import test_behavior  # noqa: E402
import test_checks  # noqa: E402
import test_systems  # noqa: E402
import test_traits  # noqa: E402

TESTS = TOP / "tests"
RULES = TESTS / "rules"
FIRED, KILLED = 0.95, 0.80
Rows = Mapping[str, Collection[Row]]


def cases_of(program: Program, jobs: int | None) -> Iterator[Case]:
    """All that the tests look at of components."""
    for case in rule_cases.component_cases():
        yield Case(
            case.id, program.evaluate(rule_cases.component_facts(case), keep="all").all_rows(), frozenset(rule_cases.expectations(case))
        )
    how = Running(partial(Alone, rules=SHIPPED, engine="embedded"), Method(sources=Settings(jobs)))
    yield from mutation_cases(program, find_cases([RULES / "sources", TESTS / "project"]).cases, how)
    yield from mutation_cases(program, find_cases([RULES / "packages"]).cases, of_workspaces(jobs))
    hinted = rule_set([RULES / "hints" / "hints.dl"])
    with_hints = Running(partial(Alone, rules=hinted, engine="embedded"), Method(hinted, sources=Settings(jobs)))
    yield from mutation_cases(component_program(hinted), find_cases([RULES / "hints"]).cases, with_hints)
    for folder, shown in ((test_behavior.HERE, behavior), (test_traits.HERE, test_traits.lines)):
        yield from model_cases(program, Sources(folder, tuple(sorted(folder.glob("*.cpp"))), ()), how, shown)
    for workspace in sorted(path.parent for path in (TOP / "examples").glob("*/expected")):
        yield from workspace_cases(program, workspace)


def of_workspaces(jobs: int | None) -> Running:
    """How the workspaces are run whose systems are checked."""
    return Running(systems_of(SHIPPED, ReadingOptions(jobs=jobs)), Method(sources=Settings(jobs)))


def behavior(model: ComponentModel) -> object:
    """What `tests/models/test_behavior.py` compares of a model."""
    return test_behavior.lines(to_json(model)), test_behavior.normal_lines(to_json(model))


def cases_of_systems(program: Program, jobs: int | None) -> Iterator[Case]:
    """All that the tests look at of systems: rows, and the findings of a check. Cases that add to what rules derive are left out."""
    yield from finding_cases(find_cases([RULES / "packages"]).cases, of_workspaces(jobs))
    for workspace in sorted({path.parents[1] for path in (TOP / "examples").glob("*/expected/*.txt")}):
        yield from example_cases(workspace, jobs)
    for case in (*test_systems.CASES, *test_checks.CASES):
        facts, own = rule_cases.facts_and_program(case)
        if own is not program:
            continue
        rows = program.evaluate(facts, keep="all").all_rows()
        if case in test_systems.CASES:
            yield Case(f"systems/{case.id}", rows, frozenset(rule_cases.expectations(case)))
            continue
        check = read_check(TOP / "rules" / "checks" / case.path.name)
        told = {check.fix_relation} & program.relations.keys()
        told |= {relation for _, type_ in check.columns for relation in (evidence_of(type_), shown_as(type_))} & program.relations.keys()
        yield Case(case.id, rows, frozenset({check.relation, *told}), partial(finds_other, case, check, program, rows))


def example_cases(workspace: Path, jobs: int | None) -> Iterator[Case]:
    """The systems of an example: `tests/examples/test_example_systems.py` compares findings that are no notes, and connectors in some."""
    shared, launches = systems_of(SHIPPED, ReadingOptions(jobs=jobs))(workspace).around
    shown = {path.read_text(encoding="utf-8").partition("\n")[0] for path in (workspace / "expected").glob("*.txt")}
    rules = system_rules(SHIPPED)
    systems = [System.of(rules, {name: list(rows) for name, rows in shared.rows(launch).items()}) for launch in launches]
    for launch, system in zip(launches, systems, strict=True):
        others = {line for other in systems if other is not system for line in warnings(other)}
        usual = shown_of(system, others, connected=launch.name in shown)
        fails = partial(shows_other, system, others, usual)
        yield Case(f"{workspace.name}: {launch.name}", system.rows, frozenset({*rules.program.outputs, *finding_relations(rules)}), fails)


Shown = tuple[set[tuple[str, ...]], list[tuple[object, ...]]]


def shows_other(system: System, others: set[tuple[str, ...]], usual: Shown, changed: Rows) -> bool:
    """Whether the test of an example fails when some relations have changed."""
    try:
        return shown_of(system.with_rows(changed), others, connected=bool(usual[1])) != usual
    except (LookupError, ValueError):
        return True  # no model can be made of such rows


def shown_of(system: System, others: set[tuple[str, ...]], *, connected: bool) -> Shown:
    """What the test of an example compares: findings, those of the other systems too, and connectors with two sides."""
    model = system_model("", (), system.facts, system.result, system.places) if connected else None
    sides = [(each, *({node for node, _ in side} for side in (each.sources, each.sinks))) for each in model.connectors] if model else []
    return warnings(system) | others, [(each.kind, each.name, into, out) for each, into, out in sides if into and out and each.kind != "tf"]


def warnings(system: System) -> set[tuple[str, ...]]:
    """The findings of a system that are no notes."""
    return {(found.severity, found.message, str(found.place)) for found in system.findings if found.severity != "note"}


def finds_other(case: rule_cases.Case, check: Check, program: Program, usual: Rows, changed: Rows) -> bool:
    """Whether a check has other findings in a case when some relations have changed."""
    return findings_of(case, check, program, {**usual, **changed}) != findings_of(case, check, program, usual)


def findings_of(case: rule_cases.Case, check: Check, program: Program, rows: Rows) -> tuple[set[tuple[object, ...]], list[str]]:
    """The findings of a check with their fixes and what they show beside, as `tests/rules/test_checks.py` compares them."""
    places = {row[0]: Place(*row[1:]) for row in rows["place"]}
    found = findings([check], Result.of(rows, program), places, "demo")
    shown = sorted(test_checks.beside(found)) if test_checks.EVIDENCE.search(case.text) else []
    return {(finding.message, str(finding.place), finding.fix) for finding in found}, shown


def main() -> int:
    """Print both figures; with `--list`, what is not pinned."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=Path, help="mutants of these files of rules alone")
    parser.add_argument("--systems", action="store_true", help="the rules of systems and checks, not those of components")
    parser.add_argument("--sample", type=int, help="as many mutants, chosen at random; all by default")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--list", action="store_true", help="clauses that never fire and mutants that survive")
    given = parser.parse_args()
    program = rule_cases.whole() if given.systems else component_program()
    cases = list(cases_of_systems(program, given.jobs) if given.systems else cases_of(program, given.jobs))
    fired = coverage(program, (Result.of(case.rows, program) for case in cases))
    test = MutationTest(program, cases)
    verdicts = judge_all(test, mutants_of(test, given.files, given.sample, given.seed), jobs=given.jobs)
    if given.list:
        for clause in fired.unfired:
            print(f"{Path(clause.location.path).resolve().relative_to(TOP)}:{clause.location.line}: never fires: {clause.text}")
        print(survivors_text(verdicts, shorten=lambda path: str(Path(path).resolve().relative_to(TOP))))
    killed = sum(bool(v.killed_by) for v in verdicts) / max(len(verdicts), 1)
    print(f"{fired.fired} of {fired.clauses} clauses fire ({fired.fired / fired.clauses:.1%}) in {len(cases)} cases; {summary(verdicts)}")
    return 0 if fired.fired >= FIRED * fired.clauses and killed >= KILLED else 1


if __name__ == "__main__":
    sys.exit(main())
