"""`.rosarch.yml`, which may come from anyone: it is read as plain YAML."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from typing import Any

import yaml

from rosarch.base.hints import hint
from rosarch.base.plain_yaml import YamlError, YamlReader, compose
from rosarch.findings.configuration import Configuration, LaunchChoice, RateGiven
from rosarch.findings.policy import CHOICES, THRESHOLDS, Severities, unmatched


class ConfigurationError(Exception):
    """A configuration that is not as it should be: one line for each thing that is wrong, `path:line:col: message`."""


def read_configuration(text: str, path: str, checks: Collection[str]) -> Configuration:
    """The configuration in a text; `path` is what messages call the file, `checks` are the ids of all checks.

    Raises:
        ConfigurationError: something in it is wrong; all errors are reported.
    """
    reader = _Reader(path, checks)
    try:
        root = compose(text, path)
    except YamlError as error:
        raise ConfigurationError(str(error)) from None
    found = {} if root is None else reader.settings(root)
    if reader.problems:
        raise ConfigurationError("\n".join(reader.problems))
    return Configuration(**found)


class _Reader(YamlReader):
    """Turns nodes into settings."""

    def __init__(self, path: str, checks: Collection[str]) -> None:
        super().__init__(path)
        self.checks = checks

    def settings(self, root: yaml.Node) -> dict[str, Any]:
        """The fields of a configuration."""
        known: dict[str, Callable[[yaml.Node], Any]] = {
            "checks": self._severities,
            "fail_on": lambda node: self.choice(node, THRESHOLDS),
            "ignore_paths": self.texts,
            "baseline": self.text,
            "launch": lambda node: tuple(filter(None, map(self._launch, self.items(node)))),
            "package_path": self.texts,
            "environment": lambda node: tuple((key.value, self.text(value, empty=True) or "") for key, value in self.pairs(node)),
            "rates": lambda node: tuple(filter(None, (self._rate(key, value) for key, value in self.pairs(node)))),
        }
        return dict(self.known_keys(root, known, "setting"))

    def _rate(self, topic: yaml.ScalarNode, node: yaml.Node) -> RateGiven | None:
        """`TOPIC: HZ`, or `TOPIC: [LEAST, MOST]`."""
        if not topic.value.startswith("/"):
            self.problem(topic, f"the name of a topic begins with `/`, not `{topic.value}`")
            return None
        ends = [self._hertz(end) for end in (node.value if isinstance(node, yaml.SequenceNode) else [node])]
        low, high = ends[0] if ends else None, ends[-1] if ends else None
        if low is None or high is None or len(ends) > 2:
            if len(ends) not in (1, 2):
                self.problem(node, "a rate is a number, or two: the least and the most")
            return None
        if low > high:
            self.problem(node, f"the least rate, {low:g}, is more than the most, {high:g}")
            return None
        return RateGiven(topic.value, low, high, self.place(topic))

    def _hertz(self, node: yaml.Node) -> float | None:
        text = self.text(node)
        try:
            number = float(text or "")
        except ValueError:
            number = -1.0
        if text is not None and not 0 <= number < math.inf:
            self.problem(node, f"`{text}` is no number of messages a second")
        return number if 0 <= number < math.inf else None

    def _severities(self, node: yaml.Node) -> Severities:
        found = []
        for key, value in self.pairs(node):
            if unmatched([key.value], self.checks):
                wildcard = any(c in key.value for c in "*?[")
                told = f"no check matches `{key.value}`" if wildcard else f"unknown check `{key.value}`{hint(key.value, self.checks)}"
                self.problem(key, told)
            severity = self.choice(value, CHOICES)
            if severity is not None:
                found.append((key.value, severity))
        return tuple(found)

    def _launch(self, node: yaml.Node) -> LaunchChoice | None:
        """`FILE`, or a map of `files` and `arguments`."""
        at = self.place(node)
        if isinstance(node, yaml.ScalarNode):
            file = self.text(node)
            return LaunchChoice((file,), (), at) if file else None
        known: dict[str, Callable[[yaml.Node], Any]] = {"files": self.texts, "arguments": self._arguments}
        parts = dict(self.known_keys(node, known, "key of a launch entry"))
        if isinstance(node, yaml.MappingNode) and "files" not in parts:
            self.problem(node, "a launch entry without `files`")
        return LaunchChoice(parts["files"], parts.get("arguments", ()), at) if parts.get("files") else None

    def _arguments(self, node: yaml.Node) -> tuple[tuple[str, tuple[str, ...]], ...]:
        return tuple((key.value, self.texts(value, empty=True)) for key, value in self.pairs(node))
