"""Questions about systems: `can NAME of NODE cause NAME of NODE`, `must ...`, `rate of TOPIC`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rosarch.base.hints import hint
from rosarch.datalog import Result

Port = tuple[Any, ...]
"""A row of the type NodePort: node, port of the model, parameter."""


class QuestionError(Exception):
    """A question that cannot be understood or is about something that is not there; the text is one line that says what."""


@dataclass(frozen=True)
class PortName:
    """A port: its name, as resolved or as the code has it, and its node; without one, all ports of that name are meant."""

    name: str
    node: str | None

    def __str__(self) -> str:
        return f"{self.name} of {self.node}" if self.node else self.name

    def rows(self) -> set[tuple[str, str]]:
        """What it may be called in full, and its node, "" for any."""
        nodes = {self.node, _absolute(self.node)} if self.node else {""}
        return {(name, node) for name in (self.name, _absolute(self.name)) for node in nodes}


@dataclass(frozen=True)
class Causes:
    """Whether what passes through `source` has an influence on what passes through `target`, `always` or at all."""

    source: PortName
    target: PortName
    always: bool


@dataclass(frozen=True)
class Rate:
    """How often something is sent on `topic`."""

    topic: str


class _Words:
    """The words of a question, taken one by one."""

    def __init__(self, text: str) -> None:
        self._words = [(match.group(), match.start() + 1) for match in re.finditer(r"[^\s?]+", text)]
        self._end = len(text.rstrip(" ?")) + 1

    def next(self) -> str | None:
        """The next word, which is not taken; None at the end."""
        return self._words[0][0] if self._words else None

    def take(self, *expected: str) -> str:
        """The next word, which must be one of these, if any are given."""
        word, column = self._words[0] if self._words else (None, self._end)
        if word is None or (expected and word not in expected):
            wanted = " or ".join(f"`{each}`" for each in expected) or "a name"
            told = "the end" if word is None else f"`{word}`"
            raise QuestionError(f"question:1:{column}: expected {wanted}, not {told}{hint(word, expected) if word and expected else ''}")
        self._words.pop(0)
        return word

    def end(self) -> None:
        """Nothing must be left."""
        if self._words:
            word, column = self._words[0]
            raise QuestionError(f"question:1:{column}: expected the end, not `{word}`")


def parse_question(text: str) -> Causes | Rate:
    """What is asked.

    Raises:
        QuestionError: it is no question; the message says where.
    """
    words = _Words(text)
    asked: Causes | Rate
    word = words.take("can", "must", "rate")
    if word == "rate":
        words.take("of")
        asked = Rate(words.take())
    else:
        source = _port(words)
        words.take("cause")
        asked = Causes(source, _port(words), word == "must")
    words.end()
    return asked


def _port(words: _Words) -> PortName:
    name = words.take()
    if words.next() != "of":
        return PortName(name, None)
    words.take("of")
    return PortName(name, words.take())


def find_ports(name: PortName, result: Result) -> list[Port]:
    """The ports of a system that a name means.

    Raises:
        QuestionError: there is no such node or port; the message names the nearest.
    """
    nodes: Mapping[Port, str] = dict(result.rows("port_node"))
    names = {port: {resolved, written} for port, resolved, written in _named(result)}
    if name.node is not None:
        own = {port for port, node in nodes.items() if _same(name.node, node)}
        if not own:
            known = set(nodes.values())
            raise QuestionError(f"no node `{name.node}` with ports{hint(_absolute(name.node), known)}")
        names = {port: found for port, found in names.items() if port in own}
    found = [port for port, known in names.items() if any(_same(name.name, each) for each in known)]
    if not found:
        known = {each for both in names.values() for each in both if not each.startswith("?")}
        whose = f"`{_absolute(name.node)}` has no port" if name.node else "there is no port"
        raise QuestionError(f"{whose} `{name.name}`{hint(name.name, known) or hint(_absolute(name.name), known)}")
    return sorted(found, key=repr)


def _named(result: Result) -> Iterable[tuple[Port, str, str]]:
    resolved: dict[Port, str] = dict(result.rows("port_name"))
    for node, model, parameter, written in result.rows("port_written"):
        port = (node, model, parameter)
        yield port, resolved.get(port) or written, written


def _absolute(name: str) -> str:
    return name if name.startswith(("/", "~")) else f"/{name}"


def _same(asked: str, name: str) -> bool:
    return asked == name or _absolute(asked) == name


def find_topic(topic: str, topics: Sequence[str]) -> str:
    """The topic of a system that is meant.

    Raises:
        QuestionError: there is none; the message names the nearest.
    """
    for known in topics:
        if _same(topic, known):
            return known
    raise QuestionError(f"there is no topic `{topic}`{hint(_absolute(topic), topics)}")
