"""A variant of the analysis: what is decided otherwise, options, and rules of one's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from rosarch.datalog import Program
from rosarch.models.rule_sets import component_program, find_options, rule_set
from rosarch.models.variants import decisions

Pairs = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Variant:
    """`decisions` and `options` are names with what is chosen, `rules` files that come beside rosarch's."""

    name: str
    decisions: Pairs = ()
    options: Pairs = ()
    rules: tuple[Path, ...] = ()

    def with_options(self, options: Pairs) -> Variant:
        """The same with more options, of which its name tells."""
        name = " ".join((self.name, *(f"{option}={value}" for option, value in options)))
        return replace(self, name=name, options=(*self.options, *options))

    def program(self) -> Program:
        """The rules of a component in this variant; DatalogError or RuleSetError when they are wrong."""
        return component_program(rule_set(self.rules, dict(self.decisions), dict(self.options)))


def known_decisions() -> Mapping[str, tuple[str, ...]]:
    """The variants of each decision."""
    return {decision.name: tuple(variant.name for variant in decision.variants) for decision in decisions()}


def known_options() -> Mapping[str, Callable[[str], str]]:
    """The options; each with what tells why a value is not allowed, or ""."""
    return {option.name: option.problem for option in find_options()}
