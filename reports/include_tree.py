"""The launch files of a system with what they include and start: as text, as JSON, for Graphviz."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from importlib.resources import files
from typing import Any

from rosarch.models.system.inclusions import LaunchFile, include_tree
from rosarch.models.system.model import SystemModel, SystemNode
from rosarch.reports.graph_dot import quoted
from rosarch.reports.labels import counted
from rosarch.reports.printable import json_text, printable

NOT_THERE, CUT = "not there", "not told again"


def trees_text(systems: Iterable[SystemModel]) -> str:
    """A tree for each system: a line for every include and every node, with its line in the file."""
    return "\n".join("".join(f"{line}\n" for line in _text(system)) for system in systems)


def _text(system: SystemModel) -> Iterator[str]:
    roots = include_tree(system)
    for root in roots:
        yield printable(root.text)
        yield from _inside(root, "")
    found = {file.path for root in roots for file in _all(root) if file.path}
    yield f"{counted(len(found), 'launch file')}, {counted(len(system.nodes), 'node')}"


def _inside(file: LaunchFile, indent: str) -> Iterator[str]:
    entries = _entries(file)
    width = max((len(str(line)) for line, _ in entries), default=0)
    for number, (line, entry) in enumerate(entries, 1):
        last = number == len(entries)
        label = _file_text(entry) if isinstance(entry, LaunchFile) else _node_text(entry)
        yield f"{indent}{'└── ' if last else '├── '}{line:>{width}} {label}"
        if isinstance(entry, LaunchFile):
            yield from _inside(entry, indent + ("    " if last else "│   "))


def _entries(file: LaunchFile) -> list[tuple[int, LaunchFile | SystemNode]]:
    """What is in a file, in the order of its lines."""
    includes: list[tuple[int, LaunchFile | SystemNode]] = [(inner.at.line, inner) for inner in file.includes if inner.at]
    return sorted([*includes, *((node.lines[-1].line, node) for node in file.starts)], key=lambda entry: entry[0])


def _file_text(file: LaunchFile) -> str:
    if file.path is None:
        return printable(f"{file.text}  {NOT_THERE}")
    return printable(f"{file.path}  {CUT}" if file.cut else file.path)


def _node_text(node: SystemNode) -> str:
    words = f"  if {' and '.join(node.conditions)}" if node.conditions else ""
    return printable(f"{node.name}  ({node.package}/{node.type}){words}")


def trees_json(systems: Iterable[SystemModel]) -> str:
    """An array of systems with their trees."""
    return json_text([tree_data(system) for system in systems])


def tree_schema() -> Any:
    """The JSON Schema of one system's tree."""
    return json.loads(files("rosarch.reports").joinpath("schema/includes.schema.json").read_text(encoding="utf-8"))


def tree_data(system: SystemModel) -> dict[str, Any]:
    """The tree of one system."""
    return {"system": system.name, "launch": list(system.launch), "files": [_file_data(root) for root in include_tree(system)]}


def _file_data(file: LaunchFile) -> dict[str, Any]:
    return {
        "file": file.path,
        "text": file.text,
        "at": None if file.at is None else str(file.at),
        "cut": file.cut,
        "nodes": [
            {"name": n.name, "package": n.package, "type": n.type, "conditions": list(n.conditions), "at": str(n.lines[-1])}
            for n in file.starts
        ],
        "includes": [_file_data(inner) for inner in file.includes],
    }


def tree_dot(system: SystemModel) -> str:
    """One graph: each launch file once, with an arrow for every line that includes it, and the nodes that it starts."""
    roots = include_tree(system)
    shown = list(dict.fromkeys(file for root in roots for file in _all(root)))
    lines: dict[str, None] = {}
    for file in shown:
        style = 'shape=note, style="dashed", color="#b03a2e"' if file.path is None else "shape=note"
        lines[f"  {_id(file)} [label={quoted([printable(file.path or file.text)])}, {style}];"] = None
        for node in file.starts:
            name = quoted([f"node:{printable(node.name)}"])
            style = ', style="dashed"' if node.origin == "unknown" else ""
            lines[f"  {name} [label={quoted([printable(node.name)])}, shape=ellipse{style}];"] = None
            dashed = ", style=dashed" if node.conditions else ""
            lines[f'  {_id(file)} -> {name} [label="{node.lines[-1].line}", arrowhead=none{dashed}];'] = None
        for inner in file.includes:
            if inner.at:
                lines[f'  {_id(file)} -> {_id(inner)} [label="{inner.at.line}"];'] = None
    head = [
        f"digraph {quoted([printable(system.name)])} {{",
        "  rankdir=LR; nodesep=0.1; fontname=Helvetica;",
        "  node [fontname=Helvetica, fontsize=11, height=0.3]; edge [fontname=Helvetica, fontsize=9, arrowsize=0.7];",
    ]
    return "\n".join([*head, *lines, "}"]) + "\n"


def _id(file: LaunchFile) -> str:
    return quoted([printable(f"file:{file.path}" if file.path else f"missing:{file.text}")])


def _all(file: LaunchFile) -> Iterator[LaunchFile]:
    yield file
    for inner in file.includes:
        yield from _all(inner)
