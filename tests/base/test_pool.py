"""The pool of workers: every task has one outcome, whatever happens to the process that works on it."""

from __future__ import annotations

import errno
import os
import re
import signal
import time
from pathlib import Path

import pytest

from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, meanwhile, run_tasks


def work(task: object) -> object:
    """Do as the task says."""
    if task == "crash":
        os.kill(os.getpid(), signal.SIGKILL)
    if task == "abort":
        os.abort()
    if task == "exit":
        os._exit(3)
    if task == "hang":
        time.sleep(60)
    if task == "error":
        raise ValueError("no such thing")
    if task == "memory":
        return len(bytearray(LIMITS.memory))
    if task == "full disk":
        raise OSError(errno.ENOSPC, "No space left on device", "/tmp/x")
    if task == "gone":
        raise FileNotFoundError(errno.ENOENT, "No such file or directory", "/tmp/x")
    if task == "pipes":
        time.sleep(0.2)  # so that all workers take part
        kinds = [os.readlink(f"/proc/self/fd/{name}") for name in os.listdir("/proc/self/fd") if os.path.lexists(f"/proc/self/fd/{name}")]
        return sum(kind.startswith("socket:") for kind in kinds)
    if task == "pid":
        return os.getpid()
    return f"done {task}"


def outcomes(tasks: list[object], jobs: int = 2, timeout: float = 20.0) -> dict[int, object]:
    found = list(run_tasks(work, tasks, jobs=jobs, timeout=timeout))
    assert sorted(index for index, _ in found) == list(range(len(tasks)))
    return dict(found)


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_every_task_has_its_result(jobs: int) -> None:
    assert outcomes(list(range(20)), jobs) == {index: f"done {index}" for index in range(20)}


def test_no_tasks() -> None:
    assert outcomes([]) == {}


@pytest.mark.parametrize(("task", "code"), [("crash", -9), ("abort", -6), ("exit", 3)])
@pytest.mark.parametrize("jobs", [1, 3])
def test_a_crash_costs_its_task(task: str, code: int, jobs: int) -> None:
    found = outcomes(["a", task, "b", "c"], jobs)
    assert found == {0: "done a", 1: Failure("crash", f"the worker process ended with code {code}"), 2: "done b", 3: "done c"}


def test_a_task_over_its_time_costs_itself() -> None:
    start = time.monotonic()
    found = outcomes(["a", "hang", "b", "c"], timeout=0.5)
    assert found == {0: "done a", 1: Failure("time limit", "not done after 0.5 s"), 2: "done b", 3: "done c"}
    assert time.monotonic() - start < 10


def test_an_exception_is_a_failure_with_its_text() -> None:
    found = outcomes(["a", "error", "b"], jobs=1)
    failure = found.pop(1)
    assert isinstance(failure, Failure)
    assert failure.reason == "error"
    assert re.fullmatch(r"ValueError: no such thing, in test_pool\.py:\d+", failure.detail)
    assert found == {0: "done a", 2: "done b"}


def test_many_crashes_are_survived() -> None:
    found = outcomes([f"crash{'' if index % 2 else 'less'}" for index in range(12)])
    assert [isinstance(found[index], Failure) for index in range(12)] == [index % 2 == 1 for index in range(12)]


def test_workers_are_kept_and_only_the_dead_are_replaced() -> None:
    found = outcomes(["pid"] * 6, jobs=1)
    assert len(set(found.values())) == 1
    found = outcomes(["pid", "crash", "pid", "pid"], jobs=1)
    assert found[0] != found[2] == found[3]


def test_no_worker_is_left_behind() -> None:
    found = outcomes(["pid", "hang", "pid", "crash"], timeout=0.5)
    for pid in (found[0], found[2]):
        with pytest.raises(ProcessLookupError):
            os.kill(int(str(pid)), 0)


def test_workers_end_when_the_caller_stops_early() -> None:
    tasks = run_tasks(work, ["pid"] * 50, jobs=2, timeout=20.0)
    _, pid = next(tasks)
    tasks.close()
    with pytest.raises(ProcessLookupError):
        os.kill(int(str(pid)), 0)


def test_a_large_result_passes() -> None:
    ((_, result),) = run_tasks(lambda size: "x" * size, [5_000_000], jobs=1, timeout=20.0)
    assert len(result) == 5_000_000


def test_there_is_at_least_one_job() -> None:
    assert default_jobs() >= 1


def test_memory_is_limited_as_asked_for() -> None:
    found = dict(run_tasks(bytearray, [100 << 20, 4 << 30], jobs=1, timeout=20.0, memory=3 << 30))
    assert len(found[0]) == 100 << 20
    assert found[1] == Failure("memory", "more than 3072 MiB")


def test_memory_and_files_have_reasons_of_their_own() -> None:
    assert outcomes(["memory", "full disk", "gone", "a"], jobs=1) == {
        0: Failure("memory", "more than 4096 MiB"), 1: Failure("disk full", "/tmp/x"),
        2: Failure("not readable", "/tmp/x: No such file or directory"), 3: "done a",
    }  # fmt: skip


def test_workers_do_not_hold_the_pipes_of_others() -> None:
    """Each knows the end of the caller's life from its own pipe."""
    found = outcomes(["pipes"] * 8, jobs=4)
    assert len(set(found.values())) == 1


def test_work_meanwhile_is_done_when_it_was_waited_for(tmp_path: Path) -> None:
    with meanwhile(lambda: (tmp_path / "done").write_text("x")) as wait:
        wait()
    assert (tmp_path / "done").read_text() == "x"


def test_work_meanwhile_ends_with_its_block(tmp_path: Path) -> None:
    start = time.monotonic()
    with meanwhile(lambda: time.sleep(30)):
        pass
    assert time.monotonic() - start < 10


def test_work_meanwhile_that_fails_says_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    with meanwhile(lambda: 1 // 0) as wait:
        wait()
    assert capfd.readouterr() == ("", "")
