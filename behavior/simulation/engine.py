"""Runs a composed system in simulated time: nodes that do one thing after another, queues in front of them, what comes from outside.

A node reacts as its state machine has it. What a reaction changes and sends takes effect when its execution time is over.
"""

from __future__ import annotations

import random
from collections import Counter, deque
from collections.abc import Generator, Mapping
from dataclasses import dataclass, field
from functools import partial
from itertools import count

import simpy

from rosarch.behavior.composition.components import Component, content_path
from rosarch.behavior.composition.contents import as_read
from rosarch.behavior.composition.inputs import Entry
from rosarch.behavior.composition.reactions import Effect, react
from rosarch.behavior.composition.scenario import Scenario, Span
from rosarch.behavior.composition.system import ENVIRONMENT, End, System
from rosarch.behavior.simulation.records import Event, Record
from rosarch.models.machine.cells import value_in
from rosarch.models.machine.conditions import spaced
from rosarch.models.machine.limits import NO_NUMBER
from rosarch.models.machine.logic import BOOLEAN, Subject

Waits = Generator[simpy.Event, object, None]
MOST_EVENTS = 1_000_000
DEFAULT_EXECUTION = 0.001  # seconds
_INSTANT = 1e-9  # seconds, by which sums of times are inexact
_MOST_LOTS = 50
_NOTHING = Effect({}, {}, {}, (), ())


class TooManyEventsError(Exception):
    """More happens than is worth while to simulate."""


@dataclass(frozen=True)
class Message:
    """A message on its way; `origins` are the topics and times of what it comes from, `fields` what is known about its contents.

    `names` are the numbers and texts that names stand for where it was sent; None for one from outside.
    """

    topic: str
    origins: Mapping[str, float]
    fields: Mapping[str, str] = field(default_factory=dict)
    names: Mapping[str, str] | None = None


@dataclass
class _Node:
    """A node at work.

    What waits for it, by port; whose turn it is, in their order, and what has arrived and gets its turn when a loop serves it; what it
    last received through each port, which ports have something for the next set of messages, and when it last sent through a port.
    """

    name: str
    component: Component
    values: dict[str, str]
    waiting: dict[str, deque[Message]]
    turns: deque[str] = field(default_factory=deque)
    arrived: list[str] = field(default_factory=list)
    latest: dict[str, Message] = field(default_factory=dict)
    gathered: set[str] = field(default_factory=set)
    sent: dict[str, float] = field(default_factory=dict)
    wake: simpy.Event | None = None


def simulate(system: System, scenario: Scenario, *, seed: int, duration: float) -> Record:
    """What happens in so many seconds; the same for the same seed.

    Raises:
        TooManyEventsError: there is no end to it.
    """
    run = _Run(system, scenario, seed, duration)
    run.environment.run(until=duration)
    return run.record


class _Run:
    def __init__(self, system: System, scenario: Scenario, seed: int, duration: float) -> None:
        self.system = system
        self.scenario = scenario
        self.random = random.Random(seed)
        self.environment = simpy.Environment()
        self.record = Record(system.name, seed, duration)
        self.nodes = {name: self._node(name) for name in sorted(system.nodes)}
        for node in self.nodes.values():
            self.environment.process(self._work(node))
            for trigger in sorted(node.component.rates):
                self._start_loop(node, trigger)
        for entry in scenario.inputs.entries:
            self.environment.process(self._outside(entry))

    def _node(self, name: str) -> _Node:
        component = self.system.nodes[name]
        values = {}
        for key, variable in component.variables.items():
            choices = self.scenario.inputs.first_values(name, variable)
            values[key] = choices[0] if len(choices) == 1 else self.random.choice(choices)
            if len(choices) > 1:
                self.record.notes.append(f"{name} begins with {variable.text} {values[key]}, of {', '.join(choices)}: drawn by lot")
        ports = [port for topic in self.system.topics.values() for node, port in topic.receivers if node == name]
        return _Node(name, component, values, {port: deque() for port in ports})

    def _start_loop(self, node: _Node, trigger: str) -> None:
        if rate := self._rate(node, trigger):
            self.environment.process(self._loop(node, trigger, 1 / rate))
        else:
            self.record.notes.append(f"a loop of {node.name} does not run: its rate is not known; a scenario can tell it")

    def _loop(self, node: _Node, trigger: str, period: float) -> Waits:
        first = self.random.uniform(0, period)
        for number in count():
            yield self._until(first + number * period)
            if trigger not in node.turns:  # a loop that is late runs once
                if trigger == node.component.serving:
                    node.turns.extend(node.arrived)
                    node.arrived.clear()
                self._turn(node, trigger)

    def _outside(self, entry: Entry) -> Waits:
        for number in count() if entry.every else (0,):
            time = entry.start + number * (entry.every or 0)
            if entry.end is not None and time > entry.end:
                return
            yield self._until(time)
            self._record(Event(self.environment.now, "sent", ENVIRONMENT, entry.topic))
            self._deliver(Message(entry.topic, {entry.topic: self.environment.now}, entry.fields))

    def _until(self, time: float) -> simpy.Event:
        return self.environment.timeout(max(0.0, time - self.environment.now))

    def _polls(self, node: _Node) -> bool:
        """Whether messages wait for a loop."""
        trigger = node.component.serving
        return trigger is not None and bool(self._rate(node, trigger))

    def _rate(self, node: _Node, trigger: str) -> float | None:
        return node.component.rates[trigger] or self.scenario.rates.get(node.name)

    def _turn(self, node: _Node, trigger: str) -> None:
        node.turns.append(trigger)
        if node.wake is not None and not node.wake.triggered:
            node.wake.succeed()

    def _deliver(self, message: Message) -> None:
        """Put a message into the queues of all who receive it; the oldest gives way where one is full."""
        self.record.sent(message.topic, self.environment.now, message.origins)
        for name, port in self.system.topics[message.topic].receivers:
            node = self.nodes[name]
            queue, size = node.waiting[port], node.component.queues.get(port)
            if size and len(queue) >= size and self.system.topics[message.topic].kind == "topic":
                queue.popleft()
                self._record(Event(self.environment.now, "dropped", name, message.topic))
                self.record.dropped[name, message.topic] += 1
            elif self._polls(node):
                node.arrived.append(port)
            else:
                self._turn(node, port)
            queue.append(message)
            self.record.queued(name, message.topic, len(queue), self.environment.now)

    def _work(self, node: _Node) -> Waits:
        """Handle what waits, one after another."""
        while True:
            if not node.turns:
                node.wake = self.environment.event()
                yield node.wake
            trigger = node.turns.popleft()
            message = self._taken(node, trigger)
            effect = self._reaction(node, trigger, message) if self._complete(node, trigger) else _NOTHING
            start = self.environment.now
            seconds = self._duration(node.name, message.topic if message else "") + node.component.asleep.get(trigger, 0.0)
            if seconds:
                yield self.environment.timeout(seconds)
            self._finish(node, trigger, message, effect, start)

    def _complete(self, node: _Node, trigger: str) -> bool:
        """Whether what arrived completes a set of messages that are passed together, or needs no others."""
        others = node.component.together.get(trigger)
        if not others:
            return True
        node.gathered.add(trigger)
        if not others <= node.gathered:
            return False
        node.gathered -= others | {trigger}
        return True

    def _reaction(self, node: _Node, trigger: str, message: Message | None) -> Effect:
        """What comes of it; where time since the last message decides, the lots that are drawn are those that agree with it."""
        steps, choose = node.component.steps.get(trigger, ()), partial(self._chosen, node, message)
        if trigger not in node.component.gaps:
            return react(steps, node.values, choose, node.component.fields)
        port, gap = node.component.gaps[trigger]
        due = self.environment.now - node.sent.get(port, -gap) >= gap - _INSTANT
        guessed = self.record.guessed.copy()
        for _ in range(_MOST_LOTS):
            effect = react(steps, node.values, choose, node.component.fields)
            if (port in effect.sent) == due:
                self.record.guessed = guessed
                break
        return effect

    def _taken(self, node: _Node, trigger: str) -> Message | None:
        if trigger not in node.waiting:
            return None
        message = node.waiting[trigger].popleft()
        node.latest[trigger] = message
        self.record.queued(node.name, message.topic, len(node.waiting[trigger]), self.environment.now)
        self._record(Event(self.environment.now, "received", node.name, message.topic))
        return message

    def _duration(self, node: str, topic: str) -> float:
        given = self.scenario.execution
        span = given.get((node, topic)) or given.get((node, "")) or Span(DEFAULT_EXECUTION, DEFAULT_EXECUTION)
        return span.least if span.least == span.most else self.random.uniform(span.least, span.most)

    def _chosen(self, node: _Node, message: Message | None, subject: Subject) -> str:
        """What a condition finds that is not about variables: the content of the message, else by chance."""
        path = content_path(subject.text, node.component.members)
        known = message.fields.get(path, message.fields.get(path.removeprefix("request."))) if message and path else None
        if message and known is not None:
            values, names = subject.values, message.names
            value = value_in(known, values) if names is None else as_read(known, names, values, node.component.constants)
            if value is not None:
                return value
        chance = self.scenario.chances.get((node.name, spaced(subject.text)))
        if chance is not None and subject.values == BOOLEAN:
            return BOOLEAN[self.random.random() >= chance]
        self.record.guessed[node.name, subject.text] += 1
        return self.random.choice([value for value in subject.values if value != NO_NUMBER])

    def _finish(self, node: _Node, trigger: str, message: Message | None, effect: Effect, start: float) -> None:
        """What a reaction changes and sends."""
        now = self.environment.now
        self.record.ran(node.name, message.topic if message else node.component.label(trigger), start, now)
        for key, value in effect.after.items():
            if node.values[key] != value:
                text = node.component.variables[key].text
                self._record(Event(now, "changed", node.name, text, f"{node.values[key]} -> {value}"))
                node.values[key] = value
        if message:
            self.record.handled(node.name, now, message.origins)
        for port in effect.sent:
            node.sent[port] = start
            for topic in self.system.outlet((node.name, port)) * node.component.repeats.get((trigger, port), 1):
                self._record(Event(now, "sent", node.name, topic.name, ", ".join(f"{n}" for n, _ in topic.receivers)))
                fields = {path.removeprefix("request."): value for path, value in effect.content(port).items()}
                origins = self._origins(node, message, (node.name, port), topic.name)
                self._deliver(Message(topic.name, origins, fields, node.component.constants))

    def _origins(self, node: _Node, message: Message | None, end: End, topic: str) -> Mapping[str, float]:
        """What a message comes from: the one that is answered, or those kept since they came, else nothing but itself."""
        if message:
            return message.origins
        kept = [node.latest[port] for port in node.component.kept.get(end[1], ()) if port in node.latest]
        found: dict[str, float] = {}
        for other in kept:
            found |= other.origins
        return found or {topic: self.environment.now}

    def _record(self, event: Event) -> None:
        self.record.events.append(event)
        if len(self.record.events) > MOST_EVENTS:
            (subject, number), *_ = Counter(event.subject for event in self.record.events).most_common(1)
            raise TooManyEventsError(f"more than {MOST_EVENTS} events until {event.time:g} s, {number} of them about {subject}")
