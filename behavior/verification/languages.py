"""The files in which other tools read a property and the model it is about."""

from __future__ import annotations

from rosarch.behavior.verification.jani import jani
from rosarch.behavior.verification.prism import prism, query
from rosarch.behavior.verification.promela import promela
from rosarch.behavior.verification.properties import Property
from rosarch.behavior.verification.transitions import TransitionSystem


def files(language: str, system: TransitionSystem, item: Property) -> list[tuple[str, str]]:
    """Names and texts; the model is first."""
    if language == "promela":
        return [(f"{item.name}.pml", promela(system, {f"{item.name}: {item.text}": item.formula}))]
    if language == "jani":
        return [(f"{item.name}.jani", jani(system, item.formula, item.name))]
    return [(f"{item.name}.prism", prism(system, item.formula)), (f"{item.name}.props", query(system, item.formula) + "\n")]
