"""A component as it takes part in a composition: its variables with finitely many values, and the steps of its reactions."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from rosarch.behavior.composition.contents import fields_of, is_content, numbers_of, with_contents
from rosarch.models.machine.cells import Cell, Document, value_in
from rosarch.models.machine.counting import whole
from rosarch.models.machine.elapsed import with_elapsed
from rosarch.models.machine.limits import NO_NUMBER, is_beyond
from rosarch.models.machine.logic import BOOLEAN, OTHER, Is, Subject
from rosarch.models.machine.parts import in_turn
from rosarch.models.machine.reactions import PERIODIC, component_steps, loop_trigger, names_of_messages
from rosarch.models.machine.steps import Step
from rosarch.models.machine.switching import START, gated, gates, starting
from rosarch.models.rhythm import runnable_document, runnable_domains

_INTEGER = re.compile(r"std_msgs/(?:(?P<signed>Int)|UInt|Byte|Bool|Char)(?P<bits>8|16|32|64|)")
_FIELD = re.compile(r"\(?\*?(?P<message>\w+)\)?(?:->|\.)(?P<path>[\w.>\[\]-]+)")


def content_path(text: str, members: Collection[str]) -> str | None:
    """The field that an operand such as `msg->header.seq` is about; None when it begins with a member of the component."""
    match = _FIELD.fullmatch(text.strip())
    return match["path"].replace("->", ".") if match and match["message"] not in members else None


@dataclass(frozen=True)
class StateVariable:
    """A variable that reactions test or assign; `initial` are the values it may begin with."""

    key: str
    text: str
    values: tuple[str, ...]
    initial: tuple[str, ...]


_AT_ONCE = (None, "plain", "lambda", "bind", "call", "image_transport")
"""The ways to a callback on which nothing holds messages back."""


@dataclass(frozen=True)
class Component:
    """What a node of this component can do.

    `steps` are those of each trigger, a port or an activity; `rates` those of the triggers that come again and again, None where unknown.
    `serving` is the trigger of the loop that handles messages, when they are not handled at once.
    `outlets` are the ports that some step sends through, `queues` the sizes of those of subscribers, `left_out` the state variables
    without finitely many values. Of times that are `measured` it is not known how fast they pass. `fields` are those of sent messages, as
    variables of one reaction, with what they are before they are given a value.
    """

    document: Document
    variables: Mapping[str, StateVariable]
    steps: Mapping[str, tuple[Step, ...]]
    rates: Mapping[str, float | None]
    outlets: frozenset[str]
    queues: Mapping[str, int | None]
    left_out: tuple[str, ...]
    serving: str | None = None
    measured: frozenset[str] = frozenset()
    fields: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def constants(self) -> Mapping[str, str]:
        """The numbers and texts that names stand for."""
        return numbers_of(self.document)

    def fields_sent(self, port: str, path: str) -> frozenset[str]:
        """The variables that a field of what goes through a port is."""
        messages = {message for steps in self.steps.values() for step in steps for name, message in step.messages if name == port}
        fields = (item for message in messages for item in fields_of(message, self.fields).items())
        return frozenset(key for name, key in fields if name.removeprefix("request.") == path)

    @cached_property
    def with_times(self) -> Component:
        """The component where the times since moments that variables keep are variables themselves, the `measured` ones."""
        steps, cells = with_elapsed(self.document, self.steps)
        if not cells:
            return self
        variables = {key: StateVariable(key, cell.subject.text, cell.subject.values, cell.initial) for key, cell in cells.items()}
        changed = {trigger: tuple(own) for trigger, own in steps.items()}
        return replace(self, steps=changed, variables={**self.variables, **variables}, measured=frozenset(cells))

    @cached_property
    def filtered(self) -> Mapping[str, str]:
        """The ports of subscribers whose messages come by way of something that may hold them back, and what that is."""
        ports = (port for port in self.document.get("ports") or () if port.get("kind") == "subscriber")
        return {str(port["id"]): str(port["via"]) for port in ports if port.get("via") not in _AT_ONCE}

    def timed(self, rates: Mapping[str, float], serving: Sequence[str]) -> Component:
        """The component with the rates that loops at these places have in a node, one of which may be `serving` messages."""
        found = dict(self.rates)
        for trigger in found:
            told = {hz for place, hz in rates.items() if trigger.partition(" ")[2] in ("", place)}
            found[trigger] = told.pop() if len(told) == 1 else found[trigger]
        own = next((place for place in serving if place in rates), None)
        if own is None:
            return replace(self, rates=found)
        trigger = next((trigger for trigger in found if trigger.partition(" ")[2] in ("", own)), loop_trigger(own))
        return replace(self, rates={trigger: rates[own], **found}, serving=trigger)

    def is_content(self, trigger: str, text: str) -> bool:
        """Whether an operand is a field of the message that a trigger is; where the model does not say, of something that is no member."""
        match = _FIELD.fullmatch(text.strip())
        if match is None or match["message"] in self.members:
            return False
        return self.document.get("traits") is None or match["message"] in names_of_messages(self.document, [trigger])

    def paths_read(self, trigger: str, step: Step) -> Mapping[Subject, str]:
        """The fields of the message that a trigger is which a step depends on, by path."""
        found = {subject: content_path(subject.text, self.members) for subject in step.tested() if not (subject.cell or subject.hidden)}
        known = {subject: path for subject, path in found.items() if path and self.is_content(trigger, subject.text)}
        return {subject: path.removeprefix("request.") for subject, path in known.items()}

    def is_in_type(self, trigger: str, value: str) -> bool:
        """Whether the only field of the message that a trigger is may be such a number."""
        types = {str(port["id"]): str(port.get("type")) for port in self.document.get("ports") or ()}
        match = _INTEGER.fullmatch(types.get(trigger, "").replace("/msg/", "/"))
        if value == NO_NUMBER or match is None:
            return value != NO_NUMBER
        bits, signed = int(match["bits"] or 8), bool(match["signed"])
        return not is_beyond(value, -(2.0 ** (bits - 1)) if signed else 0, 2.0 ** (bits - signed) - 1)

    @cached_property
    def together(self) -> Mapping[str, frozenset[str]]:
        """For each port whose messages are passed together with those of others, these."""
        found: dict[str, frozenset[str]] = {}
        for one, other in self._traits("synchronised"):
            found[one] = found.get(one, frozenset()) | {other}
        return found

    @cached_property
    def repeats(self) -> Mapping[tuple[str, str], int]:
        """How many messages go through a port (the second) each time that a trigger makes the component send there, where it is certain."""
        most = {(input_, port): text for input_, port, text in self._traits("answers_most")}
        least = {(input_, port): text for input_, port, text in self._traits("answers_least")}
        for place, port, text in self._traits("round_sends"):
            most |= {(trigger, port): text for trigger in self.rates if trigger.partition(" ")[2] in ("", place)}
        for place, port, text in self._traits("round_least"):
            least |= {(trigger, port): text for trigger in self.rates if trigger.partition(" ")[2] in ("", place)}
        return {ends: int(text) for ends, text in most.items() if text.isdecimal() and least.get(ends) == text}

    @cached_property
    def asleep(self) -> Mapping[str, float]:
        """For how many seconds what arrives at a port makes its callback sleep."""
        return {port: seconds for port, *amount in self._traits("sleeps_for_each") if (seconds := _seconds(*amount)) is not None}

    @cached_property
    def gaps(self) -> Mapping[str, tuple[str, float]]:
        """For each port whose messages are let through some seconds after the last one: where it sends then, and the seconds."""
        found = {input_: (port, _seconds(*amount)) for input_, port, *amount in self._traits("least_gap")}
        return {input_: (port, seconds) for input_, (port, seconds) in found.items() if seconds is not None}

    @cached_property
    def unsteady(self) -> Mapping[str, str]:
        """The triggers of timers and timed loops that need not run as long as the node does, each with a reason."""
        found: dict[str, str] = {}
        switched = {(gate.at, reason) for gate in gates(self.document) for reason in gate.reasons}
        for place, reason in self._traits("unsteady"):
            for trigger in self.rates:
                if trigger.partition(" ")[2] in ("", place) and (place, reason) not in switched:
                    found.setdefault(trigger, reason)
        return found

    @cached_property
    def runs_once_when_set(self) -> bool:
        """Whether the only timer that runs once runs when it has been set off, and then alone."""
        once = [gate for gate in gates(self.document) if gate.once]
        return len(once) == 1 and all(once[0].open in step.guard for step in self.steps.get("timer", ()))

    @cached_property
    def unheard(self) -> Mapping[str, str]:
        """The ports whose messages may never be taken, each with a reason; that callbacks wait for each other only makes queues longer."""
        waits = {reason for (reason,) in self._traits("held_up")}
        return {port: reason for port, reason in self._traits("unheard") if reason not in waits}

    def is_prompt(self, port: str) -> bool:
        """Whether nothing that was seen keeps the node from taking what arrives at once."""
        held = port in self.filtered or self.together.get(port) or self.serving or self._traits("held_up")
        return not held and all(other != port for other, _ in self._traits("unheard"))

    @cached_property
    def answered(self) -> frozenset[str]:
        """The triggers that are clients: what runs when something answers their requests."""
        kinds = {str(port["id"]): port.get("kind") for port in self.document.get("ports") or ()}
        return frozenset(trigger for trigger in self.steps if kinds.get(trigger) in ("service_client", "action_client"))

    @cached_property
    def answering(self) -> frozenset[str]:
        """The servers whose callbacks end and have answered then, whatever happens."""
        return frozenset(port for (port,) in self._traits("answers_surely") if port not in self.unheard)

    @cached_property
    def unfollowed(self) -> tuple[str, ...]:
        """What the component does at some time and may do anything to it, as texts."""
        waits = (f"a timer or thread lets others run at {place} before it continues" for (place,) in self._traits("gives_way_otherwise"))
        called = (f"a method of {name} is called at {place} whose name is not known" for place, name in self._traits("runs_any_method"))
        return (*waits, *called)

    @cached_property
    def disturbed(self) -> frozenset[str]:
        """The variables that callbacks which may run at the same time change or test without a lock."""
        names = {name for name, *_ in self._traits("changed_at_once")}
        return frozenset(key for key in self.variables if any(key == name or key.startswith(f"{name}.") for name in names))

    @cached_property
    def multiplied(self) -> frozenset[str]:
        """The variables that several objects may have, each its own, or change, which are one here, as is what changes them."""
        names = {name for trait in ("of_several_objects", "changed_by_several") for (name,) in self._traits(trait)}
        return frozenset(key for key in self.variables if any(key == name or key.startswith(f"{name}.") for name in names))

    @cached_property
    def shared(self) -> frozenset[str]:
        """The ports through which several objects may send, each for itself, which are one here."""
        return frozenset(port for (port,) in self._traits("sent_by_several"))

    @cached_property
    def latched(self) -> frozenset[str]:
        """The ports whose last message is kept for who connects later."""
        return frozenset(str(port["id"]) for port in self.document.get("ports") or () if port.get("latched"))

    @cached_property
    def sending(self) -> frozenset[str]:
        """The ports that something sends through of which the document has no row."""
        return frozenset(port for (port,) in self._traits("sent_by_itself"))

    @cached_property
    def silent(self) -> frozenset[str]:
        """The ports that nothing is ever sent through."""
        return frozenset(port for (port,) in self._traits("sends_nothing"))

    def _traits(self, name: str) -> list[tuple[str, ...]]:
        """What the rules say of the component for the sake of systems, in the order of the rules."""
        return [tuple(map(str, row)) for row in (self.document.get("traits") or {}).get(name, ())]

    @cached_property
    def kept(self) -> Mapping[str, tuple[str, ...]]:
        """For each port that a loop sends through, those whose messages it makes this of."""
        found: dict[str, tuple[str, ...]] = {}
        for row in self.document.get("reactive_deferred") or ():
            found[row["output"]] = (*found.get(row["output"], ()), row["input"])
        return found

    def label(self, trigger: str) -> str:
        """What people call a trigger that is no message."""
        if trigger.split(" ")[0] != PERIODIC:
            return trigger
        rate = self.rates.get(trigger)
        return f"{rate:g} Hz loop" if rate else "timed loop"

    @cached_property
    def members(self) -> frozenset[str]:
        """The last names of all variables that the document knows."""
        return frozenset(row["name"].rsplit("::", 1)[-1] for row in _variables(self.document))


def _seconds(amount: str, per_second: str) -> float | None:
    """A time in seconds; None when it is no number."""
    try:
        return float(amount) / float(per_second)
    except (ValueError, ZeroDivisionError):
        return None


LIFECYCLE = "lifecycle"
"""What triggers transitions of a managed node's life."""

Settings = Mapping[str, tuple[str, str]]
"""What the parameters of a node are: by the name that its component has for each, the kind and the text of its value."""


def component(document: Document, settings: Settings | None = None, asked: Collection[str] = ()) -> Component:
    """The component that a document in the format of `rosarch analyze -o` describes, as it is with these settings.

    `asked` are the names of the fields of messages that somebody reads.
    """
    document = with_contents(document, asked)
    told = settings or {}
    known = {name: told[parameter] for name, parameter in _by_parameters(document, "keeps_value_of") if parameter in told}
    numbers = {name: number for name, (_, text) in known.items() if (number := whole(text)) is not None}
    document = runnable_document(document, numbers)
    domains = runnable_domains(document)
    steps = {trigger: tuple(own) for trigger, own in component_steps(document, domains).items()}
    variables: dict[str, StateVariable] = {}
    fields = {key: cell.subject.values[-1] for key, cell in domains.cells.items() if is_content(key)}
    read = {row["name"] for row in document.get("state_variables") or () if row.get("from_param")}
    given = {name: told.get(parameter) for name, parameter in _by_parameters(document, "begins_with_value_of")}
    for key, cell in domains.cells.items():
        if key in fields:
            continue
        value = _set(given.get(cell.variable), cell.subject.values)
        initial = ((value,) if value else cell.subject.values) if cell.variable in read else cell.initial
        variables[key] = StateVariable(key, cell.subject.text, cell.subject.values, initial)
    steps, waiting = in_turn(steps)
    variables |= {cell.variable: _variable(cell) for cell in waiting}
    variables |= {
        gate.cell.subject.key: StateVariable(gate.cell.subject.key, gate.text, gate.cell.subject.values, gate.cell.initial)
        for gate in gates(document)
    }
    steps = _lived(document, steps)
    if begun := starting(document):
        cell, own = begun
        variables[cell.variable] = _variable(cell)
        steps[START] = tuple(part for step in own for part in gated([step], START, gates(document), document))
    variables |= _settings(document, (subject for own in steps.values() for step in own for subject in step.tested()), known)
    return Component(
        document,
        variables,
        steps,
        {trigger: _rate(trigger, document) for trigger in steps if trigger.split(" ")[0] == PERIODIC},
        frozenset(port for own in steps.values() for step in own for port in step.outputs),
        {str(port["id"]): port.get("queue") for port in document.get("ports") or ()},
        tuple(name for name in domains.left_out() if not is_content(name)),
        fields=fields,
    )


def _variable(cell: Cell) -> StateVariable:
    """A variable that is no variable of the source."""
    return StateVariable(cell.variable, cell.subject.text, cell.subject.values, cell.initial)


def _lived(document: Document, steps: Mapping[str, tuple[Step, ...]]) -> dict[str, tuple[Step, ...]]:
    """The steps, where those in transitions of a managed node hang on which is asked for: by a request, unless the node asks itself."""
    own = steps.get(LIFECYCLE)
    if own is None:
        return dict(steps)
    names: dict[str, set[str]] = {}
    for place, name in document.get("in_transition") or ():
        names.setdefault(place, set()).add(name)
    values = (*sorted(set().union(*names.values())), OTHER)
    asked = Subject("transition asked for", "the transition asked for", values)
    lived = []
    for step in own:
        told = frozenset().union(*(names.get(place, ()) for place in step.row.at.split()))
        lived.append(step.within(Is(asked, told)) if told else step)
    requests = [
        str(port["id"])
        for port in document.get("ports") or ()
        if port.get("implicit") and port.get("kind") == "service_server" and str(port.get("name")).endswith("~change_state")
    ]
    moved = (document.get("traits") or {}).get("moves_managed")
    trigger = requests[0] if len(requests) == 1 and not moved and requests[0] not in steps else LIFECYCLE
    return {**{name: found for name, found in steps.items() if name != LIFECYCLE}, trigger: tuple(lived)}


def _variables(document: Document) -> list[Mapping[str, str]]:
    return [*(document.get("state_variables") or ()), *(document.get("configuration") or ())]


def _by_parameters(document: Document, trait: str) -> list[tuple[str, str]]:
    """What has the value of a parameter, as a trait says, with the parameter."""
    return [(str(name), str(parameter)) for name, parameter in (document.get("traits") or {}).get(trait, ())]


def _settings(document: Document, tested: Iterable[Subject], known: Settings) -> dict[str, StateVariable]:
    """What conditions test of the configuration: a value that never changes, which the source or the parameter of the node gives."""
    rows: dict[str, Mapping[str, Any]] = {name: {"from_param": parameter} for name, parameter in _by_parameters(document, "keeps_value_of")}
    rows |= {row["name"].rsplit("::", 1)[-1]: row for row in document.get("configuration") or ()}
    found = {}
    for subject in tested:
        name = subject.key.removeprefix("self.")
        row = rows.get(name)
        if row is not None and not subject.cell:
            value = _set(known.get(name), subject.values) if row.get("from_param") else value_in(row.get("initial"), subject.values)
            initial = subject.values if value is None else (value,)
            found[subject.key] = StateVariable(subject.key, subject.text, subject.values, initial)
    return found


def _set(setting: tuple[str, str] | None, values: Sequence[str]) -> str | None:
    """The one of `values` that a parameter is set to; None where that is not known."""
    kind, text = setting or ("", "")
    if tuple(values) == BOOLEAN:
        return text.lower() if kind in ("bool", "default") and text.lower() in BOOLEAN else None
    if kind in ("string", "default") and any(value[:1] in "\"'" for value in values):
        return next((value for value in values if value[:1] in "\"'" and value[1:-1] == text), OTHER if OTHER in values else None)
    return None


def _rate(trigger: str, document: Document) -> float | None:
    """How often a timed loop or timer runs; None when that is not known, or differs among those that are shown as one."""
    place = trigger.partition(" ")[2]
    rates = {row.get("hz") for row in document.get("periodic") or () if not place or str(row.get("at")) == place}
    (rate,) = rates if len(rates) == 1 else (None,)
    return rate
