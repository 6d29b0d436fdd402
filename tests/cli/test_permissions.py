"""Files and folders that the user may not read or write: each costs itself, and is named."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

UNPRIVILEGED = [] if os.geteuid() else ["setpriv", "--bounding-set=-dac_override,-dac_read_search"]
"""What makes of root a user whom permissions bind."""

pytestmark = pytest.mark.skipif(
    bool(UNPRIVILEGED) and not (shutil.which("setpriv") and subprocess.run([*UNPRIVILEGED, "true"], check=False).returncode == 0),
    reason="root may read and write everywhere here",
)

BARRED = """
import pathlib, sys
from rosarch.cli.main import main
for path in sorted(pathlib.Path("ws").rglob("*")):
    mode = path.stat().st_mode
    path.chmod(0)
    print(f"\\n{path}: {main(sys.argv[1:])}", flush=True)
    path.chmod(mode)
"""
LAUNCH = '<launch><node name="t" pkg="talker" type="talker"><rosparam command="load" file="$(dirname)/p.yaml"/></node></launch>\n'
SOURCES = ("talker", "talker/CMakeLists.txt", "talker/package.xml", "talker/talker.cpp")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "files", "needed"),
    [
        (
            ("check", "-v", "ws"),
            (".rosarch.yml", *SOURCES[1:], "talker/launch/p.yaml", "talker/launch/t.launch"),
            (".rosarch.yml", "talker", "talker/launch"),  # where the configuration names a launch file
        ),
        (("analyze", "ws"), SOURCES, ("talker/package.xml",)),
        (("doctor", "ws"), SOURCES, ("talker/package.xml",)),
    ],
)
def test_what_may_not_be_read_costs_itself(
    workspace: Path, tmp_path: Path, words: tuple[str, ...], files: tuple[str, ...], needed: tuple[str, ...]
) -> None:
    package = workspace / "talker"
    (package / "launch").mkdir()
    (package / "launch" / "t.launch").write_text(LAUNCH)
    (package / "launch" / "p.yaml").write_text("rate: 1\n")
    (workspace / ".rosarch.yml").write_text("launch: [{files: [talker/launch/t.launch]}]\n")
    done = _run([sys.executable, "-c", BARRED, *words], tmp_path)
    assert done.returncode == 0, done.stdout
    assert "unexpected" not in done.stdout
    barred = re.findall(r"(.*?)\nws/(\S+): (\d)\n", done.stdout, re.DOTALL)
    assert {path for text, path, _ in barred if "permission denied" in text.lower()} == set(files)
    assert {path for _, path, code in barred if code == "2"} == set(needed)


def test_output_without_permission(workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "out").mkdir(mode=0o500)
    for out in ("out", "out/deep"):
        done = _run([sys.executable, "-m", "rosarch.cli", "analyze", "ws", "-o", out], tmp_path)
        assert (done.returncode, done.stdout) == (2, "rosarch: error: out: cannot write to this folder\n")


def _run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run it; what it prints, errors and all."""
    return subprocess.run([*UNPRIVILEGED, *command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
