"""Component models as tables for a terminal, a pipe or a file."""

from __future__ import annotations

import io
from collections.abc import Iterable
from pathlib import PurePosixPath

from rich.console import Console
from rich.measure import Measurement
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from rosarch.models.component import ComponentModel, Port
from rosarch.reports.labels import answer_label, flow_label, kind_label, parameter_labels, sorted_ports
from rosarch.reports.printable import all_printable

_STYLES = {
    "publisher": "green",
    "subscriber": "cyan",
    "service_server": "magenta",
    "service_client": "magenta",
    "action_server": "yellow",
    "action_client": "yellow",
}
_UNLIMITED = 10_000
_INDENT = (0, 0, 0, 2)


def models_text(models: Iterable[ComponentModel], *, parameters: bool, terminal: bool) -> str:
    """A header and a table per component: fitted to the terminal, or uncoloured with one line per port."""
    buffer = io.StringIO()
    width = None if terminal else _UNLIMITED
    console = Console(file=buffer, force_terminal=terminal, no_color=None if terminal else True, width=width, highlight=False)
    for model in models:
        _print_model(console, all_printable(model), parameters)
    return "".join(f"{line.rstrip()}\n" for line in buffer.getvalue().splitlines())


def _print_model(console: Console, model: ComponentModel, parameters: bool) -> None:
    folder = _common_folder(model)
    ports = sorted_ports(model)
    console.print(_header(model, folder), overflow="fold")
    if not ports:
        console.print(Padding(Text("no ports", style="dim"), _INDENT))
    elif _fits(console, table := _table(ports, folder)):
        console.print(table)
    else:
        for port in ports:
            console.print(Padding(_stacked(port, folder), _INDENT))
    names = parameter_labels(model) if parameters else []
    if names:
        console.print(Padding(Text.assemble(("parameters  ", "dim"), "  ".join(names), overflow="fold"), _INDENT))
    console.print()


def _header(model: ComponentModel, folder: str) -> Text:
    name = f"node {model.node_name}" if model.kind == "node" and model.node_name else model.kind
    name = f"node of {model.executable}" if model.executable else name
    return Text.assemble((f"{model.package}/{model.component}", "bold"), f"  {name}", (f"  {folder}" if folder else "", "dim"))


def _common_folder(model: ComponentModel) -> str:
    """The folder that all ports' sources lie below, `""` for the workspace itself."""
    folders = [PurePosixPath(port.at.path).parent.parts for port in model.ports]
    common: list[str] = []
    for parts in zip(*folders, strict=False):
        if len(set(parts)) > 1:
            break
        common.append(parts[0])
    return "".join(f"{part}/" for part in common)


def _fits(console: Console, table: Table) -> bool:
    return Measurement.get(console, console.options.update(width=_UNLIMITED), table).maximum <= console.width


def _table(ports: Iterable[Port], folder: str) -> Table:
    table = Table(box=None, show_header=False, padding=(0, 2, 0, 0), pad_edge=False)
    for _column in range(7):
        table.add_column(no_wrap=True)
    for port in ports:
        cells = map(Text, (port.type or "?", _flow(port), answer_label(port), _source(port, folder)))  # plain text would be markup
        table.add_row("", _kind(port), _name(port), *cells, style="dim" if port.implicit else None)
    return table


def _stacked(port: Port, folder: str) -> Text:
    """A port on several short lines, for narrow terminals."""
    details = " ".join(filter(None, (port.type or "?", _flow(port), answer_label(port))))
    lines = (Text.assemble(_kind(port), " ", _name(port)), Text(f"    {details}"), Text(f"    {_source(port, folder)}", style="dim"))
    return Text("\n").join(lines)


def _flow(port: Port) -> str:
    return f"{'' if port.queue is None else 'queue '}{flow_label(port)}"


def _kind(port: Port) -> Text:
    return Text(kind_label(port.kind), style=_STYLES.get(port.kind, "blue"))


def _name(port: Port) -> Text:
    text = Text(port.name, style="bold red" if "?" in port.name else "bold")
    if port.from_param:
        text.append(f" from {port.from_param}", style="not bold dim")
    if port.unknown:
        text.append(f" ({port.unknown})", style="not bold red")
    if port.implicit:
        text.append(" (implicit)", style="not bold dim")
    return text


def _source(port: Port, folder: str) -> str:
    return str(port.at).removeprefix(folder)
