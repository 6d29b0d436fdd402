"""What of the rules is chosen otherwise than they ship."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path


@dataclass(frozen=True)
class RuleSet:
    """What differs from the shipped rules: `own` files and folders, `variants` (decision and variant), `options` (name and value).

    Made by `rule_set`, which checks it. Equal ones derive the same as long as no file changes.
    With `flows`, models describe the flow of data.
    """

    own: tuple[Path, ...] = ()
    variants: tuple[tuple[str, str], ...] = ()
    options: tuple[tuple[str, str], ...] = ()
    flows: bool = False


SHIPPED = RuleSet()


def closed_world(rules: RuleSet) -> RuleSet:
    """The same rules, which claim as though there was no more than was seen."""
    return _with_option(rules, "world", "closed")


def of_any_name(rules: RuleSet) -> RuleSet:
    """The same rules, for nodes that may be started under any name: their own is `{node}` in what is made of it."""
    return _with_option(rules, "own-name", "any")


def _with_option(rules: RuleSet, name: str, value: str) -> RuleSet:
    return replace(rules, options=tuple(sorted({**dict(rules.options), name: value}.items())))
