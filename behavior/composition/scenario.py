"""Scenario files: what comes from outside, what is known about nodes beyond their source, and for simulation how long things take."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import yaml

from rosarch.base.plain_yaml import YamlError, YamlReader, compose
from rosarch.behavior.composition.inputs import Entry, Inputs
from rosarch.behavior.composition.names import Names, UnknownNameError
from rosarch.behavior.composition.system import System
from rosarch.models.machine.conditions import spaced


class ScenarioError(Exception):
    """Something is wrong with a scenario; a line `path:line:col: message` for each mistake."""


@dataclass(frozen=True)
class Span:
    """Seconds that something takes: between `least` and `most`."""

    least: float
    most: float


@dataclass(frozen=True)
class Scenario:
    """What a scenario file says.

    `execution` is how long reactions of a node take, by node and topic, or "" for those that are not named; `chances` how likely a
    condition of a node holds, by node and text; `rates` how often timed loops of a node run of which the source does not say it.
    """

    inputs: Inputs = field(default_factory=Inputs)
    execution: Mapping[tuple[str, str], Span] = field(default_factory=dict)
    chances: Mapping[tuple[str, str], float] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)


def read_scenario(text: str, path: str, system: System) -> Scenario:
    """The scenario in a text, for a system.

    Raises:
        ScenarioError: it is not plain YAML, asks for what the system does not have, or contradicts itself.
    """
    try:
        root = compose(text, path)
    except YamlError as error:
        raise ScenarioError(str(error)) from None
    reader = _Reader(path, system)
    known = {
        "inputs": reader.inputs, "other inputs": lambda node: reader.choice(node, ("any", "none")), "values": reader.values,
        "execution": reader.execution, "conditions": reader.chances, "rates": reader.rates,
    }  # fmt: skip
    found = dict(reader.known_keys(root, known, "section")) if root is not None else {}
    if reader.problems:
        raise ScenarioError("\n".join(reader.problems))
    inputs = Inputs(tuple(found.get("inputs", ())), found.get("values", {}), found.get("other inputs") == "any")
    return Scenario(inputs, found.get("execution", {}), found.get("conditions", {}), found.get("rates", {}))


class _Reader(YamlReader):
    """Reads a scenario; what is wrong is kept."""

    def __init__(self, path: str, system: System) -> None:
        super().__init__(path)
        self._system = system
        self._names = Names(system)

    def inputs(self, node: yaml.Node) -> list[Entry]:
        """Messages from outside."""
        return [entry for item in self.items(node) for entry in self._entries(item)]

    def _entries(self, node: yaml.Node) -> list[Entry]:
        known: dict[str, Callable[[yaml.Node], Any]] = {
            "topic": self._topic, "at": self._times, "every": lambda value: self._number(value, above=True), "from": self._number,
            "to": self._number, "fields": self._fields,
        }  # fmt: skip
        found = dict(self.known_keys(node, known, "key of an input"))
        if "topic" not in found:
            self.problem(node, "an input needs a `topic`")
        if ("at" in found) == ("every" in found):
            self.problem(node, "an input comes either `at` some times or `every` so many seconds")
        start, end = found.get("from") or 0.0, found.get("to")
        if end is not None and end < start:
            self.problem(node, f"an input cannot end at {end:g} s and begin at {start:g} s")
        if "at" in found and ("from" in found or "to" in found):
            self.problem(node, "`from` and `to` belong to `every`")
        topic, fields = found.get("topic"), found.get("fields") or {}
        if topic is None or self.problems:
            return []
        if "at" in found:
            return [Entry(topic, time, None, None, fields) for time in found["at"]]
        return [Entry(topic, start, found["every"], end, fields)]

    def values(self, node: yaml.Node) -> dict[tuple[str, str], str]:
        """First values of variables."""
        found = {}
        for key, value in self.pairs(node):
            text = self.text(value)
            try:
                name, variable = self._names.variable(key.value)
                if text is not None:
                    found[name, variable.text] = self._first(key.value, name, variable.text, text)
            except UnknownNameError as error:
                self.problem(value if error.of_value else key, str(error))
        return found

    def _first(self, called: str, node: str, text: str, value: str) -> str:
        known = self._names.value(called, value)
        variable = next(v for v in self._system.nodes[node].variables.values() if v.text == text)
        if known not in variable.initial:
            raise UnknownNameError(f"`{called}` begins as {' or '.join(variable.initial)}, says the source", of_value=True)
        return known

    def execution(self, node: yaml.Node) -> dict[tuple[str, str], Span]:
        """How long reactions take: seconds for all of a node, or for the messages of each topic."""
        found = {}
        for key, value in self.pairs(node):
            name = self._node(key)
            if isinstance(value, yaml.MappingNode):
                for topic, span in self.pairs(value):
                    called = "" if topic.value == "default" else self._topic(topic, received=False)
                    if called is not None and (read := self._span(span)):
                        found[name, called] = read
            elif read := self._span(value):
                found[name, ""] = read
        return found

    def chances(self, node: yaml.Node) -> dict[tuple[str, str], float]:
        """How likely conditions hold."""
        found = {}
        for key, value in self.pairs(node):
            name = self._node(key)
            for condition, chance in self.pairs(value):
                number = self._number(chance)
                if number is not None and number > 1:
                    self.problem(chance, f"a condition cannot hold more often than always, 1, but {number:g}")
                if number is not None:
                    found[name, spaced(condition.value)] = number
        return found

    def rates(self, node: yaml.Node) -> dict[str, float]:
        """How often timed loops run."""
        found = {}
        for key, value in self.pairs(node):
            name, number = self._node(key), self._number(value, above=True)
            if number is not None:
                found[name] = number
        return found

    def _node(self, key: yaml.ScalarNode) -> str:
        try:
            return self._names.node(key.value)
        except UnknownNameError as error:
            self.problem(key, str(error))
            return ""

    def _topic(self, node: yaml.Node, received: bool = True) -> str | None:
        text = self.text(node)
        try:
            name = None if text is None else self._names.topic(text)
        except UnknownNameError as error:
            self.problem(node, str(error))
            return None
        if name is not None and received and not self._system.topics[name].receivers:
            self.problem(node, f"nobody receives {name}")
        return name

    def _times(self, node: yaml.Node) -> list[float]:
        items = self.items(node) if isinstance(node, yaml.SequenceNode) else [node]
        return [number for item in items if (number := self._number(item)) is not None]

    def _span(self, node: yaml.Node) -> Span | None:
        times = self._times(node)
        if len(times) == 2 and times[0] > times[1]:
            self.problem(node, f"at least {times[0]:g} s and at most {times[1]:g} s")
        elif len(times) not in (1, 2):
            self.problem(node, "seconds are expected here, or the least and the most of them")
        return Span(times[0], times[-1]) if times else None

    def _fields(self, node: yaml.Node) -> dict[str, str]:
        return {key.value: text for key, value in self.pairs(node) if (text := self.text(value)) is not None}

    def _number(self, node: yaml.Node, above: bool = False) -> float | None:
        text = self.text(node)
        try:
            number = None if text is None else float(text)
        except ValueError:
            number = None
        if text is not None and (number is None or not 0 <= number < 1e9 or (above and number == 0)):
            self.problem(node, f"a number {'above 0' if above else 'from 0 on'} is expected here, not `{text}`")
            return None
        return number
