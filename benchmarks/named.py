"""What public robots name of packages that they do not have themselves: programs, launch files, packages.

    benchmarks/named.py SYSTEMS_DIR SYSTEM... > benchmarks/named.tsv

A row for each program that launch files start, each launch file that they include, and each package that a manifest depends on, in all
launch files that no other includes: in how many systems, and at how many places. The library is chosen by this.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from rosarch.analysis.systems.launches import unincluded
from rosarch.analysis.systems.manifests import declared
from rosarch.analysis.systems.requests import LaunchEnvironment
from rosarch.base.boundary import confined
from rosarch.extractor.launch import PackagePath

_INCLUDED = re.compile(r"\$\((?:find-pkg-share|find-pkg-prefix|find) ([\w.-]+)\)(?:/share/[\w.-]+)?(?:/.*)?/([^/]+)$")


def named(root: Path) -> Iterator[tuple[str, str, str, str]]:
    """Kind, version of ROS, name and place of all that a system names."""
    own = set(PackagePath([root]).packages)
    with confined([root]):
        launches = unincluded(LaunchEnvironment(root, (root,), {}))
        manifests = declared(root)
    for launch in launches:
        for node in launch.composition.nodes:
            if node.package not in own and node.package.isidentifier():
                yield "program", str(node.ros), f"{node.package} {node.type}", str(node.lines[-1])
        for include in launch.composition.includes:
            found = _INCLUDED.search(include.text)
            if include.file is None and found and found[1] not in own:
                yield "include", str(launch.composition.ros), f"{found[1]} {found[2]}", str(include.lines[-1])
    for one in manifests:
        for name in one.depends - own:
            yield "package", "", name, one.folder


def main() -> int:
    """Print the rows, those that most systems have first."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("names", nargs="+", metavar="SYSTEM")
    options = parser.parse_args()
    where: dict[tuple[str, str, str], dict[str, set[str]]] = defaultdict(lambda: defaultdict(set))
    for name in options.names:
        print(name, file=sys.stderr, flush=True)
        for kind, ros, what, place in named(options.systems / name):
            where[kind, ros, what][name].add(place)
    print("kind\tros\tname\tsystems\tplaces")
    rows = [(*key, len(found), sum(map(len, found.values()))) for key, found in where.items()]
    for kind, ros, what, systems, places in sorted(rows, key=lambda row: (row[0], -row[3], -row[4], row[:3])):
        if systems > 1 or kind != "package":
            print(kind, ros, what, systems, places, sep="\t")
    return 0


if __name__ == "__main__":
    sys.exit(main())
