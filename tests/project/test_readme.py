"""The commands of the README and of that of the examples run, and print what these say."""

from __future__ import annotations

import json
import re
import shlex
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.models.machine.build import build_machine
from rosarch.reports.behavior_text import behaviors_text
from rosarch.reports.machines import machines_text

ROOT = Path(__file__).resolve().parents[2]
README, EXAMPLES = ((ROOT / folder / "README.md").read_text(encoding="utf-8") for folder in ("", "examples"))
BOTH = README + EXAMPLES
CONSOLE = re.findall(r"```console\n\$ (rosarch [^\n]*)\n(.*?)```", BOTH, re.DOTALL)
DIAGRAMS = re.findall(r"```mermaid\n(.*?)```", BOTH, re.DOTALL)
SCRIPTS = re.findall(r"```sh\n(.*?)```", BOTH, re.DOTALL)


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)


def timeless(text: str) -> str:
    return re.sub(r"\d+\.\d s$", "N s", text, flags=re.MULTILINE)


@pytest.mark.parametrize(("command", "output"), CONSOLE, ids=[command for command, _ in CONSOLE])
def test_shown_output(command: str, output: str, rosarch: Callable) -> None:
    outcome = rosarch(*shlex.split(command)[1:])
    found = re.search(r"^\d+ findings?: \d+ (error|warning)", output, re.MULTILINE) is not None
    assert (outcome.code, timeless(outcome.out), outcome.err) == (int(found), timeless(output), "")


def test_the_graph_is_that_of_the_example(rosarch: Callable) -> None:
    (command,) = re.findall(r"^(rosarch show graph .* --format mermaid)$", README, re.MULTILINE)
    assert [rosarch(*shlex.split(command)[1:]).out] == DIAGRAMS[:1]


def test_machines_are_those_of_the_examples() -> None:
    expected = ROOT / "examples/docking_states/expected/auto_docking"
    docking, lamp = (json.loads((expected / f"{name}.json").read_text()) for name in ("docking", "dock_lamp"))
    shown = dict(CONSOLE)
    assert shown["rosarch show machine examples/docking_states docking"] == machines_text([build_machine(docking)], "text")
    assert DIAGRAMS[1:] == [machines_text([build_machine(docking)], "mermaid")]
    assert shown["rosarch show behavior examples/docking_states dock_lamp"] == behaviors_text([lamp])


def test_commands_run(rosarch: Callable) -> None:
    commands = [line for script in SCRIPTS for line in script.splitlines() if line.startswith("rosarch ")]
    assert len(commands) > 5
    for command in commands:
        outcome = rosarch(*shlex.split(command, comments=True)[1:])
        assert (outcome.code, outcome.err) == (0, ""), command


def test_make_targets_exist() -> None:
    makefile = (ROOT / "Makefile").read_text()
    named = re.findall(r"^make (\w+)", "\n".join(SCRIPTS), re.MULTILINE)
    assert {"demo", "test"} <= set(named)
    for target in named:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_demo_is_what_the_readme_shows() -> None:
    assert f"$ {re.search(r'^demo:.*?/(rosarch .*?)$', (ROOT / 'Makefile').read_text(), re.MULTILINE | re.DOTALL)[1]}\n" in README


def test_examples_are_described() -> None:
    for path in (ROOT / "examples").glob("*/expected"):
        assert f"## {path.parent.name}" in EXAMPLES


def test_links_exist() -> None:
    for folder, text in ((ROOT, README), (ROOT / "examples", EXAMPLES)):
        for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", text):
            assert (folder / target).exists(), target


def test_folders_are_told() -> None:
    tracked = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()
    for folder in {path.partition("/")[0] for path in tracked if "/" in path and not path.startswith(".")} - {"docs"}:
        assert f"`{folder}/`" in README, folder
