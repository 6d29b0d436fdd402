"""What a composition configures its nodes with: the parameters that it sets for each, as the node's code calls them."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.facts import kind_and_text
from rosarch.extractor.launch.model import Composition, NodeStart, ParamSetting
from rosarch.extractor.launch.names import canonical
from rosarch.extractor.launch.values import automatic
from rosarch.models.node_configuration import NodeConfiguration


class NodeSettings:
    """What is set for the nodes of a composition; it remembers what it was asked, as models are sought many times."""

    def __init__(self, composition: Composition) -> None:
        self.composition = composition
        self._by_name: dict[str, list[ParamSetting]] = defaultdict(list)
        for setting in composition.params:
            self._by_name[setting.name].append(setting)
        self._names = sorted(self._by_name)
        self._unread = [canonical(unread.name).rstrip("/") for unread in composition.unread]
        self._known: dict[int, tuple[NodeStart, NodeConfiguration]] = {}

    def configuration(self, node: NodeStart) -> NodeConfiguration:
        """The name of a node, and its parameters."""
        known = self._known.get(id(node))
        if known is None:  # it keeps the node, so that no other one gets its id
            known = self._known[id(node)] = node, configuration_of(node, self._settings_of(node), self.is_open(node))
        return known[1]

    def is_open(self, node: NodeStart) -> bool:
        """Whether there may be parameters that were not seen."""
        own = f"{canonical(node.full_name)}/"
        return any(own.startswith(f"{unread}/") for unread in self._unread)

    def _settings_of(self, node: NodeStart) -> dict[str, list[ParamSetting]]:
        """The parameters of a node, as its code calls them."""
        own = f"{canonical(node.full_name)}/"
        if node.ros == 2:
            return {name.removeprefix(own): self._by_name[name] for name in self._below(own)}
        space = f"{canonical(node.namespace) if node.namespace != '/' else ''}/"
        found = {}
        for name, settings in self._by_name.items():
            if name.startswith(own):
                found[f"~{name.removeprefix(own)}"] = settings
            else:
                found[name] = settings
                if name.startswith(space):
                    found[name.removeprefix(space)] = settings
        return found

    def _below(self, prefix: str) -> Iterable[str]:
        """The names that begin so."""
        for index in range(bisect_left(self._names, prefix), len(self._names)):
            if not self._names[index].startswith(prefix):
                break
            yield self._names[index]


def configuration_of(node: NodeStart, settings: Mapping[str, Sequence[ParamSetting]], is_open: bool) -> NodeConfiguration:
    """The configuration of a node for which this is set."""
    values: set[tuple[str, str]] = set()
    empty: set[str] = set()
    unknown: set[str] = set()
    entries: set[tuple[str, int, str, str]] = set()
    for name, found in settings.items():
        texts = _texts(found[0].value) if len(found) == 1 and not found[0].conditions else None
        if texts is None:
            unknown.add(name)
            entries.update((name, *entry) for entry in _entries(found))
        elif not texts:
            empty.add(name)
        else:
            values.update((name, text) for text in texts)
    for param, written in node_arguments(node).params:
        values = {value for value in values if value[0] != f"~{param}"} | {(f"~{param}", kind_and_text(automatic(written))[1])}
    own_name = node.name or node.called
    return NodeConfiguration(
        own_name, tuple(sorted(values)), tuple(sorted(empty)), tuple(sorted(unknown)), is_open, entries=tuple(sorted(entries))
    )


def _entries(found: Sequence[ParamSetting]) -> Iterator[tuple[int, str, str]]:
    """What a list of maps has under which keys: index, key and text; nothing of a list that has other elements."""
    if len(found) != 1 or found[0].conditions or not isinstance(found[0].value, (list, tuple)):
        return
    elements = found[0].value
    if all(isinstance(element, dict) for element in elements):
        for index, element in enumerate(elements):
            for key, value in element.items():
                texts = _texts(value)
                if isinstance(key, str) and texts is not None and len(texts) == 1:
                    yield index, key, texts[0]


def _texts(value: Any) -> list[str] | None:
    """The texts that a parameter's value is, several for a list; None when it is not known."""
    if isinstance(value, (list, tuple)):
        found = [_texts(item) for item in value]
        return None if any(texts is None or len(texts) != 1 for texts in found) else [text for texts in found for text in texts or ()]
    kind, text = kind_and_text(value)
    return [text] if kind in ("string", "bool", "int", "double") else None
