"""What a component does, row by row: reactions, timed loops, state variables, their assignments; for tables of any format."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rosarch.models.behavior import sent_in_loop
from rosarch.models.machine.conditions import spaced

Document = Mapping[str, Any]
FIELDS = ("periodic", "reactive", "state_variables", "configuration", "transitions", "one_shot")


@dataclass(frozen=True)
class Table:
    """A titled table; its last column is the longest."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def tables(document: Document) -> list[Table]:
    """The tables of a component that have rows."""
    names = _port_names(document)
    found = [
        Table("reactions", ("on", "sends", "", "source", "when"), _reactions(document, names)),
        Table("timed loops", ("rate", "by", "sends", "source", "when"), _loops(document, names)),
        Table("state", ("variable", "type", "begins", "source"), _variables(document, "state_variables")),
        Table("configuration", ("variable", "type", "value", "source"), _variables(document, "configuration")),
        Table("transitions", ("variable", "becomes", "on", "source", "when"), _transitions(document, names)),
    ]
    return [table for table in found if table.rows]


def nothing(document: Document) -> str:
    """What is said where there is no table."""
    found = "no reactions, no timed loops, no state" + (", as far as was seen" if document.get("open") else "")
    names, traits = _port_names(document), document.get("traits") or {}
    for trait, when in (("sent_at_start", "at the start"), ("sent_by_itself", "at other times")):
        sent = dict.fromkeys(names.get(str(port), str(port)) for port, *_ in traits.get(trait, ()))
        found += f"; sends {when}: {', '.join(sent)}" if sent else ""
    return found


def _port_names(document: Document) -> dict[str, str]:
    return {str(port["id"]): spaced(str(port.get("name") or "?")) for port in document.get("ports") or ()}


def heading(document: Document) -> tuple[str, str]:
    """`package/component`, and what the component is."""
    name = document.get("node_name")
    kind = f"node {name}" if document.get("kind") == "node" and name else str(document.get("kind") or "node")
    return spaced(f"{document.get('package') or '?'}/{document.get('component') or '?'}"), spaced(kind)


def _reactions(document: Document, names: Mapping[str, str]) -> tuple[tuple[str, ...], ...]:
    return tuple(
        (
            _names([row.get("input")], names),
            _names([row.get("output")], names),
            "always" if row.get("must") else "may",
            _places(row.get("at")),
            _text(row.get("when")),
        )
        for row in document.get("reactive") or ()
    ) + tuple(
        (
            _timer(row),
            _names([row.get("output")], names),
            "always" if row.get("must") else "may",
            _places(row.get("sent_at")),
            _text(row.get("when")),
        )
        for row in document.get("one_shot") or ()
    )


def _loops(document: Document, names: Mapping[str, str]) -> tuple[tuple[str, ...], ...]:
    return tuple(
        (
            _rate(row),
            _text(row.get("mechanism")),
            _names(sent_in_loop(row), names) or "nothing",
            _places(row.get("at")),
            _text(row.get("conditional")),
        )
        for row in document.get("periodic") or ()
    )


def _timer(row: Mapping[str, Any]) -> str:
    after, parameter = row.get("after"), row.get("after_from_param")
    text = f"timer, once after {after:g} s" if isinstance(after, int | float) else "timer, once"
    return f"{text} from {parameter}" if parameter else text


def _rate(row: Mapping[str, Any]) -> str:
    hz, parameter = row.get("hz"), row.get("hz_from_param")
    text = f"{hz:g} Hz" if isinstance(hz, int | float) else "?"
    return f"{text} from {parameter}" if parameter else text


def _variables(document: Document, field: str) -> tuple[tuple[str, ...], ...]:
    return tuple(
        (
            _text(row.get("name")),
            _text(row.get("type")),
            _text(row.get("initial")) or "?",
            _places(row.get("at")),
        )
        for row in document.get(field) or ()
    )


def _transitions(document: Document, names: Mapping[str, str]) -> tuple[tuple[str, ...], ...]:
    found = []
    for row in document.get("transitions") or ():
        field = f".{row['field']}" if row.get("field") else ""
        trigger = row.get("trigger") or ()
        found.append(
            (
                f"{_text(row.get('variable'))}{field}",
                _text(row.get("value")) or "?",
                _names([trigger] if isinstance(trigger, str) else trigger, names),
                _places(row.get("at")),
                _text(row.get("guard")),
            )
        )
    return tuple(found)


def _names(ids: Iterable[Any], names: Mapping[str, str]) -> str:
    return ", ".join(names.get(str(id_), spaced(str(id_))) for id_ in ids)


def _text(value: object) -> str:
    return "" if value is None else spaced(str(value))


def _places(value: object) -> str:
    """Lines of source files, a file's name once for all of its lines."""
    found: dict[str, list[str]] = {}
    for place in value if isinstance(value, list | tuple) else [value] if value else []:
        file, _, line = str(place).rsplit("/", 1)[-1].rpartition(":")
        found.setdefault(file, []).append(line)
    return " ".join(file + " ".join(f":{line}" for line in lines) for file, lines in found.items())
