"""Python 2 sources as Python 3: the fixers of 2to3 (its fork `fissix`) that change syntax, and no others."""

from __future__ import annotations

import ast
import logging
import re
from bisect import bisect_left
from functools import lru_cache, partial
from typing import Any

_FIXERS = ("except", "exec", "has_key", "ne", "numliterals", "paren", "print", "raise", "repr", "tuple_params", "unicode")

_TAKEN_APART = re.compile(r"\s*\(.*\) = xxx_todo_changeme\d*(?:\.args)?")


def as_python3(text: str) -> str | None:
    """The source as Python 3 has it; None when it is no Python 2 either."""
    spaced = "\n".join(_tabs(line) for line in text.split("\n"))
    try:
        return str(_tool().refactor_string(spaced.rstrip("\n") + "\n", "source"))
    except Exception:  # of its parser, its tokenizer and its tree; whatever it says, the source is not Python 2
        return None


def in_its_lines(text: str, tree: ast.Module) -> str:
    """A converted text without the lines that 2to3 adds where it takes a parameter apart; its tree gets the lines of the source."""
    lines = text.split("\n")
    added = [number for number, line in enumerate(lines, 1) if _TAKEN_APART.fullmatch(line)]
    for node in ast.walk(tree) if added else ():
        for end in ("lineno", "end_lineno"):
            if hasattr(node, end):
                setattr(node, end, getattr(node, end) - bisect_left(added, getattr(node, end)))
    return "\n".join(line for line in lines if not _TAKEN_APART.fullmatch(line))


def _tabs(line: str) -> str:
    """Tabs at the beginning of a line go to the next column that is a multiple of eight, as Python 2 has it."""
    body = line.lstrip(" \t")
    return line[: len(line) - len(body)].expandtabs(8) + body


@lru_cache(maxsize=1)
def _tool() -> Any:
    from fissix.pgen2 import driver  # takes a while, and few sources need it

    driver.load_grammar = partial(
        driver.load_grammar, gp="", save=False, force=True
    )  # it would keep, and trust, files in the user's folder
    from fissix.refactor import RefactoringTool

    logging.getLogger("fissix").setLevel(logging.CRITICAL)
    for name in ("RefactoringTool", "fissix.main", "fissix.pgen2.driver"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    return RefactoringTool([f"fissix.fixes.fix_{name}" for name in _FIXERS])
