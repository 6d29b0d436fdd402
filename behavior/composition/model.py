"""A composed system as guarded commands over variables with finitely many values: what checkers read, and traces are written in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rosarch.behavior.composition.cone import Event


@dataclass(frozen=True)
class Variable:
    """A variable of a node; `key` is what commands call it. It begins with one of `initial`."""

    key: tuple[str, str]
    text: str
    values: tuple[str, ...]
    initial: tuple[str, ...]


@dataclass(frozen=True)
class Queue:
    """The messages that wait for a node's callback, by number.

    A queue that is `open` is longer than `size`, and `size` stands for that many messages or more; else the oldest message is dropped
    from a full one. From a `prompt` one a message is taken as soon as it has come, as long as callbacks take no time. `contents` are what
    the messages may hold that nodes distinguish, where there is anything; the first one is what is not known.
    """

    node: str
    topic: str
    size: int
    open: bool
    prompt: bool = False
    contents: tuple[str, ...] = ()


@dataclass(frozen=True)
class Command:
    """Something that may happen when variables have these values (`when`) and there is a message in the queue `takes`.

    Then variables are `given` values, messages are put into queues, and `events` happen: those in `full_events` only when the queue
    that they are about is full. The queues in `full` have to be full. One that `takes` a message and `keeps` the queue full has one of
    those that wait beyond follow, with the content `kept_content`, and is the last to do so if it `settles` that. The message that it
    takes has one of the contents `taken`, by number, those that it puts have `given_contents`, by queue. One that `drops` takes no
    message, the oldest of an open queue is lost.
    `obligation` is the index of what has to happen again and again that this fulfils. `inputs` and `assumes` say what this takes for
    granted of messages from outside, and of anything else. `clock` is the timer or timed loop of known rate that sets it off. `cause` and
    `places` are for people.
    """

    actor: str
    cause: str
    when: tuple[tuple[int, frozenset[str]], ...]
    given: tuple[tuple[int, str], ...] = ()
    takes: int | None = None
    keeps: bool = False
    full: tuple[int, ...] = ()
    puts: tuple[int, ...] = ()
    events: frozenset[Event] = frozenset()
    full_events: tuple[tuple[Event, int], ...] = ()
    obligation: int | None = None
    sends: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    assumes: tuple[str, ...] = ()
    places: tuple[str, ...] = ()
    stage: int | None = None
    clock: str = ""
    taken: frozenset[int] | None = None
    given_contents: tuple[tuple[int, int], ...] = ()
    kept_content: int = 0
    settles: bool = False
    drops: int | None = None


@dataclass(frozen=True)
class Model:
    """Commands over variables and queues, which they refer to by index.

    `obligations` are the queues (by index) and the names of timed loops that get their turn again and again in a fair run. `stages` is the
    number of messages that a scenario sends one after another. `doubts` are ways of the system that the commands do not have.
    """

    name: str
    variables: tuple[Variable, ...]
    queues: tuple[Queue, ...]
    commands: tuple[Command, ...]
    obligations: tuple[int | str, ...]
    events: tuple[Event, ...]
    stages: int = 0
    notes: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()

    @property
    def index(self) -> Mapping[tuple[str, str], int]:
        """Where each variable is."""
        return {variable.key: index for index, variable in enumerate(self.variables)}

    @property
    def choices(self) -> tuple[int, ...]:
        """The variables whose first value is not given."""
        return tuple(index for index, variable in enumerate(self.variables) if len(variable.initial) > 1)
