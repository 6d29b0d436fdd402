"""What properties and scenarios call the nodes, variables and topics of a system."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rosarch.base.hints import hint
from rosarch.behavior.composition.components import StateVariable
from rosarch.behavior.composition.cone import Event
from rosarch.behavior.composition.system import System
from rosarch.models.machine.cells import nonzero, value_in
from rosarch.models.machine.logic import OTHER


class UnknownNameError(Exception):
    """There is no such thing; `argument` is the place of the name among several, `of_value` says that it is a value."""

    def __init__(self, message: str, *, argument: int = 0, of_value: bool = False) -> None:
        super().__init__(message)
        self.argument = argument
        self.of_value = of_value


class Names:
    """Finds what is meant; a node may be called by the last part of its name where that is enough."""

    def __init__(self, system: System) -> None:
        self._system = system

    def node(self, name: str, argument: int = 0) -> str:
        """The node of this name, of those whose behaviour is known."""
        known = self._system.nodes
        found = [id_ for id_ in known if name in (id_, id_.lstrip("/"))] or [id_ for id_ in known if id_.rsplit("/", 1)[-1] == name]
        if len(found) == 1:
            return found[0]
        if found:
            raise UnknownNameError(f"`{name}` may be {' or '.join(sorted(found))}", argument=argument)
        if f"/{name.lstrip('/')}" in self._system.unknown:
            raise UnknownNameError(f"of node {name} no behaviour is known", argument=argument)
        raise UnknownNameError(f"no node `{name}`{hint(name, _short(known))}", argument=argument)

    def topic(self, name: str, argument: int = 0) -> str:
        """The topic, service or action of this name."""
        full = name if name in self._system.topics else f"/{name}"
        if full not in self._system.topics:
            raise UnknownNameError(f"no topic `{name}`{hint(name, self._system.topics)}", argument=argument)
        return full

    def variable(self, text: str) -> tuple[str, StateVariable]:
        """The node and variable that `node.variable` names."""
        name, _, rest = text.partition(".")
        node = self.node(name)
        component = self._system.nodes[node]
        found = [variable for variable in component.variables.values() if rest in _spellings(variable)]
        if len(found) == 1:
            return node, found[0]
        if not found and rest in {name.rsplit("::", 1)[-1] for name in component.left_out}:
            raise UnknownNameError(f"`{rest}` of {node} has no finite values")
        known = {variable.text for variable in component.variables.values()}
        choice = hint(rest, known) or (f", there are {', '.join(sorted(known))}" if known else ", it has none")
        raise UnknownNameError(f"{node} has no state variable `{rest}`{choice}")

    def state(self, text: str, value: str | None) -> tuple[str, str, frozenset[str]]:
        """A test of a variable: its node, its key and the values asked for; without a value, what is true or not zero."""
        node, variable = self.variable(text)
        if value is None:
            true = nonzero(variable.values)
            if true is None:
                raise UnknownNameError(f"`{text}` is no truth value; compare it with one of {', '.join(variable.values)}")
            return node, variable.key, true
        return node, variable.key, frozenset({self.value(text, value)})

    def value(self, text: str, value: str) -> str:
        """A value of the variable that is called `text`; a constant may be called by its name or its number, a text without its quotes."""
        node, variable = self.variable(text)
        traits = self._system.nodes[node].document.get("traits") or {}
        numbers = {str(name): str(number) for name, number in traits.get("names_number", ())}
        written = {_in_double_quotes(each): each for each in variable.values}
        spellings = (value, numbers.get(value.rsplit("::", 1)[-1], value), f'"{value}"')
        found = [written.get(_in_double_quotes(each)) or value_in(each, variable.values) for each in spellings]
        known = next((each for each in found if each not in (None, OTHER) or value == OTHER), None)
        if known is None:
            near = hint(value, variable.values) or f", there are {', '.join(variable.values)}"
            raise UnknownNameError(f"`{text}` is never told apart as `{value}`{near}", of_value=True)
        return known

    def event(self, kind: str, *arguments: str) -> Event:
        """An event: its arguments are a topic, or a node and a topic."""
        topic = self.topic(arguments[-1], len(arguments) - 1)
        node = self.node(arguments[0]) if len(arguments) == 2 else ""
        ends = self._system.topics[topic].senders if kind == "sent" else self._system.topics[topic].receivers
        if node and node not in {end[0] for end in ends} and not (kind == "sent" and node in self._system.topics[topic].outside):
            others = sorted({end[0] for end in ends})
            verb = "send" if kind == "sent" else "receive"
            raise UnknownNameError(f"{node} does not {verb} {topic}" + (f"; {', '.join(others)} {verb}s it" if others else ""))
        return Event(kind, topic, node)


def _in_double_quotes(value: str) -> str:
    """A value; one in quotes, in those of both languages."""
    return f'"{value[1:-1]}"' if value[:1] == "'" else value


def _spellings(variable: StateVariable) -> Iterable[str]:
    return variable.text, variable.text.replace("::", "."), variable.key


def _short(known: Mapping[str, object]) -> list[str]:
    return [*known, *(id_.lstrip("/") for id_ in known), *(id_.rsplit("/", 1)[-1] for id_ in known)]
