"""Cases of the rules of systems and of checks: facts in the dialect, with the shorthand of `checks/shorthand.dl`.

A file has a case below each line `// case: name`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

from rosarch.datalog import Program, Result, load_program
from rosarch.datalog.language.errors import DatalogError
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.checks import check_files

SHORTHAND = Path(__file__).parent / "checks" / "shorthand.dl"
CASE = re.compile(r"^// case: (\w+)$", re.MULTILINE)


@dataclass(frozen=True)
class Case:
    """What a file says of a case; lines have the numbers that they have in the file."""

    path: Path
    name: str
    text: str

    @property
    def id(self) -> str:
        """What a test is called that is about the case."""
        return f"{self.path.stem}/{self.name}"


def cases_in(path: Path) -> list[Case]:
    """The cases of a file, in its order."""
    text = path.read_text(encoding="utf-8")
    begins = [(match[1], match.end()) for match in CASE.finditer(text)]
    ends = [*(match.start() for match in CASE.finditer(text)), len(text)][1:]
    return [Case(path, name, "\n" * text.count("\n", 0, at) + text[at:end]) for (name, at), end in zip(begins, ends, strict=True)]


def check_cases() -> list[Case]:
    """The cases of all checks."""
    return [case for path in sorted(SHORTHAND.parent.glob("*.dl")) if path != SHORTHAND for case in cases_in(path)]


def case_of(path: Path, name: str) -> Case:
    """The case of a name."""
    (found,) = (case for case in cases_in(path) if case.name == name)
    return found


@cache
def whole() -> Program:
    return load_program([rules_folder() / "system.dl", *check_files()])


def program_of(case: Case) -> Program:
    return load_program([rules_folder() / "system.dl", *check_files(), SHORTHAND], extra_source=case.text)


def facts_and_program(case: Case) -> tuple[dict[str, list[tuple[Any, ...]]], Program]:
    """The facts that a case stands for, and the rules; or none, and both in a program that is compiled anew, where a case adds to what rules derive."""
    try:
        facts = load_program([rules_folder() / "system_schema.dl", SHORTHAND], extra_source=case.text).evaluate({}, keep="all")
    except DatalogError:
        return {}, program_of(case)
    return {name: list(facts.rows(name)) for name in whole().inputs}, whole()


def evaluated(case: Case, keep: list[str] | Literal["all"]) -> Result:
    """What the rules derive in a case."""
    facts, program = facts_and_program(case)
    return program.evaluate(facts, keep=keep)
