"""The single run: the models of the components that a truth names, and their score."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.base.pool import Failure
from rosarch.datalog import Program
from rosarch.evaluation.experiments.comparison import Document
from rosarch.evaluation.experiments.run import Cell, Configuration, Runner
from rosarch.evaluation.experiments.scores import Score, score
from rosarch.evaluation.experiments.subjects import Subject, about, opened
from rosarch.evaluation.experiments.truth import Truth, TruthError, read_models, systems
from rosarch.extractor.settings import Settings
from rosarch.extractor.stored_facts import is_facts_text

if TYPE_CHECKING:
    from rosarch.extractor.workspace import Diagnostic


@dataclass(frozen=True)
class SingleRun:
    """The models that were made, the truth of those that were not, and what was not understood."""

    truths: tuple[Truth, ...]
    models: dict[tuple[str, str, str], Document]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def score(self) -> Score:
        """The score of the models."""
        return score(self.truths, lambda truth: self.models.get((truth.system, truth.package, truth.component)))


def subjects_of(truths: Sequence[Truth], folder: Path, *, absent: bool = False) -> list[Subject]:
    """Each system that truth is about, in `folder` under its name, a folder or a text of facts; the only one may be `folder` itself.

    Raises:
        TruthError: there is no folder of a system, and such must not be `absent`.
    """
    found = list(systems(tuple(truths)))
    subjects = []
    problems = []
    for system, own in found:
        below = folder / system
        text = folder / f"{system}.txt"
        here = below if os.path.isdir(below) else text if is_facts_text(text) else folder
        if here is not folder or len(found) == 1:
            subjects.append(Subject(system, here, own))
        elif not absent:
            problems.append(f"{own[0].at}:{own[0].at.column}: no folder {below} of the system {system}")
    if problems:
        raise TruthError("\n".join(problems))
    return subjects


def run_single(
    truths: Sequence[Truth], subjects: Sequence[Subject], program: Program, settings: Settings, runner: Runner, *, absent: bool = False,
    done: Callable[[str, int], None] | None = None,
) -> SingleRun:  # fmt: skip
    """Analyse the components that truth names; `done` is called with each system and its number of models.

    Raises:
        TruthError: truth is of a component that does not exist, and such must not be `absent`.
    """
    from rosarch.extractor.workspace import Diagnostic

    models: dict[tuple[str, str, str], Document] = {}
    diagnostics: list[Diagnostic] = []
    for subject in subjects:
        with opened(subject, settings, absent=absent) as found:
            diagnostics += found.diagnostics
            cells = [Cell(found, facts, Configuration("", program, tuple(program.outputs))) for facts in found.components]
            for cell, outcome in runner.run(cells):
                title = f"{cell.facts.package}/{cell.facts.name}"
                if isinstance(outcome, Failure):
                    detail = f"{title} not analysed: {outcome.reason} ({outcome.detail})"
                    diagnostics.append(Diagnostic("component", subject.folder, 1, 1, detail))
                else:
                    for truth in about(subject, cell.facts):
                        if model := outcome.model(truth.component):
                            models[subject.name, truth.package, truth.component] = model
            if done:
                done(subject.name, len(found.components))
    return SingleRun(tuple(truths), models, tuple(diagnostics))


def score_models(truths: Sequence[Truth], folder: Path) -> Score:
    """The score of models that were written to a folder: the one of a component is that of its package and name, whatever its system.

    Raises:
        TruthError: a model is damaged.
    """
    models = read_models(folder)
    return score(truths, lambda truth: models.get((truth.package, truth.component)))
