"""Results that are kept with what they rest on: what is seen, what is not, and what damage, kills and runs at once do."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from rosarch.base import tracing
from rosarch.base.cache import Cache
from rosarch.base.files import read_file
from rosarch.base.memo import Memo
from rosarch.base.pool import run_tasks


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    folder = tmp_path / "tree"
    (folder / "deep").mkdir(parents=True)
    (folder / "deep" / "a.txt").write_text("a")
    (folder / "deep" / "b.txt").write_text("b")
    return folder


class Stage:
    """Reads files below a tree and things beside it, and counts how often."""

    def __init__(self, tree: Path, cache: Cache) -> None:
        self.tree, self.cache, self.made = tree, cache, 0
        self.variables: dict[str, str] = {}

    def run(self, key: str = "stage") -> str:
        variables = tracing.Variables(self.variables)

        def make() -> str:
            self.made += 1
            outside = self.tree.parent / "outside"
            tracing.probe(outside)
            return f"{read(self.tree / 'deep' / 'a.txt')} {outside.exists()} {variables.get('ROBOT')}"

        return Memo(self.cache, self.variables).recall([key], [str(self.tree)], make)


def read(path: Path) -> str:
    try:
        return read_file(path).decode()
    except OSError:
        return "?"


@pytest.fixture
def stage(tree: Path, tmp_path: Path) -> Stage:
    return Stage(tree, Cache(tmp_path / "cache"))


def age(path: Path, seconds: float = 100.0) -> None:
    """Make a file look as if it had not been changed for a while; the time of its last change of status is what it is."""
    os.utime(path, (time.time() - seconds,) * 2)


def test_nothing_changed(stage: Stage) -> None:
    assert [stage.run(), stage.run()] == ["a False None"] * 2
    assert stage.made == 1
    assert stage.run("another") == "a False None"
    assert stage.made == 2


@pytest.mark.parametrize(
    ("change", "result"),
    [
        (lambda tree: (tree / "deep" / "a.txt").write_text("c"), "c False None"),
        (lambda tree: (tree / "deep" / "a.txt").unlink(), "? False None"),
        (lambda tree: (tree / "deep" / "new.txt").touch(), "a False None"),
        (lambda tree: (tree / "deep" / "b.txt").unlink(), "a False None"),
        (lambda tree: (tree / "deep" / "b.txt").rename(tree / "b.txt"), "a False None"),
        (lambda tree: (tree / "empty").mkdir(), "a False None"),
        (lambda tree: (tree.parent / "outside").touch(), "a True None"),
    ],
)
def test_a_change_is_seen(stage: Stage, tree: Path, change: Callable[[Path], object], result: str) -> None:
    stage.run()
    change(tree)
    assert [stage.run(), stage.run()] == [result] * 2
    assert stage.made == 2


def test_what_was_not_looked_at_may_change(stage: Stage, tree: Path, tmp_path: Path) -> None:
    (tree / ".git").mkdir()
    stage.run()
    (tree / "deep" / "b.txt").write_text("c")
    (tree / ".git" / "index").touch()
    (tmp_path / "elsewhere").touch()
    stage.variables = {"ANOTHER": "x"}
    stage.run()
    assert stage.made == 1


def test_a_variable(stage: Stage) -> None:
    stage.run()
    stage.variables = {"ROBOT": "x"}
    assert [stage.run(), stage.run()] == ["a False x"] * 2
    stage.variables = {"ROBOT": "y"}
    assert stage.run() == "a False y"
    assert stage.made == 3


def test_the_content_decides_and_not_the_time(stage: Stage, tree: Path) -> None:
    stage.run()
    (tree / "deep" / "a.txt").write_text("a")
    age(tree / "deep" / "a.txt")
    stage.run()
    assert stage.made == 1


def test_a_change_at_once_that_shows_in_no_time_is_seen(stage: Stage, tree: Path) -> None:
    file = tree / "deep" / "a.txt"
    stage.run()
    times = file.stat()
    file.write_text("c")
    os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert stage.run() == "c False None"


def test_files_that_have_settled_are_not_read_again(stage: Stage, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tracing, "_SETTLED", 0)
    stage.run()
    time.sleep(0.01)
    stage.run()  # only now the stamp can be trusted

    def refuse(*_args: object) -> bytes:
        raise AssertionError("read again")

    monkeypatch.setattr(tracing, "_content", refuse)
    assert stage.run() == "a False None"
    assert stage.made == 1


def test_links(stage: Stage, tree: Path, tmp_path: Path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "file").write_text(name)
    (tree / "link").symlink_to(tmp_path / "one")
    stage.run()
    (tmp_path / "one" / "more").touch()
    stage.run()
    assert stage.made == 2
    (tree / "link").unlink()
    (tree / "link").symlink_to(tmp_path / "two")
    stage.run()
    (tree / "loop").symlink_to(tree)
    stage.run()
    assert stage.made == 4


def test_stages_in_stages(tree: Path, tmp_path: Path) -> None:
    cache, made = Cache(tmp_path / "cache"), []

    def outer(memo: Memo) -> str:
        made.append("outer")
        return read(tree / "deep" / "b.txt") + memo.recall(["inner"], [str(tree)], inner)

    def inner() -> str:
        made.append("inner")
        return read(tree / "deep" / "a.txt")

    def run() -> str:
        memo = Memo(cache)
        return memo.recall(["outer"], [str(tree)], lambda: outer(memo))

    assert run() == run() == "ba"
    assert made == ["outer", "inner"]
    (tree / "deep" / "b.txt").write_text("c")
    assert run() == run() == "ca"
    assert made == ["outer", "inner", "outer"]
    (tree / "deep" / "a.txt").write_text("d")
    assert run() == run() == "cd"
    assert made == ["outer", "inner", "outer", "outer", "inner"]


def test_a_stage_that_sees_as_little_as_the_one_around_it_is_told_apart(tree: Path, tmp_path: Path) -> None:
    memo = Memo(Cache(tmp_path / "cache"))
    assert memo.recall(["outer"], [str(tree)], lambda: memo.recall(["inner"], [str(tree)], lambda: 1) + 1) == 2


def test_what_workers_see_counts(tree: Path, tmp_path: Path) -> None:
    cache, files = Cache(tmp_path / "cache"), [tree / "deep" / "a.txt", tree / "deep" / "b.txt"]

    def run() -> list[str]:
        return Memo(cache).recall(["s"], [str(tree)], lambda: [str(text) for _, text in sorted(run_tasks(read, files, jobs=2, timeout=60))])

    assert run() == run() == ["a", "b"]
    files[1].write_text("c")
    assert run() == ["a", "c"]


def test_a_task_that_fails_may_not_do_so_again(tree: Path, tmp_path: Path) -> None:
    cache, made = Cache(tmp_path / "cache"), []

    def work(_task: int) -> None:
        raise MemoryError

    def make() -> list[str]:
        made.append(1)
        return [type(outcome).__name__ for _, outcome in run_tasks(work, [1], jobs=1, timeout=60)]

    for _ in range(2):
        assert Memo(cache).recall(["s"], [str(tree)], make) == ["Failure"]
    assert len(made) == 2


def test_a_file_that_changes_while_it_is_read(tree: Path, tmp_path: Path) -> None:
    cache, file = Cache(tmp_path / "cache"), tree / "deep" / "a.txt"

    def make() -> str:
        first = read(file)
        file.write_text("c")
        return first + read(file)

    assert Memo(cache).recall(["s"], [str(tree)], make) == "ac"
    assert Memo(cache).recall(["s"], [str(tree)], make) == "cc"


def test_an_error_is_not_kept(stage: Stage, tree: Path) -> None:
    def fail() -> str:
        raise ValueError("no")

    for _ in range(2):
        with pytest.raises(ValueError, match="no"):
            Memo(stage.cache).recall(["stage"], [str(tree)], fail)
    assert stage.run() == "a False None"
    assert not tracing._recordings


@pytest.mark.parametrize("damage", [b"", b"no pickle", b"cno.such.module\nThing\n.", b"N."])
@pytest.mark.parametrize("checksum", [True, False])
def test_a_damaged_entry_is_replaced(stage: Stage, damage: bytes, checksum: bool) -> None:
    stage.run()
    (entry,) = stage.cache.folder.glob("*/*")
    if checksum:
        stage.cache.store(entry.parent.name + entry.name, damage)
    else:
        entry.write_bytes(damage)
    assert [stage.run(), stage.run()] == ["a False None"] * 2
    assert stage.made == 2


def test_another_version_has_its_own(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.run()
    monkeypatch.setattr("rosarch.base.memo.stage_version", lambda: "changed")
    stage.run()
    assert stage.made == 2


def test_a_cache_that_cannot_be_written(tree: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    stage = Stage(tree, Cache(tmp_path / "file" / "cache"))
    assert [stage.run(), stage.run()] == ["a False None"] * 2
    assert stage.made == 2


SCRIPT = """
import sys
from pathlib import Path
from rosarch.base.cache import Cache
from rosarch.base.files import read_file
from rosarch.base.memo import Memo
tree, cache = map(Path, sys.argv[1:])
while True:
    for number in range(20):
        Memo(Cache(cache)).recall([str(number)], [str(tree)], lambda: read_file(tree / "deep" / "a.txt").decode() * 100_000)
        print(number, flush=True)
"""


@pytest.fixture
def runs(tree: Path, tmp_path: Path) -> Iterator[list[subprocess.Popen[bytes]]]:
    command = [sys.executable, "-c", SCRIPT, str(tree), str(tmp_path / "cache")]
    found = [subprocess.Popen(command, stdout=subprocess.PIPE) for _ in range(2)]
    yield found
    for process in found:
        process.kill()
        process.communicate()


def test_runs_at_once_that_are_killed(tree: Path, tmp_path: Path, runs: list[subprocess.Popen[bytes]]) -> None:
    for process in runs:
        assert process.stdout is not None
        process.stdout.readline()
    (tree / "deep" / "a.txt").write_text("x")
    for process in runs:
        assert process.stdout is not None
        process.stdout.readline()
        process.send_signal(signal.SIGKILL)
        process.wait()
    (tree / "deep" / "a.txt").write_text("z")

    def again(number: int) -> str:
        return Memo(Cache(tmp_path / "cache")).recall([str(number)], [str(tree)], lambda: read(tree / "deep" / "a.txt") * 100_000)

    assert {again(number) for number in range(20)} == {"z" * 100_000}
    with ThreadPoolExecutor(1) as pool:
        assert set(pool.map(again, range(20))) == {"z" * 100_000}
