"""What a launch file starts and sets, for people."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from rosarch.extractor.launch import Composition, Condition, NodeStart, ParamSetting, Place, record
from rosarch.extractor.launch.record import plain
from rosarch.reports.labels import counted
from rosarch.reports.printable import json_text

MAX_VALUE = 60  # characters of a value that are shown


def composition_json(composition: Composition) -> str:
    """The record of a composition."""
    return json_text(record(composition))


def overview_json(compositions: Mapping[str, Composition]) -> str:
    """The records of several launch files, each started by itself."""
    records = [{"file": path, **record(composition)} for path, composition in compositions.items()]
    return json_text(records)


def overview_text(compositions: Mapping[str, Composition], base: Path) -> str:
    """A line per launch file: how much it starts and sets, and what the launch tool would stop at."""
    rows = [
        (_shown(path, base), counted(len(found.nodes), "node"), counted(len(found.params), "parameter"), found.refusal)
        for path, found in compositions.items()
    ]
    widths = [max(len(str(row[column])) for row in rows) for column in range(3)]
    lines = []
    for *texts, refusal in rows:
        cells = [f"{text!s:{width}}" for text, width in zip(texts, widths, strict=True)]
        lines.append("  ".join([*cells, f"refused: {refusal.message}" if refusal else ""]))
    refused = sum(1 for row in rows if row[3])
    lines += ["", f"{counted(len(rows), 'launch file')} that no other includes, {refused} of them refused with their default arguments"]
    return "".join(line.rstrip() + "\n" for line in lines)


def composition_text(composition: Composition, base: Path) -> str:
    """A paragraph per node with what it is given and the launch lines that start it, then the parameters that are no node's."""
    started = (*composition.nodes, *composition.tests)
    owned: dict[str, list[ParamSetting]] = {node.full_name: [] for node in started}
    shared: list[ParamSetting] = []
    for setting in composition.params:
        owned.get(_owner(setting.name, owned), shared).append(setting)
    width = max((len(_header(node)[0]) for node in started), default=0)
    names = Counter(node.full_name for node in started)
    paragraphs = [
        _node_text(node, node.own_params if node.ros == 2 and names[node.full_name] > 1 else owned[node.full_name], width, base)
        for node in started
    ]
    if shared:
        paragraphs.append("parameters\n" + "".join(f"  {_param_text(setting, setting.name)}\n" for setting in shared))
    missing = _missing(composition, base)
    if missing:
        paragraphs.append("not read\n" + "".join(f"  {line}\n" for line in missing))
    return "\n".join([*paragraphs, summary_line(composition, base)])


def _missing(composition: Composition, base: Path) -> list[str]:
    """What would start or set more, but is not there or not known."""
    missing = [(f"include {include.text}", include.lines) for include in composition.includes if not include.file]
    what = "rosparam" if composition.ros == 1 else "parameters"
    missing += [(f"{what} {setting.name} of {setting.source}", setting.lines) for setting in composition.unread]
    return [f"{_shown(text, base)}  from  {_chain(lines, base)}" for text, lines in missing]


def summary_line(composition: Composition, base: Path) -> str:
    """How much there is, and what the launch tool would stop at."""
    counts = [counted(len(composition.nodes), "node")]
    if composition.tests:
        counts.append(counted(len(composition.tests), "test"))
    counts += [counted(len(composition.params), "parameter"), counted(len(composition.files), "launch file")]
    line = ", ".join(counts) + "\n"
    if composition.refusal:
        tool = "roslaunch" if composition.ros == 1 else "ros2 launch"
        line += f"{tool} would refuse this: {_shown(str(composition.refusal), base)}\n"
    return line


def _header(node: NodeStart) -> tuple[str, str]:
    kind = f"{node.package}/{node.type}"
    return node.full_name, f"{kind} (test {node.test_name})" if node.test_name else kind


def _node_text(node: NodeStart, params: Iterable[ParamSetting], width: int, base: Path) -> str:
    name, kind = _header(node)
    lines = [f"{name:{width}}  {kind}"]
    lines += [f"  {label:6}  {text}" for label, text in _details(node, params)]
    lines.append(f"  {'from':6}  {_chain(node.lines, base)}")
    return "".join(line.rstrip() + "\n" for line in lines)


def _details(node: NodeStart, params: Iterable[ParamSetting]) -> Iterable[tuple[str, str]]:
    if node.name is None and node.called is not None:
        yield "name", "not given here: its code decides"
    if node.conditions:
        yield "only", _conditions(node.conditions)
    if node.args:
        yield "args", _printable(node.args)
    for remap in node.own_remaps:
        when = f"  {_conditions(remap.conditions)}" if remap.conditions else ""
        yield "remap", f"{remap.source} -> {remap.target}{when}"
    for setting in params:
        yield "param", _param_text(setting, "~" + setting.name[len(node.full_name) + 1 :], known=node.conditions)
    flags = [flag for flag, is_set in (("respawn", node.respawn), ("required", node.required)) if is_set]
    if node.machine:
        flags.append(f"on machine {node.machine}")
    if flags:
        yield "run", ", ".join(flags)


def _owner(name: str, nodes: Iterable[str]) -> str:
    """The node that a parameter is private to, as its name says."""
    known = nodes if isinstance(nodes, dict) else set(nodes)
    while name.count("/") > 1:
        name = name.rpartition("/")[0]
        if name in known:
            return name
    return ""


def _param_text(setting: ParamSetting, name: str, known: tuple[Condition, ...] = ()) -> str:
    more = tuple(condition for condition in setting.conditions if condition not in known)
    return f"{name}={_value(plain(setting.value))}" + (f"  {_conditions(more)}" if more else "")


def _conditions(conditions: Iterable[Condition]) -> str:
    return " and ".join(map(str, conditions))


def _value(value: object) -> str:
    return _one_line(value if isinstance(value, str) else json.dumps(value, ensure_ascii=False))


def _one_line(text: str) -> str:
    """`text` without control characters and not longer than a line has room for."""
    line = " ".join(_printable(text[: 4 * MAX_VALUE]).split())
    return line if len(line) <= MAX_VALUE and len(text) <= 4 * MAX_VALUE else line[: MAX_VALUE - 3] + "..."


def _printable(text: str) -> str:
    return "".join(character if character.isprintable() else " " for character in text)


def _chain(lines: Iterable[Place], base: Path) -> str:
    return _shown(" > ".join(map(str, lines)), base)


def _shown(text: str, base: Path) -> str:
    return text.replace(f"{base}{os.sep}", "")
