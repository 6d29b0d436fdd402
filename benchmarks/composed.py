"""How much of what public robots start is composed: nodes with a model, launch files that are read, and why the others are not.

    benchmarks/composed.py SYSTEMS_DIR SYSTEM... [--underlay DIR] [--no-library] [--missing]

Each launch file that no other of the system includes is composed. A node or include counts once for each place that names it, however many
launch files lead there. `--missing` lists what is missing of all systems together, most frequent first: in how many systems, and how often.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections import Counter, defaultdict
from dataclasses import dataclass, field, replace
from pathlib import Path

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import unincluded
from rosarch.analysis.systems.requests import LaunchEnvironment
from rosarch.base.boundary import confined
from rosarch.base.cache import Cache
from rosarch.base.memo import Memo
from rosarch.base.places import Place
from rosarch.datalog.cache import cache_folder
from rosarch.extractor.launch import PackagePath
from rosarch.extractor.launch.model import Include
from rosarch.extractor.settings import Settings
from rosarch.extractor.underlay import Underlay
from rosarch.library import prefixes
from rosarch.models.system.model import SystemNode

_PACKAGE = re.compile(r"\$\((?:find-pkg-share|find-pkg-prefix|find) ([\w.-]+)\)")
_OPEN = re.compile(r"\$\(|\?")


@dataclass
class Composed:
    """What one system starts and includes; `missing` are reasons with what they are about."""

    nodes: set[tuple[Place, str, str]] = field(default_factory=set)
    includes: set[tuple[Place, str]] = field(default_factory=set)
    missing: dict[tuple[str, str, str], set[Place]] = field(default_factory=lambda: defaultdict(set))
    launches: int = 0
    problems: int = 0

    def without(self, kind: str) -> int:
        """How many nodes, or includes, are missing."""
        return sum(len(places) for (what, _, _), places in self.missing.items() if what == kind)


def compose(root: Path, underlay: Underlay) -> Composed:
    """All that the launch files of a system start and include."""
    cache = Cache(cache_folder() / "units")
    where = LaunchEnvironment(root, (root,), {}, underlay)
    own = set(PackagePath([root]).packages)
    found = Composed()
    with confined([root, *underlay.folders]):
        launches = unincluded(where)
        memo = Memo(cache, where.variables())
        analysis = analyze_systems(root, launches, Method(sources=Settings(cache=cache, underlay=underlay)), memo)
    found.launches, found.problems = len(launches), len(launches) - len(analysis.systems)
    for system in analysis.systems:
        for node in system.nodes:
            found.nodes.add((node.lines[-1], node.package, node.type))
            if node.origin == "unknown":
                found.missing["node", _why_unknown(node, own), f"{node.package} {node.type}"].add(node.lines[-1])
    for include in (include for launch in launches for include in launch.composition.includes):
        at = Place(include.lines[-1].path, include.lines[-1].line, include.lines[-1].column)
        found.includes.add((at, include.text))
        if include.file is None:
            why, what = _why_unread(include, own)
            found.missing["include", why, what].add(at)
    return found


def _why_unknown(node: SystemNode, own: set[str]) -> str:
    if _OPEN.search(node.package + node.type):
        return "which program is not known"
    return "no model of a program of the system" if node.package in own else "neither in the system nor in the library"


def _why_unread(include: Include, own: set[str]) -> tuple[str, str]:
    package = _PACKAGE.search(include.text)
    if package and package[1] not in own:
        return "package not in the system", f"{package[1]} {os.path.basename(include.text)}"
    rest = _PACKAGE.sub("", include.text)
    return ("which file is not known" if _OPEN.search(rest) else "no such file in the system"), os.path.basename(include.text)


def share(found: int, all_: int) -> str:
    """A part of a whole."""
    return f"{found}/{all_}" + (f" ({100 * found / all_:.0f} %)" if all_ else "")


def main() -> int:
    """Print a row for each system, and all together."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("names", nargs="+", metavar="SYSTEM")
    parser.add_argument("--underlay", type=Path, action="append", default=[])
    parser.add_argument("--no-library", action="store_true", help="without the launch files and parameters of the library")
    parser.add_argument("--missing", action="store_true")
    options = parser.parse_args()
    underlay = replace(Underlay.of(options.underlay), libraries=() if options.no_library else prefixes())
    reasons: Counter[tuple[str, str]] = Counter()
    missing: dict[tuple[str, str, str], Counter[str]] = defaultdict(Counter)
    total = Counter[str]()
    print("| system | launches | nodes with a model | includes read |\n|---|---|---|---|")
    for name in options.names:
        found = compose(options.systems / name, underlay)
        nodes, includes = len(found.nodes), len(found.includes)
        known, read = nodes - found.without("node"), includes - found.without("include")
        print(f"| {name} | {found.launches} | {share(known, nodes)} | {share(read, includes)} |", flush=True)
        total.update(launches=found.launches, nodes=nodes, known=known, includes=includes, read=read)
        for (kind, why, what), places in found.missing.items():
            reasons[kind, why] += len(places)
            missing[kind, why, what][name] += len(places)
    print(f"| all | {total['launches']} | {share(total['known'], total['nodes'])} | {share(total['read'], total['includes'])} |\n")
    for (kind, why), count in sorted(reasons.items(), key=lambda item: (item[0][0], -item[1])):
        print(f"- {count} {kind}s: {why}")
    if options.missing:
        for (kind, why, what), where in sorted(missing.items(), key=lambda item: (item[0][0], -len(item[1]), -item[1].total(), item[0])):
            print(f"{kind}\t{len(where)}\t{where.total()}\t{what}\t{why}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
