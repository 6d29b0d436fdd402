"""A variant of the analysis: what is decided otherwise, options, and rules of one's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from rosarch.datalog import Program, load_program
from rosarch.extractor.manifest import rules_folder

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
        """The rules of a component in this variant; DatalogError when they are wrong."""
        return load_program([rules_folder() / "component.dl", *self.rules])


def known_decisions() -> Mapping[str, tuple[str, ...]]:
    """The variants of each decision."""
    return {}


def known_options() -> Mapping[str, Callable[[str], str]]:
    """The options; each with what tells why a value is not allowed, or ""."""
    return {}
