"""Measure what a writer of rules waits for: the rows after an edit, and an experiment.

    benchmarks/workbench.py edits PATH... [--rule FILE]... [--runs N]
    benchmarks/workbench.py experiment TRUTH SYSTEMS [--runs N]

`edits` derives all rows of the components at PATH (sources, or better facts) as `rosarch watch` does, edits one rule, and derives again:
once so that no row changes, and once so that the rule is gone. Rules of rosarch's are edited in a copy. By default an own rule and
`core/behavior/reactive.dl` are edited. `experiment` runs three variants on all systems of TRUTH, facts being extracted before. Prints
Markdown tables, of several runs the median. Processor time is of all processes.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TypeVar

from rosarch.datalog.engine.rederive import RuleHistory
from rosarch.evaluation.experiments.truth import read_truth
from rosarch.extractor.manifest import rules_folder
from rosarch.extractor.selection import select
from rosarch.rule_programs.live import LiveRules
from rosarch.rule_programs.sets import rule_history, rule_set

Result = TypeVar("Result")

OWN = """
.decl changed_by(topic: symbol, variable: symbol)
.output changed_by
changed_by(Topic, Name) :- transition(_, Variable, Function), variable_name(Variable, Name), port_callback([_, _, Topic], Function).
"""
WANTED = ("port", "reacts", "transition")
EDITS = {"1 = 1": "", "1 = 2": ", a rule gone"}
VARIANTS = "{default: {}, rosinfer: {decisions: {state-variable: rosinfer}}, nesting: {decisions: {publish-guard: nesting}}}"


def timed(work: Callable[[], Result]) -> tuple[Result, float, float]:
    """What `work` gives, seconds, and seconds of processor time with those of its processes."""
    start, before = time.perf_counter(), os.times()
    result = work()
    after = os.times()
    return result, time.perf_counter() - start, sum(after[:4]) - sum(before[:4])


def history(rules: Sequence[str], folder: Path) -> tuple[RuleHistory, dict[str, Path]]:
    """The rules of components, and the files among them that may be edited: copies of rosarch's, and one of the user's own."""
    files = {rule: folder / f"edited{number}.dl" for number, rule in enumerate(rules)}
    for rule, file in files.items():
        file.write_text(OWN if rule == "own" else (rules_folder() / rule).read_text())
    own = rule_history("component", rule_set([file for rule, file in files.items() if rule == "own"]))
    copies = {rules_folder() / rule: file for rule, file in files.items() if rule != "own"}
    return RuleHistory(own.roots, extra_source=own.extra_source, instead={**dict(own.reading.instead), **copies}), files


def measure_edits(paths: Sequence[Path], rules: Sequence[str], runs: int) -> None:
    """Two rows for each path and rule: a condition that holds is put into the first rule of the file, and one that does not."""
    print("| facts | components | edited | all rows | processor | after the edit | processor | derived again |\n|---|" + "---:|" * 7)
    for path in paths:
        first: list[tuple[float, ...]] = []
        again: dict[tuple[str, str], list[tuple[float, ...]]] = {(rule, condition): [] for rule in rules for condition in EDITS}
        affected: dict[tuple[str, str], int] = {}
        for _ in range(runs):
            with tempfile.TemporaryDirectory() as folder, select(path) as selection:
                known, files = history(rules, Path(folder))
                live = LiveRules(selection.components, known, Path(folder))
                first.append(timed(partial(live.derive, lambda _: WANTED))[1:])
                for edit in again:
                    rule, condition = edit
                    text = files[rule].read_text()
                    files[rule].write_text(text.replace(":-", f":- {condition},", 1))
                    wanted = ("changed_by",) if rule == "own" else WANTED
                    update, *seconds = timed(partial(live.derive, lambda _, wanted=wanted: wanted))
                    files[rule].write_text(text)
                    if update.failures or update.affected is None:
                        raise SystemExit(f"{path}: {update.failures or 'everything was derived again'}")
                    again[edit].append(tuple(seconds))
                    affected[edit] = len(update.affected)
        for rule, condition in again:
            edit = rule, condition
            cells = [f"{statistics.median(row[i] for row in rows):.2f} s" for rows in (first, again[edit]) for i in (0, 1)]
            shown = ("a rule of one's own" if rule == "own" else f"`{rule}`") + EDITS[condition]
            print(f"| {path.stem} | {len(selection.components)} | {shown} | {' | '.join(cells)} | {affected[edit]} |", flush=True)


def run_experiment(plan: Path, cache: Path) -> None:
    """Run an experiment with a cache of its own."""
    command = [sys.executable, "-m", "rosarch.cli", "experiment", str(plan), "--format", "csv"]
    subprocess.run(command, env={**os.environ, "ROSARCH_CACHE_DIR": str(cache)}, check=True, stdout=subprocess.DEVNULL)


def measure_experiment(truth: Path, systems: Path, runs: int) -> None:
    """A row for the experiment; facts are in the cache, results are not."""
    names = sorted({each.system for each in read_truth(truth) if (systems / each.system).exists()})
    with tempfile.TemporaryDirectory() as folder:
        plan = Path(folder, "plan.yml")
        subjects = "".join(f"  {name}: {(systems / name).absolute()}\n" for name in names)
        plan.write_text(f"subjects:\n{subjects}truth: {truth.absolute()}\nvariants: {VARIANTS}\n")
        found = []
        for run in range(runs + 1):
            shutil.rmtree(Path(folder, "cache", "experiments"), ignore_errors=True)
            _, *seconds = timed(partial(run_experiment, plan, Path(folder, "cache")))
            found += [seconds] if run else []
    cells = [f"{statistics.median(row[i] for row in found):.1f} s" for i in (0, 1)]
    print("| systems | components with truth | variants | elapsed | processor |\n|---|" + "---:|" * 4)
    print(f"| {', '.join(names)} | {sum(each.system in names for each in read_truth(truth))} | 3 | {' | '.join(cells)} |")


def main() -> None:
    """Measure what the arguments name."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    edits = commands.add_parser("edits")
    edits.add_argument("paths", metavar="PATH", type=Path, nargs="+")
    edits.add_argument("--rule", metavar="FILE", action="append", help="`own`, or a file of rosarch's rules, from their folder on")
    experiment = commands.add_parser("experiment")
    experiment.add_argument("truth", metavar="TRUTH", type=Path)
    experiment.add_argument("systems", metavar="SYSTEMS", type=Path)
    for each in (edits, experiment):
        each.add_argument("--runs", metavar="N", type=int, default=1)
    arguments = parser.parse_args()
    if arguments.command == "edits":
        measure_edits(arguments.paths, arguments.rule or ["own", "core/behavior/reactive.dl"], arguments.runs)
    else:
        measure_experiment(arguments.truth, arguments.systems, arguments.runs)


if __name__ == "__main__":
    main()
