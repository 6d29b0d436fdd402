"""The options on rules: files of the user's own, variants of contested decisions, options."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.derivations import datalog_errors
from rosarch.cli.options import parse_pairs, path_argument
from rosarch.cli.terminal import show_note

if TYPE_CHECKING:
    from rosarch.rule_programs.sets import RuleSet

Rules = Annotated[
    list[Path] | None,
    typer.Option(
        "--rules",
        "-r",
        parser=path_argument,
        metavar="PATH",
        help="A file or a folder of rules of your own, in addition to rosarch's; may be repeated.",
        show_default=False,
    ),
]
Variants = Annotated[
    list[str] | None,
    typer.Option(
        "--variant",
        metavar="DECISION=NAME",
        help="Use another definition than the default, see `rosarch options`; may be repeated.",
        show_default=False,
    ),
]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--option", metavar="NAME=VALUE", help="Set an option of the rules, see `rosarch options`; may be repeated.", show_default=False
    ),
]


def parse_rules(own: Sequence[Path] | None = None, variants: Sequence[str] | None = None, options: Sequence[str] | None = None) -> RuleSet:
    """The rules that the options name, checked. What files of the user's own override is reported on stderr."""
    from rosarch.rule_programs.choice import SHIPPED

    if not (own or variants or options):
        return SHIPPED
    from rosarch.rule_programs.sets import check_own, overridden, rule_set

    with datalog_errors():
        rules = rule_set(own or (), parse_pairs("--variant", variants), parse_pairs("--option", options))
        check_own(rules)
        for each in overridden(rules):
            where = dict.fromkeys(place.path for place in each.dropped)
            count = len(each.dropped)
            files = ", ".join(map(_shorten, where))
            show_note(f"{each.location}: `{each.relation}` is overridden: {count} clause{'s' * (count != 1)} of {files} dropped")
    return rules


def _shorten(path: str) -> str:
    from rosarch.cli.derivations import shorten

    return shorten(path)
