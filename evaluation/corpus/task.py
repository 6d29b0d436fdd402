"""What is done for one workspace, wherever that is: `rosarch` runs as a program, so that nothing it meets can harm the worker."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from rosarch.base.pool import end_with_parent
from rosarch.extractor.launch import launch_files

REFUSED = 2
"""The exit code of `rosarch` for input that cannot be analysed, however often that is tried."""


@dataclass(frozen=True)
class Job:
    """A workspace, the options for all commands, and the seconds that they may take."""

    folder: str
    options: tuple[str, ...] = ()
    limit: float = 3600.0


@dataclass(frozen=True)
class Done:
    """Reports by name, documents that are JSON; `seconds` is the time that they took."""

    reports: Mapping[str, Any]
    seconds: float


@dataclass(frozen=True)
class Failed:
    """Why a workspace has no report."""

    reason: str


class Unfinished(Exception):
    """A run ended without an answer: another may not."""


def analyse(job: Job) -> Done | Failed:
    """The reports on one workspace: its models and, where it has launch files, its findings.

    Raises:
        Unfinished: rosarch was ended, or took too long.
    """
    if not os.path.isdir(job.folder):
        return Failed("no such folder")
    start = time.monotonic()
    reports = {}
    for name, command in (("models", "analyze"), ("findings", "check")):
        if name == "findings" and not launch_files(os.path.abspath(job.folder)):
            continue
        code, output, errors = _run([command, job.folder, "--format", "json", *job.options], start + job.limit - time.monotonic())
        if code == REFUSED:
            return Failed(errors.strip().rpartition("\n")[2].removeprefix("rosarch: error: ") or "refused without a word")
        if code not in (0, 1):
            raise Unfinished(f"rosarch {command} ended with code {code}")
        reports[name] = json.loads(output)
    return Done(reports, round(time.monotonic() - start, 3))


def _run(arguments: Sequence[str], limit: float) -> tuple[int, str, str]:
    """Exit code, output and errors of `rosarch`, which ends with this process."""
    parent = os.getpid()
    command = [sys.executable, "-m", "rosarch.cli", *arguments]
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8", errors="replace",
        start_new_session=True, preexec_fn=lambda: end_with_parent(parent),
    ) as process:  # fmt: skip
        try:
            output, errors = process.communicate(timeout=max(limit, 0.0))
        except BaseException as error:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            if isinstance(error, subprocess.TimeoutExpired):
                raise Unfinished("not done in time") from None
            raise
    return process.returncode, output, errors
