"""The last line of a report: how much was found."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosarch.models.component import ComponentModel
from rosarch.reports.labels import KINDS, counted, underlay_text

if TYPE_CHECKING:
    from rosarch.extractor.underlay import Underlay


def summary_line(models: Sequence[ComponentModel], seconds: float, underlay: Underlay) -> str:
    """Components, ports by kind, unknown names, time, what is installed.

    Nodes of a program count as the program, ports inside libraries do not.
    """
    models = [model for model in models if not model.executable]
    ports = [port for model in models for port in model.ports if not port.implicit]
    kinds = Counter(port.kind for port in ports)
    parts = [counted(kinds[kind], label) for kind, label in KINDS.items() if kinds[kind]]
    unknown = sum("?" in port.name for port in ports)
    head = f"{counted(len(models), 'component')}, {counted(len(ports), 'port')}"
    listing = f" ({', '.join(parts)})" if parts else ""
    return f"{head}{listing}, {unknown} with unknown name, {seconds:.1f} s{underlay_text(underlay)}"
