"""Measure time and memory of `rosarch analyze` on a whole system or on some of its packages.

    benchmarks/speed.py SYSTEM_DIR [--package NAME]... [--runs N]

Prints a Markdown table. A cold run starts with empty caches, a new system finds only the rules compiled, a warm run is the cold one again.
Memory is the largest resident set of any one process of the run.
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
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

KILOBYTES = 1 if sys.platform != "darwin" else 1024  # the unit of ru_maxrss


@dataclass(frozen=True)
class Run:
    """What one run cost."""

    seconds: float
    mebibytes: float


def measure(command: Sequence[str], cache: Path, log: Path) -> Run:
    """Run `command`; stop the benchmark when it fails."""
    environment = {**os.environ, "ROSARCH_CACHE_DIR": str(cache)}
    with log.open("w", encoding="utf-8") as output:
        start = time.perf_counter()
        process = subprocess.Popen(command, env=environment, stdout=output, stderr=output)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{' '.join(command)} ended with {process.returncode}:\n{log.read_text(encoding='utf-8')}")
    return Run(seconds, usage.ru_maxrss / KILOBYTES / 1024)


def measure_all(system: Path, options: Sequence[str], runs: int) -> dict[str, list[Run]]:
    """The runs of each kind."""
    results: dict[str, list[Run]] = {"cold": [], "new system": [], "warm": []}
    for _ in range(runs):
        with tempfile.TemporaryDirectory(prefix="rosarch-speed-") as name:
            folder = Path(name)

            def run(folder: Path = folder) -> Run:
                command = [sys.executable, "-m", "rosarch.cli.main", "analyze", str(system), "-o", str(folder / "models"), *options]
                return measure(command, folder / "cache", folder / "log")

            results["cold"].append(run())
            results["warm"].append(run())
            shutil.rmtree(folder / "cache" / "units")
            results["new system"].append(run())
    return results


def table(results: dict[str, list[Run]]) -> str:
    """The results as Markdown."""
    lines = ["| run | min | median | max | peak memory |", "|---|---|---|---|---|"]
    for kind, runs in results.items():
        seconds = [run.seconds for run in runs]
        figures = " | ".join(f"{value:.2f} s" for value in (min(seconds), statistics.median(seconds), max(seconds)))
        lines.append(f"| {kind} | {figures} | {max(run.mebibytes for run in runs):.0f} MiB |")
    return "\n".join(lines)


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("system", type=Path)
    parser.add_argument("--package", action="append", default=[])
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    options = parser.parse_args()
    extra = ["--engine", options.engine, *(f"--package={name}" for name in options.package)]
    extra += [f"--jobs={options.jobs}"] if options.jobs else []
    print(table(measure_all(options.system, extra, options.runs)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
