"""`rosarch watch` while files are saved."""

from __future__ import annotations

import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from rosarch.cli.main import main

EXAMPLE = Path(__file__).parents[2] / "examples" / "docking_states"
RULES = """\
.decl named(name: symbol)
.output named
named(Name) :- port([_, "subscriber", Name]).
"""


class Watching:
    """A running `rosarch watch` and the lines it prints."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process
        self.lines: queue.Queue[str] = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.put(line.rstrip("\n"))

    def until(self, pattern: str) -> list[str]:
        """The lines up to one that matches."""
        found = []
        while True:
            found.append(self.lines.get(timeout=120))
            if re.search(pattern, found[-1]):
                return found


@contextmanager
def watching(*arguments: str) -> Iterator[Watching]:
    command = [sys.executable, "-m", "rosarch.cli", "watch", *arguments]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    with subprocess.Popen(command, preexec_fn=_heed_interrupts, **pipes) as process:  # type: ignore[call-overload]
        try:
            yield Watching(process)
            process.send_signal(signal.SIGINT)
            process.wait(30)
        finally:
            process.kill()


def _heed_interrupts() -> None:
    """As on a terminal: what is started in the background may ignore them."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.slow
def test_rules_and_sources_are_saved(tmp_path: Path) -> None:
    """Rows come and go with the rules; an error is told and the next save mends it; a saved source is read again; Ctrl-C ends it."""
    robot = shutil.copytree(EXAMPLE, tmp_path / "robot")
    source = next(p for p in robot.rglob("*.cpp") if '"beacon"' in p.read_text())
    rules = tmp_path / "own.dl"
    rules.write_text(RULES)
    with watching(str(robot), str(rules), "--component", "docking") as seen:
        first = seen.until(r"\d+ rows?$")
        assert first[:3] == ["named", "name", first[2]] and "beacon" in first

        rules.write_text(RULES + 'named("own").\n')
        changed = seen.until("^[+-] ")
        assert re.fullmatch(r"\d\d:\d\d:\d\d  \S*own\.dl  1 relation derived again, \d+\.\d\d s", changed[0])
        assert changed[1:] == [f"named  {len(first) - 3} rows", "+ own"]

        rules.write_text(RULES + "named(X) :- prt(X).\n")
        assert seen.until("unknown relation")[-1].endswith("own.dl:4:13: unknown relation `prt`, did you mean `port`?")

        rules.write_text(RULES)
        assert seen.until("^[+-] ")[-1] == "- own"

        source.write_text(source.read_text().replace('"beacon"', '"light"'))
        changed = seen.until("^- ")
        assert changed[-2:] == ["+ light", "- beacon"]
    assert (seen.process.returncode, list(seen.lines.queue)) == (0, [])


@pytest.mark.slow
def test_input_that_is_wrong_from_the_start(tmp_path: Path, capsys: object) -> None:
    """What is wrong at the start is refused as by every command."""
    rules = tmp_path / "own.dl"
    rules.write_text("named(X) :- port(X).\n")
    assert main(["watch", str(EXAMPLE), str(rules)]) == 2
    assert "unknown relation `named`" in capsys.readouterr().err  # type: ignore[attr-defined]
    assert main(["watch", str(EXAMPLE), str(tmp_path / "none.dl")]) == 2
    assert "none.dl: no such file or folder" in capsys.readouterr().err  # type: ignore[attr-defined]
    rules.write_text(RULES)
    assert main(["watch", str(EXAMPLE), str(rules), "--relation", "prt"]) == 2
    assert "--relation prt: no such relation, did you mean port?" in capsys.readouterr().err.replace("`", "")  # type: ignore[attr-defined]
