"""What the rules leave to choose: decisions with their variants, and options."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from textwrap import fill

from rosarch.reports.printable import json_text
from rosarch.rule_programs.sets import Option
from rosarch.rule_programs.variants import Decision

WIDTH = 120


def choices_text(decisions: Sequence[Decision], options: Sequence[Option], shorten: Callable[[str], str]) -> str:
    """Decisions, each with its variants, then options; the defaults are marked."""
    parts = []
    for decision in decisions:
        parts.append(f"{decision.name}  (rules of {decision.program}s)\n{_wrapped(decision.doc, 2)}")
        for variant in decision.variants:
            mark = "*" if variant.name == decision.default.stem else " "
            parts.append(f"{mark} {variant.name}  {shorten(str(variant.path))}\n{_wrapped(variant.doc, 6)}")
        parts.append("")
    parts.append("options")
    for option in options:
        values = ", ".join(f"*{value}" if value == option.default else value for value in option.allowed)
        parts.append(f"  {option.name}  {values}\n{_wrapped(option.meaning, 6)}")
    parts.append("\n* is the default; choose with --variant DECISION=NAME and --option NAME=VALUE")
    return "\n".join(parts) + "\n"


def _wrapped(text: str, indent: int) -> str:
    pad = " " * indent
    return fill(text, WIDTH, initial_indent=pad, subsequent_indent=pad, break_long_words=False, break_on_hyphens=False)


def choices_json(decisions: Sequence[Decision], options: Sequence[Option], shorten: Callable[[str], str]) -> str:
    """The same for programs."""
    data = {
        "decisions": [
            {
                "name": decision.name,
                "program": decision.program,
                "doc": decision.doc,
                "default": decision.default.stem,
                "variants": [{"name": each.name, "doc": each.doc, "file": shorten(str(each.path))} for each in decision.variants],
            }
            for decision in decisions
        ],
        "options": [
            {"name": option.name, "doc": option.meaning, "default": option.default, "allowed": list(option.allowed)} for option in options
        ],
    }
    return json_text(data)
