"""Definitions as text to messages, line by line, so that one bad line costs one field.

Sources: https://wiki.ros.org/msg, https://wiki.ros.org/srv, https://wiki.ros.org/actionlib; bounds, defaults and `wstring` from
https://docs.ros.org/en/humble/Concepts/Basic/About-Interfaces.html. The `rosbags` parser is not used here: it gives no positions,
rejects a whole file for one line and knows no lower-case constants, which ROS 1 allows. Tests compare both.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.messages.model import PRIMITIVES, UNBOUNDED, Action, Constant, Field, Message, Service

_LINE = re.compile(
    r"\s*(?P<type>[A-Za-z][\w/]*)(?:<=\d+)?(?:\[\s*(?P<size>(?:<=\s*)?(?:\d{1,9})?)\s*\])?\s+(?P<name>[A-Za-z_]\w*)\s*(?P<rest>=.*|\S.*)?$"
)


def parse_fields(
    lines: Iterable[tuple[int, str]], package: str, path: Path, problems: list[Diagnostic]
) -> tuple[tuple[Field, ...], tuple[Constant, ...]]:
    """Fields and constants of numbered lines."""
    fields: list[Field] = []
    constants: list[Constant] = []
    for number, line in lines:
        code = line.partition("#")[0].rstrip()
        if not code.strip() or code.lstrip().startswith("@"):
            continue
        match = _LINE.match(code)
        if not match:
            column = len(code) - len(code.lstrip()) + 1
            problems.append(Diagnostic("message-syntax", path, number, column, f"not a field: `{code.strip()}`"))
            continue
        kind, name, rest = match["type"], match["name"], (match["rest"] or "").strip()
        if rest.startswith("="):
            value = line.partition("=")[2].strip() if kind in ("string", "wstring") else rest[1:].strip()
            constants.append(Constant(name, kind, value))
            continue
        size = match["size"]
        array = None if size is None else UNBOUNDED if not size or size.startswith("<=") else int(size)
        fields.append(Field(name, full_type(kind, package), array, rest or None, line=number, column=match.start("type") + 1))
    return tuple(fields), tuple(constants)


def full_type(name: str, package: str) -> str:
    """A field's type with its package; `Header` alone is `std_msgs/Header`."""
    if name in PRIMITIVES:
        return name
    if name == "Header":
        return "std_msgs/Header"
    if "/" in name:
        return name.replace("/msg/", "/")
    return f"{package}/{name}"


def _numbered(text: str) -> list[list[tuple[int, str]]]:
    """The parts between `---` lines."""
    parts: list[list[tuple[int, str]]] = [[]]
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("---"):
            parts.append([])
        else:
            parts[-1].append((number, line))
    return parts


def parse_message(text: str, name: str, path: Path, problems: list[Diagnostic]) -> Message:
    """A `.msg` file's message called `name` (`pkg/Name`)."""
    lines = list(enumerate(text.splitlines(), 1))
    fields, constants = parse_fields(lines, name.partition("/")[0], path, problems)
    return Message(name, fields, constants, path)


def parse_service(text: str, name: str, path: Path, problems: list[Diagnostic]) -> tuple[Service, list[Message]]:
    """A `.srv` file: the service, its request and response."""
    parts = _parts(text, 2, path, problems)
    package = name.partition("/")[0]
    messages = []
    for role, lines in zip(("Request", "Response"), parts, strict=True):
        fields, constants = parse_fields(lines, package, path, problems)
        messages.append(Message(name + role, fields, constants, path, role.lower(), name))
    return Service(name, path), messages


def _parts(text: str, count: int, path: Path, problems: list[Diagnostic]) -> list[list[tuple[int, str]]]:
    parts = _numbered(text)
    if len(parts) != count:
        message = f"{count - 1} `---` expected, {len(parts) - 1} found"
        problems.append(Diagnostic("message-syntax", path, 1, 1, message))
    return (parts + [[]] * count)[:count]


def parse_action(text: str, name: str, path: Path, problems: list[Diagnostic]) -> tuple[Action, list[Message]]:
    """An `.action` file: the action and the seven messages actionlib derives from it."""
    package = name.partition("/")[0]
    messages: list[Message] = []
    for role, lines in zip(("Goal", "Result", "Feedback"), _parts(text, 3, path, problems), strict=True):
        fields, constants = parse_fields(lines, package, path, problems)
        messages.append(Message(name + role, fields, constants, path, role.lower(), name))
    header = Field("header", "std_msgs/Header")
    status = Field("status", "actionlib_msgs/GoalStatus")
    wrappers = {
        "ActionGoal": (header, Field("goal_id", "actionlib_msgs/GoalID"), Field("goal", f"{name}Goal")),
        "ActionResult": (header, status, Field("result", f"{name}Result")),
        "ActionFeedback": (header, status, Field("feedback", f"{name}Feedback")),
        "Action": tuple(Field(f"action_{part.lower()}", f"{name}Action{part}") for part in ("Goal", "Result", "Feedback")),
    }
    roles = {"ActionGoal": "action_goal", "ActionResult": "action_result", "ActionFeedback": "action_feedback", "Action": "action"}
    messages += [Message(name + suffix, fields, (), path, roles[suffix], name) for suffix, fields in wrappers.items()]
    return Action(name, path), messages
