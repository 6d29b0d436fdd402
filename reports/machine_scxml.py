"""State machines as SCXML, which interpreters run: <https://www.w3.org/TR/scxml/>.

Regions are children of a `<parallel>`. A trigger is an event `in.<name>`, a port that is sent to gets an event `out.<name>`. What a
condition asks of an input is a field of the event's data; conditions on the node's own variables are `In(...)`. A variable whose first
value the source does not give waits in `<variable>.undetermined` for an event `init.<variable>.<value>`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import product
from xml.sax.saxutils import quoteattr

from rosarch.base.logic import FALSE, TRUE, All, Any, Not
from rosarch.models.machine.build import StateMachine, Transition
from rosarch.models.machine.conditions import NULL, number
from rosarch.models.machine.logic import BOOLEAN, OTHER, Formula, Is, Subject, conjunction, negation, subjects
from rosarch.models.machine.steps import Output
from rosarch.reports.machine_labels import region_title, state_text, title

NAMESPACE = "http://www.w3.org/2005/07/scxml"
_FLAGS = {"true": "on", "false": "off"}  # some interpreters take `true` for the literal inside `In('x.true')` as well
_MOST_SPLITS = 4  # outputs of a transition whose conditions ask for the state of other regions


class _Names:
    """Identifiers of one kind: readable, legal in XML, distinct."""

    def __init__(self) -> None:
        self._names: dict[object, str] = {}
        self._used: set[str] = set()

    def of(self, key: object, text: str) -> str:
        """The identifier of `key`, made from `text` when it is first asked for."""
        if key not in self._names:
            stem = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_") or "x"
            stem = f"_{stem}" if stem[0].isdigit() else stem
            number_ = 1
            while (name := stem if number_ == 1 else f"{stem}_{number_}") in self._used:
                number_ += 1
            self._used.add(name)
            self._names[key] = name
        return self._names[key]

    def items(self) -> Iterable[tuple[object, str]]:
        """All that were given out."""
        return self._names.items()


def machine_text(machine: StateMachine) -> str:
    """The document."""
    return _Writer(machine).document()


class _Writer:
    def __init__(self, machine: StateMachine) -> None:
        self._machine = machine
        self._events, self._ports, self._inputs, ids = _Names(), _Names(), _Names(), _Names()
        self._root = ids.of("component", machine.component)
        self._regions = [ids.of(number_, region_title(region)) for number_, region in enumerate(machine.regions)]
        self._always = ids.of("always", "always")
        self._states: list[list[str]] = []
        for region, name in zip(machine.regions, self._regions, strict=True):
            own = _Names()
            texts = [state_text(region, state) for state in range(len(region.states))]
            self._states.append([f"{name}.{own.of(state, _FLAGS.get(text, text))}" for state, text in enumerate(texts)])
        for trigger in machine.triggers:
            self._events.of(trigger.id, trigger.label if trigger.id in machine.ports else trigger.id)

    def document(self) -> str:
        body = [line for number_ in range(len(self._regions)) for line in self._region(number_)]
        if self._machine.always or not self._regions:
            body.append(f'    <state id="{self._always}">')
            body += [line for t in self._machine.always for line in self._transition(t, None)]
            body.append("    </state>")
        return "\n".join(
            [
                '<?xml version="1.0" encoding="UTF-8"?>',
                f"<!-- {_comment(title(self._machine))} -->",
                *self._legend(),
                f'<scxml xmlns="{NAMESPACE}" version="1.0" datamodel="ecmascript" name={quoteattr(self._root)}>',
                f'  <parallel id="{self._root}">',
                *body,
                "  </parallel>",
                "</scxml>",
                "",
            ]
        )

    def _legend(self) -> list[str]:
        """What the names of events and of their data stand for, where they are not that."""
        labels = {trigger.id: trigger.label for trigger in self._machine.triggers}
        lines = [f"in.{name}: {labels[str(id_)]}" for id_, name in self._events.items() if name != labels[str(id_)]]
        lines += [f"out.{name}: {self._machine.ports.get(str(id_), str(id_))}" for id_, name in self._ports.items()]
        lines += [f"_event.data.{name}: {s.text}" for s, name in self._inputs.items() if isinstance(s, Subject) and s.text != name]
        return [f"<!-- {_comment(line)} -->" for line in lines]

    def _region(self, number_: int) -> list[str]:
        region, name, states = self._machine.regions[number_], self._regions[number_], self._states[number_]
        out = []
        if len(region.initial) == 1:
            out.append(f'    <state id="{name}" initial="{states[region.initial[0]]}">')
        else:
            waiting = f"{name}.undetermined"
            out += [f'    <state id="{name}" initial="{waiting}">', f'      <state id="{waiting}">']
            out += [f'        <transition event="init.{states[state]}" target="{states[state]}"/>' for state in region.initial]
            out.append("      </state>")
        for state, id_ in enumerate(states):
            inner = [line for t in region.transitions if t.source == state and t.visible for line in self._transition(t, states)]
            out += (
                [f'      <state id="{id_}">', *(f"  {line}" for line in inner), "      </state>"]
                if inner
                else [f'      <state id="{id_}"/>']
            )
        return [*out, "    </state>"]

    def _transition(self, transition: Transition, states: Sequence[str] | None) -> list[str]:
        """A transition; several when what it sends hangs on other regions, whose states are not seen once it is under way."""
        foreign = [o for o in transition.outputs if any(subject.cell for subject in subjects(o.when))][:_MOST_SPLITS]
        out = []
        for sent in product((True, False), repeat=len(foreign)):
            chosen = dict(zip(foreign, sent, strict=True))
            guard = conjunction([transition.guard, *(o.when if yes else negation(o.when) for o, yes in chosen.items())])
            outputs = [Output(o.port, TRUE if o in chosen else o.when, o.sometimes) for o in transition.outputs if chosen.get(o, True)]
            if transition.source == transition.target and not outputs:
                continue
            head = f'event="in.{self._events.of(transition.trigger, transition.trigger)}"'
            if guard != TRUE:
                head += f" cond={quoteattr(self._condition(guard))}"
            if states and transition.source != transition.target:
                head += f' target="{states[transition.target]}"'
            inside = [line for output in outputs for line in self._send(output)]
            out += [f"      <transition {head}>", *inside, "      </transition>"] if inside else [f"      <transition {head}/>"]
        return out

    def _send(self, output: Output) -> list[str]:
        name = self._ports.of(output.port, self._machine.ports.get(output.port, output.port))
        send = f'<send event="out.{name}"/>'
        when = output.when
        if output.sometimes:
            when = Is(Subject(f"sends {output.port}", f"sends {name}"), frozenset({"true"}))
        if when == TRUE:
            return [f"        {send}"]
        return [f"        <if cond={quoteattr(self._condition(when))}>", f"          {send}", "        </if>"]

    def _condition(self, formula: Formula) -> str:
        """An ECMAScript expression in the subset that interpreters with other expression languages read too."""
        if isinstance(formula, Is):
            return self._membership(formula)
        if isinstance(formula, Not):
            return self._condition(negation(formula.inner))
        if formula in (TRUE, FALSE):
            return "true" if formula == TRUE else "false"
        word = " && " if isinstance(formula, All) else " || "
        return word.join(
            f"({text})" if isinstance(part, All | Any) or " || " in text else text
            for part, text in ((part, self._condition(part)) for part in formula.parts)
        )

    def _membership(self, formula: Is) -> str:
        if formula.subject.cell:
            return self._in_states(formula)
        field = f"_event.data.{self._inputs.of(formula.subject, formula.subject.text)}"
        if OTHER in formula.values:
            rest = [value for value in formula.subject.values if value not in formula.values]
            return " && ".join(f"{field} != {_literal(value)}" for value in rest) or "true"
        listed = [value for value in formula.subject.values if value in formula.values]
        return " || ".join(f"{field} == {_literal(value)}" for value in listed) or "false"

    def _in_states(self, formula: Is) -> str:
        for region, states in zip(self._machine.regions, self._states, strict=True):
            keys = [cell.subject.key for cell in region.cells]
            if formula.subject.key in keys:
                index = keys.index(formula.subject.key)
                found = [id_ for values, id_ in zip(region.states, states, strict=True) if values[index] in formula.values]
                return " || ".join(f"In('{id_}')" for id_ in found) or "false"
        return "false"


def _literal(value: str) -> str:
    """A value in the data of an event: a truth value, a number, `null`, or a text."""
    if value in (*BOOLEAN, NULL) or number(value) is not None:
        return value
    text = "".join(c for c in value if c.isprintable())
    text = text.strip("\"'") if text[:1] in "\"'" else text
    return "'" + re.sub(r"[\\']", lambda match: f"\\{match[0]}", text) + "'"


def _comment(text: str) -> str:
    """A text that may appear in an XML comment."""
    return re.sub(r"-(?=-|$)", "- ", "".join(c for c in text if c.isprintable()))
