"""Storm, the probabilistic model checker, through stormpy: finds out whether a property holds in a model in the language of PRISM."""

from __future__ import annotations

import importlib
import importlib.util
import multiprocessing
import re
import resource
from multiprocessing.connection import Connection
from pathlib import Path

from rosarch.base.scratch import scratch_folder
from rosarch.behavior.verification.checkers import CheckerError, CheckResult
from rosarch.behavior.verification.ltl import Formula
from rosarch.behavior.verification.prism import prism, query
from rosarch.behavior.verification.transitions import TransitionSystem

HINT = "Storm is not installed: `pip install 'rosarch[storm]'`"


def is_installed() -> bool:
    """Whether it can be used."""
    return importlib.util.find_spec("stormpy") is not None


def check(system: TransitionSystem, formula: Formula, *, timeout: float, memory: int) -> CheckResult:
    """Let Storm check a property, within `timeout` seconds and `memory` MiB, in a process of its own.

    The least probability that the property has is 0 or 1, since nothing in the model is left to chance: it is 1 exactly when every run
    satisfies it.

    Raises:
        CheckerError: it does not end.
    """
    ours, theirs = multiprocessing.Pipe(duplex=False)
    arguments = (theirs, prism(system, formula), query(system, formula), memory)
    process = multiprocessing.get_context("fork").Process(target=_work, args=arguments, daemon=True)
    process.start()
    theirs.close()
    try:
        if not ours.poll(timeout):
            raise CheckerError(f"Storm did not end within {timeout:g} s", large=True)
        value, states = ours.recv()
    except EOFError:
        raise CheckerError("Storm gave up", large=True) from None
    finally:
        process.kill()
        process.join()
    if isinstance(value, str):
        raise CheckerError(f"Storm failed: {value}")
    return CheckResult(value > 0.5, states, None)


def _work(answer: Connection, text: str, asked: str, memory: int) -> None:
    stormpy = importlib.import_module("stormpy")
    most = _data_held() + (memory << 20)
    resource.setrlimit(resource.RLIMIT_DATA, (most, most))
    try:
        with scratch_folder() as folder:
            path = folder / "model.prism"
            path.write_text(text, "utf-8")
            program = stormpy.parse_prism_program(str(path))
            formulas = stormpy.parse_properties(asked, program)
            model = stormpy.build_model(program, formulas)
            result = stormpy.model_checking(model, formulas[0], only_initial_states=True)
            answer.send((result.get_value(model.initial_states[0]), model.nr_states))
    except MemoryError:
        pass  # no answer is answer enough
    except RuntimeError as error:
        if not str(error).startswith("std::"):  # what the standard library throws when there is no room
            answer.send((" ".join(str(error).split()), 0))


def _data_held() -> int:
    """Bytes of data that this process has, most from the one it was forked from; 0 where the system does not say (proc(5))."""
    try:
        status = Path("/proc/self/status").read_text("ascii")
    except OSError:
        return 0
    found = re.search(r"^VmData:\s*(\d+) kB$", status, re.MULTILINE)
    return int(found[1]) << 10 if found else 0
