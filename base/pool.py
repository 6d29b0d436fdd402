"""Worker processes for work that may crash or hang: a task that does costs itself, never the run."""

from __future__ import annotations

import ctypes
import errno
import gc
import multiprocessing
import os
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, Generic, TypeVar

from rosarch.base import tracing
from rosarch.base.limits import LIMITS

Task = TypeVar("Task")
Result = TypeVar("Result")


_GARBAGE = 200_000
"""Objects that a worker's tasks have left behind when it looks for cycles among them."""
_DEATH_SIGNAL = 1
"""`PR_SET_PDEATHSIG` of prctl(2)."""


@dataclass(frozen=True)
class Failure:
    """Why a task has no result: `crash`, `time limit`, `memory`, `disk full`, `not readable` or `error`, with a detail for the reader."""

    reason: str
    detail: str


@dataclass
class _Worker(Generic[Task]):
    process: BaseProcess
    connection: Connection
    index: int = -1
    deadline: float = 0.0


def default_jobs() -> int:
    """The number of processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_tasks(
    function: Callable[[Task], Result], tasks: Sequence[Task], *, jobs: int, timeout: float, memory: int | None = None
) -> Iterator[tuple[int, Result | Failure]]:
    """Yield (index of the task, its result or failure) as tasks end, in no particular order.

    A worker that dies or works on one task for more than `timeout` seconds is replaced. None has more than `memory` bytes of
    addresses, as many as `LIMITS` says by default.
    """
    observed, memory = tracing.carried(function), memory or LIMITS.memory
    pending = iter(range(len(tasks)))
    workers: list[_Worker[Task]] = []
    busy: list[_Worker[Task]] = []
    try:
        for _ in range(min(jobs, len(tasks))):
            workers.append(_start(observed, workers, memory))
            _feed(workers[-1], pending, tasks, timeout, busy)
        while busy:
            patience = max(0.0, min(worker.deadline for worker in busy) - time.monotonic())
            ready = wait([worker.connection for worker in busy], patience)
            for worker in [w for w in busy if w.connection in ready or time.monotonic() > w.deadline]:
                busy.remove(worker)
                index, outcome = worker.index, _outcome(worker) if worker.connection in ready else _expire(worker, timeout)
                if not worker.process.is_alive():
                    workers.remove(worker)
                    worker.connection.close()
                    worker = _start(observed, workers, memory)
                    workers.append(worker)
                _feed(worker, pending, tasks, timeout, busy)
                if isinstance(outcome, Failure):
                    tracing.uncertain()  # another time, there may be more time or memory
                yield index, tracing.received(outcome)
    finally:
        for worker in workers:
            worker.process.kill()  # it has nothing to tidy up, and a worker that has just started may not heed anything else
            worker.process.join()
            worker.connection.close()


@contextmanager
def meanwhile(function: Callable[[], object]) -> Iterator[Callable[[], None]]:
    """Call a function for what it leaves on disk, in a process of its own; yields what waits for its end.

    Whether it succeeds is not reported: it must be work that the caller does itself where it finds it undone.
    """
    process = alongside(partial(_quietly, function))
    try:
        yield process.join
    finally:
        process.kill()
        process.join()


def alongside(function: Callable[[], object], *, daemon: bool = True) -> BaseProcess:
    """Call a function in a process of its own. Ctrl-C is not for that process: who started it ends it, or it ends when they do."""
    process: BaseProcess = _context().Process(target=_alone, args=(function, os.getpid()), daemon=daemon)
    _launch(process)
    return process


def _launch(process: BaseProcess) -> None:
    """Start a process; Ctrl-C waits until that is done, and the process knows what it does about it."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        process.start()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _heed_signals() -> None:
    """In a process that `_launch` started: Ctrl-C is for the parent, which ends this process; all others end it at once."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_SETMASK, ())


def _alone(function: Callable[[], object], parent: int) -> None:
    _heed_signals()
    end_with_parent(parent)
    function()


def _quietly(function: Callable[[], object]) -> None:
    with suppress(Exception):
        function()


def _context() -> Any:
    # fork hands the tables that the task function needs to the workers without copying them
    return multiprocessing.get_context("fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn")


def _start(function: Callable[[Any], Any], others: Sequence[_Worker[Any]], memory: int) -> _Worker[Any]:
    context = _context()
    forks = context.get_start_method() == "fork"
    ours, theirs = context.Pipe()
    inherited = [ours, *(worker.connection for worker in others)] if forks else []
    process = context.Process(target=_work, args=(function, theirs, inherited, os.getpid(), memory), daemon=True)
    _launch(process)
    theirs.close()
    return _Worker(process, ours)


def _feed(worker: _Worker[Task], pending: Iterator[int], tasks: Sequence[Task], timeout: float, busy: list[_Worker[Task]]) -> None:
    index = next(pending, None)
    if index is not None:
        worker.index, worker.deadline = index, time.monotonic() + timeout
        worker.connection.send(tasks[index])
        busy.append(worker)


def _outcome(worker: _Worker[Any]) -> Any:
    try:
        return worker.connection.recv()
    except (EOFError, ConnectionResetError):
        worker.process.join()
        return Failure("crash", f"the worker process ended with code {worker.process.exitcode}")


def _expire(worker: _Worker[Any], timeout: float) -> Failure:
    worker.process.kill()
    worker.process.join()
    return Failure("time limit", f"not done after {timeout:g} s")


def _work(function: Callable[[Any], Any], connection: Connection, inherited: Sequence[Connection], parent: int, memory: int) -> None:
    for other in inherited:
        other.close()  # or no worker would see the end of its pipe when the parent is killed
    _heed_signals()
    _limit(parent, memory)
    gc.disable()  # in the middle of a task nearly everything is in use
    gc.freeze()
    while True:
        try:
            task = connection.recv()
        except (EOFError, OSError):
            return
        try:
            result = function(task)
        except MemoryError:
            result = Failure("memory", f"more than {memory >> 20} MiB")
        except OSError as error:
            result = _failure_of_file(error)
        except Exception as error:  # the boundary of a worker: whatever goes wrong belongs to this task
            result = _failure(error)
        connection.send(result)
        if gc.get_count()[0] > _GARBAGE:
            gc.collect()
            gc.freeze()  # what outlives a task is kept for the next ones: it is not looked through again


def _failure_of_file(error: OSError) -> Failure:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):  # of what is written on the way; to read needs no space
        return Failure("disk full", str(error.filename or tempfile.gettempdir()))
    if isinstance(error, (FileNotFoundError, PermissionError)) and error.filename:
        return Failure("not readable", f"{error.filename}: {error.strerror}")
    return _failure(error)


def _failure(error: Exception) -> Failure:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return Failure("error", f"{type(error).__name__}: {error}, in {Path(frame.filename).name}:{frame.lineno}")


def _limit(parent: int, memory: int) -> None:
    """Bound the memory of this process, and end it with its parent, also in the middle of a task."""
    with suppress(ImportError, OSError, ValueError):
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        limit = min(known for known in (memory, soft, hard) if known != resource.RLIM_INFINITY)
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    end_with_parent(parent)


def end_with_parent(parent: int) -> None:
    """Have this process killed when `parent`, which started it, ends in whatever way."""
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(_DEATH_SIGNAL, signal.SIGKILL)
        if os.getppid() != parent:  # it has ended before
            os._exit(1)
