"""What `--ros-args` of a command line say, and what rcl rejects of it: a node that is given that ends at its start.

Source: rcl (arguments.c, lexer.c); `benchmarks/rcl_table.jsonl` has what it says of each form.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rosarch.extractor.launch.model import LaunchError, Place, Remap
from rosarch.extractor.launch_ros2.context import Given
from rosarch.extractor.launch_ros2.params_files import refused_value
from rosarch.extractor.launch_ros2.rcl_values import read

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

_WORD = r"(?!\w*__)[A-Za-z_]\w*"
_NAME = rf"(?:~?/)?{_WORD}(?:/{_WORD})*"
_RULE = re.compile(
    rf"(?:{_WORD}:)?(?:__(?:node|name):={_WORD}|__ns:=/(?:{_WORD}(?:/{_WORD})*)?|(?:ros(?:topic|service)://)?{_NAME}:={_NAME})", re.ASCII
)
_PART = r"(?!__)[A-Za-z_]\w*"
_ASSIGNED = re.compile(rf"(?:{_WORD}:)?/?{_PART}(?:[./]{_PART})*:=(?P<value>.+)", re.ASCII | re.DOTALL)


@dataclass
class RosArguments:
    """What is behind `--ros-args`; `plain` are the other words. Each namespace is for the node of a name, or for all ("")."""

    plain: list[str] = field(default_factory=list)
    remaps: list[Remap] = field(default_factory=list)
    params: list[Given] = field(default_factory=list)
    name: str | None = None
    namespaces: list[tuple[str, str]] = field(default_factory=list)

    def namespace(self, name: str | None) -> str | None:
        """The namespace of the node that is called so: of several the first."""
        return next((namespace for node, namespace in self.namespaces if not node or node == name), None)


def ros_arguments(world: World, words: list[str]) -> RosArguments:
    """The arguments of a command line."""
    found = RosArguments()
    rest, inside = list(words), False
    while rest:
        word = rest.pop(0)
        if word in ("--ros-args", "--"):
            inside = word == "--ros-args"
        elif not inside:
            found.plain.append(word)
        elif word in ("-r", "--remap") and rest:
            _remap(world, rest.pop(0), found)
        elif word in ("-p", "--param") and rest:
            _param(world, rest.pop(0), found)
        elif word == "--params-file" and rest:
            found.params.append(Given(rest.pop(0), world.state.here))
    return found


def prefixed(source: str) -> tuple[str, str]:
    """The node that a rule is for ("" for all) and what it changes there."""
    node, colon, rest = source.partition(":")
    return (node, rest) if colon and not rest.startswith("//") and "/" not in node else ("", source)


def require_rule(world: World, source: str, target: str, place: Place) -> None:
    """Report a remapping rule that rcl rejects, if all of it is known."""
    rule = f"{source}:={target}"
    if not world.state.unknowns.is_open(rule) and not _RULE.fullmatch(rule):
        world.state.report(LaunchError("ros-argument", rule, f"`{rule}` is no remapping rule"), fatal=False, place=place)


def _remap(world: World, rule: str, found: RosArguments) -> None:
    given, _, target = rule.partition(":=")
    node, source = prefixed(given)
    if source == "__ns":
        found.namespaces.append((node, target))
    if node or source not in ("__node", "__name", "__ns"):
        found.remaps.append(
            Remap(given, target, world.state.here)
        )  # of several nodes of a process, it may be for one that only its code names
        return
    require_rule(world, given, target, world.state.here)
    if source != "__ns":
        found.name = found.name or target


def _param(world: World, text: str, found: RosArguments) -> None:
    source, _, value = text.partition(":=")
    node, name = prefixed(source)
    if not world.state.unknowns.is_open(text):
        form = _ASSIGNED.fullmatch(text)
        reason = refused_value(form["value"]) if form else "it is no NAME:=VALUE"
        if reason is not None:
            world.state.report(LaunchError("ros-argument", text, f"the parameter `{text}`: {reason}"), fatal=False)
            return  # the node does not start; launch goes on
    found.params.append(Given(read(value), world.state.here, name=name, node=f"/{node}" if node else None))
