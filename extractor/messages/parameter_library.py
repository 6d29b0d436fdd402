"""C++ headers as generate_parameter_library would write them, from YAML files that are only read.

Source: https://github.com/PickNikRobotics/generate_parameter_library. A header declares `Params`, a structure of the parameters, and
`ParamListener`, which declares them at a node. It is made so that each parameter is declared in the line, and at the column, at which the
YAML file has it: what is reported about that place is reported about the YAML file, whose name is in the header's first comment.
"""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from rosarch.base.diagnostics import Diagnostic, unreadable
from rosarch.base.files import LARGEST_PARSED, path_text, read_file
from rosarch.base.yaml_loader import BoundedLoader
from rosarch.extractor.workspace.model import Package

_MADE_FROM = re.compile(rb"/\* made from (.+?) \*/")
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_NAMESPACE = re.compile(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*", re.ASCII)
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.ASCII | re.IGNORECASE)
_TYPES = {"bool": "bool", "int": "int64_t", "double": "double", "string": "std::string"}
_FIXED = re.compile(r"_fixed_\d+$")
_MAP = "__map_"
MAX_DEPTH = 50

_INTERFACE = "rclcpp::node_interfaces::NodeParametersInterface::SharedPtr"
_NODES = {
    f"const {_INTERFACE}& node": "node",
    f"const {_INTERFACE}& node, rclcpp::Logger": "node",
    "const rclcpp::Node::SharedPtr& node": "node->get_node_parameters_interface()",
    "const rclcpp_lifecycle::LifecycleNode::SharedPtr& node": "node->get_node_parameters_interface()",
}
# behind a pointer: whose parameters they are that a copy of the structure has makes no difference to the rules
_LISTENER = (
    " Params get_params() const { return *params_; } bool try_get_params(Params& params) const { params = *params_; return true; }"
    " bool is_old(const Params&) const; void refresh_dynamic_parameters(); private: Params* params_;"
)


@dataclass(frozen=True)
class ParameterHeaders:
    """The texts of headers, by the names that code includes them by, and what was wrong with their YAML files."""

    texts: dict[str, str] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()

    @classmethod
    def of(cls, packages: Iterable[Package], root: Path) -> ParameterHeaders:
        """What the packages, below `root`, generate."""
        texts: dict[str, str] = {}
        problems: list[Diagnostic] = []
        for package in packages:
            for name, path in package.parameter_files:
                body = _body(path, root, problems)
                if body is None:
                    continue
                inner = f"rosarch_parameters/{package.name}/{name}.hpp"
                headers = ("stdexcept", "rclcpp/rclcpp.hpp", "rclcpp_lifecycle/lifecycle_node.hpp", inner)
                text = "#pragma once\n" + "".join(f"#include <{header}>\n" for header in headers)
                texts |= {inner: body, f"{package.name}/{name}.hpp": text}
                texts.setdefault(f"{name}.hpp", text)
        return cls(texts, tuple(problems))


def made_from(header: bytes) -> str | None:
    """The file, relative to the root of the workspace, that the text of a header was made from, line by line."""
    match = _MADE_FROM.match(header)
    return match[1].decode() if match else None


def _body(path: Path, root: Path, problems: list[Diagnostic]) -> str | None:
    try:
        text = read_file(path, LARGEST_PARSED).decode("utf-8-sig")
        tree = yaml.compose(text, Loader=BoundedLoader)
    except OSError as error:
        problems.append(unreadable(path, error))
        return None
    except UnicodeDecodeError:
        problems.append(Diagnostic("encoding", path, 1, 1, "not UTF-8"))
        return None
    except (yaml.YAMLError, RecursionError) as error:
        mark = getattr(error, "problem_mark", None)
        line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
        problems.append(Diagnostic("parameter-file", path, line, column, getattr(error, "problem", None) or "nested too deep"))
        return None
    relative = path_text(path.relative_to(root)) if path.is_relative_to(root) else ""
    if not relative or "*/" in relative or "\n" in relative:
        return None
    spaces = list(_entries(tree))
    if len(spaces) != 1 or not _NAMESPACE.fullmatch(spaces[0][0].value) or not isinstance(spaces[0][1], yaml.MappingNode):
        problems.append(Diagnostic("parameter-file", path, 1, 1, "not a map of one name, the namespace, to parameters"))
        return None
    header = _Header(path, problems)
    members = header.members(spaces[0][1], (), 0)
    return header.text(relative, spaces[0][0].value, members)


def _entries(node: yaml.Node | None) -> Iterator[tuple[yaml.ScalarNode, yaml.Node]]:
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode):
                yield key, value


@dataclass
class _Header:
    """A header in the making: per line of the file, each parameter's column, what its value goes to, and the call that declares it."""

    path: Path
    problems: list[Diagnostic]
    statements: dict[int, list[tuple[int, str, str]]] = field(default_factory=lambda: defaultdict(list))

    def members(self, tree: yaml.Node, above: tuple[str, ...], depth: int) -> str:
        """The members of a structure for the parameters of `tree`, which is below the names `above`."""
        found = []
        for key, value in _entries(tree):
            names = (*above, key.value)
            described = {entry.value: given for entry, given in _entries(value)}
            if key.value.startswith(_MAP):
                found.append(self._structure(key.value, value, names, depth, mapped=True))
            elif isinstance(described.get("type"), yaml.ScalarNode):
                found.append(self._parameter(key, described, names))
            elif isinstance(value, yaml.MappingNode):
                found.append(self._structure(key.value, value, names, depth))
        return " ".join(member for member in found if member)

    def _structure(self, name: str, tree: yaml.Node, names: tuple[str, ...], depth: int, *, mapped: bool = False) -> str:
        name = name.removeprefix(_MAP)
        if not _NAME.fullmatch(name) or depth > MAX_DEPTH:
            return self._refuse(tree, f"`{name}` is no name of a parameter")
        title = ("Map" if mapped else "") + "".join(part.capitalize() for part in name.split("_"))
        members = self.members(tree, names, depth + 1)
        variable = f"std::map<std::string, {title}> {name}_map;" if mapped else f"{name};"
        return f"struct {title} {{ {members} }}{';' if mapped else ''} {variable}"

    def _parameter(self, key: yaml.ScalarNode, described: dict[str, yaml.Node], names: tuple[str, ...]) -> str:
        kind = _FIXED.sub("", described["type"].value)
        if kind == "none":
            return ""
        item = _TYPES.get(kind.removesuffix("_array"))
        if item is None or not _NAME.fullmatch(key.value):
            return self._refuse(key, f"unknown type {described['type'].value}" if item is None else f"`{key.value}` is no name")
        type_ = f"std::vector<{item}>" if kind.endswith("_array") else item
        default = _literal(described["default_value"], item) if "default_value" in described else None
        given = f", {type_}({default})" if default is not None and type_ != item else f", {default}" if default is not None else ""
        begin, target, text, end, joint = "", "params_->", "prefix", "", ""
        for index, name in enumerate(names):
            if name.startswith(_MAP):  # an entry for each value of the parameter that it is called after
                keys = name.removeprefix(_MAP)
                begin += f"for (const auto& {keys}_key : params_->{keys}) {{ "
                end += " }"
                target += f"{keys}_map[{keys}_key]."
                text += f' + "{joint}" + {keys}_key'
                joint = "."
            else:
                target += f"{name}."
                joint += f"{name}{'.' if index + 1 < len(names) else ''}"
        text += f' + "{joint}"'
        told = kind if kind in _TYPES and kind != "string" else type_
        line, column = key.start_mark.line, key.start_mark.column
        declares = f"node->declare_parameter<{told}>({text}{given});"
        refused = [] if begin else list(_refused(described.get("validation"), item, is_list=type_ != item))
        if refused:
            checks = "".join(f' if ({condition.replace("?", "given")}) throw std::invalid_argument("");' for condition in refused)
            self.statements[line].append((column, f"{{ const {type_} given =", f"{declares} {target[:-1]} = given;{checks} }}"))
        else:
            self.statements[line].append((column, f"{begin}{target[:-1]} =", f"{declares}{end}"))
        return f"{type_} {key.value};"

    def _refuse(self, node: yaml.Node, text: str) -> str:
        self.problems.append(Diagnostic("parameter-file", self.path, node.start_mark.line + 1, node.start_mark.column + 1, text))
        return ""

    def text(self, relative: str, namespace: str, members: str) -> str:
        """The header; its first line has all that the YAML file has no line for."""
        makers = "".join(
            f' ParamListener({node}) {{ declare({given}, ""); }}'
            f' ParamListener({node}, const std::string& prefix) {{ declare({given}, prefix + "."); }}'
            for node, given in _NODES.items()
        )
        lines = [
            f"/* made from {relative} */ namespace {namespace} {{ struct Params {{ {members} }};"
            f" class ParamListener {{ public:{makers}{_LISTENER} void declare(const {_INTERFACE}& node, const std::string& prefix) {{"
        ]
        for number in range(max(self.statements, default=0) + 1):
            if number > 0:
                lines.append("")
            for index, (column, target, call) in enumerate(self.statements.get(number, ())):
                before = -1 if index or not number else -2  # what the value goes to stands before the place that is reported
                lines[before] += f" {target}"
                lines[-1] = f"{lines[-1].ljust(column)}{call}" if before == -2 else f"{lines[-1]} {call}"
        return "\n".join([*lines, "} }; }", ""])


_COMPARED = {"lt": (">=",), "gt": ("<=",), "lt_eq": (">",), "gt_eq": ("<",), "bounds": ("<", ">")}
_SIZED = {"fixed_size": "!=", "size_gt": "<=", "size_lt": ">="}


def _refused(validation: yaml.Node | None, item: str, *, is_list: bool) -> Iterator[str]:
    """The conditions on a value, `?`, under which the validators reject it; those of own validators and of elements are not given."""
    for key, value in _entries(validation):
        name, listed = key.value.removesuffix("<>"), value.value if isinstance(value, yaml.SequenceNode) else [value]
        if name in _SIZED and is_list and len(listed) == 1 and (number := _number(listed[0])):
            yield f"?.size() {_SIZED[name]} {number}"
        elif name == "not_empty" and is_list:
            yield "?.size() == 0"
        elif name in _COMPARED and not is_list and item in ("int64_t", "double"):
            for operator, given in zip(_COMPARED[name], listed, strict=False):
                if number := _number(given):
                    yield f"? {operator} {number}"
        elif name == "one_of" and not is_list and item == "std::string" and len(listed) == 1 and isinstance(listed[0], yaml.SequenceNode):
            yield " && ".join(f"? != {json.dumps(text.value)}" for text in listed[0].value if isinstance(text, yaml.ScalarNode))


def _number(node: yaml.Node) -> str | None:
    return node.value if isinstance(node, yaml.ScalarNode) and _NUMBER.fullmatch(node.value) else None


def _literal(node: yaml.Node, item: str) -> str | None:
    """A default as C++ has it; None when it is none of its type."""
    if isinstance(node, yaml.SequenceNode):
        values = [_literal(value, item) for value in node.value]
        return None if None in values else f"{{{', '.join(value for value in values if value is not None)}}}"
    if not isinstance(node, yaml.ScalarNode):
        return None
    if item == "std::string":
        return json.dumps(node.value)
    if item == "bool":
        return node.value.lower() if node.value.lower() in ("true", "false") else None
    return node.value if _NUMBER.fullmatch(node.value) else None
