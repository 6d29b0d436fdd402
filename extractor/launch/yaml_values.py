"""YAML as `<rosparam>` reads it: plain data, and angles (`rad(pi/2)`, `deg(90)`, `!radians`, `!degrees`).

The loader is PyYAML's safe one, so a tag makes no object. A small text may use an alias any number of times, so what aliases unfold
to is counted, not what is written. Sources: roslaunch.loader, rosparam (angles, `!!binary`).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import yaml

from rosarch.base.yaml_loader import BoundedLoader
from rosarch.extractor.launch.evaluation import EvalFailed, Unsupported, radians
from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.values import Binary

MAX_VALUES = 1_000_000  # scalars, lists and maps of one document after aliases are unfolded
_MERGE = "tag:yaml.org,2002:merge"  # of the key `<<`
_ESCAPED_MARK = re.compile(r"\\U0010[0-9A-Fa-f]{4}")  # would pose as an unknown (see unknowns.py)
_MAX_MERGED = 100_000  # keys that `<<` adds to the maps of one document


class YamlError(Exception):
    """A text that is no YAML for parameters; `line` and `column` count from 1 within the text."""

    def __init__(self, message: str, line: int = 1, column: int = 1) -> None:
        super().__init__(message)
        self.message, self.line, self.column = message, line, column


KeyLines = Mapping[tuple[str, ...], int]


class Loader(BoundedLoader):
    """The safe loader, which makes no objects, with a bound on what `<<` merges."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._merged = 0

    def flatten_mapping(self, node: yaml.MappingNode) -> None:
        written = sum(key.tag != _MERGE for key, _ in node.value)
        super().flatten_mapping(node)
        self._merged += len(node.value) - written
        if self._merged > _MAX_MERGED:
            raise yaml.constructor.ConstructorError(None, None, f"more than {_MAX_MERGED} merged keys", node.start_mark)


class RepeatedKeysLoader(Loader):
    """The loader of files in which a key may stand several times: their maps are one."""

    def flatten_mapping(self, node: yaml.MappingNode) -> None:
        super().flatten_mapping(node)
        kept: dict[str, yaml.MappingNode] = {}
        pairs = []
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode) and isinstance(value, yaml.MappingNode):
                if key.value in kept:
                    kept[key.value].value = [*kept[key.value].value, *value.value]
                    continue
                kept[key.value] = value
            pairs.append((key, value))
        node.value = pairs


class RosparamLoader(Loader):
    """The loader of rosparam, with its angles and binaries."""


def load_yaml(text: str, loader_class: type[Loader] = RosparamLoader) -> Any:
    """The value of a document. See `load_yaml_lines`."""
    return load_yaml_lines(text, loader_class)[0]


def load_yaml_lines(text: str, loader_class: type[Loader] = RosparamLoader) -> tuple[Any, KeyLines]:
    """The value of a document, and the line that each key of its maps stands on, by the keys that lead there.

    Raises:
        YamlError: the text is not YAML, has a tag that makes an object, or unfolds to too much.
    """
    with opened(text, loader_class) as (loader, node):
        return constructed(loader, node), _key_lines(node)


@contextmanager
def opened(text: str, loader_class: type[Loader]) -> Iterator[tuple[Loader, yaml.Node | None]]:
    """A loader, and the root of a document as it is written, None of an empty one.

    Raises:
        YamlError: the text is not YAML, or what is made of it meanwhile is rejected.
    """
    try:
        loader = loader_class(_ESCAPED_MARK.sub(r"\\uFFFD", text))
        try:
            yield loader, loader.get_single_node()
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        reason = " ".join(part for part in (error.context, error.problem) if part)
        raise YamlError(reason, mark.line + 1 if mark else 1, mark.column + 1 if mark else 1) from None
    except yaml.YAMLError as error:
        raise YamlError(" ".join(str(error).split())) from None
    except RecursionError:
        raise YamlError("nested too deeply") from None
    except (ValueError, LookupError, TypeError, OverflowError) as error:  # e.g. the date 2000-99-99
        raise YamlError(str(error)) from None


def constructed(loader: Loader, node: yaml.Node | None) -> Any:
    """The value of a node of an `opened` document.

    Raises:
        YamlError: aliases unfold to too much.
    """
    value = None if node is None else loader.construct_document(node)
    _check_size(value)
    return value


def place_of(node: yaml.Node, path: str) -> Place:
    """Where a node of a YAML file begins."""
    return Place(path, node.start_mark.line + 1, node.start_mark.column + 1)


def _key_lines(document: yaml.Node | None) -> dict[tuple[str, ...], int]:
    """The line of each key. What an alias stands for is counted once, where it is first reached."""
    lines: dict[tuple[str, ...], int] = {}
    seen: set[int] = set()
    stack: list[tuple[tuple[str, ...], yaml.Node]] = [((), document)] if document is not None else []
    while stack:
        path, node = stack.pop()
        if not isinstance(node, yaml.MappingNode) or id(node) in seen:
            continue
        seen.add(id(node))
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode):
                lines.setdefault((*path, key.value), key.start_mark.line + 1)
                stack.append(((*path, key.value), value))
    return lines


def _radians(loader: RosparamLoader, node: yaml.Node) -> float:
    text = str(loader.construct_scalar(node)).strip()  # type: ignore[arg-type]
    expression = text[4:-1] if text.startswith("rad(") else text
    try:
        return radians(expression)
    except (EvalFailed, Unsupported):
        raise yaml.constructor.ConstructorError(None, None, f"invalid radian expression: {text}", node.start_mark) from None


def _degrees(loader: RosparamLoader, node: yaml.Node) -> float:
    text = str(loader.construct_scalar(node))  # type: ignore[arg-type]
    number = text.strip()[4:-1] if text.startswith("deg(") else text
    try:
        return float(number) * math.pi / 180.0
    except ValueError:
        raise yaml.constructor.ConstructorError(None, None, f"invalid degree value: {text}", node.start_mark) from None


def _binary(loader: RosparamLoader, node: yaml.Node) -> Binary:
    return Binary(loader.construct_yaml_binary(node))  # type: ignore[arg-type]


for _tag, _constructor in (("!radians", _radians), ("!degrees", _degrees), ("tag:yaml.org,2002:binary", _binary)):
    RosparamLoader.add_constructor(_tag, _constructor)
for _tag, _name in (("!degrees", "deg"), ("!radians", "rad")):
    RosparamLoader.add_implicit_resolver(_tag, re.compile(rf"^{_name}\([^\)]*\)$"), list(_name + "("))


def _check_size(value: Any) -> None:
    """Reject what aliases unfold to more than `MAX_VALUES`, or to something without end."""
    sizes: dict[int, int] = {}
    opened: set[int] = set()

    def size(item: Any) -> int:
        if not isinstance(item, (dict, list, set, tuple)):
            return 1
        if id(item) in opened:
            raise YamlError("a value that contains itself")
        if id(item) not in sizes:
            opened.add(id(item))
            sizes[id(item)] = 1 + sum(map(size, item.values() if isinstance(item, Mapping) else item))
            opened.discard(id(item))
        return sizes[id(item)]

    try:
        if size(value) > MAX_VALUES:
            raise YamlError(f"more than {MAX_VALUES} values when aliases are unfolded")
    except RecursionError:
        raise YamlError("nested too deeply") from None
