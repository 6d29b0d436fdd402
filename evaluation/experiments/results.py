"""What an experiment found: figures of each variant, how sure they are, and how variants differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

from rosarch.evaluation.experiments.comparison import CATEGORIES, FINDINGS, MISSED, Comparison, Counts
from rosarch.evaluation.experiments.plan import Experiment
from rosarch.evaluation.experiments.run import Evaluated
from rosarch.evaluation.experiments.statistics import holm, intervals, p_value, total

FIGURES: dict[str, Callable[[Counts], float]] = {
    "precision": lambda counts: counts.precision,
    "recall": lambda counts: counts.recall,
    "F1": lambda counts: counts.f1,
}
DECIDING = "F1"
"""The figure whose tests are corrected for how many there are."""


@dataclass(frozen=True)
class Outcome:
    """A component under a variant: None for what failed; `judged`: there is truth about it."""

    evaluated: Evaluated | None
    comparison: Comparison
    judged: bool


@dataclass(frozen=True)
class Component:
    """A component of a subject, or, without a title, the systems of one."""

    subject: str
    title: str


@dataclass(frozen=True)
class Results:
    """The outcome of each variant on each component, and what all of it depends on: names of things, and their versions or hashes."""

    experiment: Experiment
    outcomes: Mapping[str, Mapping[Component, Outcome]]
    provenance: tuple[tuple[str, str], ...]

    def counts(self, variant: str, category: str) -> list[Counts]:
        """Of each component that there is truth about; of findings, of each such subject."""
        own = (outcome for outcome in self.outcomes[variant].values() if outcome.judged and category in outcome.comparison.elements)
        return [outcome.comparison.counts(category) for outcome in own]

    @property
    def categories(self) -> tuple[str, ...]:
        """Those that there is truth about."""
        found = [outcome.comparison.elements for outcome in next(iter(self.outcomes.values())).values() if outcome.judged]
        return tuple(category for category in (*CATEGORIES, FINDINGS) if any(category in elements for elements in found))

    @property
    def judged(self) -> int:
        """How many components there is truth about."""
        return len(self.counts(next(iter(self.outcomes)), CATEGORIES[0]))


@dataclass(frozen=True)
class Figure:
    """Of a variant in a category: the counts, and precision, recall and F1 each with an interval."""

    variant: str
    category: str
    counts: Counts
    values: Mapping[str, tuple[float, tuple[float, float] | None]]


@dataclass(frozen=True)
class Test:
    """Of a figure in a category: how much larger it is under `other` than under `one`, and how likely that is by chance.

    `corrected` is the p value corrected for the number of tests; None where it is not.
    """

    one: str
    other: str
    category: str
    figure: str
    difference: float
    p: float
    corrected: float | None


@dataclass(frozen=True)
class Difference:
    """An element, or a row of a relation (`kind` is its name), that `other` has and `one` has not (`gained`), or the other way round.

    `verdict` is that of the element, "" where there is no truth and for rows.
    """

    one: str
    other: str
    gained: bool
    component: Component
    kind: str
    text: str
    at: str
    verdict: str


def figures(results: Results) -> list[Figure]:
    """Of each variant and category; none without truth."""
    found = []
    for variant in results.outcomes:
        for category in results.categories:
            counts = results.counts(variant, category)
            sampled = intervals(counts, tuple(FIGURES.values()), samples=results.experiment.samples, seed=_seed(results, category))
            whole = total(counts)
            values = {name: (figure(whole), interval) for (name, figure), interval in zip(FIGURES.items(), sampled, strict=True)}
            found.append(Figure(variant, category, whole, values))
    return found


def tests(results: Results) -> list[Test]:
    """Of each pair of variants, category and figure."""
    found = []
    for one, other in results.experiment.pairs:
        for category in results.categories:
            before, after = results.counts(one, category), results.counts(other, category)
            for name, figure in FIGURES.items():
                p = p_value(before, after, figure, samples=results.experiment.samples, seed=_seed(results, category))
                found.append(Test(one, other, category, name, figure(total(after)) - figure(total(before)), p, None))
    deciding = [test for test in found if test.figure == DECIDING]
    corrected = dict(zip(map(id, deciding), holm([test.p for test in deciding]), strict=True))
    return [Test(t.one, t.other, t.category, t.figure, t.difference, t.p, corrected.get(id(t))) for t in found]


def _seed(results: Results, category: str) -> str:
    """One for each category: variants are judged on the same samples of components."""
    return f"{results.experiment.seed} {category}"


def agreements(results: Results) -> dict[str, dict[str, tuple[float, int]]]:
    """For each variant and attribute the mean agreement and how many were compared."""
    found: dict[str, dict[str, tuple[float, int]]] = {}
    for variant, outcomes in results.outcomes.items():
        values: dict[str, list[float]] = {}
        for outcome in outcomes.values():
            for attribute, own in outcome.comparison.agreement.items() if outcome.judged else ():
                values.setdefault(attribute, []).extend(own)
        found[variant] = {attribute: (sum(own) / len(own), len(own)) for attribute, own in values.items() if own}
    return found


def element_differences(results: Results) -> Iterator[Difference]:
    """The elements of models that one of two variants has and the other has not."""
    for one, other in results.experiment.pairs:
        for component, before, after in _both(results, one, other):
            for category in before.comparison.elements:
                sides = [
                    {key: element for key, element in outcome.comparison.elements[category].items() if element.verdict != MISSED}
                    for outcome in (before, after)
                ]
                for gained, own, opposite in ((True, sides[1], sides[0]), (False, sides[0], sides[1])):
                    for key in sorted(own.keys() - opposite.keys(), key=repr):
                        element = own[key]
                        verdict = element.verdict if before.judged else ""
                        yield Difference(one, other, gained, component, category, element.text, element.at, verdict)


def row_differences(results: Results) -> Iterator[Difference]:
    """The rows of relations that one of two variants has and the other has not."""
    wanted = results.experiment.relations
    for one, other in results.experiment.pairs:
        for component, before, after in _both(results, one, other):
            if before.evaluated is None or after.evaluated is None:
                continue
            for relation in sorted(before.evaluated.rows.keys() | after.evaluated.rows.keys()):
                if wanted is not None and relation not in wanted:
                    continue
                left, right = (set(outcome.rows.get(relation, ())) for outcome in (before.evaluated, after.evaluated))
                for gained, rows in ((True, right - left), (False, left - right)):
                    for text, at in sorted(rows):
                        yield Difference(one, other, gained, component, relation, text, at, "")


def _both(results: Results, one: str, other: str) -> Iterator[tuple[Component, Outcome, Outcome]]:
    """The components that succeeded under both variants."""
    for component, before in results.outcomes[one].items():
        after = results.outcomes[other][component]
        if before.evaluated is not None and after.evaluated is not None:
            yield component, before, after
