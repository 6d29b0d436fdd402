"""Ports as Markdown tables, for documentation and pull requests."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rosarch.models.component import ComponentModel, Port
from rosarch.reports.labels import answer_label, flow_label, kind_label, sorted_ports
from rosarch.reports.printable import all_printable, code_span

_HEADER = "| kind | name | type | queue | callback | source |\n|---|---|---|---|---|---|"


def ports_text(models: Iterable[ComponentModel]) -> str:
    """One heading and one table per component."""
    return "\n".join(_component(all_printable(model)) for model in models)


def _component(model: ComponentModel) -> str:
    name = f", node name {code_span(model.node_name)}" if model.node_name and model.node_name != model.component else ""
    kind = f"node of {code_span(model.executable)}" if model.executable else f"{model.kind}{name}"
    head = f"## {_plain(f'{model.package}/{model.component}')} ({kind})\n"
    ports = sorted_ports(model)
    if not ports:
        return f"{head}\nNo ports.\n"
    return "\n".join([head, _HEADER, *map(_row, ports)]) + "\n"


def _row(port: Port) -> str:
    origin = f" from {code_span(port.from_param)}" if port.from_param else ""
    reason = f" ({_plain(port.unknown)})" if port.unknown else ""
    cells = (
        kind_label(port.kind) + (" (implicit)" if port.implicit else ""),
        f"{code_span(port.name)}{origin}{reason}",
        *map(_plain, (port.type or "?", flow_label(port), answer_label(port), str(port.at))),
    )
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _plain(text: str) -> str:
    return re.sub(r"[`<]", r"\\\g<0>", text)
