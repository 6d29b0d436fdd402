"""A system as a description in Acme, in the family that ROSDiscover's architectures are of (ROSFam)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from rosarch.models.system.links import TRANSFORMS, connector_kind, is_implicit, ports_of
from rosarch.models.system.model import Connector, SystemModel, SystemNode, SystemPort

_WORDS = """
abstract analysis and any assert attachment attachments bindings boolean collect component components connector connectors design distinct
double element enum exists extended extends external false family final float forall group heuristic iff implies import in int invariant
members new not on or path port ports private properties property public record representation representations role roles rule select
self seq sequence set string style system to true type unique view where with xor
"""
_RESERVED = frozenset(_WORDS.split())
_ANY_TYPE = "any"  # what the family's rules take for a type that goes with every other one
_NOT_A_TYPE = "*"


@dataclass(frozen=True)
class _Kind:
    """How a port kind is written: the types of a port and of the role that it is attached to, a suffix, and the port's properties."""

    port: str
    role: str
    suffix: str
    properties: tuple[tuple[str, str], ...]


_TOPIC = (("topic", "{name}"), ("msg_type", "{type}"))
_SERVICE = (("name : string", "{name}"), ("svc_type : string", "{type}"))
_KINDS: Mapping[str, _Kind] = MappingProxyType(
    {
        "publisher": _Kind("TopicAdvertisePortT", "ROSTopicAdvertiserRoleT", "pub", _TOPIC),
        "subscriber": _Kind("TopicSubscribePortT", "ROSTopicSubscriberRoleT", "sub", _TOPIC),
        "service_server": _Kind("ServiceProviderPortT", "ROSServiceResponderRoleT", "svc", (*_SERVICE, ("args : string", ""))),
        "service_client": _Kind("ServiceClientPortT", "ROSServiceCallerRoleT", "call", _SERVICE),
        "action_server": _Kind("ActionServerPortT", "ROSActionResponderRoleT", "srvr", (("action_type", "{type}"),)),
        "action_client": _Kind("ActionClientPortT", "ROSActionCallerRoleT", "cli", (("action_type", "{type}"),)),
        "tf_broadcaster": _Kind("TFLookupTransformPortT", "ROSTFAdvertiserRoleT", "pub", ()),
        "tf_listener": _Kind("TFListenerPortT", "ROSTFSubscriberRoleT", "sub", ()),
    }
)
_CONNECTORS = MappingProxyType(
    {"topic": "TopicConnectorT", "service": "ServiceConnT", "action": "ActionServerConnT", TRANSFORMS: "TFConnectorT"}
)

End = tuple[str, str]


def acme_text(system: SystemModel) -> str:
    """The system: a component for each node, a connector for each topic, service and action that joins ports.

    Ports that only libraries make are left out, as are connectors with one end.
    """
    scope = _Names()
    components = {node.id: scope.name(node.name) for node in system.nodes}
    ports: dict[End, str] = {}
    written: list[str] = []
    for node in system.nodes:
        own = [port for port in node.ports if port.kind in _KINDS and not port.implicit]
        names = _Names()
        ports.update(((node.id, port.id), names.name(port.name, _KINDS[port.kind].suffix)) for port in own)
        written += _component(node, components[node.id], [(ports[node.id, port.id], port) for port in own])
    attachments: list[str] = []
    known = ports_of(system)
    for connector in system.connectors:
        ends = [end for end in sorted({*connector.sources, *connector.sinks}) if end in ports]
        if _joins(connector, ends) and not is_implicit(connector, known):
            name = scope.name(connector.name, "conn")
            roles = _Names()
            attached = [(end, known[end], roles.name(components[end[0]], _KINDS[known[end].kind].suffix)) for end in ends]
            written += _connector(connector, name, connector_kind(connector, known), [(port, role) for _, port, role in attached])
            attachments += [f"  attachment {components[end[0]]}.{ports[end]} to {name}.{role};" for end, _, role in attached]
    head = ["import families/ROSFam.acme;", f"system {_Names().name(system.name)} : ROSFam = new ROSFam extended with {{"]
    return "\n".join([*head, *written, *attachments, "}"]) + "\n"


def _joins(connector: Connector, ends: Iterable[End]) -> bool:
    """Whether a connector has something to join: two ports of a topic, or a caller and a server."""
    known = set(ends)
    if connector.kind == "topic":
        return len(known) > 1
    return bool(known.intersection(connector.sources)) and bool(known.intersection(connector.sinks))


def _component(node: SystemNode, name: str, ports: Iterable[tuple[str, SystemPort]]) -> Iterator[str]:
    types = "ROSNodeCompT, PlaceholderT" if node.origin == "unknown" else "ROSNodeCompT"
    yield f"  component {name} : {types} = new {types} extended with {{"
    for port_name, port in ports:
        yield from _port(port_name, port)
    yield f"    property name = {_string(node.name)};"
    if node.origin == "unknown":
        yield "    property placeholder = true;"
    yield f"    property launchedBy = {_string(node.lines[-1].path if node.lines else 'unknown')};"
    yield "  };"


def _port(name: str, port: SystemPort) -> Iterator[str]:
    kind = _KINDS[port.kind]
    values = {"{name}": port.name, "{type}": _type(port.type)}
    properties = [f"      property {key} = {_string(values.get(value, value))};" for key, value in kind.properties]
    yield from _element("port", name, kind.port, properties)


def _connector(connector: Connector, name: str, kind: str, roles: Iterable[tuple[SystemPort, str]]) -> Iterator[str]:
    yield f"  connector {name} : {_CONNECTORS[kind]} = new {_CONNECTORS[kind]} extended with {{"
    types: list[str] = []
    for port, role in roles:
        role_type = _KINDS[port.kind].role
        types.append(_type(port.type))
        yield f"    role {role} : {role_type} = new {role_type};"
    if kind == "topic":
        yield f"    property msg_type = {_string(_ANY_TYPE if _ANY_TYPE in types else types[0])};"
        yield f"    property topic = {_string(connector.name)};"
    yield "  };"


def _element(word: str, name: str, type_: str, properties: list[str]) -> Iterator[str]:
    if not properties:
        yield f"    {word} {name} : {type_} = new {type_};"
        return
    yield f"    {word} {name} : {type_} = new {type_} extended with {{"
    yield from properties
    yield "    };"


def _type(type_: str | None) -> str:
    return _ANY_TYPE if type_ in (None, "", _NOT_A_TYPE) else str(type_)


def _string(text: str) -> str:
    """A string, which cannot have quotes and backslashes in it."""
    clean = "".join(c if c.isprintable() else " " for c in text.replace("\\", "/").replace('"', "'"))
    return f'"{clean}"'


class _Names:
    """Identifiers of one scope: letters, digits and underscores, none of them twice, none a word of the language."""

    def __init__(self) -> None:
        self.taken: set[str] = set(_RESERVED)

    def name(self, text: str, suffix: str = "") -> str:
        words = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")
        plain = "_".join(part for part in (words, suffix) if part) or "unnamed"
        first = plain if plain[0].isalpha() else f"n_{plain}"
        found, number = first, 1
        while found.lower() in self.taken:
            number += 1
            found = f"{first}_{number}"
        self.taken.add(found.lower())
        return found
