"""The configuration that a component is analysed with: what one node is called, and what its parameters are."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

from rosarch.base.cache import hash_of

Rows = dict[str, set[tuple[Any, ...]]]
Argument = tuple[str, int, str]
"""A function, the index of a parameter, and the text that it gets."""


@dataclass(frozen=True)
class NodeConfiguration:
    """What is known about a node before it runs; parameters go by the names that its code has for them.

    `values` are a parameter and a text, several for a list; `empty` are lists without elements; `unknown` are set to what is not known.
    When it is `open`, more may be set. With an `entry`, the node is an object of that class, which another node makes; `arguments` are what
    its constructor, or the functions of a plug-in, get from there. The `namespace`, absolute, is there where code may ask for it: nodes in
    different ones share their models otherwise, as their names are put below it when systems are composed. A node of a behavior tree has
    `inputs`: what the tree says of its input ports. `entries` are those of lists of maps: the parameter, the index of the map, key and
    text. `words` are those of its command line, without what is for ROS; None when they are not known.
    `results` are what functions of the base of its plug-ins return in these.
    """

    name: str | None = None
    values: tuple[tuple[str, str], ...] = ()
    empty: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()
    open: bool = False
    arguments: tuple[Argument, ...] = ()
    entry: str | None = None
    namespace: str | None = None
    inputs: tuple[tuple[str, str], ...] | None = None
    entries: tuple[tuple[str, int, str, str], ...] = ()
    words: tuple[str, ...] | None = None
    results: tuple[tuple[str, str], ...] = ()

    @cached_property
    def key(self) -> str:
        """Distinguishes it from others."""
        return hash_of(repr((one.name, getattr(self, one.name))) for one in fields(self))[:12]

    def rows(self) -> Rows:
        """The rows of `rules/schema/configuration.dl`; those of the class that is entered take the place of the component's."""
        rows: Rows = {
            "configuration_known": {()},
            "configured_name": {(self.name,)} if self.name else set(),
            "configured_namespace": {(self.namespace,)} if self.namespace else set(),
            "configured_value": set(self.values),
            "configured_entry": set(self.entries),
            "configured_empty": {(name,) for name in self.empty},
            "configured_unknown": {(name,) for name in self.unknown},
            "configured_open": {()} if self.open else set(),
            "configured_argument": set(self.arguments),
            "configured_as_tree_node": {()} if self.inputs is not None else set(),
            "configured_input": set(self.inputs or ()),
            "configured_command_line": {()} if self.words is not None else set(),
            "configured_result": set(self.results),
            "configured_word": set(enumerate(self.words or (), 1)),
        }
        if self.entry:
            rows |= {"component_class": {(self.entry,)}, "program_entry": set()}
        return rows


@dataclass(frozen=True)
class InnerNode:
    """A node that a component makes inside of its own: an object of `class_`.

    `namespaces` are texts and whether they are relative to the namespace of the component's node.
    """

    class_: str
    name: str
    namespaces: tuple[tuple[str, bool], ...]
    arguments: tuple[Argument, ...]


@dataclass(frozen=True)
class PluginArgument:
    """A component loads the plug-in called `name`, an object of class `base`, and gives it a text."""

    base: str
    name: str
    argument: Argument


def arguments_of_plugin(name: str, arguments: Iterable[PluginArgument]) -> list[tuple[Argument, ...]]:
    """The arguments that each instance of the plug-in called `name` gets from the component that loads it."""
    by_place: dict[tuple[str, int], set[str]] = {}
    for one in arguments:
        if one.name == name:
            by_place.setdefault(one.argument[:2], set()).add(one.argument[2])
    texts = {text for given in by_place.values() for text in given}
    several = {text for given in by_place.values() if len(given) > 1 for text in given}
    instances = []
    for own in sorted(several) if several else [None]:
        given = [
            (function, index, text)
            for (function, index), found in sorted(by_place.items())
            for text in sorted({own} if own in found else found)
            if text is not None
        ]
        instances.append(tuple(given))
    return instances if texts else [()]
