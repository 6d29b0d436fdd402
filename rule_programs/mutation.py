"""Mutants of the rules of components, judged by drop-in tests and by example workspaces, in worker processes."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from pathlib import Path

from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.datalog import Program
from rosarch.datalog.inspection.mutation import Case, Mutant, MutationTest, Verdict, merged, mutants
from rosarch.datalog.inspection.rule_tests import EXPECTED, FACTS, PROGRAM, find_tests
from rosarch.extractor.selection import select

Progress = Callable[[str, int, int], None]
_EXCEEDED = ("time limit", "memory")
TASK = 20  # mutants of one relation that a worker judges at once


def drop_in_cases(program: Program, folder: Path) -> Iterator[Case]:
    """The tests below a folder that are about this program; each observes the relations it has expected rows of."""
    for test in find_tests(folder):
        if not (test / PROGRAM).is_file():
            facts = program.read_facts(test / FACTS) if (test / FACTS).is_dir() else {}
            result = program.evaluate(facts, keep="all")
            observed = frozenset(path.stem for path in (test / EXPECTED).glob("*.csv"))
            yield Case(str(test.relative_to(folder)), result.all_rows(), observed)


def workspace_cases(program: Program, workspace: Path) -> Iterator[Case]:
    """The components of a workspace whose models are known; each observes all that models are made from."""
    inputs = set(program.inputs)
    with select(workspace) as found:
        for component in found.components:
            facts = {name: list(rows) for name, rows in component.load().items() if name in inputs}
            result = program.evaluate(facts, keep="all")
            rows = result.all_rows()
            yield Case(f"{workspace.name}: {component.title}", rows, frozenset(program.outputs))


def mutants_of(test: MutationTest, files: Sequence[Path], sample: int | None, seed: int) -> list[Mutant]:
    """The mutants of clauses in some files, all by default; `sample` of them, chosen at random."""
    own = {str(path.resolve()) for path in files}
    found = [m for m in mutants(test.rules, test.demand) if not own or str(Path(m.location.path).resolve()) in own]
    if sample is None or sample >= len(found):
        return found
    chosen = random.Random(seed).sample(range(len(found)), sample)
    return [found[i] for i in sorted(chosen)]


def judge_all(
    test: MutationTest, chosen: Sequence[Mutant], *, jobs: int | None = None, progress: Progress | None = None
) -> list[Verdict]:  # fmt: skip
    """The verdicts on mutants that are legal programs, in their order. One that takes too long or too much counts as killed."""
    tasks = []
    order = sorted(range(len(chosen)), key=lambda i: (chosen[i].relation, i))
    for _, group in groupby(order, key=lambda i: chosen[i].relation):  # they share what reads their relation
        same = list(group)
        tasks += [same[at : at + TASK] for at in range(0, len(same), TASK)]

    def work(indexes: list[int]) -> list[str | None]:
        return [verdict.killed_by if (verdict := test.judge(chosen[i])) else None for i in indexes]

    killed: dict[int, str | None] = {}
    while tasks:
        again = []
        for number, outcome in run_tasks(work, tasks, jobs=jobs or default_jobs(), timeout=LIMITS.evaluation):
            indexes = tasks[number]
            if isinstance(outcome, Failure):
                if outcome.reason not in _EXCEEDED:
                    raise RuntimeError(f"{chosen[indexes[0]].location}: {outcome.reason}: {outcome.detail}")
                if len(indexes) > 1:  # one of them is to blame
                    again += [[index] for index in indexes]
                    continue
                outcome = [outcome.reason]
            killed.update(zip(indexes, outcome, strict=True))
            if progress is not None:
                progress("mutants", len(killed), len(chosen))
        tasks = again
    return merged(Verdict(chosen[i], found) for i, found in sorted(killed.items()) if found is not None)
