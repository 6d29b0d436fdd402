"""The second engine: the `souffle` binary, run on the same program and the same facts.

The files of the program are joined into one, without their `.include` and input/output directives; every input is
read from a tab-separated file and every wanted relation written to one with a delimiter that no symbol contains.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Collection, Iterable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.scratch import scratch_folder
from rosarch.datalog.files.facts import read_fact_file, write_facts
from rosarch.datalog.files.tables import Layout
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.values import ValueReader

if TYPE_CHECKING:
    from rosarch.datalog.program import Program

DELIMITER = "\x01"
OLDEST = (2, 4)
"""The first version whose language all of this is."""
_NUMBER = re.compile(r"\bVersion:?\s+v?(\d+)\.(\d+)", re.IGNORECASE)
_PATIENCE = 30.0
_SKIPPED = re.compile(
    r"""("(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/)        # strings and comments stay
    |\.include\s+"(?:\\.|[^"\\])*"|\.once\b
    |\.(?:input|output|printsize)\s+[\w?.]+(?:\s*,\s*[\w?.]+)*(?:\s*\((?:[^()"]|"(?:\\.|[^"\\])*")*\))?""",
    re.DOTALL | re.VERBOSE,
)


def find_souffle() -> str:
    """The path of the binary; DatalogError when there is none, or one that is too old."""
    found = shutil.which("souffle")
    if found is None:
        message = "the souffle engine was asked for, but there is no `souffle` on PATH"
        raise DatalogError([Diagnostic(message, hint="the embedded engine needs no installation")])
    _version(found)
    return found


@lru_cache(maxsize=4)
def _version(binary: str) -> str:
    """What the binary says about itself; DatalogError when that is another version than is needed."""
    try:
        told = subprocess.run(
            [binary, "--version"], capture_output=True, check=False, text=True, errors="replace", timeout=_PATIENCE
        ).stdout
    except (OSError, subprocess.TimeoutExpired) as error:
        raise DatalogError(f"{binary}: does not run ({error})") from None
    number = _NUMBER.search(told)
    if number is None:
        raise DatalogError(f"{binary}: does not tell its version, as souffle does")
    if (int(number[1]), int(number[2])) < OLDEST:
        needed = ".".join(map(str, OLDEST))
        message = f"{binary} is souffle {number[1]}.{number[2]}; {needed} or newer is needed"
        raise DatalogError([Diagnostic(message, hint="the embedded engine needs no installation")])
    return told


def joined_source(program: Program, kept: Collection[str]) -> str:
    """The program as one file that reads its inputs and writes `kept`."""
    parts = [_SKIPPED.sub(lambda m: m[1] or "", text) for text in program.parsed.values()]
    for name in program.inputs:
        parts.append(f'.input {name}(IO=file, filename="{name}.facts")')
    for name in kept:
        parts.append(f'.output {name}(IO=file, filename="{name}.csv", delimiter="{DELIMITER}")')
    return "\n".join(parts) + "\n"


def evaluate_with_souffle(
    program: Program, facts: Mapping[str, Iterable[tuple[Any, ...]]], kept: Collection[str], time_limit: float | None
) -> dict[str, Collection[Any]]:
    """Run the binary; rows of unary relations come back as bare values, as from the embedded engine."""
    binary = find_souffle()
    if program.types.bits != 32 and f"Word size: {program.types.bits}" not in _version(binary):
        raise DatalogError(f"this souffle was not built for numbers of {program.types.bits} bits")
    with scratch_folder() as root:
        inputs, outputs = root / "facts", root / "out"
        outputs.mkdir()
        relations = {name: program.relations[name] for name in program.inputs}
        write_facts(inputs, {name: facts.get(name, ()) for name in relations}, relations, types=program.types)
        source = root / "program.dl"
        source.write_text(joined_source(program, kept), encoding="utf-8", errors="surrogateescape")
        command = [binary, "-w", "-F", str(inputs), "-D", str(outputs), str(source)]
        try:
            done = subprocess.run(command, capture_output=True, check=False, text=True, errors="replace", timeout=time_limit)
        except subprocess.TimeoutExpired:
            raise DatalogError(f"souffle was still running after {time_limit:g} s") from None
        if done.returncode:
            raise DatalogError(f"souffle failed with exit code {done.returncode}:\n{done.stderr.strip() or done.stdout.strip()}")
        return {name: _read_output(outputs / f"{name}.csv", program, name) for name in kept}


def _read_output(path: Path, program: Program, name: str) -> Collection[Any]:
    relation = program.relations[name]
    errors: list[Diagnostic] = []
    rows = read_fact_file(path, relation, errors, ValueReader(program.types), Layout(DELIMITER))
    if errors:
        raise DatalogError(errors)
    found = [row[0] for row in rows] if len(relation.attributes) == 1 else rows
    return found if name in program.code.nested else set(found)
