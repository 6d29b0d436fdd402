"""The comparison of two states of a workspace."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from rosarch.analysis.comparison.changes import HOW, Change, Item, differences, paired
from rosarch.findings.model import Finding
from rosarch.models import formula
from rosarch.models.component import ComponentModel, Port
from rosarch.models.formula import Formula
from rosarch.models.system.links import TRANSFORMS, connector_kind, is_implicit, ports_of
from rosarch.models.system.model import SystemModel

Whole = TypeVar("Whole", ComponentModel, SystemModel)
_UNNAMED = re.compile(r"\(((?:unnamed|anonymous) \w+) at [^()]*\)")  # a type without a name is called by its line, which moves
SUBJECTS = ("component", "system", "node", "port", "parameter", "connection", "rate", "reaction", "state", "transition", "finding")


@dataclass(frozen=True)
class Snapshot:
    """A state of a workspace, as far as it was analysed."""

    components: tuple[ComponentModel, ...]
    systems: tuple[SystemModel, ...] = ()
    findings: tuple[Finding, ...] = ()


def compare(old: Snapshot, new: Snapshot) -> tuple[Change, ...]:
    """What is different, by component, then by system, then the findings; implicit ports follow from others and are not compared."""
    return tuple(
        [
            *_compared(
                "component", {_title(m): m for m in old.components}, {_title(m): m for m in new.components}, _component_item, _component
            ),
            *_compared("system", {s.name: s for s in old.systems}, {s.name: s for s in new.systems}, _system_item, _system),
            *_findings(old.findings, new.findings),
        ]
    )


def _compared(
    subject: str,
    old: Mapping[str, Whole],
    new: Mapping[str, Whole],
    item: Callable[[Whole], Item],
    inside: Callable[[Whole, Whole], Iterable[Change]],
) -> Iterator[Change]:
    """What is in one state only is one change, without those inside."""
    for name in sorted({*old, *new}):
        if name in old and name in new:
            yield from sorted(inside(old[name], new[name]), key=lambda change: (SUBJECTS.index(change.subject), HOW.index(change.how)))
        else:
            yield from differences(subject, name, [item(old[name])] if name in old else (), [item(new[name])] if name in new else ())


def _title(model: ComponentModel) -> str:
    return f"{model.package}/{model.component}"


def _component_item(model: ComponentModel) -> Item:
    ports = sum(1 for port in model.ports if not port.implicit)
    return Item(_title(model), _title(model), f"{model.kind} {_title(model)}", (("ports", str(ports)),))


def _component(old: ComponentModel, new: ComponentModel) -> Iterator[Change]:
    where = _title(new)
    ports = ([_port_item(port) for port in model.ports if not port.implicit] for model in (old, new))
    first, second = ports
    yield from differences("port", where, first, second)
    pairs, _, _ = paired(first, second)
    renamed = {before.key: after.name for before, after in pairs}
    old_names = {port.id: renamed.get(_port_item(port).key, port.name) for port in old.ports}
    new_names = {port.id: port.name for port in new.ports}
    yield from differences("parameter", where, _parameters(old), _parameters(new))
    for subject, items in (("rate", _rates), ("reaction", _reactions), ("state", _states), ("transition", _transitions)):
        yield from differences(subject, where, items(old, old_names), items(new, new_names))


def _port_item(port: Port) -> Item:
    attributes = (
        ("type", port.type),
        ("queue", None if port.queue is None else str(port.queue)),
        ("latched", "yes" if port.latched else None),
        ("quality", ", ".join(setting for policy, setting in port.qos if policy != "profile") or None),
        ("callback", port.callback),
        ("from", port.from_param),
    )
    likeness = (port.kind, port.type, port.callback) if port.type and "?" not in port.name else None
    return Item((port.kind, port.name), port.name, f"{port.kind.replace('_', ' ')} {port.name}", attributes, port.at, likeness)


def _parameters(model: ComponentModel) -> list[Item]:
    return [
        Item((p.name, p.op), p.name, f"{p.op} {p.name}", (("type", p.type), ("default", p.default)), p.at)
        for p in sorted(model.params, key=lambda p: (p.name, p.op, p.at))
    ]


Names = Mapping[str, str]


def _rates(model: ComponentModel, names: Names) -> list[Item]:
    found = []
    for rate in model.behavior.periodic:
        sent = ", ".join(sorted({names.get(port, port) for port in rate.publishes})) or "nothing"
        hz = "?" if rate.hz is None else f"{rate.hz:g} Hz"
        attributes = (("rate", hz), ("from", rate.hz_from_param), ("when", _text(rate.guard)))
        found.append(Item((rate.mechanism, sent), sent, f"{rate.mechanism} sends {sent}", attributes, rate.at))
    for once in model.behavior.one_shot:
        sent = names.get(once.output, once.output)
        delay = "?" if once.after is None else f"{once.after:g} s"
        attributes = (("after", delay), ("from", once.after_from_param), ("when", _text(once.guard)))
        found.append(Item(("once", sent), sent, f"once sends {sent}", attributes, once.at))
    return found


def _reactions(model: ComponentModel, names: Names) -> list[Item]:
    found = []
    for reaction in model.behavior.reactive:
        pair = names.get(reaction.input, reaction.input), names.get(reaction.output, reaction.output)
        attributes = (("always", "yes" if reaction.must else None), ("when", _text(reaction.guard)))
        at = reaction.at[0] if reaction.at else None
        found.append(Item(pair, pair[1], f"{pair[0]} sends {pair[1]}", attributes, at))
    return found


def _states(model: ComponentModel, _names: Names) -> list[Item]:
    found = []
    for variable in model.behavior.state_variables:
        values = None if variable.domain is None else " | ".join(variable.domain)
        attributes = (
            ("type", _UNNAMED.sub(r"(\1)", variable.type)),
            ("begins", variable.initial),
            ("from", variable.from_param),
            ("values", values),
        )
        found.append(Item(variable.name, variable.name, variable.name, attributes, variable.at))
    return found


def _transitions(model: ComponentModel, names: Names) -> list[Item]:
    found = []
    for transition in model.behavior.transitions:
        variable = f"{transition.variable}.{transition.field}" if transition.field else transition.variable
        causes = ", ".join(sorted(names.get(cause, cause) for cause in transition.trigger))
        key = (variable, transition.value, causes)
        title = f"{variable} becomes {transition.value or '?'}{f' on {causes}' if causes else ''}"
        found.append(Item(key, variable, title, (("when", _text(transition.guard)),), transition.at))
    return found


def _text(guard: Formula) -> str | None:
    return formula.text(guard)


def _system_item(system: SystemModel) -> Item:
    return Item(system.name, system.name, system.name, (("nodes", str(len(system.nodes))),))


def _system(old: SystemModel, new: SystemModel) -> Iterator[Change]:
    where = new.name
    yield from differences("node", where, _nodes(old), _nodes(new))
    both = {node.name for node in old.nodes} & {node.name for node in new.nodes}
    yield from differences("port", where, _system_ports(old, both), _system_ports(new, both))
    yield from differences("connection", where, _connections(old), _connections(new))


def _nodes(system: SystemModel) -> list[Item]:
    found = []
    for node in sorted(system.nodes, key=lambda node: (node.name, node.lines)):
        model = None if node.origin == "source" else node.origin
        attributes = (("executable", f"{node.package}/{node.type}"), ("model", model), ("if", " and ".join(node.conditions) or None))
        found.append(Item(node.name, node.name, node.name, attributes, node.lines[-1] if node.lines else None))
    return found


def _system_ports(system: SystemModel, nodes: set[str]) -> list[Item]:
    """The ports of nodes that both systems have, by their names at run time."""
    return [
        Item(
            (node.name, port.kind, port.name),
            port.name,
            f"{node.name} {port.kind.replace('_', ' ')} {port.name}",
            (("type", port.type), ("if", port.conditional)),
            port.at or (node.lines[-1] if node.lines else None),
            (node.name, port.kind, port.written, port.type) if "?" not in port.name else None,
        )
        for node in sorted(system.nodes, key=lambda node: node.name)
        if node.name in nodes
        for port in sorted(node.ports, key=lambda port: (port.kind, port.name, port.id))
        if not port.implicit
    ]


def _connections(system: SystemModel) -> list[Item]:
    """What leads from node to node; transforms, which lead from each to each, are seen by the ports."""
    ports = ports_of(system)
    names = {node.id: node.name for node in system.nodes}
    found = {
        (connector.kind, names[source], connector.name, names[sink])
        for connector in system.connectors
        if connector_kind(connector, ports) != TRANSFORMS and not is_implicit(connector, ports)
        for source, _ in connector.sources
        for sink, _ in connector.sinks
        if source in names and sink in names
    }
    return [Item(key, key[2], f"{key[1]} > {key[2]} > {key[3]}", (("kind", key[0]),)) for key in sorted(found)]


def _findings(old: Sequence[Finding], new: Sequence[Finding]) -> Iterator[Change]:
    """Findings are the same when their fingerprints are, as often as they are there."""
    before, after = (Counter(finding.fingerprint for finding in findings) for findings in (old, new))
    for how, findings, missing in (("lost", old, before - after), ("gained", new, after - before)):
        for finding in sorted(findings, key=lambda f: (f.place, f.check.id, f.message)):
            if missing[finding.fingerprint] > 0:
                missing[finding.fingerprint] -= 1
                places = (finding.place, None) if how == "lost" else (None, finding.place)
                yield Change("finding", "findings", how, f"{finding.severity} {finding.check.id}: {finding.message}", (), *places)
