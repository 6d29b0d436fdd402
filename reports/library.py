"""What the library knows, as text and as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from rosarch.reports.labels import counted, kind_label
from rosarch.reports.printable import json_text, printable

if TYPE_CHECKING:
    from rosarch.library import LibraryComponent, LibraryParameter, LibraryPort


def library_schema() -> Any:
    """The JSON Schema of library files."""
    return json.loads(files("rosarch.reports").joinpath("schema/library.schema.json").read_text(encoding="utf-8"))


def list_text(components: Sequence[LibraryComponent]) -> str:
    """A line per component."""
    rows = [(c.title, c.kind, _size(c), c.made, f"{c.origin} {c.revision}") for c in components]
    packages = {component.package for component in components}
    return f"{_aligned(rows)}\n{counted(len(components), 'component')} of {counted(len(packages), 'package')}\n"


def list_json(components: Iterable[LibraryComponent]) -> str:
    """All that is known about the components, in an array."""
    return json_text([component.document() for component in components])


def component_json(component: LibraryComponent) -> str:
    """All that is known about a component."""
    return json_text(component.document())


def component_text(component: LibraryComponent) -> str:
    """A component's ports and parameters, a line each."""
    head = f"{component.title}  {component.kind}{_more(component)}\n{component.made}: {component.origin} {component.revision}\n"
    ports = [(kind_label(port.kind), _name(port), port.type or "?", _details(port)) for port in component.ports]
    params = [
        ("parameter", parameter.pattern or parameter.name or "?", parameter.type or "?", _access(parameter))
        for parameter in component.params
    ]
    elements = [("element", name, "" if default is None else f"={default}", "") for name, default in component.elements.items()]
    return printable_lines(head) + _aligned([*ports, *elements, *params])


def printable_lines(text: str) -> str:
    """Text with its line breaks and nothing else that a terminal would act on."""
    return "".join(f"{printable(line)}\n" for line in text.splitlines())


def _aligned(rows: Sequence[tuple[str, ...]]) -> str:
    shown = [tuple(printable(cell) for cell in row) for row in rows]
    widths = [max(map(len, column)) for column in zip(*shown, strict=True)]
    return "".join("  ".join(f"{cell:{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() + "\n" for row in shown)


def _size(component: LibraryComponent) -> str:
    return counted(len(component.ports), "port") + (" or more" if component.open_ports else "")


def _more(component: LibraryComponent) -> str:
    words = [word for word, more in (("ports", component.open_ports), ("parameters", component.open_params)) if more]
    return f"  may have more {' and '.join(words)}" if words else ""


def _name(port: LibraryPort) -> str:
    name = port.name or ""
    for label, source in (("argument", port.from_arg), ("from", port.from_param), ("from each", port.param_pattern)):
        if source is not None:
            name = f"{name} ({label} {source}{' and on' if port.rest else ''})".strip()
    return f"{name} + /{port.suffix}" if port.suffix else name


def _details(port: LibraryPort) -> str:
    words = ["latched"] if port.latched else []
    words += [f"via {port.via}"] if port.via != "plain" else []
    words += [f"if argument {number} is {pattern}" for number, pattern in port.if_arg.items()]
    words += [f"if {port.conditional}"] if port.conditional else []
    words += ["implicit"] if port.implicit else []
    return ", ".join(words)


def _access(parameter: LibraryParameter) -> str:
    default = "" if parameter.default is None else f" default {json.dumps(parameter.default, ensure_ascii=False)}"
    return f"{parameter.op}{default}"
