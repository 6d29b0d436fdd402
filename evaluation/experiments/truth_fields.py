"""The fields of a document of truth.

What is scored has to be as it is described here. What is not known is the author's own, unless it is nearly a name that is known: that is a
slip, and what it should have said would be missed in silence.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass

import yaml

from rosarch.base.hints import hint
from rosarch.base.plain_yaml import YamlReader, is_nothing, kind_of

Form = Callable[[YamlReader, yaml.Node], None]

_PLACE = re.compile(r".+:\d+")


def is_null(node: yaml.Node) -> bool:
    """Whether a value is `null`, or left out."""
    return is_nothing(node) or (isinstance(node, yaml.ScalarNode) and node.tag == "tag:yaml.org,2002:null")


def _text(reader: YamlReader, node: yaml.Node) -> None:
    if not is_null(node):
        reader.text(node, empty=True)


def _name(reader: YamlReader, node: yaml.Node) -> None:
    reader.text(node, empty=not is_nothing(node))  # `""` is what code can say, too


def _scalar(what: str, *tags: str) -> Form:
    def form(reader: YamlReader, node: yaml.Node) -> None:
        if is_null(node) or node.tag in [f"tag:yaml.org,2002:{tag}" for tag in tags]:
            return
        shown = f"`{node.value}`" if isinstance(node, yaml.ScalarNode) else f"a {kind_of(node)}"
        reader.problem(node, f"{what} is expected here, not {shown}")

    return form


def _place(reader: YamlReader, node: yaml.Node) -> None:
    if isinstance(node, yaml.ScalarNode) and not is_null(node) and not _PLACE.fullmatch(node.value):
        reader.problem(node, f"a place, `file:line`, is expected here, not `{node.value}`")


def _each(form: Form) -> Form:
    def forms(reader: YamlReader, node: yaml.Node) -> None:
        for item in [] if is_null(node) else reader.items(node):
            form(reader, item)

    return forms


def _either(form: Form) -> Form:
    """One, or a list of them."""
    return lambda reader, node: (_each(form) if isinstance(node, yaml.SequenceNode) else form)(reader, node)


def _anything(reader: YamlReader, node: yaml.Node) -> None:
    """What nobody reads."""


_INTEGER, _NUMBER, _FLAG = _scalar("a whole number", "int"), _scalar("a number", "int", "float"), _scalar("true or false", "bool")
_ALL: Mapping[str, Form] = {"at": _either(_place), "optional": _FLAG}
_CONDITION: Mapping[str, Form] = {
    "conditional": _text, "conditional_tree": _anything, "conditional_normal": _text, "meant": _anything,
}  # fmt: skip
_VARIABLE: Mapping[str, Form] = {
    "name": _name, "type": _text, "initial": _text, "from_param": _text, "aliases": _each(_name), "domain": _each(_text),
}  # fmt: skip


@dataclass(frozen=True)
class Fields:
    """The fields of the items of a list: those that each has to have, and the forms of all that it may have."""

    required: tuple[str, ...]
    forms: Mapping[str, Form]


LISTS: Mapping[str, Fields] = {
    "ports": Fields(("id", "kind"), {
        "id": _name, "kind": _name, "name": _text, "from_param": _text, "type": _text, "alt_types": _each(_name), "queue": _INTEGER,
        "queue_from_param": _text, "latched": _FLAG, "callback": _text, "via": _text, "at_alt": _either(_place), "implicit": _FLAG,
        "unknown": _text, "node": _text, "qos": _anything, "inside": _either(_place), "in_namespace": _text, **_CONDITION, **_ALL,
    }),
    "params": Fields(("name",), {"name": _name, "op": _name, "type": _text, "default": _anything, **_ALL}),
    "periodic": Fields((), {
        "mechanism": _name, "hz": _NUMBER, "hz_from_param": _text, "publishes": _each(_name), "calls": _each(_name),
        "feedback": _each(_name), "ways": _anything, **_CONDITION, **_ALL,
    }),
    "reactive": Fields(("input", "output"), {
        "input": _name, "output": _name, "must": _FLAG, "when": _text, "when_tree": _anything, "when_normal": _text, "meant": _anything,
        "ways": _anything,
        **_ALL,
    }),
    "state_variables": Fields(("name",), {**_VARIABLE, **_ALL}),
    "configuration": Fields(("name",), {**_VARIABLE, **_ALL}),
    "transitions": Fields(("variable",), {
        "variable": _name, "field": _text, "trigger": _each(_name), "guard": _text, "guard_tree": _anything, "guard_normal": _text,
        "value": _text, "timed_by": _each(_place), "build_condition": _text, "trail": _anything, "meant": _anything, **_ALL,
    }),
}  # fmt: skip
_LISTED = ("publishes", "trigger")
DOCUMENT: Mapping[str, Form] = {
    "system": _name, "component": _name, "package": _name, "kind": _name, "node_name": _text, "sources": _each(_name),
    "complete": _FLAG, "notes": _anything, "executable": _text, "executables": _each(_name), "node_names": _each(_name),
    "middleware": _text, "plugin": _anything,
    "loads": _each(_name), "loads_any": _each(_name), "reactive_deferred": _anything, "one_shot": _anything, "open": _anything,
}  # fmt: skip


def check_truth(reader: YamlReader, root: yaml.Node) -> dict[str, yaml.Node]:
    """The fields of a document of truth; what is wrong with them is kept by `reader`."""
    fields, items = _read(reader, root, {name: fields.forms for name, fields in LISTS.items()})
    _check_names(reader, root, [*DOCUMENT, *LISTS], "key of a component")
    for name, own in items.items():
        for item in own:
            _check_names(reader, item, LISTS[name].forms, f"field of `{name}`")
    _check_references(reader, items)
    return fields


def check_model(reader: YamlReader, root: yaml.Node) -> dict[str, yaml.Node]:
    """The fields of a model, of whatever tool: only without some of them it cannot be compared."""
    needed = {*_LISTED, *(field for fields in LISTS.values() for field in fields.required)}
    known = {name: {field: form for field, form in fields.forms.items() if field in needed} for name, fields in LISTS.items()}
    return _read(reader, root, known)[0]


def _read(
    reader: YamlReader, root: yaml.Node, forms: Mapping[str, Mapping[str, Form]]
) -> tuple[dict[str, yaml.Node], dict[str, list[yaml.Node]]]:
    """The fields of a document, and the items of its lists, these in the given forms."""
    fields = _pairs(reader, root, DOCUMENT)
    for name in ("component", "package"):
        if name not in fields:
            reader.problem(root, f"a component without `{name}`")
    items = {name: [] if name not in fields or is_null(fields[name]) else reader.items(fields[name]) for name in LISTS}
    for name, wanted in LISTS.items():
        for item in items[name]:
            present = _pairs(reader, item, forms[name])
            for field in wanted.required:
                if isinstance(item, yaml.MappingNode) and field not in present:
                    reader.problem(item, f"an entry of `{name}` without `{field}`")
    return fields, items


def _pairs(reader: YamlReader, node: yaml.Node, forms: Mapping[str, Form]) -> dict[str, yaml.Node]:
    found = {key.value: value for key, value in reader.pairs(node)}
    for name in found:
        if name in forms:
            forms[name](reader, found[name])
    return found


def _check_names(reader: YamlReader, node: yaml.Node, known: Collection[str], what: str) -> None:
    for key, _ in node.value if isinstance(node, yaml.MappingNode) else ():
        if isinstance(key, yaml.ScalarNode) and key.value not in known and (near := hint(key.value, known)):
            reader.problem(key, f"unknown {what} `{key.value}`{near}")


ACTIVITIES = frozenset({"periodic", "timer", "main", "thread", "signal", "external", "parameters", "lifecycle"})
"""What else than a port begins something."""


def _check_references(reader: YamlReader, items: Mapping[str, list[yaml.Node]]) -> None:
    """Ports are called by their ids, variables by their names, with or without namespaces."""
    ids = _texts(items["ports"], "id")
    seen: set[str] = set()
    for node in ids:
        if node.value in seen:
            reader.problem(node, f"a second port with the id `{node.value}`")
        seen.add(node.value)
    variables = {node.value for name in ("state_variables", "configuration") for node in _texts(items[name], "name")}
    members = {name.rpartition("::")[2] for name in variables}
    for list_, field, known, what, certain in (
        ("reactive", "input", seen, "port", False),
        ("reactive", "output", seen, "port", True),
        ("periodic", "publishes", seen, "port", True),
        ("transitions", "trigger", seen, "port", False),
        ("transitions", "variable", variables, "variable", False),
    ):
        for node in _texts(items[list_], field):
            if node.value in known or (not certain and node.value in ACTIVITIES) or node.value.rpartition("::")[2] in members:
                continue
            near = hint(node.value, known)
            if near or certain:
                reader.problem(node, f"no {what} `{node.value}` in this document{near}")


def _texts(items: Iterable[yaml.Node], field: str) -> list[yaml.ScalarNode]:
    """The texts in a field of some items."""
    values = [value for item in items if isinstance(item, yaml.MappingNode) for key, value in item.value if key.value == field]
    flat = [each for value in values for each in (value.value if isinstance(value, yaml.SequenceNode) else [value])]
    return [node for node in flat if isinstance(node, yaml.ScalarNode) and not is_null(node)]
