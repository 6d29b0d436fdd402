"""Run Soufflé's own test programs with the embedded engine and compare every expected output.

    benchmarks/souffle_suite.py SOUFFLE_SOURCE_DIR [--only FOLDER] [--test NAME]... [--list]

A case is a folder of `tests/evaluation` or `tests/example` with a program and expected outputs: `.csv` files, and a `.out` file where the
program prints. It passes when each of them has the same lines, each as often, in any order, and when no further `.csv` is written; so does
souffle compare them. In `tests/semantic` and `tests/syntactic` there are programs without outputs too: a program that souffle rejects
passes when it is rejected, without a traceback. Prints a table, and the cases that do not pass with the reason. The exit code is 1 when one
does not pass.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

FOLDERS = ("evaluation", "example")
CHECKS = ("semantic", "syntactic")


@dataclass(frozen=True)
class Case:
    """A program, its facts, and the folder of what it should write."""

    folder: str
    name: str
    program: Path
    facts: Path
    expected: tuple[Path, ...]
    refused: bool = False


@dataclass(frozen=True)
class Outcome:
    """How a case ended; no reason means that it passed."""

    seconds: float
    reason: str = ""


def cases(root: Path, folder: str) -> Iterator[Case]:
    """The cases of `tests/evaluation` or `tests/example`; a program with several sets of facts is several cases."""
    if folder in CHECKS:
        yield from _checks(root, folder)
        return
    for home in sorted(p for p in (root / "tests" / folder).iterdir() if p.is_dir()):
        program = home / f"{home.name}.dl"
        if not program.is_file():
            continue
        expected = _expected(home, home.name)
        if expected:
            facts = home / "facts"
            yield Case(folder, home.name, program, facts if facts.is_dir() else home, expected)
            continue
        for facts in sorted(p for p in home.iterdir() if p.is_dir() and any(p.glob("*.csv"))):
            yield Case(folder, f"{home.name}/{facts.name}", program, facts, _expected(facts, home.name))


def _checks(root: Path, folder: str) -> Iterator[Case]:
    """The tests that are listed as positive or negative ones."""
    listed = (root / "tests" / folder / "CMakeLists.txt").read_text(encoding="utf-8")
    for kind, name in sorted(re.findall(r"^\s*(positive|negative)_test\((\w+)[ )]", listed, re.MULTILINE), key=lambda found: found[1]):
        home = root / "tests" / folder / name
        facts = home / "facts"
        expected = () if kind == "negative" else _expected(home, name)
        yield Case(folder, name, home / f"{name}.dl", facts if facts.is_dir() else home, expected, kind == "negative")


def _expected(home: Path, name: str) -> tuple[Path, ...]:
    printed = home / f"{name}.out"
    return (*sorted(home.glob("*.csv")), *([printed] if printed.is_file() and printed.stat().st_size else []))


def run(case: Case, time_limit: float, memory_limit: int, cache: Path) -> Outcome:
    """Run one case in a process of its own."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (memory_limit << 20, memory_limit << 20))

    with tempfile.TemporaryDirectory(prefix="rosarch-suite-") as name:
        out = Path(name)
        command = [sys.executable, "-m", "rosarch.datalog", str(case.program), "-F", str(case.facts), "-D", "."]
        start = time.perf_counter()
        with (out / ".out").open("wb") as printed, (out / ".err").open("wb") as errors:
            try:
                environment = {**os.environ, "ROSARCH_CACHE_DIR": str(cache)}
                done = subprocess.run(
                    command, cwd=out, stdin=subprocess.DEVNULL, stdout=printed, stderr=errors, timeout=time_limit,
                    check=False, preexec_fn=limit, env=environment,
                )  # fmt: skip
            except subprocess.TimeoutExpired:
                return Outcome(time_limit, f"still running after {time_limit:g} s")
        seconds = time.perf_counter() - start
        if case.refused and done.returncode == 2:
            return Outcome(seconds)
        if case.refused:
            return Outcome(seconds, "not refused" if not done.returncode else f"exit code {done.returncode}")
        if done.returncode:
            lines = (out / ".err").read_text(errors="replace").strip().splitlines() or [f"exit code {done.returncode}"]
            return Outcome(seconds, lines[-1] if lines[0].startswith("Traceback") else lines[0])
        return Outcome(seconds, "; ".join(_differences(case, out)))


def _differences(case: Case, out: Path) -> Iterator[str]:
    for path in case.expected:
        actual = out / (".out" if path.suffix == ".out" else path.name)
        if not actual.is_file():
            yield f"{path.name} is not written"
            continue
        wanted, found = _lines(path), _lines(actual)
        if wanted != found:
            parts = [
                f"`{row}` {what}"
                for rows, what in ((wanted - found, "is missing"), (found - wanted, "is wrong"))
                for row in sorted(rows)[:1]
            ]
            yield f"{path.name}: {(wanted - found).total()} rows missing, {(found - wanted).total()} wrong ({', '.join(parts)})"
    names = {path.name for path in case.expected}
    for extra in sorted(p.name for p in out.glob("*.csv") if p.name not in names):
        yield f"{extra} is written and not expected"


def _lines(path: Path) -> Counter[str]:
    """The lines of a file, each with how often it is there."""
    return Counter(path.read_text(encoding="utf-8", errors="replace").splitlines())


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("souffle", type=Path, help="a checkout of souffle-lang/souffle")
    parser.add_argument("--only", choices=(*FOLDERS, *CHECKS), help="one of the folders")
    parser.add_argument("--checks", action="store_true", help="run semantic and syntactic too")
    parser.add_argument("--test", action="append", help="only the case of this name")
    parser.add_argument("--list", action="store_true", help="tell every case with its time as it ends")
    parser.add_argument("--time-limit", type=float, default=60, metavar="SECONDS")
    parser.add_argument("--memory-limit", type=int, default=3072, metavar="MEBIBYTES")
    options = parser.parse_args(argv)
    folders = [options.only] if options.only else (*FOLDERS, *CHECKS) if options.checks else FOLDERS
    outcomes: dict[Case, Outcome] = {}
    with tempfile.TemporaryDirectory(prefix="rosarch-cache-") as cache:
        for case in (c for folder in folders for c in cases(options.souffle.resolve(), folder)):
            if options.test and case.name not in options.test:
                continue
            outcomes[case] = run(case, options.time_limit, options.memory_limit, Path(cache))
            if options.list:
                print(
                    f"{case.folder}/{case.name}: {outcomes[case].seconds:.2f} s {outcomes[case].reason or 'passed'}"[:400], file=sys.stderr
                )
    _print_table(folders, outcomes)
    return 1 if any(o.reason for o in outcomes.values()) else 0


def _print_table(folders: Sequence[str], outcomes: dict[Case, Outcome]) -> None:
    print("| folder | passed | of | share |\n|---|---:|---:|---:|")
    for folder in (*folders, "all"):
        chosen = [o for c, o in outcomes.items() if folder in ("all", c.folder)]
        passed = sum(not o.reason for o in chosen)
        print(f"| {folder} | {passed} | {len(chosen)} | {100 * passed / max(len(chosen), 1):.1f} % |")
    failed = [(c, o) for c, o in outcomes.items() if o.reason]
    if failed:
        print("\n| not passed | reason |\n|---|---|")
    for case, outcome in failed:
        reason = outcome.reason.replace(str(case.program.parent) + "/", "").replace("|", "\\|")
        print(f"| {case.folder}/{case.name} | {reason[:200]} |")


if __name__ == "__main__":
    sys.exit(main())
