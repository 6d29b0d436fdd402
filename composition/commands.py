"""From the part of a system that matters to guarded commands: the reactions of its nodes, its queues, and what may come from outside."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from rosarch.composition.components import Component
from rosarch.composition.cone import Cone, Event
from rosarch.composition.inputs import Inputs, content_path
from rosarch.composition.model import Command, Model, Queue, Variable
from rosarch.composition.reactions import Effect, alternatives, effects
from rosarch.composition.system import ENVIRONMENT, End, System, Topic
from rosarch.models.machine.logic import BOOLEAN, Subject, from_cases
from rosarch.models.machine.reactions import Step

BOUND = 2
_ACTIVITIES = {"timer": "a timer that runs once"}


@dataclass
class _Builder:
    system: System
    cone: Cone
    inputs: Inputs
    bound: int
    fair: bool
    variables: list[Variable] = field(default_factory=list)
    queues: list[Queue] = field(default_factory=list)
    queue_of: dict[End, int] = field(default_factory=dict)
    obligations: list[int | str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def model_of(system: System, cone: Cone, inputs: Inputs, *, bound: int = BOUND, fair: bool = True) -> Model:
    """The guarded commands of the part of a system in the cone; queues of more than `bound` messages are open.

    When it has to be `fair`, what has to get its turn again and again is counted.
    """
    builder = _Builder(system, cone, inputs, bound, fair)
    for node, key in sorted(cone.variables):
        variable = system.nodes[node].variables[key]
        initial = inputs.first_values(node, variable)
        text = f"{node.lstrip('/')}.{variable.text}"
        builder.variables.append(Variable((node, key), text, variable.values, initial))
    for end in cone.steps:
        _queue(builder, end)
    commands = [command for end, steps in cone.steps.items() for command in _reaction(builder, end)]
    stages = [entry for entry in inputs.stages() if _reaches(builder, entry.topic)]
    commands += _from_outside(builder, [entry.topic for entry in stages])
    events = tuple(sorted(cone.watched.events))
    return Model(
        system.name,
        tuple(builder.variables),
        tuple(builder.queues),
        tuple(commands),
        tuple(builder.obligations),
        events,
        len(stages),
        tuple(dict.fromkeys(builder.notes)),
    )


def _reaches(builder: _Builder, topic: str) -> bool:
    return topic in builder.system.topics and any(end in builder.cone.steps for end in builder.system.topics[topic].receivers)


def _queue(builder: _Builder, end: End) -> None:
    """The queue in front of a callback, unless its messages may come at any time and nobody looks at when they were sent."""
    node, port = end
    topic = builder.system.inlet(end)
    if topic is None or not _is_queued(builder, topic):
        return
    declared = builder.system.nodes[node].queues.get(port)
    size = declared if topic.kind == "topic" else None
    is_open = not size or size > builder.bound
    if is_open:
        builder.notes.append(f"the queue of {node} for {topic.name} is counted up to {builder.bound}")
    builder.queue_of[end] = len(builder.queues)
    builder.queues.append(Queue(node, topic.name, builder.bound if is_open or size is None else size, is_open))
    _oblige(builder, builder.queue_of[end])


def _is_queued(builder: _Builder, topic: Topic) -> bool:
    if topic.senders or builder.inputs.mentions(topic.name):
        return True
    watched = any(event.topic == topic.name and event.kind in ("sent", "dropped") for event in builder.cone.watched.events)
    return bool(topic.outside) and (watched or sum(end in builder.cone.steps for end in topic.receivers) > 1)


def _oblige(builder: _Builder, what: int | str) -> int | None:
    if not builder.fair:
        return None
    if what not in builder.obligations:
        builder.obligations.append(what)
    return builder.obligations.index(what)


def _reaction(builder: _Builder, end: End) -> Iterator[Command]:
    """The commands for a trigger of a node."""
    node, trigger = end
    component, topic = builder.system.nodes[node], builder.system.inlet(end)
    queue = builder.queue_of.get(end)
    if topic and queue is None and not (topic.outside and builder.inputs.may_come(topic.name)):
        return
    loop = trigger in component.rates
    obligation = _oblige(builder, f"{node} {trigger}" if queue is None else queue) if loop or queue is not None else None
    assumed = () if topic or loop or trigger in component.queues else (f"{_ACTIVITIES.get(trigger, f'`{trigger}`')} of {node} runs then",)
    keys = {key for other, key in builder.cone.variables if other == node}
    shared = dict(_known(builder, topic, builder.cone.steps[end]))
    found = effects(builder.cone.steps[end], keys, lambda subject: shared.get(subject, subject.values))
    idle = topic is not None and any(event.kind in ("received", "ignored") for event in _events_at(builder, end, topic))
    for effect, cases in _grouped(found, component, keys):
        if not (effect.after or effect.sent or queue is not None or obligation is not None or idle):
            continue
        inputs, assumes = _taken_for_granted(builder, component, topic, effect)
        command = Command(
            actor=node,
            cause=_cause(component, trigger, topic),
            when=(),
            given=tuple((_index(builder, node, key), value) for key, value in effect.after.items()),
            takes=queue,
            events=frozenset(_events(builder, end, topic, effect)),
            obligation=obligation,
            inputs=inputs,
            assumes=assumes + assumed,
            places=tuple(dict.fromkeys(row.at for row in effect.rows)),
        )
        command = _sending(builder, command, [t for port in effect.sent for t in builder.system.outlet((node, port))])
        for case in cases:
            when = tuple((_index(builder, node, key), values) for key, values in sorted(case.items()))
            yield from _by_length(builder, replace(command, when=when))
    if topic and queue is not None and trigger in component.filtered:
        held = f"{component.filtered[trigger]} of {node} holds {topic.name} back"
        cause = _cause(component, trigger, topic)
        yield from _by_length(builder, Command(node, cause, (), takes=queue, obligation=obligation, assumes=(held,)))


def _by_length(builder: _Builder, command: Command) -> Iterator[Command]:
    """The command, and what else may come of it since open queues are not counted to their end: a taken message is not missed."""
    lost = [queue for _, queue in command.full_events if builder.queues[queue].open]
    plain = replace(command, full_events=tuple(item for item in command.full_events if item[1] not in lost))
    found = [plain]
    for queue in dict.fromkeys(lost):
        events = frozenset(event for event, other in command.full_events if other == queue)
        assumed = (*command.assumes, f"the queue of {builder.queues[queue].node} for {builder.queues[queue].topic} is full")
        found.append(replace(plain, full=(queue,), events=command.events | events, assumes=assumed))
    for one in found:
        yield one
        if one.takes is not None and builder.queues[one.takes].open:
            more = f"more than {builder.bound} messages on {builder.queues[one.takes].topic} wait"
            yield replace(one, keeps=True, full=(*one.full, one.takes), assumes=(*one.assumes, more))


def _index(builder: _Builder, node: str, key: str) -> int:
    return next(index for index, variable in enumerate(builder.variables) if variable.key == (node, key))


def _known(builder: _Builder, topic: Topic | None, steps: Iterable[Step]) -> Iterator[tuple[Subject, tuple[str, ...]]]:
    """What the inputs tell of the content of messages on a topic."""
    if topic is None:
        return
    for step in steps:
        for subject in step.tested():
            if not subject.cell and (value := builder.inputs.content(topic.name, subject)) is not None:
                yield subject, (value,)


Case = Mapping[str, frozenset[str]]


def _grouped(found: Sequence[Effect], component: Component, keys: Iterable[str]) -> Iterator[tuple[Effect, list[Case]]]:
    """The effects that differ, each with the values of variables it needs; what takes least for granted comes first."""
    subjects = {key: Subject(key, key, component.variables[key].values, True) for key in keys}
    best: dict[object, Effect] = {}
    for effect in sorted(found, key=lambda effect: len(effect.choices)):
        key = (frozenset(effect.before.items()), frozenset(effect.after.items()), effect.sent, bool(effect.rows))
        best.setdefault(key, effect)
    groups: dict[object, list[Effect]] = {}
    for effect in best.values():
        choices = frozenset(effect.choices.items())
        groups.setdefault((frozenset(effect.after.items()), effect.sent, bool(effect.rows), choices), []).append(effect)
    for members in groups.values():
        cases = [{subjects[key]: frozenset({value}) for key, value in effect.before.items()} for effect in members]
        yield members[0], [{subject.key: values for subject, values in case.items()} for case in alternatives(from_cases(cases))]


def _taken_for_granted(
    builder: _Builder, component: Component, topic: Topic | None, effect: Effect
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What an effect needs to be so: of the content of messages from outside, and of anything else."""
    inputs: list[str] = []
    assumes: list[str] = []
    for subject, values in effect.choices.items():
        text = _told(subject, values)
        from_outside = topic is not None and not topic.senders and content_path(subject.text, component.members) is not None
        if not (topic and builder.inputs.content(topic.name, subject) is not None):
            (inputs if from_outside and not subject.hidden else assumes).append(text)
    return tuple(inputs), tuple(assumes)


def _told(subject: Subject, values: frozenset[str]) -> str:
    if tuple(subject.values) != BOOLEAN:
        return f"{subject.text} is {' or '.join(value for value in subject.values if value in values)}"
    if values == {BOOLEAN[0]}:
        return subject.text
    return subject.negative or (f"!{subject.text}" if re.fullmatch(r"[\w.>:()-]+", subject.text) else f"!({subject.text})")


def _cause(component: Component, trigger: str, topic: Topic | None) -> str:
    if topic:
        return f"receives {topic.name}" if topic.kind == "topic" else f"serves {topic.name}"
    return component.label(trigger) if trigger in component.rates else f"runs {trigger}"


def _events_at(builder: _Builder, end: End, topic: Topic) -> Iterator[Event]:
    return (event for event in builder.cone.watched.events if (event.node, event.topic) == (end[0], topic.name))


def _events(builder: _Builder, end: End, topic: Topic | None, effect: Effect) -> Iterator[Event]:
    if topic:
        for event in _events_at(builder, end, topic):
            if event.kind == "received" or (event.kind == "ignored" and not effect.rows):
                yield event


def _sending(builder: _Builder, command: Command, topics: Sequence[Topic]) -> Command:
    """The command that also sends these messages."""
    events, full, puts = set(command.events), list(command.full_events), list(command.puts)
    for topic in dict.fromkeys(topics):
        for event in builder.cone.watched.events:
            if event.kind == "sent" and event.topic == topic.name and event.node in ("", command.actor):
                events.add(event)
        for end in topic.receivers:
            if (queue := builder.queue_of.get(end)) is not None:
                puts.append(queue)
                full += [(event, queue) for event in _events_at(builder, end, topic) if event.kind == "dropped" and queue != command.takes]
    return replace(
        command,
        events=frozenset(events),
        full_events=tuple(full),
        puts=tuple(puts),
        sends=(*command.sends, *(topic.name for topic in dict.fromkeys(topics))),
    )


def _from_outside(builder: _Builder, stages: Sequence[str]) -> Iterator[Command]:
    """Messages that come from nobody whose behaviour is known."""
    inlets = {queue.topic for queue in builder.queues} | {event.topic for event in builder.cone.watched.events if event.kind == "sent"}
    for name in sorted(inlets):
        topic = builder.system.topics[name]
        again = builder.inputs.again(name)
        senders = (ENVIRONMENT,) if builder.inputs.mentions(name) else topic.outside
        for sender in senders if again or builder.inputs.may_come(name) else ():
            assumes = (f"{sender} sends {name} then",) if sender in builder.system.nodes else ()
            obligation = _oblige(builder, f"scenario {name}") if again else None
            command = Command(sender, f"sends {name}", (), assumes=assumes, obligation=obligation)
            yield from _by_length(builder, _sending(builder, command, [topic]))
    for stage, name in enumerate(stages):
        command = Command(ENVIRONMENT, f"sends {name}", (), obligation=_oblige(builder, "scenario"), stage=stage)
        yield from _by_length(builder, _sending(builder, command, [builder.system.topics[name]]))
