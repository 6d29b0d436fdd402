"""Score the models of real systems against hand-written ground truth.

    benchmarks/truth.py TRUTH_DIR SYSTEMS_DIR --out MODELS_DIR

TRUTH_DIR holds one folder of truth files per system, SYSTEMS_DIR the sources of each system under the same name. Only the components
that the truth names are analysed, without caches; those that SYSTEMS_DIR does not have count as missed. The models go to
MODELS_DIR/<system>/<package>/<component>.json. `rosarch score` does the same for users.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from rosarch.evaluation.experiments.run import Runner
from rosarch.evaluation.experiments.single import run_single, subjects_of
from rosarch.evaluation.experiments.truth import read_truth
from rosarch.extractor.settings import Settings
from rosarch.reports.json_models import write_document
from rosarch.reports.scores import score_text
from rosarch.rule_programs.sets import model_program


def remove_models(folder: Path) -> None:
    """Remove the models of an earlier run: one that is no longer made must not count as found."""
    for path in folder.glob("*/*.json"):
        path.unlink()


def main() -> int:
    """Analyse, then print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("truth", type=Path)
    parser.add_argument("systems", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="where the models are written")
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--misses", action="store_true", help="list every missed and every extra element")
    options = parser.parse_args()
    truths = read_truth(options.truth)
    subjects = subjects_of(truths, options.systems, absent=True)
    start = time.perf_counter()

    def done(system: str, components: int) -> None:
        print(f"{system}: {components} components after {time.perf_counter() - start:.1f} s", file=sys.stderr)

    runner = Runner(options.engine, options.jobs)
    run = run_single(truths, subjects, model_program(), Settings(options.jobs), runner, absent=True, done=done)
    for diagnostic in run.diagnostics:
        if diagnostic.kind in ("component", "source", "workspace"):
            print(str(diagnostic).partition("\n")[0], file=sys.stderr)
    for system in {truth.system for truth in truths}:
        remove_models(options.out / system)
    for (system, _, _), model in run.models.items():
        write_document(model, options.out / system)
    print(score_text(run.score, listed=options.misses), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
