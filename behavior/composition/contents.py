"""What messages hold: the values that senders give their fields, as variables of one reaction, and what these are where they are read."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from rosarch.models.machine.cells import Document, value_in
from rosarch.models.machine.conditions import is_name
from rosarch.models.machine.limits import NO_NUMBER
from rosarch.models.machine.logic import OTHER

_READ = re.compile(r"(?:->|\.)(\w+)")
_PREFIX = "message "
Content = Mapping[str, str]
"""The values of the fields of a message that are known, by their paths."""


def fields_read(documents: Iterable[Document]) -> frozenset[str]:
    """The last names of all fields that some condition or assignment may read."""
    texts = (text for document in documents for text in _texts(document))
    return frozenset(name for text in texts for name in _READ.findall(text))


def _texts(document: Document) -> Iterable[str]:
    for kind in ("transitions", "reactive", "periodic", "one_shot"):
        for row in document.get(kind) or ():
            for own in (row, *row.get("ways", ())):
                keys = ("guard", "guard_normal", "when", "when_normal", "conditional", "conditional_normal", "value", "value_normal")
                yield from (str(own[key]) for key in keys if own.get(key))


def with_contents(document: Document, asked: Collection[str]) -> Document:
    """The document in which fields of sent messages that somebody asks for are variables, which what gives them values changes."""
    contents = document.get("contents") or {}
    kinds = {(message, path): kind for message, path, kind in contents.get("kinds", ())}
    rows = [row for row in contents.get("fillings", ()) if row["path"].rpartition(".")[2] in asked]
    variables: dict[str, dict[str, Any]] = {}
    changes = []
    for row in rows:
        name = variable_of(row["message"], row["path"])
        kind = kinds.get((row["message"], row["path"]), "")
        variables[name] = {"name": name, "type": kind, "initial": None, "domain": None, "at": ""}
        changes.append({key: value for key, value in row.items() if key not in ("message", "path")} | {"variable": name})
    if not changes:
        return document
    return {
        **document,
        "state_variables": [*(document.get("state_variables") or ()), *variables.values()],
        "transitions": [*(document.get("transitions") or ()), *changes],
    }


def variable_of(message: str, path: str) -> str:
    """The variable that a field of a message is."""
    return f"{_PREFIX}{message} {path}"


def is_content(key: str) -> bool:
    """Whether a variable is a field of a message."""
    return key.startswith(_PREFIX)


def fields_of(message: str, keys: Iterable[str]) -> dict[str, str]:
    """The variables that are fields of a message, by path."""
    begin = variable_of(message, "")
    return {key[len(begin) :]: key for key in keys if key.startswith(begin)}


def numbers_of(document: Document) -> Mapping[str, str]:
    """The numbers and texts that names stand for in a component."""
    return {str(name): str(value) for name, value in (document.get("contents") or {}).get("constants", ())}


def as_read(value: str, sent_by: Mapping[str, str], values: Sequence[str], read_by: Mapping[str, str]) -> str | None:
    """The one of `values`, which a reader distinguishes, that a sent value is; None where that is not known.

    The names of numbers are those of the sender and of the reader.
    """
    if value in (OTHER, NO_NUMBER):
        return None
    sent = _plain(value, sent_by)
    if sent is None:
        return None
    known = {_plain(each, read_by): each for each in values if each != OTHER}
    if sent in known:
        return known[sent]
    if None in known or _is_text(sent) is not any(_is_text(each) for each in known if each):
        found = value_in(sent, values) if None not in known and not _is_text(sent) else None
        return found if found != OTHER else None
    return value_in(sent, values)


def _plain(value: str, numbers: Mapping[str, str]) -> str | None:
    """A value with its number in the place of a name; None for a name of something else."""
    if value in ("true", "false") or not is_name(value):
        return f'"{value[1:-1]}"' if value[:1] == "'" else value
    return numbers.get(value.rsplit("::", 1)[-1].rsplit(".", 1)[-1])


def _is_text(value: str) -> bool:
    return value[:1] == '"'
