"""`rosarch rules checks`: the checks that `rosarch check` makes, and what is behind them."""

from __future__ import annotations

from enum import Enum
from fnmatch import fnmatchcase
from typing import Annotated

import typer

from rosarch.cli.derivations import datalog_errors, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.terminal import emit


class CheckFormat(str, Enum):
    """The formats for descriptions of checks."""

    text = "text"
    markdown = "markdown"


def checks(
    patterns: Annotated[
        list[str] | None,
        typer.Argument(metavar="[ID]...", help="Explain these checks; `*` for any text. Without one, list all.", show_default=False),
    ] = None,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    output_format: Annotated[CheckFormat, typer.Option("--format", help="The form of the text on stdout.")] = CheckFormat.text,
) -> None:
    """List the checks with their severity, or explain some: what each finds, why that is bad, an example, what to do."""
    from rosarch.base.hints import hint
    from rosarch.findings.suppressions import COMMENT_CHECKS
    from rosarch.reports.checks import explanation_text, list_text, reference_markdown, sections_markdown
    from rosarch.rule_programs.sets import system_rules

    with datalog_errors():
        known = sorted((*system_rules(parse_rules(own, variants, settings)).checks, *COMMENT_CHECKS), key=lambda check: check.id)
    for pattern in patterns or ():
        if not any(fnmatchcase(check.id, pattern) for check in known):
            raise InputError(f"no check {pattern}{hint(pattern, [check.id for check in known])}")
    chosen = [check for check in known if not patterns or any(fnmatchcase(check.id, pattern) for pattern in patterns)]
    if output_format is CheckFormat.markdown:
        emit(sections_markdown(chosen) if patterns else reference_markdown(chosen))
    else:
        emit(explanation_text(chosen, shorten) if patterns else list_text(chosen))
