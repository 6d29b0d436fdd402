"""Executables under a time limit, each in a process group of its own that ends in any case."""

from __future__ import annotations

import ctypes
import os
import resource
import secrets
import signal
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of prctl(2)
_MARK = "ROSARCH_PROCESS"
_ROUNDS, _PAUSE = 100, 0.02
_LONGEST_LOG = 1 << 26
"""Bytes that a process may write into a file."""


class Process:
    """A running executable; `with` ends it and all that it started. What it prints goes to `log`."""

    def __init__(
        self, command: Sequence[str], folder: Path, log: Path, environment: Mapping[str, str], given: int | None = None,
        answers: int | None = None,
    ) -> None:  # fmt: skip
        """Start a command; `given` and `answers` are descriptors in the place of its standard input, which is empty, and output."""
        self._mark = f"{_MARK}={secrets.token_hex(8)}"
        name, _, value = self._mark.partition("=")
        with log.open("wb") as output:
            self._process = subprocess.Popen(
                list(command), cwd=folder, stdin=subprocess.DEVNULL if given is None else given,
                stdout=output if answers is None else answers, stderr=output,
                env={**environment, name: value}, start_new_session=True, preexec_fn=_limited(),
            )  # fmt: skip

    def __enter__(self) -> Process:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    @property
    def ended(self) -> str | None:
        """How it ended by itself; None while it runs."""
        code = self._process.poll()
        if code is None:
            return None
        return f"was killed by {signal.Signals(-code).name}" if code < 0 else f"exited with {code}"

    def stop(self, patience: float = 2.0) -> None:
        """Ask all of its group to end, then make them."""
        for wanted, seconds in ((signal.SIGINT, patience), (signal.SIGKILL, patience)):
            with suppress(ProcessLookupError, PermissionError):
                os.killpg(self._process.pid, wanted)
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(seconds)
                if not _group_lives(self._process.pid):
                    break
        self._end_strays()

    def _end_strays(self) -> None:
        """End what it has started and that has left its group; Linux alone shows it, by the mark in its environment."""
        for _ in range(_ROUNDS):
            strays = [int(folder.name) for folder in Path("/proc").glob("[0-9]*") if self._is_own(folder)]
            if not strays:
                return
            for stray in strays:
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(stray, signal.SIGKILL)
            time.sleep(_PAUSE)

    def _is_own(self, folder: Path) -> bool:
        try:
            return self._mark.encode() in (folder / "environ").read_bytes().split(b"\0")
        except OSError:
            return False


def _group_lives(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except (ProcessLookupError, PermissionError):
        return False
    return True


def _limited() -> Callable[[], object] | None:
    """What a child does first: keep its files short, and end when this process does, however that comes about. Only Linux can."""
    try:
        prctl = ctypes.CDLL(None).prctl
    except (OSError, AttributeError):
        return None

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (_LONGEST_LOG, _LONGEST_LOG))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        prctl(_DEATH_SIGNAL, signal.SIGKILL)

    return limit


def wait_until(condition: Callable[[], object], seconds: float, step: float = 0.02) -> bool:
    """Whether `condition()` becomes true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(step)
    return True
