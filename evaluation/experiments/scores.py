"""The score of many models: the counts and agreements of their comparisons, put together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rosarch.evaluation.experiments.comparison import CATEGORIES, MISSED, Comparison, Counts, Document, compare
from rosarch.evaluation.experiments.statistics import total
from rosarch.evaluation.experiments.truth import Truth


@dataclass(frozen=True)
class Score:
    """Of the models of all components of a truth; `absent` are those without one, whose elements all count as missed."""

    comparisons: tuple[tuple[Truth, Comparison], ...]
    absent: tuple[Truth, ...]

    @property
    def counts(self) -> dict[str, Counts]:
        """The sum for each category."""
        return {category: total([found.counts(category) for _, found in self.comparisons]) for category in CATEGORIES}

    @property
    def agreement(self) -> dict[str, tuple[float, int]]:
        """For each attribute the mean agreement and how many were compared."""
        found: dict[str, list[float]] = {}
        for _, comparison in self.comparisons:
            for attribute, values in comparison.agreement.items():
                found.setdefault(attribute, []).extend(values)
        return {attribute: (sum(values) / len(values), len(values)) for attribute, values in found.items() if values}


def score(truths: Sequence[Truth], model_of: Callable[[Truth], Document | None]) -> Score:
    """The score of the models that `model_of` has, against the truth of components."""
    models = [(truth, model_of(truth)) for truth in truths]
    return Score(
        tuple((truth, compare(truth.document, model or {})) for truth, model in models),
        tuple(truth for truth, model in models if model is None),
    )


def misses(found: Score, verdict: str = MISSED) -> list[tuple[str, Truth, str, str]]:
    """Category, component, text and place of the elements of a verdict."""
    return [
        (category, truth, element.text, element.at)
        for category in CATEGORIES
        for truth, comparison in found.comparisons
        for element in comparison.elements[category].values()
        if element.verdict == verdict
    ]
