"""What `docs/` shows is what happens."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import rosarch.datalog

DOCS = Path(__file__).resolve().parents[2] / "docs"


def blocks(name: str, language: str) -> list[str]:
    text = (DOCS / name).read_text(encoding="utf-8")
    return [body for found, body in re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL) if found == language]


def test_the_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    script, session = blocks("datalog.md", "python")
    names: dict[str, Any] = {}
    exec(script, names)
    assert capsys.readouterr().out == "a b\na c\nb c\n"
    command, expected = session.split("\n", 1)
    exec(command.removeprefix(">>> "), names)
    assert capsys.readouterr().out.rstrip("\n") == expected.rstrip("\n")
    text = (DOCS / "datalog.md").read_text(encoding="utf-8")
    for name in re.findall(r"`([a-z_]+)\(", text):
        assert (
            name in rosarch.datalog.__all__ or name == "leaves" or name in ("location", "source_file", "autoinc", "recursive_iteration_cnt")
        ), name


def test_every_public_name_is_there() -> None:
    for name in rosarch.datalog.__all__:
        assert getattr(rosarch.datalog, name) is not None
    with pytest.raises(AttributeError):
        rosarch.datalog.no_such_name  # noqa: B018


def test_from_an_empty_file_to_an_explained_row(
    rosarch: Callable[..., Any], examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pairs.dl").write_text(blocks("rules.md", "prolog")[0])
    ran = 0
    for block in blocks("rules.md", ""):
        command, _, expected = block.partition("\n")
        if not command.startswith("$ rosarch") or "mobile_base" not in command or "error:" in block:
            continue
        arguments = [
            a or b for a, b in re.findall(r"'([^']*)'|(\S+)", command.removeprefix("$ rosarch ").replace("examples/", f"{examples}/"))
        ]
        done = rosarch(*arguments)
        assert done.code == 0, done.err
        actual = done.out.removeprefix("== base_odometry/odometry_node\n").splitlines()
        wanted = [re.sub(r"#\w{4}|\.dl:(?:\d+|\.{3})", "", line) for line in expected.splitlines() if line != "  ..."]
        assert set(wanted) <= {re.sub(r"#\w{4}|\.dl:(?:\d+|\.{3})", "", line) for line in actual}, command
        ran += 1
    assert ran == 4


def _without_keys(text: str) -> str:
    """A text whose keys of configurations are all alike: with values that are paths, they depend on where the workspace lies."""
    return re.sub(r"@[0-9a-f]{12}#", "@key#", text)


def test_a_check_of_ones_own(rosarch: Callable[..., Any], examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(examples)
    check = blocks("rules.md", "prolog")[-1]
    (tmp_path / "old-position.dl").write_text(check)
    shown = {block.partition("\n")[0]: block.partition("\n")[2] for block in blocks("rules.md", "") if "patrol_robot" in block}
    for command, expected in shown.items():
        done = rosarch(*shlex.split(command)[2:])
        assert (done.code, _without_keys(done.out)) == (int("old-position" in command), _without_keys(expected))
    (error,) = (block for block in blocks("rules.md", "") if "error: old-position.dl:" in block)
    (tmp_path / "old-position.dl").write_text(check.replace("{length}", "{lenght}"))
    done = rosarch("check", "examples/patrol_robot", "--rules", "old-position.dl")
    assert (done.code, done.err) == (2, error)
    assert len(shown) == 2


def test_variants(rosarch: Callable[..., Any], examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(examples)
    (tmp_path / "all.dl").write_text('.pragma "override" "state_variable"\nstate_variable(V) :- changes(_, _, V).\n')
    shown = [block for block in blocks("variants.md", "") if block.startswith("$")]
    shown += [block for block in blocks("rules.md", "") if "all.dl" in block]
    ran = 0
    for part in re.split(r"^\$ rosarch ", "".join(shown), flags=re.MULTILINE)[1:]:
        command, _, expected = part.partition("\n")
        done = rosarch(*shlex.split(command))
        actual = (done.err + done.out).splitlines()
        assert [line for line in expected.splitlines() if line != "..." and line not in actual] == [], command
        ran += 1
    assert ran == 4


def test_a_variant_and_an_option_of_ones_own(rosarch: Callable[..., Any], examples: Path, tmp_path: Path) -> None:
    variant, option = blocks("variants.md", "prolog")
    folder = tmp_path / "my_rules"
    (folder / "variants" / "state-variable").mkdir(parents=True)
    (folder / "variants" / "state-variable" / "all.dl").write_text(variant)
    (folder / "late.dl").write_text(f".decl late_queue(port: PortModel)\n{option}")
    chosen = ("--rules", folder, "--variant", "state-variable=all", "--option", "late=3")
    done = rosarch("query", examples / "docking_states", "state_variable(V)", *chosen, "-c", "docking")
    assert done.out.splitlines()[-1] == "2 rows"
    late = rosarch("query", examples / "patrol_robot", "late_queue(Port)", *chosen, "--launch", "*")
    assert "patrol_robot/patrol#" in late.out
