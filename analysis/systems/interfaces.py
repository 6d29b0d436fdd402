"""Component models and components of the library as rows of `rules/schema/interfaces.dl`."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from rosarch.base.places import Place
from rosarch.library import LibraryComponent
from rosarch.models.component import MANAGED, ComponentModel, parameter_json, port_json
from rosarch.models.rhythm import way_needs
from rosarch.models.traits import TRAITS

Rows = dict[str, set[tuple[Any, ...]]]


class _Writer:
    """Collects rows."""

    def __init__(self) -> None:
        self.rows: Rows = {}

    def add(self, relation: str, *row: Any) -> None:
        self.rows.setdefault(relation, set()).add(row)

    def placed(self, place: Place) -> str:
        """The key of a place."""
        key = f"{place}:{place.column}"
        self.add("place", key, place.path, place.line, place.column)
        return key

    def attributes(self, prefix: str, key: str, source: Mapping[str, Any], fields: Mapping[str, str]) -> None:
        """A row for each field that is given; one that is true has no value."""
        for field, relation in fields.items():
            value = source.get(field)
            if value is True:
                self.add(f"{prefix}_{relation}", key)
            elif value is not None and value is not False:
                self.add(f"{prefix}_{relation}", key, value)


_PORT = {
    "type": "type", "queue": "queue", "from_param": "parameter", "conditional": "conditional", "callback": "callback",
    "latched": "latched", "implicit": "implicit", "via": "via", "in_namespace": "in_namespace",
}  # fmt: skip
_LIBRARY_PORT = {**_PORT, "from_arg": "argument", "param_pattern": "pattern", "suffix": "suffix", "rest": "rest"}


def model_rows(model: ComponentModel) -> Rows:
    """The rows of a component that was analysed."""
    writer = _Writer()
    component = model.title
    if model.configuration:
        writer.add("interface_configured", component)
    for type_ in model.types:
        writer.add("interface", component, model.package, type_, model.kind, "source")
    if model.middleware:
        writer.add("interface_middleware", component, model.middleware)
    if model.node_name:
        writer.add("interface_node_name", component, model.node_name)
    if model.plugin and model.plugin.base:
        writer.add("interface_base", component, model.plugin.base)
    for name in model.loads:
        writer.add("interface_loads", component, name)
    for base in model.loads_any:
        writer.add("interface_loads_any", component, base)
    for port in model.ports:
        key = f"{component}#{port.id}"
        writer.add("interface_port", component, key, port.kind, port.name)
        writer.attributes("interface_port", key, port_json(port), _PORT)
        writer.add("interface_port_at", key, writer.placed(port.at))
        for policy, setting in port.qos:
            writer.add("interface_port_quality", key, policy, setting)
    for number, parameter in enumerate(model.params, 1):
        _access(writer, component, f"{component}#a{number}", parameter_json(parameter), parameter.at)
    for number, parameter in enumerate(model.reconfigurable, 1):
        _access(writer, component, f"{component}#d{number}", vars(parameter), parameter.at)
    for reaction in model.behavior.reactive:
        how = "always" if reaction.must else "sometimes"
        writer.add("interface_reacts", f"{component}#{reaction.input}", f"{component}#{reaction.output}", how)
    for loop in model.behavior.periodic:
        for sent in loop.publishes:
            writer.add("interface_periodic", f"{component}#{sent}", loop.hz or 0.0, loop.hz_from_param or "")
        writer.add("interface_loop", component, writer.placed(loop.at), loop.hz or 0.0, loop.hz_from_param or "")
    _sendings(writer, component, model)
    for each in model.unseen:
        writer.add("interface_open", component, each.what, each.kind, each.subject, writer.placed(each.at))
    for trait in model.traits:
        values = zip(TRAITS[trait.name], trait.values, strict=True)
        writer.add(f"interface_{trait.name}", component, *(_trait_value(writer, component, kind, value) for kind, value in values))
    return writer.rows


def _sendings(writer: _Writer, component: str, model: ComponentModel) -> None:
    """What decides whether something is sent, as far as parameters and counters do."""
    kept = {str(trait.values[0]): str(trait.values[1]) for trait in model.traits if trait.name == "keeps_value_of"}
    managed = model.kind == MANAGED  # what it sends while it is not active is dropped
    guards = [(f"{component}#{r.input}", r.output, r.guard) for r in model.behavior.reactive]
    guards += [(writer.placed(loop.at), sent, loop.guard) for loop in model.behavior.periodic for sent in loop.publishes]
    for source, output, guard in guards if kept else ():
        for number, (wholly, needs) in enumerate(way_needs(guard, kept), 1):
            way = f"{component}#{source} {output} {number}"
            told = "wholly" if wholly and not managed else "partly"
            writer.add("interface_way", way, component, source, f"{component}#{output}", told)
            for parameter, value, holds in needs:
                writer.add("interface_way_needs", way, parameter, value, "yes" if holds else "no")
    places = {str(loop.at): loop.at for loop in model.behavior.periodic}
    for rhythm in model.rhythms.regular:
        source = writer.placed(places[rhythm.trigger]) if rhythm.trigger in places else f"{component}#{rhythm.trigger}"
        sink = f"{component}#{rhythm.output}"
        name = "interface_rhythm_beside" if rhythm.parameter and not rhythm.factor else "interface_rhythm"
        writer.add(name, component, source, sink, rhythm.parameter, rhythm.rounds, rhythm.sends)
    for used in model.rhythms.used_up:
        sink, port = f"{component}#{used.output}", f"{component}#{used.port}"
        writer.add("interface_uses_up", component, writer.placed(places[used.trigger]), sink, port, "each" if used.each else "some")


def _trait_value(writer: _Writer, component: str, kind: str, value: str | Place) -> str:
    if isinstance(value, Place):
        return writer.placed(value)
    return f"{component}#{value}" if kind == "port" else value


def library_rows(found: LibraryComponent) -> Rows:
    """The rows of a component of the library."""
    writer = _Writer()
    component = found.title
    writer.add("interface", component, found.package, found.component, found.kind, "library")
    for version in found.ros:
        writer.add("interface_ros", component, version)
    for name in found.loads:
        writer.add("interface_loads", component, name)
    for what, is_open in (("ports", found.open_ports), ("params", found.open_params)):
        if is_open:
            writer.add("interface_open", component, what, "library", component, "")
    if found.options is not None:
        for option in ("", *found.options):
            writer.add("interface_option", component, option)
    for element, default in found.elements.items():
        if default is not None:
            writer.add("interface_element", component, element, default)
    if found.namespace_element:
        writer.add("interface_namespace_element", component, found.namespace_element)
    for number, port in enumerate(found.ports, 1):
        key = f"{component}#p{number}"
        writer.add("interface_port", component, key, port.kind, port.name or "?")
        writer.attributes("interface_port", key, vars(port), _LIBRARY_PORT)
        for index, pattern in port.if_arg.items():
            writer.add("interface_port_if_argument", key, index, pattern)
    for number, access in enumerate(found.params, 1):
        key = f"{component}#a{number}"
        if access.pattern:
            writer.add("interface_parameter_pattern", component, key, access.op, access.pattern)
        else:
            _access(writer, component, key, vars(access))
    return writer.rows


def _access(writer: _Writer, component: str, key: str, access: Mapping[str, Any], at: Place | None = None) -> None:
    writer.add("interface_parameter", component, key, access["op"], access["name"])
    if access["type"]:
        writer.add("interface_parameter_type", key, access["type"])
    default = access["default"]
    if default is not None:
        writer.add("interface_parameter_default", key, default if isinstance(default, str) else json.dumps(default))
    if at is not None:
        writer.add("interface_parameter_at", key, writer.placed(at))
