"""Compare what rosarch and the real xacro make of xacro files.

    benchmarks/xacro.py ORACLE.jsonl ROOT [--order noetic|inorder|traditional] [--package-path DIR]

ORACLE.jsonl has one JSON object per file below ROOT: `file`, the `arguments` it was evaluated with, if any (a list of `name:=value`), and
either the `text` that xacro printed or the `exception` it stopped with. ROOT is the package path. The first difference of each file is
listed; the exit code is 1 if there is one. A file that xacro rejects must be rejected by rosarch.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

from rosarch.extractor.launch import Files, PackagePath
from rosarch.extractor.launch.names import mapping
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf import IN_ORDER, NOETIC, TRADITIONAL, expand, write

ORDERS = {"noetic": NOETIC, "inorder": IN_ORDER, "traditional": TRADITIONAL}


def difference(oracle: dict[str, Any], root: Path, files: Files, order: str) -> str | None:
    """The first difference for one file."""
    path = str(root / oracle["file"])
    arguments = dict(pair for word in oracle.get("arguments", ()) if (pair := mapping(word)))
    unknowns = Unknowns()
    files.allow_beside(path)
    expansion = expand(path, arguments, files=files, environment=os.environ, unknowns=unknowns, dialect=ORDERS[order])
    refusal = next((problem for problem in expansion.problems if problem.fatal), None)
    if "exception" in oracle:
        return None if refusal else f"xacro: {oracle['exception']!r}, rosarch: no refusal"
    if expansion.document is None:
        return f"xacro accepts it, rosarch refuses: {refusal}"
    mine = unknowns.render(write(expansion.document, path)).splitlines()
    for number, (theirs, own) in enumerate(itertools.zip_longest(oracle["text"].splitlines(), mine), 1):
        if theirs != own:
            return f"line {number} of the output is {theirs!r}, rosarch has {own!r}"
    return None


def main() -> int:
    """Compare all records; 1 when something differs."""
    parser = argparse.ArgumentParser(description="Compare what rosarch and the real xacro make of xacro files.")
    parser.add_argument("oracle", type=Path, metavar="ORACLE.jsonl", help="what xacro made of them")
    parser.add_argument("root", type=Path, metavar="ROOT", help="the folder they lie in")
    parser.add_argument("--order", choices=ORDERS, default="noetic", help="the release and order of xacro")
    parser.add_argument("--package-path", type=Path, action="append", metavar="DIR", default=[], help="more packages")
    options = parser.parse_args()
    root = options.root.resolve()
    files = Files(PackagePath([root, *options.package_path]), str(root))
    counts: Counter[str] = Counter()
    start = time.perf_counter()
    for line in options.oracle.read_text(encoding="utf-8").splitlines():
        oracle = json.loads(line)
        found = difference(oracle, root, files, options.order)
        kind = "refused" if "exception" in oracle else "accepted"
        counts[kind] += 1
        counts[f"{kind} equal"] += not found
        if found:
            print(f"{oracle['file']}: {found}")
    print(
        f"{root.name}: {counts['accepted equal']} of {counts['accepted']} files that xacro accepts are equal,"
        f" {counts['refused equal']} of {counts['refused']} that it refuses are refused, {time.perf_counter() - start:.1f} s"
    )
    return int(counts["accepted equal"] != counts["accepted"] or counts["refused equal"] != counts["refused"])


if __name__ == "__main__":
    sys.exit(main())
