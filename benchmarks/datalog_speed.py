"""Measure the embedded Datalog engine against the souffle binary: the same programs, turn about, in one run.

    benchmarks/datalog_speed.py SOUFFLE [--suite SOUFFLE_SOURCE_DIR [--program NAME]...] [--facts FACTS_DIR] [--runs N]

SOUFFLE is the binary; it interprets, as it does by default. `--suite`: a checkout of souffle-lang/souffle, of which the programs that
take the binary longest are measured. `--facts`: what `rosarch extract` wrote for a system, on which rosarch's own rules are measured, a
process for each component. Prints a Markdown table of wall-clock time and peak memory, each the median of the runs (time summed over
components, memory of the largest), and stops when the two engines write different rows.
"""

from __future__ import annotations

import argparse
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import souffle_suite

KILOBYTES = 1 if sys.platform != "darwin" else 1024  # the unit of ru_maxrss
NODES, EDGES, SEED = 6000, 7500, 1
CLOSURE = """.decl edge(a: number, b: number)
.input edge
.decl path(a: number, b: number)
.output path
path(X, Y) :- edge(X, Y).
path(X, Z) :- path(X, Y), edge(Y, Z).
"""
ONE_LINE = ".decl answer(n: number) .output answer answer(42).\n"
RULES = Path(__file__).resolve().parents[1] / "rules" / "component.dl"


class CommandError(SystemExit):
    """A command has failed; ends the benchmark unless that was to be expected."""


@dataclass(frozen=True)
class Task:
    """A program with one or more folders of facts, each of which is a run of its own."""

    title: str
    program: Path
    facts: tuple[Path, ...]
    cold: bool = False  # without the compiled programs of earlier runs

    def options(self, facts: Path) -> list[str]:
        """The options of both commands."""
        return ["-w", "-F", str(facts), "-D", ".", str(self.program)]


@dataclass(frozen=True)
class Cost:
    """What a command took."""

    seconds: float
    mebibytes: float


class Benchmark:
    """Runs tasks with both engines below a folder for what they write."""

    def __init__(self, souffle: Path, folder: Path) -> None:
        self.souffle = souffle
        self.folder = folder

    def measure(self, command: Sequence[str], out: Path, cache: Path) -> Cost:
        """Run a command in an empty folder `out`."""
        subprocess.run(["rm", "-rf", str(out)], check=True)
        out.mkdir(parents=True)
        with (out / ".log").open("wb") as log:
            start = time.perf_counter()
            environment = {**os.environ, "ROSARCH_CACHE_DIR": str(cache)}
            process = subprocess.Popen(command, cwd=out, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
            _, status, usage = os.wait4(process.pid, 0)
            seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            raise CommandError(f"{' '.join(command)} ended with {process.returncode}:\n{(out / '.log').read_text(errors='replace')}")
        return Cost(seconds, usage.ru_maxrss / KILOBYTES / 1024)

    def pair(self, task: Task, facts: Path) -> tuple[Cost, Cost]:
        """Both engines once on one folder of facts."""
        return self.theirs(task, facts), self.ours(task, facts)

    def theirs(self, task: Task, facts: Path) -> Cost:
        """The binary once."""
        return self.measure([str(self.souffle), *task.options(facts)], self.folder / "souffle", self.folder / "cache")

    def ours(self, task: Task, facts: Path) -> Cost:
        """The embedded engine once."""
        with tempfile.TemporaryDirectory(dir=self.folder) as empty:
            cache = Path(empty) if task.cold else self.folder / "cache"
            return self.measure([sys.executable, "-m", "rosarch.datalog", *task.options(facts)], self.folder / "embedded", cache)

    def check(self, task: Task, facts: Path) -> None:
        """Stop when the engines wrote different rows."""
        written = {path.name for path in (self.folder / "souffle").glob("*.csv")}
        for name in sorted(written):
            if checksum(self.folder / "souffle" / name) != checksum(self.folder / "embedded" / name):
                raise SystemExit(f"{task.title}, facts {facts}: {name} differs")

    def run(self, task: Task, runs: int) -> str:
        """The row of the table for a task."""
        self.ours(task, task.facts[0])  # compiles the program
        totals: list[tuple[Cost, Cost]] = []
        for _ in range(runs):
            pairs = []
            for facts in task.facts:
                pairs.append(self.pair(task, facts))
                self.check(task, facts)
            both = [Cost(sum(p[i].seconds for p in pairs), max(p[i].mebibytes for p in pairs)) for i in (0, 1)]
            totals.append((both[0], both[1]))
        theirs, ours = (median([t[i] for t in totals]) for i in (0, 1))
        return (
            f"| {task.title} | {theirs.seconds:.2f} s | {ours.seconds:.2f} s | {ours.seconds / theirs.seconds:.2f} "
            f"| {theirs.mebibytes:.0f} MiB | {ours.mebibytes:.0f} MiB | {ours.mebibytes / theirs.mebibytes:.2f} |"
        )

    def heaviest(self, suite: Path, count: int, names: Sequence[str]) -> list[Task]:
        """The programs of souffle's suite that take the binary longest, or those of these names."""
        cases = [c for folder in souffle_suite.FOLDERS for c in souffle_suite.cases(suite.resolve(), folder)]
        found = [Task(f"suite: {case.name}", case.program, (case.facts,)) for case in cases if not names or case.name in names]
        if names:
            return found
        times: dict[Task, float] = {}
        for task in found:
            try:
                times[task] = self.theirs(task, task.facts[0]).seconds
            except CommandError:
                continue  # some need functors in a library of their own
        return sorted(times, key=lambda task: -times[task])[:count]


def median(costs: Sequence[Cost]) -> Cost:
    """The median of time and of memory."""
    return Cost(statistics.median(c.seconds for c in costs), statistics.median(c.mebibytes for c in costs))


def checksum(path: Path) -> tuple[int, int]:
    """The number of lines of a file and the sum of their hashes, whatever their order."""
    count, total = 0, 0
    with path.open("rb") as stream:
        for line in stream:
            count += 1
            total += hash(line)
    return count, total


def closure(folder: Path) -> Task:
    """The transitive closure of a random graph."""
    source = random.Random(SEED)
    edges: set[tuple[int, int]] = set()
    while len(edges) < EDGES:
        edges.add((source.randrange(NODES), source.randrange(NODES)))
    facts = folder / "graph"
    facts.mkdir()
    (facts / "edge.facts").write_text("".join(f"{a}\t{b}\n" for a, b in sorted(edges)), encoding="utf-8")
    program = folder / "closure.dl"
    program.write_text(CLOSURE, encoding="utf-8")
    return Task(f"transitive closure, {NODES} nodes, {EDGES} edges", program, (facts,))


def tasks(options: argparse.Namespace, benchmark: Benchmark) -> Iterator[Task]:
    """What is to be measured."""
    yield closure(benchmark.folder)
    if options.suite:
        yield from benchmark.heaviest(options.suite, options.heaviest, options.program)
    if options.facts:
        components = tuple(sorted({path.parent for path in options.facts.resolve().glob("*/*/*.facts")}))
        yield Task(f"rosarch's rules, {len(components)} components", RULES, components)
    line = benchmark.folder / "line.dl"
    line.write_text(ONE_LINE, encoding="utf-8")
    yield Task("one line", line, (benchmark.folder / "graph",))
    yield Task("one line, not seen before", line, (benchmark.folder / "graph",), cold=True)


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("souffle", type=Path, help="the souffle binary")
    parser.add_argument("--suite", type=Path, help="a checkout of souffle-lang/souffle")
    parser.add_argument("--heaviest", type=int, default=4, help="how many programs of the suite")
    parser.add_argument("--program", action="append", default=[], metavar="NAME", help="this program of the suite, instead of the heaviest")
    parser.add_argument("--facts", type=Path, help="a folder that `rosarch extract` wrote")
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    print("| program | souffle | rosarch | time ratio | souffle | rosarch | memory ratio |")
    print("|---|---:|---:|---:|---:|---:|---:|", flush=True)
    with tempfile.TemporaryDirectory(prefix="rosarch-datalog-") as name:
        benchmark = Benchmark(options.souffle.resolve(), Path(name))
        for task in tasks(options, benchmark):
            print(benchmark.run(task, options.runs), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
