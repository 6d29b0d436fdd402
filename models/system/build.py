"""From launch files and component models to a system: the rules of systems, their rows as a model and as findings."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any, Literal

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.models.openness import OpenPart, reason_text
from rosarch.models.system.model import Connector, Inclusion, SystemModel, SystemNode, SystemPort
from rosarch.models.system.rows import Rows, grouped
from rosarch.rule_programs.checks import evidence_of, shown_as
from rosarch.rule_programs.sets import SystemRules


def evaluate(rules: SystemRules, rows: Rows, engine: str = "embedded", keep: Sequence[str] | Literal["all"] = ()) -> Result:
    """What the rules derive of a system: its model, the findings and, if asked for, the relations in `keep`."""
    wanted = keep if keep == "all" else [*rules.program.outputs, *finding_relations(rules), *keep]
    return rules.program.evaluate(rows, engine=engine, keep=wanted)


def finding_relations(rules: SystemRules) -> list[str]:
    """The relations that findings are made from."""
    types = {type_ for check in rules.checks for _, type_ in check.columns}
    helpers = {relation for type_ in types for relation in (evidence_of(type_), shown_as(type_)) if relation in rules.program.relations}
    fixes = [check.fix_relation for check in rules.checks if check.fix_columns]
    return [*(check.relation for check in rules.checks), *fixes, *sorted(helpers)]


def system_model(name: str, launch: Sequence[str], rows: Rows, result: Result, places: Mapping[str, Place]) -> SystemModel:
    """The model of a system, from the facts about it and what the rules derived; `places` are those of the facts, by key."""
    instances = _instances(rows, result)
    ports, ids = _ports(rows, result, places, instances)
    opened = {node for node, what, *_ in result.rows("node_open") if what == "ports"}
    hosts = {node for (node,) in result.rows("hosts")}
    lines = grouped(rows.get("started_at", ()))
    conditions = grouped(rows.get("started_if", ()))
    names = {row[0]: row[1] for row in rows.get("started_name", ())}
    rates = grouped(result.rows("loop_rate"))
    settings = grouped(result.rows("setting"))
    serving = grouped(rows.get("interface_serves_callbacks", ()))
    origins = {row[0]: row[4] for row in rows.get("interface", ())}
    nodes = []
    for start, package, type_ in sorted(rows.get("started", ())):
        components = instances.get(start, [])
        nodes.append(
            SystemNode(
                id=start,
                name=names[start],
                package=package,
                type=type_,
                origin=origins[components[0]] if components else "library" if start in hosts else "unknown",
                component=components[0] if components else None,
                lines=tuple(places[place] for _, place in lines.get(start, [])),
                ports=tuple(ports.get(start, ())),
                conditions=tuple(condition for (condition,) in conditions.get(start, [])),
                open=start in opened,
                rates=tuple(sorted((places[place], hz) for place, hz in rates.get(start, []))),
                serving=tuple(sorted(places[place] for (place,) in serving.get(components[0], []))) if components else (),
                settings=tuple(sorted(settings.get(start, []))),
            )
        )
    inclusions = tuple(sorted((_inclusion(row, places) for row in rows.get("included", ())), key=lambda inclusion: inclusion.at))
    return SystemModel(name, tuple(launch), tuple(nodes), _connectors(result, ids), inclusions, _unseen(result, names, places))


def _instances(rows: Rows, result: Result) -> dict[str, list[str]]:
    """The components of each node: what it runs, then the plug-ins that this loads."""
    kinds = {row[0]: row[3] for row in rows.get("interface", ())}
    found: dict[str, list[str]] = defaultdict(list)
    for node, component in result.rows("instance"):
        found[node].append(component)
    return {node: sorted(components, key=lambda one: (kinds.get(one) == "plugin", one)) for node, components in found.items()}


def _unseen(result: Result, names: Mapping[str, str], places: Mapping[str, Place]) -> tuple[OpenPart, ...]:
    opened = {(node, reason, place) for node, _, reason, place in result.rows("node_open") if place in places}
    nodes = {OpenPart(names[node], reason_text(*reason), places[place]) for node, reason, place in opened}
    systems = {OpenPart("", reason_text(*reason), places[place]) for reason, place in result.rows("system_open")}
    return tuple(sorted(nodes | systems))


def _inclusion(row: tuple[Any, ...], places: Mapping[str, Place]) -> Inclusion:
    place, _, file = row
    return Inclusion(places[place], file, file or None)


def _ports(
    rows: Rows, result: Result, places: Mapping[str, Place], instances: Mapping[str, Sequence[str]]
) -> tuple[dict[str, list[SystemPort]], dict[Any, tuple[str, str]]]:
    """The ports by node, and node and port id of each port's record; the ids of a plug-in's ports name the plug-in, too."""
    models = {row[1]: row for row in rows.get("interface_port", ())}
    types = _types(result)
    at = {row[0]: row[1] for row in rows.get("interface_port_at", ())}
    conditional = {row[0]: row[1] for row in rows.get("interface_port_conditional", ())}
    implicit = {row[0] for row in rows.get("interface_port_implicit", ())}
    decided = {(node, model) for node, model in result.rows("switched_on")}
    names: dict[tuple[Any, ...], str] = {tuple(port): name for port, name in result.rows("port_name")}
    ports: dict[str, list[SystemPort]] = defaultdict(list)
    ids: dict[Any, tuple[str, str]] = {}
    for node, model, parameter, written in result.rows("port_written"):
        record = (node, model, parameter)
        component, _, kind, _ = models[model]
        own = component in instances.get(node, ())[:1]
        id_ = (model.removeprefix(f"{component}#") if own else model) + (f":{parameter}" if parameter else "")
        ids[record] = (node, id_)
        port = SystemPort(
            id_,
            kind,
            names.get(record) or written,
            written,
            _only_type(types.get(record, [])),
            places.get(at.get(model, "")),
            model in implicit,
            None if (node, model) in decided else conditional.get(model),
        )
        ports[node].append(port)
    return ports, ids


def _only_type(types: Sequence[tuple[Any, ...]]) -> str | None:
    """The type of a port; of several that may pass through it, none is known to be it."""
    return str(types[0][0]) if len(types) == 1 else None


def _types(result: Result) -> dict[Any, list[tuple[Any, ...]]]:
    """The types of the messages that may pass through each port's record."""
    return grouped((tuple(port), type_) for port, type_ in result.rows("node_port_type"))


def _connectors(result: Result, ids: Mapping[Any, tuple[str, str]]) -> tuple[Connector, ...]:
    types = _types(result)
    found: dict[tuple[str, str], dict[str, set[tuple[str, str]]]] = {}
    passed: dict[tuple[str, str], set[str]] = defaultdict(set)
    for kind, name, side, port in result.rows("joins_connector"):
        found.setdefault((kind, name), {"source": set(), "sink": set()})[side].add(ids[tuple(port)])
        passed[kind, name].update(type_ for (type_,) in types.get(tuple(port), []))
    opened = set(result.rows("connector_open"))
    return tuple(
        Connector(*key, tuple(sorted(passed[key])), tuple(sorted(sides["source"])), tuple(sorted(sides["sink"])), key in opened)
        for key, sides in sorted(found.items())
    )
