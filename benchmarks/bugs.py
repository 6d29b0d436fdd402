#!/usr/bin/env python3
"""Check the buggy and the fixed tree of real misconfiguration bugs.

Usage: bugs.py BUGS.yml TREES_DIR --out FINDINGS_DIR [--bug ID ...]

TREES_DIR/<id>/{buggy,fixed} are the trees; FINDINGS_DIR/<id>.{buggy,fixed}.json become lists of
{"message", "file", "line", "check", "severity"}. `${T}` in a bug's arguments and variables is its tree, `${B}` the folder of BUGS.yml.
Packages are looked for in the tree, then in the bug's `companions` (TREES_DIR/<id>/<path>: siblings of the same day, which the tree
needs), then in `stubs/` beside BUGS.yml, which replace absent packages. No path of the machine is written, so that both trees
can be compared.
"""

from __future__ import annotations

import argparse
import json
import shlex
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import analyze_systems
from rosarch.analysis.systems.launches import given
from rosarch.analysis.systems.requests import LaunchEnvironment, parse_request
from rosarch.cli.inputs import extraction_cache
from rosarch.extractor.settings import Settings
from rosarch.findings.model import Finding


@dataclass(frozen=True)
class Place:
    """Where one side of a bug lies: its tree, what is beside it, and the folder of BUGS.yml."""

    tree: Path
    beside: Path
    bugs: Path

    def package_path(self, bug: dict[str, Any]) -> tuple[Path, ...]:
        """The tree, its companions in their order, and the stubs; of two packages of one name the first counts."""
        companions = [self.beside / companion["path"] for companion in bug.get("companions", ())]
        return (self.tree, *companions, self.bugs / "stubs")

    def relative(self, text: str) -> str:
        """A text with its paths relative to the folder that they lie in."""
        for folder in (self.tree, self.beside, self.bugs):
            text = text.replace(f"{folder}/", "")
        return text


def check_tree(bug: dict[str, Any], side: str, place: Place) -> tuple[Finding, ...]:
    """The findings about the system that a bug names, in one of its trees."""
    tree, bugs = place.tree, place.bugs

    def filled(text: str) -> str:
        return text.replace("${T}", str(tree)).replace("${B}", str(bugs))

    environment = {name: filled(str(value)) for name, value in bug.get("env", {}).items()}
    where = LaunchEnvironment(tree, place.package_path(bug), environment)
    texts = []
    for launch in bug["launch"]:
        words = [*launch.get("args", ()), *launch.get(f"args_{side}", ())]
        texts.append([str(tree / launch["file"]), *(filled(word).replace(",", "\\,") for word in words)])
    if bug.get("launch_inline_file"):
        texts.append([str(bugs / bug["launch_inline_file"])])
    if bug.get("launch_mode") == "together":
        texts = [[word for words in texts for word in words]]
    method = Method(sources=Settings(cache=extraction_cache(True)))
    return analyze_systems(tree, given(map(parse_request, map(shlex.join, texts)), where), method).findings


def document(finding: Finding, place: Place) -> dict[str, Any]:
    """A finding as `evaluate.py` wants it: where the fault lies, and of the chain of evidence nothing else."""
    return {
        "message": place.relative(finding.message),
        "file": place.relative(finding.place.path),
        "line": finding.place.line,
        "check": finding.check.id,
        "severity": finding.severity,
    }


def main() -> None:
    """Write the findings of every bug."""
    parser = argparse.ArgumentParser(description="Check the buggy and the fixed tree of real misconfiguration bugs.")
    parser.add_argument("bugs", type=Path)
    parser.add_argument("trees", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--bug", action="append", metavar="ID", help="only this one; may be repeated")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for bug in yaml.safe_load(options.bugs.read_text(encoding="utf-8")):
        if options.bug and bug["id"] not in options.bug:
            continue
        for side in ("buggy", "fixed"):
            beside = (options.trees / bug["id"]).resolve()
            place = Place(beside / side, beside, options.bugs.parent.resolve())
            start = time.perf_counter()
            found = check_tree(bug, side, place)
            rows = [document(finding, place) for finding in found]
            (options.out / f"{bug['id']}.{side}.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
            print(f"{bug['id']:13} {side:6} {len(rows):4} findings {time.perf_counter() - start:7.1f} s", flush=True)


if __name__ == "__main__":
    main()
