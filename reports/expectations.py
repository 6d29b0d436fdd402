"""What became of expectations, for a reader."""

from __future__ import annotations

from rosarch.evaluation.expectations.judgement import Unmet
from rosarch.evaluation.expectations.run import FileOutcome
from rosarch.reports.printable import printable


def file_text(outcome: FileOutcome) -> str:
    """One line for a file whose expectations are met, else what was expected and what was there."""
    if not outcome.unmet:
        return f"ok       {outcome.path}: {outcome.expected} expectation{'s' * (outcome.expected != 1)}\n"
    lines = [f"FAILED   {outcome.path}: {len(outcome.unmet)} of {outcome.expected} expectation{'s' * (outcome.expected != 1)}"]
    for unmet in outcome.unmet:
        lines += _unmet_lines(outcome, unmet)
    return "".join(f"{printable(line)}\n" for line in lines)


def _unmet_lines(outcome: FileOutcome, unmet: Unmet) -> list[str]:
    marked = unmet.expectation.marked
    word = {"": "expected", "not": "not expected", "only": "nothing else expected"}[marked.sense]
    here = " here" if unmet.expectation.here else ""
    if here and unmet.expectation.kind is None:
        word, here = "expected", " here only"
    head = f"  {outcome.path}:{marked.line}:{marked.column}: {word}{here}: {marked.text}"
    label = "there is" if marked.sense else "nearest"
    kind = unmet.expectation.kind
    nothing = "no such row" if kind is None else f"there is no {kind.name}"
    return [head, *(f"    {label:<8}  {text}" for text in unmet.instead or ())] if unmet.instead else [head, f"    {nothing}"]


def total_text(outcomes: list[FileOutcome]) -> str:
    """How many expectations there were, and how many were not met."""
    expected, unmet = sum(outcome.expected for outcome in outcomes), sum(len(outcome.unmet) for outcome in outcomes)
    return f"{expected} expectation{'s' * (expected != 1)} in {len(outcomes)} file{'s' * (len(outcomes) != 1)}, {unmet} not met\n"
