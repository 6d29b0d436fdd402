"""`docs/guide.md`, followed by somebody who takes every word of it: files are written as it says, commands print what it shows."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

GUIDE = Path(__file__).parents[2] / "docs" / "guide.md"
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"`((?:my_rules/)?[\w/]+\.(?:dl|cpp|yml))`")
LEFT_OUT = "..."


def steps() -> Iterator[tuple[str, str, str]]:
    """What to do, in order: `write` a file with a content, or `run` a command that prints something."""
    text = GUIDE.read_text(encoding="utf-8")
    before = 0
    for block in BLOCK.finditer(text):
        if block[1]:
            yield "write", FILE.findall(text[before : block.start()])[-1], block[2]
        else:
            for part in re.split(r"^\$ ", block[2], flags=re.MULTILINE)[1:]:
                command, _, printed = part.partition("\n")
                yield "run", command, printed
        before = block.end()


def pattern(shown: str) -> str:
    """What `...` leaves out may be anything: alone, whole lines."""
    lines = [r"(?:.*\n)*" if line == LEFT_OUT else ".*".join(map(re.escape, line.split(LEFT_OUT))) + "\n" for line in shown.splitlines()]
    return "".join(lines)


def test_the_guide(rosarch: Callable[..., Any], examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every command of the guide, with what it prints. Only where a mutant survives is the exit code 1."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(examples)
    commands = []
    for kind, what, text in steps():
        if kind == "write":
            (tmp_path / what).write_text(text, encoding="utf-8")
            continue
        program, *arguments = shlex.split(what)
        assert program == "rosarch"
        done = rosarch(*arguments)
        survivors = arguments[:2] == ["rules", "mutate"] and "(100.0%)" not in text
        assert done.code == int(survivors), (what, done.err)
        assert re.fullmatch(pattern(text), done.out), (what, done.out)
        commands.append(what)
    assert len(commands) >= 10
