"""Programs that Python launch files run themselves, and what they print. They are not run here."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.registry import native
from rosarch.extractor.launch_ros2.substitutions import printed_by
from rosarch.extractor.launch_ros2.values import NOTHING, Made, PathText, TextFile

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.calls import Calls

_AS_TEXT = ("text", "universal_newlines", "encoding")
"""Arguments that have the output decoded."""


@native("subprocess.run")
def _run(run: Calls, command: Any, *_more: Any, **named: Any) -> Any:
    printed = _output(run, command, *_more, **named)
    if printed is NOTHING:
        return NOTHING
    captured = named.get("capture_output") is True or "stdout" in named
    return Made("CompletedProcess", {"stdout": printed if captured else None, "returncode": 0}, run.world.state.here)


@native("subprocess.check_output")
def _output(run: Calls, command: Any, *_more: Any, **named: Any) -> Any:
    printed = _printed(run, command)
    if printed is NOTHING or any(named.get(name) not in (None, False) for name in _AS_TEXT):
        return printed
    return Made("Bytes", {"text": printed}, run.world.state.here)


@native("subprocess.getoutput")
def _getoutput(run: Calls, command: Any, **_named: Any) -> Any:
    printed = _printed(run, command)
    return printed if printed is NOTHING else printed.removesuffix("\n")


@native("os.popen")
def _popen(run: Calls, command: Any, *_more: Any, **_named: Any) -> Any:
    printed = _printed(run, command)
    return printed if printed is NOTHING else TextFile("", printed)


def decoded(_run: Calls, owner: Made, *_more: Any, **_named: Any) -> Any:
    """`bytes.decode()`."""
    return owner.arguments["text"] if owner.kind == "Bytes" else NOTHING


def _printed(run: Calls, command: Any) -> Any:
    words = _words(command)
    if not words:
        run.world.hand(command)
        return NOTHING
    try:
        printed = printed_by(run.world, words, words)
    except LaunchError as error:
        run.world.state.report_unread(error)
        return NOTHING
    return NOTHING if printed is None else printed


def _words(command: Any) -> list[str]:
    """The words of a command line, none where they are not all known."""
    if isinstance(command, str) and is_known(command):
        try:
            return shlex.split(command)
        except ValueError:
            return []
    words = [word.text if isinstance(word, PathText) else word for word in command] if isinstance(command, (list, tuple)) else []
    return words if all(isinstance(word, str) for word in words) else []
