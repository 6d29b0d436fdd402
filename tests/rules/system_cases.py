"""Cases of the rules of systems and of checks: facts in the dialect, with the shorthand of `checks/shorthand.dl`."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any, Literal

from rosarch.datalog import Program, Result, load_program
from rosarch.datalog.language.errors import DatalogError
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.checks import check_files

SHORTHAND = Path(__file__).parent / "checks" / "shorthand.dl"


@cache
def whole() -> Program:
    return load_program([rules_folder() / "system.dl", *check_files()])


def program_of(case: Path) -> Program:
    return load_program([rules_folder() / "system.dl", *check_files(), SHORTHAND, case])


def facts_and_program(case: Path) -> tuple[dict[str, list[tuple[Any, ...]]], Program]:
    """The facts that a case stands for, and the rules; or none, and both in a program that is compiled anew, where a case adds to what rules derive."""
    try:
        facts = load_program([rules_folder() / "system_schema.dl", SHORTHAND, case]).evaluate({}, keep="all")
    except DatalogError:
        return {}, program_of(case)
    return {name: list(facts.rows(name)) for name in whole().inputs}, whole()


def evaluated(case: Path, keep: list[str] | Literal["all"]) -> Result:
    """What the rules derive in a case."""
    facts, program = facts_and_program(case)
    return program.evaluate(facts, keep=keep)
