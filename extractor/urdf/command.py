"""What a call of the xacro program prints.

A launch file does not say which release of xacro it is for. The one that its command line fits best is tried first; the next when that one
rejects the file, or leaves tags in it that are an older xacro's.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.names import mapping
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf.model import IN_ORDER, NOETIC, TRADITIONAL, Dialect, Expansion
from rosarch.extractor.urdf.xacro import expand

_PROGRAMS: dict[str, tuple[Dialect, ...]] = {"xacro": (NOETIC, TRADITIONAL, IN_ORDER), "xacro.py": (TRADITIONAL, IN_ORDER, NOETIC)}
_OPTIONS: dict[str, tuple[Dialect, ...]] = {
    **dict.fromkeys(("--inorder", "-i", "--check-order"), (NOETIC, IN_ORDER)),
    "--oldorder": (TRADITIONAL,),
    "--xacro-ns": (NOETIC,),
}
_SILENT = frozenset({"-q", "-v", "-vv", "-vvv"})


@dataclass(frozen=True)
class XacroCall:
    """A command line of xacro. `program` is a path, or a name to be looked up."""

    program: str
    file: str
    arguments: Mapping[str, str]
    dialects: Sequence[Dialect]


def xacro_call(words: Sequence[str]) -> XacroCall | None:
    """The call that `words` make; None when they call another program, or with options that make it print something else."""
    program, rest = words[0], list(words[1:])
    if program == "ros2" and rest[:1] == ["run"]:
        program, rest = "rosrun", rest[1:]
    if program == "rosrun" and len(rest) > 1:
        program, rest = rest[1], rest[2:]
    dialects = _PROGRAMS.get(program.rpartition("/")[2])
    if dialects is None:
        return None
    arguments: dict[str, str] = {}
    files = []
    while rest:
        word = rest.pop(0)
        if ":=" in word:
            arguments.update(filter(None, (mapping(word),)))
        elif word in _OPTIONS:
            dialects = _OPTIONS[word]
        elif word == "--verbosity" and rest:
            rest.pop(0)
        elif word.startswith("-") and word not in _SILENT and not word.startswith("--verbosity="):
            return None
        elif not word.startswith("-"):
            files.append(word)
    return XacroCall(program, files[0], arguments, dialects) if len(files) == 1 else None


def run(call: XacroCall, files: Files, environment: Mapping[str, str], unknowns: Unknowns, *, installed: bool = False) -> Expansion:
    """What xacro makes of the file that `call` names."""
    tried = []
    for dialect in call.dialects:
        expansion = expand(
            call.file, call.arguments, files=files, environment=environment, unknowns=unknowns, dialect=dialect, installed=installed
        )
        if expansion.document is not None and not expansion.bare_tags:
            return expansion
        tried.append(expansion)
    return next((expansion for expansion in tried if expansion.document is not None), tried[0])
