"""What comes from outside, as far as it is given: which messages, with which content, and first values that the source does not give."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rosarch.behavior.composition.components import StateVariable, content_path
from rosarch.models.machine.cells import value_in
from rosarch.models.machine.logic import Subject


@dataclass(frozen=True)
class Entry:
    """Messages on a topic: one at `start`, or one every `every` seconds from `start` to `end`; `fields` is their content."""

    topic: str
    start: float
    every: float | None = None
    end: float | None = None
    fields: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Inputs:
    """What a scenario says; without one (`anything`) any message may come at any time.

    `values` are first values, by node and the text of a variable. In a scenario, `anything` lets topics that it does not name be free.
    """

    entries: tuple[Entry, ...] = ()
    values: Mapping[tuple[str, str], str] = field(default_factory=dict)
    anything: bool = True

    def mentions(self, topic: str) -> bool:
        """Whether it describes messages on a topic."""
        return any(entry.topic == topic for entry in self.entries)

    def may_come(self, topic: str) -> bool:
        """Whether messages from outside may come on a topic at any time."""
        return self.anything and not self.mentions(topic)

    def again(self, topic: str) -> bool:
        """Whether messages come on a topic again and again."""
        return any(entry.topic == topic and entry.every is not None for entry in self.entries)

    def stages(self) -> list[Entry]:
        """The messages that come once, in their order."""
        return sorted((entry for entry in self.entries if entry.every is None), key=lambda entry: entry.start)

    def first_values(self, node: str, variable: StateVariable) -> tuple[str, ...]:
        """The values that a variable may begin with: the one that it is said to, else those that the source gives."""
        value = value_in(self.values.get((node, variable.text)), variable.values)
        return variable.initial if value is None else (value,)

    def content(self, topic: str, subject: Subject) -> str | None:
        """The value of a field that all messages on a topic have, where conditions ask for it."""
        path = content_path(subject.text, ())
        values = {entry.fields.get(path or "") for entry in self.entries if entry.topic == topic}
        return value_in(values.pop(), subject.values) if len(values) == 1 else None
