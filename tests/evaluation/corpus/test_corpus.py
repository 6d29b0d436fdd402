"""Workspaces as tasks of a real scheduler with real workers, one of which is killed."""

from __future__ import annotations

import json
import logging
import os
import shutil
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from distributed import Client, LocalCluster

from rosarch.evaluation.corpus import cluster as corpus_cluster
from rosarch.evaluation.corpus.cluster import Cluster, run
from rosarch.evaluation.corpus.task import Failed, Job, Unfinished, analyse

pytestmark = pytest.mark.slow

RULES = '.pragma "override" "port_queue"\nport_queue(Port, "7") :- port(Port).\n'
LAUNCH = '<launch><node name="t" pkg="talker" type="talker"/></launch>\n'


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    options: dict[str, Any] = {"silence_logs": logging.CRITICAL, "dashboard_address": None}
    with LocalCluster(n_workers=2, threads_per_worker=1, **options) as cluster:
        yield cluster.scheduler_address


@pytest.fixture
def workspaces(workspace: Path, tmp_path: Path) -> list[Path]:
    (workspace / "talker" / "t.launch").write_text(LAUNCH)
    found = [workspace, tmp_path / "two", tmp_path / "more" / "two"]
    for folder in found[1:]:
        shutil.copytree(workspace, folder)
    (found[1] / "talker" / "t.launch").unlink()
    return found


def kill_one_that_works(address: str, killed: list[int]) -> None:
    """Kill a worker as soon as one has a task."""
    with Client(address, set_as_default=False) as client:
        while not killed:
            busy = [worker for worker, tasks in client.processing().items() if tasks]
            if busy:
                time.sleep(0.3)
                killed += client.run(os.getpid, workers=busy[:1]).values()
                os.kill(killed[0], signal.SIGKILL)
            time.sleep(0.05)


def test_a_killed_worker_and_a_bad_workspace_cost_nothing_else(
    rosarch: Callable[..., Any], address: str, workspaces: list[Path], tmp_path: Path
) -> None:
    (tmp_path / "corpus.txt").write_text("# all\nws\ntwo # no launch files\n\nmore/two\nnone\n")
    killed: list[int] = []
    killer = threading.Thread(target=kill_one_that_works, args=(address, killed))
    killer.start()
    own = tmp_path / "own.dl"
    own.write_text(RULES)
    done = rosarch("corpus", tmp_path / "corpus.txt", "-o", tmp_path / "out", "--scheduler", address, "--rules", own)
    killer.join()
    assert killed
    assert done.code == 2
    rows = [line.split() for line in done.out.splitlines()]
    assert rows[:2] == [["Workspaces"], ["workspace", "components", "ports", "errors", "warnings", "notes", "seconds"]]
    assert [row[:6] for row in rows[2:5]] == [
        ["two", "1", "1", "-", "-", "-"], ["two_2", "1", "1", "0", "0", "1"], ["ws", "1", "1", "0", "0", "1"]
    ]  # fmt: skip
    assert done.out.splitlines()[5:] == ["", "none: no such folder", "", "4 workspaces, 1 failed"]
    models = (tmp_path / "out" / "ws" / "models.json").read_text()
    assert json.loads(models) == json.loads(rosarch("analyze", workspaces[0], "--format", "json", "--rules", own).out)
    assert '"queue": 7' in models
    assert sorted(str(path.relative_to(tmp_path / "out")) for path in (tmp_path / "out").rglob("*.json")) == [
        "corpus.json", "two/models.json", "two_2/findings.json", "two_2/models.json", "ws/findings.json", "ws/models.json"
    ]  # fmt: skip
    summaries = json.loads((tmp_path / "out" / "corpus.json").read_text())
    assert [each["workspace"] for each in summaries] == ["none", "two", "two_2", "ws"]
    assert summaries[0]["failed"] == "no such folder"


def test_a_task_that_takes_too_long_is_tried_again_and_told(address: str, workspaces: list[Path]) -> None:
    jobs = [Job(str(workspaces[0]), limit=0.01)]
    assert list(run(jobs, Cluster(address, retries=1))) == [(0, Failed("not done in time"))]
    with pytest.raises(Unfinished):
        analyse(jobs[0])


def test_what_rosarch_refuses_is_told(tmp_path: Path) -> None:
    assert analyse(Job(str(tmp_path))) == Failed(f"{tmp_path}: no package.xml below this folder")


def test_without_dask_or_a_scheduler_there_is_a_message(
    rosarch: Callable[..., Any], workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(corpus_cluster, "CONNECTING", 0.2)
    done = rosarch("corpus", workspace, "-o", tmp_path / "out", "--scheduler", "tcp://127.0.0.1:9")
    assert done.code == 2
    assert done.err.startswith("rosarch: error: tcp://127.0.0.1:9: no scheduler answers (")
    monkeypatch.setitem(sys.modules, "distributed", None)
    done = rosarch("corpus", workspace, "-o", tmp_path / "out")
    assert (done.code, done.err) == (2, "rosarch: error: a corpus needs Dask: pip install 'rosarch[cluster]'\n")
    empty = tmp_path / "empty.txt"
    empty.write_text("# nothing\n")
    done = rosarch("corpus", workspace, "-o", tmp_path / "out", "--variant", "state-variable=rosinfr")
    assert (done.code, done.err) == (2, "rosarch: error: state-variable has no variant `rosinfr`, did you mean `rosinfer`?\n")
    assert rosarch("corpus", empty, "-o", tmp_path / "out").err == "rosarch: error: no workspace is named\n"
