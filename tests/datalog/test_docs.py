"""What `docs/` shows is what happens."""

from __future__ import annotations

import re
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


@pytest.mark.slow
def test_mistakes_are_reported_as_shown(
    rosarch: Callable[..., Any], examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(examples)
    pairs, check = blocks("rules.md", "prolog")[0], blocks("rules.md", "prolog")[1]
    misspelt = {
        "pairs.dl": (
            pairs.replace(', port([_, "publisher", Answer]),', ', prt([_, "publisher", Answer]),'),
            ("rules", "run", "examples/mobile_base"),
        ),
        "old-position.dl": (check.replace("{length}", "{lenght}"), ("check", "examples/patrol_robot", "--rules")),
    }
    shown = {name: error for error in blocks("rules.md", "text") for name in misspelt if f"error: {name}:" in error}
    assert set(shown) == set(misspelt)
    for name, (text, command) in misspelt.items():
        (tmp_path / name).write_text(text)
        done = rosarch(*command, name)
        assert (done.code, done.err) == (2, shown[name])


@pytest.mark.slow
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
