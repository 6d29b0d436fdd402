"""Files that a `.gitignore` keeps out of the repository."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.extractor.launch.ignored import kept_out
from rosarch.extractor.launch.meant import file_meant
from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.packages import PackagePath

LINES = "# made by calibration\nhead.yaml\n/robot/maps/*.pgm\nlogs/\ndata/**/raw.csv\n!kept.yaml\n"


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("robot/config/head.yaml", True),
        ("robot/config/other.yaml", False),
        ("robot/maps/office.pgm", True),
        ("robot/maps/old/office.pgm", False),
        ("robot/logs/today/run.yaml", True),
        ("data/one/two/raw.csv", True),
        ("robot/data/raw.csv", False),
        ("kept.yaml", False),
    ],
)
def test_patterns(tmp_path: Path, path: str, expected: bool) -> None:
    (tmp_path / ".gitignore").write_text(LINES)
    assert kept_out(str(tmp_path / path), str(tmp_path)) == expected


def test_what_is_kept_out_is_made_on_each_machine(tmp_path: Path) -> None:
    config = tmp_path / "src" / "robot" / "config"
    config.mkdir(parents=True)
    (config.parent / "package.xml").write_text("<package><name>robot</name></package>")
    packages = PackagePath([tmp_path / "src"])
    assert not packages.makes(str(config / "head.yaml"))
    (config / ".gitignore").write_text("head.yaml\n")
    assert packages.makes(str(config / "head.yaml"))
    (tmp_path / ".gitignore").write_text("*.json\n")  # above the workspace: of another repository
    assert not packages.makes(str(config / "head.json"))


def test_a_made_file_is_neither_there_nor_absent(tmp_path: Path) -> None:
    config = tmp_path / "robot" / "config"
    config.mkdir(parents=True)
    (config / "old.yaml").write_text("a: 1\n")
    (tmp_path / "robot" / ".gitignore").write_text("head.yaml\n")
    packages = PackagePath([tmp_path])
    made = file_meant("value", str(config / "head.yaml"), Place("x.launch", 1), packages, there=False)
    gone = file_meant("value", str(config / "gone.yaml"), Place("x.launch", 1), packages, there=False)
    assert (made.made, made.absent, made.beside) == (True, False, None)
    assert (gone.made, gone.absent, gone.beside) == (False, True, str(config / "old.yaml"))
