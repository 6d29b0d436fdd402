"""`rosarch options`: what the rules leave to choose."""

from __future__ import annotations

from typing import Annotated

import typer

from rosarch.cli.derivations import datalog_errors, shorten
from rosarch.cli.rule_options import Rules, parse_rules
from rosarch.cli.terminal import emit


def options(own: Rules = None, as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False) -> None:
    """List the options of the rules, and the decisions with several variants, with their defaults."""
    from rosarch.reports.choices import choices_json, choices_text
    from rosarch.rule_programs.sets import find_options
    from rosarch.rule_programs.variants import decisions

    with datalog_errors():
        rules = parse_rules(own)
        write = choices_json if as_json else choices_text
        text = write(decisions(rules.own), find_options(rules), shorten)
    emit(text)
