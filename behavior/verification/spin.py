"""SPIN, the model checker: finds out whether a property holds in a model in Promela."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from rosarch.base.scratch import scratch_folder
from rosarch.behavior.verification.checkers import CheckerError, CheckResult
from rosarch.behavior.verification.explorer import Lasso
from rosarch.behavior.verification.ltl import Formula
from rosarch.behavior.verification.promela import STEP, promela
from rosarch.behavior.verification.transitions import TransitionSystem

HINT = "SPIN is not installed: `apt-get install spin gcc`, or see https://spinroot.com"
_SHORT = 10_000  # steps of a run; room for many takes time to prepare
_PER_MIB = 5_000  # steps of a run that there is room for beside the states
_TOO_DEEP = "max search depth too small"
_FEW = 1_000_000  # valuations for which it is not worth while to let the compiler optimise
_GIVEN_UP = ("Search not completed", _TOO_DEEP, "out of memory")
_CYCLE = "<<<<<START OF CYCLE>>>>>"
_STEP = re.compile(rf"^\s*{STEP}(\d+)$")


def is_installed() -> bool:
    """Whether it is there, with the compiler that it needs."""
    return bool(shutil.which("spin") and shutil.which("gcc"))


def check(system: TransitionSystem, formula: Formula, *, timeout: float, memory: int) -> CheckResult:
    """Let SPIN check a property, within `timeout` seconds and `memory` MiB.

    Raises:
        CheckerError: it cannot, or does not end.
    """
    with scratch_folder() as folder:
        _compile(system, [formula], folder, timeout, memory)
        found = _claim(0, folder, timeout, memory)
        return found if found.holds else replace(found, lasso=_trail(_run(["spin", "-t", "-B", "model.pml"], folder, timeout)))


def check_all(system: TransitionSystem, formulas: Sequence[Formula], *, timeout: float, memory: int) -> list[CheckResult]:
    """Let SPIN check several properties of one model, without the runs that violate them."""
    with scratch_folder() as folder:
        _compile(system, formulas, folder, timeout, memory)
        return [_claim(index, folder, timeout, memory) for index in range(len(formulas))]


def _compile(system: TransitionSystem, formulas: Sequence[Formula], folder: Path, timeout: float, memory: int) -> None:
    claims = {f"property {index}": formula for index, formula in enumerate(formulas)}
    (folder / "model.pml").write_text(promela(system, claims), "utf-8")
    _run(["spin", "-a", "model.pml"], folder, timeout)
    valuations = math.prod(number.high + 1 for number in system.numbers)
    effort = "-O0" if valuations < _FEW else "-O2"
    _run(["gcc", effort, "-w", f"-DMEMLIM={memory}", "-DNOFAIR", "-DNOREDUCE", "-DNOSTUTTER", "-o", "pan", "pan.c"], folder, timeout)


def _claim(index: int, folder: Path, timeout: float, memory: int) -> CheckResult:
    for depth in (_SHORT, memory * _PER_MIB):
        report = _run(["./pan", "-a", f"-m{depth}", "-N", f"claim{index}"], folder, timeout)
        if _TOO_DEEP not in report:
            break
    errors = re.search(r"errors: (\d+)", report)
    states = re.search(r"^\s*(\S+) states, stored", report, re.MULTILINE)
    count = int(float(states.group(1))) if states else 0
    if errors and int(errors.group(1)):
        return CheckResult(False, count, None)
    if errors is None or any(sign in report for sign in _GIVEN_UP):
        raise CheckerError(f"SPIN gave up after {count} states", large=True)
    return CheckResult(True, count, None)


def _run(command: list[str], folder: Path, timeout: float) -> str:
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        raise CheckerError(f"{command[0].lstrip('./')} did not end within {timeout:g} s", large=True) from None
    if done.returncode and command[0] != "./pan":
        message = (done.stderr or done.stdout).strip().split("\n")[0]
        raise CheckerError(f"{command[0]} failed: {message}")
    return done.stdout


def _trail(text: str) -> Lasso:
    """The transitions that SPIN prints while it runs a trail."""
    before, _, after = text.partition(_CYCLE)
    stem, loop = ([int(match.group(1)) for line in part.split("\n") if (match := _STEP.match(line))] for part in (before, after))
    return Lasso(tuple(stem), tuple(loop))
