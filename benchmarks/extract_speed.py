"""Measure what it takes to extract facts from sources against what clang alone takes to parse them.

    benchmarks/extract_speed.py SYSTEM_DIR [--package NAME]... [--sources N] [--rounds N]

Prints a Markdown table. Each source is parsed and extracted in turn, in one process, and processor time is counted, so that a busy machine
slows all columns alike. The bare parse sees the same headers, generated and made ones included; *precompiled* is the same parse with the
declarations precompiled that extraction has precompiled as well. Extraction starts with an empty cache in each round: finding headers,
precompiling, healing, walking and writing are all part of it.
"""

from __future__ import annotations

import argparse
import gc
import os
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, arguments_of
from rosarch.extractor.cxx.units import UnitReader
from rosarch.extractor.messages import Interfaces
from rosarch.extractor.survey import compile_units
from rosarch.extractor.workspace import Workspace, components, discover
from rosarch.extractor.workspace.compile_commands import read_compile_commands

COLUMNS = ("bare parse", "precompiled", "extraction")


def sample(workspace: Workspace, packages: Sequence[str], count: int) -> list[CompileUnit]:
    """Sources of all sizes: every n-th of those sorted by size."""
    commands = read_compile_commands(workspace.root)
    found = [c for c in components(workspace) if not packages or c.package in packages]
    units = {unit for component in found for unit in compile_units(workspace, component, commands)}
    ranked = sorted(units, key=lambda unit: (os.path.getsize(unit.source), repr(unit)))
    if not 0 < count < len(ranked):
        return ranked
    return [ranked[int((index + 0.5) * len(ranked) / count)] for index in range(count)]


def seconds(work: Callable[[], object]) -> float:
    """The processor time that `work` takes."""
    start = time.process_time()
    work()
    return time.process_time() - start


def measure(workspace: Workspace, units: Sequence[CompileUnit], scratch: Path) -> dict[str, float]:
    """One round: the time of each column, over all sources."""
    interfaces = Interfaces.of(workspace.packages, workspace.root)
    finder = HeaderFinder(workspace.root, scratch, interfaces.header_text)
    aside = UnitReader(workspace.root, finder, scratch, None)
    reader = UnitReader(workspace.root, finder, scratch / "extraction", None)
    reader.scratch.mkdir()
    total = dict.fromkeys(COLUMNS, 0.0)
    total["extraction"] += seconds(reader.precompiled)
    for unit in units:
        total["extraction"] += seconds(lambda unit=unit: reader.read(unit))  # type: ignore[misc]
        includes = finder.closure(unit.source, unit.folders)
        for column, prelude in (("bare parse", None), ("precompiled", aside.precompiled_for(unit, includes))):
            arguments = arguments_of(unit, includes, prelude)
            total[column] += seconds(lambda unit=unit, arguments=arguments: parse(unit, arguments))  # type: ignore[misc]
    return total


def parses(workspace: Workspace, scratch: Path) -> list[tuple[CompileUnit, list[str]]]:
    """All sources with the arguments of their parse; the declarations are precompiled, other headers generated or made, in `scratch`."""
    finder = HeaderFinder(workspace.root, scratch, Interfaces.of(workspace.packages, workspace.root).header_text)
    reader, found = UnitReader(workspace.root, finder, scratch, None), []
    for unit in sample(workspace, [], 0):
        includes = finder.closure(unit.source, unit.folders)
        found.append((unit, arguments_of(unit, includes, reader.precompiled_for(unit, includes))))
    return found


def parse(unit: CompileUnit, arguments: Sequence[str]) -> None:
    """Parse a source, and no more."""
    with libclang.Unit(unit.source, arguments):
        pass


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("system", type=Path)
    parser.add_argument("--package", action="append", default=[])
    parser.add_argument("--sources", type=int, default=0, help="how many of the sources, of all sizes (default: all)")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    gc.disable()  # as in a worker
    workspace = discover(options.system)
    units = sample(workspace, options.package, options.sources)
    print(f"| {len(units)} sources | {' | '.join(COLUMNS)} | to bare parse | to precompiled |\n|---|---|---|---|---|---|")
    for number in range(options.rounds):
        with tempfile.TemporaryDirectory(prefix="rosarch-speed-") as scratch:
            total = measure(workspace, units, Path(scratch))
        figures = [f"{total[column]:.2f} s" for column in COLUMNS]
        ratios = [f"{total['extraction'] / total[column]:.2f}" for column in COLUMNS[:2]]
        print(f"| round {number + 1} | {' | '.join([*figures, *ratios])} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
