"""Values of parameters as rcl reads them, whatever the YAML of Python makes of them: in files, and of what launch_ros writes for a node.

Source: rcl_yaml_param_parser (parse.c): a plain scalar is a Boolean, an integer or a double when it looks like one to C, else a text; tags
count for nothing but `!!str`. A list within a list takes its place. Of what a launch file gives, launch_ros writes a file by
PyYAML, which quotes what would be another type to itself: `1e5` and `y` it leaves as they are, and they arrive as a double and a Boolean.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from typing import Any

import yaml

from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch.yaml_values import RepeatedKeysLoader, YamlError, load_yaml

_TEXT = "tag:yaml.org,2002:str"
_TAGS = {name: f"tag:yaml.org,2002:{name}" for name in ("bool", "int", "float", "null", "timestamp")}
SCALARS = (
    ("Booleans", "bool", re.compile(r"y|Y|yes|Yes|YES|n|N|no|No|NO|true|True|TRUE|false|False|FALSE|on|On|ON|off|Off|OFF")),
    ("integers", "int", re.compile(r"[-+]?(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*)")),
    ("doubles", "float", re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")),
    # what strtod of C reads, too
    ("doubles", "float", re.compile(r"[-+]?(inf(inity)?|nan|0x([0-9a-f]+\.?[0-9a-f]*|\.[0-9a-f]+)(p[-+]?[0-9]+)?)", re.IGNORECASE)),
)
"""The types of plain scalars: what they are called, the name in YAML, their form."""
_TRUE = frozenset({"y", "yes", "true", "on"})
_tag_of: Callable[..., str] = yaml.resolver.Resolver().resolve


def scalar(text: str) -> Any:
    """The value of a plain scalar."""
    kind = next((name for _, name, form in SCALARS if form.fullmatch(text)), "")
    if kind == "bool":
        return text.lower() in _TRUE
    if kind == "int":
        digits = text.lstrip("+-")
        value = int(digits, 16 if digits[1:2] in ("x", "X") else 8 if digits.startswith("0") else 10)
        value = -value if text.startswith("-") else value
        return value if -(1 << 63) <= value < 1 << 63 else float(value)
    return _double(text) if kind == "float" else text


def _double(text: str) -> float | str:
    """What C reads as a double; one that is too large or too small for it to be exact stays a text."""
    lower = text.lower()
    value = float.fromhex(text) if "x" in lower else float(lower.replace(".inf", "inf").replace(".nan", "nan"))
    named = "inf" in lower or "nan" in lower
    mantissa = lower.partition("p" if "x" in lower else "e")[0].lstrip("+-").removeprefix("0x")
    is_zero = not mantissa.strip("0.")
    return value if named or is_zero or sys.float_info.min <= abs(value) <= sys.float_info.max else text


class RclLoader(RepeatedKeysLoader):
    """The loader of files of parameters."""

    def flatten_mapping(self, node: yaml.MappingNode) -> None:
        """Keys are texts."""
        super().flatten_mapping(node)
        for key, _ in node.value:
            if isinstance(key, yaml.ScalarNode):
                key.tag = _TEXT

    def typed(self, node: yaml.ScalarNode) -> Any:
        """A scalar that is not certainly a text."""
        return node.value if node.style else scalar(node.value)

    def list_of(self, node: yaml.SequenceNode) -> Any:
        """A list, or the one that it ends with."""
        outer: set[int] = set()
        while id(node) not in outer and node.value and isinstance(node.value[-1], yaml.SequenceNode):
            outer.add(id(node))
            node = node.value[-1]
        return self.construct_yaml_seq(node)


RclLoader.yaml_implicit_resolvers = {None: [(_TAGS[name], re.compile(rf"(?:{form.pattern})\Z", form.flags)) for _, name, form in SCALARS]}
for _tag in _TAGS.values():
    RclLoader.add_constructor(_tag, RclLoader.typed)
RclLoader.add_constructor("tag:yaml.org,2002:seq", RclLoader.list_of)


def read(text: str) -> Any:
    """What a node is given as `-p name:=text`."""
    try:
        return load_yaml(text, RclLoader)
    except YamlError:
        return text


def written(value: Any) -> Any:
    """A value that launch_ros writes into a file for a node, as it arrives there."""
    if isinstance(value, (list, tuple)):
        return [written(item) for item in value]
    if isinstance(value, str) and is_known(value) and _tag_of(yaml.ScalarNode, value, (True, False)) == _TEXT:
        return scalar(value)
    return value


def shown(value: Any) -> Any:
    """A value that launch_ros hands to a node as Python writes it: a list as the text of a tuple."""
    if isinstance(value, str) and not is_known(value):
        return value
    return read(str(tuple(value) if isinstance(value, list) else value))
