"""Cases of rules: facts in the dialect, with a shorthand: that of `components/shorthand.dl` or, for systems and checks, `checks/shorthand.dl`.

A file has a case below each line `// case: name`. `// expect: relation(a, b)` is a row that must come out, and all rows of a relation that is named
so are told; records are written `[a, b, c]`. `// none: relation` names one that must be empty, `// none: relation("a", _); ...` rows that must not
be there.
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

HERE = Path(__file__).parent
SHORTHAND = HERE / "checks" / "shorthand.dl"
OF_COMPONENTS = HERE / "components" / "shorthand.dl"
CASE = re.compile(r"^// case: (\w+)$", re.MULTILINE)
EXPECT = re.compile(r"^// expect: (\w+)\((.*)\)$", re.MULTILINE)
NONE = re.compile(r"^// none: (.*)$", re.MULTILINE)
ATOM = re.compile(r"(\w+)\((.*)\)")
Facts = dict[str, list[tuple[Any, ...]]]


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


def component_cases() -> list[Case]:
    """The cases of the rules of components."""
    return [case for path in sorted(OF_COMPONENTS.parent.glob("*.dl")) if path != OF_COMPONENTS for case in cases_in(path)]


def component_facts(case: Case) -> Facts:
    """The facts that a case of components stands for."""
    program = load_program([rules_folder() / "schema.dl", OF_COMPONENTS], extra_source=case.text)
    facts = program.evaluate({}, keep=program.inputs)
    return {name: list(facts.rows(name)) for name in program.inputs}


def check_cases() -> list[Case]:
    """The cases of all checks."""
    return [case for path in sorted(SHORTHAND.parent.glob("*.dl")) if path != SHORTHAND for case in cases_in(path)]


def case_of(path: Path, name: str) -> Case:
    """The case of a name."""
    (found,) = (case for case in cases_in(path) if case.name == name)
    return found


def expectations(case: Case) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {name: [] for name in nothing(case) if name.isidentifier()}
    for name, row in EXPECT.findall(case.text):
        found.setdefault(name, []).append(row)
    return {name: sorted(rows) for name, rows in found.items()}


def nothing(case: Case) -> list[str]:
    return [each for line in NONE.findall(case.text) for each in line.split("; ")]


def unwanted(case: Case) -> list[tuple[str, re.Pattern[str]]]:
    """Relations, with what rows they must not have."""
    atoms = [match.groups() for match in map(ATOM.fullmatch, nothing(case)) if match]
    cells = [(name, arguments.replace('"', "").split(", ")) for name, arguments in atoms]
    return [(name, re.compile(", ".join("[^,]*" if cell == "_" else re.escape(cell) for cell in row))) for name, row in cells]


@cache
def whole() -> Program:
    return load_program([rules_folder() / "system.dl", *check_files()])


def program_of(case: Case) -> Program:
    return load_program([rules_folder() / "system.dl", *check_files(), SHORTHAND], extra_source=case.text)


def facts_and_program(case: Case) -> tuple[Facts, Program]:
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
