"""Measure time and memory of `rosarch` on a whole system, on some of its packages, on one of its nodes, or after edits.

    benchmarks/speed.py SYSTEM_DIR [--package NAME]... [--runs N]        `rosarch analyze`
    benchmarks/speed.py SYSTEM_DIR --node PACKAGE/NAME [--runs N]        `rosarch show ports`
    benchmarks/speed.py SYSTEM_DIR --edits N                             `rosarch check` after each of N edits of every kind

Prints a Markdown table. A cold run starts with empty caches, a new system finds only the rules compiled, a warm run is the cold one again.
Memory is the largest resident set of any one process of the run, processor time that of all of them. With edits, libclang alone parses all
sources before and after each kind of run, in as many processes: the figures of different machines do not compare, but multiples of that do.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any

KILOBYTES = 1 if sys.platform != "darwin" else 1024  # the unit of ru_maxrss
CLEAN, FINDINGS = 0, 1
BARE = "bare parse"
_INCLUDED = re.compile(r'^\s*#\s*include\s*[<"]([^>"\n]+)[>"]', re.MULTILINE)


@dataclass(frozen=True)
class Run:
    """What one run cost."""

    seconds: float
    processor: float
    mebibytes: float


def measure(arguments: Sequence[str], folder: Path) -> Run:
    """Run `rosarch` with what it keeps in `folder`; stop the benchmark when it fails."""
    command = [sys.executable, "-m", "rosarch.cli", *arguments]
    environment = {**os.environ, "ROSARCH_CACHE_DIR": str(folder / "cache")}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # modules are compiled once, as in any installation
    log = folder / "log"
    with log.open("w", encoding="utf-8") as output:
        start = time.perf_counter()
        process = subprocess.Popen(command, env=environment, stdout=output, stderr=output)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (CLEAN, FINDINGS):
        raise SystemExit(f"{' '.join(command)} ended with {process.returncode}:\n{log.read_text(encoding='utf-8')}")
    return Run(seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / KILOBYTES / 1024)


def measure_all(arguments: Sequence[str], runs: int) -> dict[str, list[Run]]:
    """The runs of each kind."""
    results: dict[str, list[Run]] = {"cold": [], "new system": [], "warm": []}
    for _ in range(runs):
        with tempfile.TemporaryDirectory(prefix="rosarch-speed-") as name:
            folder = Path(name)
            words = [word.replace(OUT, str(folder / "models")) for word in arguments]
            results["cold"].append(measure(words, folder))
            results["warm"].append(measure(words, folder))
            shutil.rmtree(folder / "cache" / "units")
            results["new system"].append(measure(words, folder))
    return results


OUT = "{out}"
"""Stands for a folder of the benchmark's own."""


def measure_edits(system: Path, edits: int) -> dict[str, list[Run]]:
    """The runs of `rosarch check` on a copy of a system: the first, one without an edit, and one after each edit; these add up."""
    with (
        tempfile.TemporaryDirectory(prefix="rosarch-speed-") as name,
        tempfile.TemporaryDirectory(prefix="rosarch-speed-") as aside,
        ProcessPoolExecutor(1, get_context("spawn")) as other,  # a process begins with the peak memory of the one that starts it
    ):
        folder = Path(name).resolve()
        copy = folder / system.name
        shutil.copytree(system, copy, symlinks=True)
        command = ["check", str(copy)]
        parse = partial(other.submit, bare_parse, system.resolve(), Path(aside))
        results = {BARE: [parse().result()], "cold": [measure(command, folder)]}
        results[BARE].append(parse().result())
        results["nothing changed"] = [measure(command, folder) for _ in range(edits)]
        for kind, files in other.submit(edited_files, copy, folder).result().items():
            results[f"{kind} changed"] = []
            for number, path in enumerate(spread(files, edits)):
                edit(path, number)
                results[f"{kind} changed"].append(measure(command, folder))
            results[BARE].append(parse().result())
        return results


def bare_parse(system: Path, scratch: Path) -> Run:
    """Have libclang parse all sources of a system, in as many processes as `rosarch`; `scratch` holds what is made for it, once."""
    from extract_speed import parse

    from rosarch.base.pool import Failure, default_jobs, run_tasks

    work = _parses(system, scratch)
    start, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
    for _, outcome in run_tasks(lambda given: parse(*given), work, jobs=default_jobs(), timeout=600):
        if isinstance(outcome, Failure):
            raise SystemExit(f"the bare parse failed: {outcome.detail}")
    seconds, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return Run(seconds, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, after.ru_maxrss / KILOBYTES / 1024)


@cache
def _parses(system: Path, scratch: Path) -> Sequence[Any]:
    from extract_speed import parses

    from rosarch.extractor.workspace import discover

    return parses(discover(system), scratch)


def edited_files(root: Path, folder: Path) -> dict[str, list[Path]]:
    """What is there to edit: sources of components that are started, headers that these include, launch files; the smallest first."""
    from rosarch.analysis.method import Method
    from rosarch.cli.inputs import extraction_cache
    from rosarch.cli.systems import SystemInputs, load_systems
    from rosarch.extractor.launch import launch_files
    from rosarch.extractor.settings import Settings

    os.environ["ROSARCH_CACHE_DIR"] = str(folder / "cache")
    analysis = load_systems(SystemInputs(root, Method(sources=Settings(cache=extraction_cache(True)))))
    sources = {root / source for model in analysis.models for source in model.sources}
    included = {name.rpartition("/")[2] for source in sources for name in _INCLUDED.findall(source.read_text(errors="replace"))}
    headers = [path for path in root.rglob("*.h*") if path.name in included]
    found = {"one source": sources, "one header": headers, "one launch file": map(Path, launch_files(root))}
    return {kind: sorted(paths, key=lambda path: (path.stat().st_size, path)) for kind, paths in found.items()}


def spread(files: Sequence[Path], count: int) -> list[Path]:
    """Some of the files, at even distances."""
    return [files[(2 * number + 1) * len(files) // (2 * count)] for number in range(min(count, len(files)))]


def edit(path: Path, number: int) -> None:
    """Put another file in the place of `path`: with a comment more, above all else where that is allowed, so that everything moves."""
    text = path.read_bytes()
    comment = b"edit %d" % number
    change: dict[str, Callable[[], bytes]] = {
        ".launch": lambda: text.replace(b"<launch", b"<!-- %s -->\n<launch" % comment, 1),
        ".xml": lambda: text.replace(b"<launch", b"<!-- %s -->\n<launch" % comment, 1),
        ".py": lambda: text + b"\n# %s\n" % comment,
        ".yaml": lambda: text + b"\n# %s\n" % comment,
    }
    other = path.with_name(f"{path.name}.edited")
    other.write_bytes(change.get(path.suffix, lambda: b"// %s\n%s" % (comment, text))())
    shutil.copymode(path, other)
    other.replace(path)


def table(results: dict[str, list[Run]]) -> str:
    """The results as Markdown; where there was a bare parse, the median run as a multiple of that."""
    bare = statistics.median(run.seconds for run in results[BARE]) if BARE in results else None
    columns = ["min", "median", "max", "processor", "peak memory", *(["to the bare parse"] if bare else [])]
    lines = [f"| run | {' | '.join(columns)} |", f"|---|{'---:|' * len(columns)}"]
    for kind, runs in ((kind, runs) for kind, runs in results.items() if runs):
        seconds = [run.seconds for run in runs]
        median, processor = statistics.median(seconds), statistics.median(run.processor for run in runs)
        figures = [f"{value:.2f} s" for value in (min(seconds), median, max(seconds), processor)]
        figures += [f"{max(run.mebibytes for run in runs):.0f} MiB", *([f"{median / bare:.2f}"] if bare else [])]
        lines.append(f"| {kind} | {' | '.join(figures)} |")
    return "\n".join(lines)


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("system", type=Path)
    parser.add_argument("--package", action="append", default=[])
    parser.add_argument("--node")
    parser.add_argument("--edits", type=int)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    options = parser.parse_args()
    if options.edits:
        print(table(measure_edits(options.system, options.edits)))
        return 0
    command = ["show", "ports", str(options.system), options.node] if options.node else ["analyze", str(options.system), "-o", OUT]
    command += ["--engine", options.engine, *(f"--package={name}" for name in options.package)]
    command += [f"--jobs={options.jobs}"] if options.jobs else []
    print(table(measure_all(command, options.runs)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
