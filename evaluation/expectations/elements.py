"""The elements of models as expectations name them: a kind, its subject, and attributes that are texts, truth values or lists."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from typing import Any

from rosarch.findings.model import Finding
from rosarch.models.behavior import sent_in_loop

Attributes = Mapping[str, Any]


@dataclass(frozen=True)
class Kind:
    """A kind of elements: `subject` are the attributes that its expectations begin with, in order, `then` the one that may follow.

    `attributes` are all that it has, `between` is what stands between the subject's parts or before the next one.
    """

    name: str
    subject: tuple[str, ...]
    then: str | None
    attributes: tuple[str, ...]
    between: str = ""


_PORT = ("name", "type", "queue", "latched", "callback", "via", "from_param", "conditional", "implicit", "unknown")
_VARIABLE = ("name", "initial", "type", "from_param", "domain")
_KINDS = (
    Kind("component", ("name",), None, ("name", "package", "kind", "node_name")),
    Kind("param", ("name",), "default", ("name", "default", "type", "op"), "="),
    Kind("periodic", ("output",), "hz", ("output", "hz", "mechanism", "hz_from_param", "conditional")),
    Kind("reactive", ("input", "output"), None, ("input", "output", "must", "when"), "->"),
    Kind("deferred", ("input", "output"), None, ("input", "output", "variable"), "->"),
    Kind("one_shot", ("output",), "after", ("output", "after", "after_from_param", "must", "when")),
    Kind("state", ("name",), "initial", _VARIABLE, "="),
    Kind("configuration", ("name",), "initial", _VARIABLE, "="),
    Kind("transition", ("variable",), "value", ("variable", "value", "field", "trigger", "guard"), "="),
    Kind("finding", ("check",), "message", ("check", "message", "severity")),
)
FINDING = "finding"
ANY = Kind("*", (), None, ())


@dataclass(frozen=True)
class Element:
    """An element, with the places (`path:line`) that it has."""

    kind: str
    attributes: Attributes
    at: tuple[str, ...]


@lru_cache(maxsize=1)
def kinds() -> Mapping[str, Kind]:
    """All kinds by name: those of ports, and the others."""
    schema = json.loads(files("rosarch.reports").joinpath("schema/library.schema.json").read_text(encoding="utf-8"))
    ports = [Kind(name, ("name",), "type", _PORT) for name in schema["$defs"]["port"]["properties"]["kind"]["enum"]]
    return {kind.name: kind for kind in (*ports, *_KINDS)}


def elements(document: Mapping[str, Any]) -> Iterator[Element]:
    """All elements of a component's document; ports are called by their names."""
    names = {port["id"]: port["name"] for port in document["ports"]}
    yield Element("component", {**document, "name": document["component"]}, ())
    for port in document["ports"]:
        yield _element(port["kind"], port)
    for parameter in document["params"]:
        default = parameter["default"]
        yield _element("param", {**parameter, "default": f"[{', '.join(map(str, default))}]" if isinstance(default, list) else default})
    for loop in document["periodic"]:
        for port in sent_in_loop(loop) or [""]:
            yield _element("periodic", {**loop, "output": names.get(port, port)})
    for field, kind in (("reactive", "reactive"), ("reactive_deferred", "deferred"), ("one_shot", "one_shot")):
        for entry in document[field]:
            ends = {end: names.get(entry[end], entry[end]) for end in ("input", "output") if end in entry}
            yield _element(kind, {**entry, **ends})
    for field, kind in (("state_variables", "state"), ("configuration", "configuration")):
        for variable in document[field]:
            yield _element(kind, variable)
    for transition in document["transitions"]:
        yield _element("transition", {**transition, "trigger": [names.get(trigger, trigger) for trigger in transition["trigger"]]})


def finding_element(finding: Finding) -> Element:
    """What a check found."""
    attributes = {"check": finding.check.id, "message": finding.message, "severity": finding.severity}
    return Element(FINDING, attributes, (str(finding.place),))


def _element(kind: str, entry: Mapping[str, Any]) -> Element:
    at = entry.get("at") or ()
    return Element(kind, entry, tuple(at) if isinstance(at, (list, tuple)) else (at,))
