"""`.rosarch.yml`: what a team has settled about checking its workspace.

The file may come from anyone. It is read as plain YAML: a tag or an alias is an error, and nothing in it is ever run.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import yaml

from rosarch.extractor.hints import hint
from rosarch.models.places import Place
from rosarch.models.policy import CHOICES, THRESHOLDS, Severities, unmatched

NAME = ".rosarch.yml"
LONGEST = 1_000_000  # characters


class ConfigurationError(Exception):
    """A configuration that is not as it should be: one line for each thing that is wrong, `path:line:col: message`."""


@dataclass(frozen=True)
class LaunchChoice:
    """Launch files that are started together; every combination of the values of `arguments` is a system."""

    files: tuple[str, ...]
    arguments: tuple[tuple[str, tuple[str, ...]], ...]
    at: Place


@dataclass(frozen=True)
class Configuration:
    """The settings of a workspace; None and empty ones are not given. Paths are as written: relative to the folder of the file."""

    checks: Severities = ()
    fail_on: str | None = None
    ignore_paths: tuple[str, ...] = ()
    baseline: str | None = None
    launch: tuple[LaunchChoice, ...] = ()
    package_path: tuple[str, ...] = ()
    environment: tuple[tuple[str, str], ...] = ()


def read_configuration(text: str, path: str, checks: Collection[str]) -> Configuration:
    """The configuration in a text; `path` is what messages call the file, `checks` are the ids of all checks.

    Raises:
        ConfigurationError: something in it is wrong; all that is wrong is told.
    """
    if len(text) > LONGEST:
        raise ConfigurationError(f"{path}:1:1: more than {LONGEST} characters")
    reader = _Reader(path, checks)
    try:
        root = yaml.compose(text, Loader=_PlainLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        reason = " ".join(part for part in (error.context, error.problem) if part)
        place = f"{mark.line + 1}:{mark.column + 1}" if mark else "1:1"
        raise ConfigurationError(f"{path}:{place}: {reason}") from None
    except yaml.YAMLError as error:
        raise ConfigurationError(f"{path}:1:1: {' '.join(str(error).split())}") from None
    except RecursionError:
        raise ConfigurationError(f"{path}:1:1: nested too deeply") from None
    found = {} if root is None else reader.settings(root)
    if reader.problems:
        raise ConfigurationError("\n".join(reader.problems))
    return Configuration(**found)


class _PlainLoader(yaml.SafeLoader):
    """Composes trees of nodes: no node twice, none of a type of its own."""

    def compose_node(self, parent: yaml.Node | None, index: Any) -> yaml.Node | None:
        event: Any = self.peek_event()  # type: ignore[no-untyped-call]
        at: Any = event.start_mark
        if isinstance(event, yaml.AliasEvent):
            raise yaml.composer.ComposerError(None, None, f"an alias, `*{event.anchor}`: write the value out", at)
        if getattr(event, "tag", None) is not None:
            raise yaml.composer.ComposerError(None, None, f"a tag, `{event.tag}`: only plain values are allowed", at)
        return super().compose_node(parent, index)


class _Reader:
    """Turns nodes into settings and keeps what is wrong."""

    def __init__(self, path: str, checks: Collection[str]) -> None:
        self.path = path
        self.checks = checks
        self.problems: list[str] = []

    def settings(self, root: yaml.Node) -> dict[str, Any]:
        """The fields of a configuration."""
        known: dict[str, Callable[[yaml.Node], Any]] = {
            "checks": self._severities,
            "fail_on": lambda node: self._choice(node, THRESHOLDS),
            "ignore_paths": self._texts,
            "baseline": self._text,
            "launch": lambda node: tuple(filter(None, map(self._launch, self._items(node)))),
            "package_path": self._texts,
            "environment": lambda node: tuple((key.value, self._text(value, empty=True) or "") for key, value in self._pairs(node)),
        }
        return dict(self._known_keys(root, known, "setting"))

    def _known_keys(self, node: yaml.Node, known: dict[str, Callable[[yaml.Node], Any]], what: str) -> Iterator[tuple[str, Any]]:
        for key, value in self._pairs(node):
            if key.value in known:
                yield key.value, known[key.value](value)
            else:
                near = hint(key.value, known) or f", there are {', '.join(known)}"
                self._problem(key, f"unknown {what} `{key.value}`{near}")

    def _severities(self, node: yaml.Node) -> Severities:
        found = []
        for key, value in self._pairs(node):
            if unmatched([key.value], self.checks):
                wildcard = any(c in key.value for c in "*?[")
                told = f"no check matches `{key.value}`" if wildcard else f"unknown check `{key.value}`{hint(key.value, self.checks)}"
                self._problem(key, told)
            severity = self._choice(value, CHOICES)
            if severity is not None:
                found.append((key.value, severity))
        return tuple(found)

    def _launch(self, node: yaml.Node) -> LaunchChoice | None:
        """`FILE`, or a map of `files` and `arguments`."""
        at = Place(self.path, node.start_mark.line + 1, node.start_mark.column + 1)
        if isinstance(node, yaml.ScalarNode):
            file = self._text(node)
            return LaunchChoice((file,), (), at) if file else None
        known: dict[str, Callable[[yaml.Node], Any]] = {"files": self._texts, "arguments": self._arguments}
        parts = dict(self._known_keys(node, known, "key of a launch entry"))
        if isinstance(node, yaml.MappingNode) and "files" not in parts:
            self._problem(node, "a launch entry without `files`")
        return LaunchChoice(parts["files"], parts.get("arguments", ()), at) if parts.get("files") else None

    def _arguments(self, node: yaml.Node) -> tuple[tuple[str, tuple[str, ...]], ...]:
        return tuple((key.value, self._texts(value, empty=True)) for key, value in self._pairs(node))

    def _choice(self, node: yaml.Node, choices: Iterable[str]) -> str | None:
        text = self._text(node)
        if text is None or text in choices:
            return text
        self._problem(node, f"`{text}` is none of {', '.join(choices)}{hint(text, choices)}")
        return None

    def _texts(self, node: yaml.Node, *, empty: bool = False) -> tuple[str, ...]:
        """A text, or a list of them."""
        found = [self._text(item, empty=empty) for item in (self._items(node) if isinstance(node, yaml.SequenceNode) else [node])]
        return tuple(text for text in found if text is not None)

    def _text(self, node: yaml.Node, *, empty: bool = False) -> str | None:
        """A scalar as it is written, whatever YAML would make of it."""
        if not isinstance(node, yaml.ScalarNode):
            self._problem(node, f"a text is expected here, not a {_kind(node)}")
            return None
        if not (node.value or empty):
            self._problem(node, "a text is expected here, not nothing")
            return None
        return str(node.value)

    def _items(self, node: yaml.Node) -> list[yaml.Node]:
        if isinstance(node, yaml.SequenceNode) or _nothing(node):
            return list(node.value)
        self._problem(node, f"a list is expected here, not a {_kind(node)}")
        return []

    def _pairs(self, node: yaml.Node) -> Iterator[tuple[yaml.ScalarNode, yaml.Node]]:
        """The keys and values of a map, each key once."""
        if _nothing(node):
            return
        if not isinstance(node, yaml.MappingNode):
            self._problem(node, f"a map is expected here, not a {_kind(node)}")
            return
        seen: dict[str, int] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                self._problem(key, f"a text is expected here, not a {_kind(key)}")
            elif key.value in seen:
                self._problem(key, f"`{key.value}` stands here for the second time, first in line {seen[key.value]}")
            else:
                seen[key.value] = key.start_mark.line + 1
                yield key, value

    def _problem(self, node: yaml.Node, message: str) -> None:
        self.problems.append(f"{self.path}:{node.start_mark.line + 1}:{node.start_mark.column + 1}: {message}")


def _nothing(node: yaml.Node) -> bool:
    """Whether a value is left out, as where all of it is commented out."""
    return isinstance(node, yaml.ScalarNode) and not node.value and node.style is None


def _kind(node: yaml.Node) -> str:
    return {yaml.ScalarNode: "text", yaml.SequenceNode: "list"}.get(type(node), "map")
