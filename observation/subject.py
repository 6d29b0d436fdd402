"""The component that is probed: its machine, its topics and services, and the messages that can be put into it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from rosarch.behavior.composition.components import Component, component
from rosarch.extractor.messages import MessageStore
from rosarch.models.machine.cells import Document, value_in
from rosarch.models.machine.logic import BOOLEAN
from rosarch.models.machine.logic import Subject as Asked
from rosarch.models.machine.steps import Row
from rosarch.observation.content import ContentError, Values, encoded, needed
from rosarch.observation.machine import Input, Machine, machine

_INLETS = ("subscriber", "service_server")
_UNKNOWN = "?"


@dataclass(frozen=True)
class Place:
    """A port under its name in the graph, and the type of what passes."""

    port: str
    kind: str
    name: str
    type: str

    @property
    def service(self) -> bool:
        """Whether it is served."""
        return self.kind == "service_server"


@dataclass(frozen=True)
class Subject:
    """A component, as the document of its model describes it, that runs as the node `name`."""

    document: Document
    store: MessageStore
    name: str

    @cached_property
    def component(self) -> Component:
        """Its steps and variables."""
        return component(self.document)

    @cached_property
    def places(self) -> Mapping[str, Place]:
        """Its ports by id: those whose names and types are known."""
        return {port["id"]: place for port in self.document.get("ports") or () if (place := self._place(port)) is not None}

    def _place(self, port: Mapping[str, str]) -> Place | None:
        name = port.get("name") or _UNKNOWN
        if _UNKNOWN in name or not port.get("type"):
            return None
        graph_name = name if name.startswith("/") else f"{self.name}/{name.lstrip('~/')}" if name.startswith("~") else f"/{name}"
        return Place(port["id"], port["kind"], graph_name, port["type"])

    @cached_property
    def inlets(self) -> list[Place]:
        """What something can be put into."""
        return [place for place in self.places.values() if place.kind in _INLETS and self._can_be_made(place, {})]

    @cached_property
    def outlets(self) -> list[Place]:
        """What sends."""
        return [place for place in self.places.values() if place.kind in ("publisher", "tf_broadcaster")]

    @cached_property
    def machine(self) -> Machine:
        """What it may do."""
        rows = [row for key in ("state_variables", "configuration") for row in self.document.get(key) or () if row.get("from_param")]
        given = {row["name"].rsplit("::", 1)[-1]: row.get("initial") for row in rows}
        named = {key: given.get(key.rsplit("::", 1)[-1]) for key in self.component.variables}
        first = {key: value_in(text, self.component.variables[key].values) for key, text in named.items()}
        known = {key: value for key, value in first.items() if value is not None}
        return machine(self.component, [place.port for place in self.inlets], self._solves, known)

    @cached_property
    def rows(self) -> dict[Row, tuple[str, ...]]:
        """The rows of its model that are to be settled, each with its triggers."""
        found: dict[Row, tuple[str, ...]] = {}
        for trigger, steps in self.component.steps.items():
            for step in steps:
                found[step.row] = (*found.get(step.row, ()), trigger)
        return found

    def entry(self, row: Row) -> Mapping[str, Any]:
        """What the document of its component says in a row."""
        found: Mapping[str, Any] = self.component.document[row.kind][row.index]
        return found

    def index(self, row: Row) -> int:
        """Where that is in the document of the model, of which the component leaves out loops that are another one's twin."""
        found: int = self.document[row.kind].index(self.entry(row))
        return found

    @cached_property
    def _numbers(self) -> dict[str, float]:
        """The numbers that variables of the configuration have, when no parameter is set."""
        found = {}
        for row in self.document.get("configuration") or ():
            try:
                found[str(row["name"]).rsplit("::", 1)[-1]] = float(row.get("initial") or "")
            except ValueError:
                continue
        return found

    def _solves(self, port: str, asked: Asked, value: str) -> bool:
        values = needed(asked, value, self.component.members, self._numbers)
        return values is not None and self._can_be_made(self.places[port], values)

    def values(self, given: Input) -> Values:
        """The fields of an input that matter."""
        values: dict[str, float | str] = {}
        for asked, value in given.content:
            values.update(needed(asked, value, self.component.members, self._numbers) or {})
        return values

    def encoded(self, place: Place, values: Values) -> bytes:
        """The bytes of a message or a request with these values.

        Raises:
            ContentError: none can be made.
        """
        type_ = place.type
        if place.service:
            service = self.store.services.get(type_)
            if service is None:
                raise ContentError(f"{type_} has no definition")
            type_ = service.request
        return encoded(self.store, type_, values)

    def _can_be_made(self, place: Place, values: Values) -> bool:
        try:
            self.encoded(place, values)
        except ContentError:
            return False
        return True

    def description(self, given: Input) -> str:
        """An input for people: the name, and what of its content matters."""
        conditions = [_condition(asked, value) for asked, value in given.content]
        return self.places[given.port].name + (f" with {' && '.join(conditions)}" if conditions else "")


def _condition(asked: Asked, value: str) -> str:
    if value not in BOOLEAN:
        return f"{asked.text} == {value}"
    return asked.text if value == BOOLEAN[0] else f"!({asked.text})"
