"""What the command prints and writes when all is well."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.reports.table import models_text

TABLE = """\
talker/talker  node talker  talker/
  publisher  chatter  std_msgs/String  queue 10    talker.cpp:8

1 component, 1 port (1 publisher), 0 with unknown name, N s
"""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("NO_COLOR", raising=False)


def timeless(text: str) -> str:
    return re.sub(r"\d+\.\d s$", "N s", text, flags=re.MULTILINE)


@pytest.mark.parametrize("command", [("analyze", "ws"), ("show", "ports", "ws"), ("show", "ports", "ws", "talker/talker")])
def test_table(rosarch: Callable, workspace: Path, command: tuple[str, ...]) -> None:
    outcome = rosarch(*command)
    assert (outcome.code, timeless(outcome.out), outcome.err) == (0, TABLE, "")


def test_models_in_files(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    outcome = rosarch("analyze", "ws", "-o", "out")
    assert timeless(outcome.out) == TABLE.splitlines(keepends=True)[-1]
    text = (tmp_path / "out" / "talker" / "talker.json").read_text()
    assert text.endswith("}\n")
    assert list(json.loads(text)) == [
        "system", "component", "package", "kind", "middleware", "node_name", "sources", "ports", "params",
        "periodic", "reactive", "state_variables", "configuration", "transitions", "reactive_deferred", "one_shot", "open",
    ]  # fmt: skip


def test_models_on_stdout(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    outcome = rosarch("analyze", "ws", "--format", "json", "-o", "out")
    assert json.loads(outcome.out) == [json.loads((tmp_path / "out" / "talker" / "talker.json").read_text())]


def test_ports_as_json(rosarch: Callable, workspace: Path) -> None:
    (model,) = json.loads(rosarch("show", "ports", "ws", "--format", "json").out)
    assert list(model) == ["system", "component", "package", "kind", "node_name", "ports"]
    assert [port["name"] for port in model["ports"]] == ["chatter"]


def test_ports_as_markdown(rosarch: Callable, workspace: Path) -> None:
    assert rosarch("show", "ports", "ws", "--format", "markdown").out == (
        "## talker/talker (node)\n"
        "\n"
        "| kind | name | type | queue | callback | source |\n"
        "|---|---|---|---|---|---|\n"
        "| publisher | `chatter` | std_msgs/String | 10 |  | talker/talker.cpp:8 |\n"
    )


def test_facts_give_the_models_of_their_sources(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    assert rosarch("extract", "ws", "-o", "facts").out == "facts of 1 component in facts\n"
    rosarch("analyze", "facts", "-o", "from_facts")
    rosarch("analyze", "ws", "-o", "from_sources")
    name = "talker/talker.json"
    assert (tmp_path / "from_facts" / name).read_bytes() == (tmp_path / "from_sources" / name).read_bytes()


@pytest.mark.slow
def test_two_runs_and_worker_counts_agree(rosarch: Callable, examples: Path, tmp_path: Path) -> None:
    written = []
    for number, jobs in enumerate((1, 2, 2)):
        assert rosarch("analyze", examples, "--jobs", jobs, "-o", tmp_path / str(number)).code == 0
        folder = tmp_path / str(number)
        written.append({path.relative_to(folder): path.read_bytes() for path in folder.glob("*/*.json")})
    assert len(written[0]) >= 10
    assert written[0] == written[1] == written[2]


def test_sources_stay_untouched(rosarch: Callable, workspace: Path) -> None:
    before = {path: path.stat().st_mtime_ns for path in workspace.rglob("*")}
    rosarch("analyze", "ws")
    assert {path: path.stat().st_mtime_ns for path in workspace.rglob("*")} == before


def test_narrow_terminal(rosarch: Callable, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.analysis.components import analyze

    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.setenv("NO_COLOR", "1")
    text = models_text(analyze(workspace).models, parameters=False, terminal=True)
    assert re.sub(r"\x1b\[[0-9;]*m", "", text) == (
        "talker/talker  node talker  talker/\n"
        "  publisher chatter\n"
        "      std_msgs/String queue 10\n"
        "      talker.cpp:8\n"
        "\n"
    )  # fmt: skip


def test_no_color(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosarch.analysis.components import analyze

    models = analyze(workspace).models
    monkeypatch.setenv("TERM", "xterm")
    assert "\x1b[32m" in models_text(models, parameters=False, terminal=True)
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[32m" not in models_text(models, parameters=False, terminal=True)


def test_version_and_help(rosarch: Callable) -> None:
    assert re.fullmatch(r"rosarch \d+\.\d+\.\d+\n", rosarch("--version").out)
    for command in ((), ("extract",), ("analyze",), ("show",), ("show", "ports")):
        outcome = rosarch(*command, "--help")
        assert (outcome.code, outcome.err) == (0, "")
        assert "Usage: " in outcome.out


def test_help_loads_no_analysis() -> None:
    code = "import sys; from rosarch.cli.main import main; main(['--version']); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"clang", "lark", "yaml", "numpy", "rosarch.datalog", "rosarch.extractor"} & set(loaded)


def test_the_help_tells_what_the_modules_of_commands_tell(rosarch: Callable) -> None:
    from rosarch.cli.command_table import SUMMARIES, load_command

    told = rosarch("--help").out
    for name, summary in SUMMARIES.items():
        assert load_command(name).help.partition("\n\n")[0].replace("\n", " ") == summary
        assert f"\n  {name} " in told


def test_the_help_of_a_group_is_not_cut_off(rosarch: Callable) -> None:
    assert "..." not in rosarch("show", "--help").out.replace("]...", "")
