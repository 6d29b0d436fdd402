"""Names and files of the input, which are never trusted."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosarch.base.files import file_name, path_below, path_text, read_file


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("talker", "talker"),
        ("talker-2.0 (old)", "talker-2.0 (old)"),
        ("größe", "größe"),
        ("../../evil", "evil"),
        ("/tmp/evil", "evil"),
        ("..", "_"),
        (".", "_"),
        ("", "_"),
        ("a/", "_"),
        ("a\0b\nc\x1b[31m\udcff\u202e", "a_b_c_[31m__"),
        ("ä" * 300, "ä" * 100),
    ],
)
def test_names_of_files(text: str, name: str) -> None:
    assert file_name(text) == name
    assert file_name(name) == name


def test_paths_stay_below_their_folder(tmp_path: Path) -> None:
    assert path_below(tmp_path, "a", "b.json") == tmp_path / "a" / "b.json"
    with pytest.raises(ValueError) as caught:
        path_below(tmp_path, "..", "b")
    assert str(caught.value) == f"{tmp_path}/../b is not below {tmp_path}"
    with pytest.raises(ValueError):
        path_below(tmp_path, "/etc", "b")


def test_only_regular_files_are_read(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"text")
    assert read_file(tmp_path / "file") == b"text"
    os.mkfifo(tmp_path / "pipe")
    for name in ("pipe", "."):
        with pytest.raises(OSError, match="not a regular file"):
            read_file(tmp_path / name)


def test_paths_as_text() -> None:
    assert path_text("größe.cpp") == "größe.cpp"
    assert path_text(os.fsdecode(b"a\xff/b.cpp")) == "a\\xff/b.cpp"
