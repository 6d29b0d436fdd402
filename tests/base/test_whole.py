"""Files and folders that are written whole or not at all."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from rosarch.base.whole import whole_folder, write_whole


@contextmanager
def full_disk() -> Iterator[None]:
    """No file can be larger than 100 bytes, as on a disk that is full: for this process, so for what is done within and no longer."""
    before, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def _content(folder: Path) -> dict[str, str]:
    return {str(path.relative_to(folder)): path.read_text() if path.is_file() else "" for path in folder.rglob("*")}


def test_a_file_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "old").mkdir()
    for path in (tmp_path / "new" / "deep" / "file", tmp_path / "old" / "file"):
        with pytest.raises(OSError, match="File too large") as raised, full_disk():
            write_whole(path, b"x" * 101)
        assert raised.value.filename == str(path)
    assert _content(tmp_path) == {"old": ""}


def test_the_disk_is_full_for_no_other_test() -> None:
    before = resource.getrlimit(resource.RLIMIT_FSIZE), signal.getsignal(signal.SIGXFSZ)
    with pytest.raises(KeyError), full_disk():
        raise KeyError
    assert (resource.getrlimit(resource.RLIMIT_FSIZE), signal.getsignal(signal.SIGXFSZ)) == before


def test_a_folder_gets_all_of_its_files(tmp_path: Path) -> None:
    out = tmp_path / "new" / "out"
    for text in ("first", "second"):
        with whole_folder(out) as folder:
            write_whole(folder / "a" / "b", text.encode())
    (out / "other").touch()
    with whole_folder(out) as folder:
        (folder / "c").write_text("third")
    assert _content(tmp_path / "new") == {"out": "", "out/a": "", "out/a/b": "second", "out/c": "third", "out/other": ""}


def test_what_a_killed_run_left_is_removed_by_the_next(tmp_path: Path) -> None:
    killed = "from rosarch.base.whole import whole_folder\nimport os, pathlib\n"
    killed += "with whole_folder(pathlib.Path('out')) as folder:\n    (folder / 'file').touch()\n    os.kill(os.getpid(), 9)\n"
    assert subprocess.run([sys.executable, "-c", killed], cwd=tmp_path).returncode == -signal.SIGKILL
    assert list(tmp_path.iterdir())
    with whole_folder(tmp_path / "out") as folder:
        (folder / "mine").touch()
        with whole_folder(tmp_path / "other") as theirs:  # in use: both stay
            (theirs / "yours").touch()
    assert sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*")) == ["other", "other/yours", "out", "out/mine"]


@pytest.mark.parametrize("there", [(), ("out",), ("out", "out/a")])
def test_a_folder_whose_last_file_cannot_be_written_gets_none(tmp_path: Path, there: tuple[str, ...]) -> None:
    for name in there:
        (tmp_path / name).mkdir()
        (tmp_path / name / "file").write_text("before")
    before = _content(tmp_path)
    with pytest.raises(OSError, match="File too large") as raised, full_disk(), whole_folder(tmp_path / "out") as folder:
        write_whole(folder / "a" / "file", b"after")
        write_whole(folder / "b" / "file", b"x" * 101)
    assert raised.value.filename == str(tmp_path / "out" / "b" / "file")
    assert _content(tmp_path) == before


def test_a_folder_that_has_a_folder_in_the_place_of_a_file_gets_none(tmp_path: Path) -> None:
    (tmp_path / "out" / "b").mkdir(parents=True)
    with pytest.raises(IsADirectoryError), whole_folder(tmp_path / "out") as folder:
        write_whole(folder / "a", b"")
        write_whole(folder / "b", b"")
    assert _content(tmp_path / "out") == {"b": ""}


def test_devices_and_pipes_are_written_to(tmp_path: Path) -> None:
    (tmp_path / "null").symlink_to(os.devnull)
    write_whole(tmp_path / "null", b"text")
    assert _content(tmp_path) == {"null": ""}
    assert (tmp_path / "null").is_symlink()
    os.mkfifo(tmp_path / "pipe")
    end = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    write_whole(tmp_path / "pipe", b"text")
    assert os.read(end, 10) == b"text"
    os.close(end)
    assert (tmp_path / "pipe").is_fifo()
