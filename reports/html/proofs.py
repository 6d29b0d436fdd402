"""Proofs as the report has them: the steps of all, each once, as systems that start the same nodes have most of them in common."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rosarch.models.derivations import Derivations, ProofStep


class Pool:
    """Steps as text, rule, numbers of the steps they rest on, 1 where more is left out, and the number of the place if there is one."""

    def __init__(self) -> None:
        self.steps: list[list[Any]] = []
        self.places: dict[str, int] = {}
        self._numbers: dict[tuple[Any, ...], int] = {}

    def add(self, found: Derivations, keys: Iterable[str]) -> dict[str, int]:
        """The numbers of the steps that prove these things."""
        known: dict[int, int] = {}
        return {key: self._added(found, found.roots[key], known) for key in keys}

    def _added(self, found: Derivations, root: int, known: dict[int, int]) -> int:
        """The number of a step, once those that it rests on have theirs."""
        waiting = [root]
        while waiting:
            step = found.steps[waiting[-1]]
            missing = [premise for premise in step.premises if premise not in known]
            if not missing:
                known[waiting[-1]] = self._number(step, [known[premise] for premise in step.premises])
                waiting.pop()
            waiting += missing
        return known[root]

    def _number(self, step: ProofStep, premises: list[int]) -> int:
        at = [self.places.setdefault(str(step.at), len(self.places))] if step.at else []
        number = self._numbers.setdefault((step.text, step.rule, *premises, step.cut, *at), len(self.steps))
        if number == len(self.steps):
            self.steps.append([step.text, step.rule, premises, int(step.cut), *at])
        return number
