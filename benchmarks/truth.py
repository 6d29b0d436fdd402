"""Score the models of real systems against hand-written ground truth.

    benchmarks/truth.py TRUTH_DIR SYSTEMS_DIR --out MODELS_DIR

TRUTH_DIR holds one folder of truth files per system, SYSTEMS_DIR the sources of each system under the same name. Only the packages
that the truth names are analysed. The models go to MODELS_DIR/<system>/<package>/<component>.json; the table that is printed is that
of the truth's own `score.py`, which is looked for beside TRUTH_DIR and above.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import yaml

from rosarch.models.analysis import analyze
from rosarch.reports.json_models import write_models


def wanted_packages(truth: Path) -> dict[str, set[str]]:
    """The packages of each system that the truth files below `truth` name."""
    wanted: dict[str, set[str]] = {}
    for path in sorted(truth.rglob("*.yml")):
        document = yaml.safe_load(path.read_text(encoding="utf-8"))
        if isinstance(document, dict) and "component" in document:
            wanted.setdefault(document.get("system", path.parent.name), set()).add(document["package"])
    return wanted


def find_scorer(truth: Path) -> Path:
    """The nearest `score.py` in `truth` or above it."""
    for folder in (truth, *truth.parents):
        if (folder / "score.py").is_file():
            return folder / "score.py"
    raise SystemExit(f"{truth}: no score.py here or in a folder above")


def remove_models(folder: Path) -> None:
    """Remove the models of an earlier run: one that is no longer made must not count as found."""
    for path in folder.glob("*/*.json"):
        path.unlink()


def analyze_systems(wanted: dict[str, set[str]], options: argparse.Namespace) -> Iterator[str]:
    """Write the models of each system; yield a line of progress per system."""
    for system, packages in wanted.items():
        root = options.systems / system
        remove_models(options.out / system)
        if not root.is_dir():
            yield f"{system}: no folder {root}, its components count as missed"
            continue
        start = time.perf_counter()
        analysis = analyze(root, packages, engine=options.engine, jobs=options.jobs)
        write_models(analysis.models, options.out / system)
        for diagnostic in analysis.diagnostics:
            if diagnostic.kind in ("component", "source", "workspace"):
                yield str(diagnostic).partition("\n")[0]
        yield f"{system}: {len(analysis.models)} components of {len(packages)} packages in {time.perf_counter() - start:.1f} s"


def main() -> int:
    """Analyse, then print the scorer's table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("truth", type=Path)
    parser.add_argument("systems", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="where the models are written")
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--misses", action="store_true", help="list every missed and every extra element")
    options = parser.parse_args()
    scorer = find_scorer(options.truth.resolve())
    for line in analyze_systems(wanted_packages(options.truth), options):
        print(line, file=sys.stderr)
    command = [sys.executable, str(scorer), str(options.truth), str(options.out)]
    return subprocess.run(command + ["--misses"] * options.misses, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
