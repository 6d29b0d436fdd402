"""From the part of a system that matters to guarded commands: the reactions of its nodes, its queues, and what may come from outside."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from rosarch.behavior.composition.components import Component
from rosarch.behavior.composition.cone import Cone, Event
from rosarch.behavior.composition.held import Held
from rosarch.behavior.composition.inputs import Inputs
from rosarch.behavior.composition.model import Command, Model, Queue, Variable
from rosarch.behavior.composition.reactions import Effect, cases_of, effects
from rosarch.behavior.composition.system import ENVIRONMENT, End, System, Topic
from rosarch.models.guards import CANCEL
from rosarch.models.machine.elapsed import LONG
from rosarch.models.machine.logic import BOOLEAN, Subject, from_cases
from rosarch.models.machine.parts import continuation, short
from rosarch.models.machine.reactions import is_ambiguous
from rosarch.models.machine.steps import Step
from rosarch.models.machine.switching import OFF, START

BOUND = 2
_ACTIVITIES = {"timer": "a timer that runs once"}
_OWN = ("timer", "thread", "main", "lifecycle")  # what a node does by itself, though it is not known when


@dataclass
class _Builder:
    system: System
    cone: Cone
    inputs: Inputs
    bound: int
    fair: bool
    held: Held
    variables: list[Variable] = field(default_factory=list)
    queues: list[Queue] = field(default_factory=list)
    queue_of: dict[End, int] = field(default_factory=dict)
    kept_of: dict[End, int] = field(default_factory=dict)
    obligations: list[int | str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    found: dict[End, list[Effect]] = field(default_factory=dict)


def model_of(system: System, cone: Cone, inputs: Inputs, *, bound: int = BOUND, fair: bool = True) -> Model:
    """The guarded commands of the part of a system in the cone; queues of more than `bound` messages are open.

    When it has to be `fair`, what has to get its turn again and again is counted.
    """
    builder = _Builder(system, cone, inputs, bound, fair, Held(system, cone))
    for node, key in sorted(cone.variables):
        variable = system.nodes[node].variables[key]
        initial = inputs.first_values(node, variable)
        text = f"{node.lstrip('/')}.{variable.text}"
        builder.variables.append(Variable((node, key), text, variable.values, initial))
    for end in cone.steps:
        _queue(builder, end)
    builder.held.find(builder.queue_of, lambda topic, subject: inputs.content(topic, subject) is not None)
    for end in cone.steps:
        builder.found[end] = _effects(builder, end)
    for end in cone.steps:
        _hold(builder, end)
    commands = [_started(builder, end, command) for end in cone.steps for command in _reaction(builder, end)]
    commands += _time_passes(builder)
    commands += _lost(builder)
    stages = [entry for entry in inputs.stages() if _reaches(builder, entry.topic)]
    commands += _from_outside(builder, [entry.topic for entry in stages])
    events = tuple(sorted(cone.watched.events))
    doubts = tuple(dict.fromkeys(_doubts(system, cone)))
    return Model(
        system.name,
        tuple(builder.variables),
        tuple(builder.queues),
        tuple(commands),
        tuple(builder.obligations),
        events,
        len(stages),
        tuple(dict.fromkeys([*builder.notes, *doubts])),
        doubts,
    )


def _doubts(system: System, cone: Cone) -> Iterator[str]:
    """What nodes may do that reactions which are atomic, in one order, do not."""
    for node, key in sorted(cone.variables):
        if key in system.nodes[node].disturbed:
            yield f"callbacks of {node} that may run at the same time change {system.nodes[node].variables[key].text}"
        if key in system.nodes[node].multiplied:
            yield f"several objects of {node} may have or change {system.nodes[node].variables[key].text}"
    nodes = sorted({node for node, _ in (*cone.variables, *cone.steps)})
    for node in nodes:
        yield from (f"{node}: {text}" for text in system.nodes[node].unfollowed)
    for node in (node for node in nodes if node in system.conditions):
        yield f"{node} is started only if {system.conditions[node]}"
    for (node, _), steps in cone.steps.items():
        if not system.nodes[node].shared.isdisjoint(port for step in steps for port in step.outputs):
            yield f"several objects of {node} may send, each for itself"
        if is_ambiguous(steps, system.nodes[node].document):
            yield f"{node} calls a function, or asks for a value, several times in one reaction, so that what it does is not known"


def _reaches(builder: _Builder, topic: str) -> bool:
    return topic in builder.system.topics and any(end in builder.cone.steps for end in builder.system.topics[topic].receivers)


def _queue(builder: _Builder, end: End) -> None:
    """The queue in front of a callback, unless its messages may come at any time and nobody looks at when they were sent."""
    node, port = end
    topic = builder.system.inlet(end)
    component = builder.system.nodes[node]
    if port in component.answered:
        _extra(builder, builder.queue_of, end, "answers")
        _oblige(builder, builder.queue_of[end])
    if component.together.get(port):
        _extra(builder, builder.kept_of, end, "messages kept")
    if topic is None or not _is_queued(builder, topic):
        return
    declared = builder.system.nodes[node].queues.get(port)
    size = declared if topic.kind == "topic" else None
    is_open = not size or size > builder.bound
    if is_open:
        builder.notes.append(f"the queue of {node} for {topic.name} is counted up to {builder.bound}")
    builder.queue_of[end] = len(builder.queues)
    length = builder.bound if is_open or size is None else size
    builder.queues.append(Queue(node, topic.name, length, is_open, component.is_prompt(port)))
    _oblige(builder, builder.queue_of[end])


def _effects(builder: _Builder, end: End) -> list[Effect]:
    """The ways in which a reaction may go; what is distinguished of the message that it takes is a variable."""
    node, _ = end
    component, steps = builder.system.nodes[node], builder.cone.steps[end]
    keys = {key for other, key in builder.cone.variables if other == node} | {subject.key for subject in builder.held.read.get(end, ())}
    shared = dict(_content_of_inputs(builder, builder.system.inlet(end), steps))
    fields = {key: component.fields[key] for other, key in builder.cone.fields if other == node}
    return effects(steps, keys, lambda subject: shared.get(subject, subject.values), fields)


def _hold(builder: _Builder, end: End) -> None:
    """Note what the messages in the queue of a reader may hold."""
    if not builder.held.read.get(end):
        return
    index = builder.queue_of[end]
    if texts := builder.held.noted(end, index, builder.found):
        builder.queues[index] = replace(builder.queues[index], contents=texts)
    else:
        builder.found[end] = _effects(builder, end)


def _extra(builder: _Builder, known: dict[End, int], end: End, what: str) -> None:
    """A queue for what waits for a node beside messages: one stands for any number."""
    known[end] = len(builder.queues)
    builder.queues.append(Queue(end[0], f"{what} of {end[1]}", 1, True))


def _is_queued(builder: _Builder, topic: Topic) -> bool:
    if topic.senders or builder.inputs.mentions(topic.name):
        return True
    if builder.fair and any(map(builder.system.is_uncertain, topic.outside)):
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
    due = loop or queue is not None or trigger in (*_OWN, START)
    obligation = _oblige(builder, f"{node} {trigger}" if queue is None else queue) if due else None
    others = [builder.kept_of[node, other] for other in sorted(component.together.get(trigger, ())) if (node, other) in builder.kept_of]
    keys = {key for other, key in builder.cone.variables if other == node}
    read = {subject.key: subject for subject in builder.held.read.get(end, ())}
    idle = topic is not None and any(event.kind in ("received", "ignored") for event in _events_at(builder, end, topic))
    for effect, cases in _grouped(builder.found[end], component, keys, read):
        if not (effect.after or effect.sent or queue is not None or obligation is not None or idle):
            continue
        inputs, assumes = _taken_for_granted(builder, component, trigger, effect, topic)
        events = frozenset(_events(builder, end, topic, effect))
        if effect.after or effect.sent or queue is not None or events:  # else it is the same when it does not run
            assumes += _runs_if(builder, end)
        command = Command(
            actor=node,
            cause=_cause(component, trigger, topic),
            when=(),
            given=tuple((_index(builder, node, key), value) for key, value in effect.after.items()),
            takes=queue,
            full=tuple(others),
            events=events,
            obligation=obligation,
            clock=f"{component.label(trigger)} of {node}" if loop and component.rates[trigger] else "",
            inputs=inputs,
            assumes=assumes,
            places=tuple(dict.fromkeys(row.at for row in effect.rows if row.at)),
        )
        command = _answering(
            builder, end, _sending(builder, command, [t for port in effect.sent for t in builder.system.outlet((node, port))])
        )
        command = replace(_asking(builder, command, effect.sent), given_contents=builder.held.put(node, effect, builder.queue_of))
        for case in cases:
            when = tuple((_index(builder, node, key), values) for key, values in sorted(case.items()) if key not in read)
            for variant in _taking(builder, end, command, {key: values for key, values in case.items() if key in read}):
                yield from _by_length(builder, replace(variant, when=when))
            if lost := _unconnected(builder, end, effect.sent).intersection(command.puts):
                alone = f"nobody is connected to {node} when it starts"
                left = tuple(queue for queue in command.puts if queue not in lost)
                yield replace(command, when=when, puts=left, full_events=(), assumes=(*command.assumes, alone))
    yield from _nothing_done(builder, end, obligation)


def _taking(builder: _Builder, end: End, command: Command, case: Case) -> Iterator[Command]:
    """The command, which takes messages that hold what is known to be so, and the ones that take those of which it is not known."""
    if command.takes is None or command.takes not in builder.held.contents:
        yield command
        return
    for taken, open_ in builder.held.cases(end, command.takes, case):
        assumes = tuple(_condition_text(subject, case[subject.key]) for subject in open_)
        yield replace(command, taken=taken, assumes=(*command.assumes, *assumes))


def _time_passes(builder: _Builder) -> Iterator[Command]:
    """Times get as long as they are compared with, sooner or later."""
    for node, key in sorted(builder.cone.variables):
        if key in builder.system.nodes[node].measured:
            text = builder.system.nodes[node].variables[key].text
            obligation = _oblige(builder, f"{node} {key}")
            yield Command(node, f"waits: {text} gets long", (), given=((_index(builder, node, key), LONG),), obligation=obligation)


def _lost(builder: _Builder) -> Iterator[Command]:
    """What waits is lost where more comes than a queue holds: what comes next may be one of those that came later."""
    for index, contents in builder.held.contents.items():
        queue = builder.queues[index]
        for content in range(len(contents)) if queue.open else ():
            full = f"the queue of {queue.node} for {queue.topic} is full"
            yield Command(queue.node, f"loses {queue.topic}", (), drops=index, full=(index,), kept_content=content, assumes=(full,))


def _unconnected(builder: _Builder, end: End, sent: Sequence[str]) -> set[int]:
    """The queues that need not get what a node sends at its start, as their nodes may not be connected yet."""
    node, trigger = end
    ports = [port for port in sent if port not in builder.system.nodes[node].latched] if trigger == START else []
    ends = [other for port in ports for topic in builder.system.outlet((node, port)) for other in topic.receivers]
    return {builder.queue_of[other] for other in ends if other in builder.queue_of}


def _started(builder: _Builder, end: End, command: Command) -> Command:
    """The command, which has to wait until the node has started, unless threads of its own may not."""
    node, trigger = end
    component = builder.system.nodes[node]
    if trigger == START or (node, START) not in builder.cone.variables or "thread" in component.steps:
        return command
    return replace(command, when=(*command.when, (_index(builder, node, START), frozenset({OFF}))))


def _runs_if(builder: _Builder, end: End) -> tuple[str, ...]:
    """What has to be so for a trigger to run when it may, of which nothing is known."""
    node, trigger = end
    component = builder.system.nodes[node]
    if trigger in component.rates:
        reason = component.unsteady.get(trigger)
        return (f"{component.label(trigger)} of {node} runs then ({reason})",) if reason else ()
    if trigger in component.answered and not builder.system.is_answered(end):
        return (f"what {node} asked through {trigger} is answered then",)
    if component.together.get(trigger):
        return (f"messages that {node} waits for together belong together",)
    if trigger in component.unheard:
        return (f"{node} takes what arrives ({component.unheard[trigger]})",)
    if builder.system.inlet(end) or trigger in component.queues or trigger == START:
        return ()
    if _runs_when_set(component, trigger):
        return ()
    if waited := continuation(trigger):
        return (f"what {node} awaits at {short(waited[1])} has come then",)
    return (f"{_ACTIVITIES.get(trigger, f'`{trigger}`')} of {node} runs then",)


def _runs_when_set(component: Component, trigger: str) -> bool:
    """Whether a trigger is that of timers that run once, of which it is known when they do."""
    return trigger == "timer" and component.runs_once_when_set


def _nothing_done(builder: _Builder, end: End, obligation: int | None) -> Iterator[Command]:
    """Other ways in which what has its turn may end: nothing is done, for a reason that is assumed."""
    node, trigger = end
    component, topic, queue = builder.system.nodes[node], builder.system.inlet(end), builder.queue_of.get(end)
    cause = _cause(component, trigger, topic)
    if topic and (trigger in component.filtered or component.together.get(trigger)):
        held = f"{component.filtered.get(trigger, 'a filter')} of {node} holds {topic.name} back"
        kept = (builder.kept_of[end],) if end in builder.kept_of else ()
        received = frozenset(event for event in _events_at(builder, end, topic) if event.kind == "received")
        command = Command(node, cause, (), takes=queue, puts=kept, events=received, obligation=obligation, assumes=(held,))
        if queue is not None or kept:
            yield from _by_length(builder, command)
    if queue is not None and trigger in component.unheard:
        lost = f"{node} does not take {builder.queues[queue].topic} then ({component.unheard[trigger]})"
        yield from _by_length(builder, Command(node, cause, (), takes=queue, obligation=obligation, assumes=(lost,)))
    if obligation is not None and trigger in component.unsteady:
        rests = f"{component.label(trigger)} of {node} does not run then ({component.unsteady[trigger]})"
        yield Command(node, cause, (), obligation=obligation, assumes=(rests,))
    if obligation is not None and trigger in _OWN and not _runs_when_set(component, trigger):
        rests = f"{_ACTIVITIES.get(trigger, f'`{trigger}`')} of {node} does not run then"
        yield Command(node, cause, (), obligation=obligation, assumes=(rests,))
    if trigger in component.answered and not builder.system.is_answered(end):
        yield Command(
            node, cause, (), takes=queue, obligation=obligation, assumes=(f"what {node} asked through {trigger} is not answered",)
        )


def _asking(builder: _Builder, command: Command, sent: Sequence[str]) -> Command:
    """The command that also has clients wait for answers: those of which it is not known who alone gives them."""
    clients = [(command.actor, port) for port in sent if not builder.system.servers((command.actor, port))]
    waiting = tuple(builder.queue_of[end] for end in clients if end in builder.queue_of)
    return replace(command, puts=(*command.puts, *waiting)) if waiting else command


def _answering(builder: _Builder, server: End, command: Command) -> Command:
    """The command that also answers the client that alone asks a server."""
    topic = builder.system.inlet(server)
    clients = [end for end in topic.senders if server in builder.system.servers(end)] if topic else []
    waiting = tuple(builder.queue_of[end] for end in clients if end in builder.queue_of)
    return replace(command, puts=(*command.puts, *waiting)) if waiting else command


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
            kept = replace(one, keeps=True, full=(*one.full, one.takes), assumes=(*one.assumes, more))
            if one.takes not in builder.held.contents:
                yield kept
            for content in range(len(builder.held.contents.get(one.takes, ()))):
                yield from (replace(kept, kept_content=content, settles=settles) for settles in (False, True))


def _index(builder: _Builder, node: str, key: str) -> int:
    return next(index for index, variable in enumerate(builder.variables) if variable.key == (node, key))


def _content_of_inputs(builder: _Builder, topic: Topic | None, steps: Iterable[Step]) -> Iterator[tuple[Subject, tuple[str, ...]]]:
    """What the inputs say about the content of messages on a topic."""
    if topic is None:
        return
    for step in steps:
        for subject in step.tested():
            if not subject.cell and (value := builder.inputs.content(topic.name, subject)) is not None:
                yield subject, (value,)


Case = Mapping[str, frozenset[str]]


def _grouped(
    found: Sequence[Effect], component: Component, keys: Iterable[str], read: Mapping[str, Subject]
) -> Iterator[tuple[Effect, list[Case]]]:  # fmt: skip
    """The effects that differ, each with the values of variables it needs; what takes least for granted comes first.

    `read` is what is distinguished of the message that is taken.
    """
    subjects = {key: Subject(key, key, component.variables[key].values, True) for key in keys} | dict(read)
    best: dict[object, Effect] = {}
    for effect in sorted(found, key=lambda effect: len(effect.choices)):
        key = (frozenset(effect.before.items()), frozenset(effect.after.items()), effect.sent, bool(effect.rows), effect.contents)
        best.setdefault(key, effect)
    groups: dict[object, list[Effect]] = {}
    for effect in best.values():
        choices = frozenset(effect.choices.items())
        known = (frozenset(effect.after.items()), effect.sent, bool(effect.rows), choices, effect.contents)
        groups.setdefault(known, []).append(effect)
    for members in groups.values():
        cases = [{subjects[key]: frozenset({value}) for key, value in effect.before.items()} for effect in members]
        yield members[0], [{subject.key: values for subject, values in case.items()} for case in cases_of(from_cases(cases))]


def _taken_for_granted(
    builder: _Builder, component: Component, trigger: str, effect: Effect, topic: Topic | None
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What an effect needs to be so: of the content of messages from outside, and of anything else."""
    inputs: list[str] = []
    assumes: list[str] = []
    for subject, values in effect.choices.items():
        text = _condition_text(subject, values)
        told = component.is_content(trigger, subject.text) and any(component.is_in_type(trigger, value) for value in values)
        a_goal = subject.text == CANCEL and BOOLEAN[0] not in values  # anybody may give one; only a goal that is followed can be cancelled
        from_outside = topic is not None and not topic.senders and (told or a_goal)
        if not (topic and builder.inputs.content(topic.name, subject) is not None):
            (inputs if from_outside and not subject.hidden else assumes).append(text)
    assumes += [f"{component.variables[key].text} is {value} then" for key, value in effect.before.items() if key in component.measured]
    return tuple(inputs), tuple(assumes)


def _condition_text(subject: Subject, values: frozenset[str]) -> str:
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
    inlets = {queue.topic for queue in builder.queues if queue.topic in builder.system.topics} | {
        event.topic for event in builder.cone.watched.events if event.kind == "sent"
    }
    for name in sorted(inlets):
        topic = builder.system.topics[name]
        again = builder.inputs.again(name)
        senders = (ENVIRONMENT,) if builder.inputs.mentions(name) else topic.outside
        for sender in senders if again or builder.inputs.may_come(name) else ():
            known = builder.system.is_uncertain(sender)
            assumes = (f"{sender} sends {name} then",) if known else ()
            obligation = _oblige(builder, f"scenario {name}") if again else _oblige(builder, f"{sender} {name}") if known else None
            if known and not again and obligation is not None:
                yield Command(sender, f"sends {name}", (), obligation=obligation, assumes=(f"{sender} does not send {name} then",))
            command = Command(sender, f"sends {name}", (), assumes=assumes, obligation=obligation)
            yield from _by_length(builder, _sending(builder, command, [topic]))
    for stage, name in enumerate(stages):
        command = Command(ENVIRONMENT, f"sends {name}", (), obligation=_oblige(builder, "scenario"), stage=stage)
        yield from _by_length(builder, _sending(builder, command, [builder.system.topics[name]]))
