"""Plain YAML with places: texts, lists and maps, and for all that is wrong in them a line `path:line:col: message`.

The files may come from anyone: a tag or an alias is an error, and nothing in them is ever run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import yaml

from rosarch.base.hints import hint
from rosarch.base.places import Place
from rosarch.base.yaml_loader import BoundedLoader

LONGEST = 1_000_000  # characters


class YamlError(Exception):
    """A text that is no plain YAML; the message is `path:line:col: reason`."""


def compose(text: str, path: str) -> yaml.Node | None:
    """The tree of a text, None of an empty one; `path` is what messages call the file.

    Raises:
        YamlError: the text is not plain YAML.
    """
    if len(text) > LONGEST:
        raise YamlError(f"{path}:1:1: more than {LONGEST} characters")
    try:
        root: yaml.Node | None = yaml.compose(text, Loader=_PlainLoader)
    except yaml.YAMLError as error:
        raise YamlError(yaml_problem(path, error)) from None
    except RecursionError:
        raise YamlError(f"{path}:1:1: nested too deeply") from None
    return root


def yaml_problem(path: str, error: yaml.YAMLError) -> str:
    """`path:line:col: reason` of what the YAML reader rejected."""
    if not isinstance(error, yaml.MarkedYAMLError):
        return f"{path}:1:1: {' '.join(str(error).split())}"
    mark = error.problem_mark or error.context_mark
    reason = " ".join(part for part in (error.context, error.problem) if part)
    return f"{path}:{mark.line + 1}:{mark.column + 1}: {reason}" if mark else f"{path}:1:1: {reason}"


class _PlainLoader(BoundedLoader):
    """Composes trees of nodes: no node twice, none of a type of its own."""

    def compose_node(self, parent: yaml.Node | None, index: Any) -> yaml.Node | None:
        event: Any = self.peek_event()  # type: ignore[no-untyped-call]
        at: Any = event.start_mark
        if isinstance(event, yaml.AliasEvent):
            raise yaml.composer.ComposerError(None, None, f"an alias, `*{event.anchor}`: write the value out", at)
        if getattr(event, "tag", None) is not None:
            raise yaml.composer.ComposerError(None, None, f"a tag, `{event.tag}`: only plain values are allowed", at)
        return super().compose_node(parent, index)


class YamlReader:
    """Turns nodes into values and keeps what is wrong, one line each, in `problems`."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.problems: list[str] = []

    def place(self, node: yaml.Node) -> Place:
        """Where a node begins."""
        return Place(self.path, node.start_mark.line + 1, node.start_mark.column + 1)

    def problem(self, node: yaml.Node, message: str) -> None:
        """Something is wrong with a node."""
        self.problems.append(f"{self.path}:{node.start_mark.line + 1}:{node.start_mark.column + 1}: {message}")

    def known_keys(self, node: yaml.Node, known: Mapping[str, Callable[[yaml.Node], Any]], what: str) -> Iterator[tuple[str, Any]]:
        """The keys of a map with what `known` makes of their values; others are wrong, no `what`."""
        for key, value in self.pairs(node):
            if key.value in known:
                yield key.value, known[key.value](value)
            else:
                near = hint(key.value, known) or f", there are {', '.join(known)}"
                self.problem(key, f"unknown {what} `{key.value}`{near}")

    def choice(self, node: yaml.Node, choices: Iterable[str]) -> str | None:
        """A text that is one of `choices`."""
        text = self.text(node)
        if text is None or text in choices:
            return text
        self.problem(node, f"`{text}` is none of {', '.join(choices)}{hint(text, choices)}")
        return None

    def texts(self, node: yaml.Node, *, empty: bool = False) -> tuple[str, ...]:
        """A text, or a list of them."""
        found = [self.text(item, empty=empty) for item in (self.items(node) if isinstance(node, yaml.SequenceNode) else [node])]
        return tuple(text for text in found if text is not None)

    def text(self, node: yaml.Node, *, empty: bool = False) -> str | None:
        """A scalar as it is written, whatever YAML would make of it."""
        if not isinstance(node, yaml.ScalarNode):
            self.problem(node, f"a text is expected here, not a {kind_of(node)}")
            return None
        if not (node.value or empty):
            self.problem(node, "a text is expected here, not nothing")
            return None
        return str(node.value)

    def items(self, node: yaml.Node) -> list[yaml.Node]:
        """The items of a list."""
        if isinstance(node, yaml.SequenceNode) or is_nothing(node):
            return list(node.value)
        self.problem(node, f"a list is expected here, not a {kind_of(node)}")
        return []

    def pairs(self, node: yaml.Node) -> Iterator[tuple[yaml.ScalarNode, yaml.Node]]:
        """The keys and values of a map, each key once."""
        if is_nothing(node):
            return
        if not isinstance(node, yaml.MappingNode):
            self.problem(node, f"a map is expected here, not a {kind_of(node)}")
            return
        seen: dict[str, int] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                self.problem(key, f"a text is expected here, not a {kind_of(key)}")
            elif key.value in seen:
                self.problem(key, f"`{key.value}` stands here for the second time, first in line {seen[key.value]}")
            else:
                seen[key.value] = key.start_mark.line + 1
                yield key, value


def is_nothing(node: yaml.Node) -> bool:
    """Whether a value is left out, as where all of it is commented out."""
    return isinstance(node, yaml.ScalarNode) and not node.value and node.style is None


def kind_of(node: yaml.Node) -> str:
    """What messages call a node."""
    return {yaml.ScalarNode: "text", yaml.SequenceNode: "list"}.get(type(node), "map")
