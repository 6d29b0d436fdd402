"""The words that the reports for people share."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosarch.reports.printable import printable

if TYPE_CHECKING:
    from rosarch.extractor.underlay import Underlay
    from rosarch.models.component import ComponentModel, Port

_MOST = 3  # prefixes that a line names
KINDS = {
    "publisher": "publisher",
    "subscriber": "subscriber",
    "service_server": "service server",
    "service_client": "service client",
    "action_server": "action server",
    "action_client": "action client",
    "tf_broadcaster": "tf broadcaster",
    "tf_listener": "tf listener",
    "dynamic_reconfigure_server": "reconfigure server",
}


def kind_label(kind: str) -> str:
    """The words for a port kind."""
    return KINDS.get(kind, kind.replace("_", " "))


def sorted_ports(model: ComponentModel) -> list[Port]:
    """The ports by kind, then as the source has them; those inside a library last."""
    order = {kind: number for number, kind in enumerate(KINDS)}
    return sorted(
        model.ports, key=lambda port: (port.implicit, order.get(port.kind, len(order)), port.at.path, port.at.line, port.at.column)
    )


_TOLD = frozenset({("reliability", "best_effort"), ("history", "keep_all"), ("reliability", "system_default")})


def flow_label(port: Port) -> str:
    """Queue size and the modes that matter to the other side."""
    words = [] if port.queue is None else [str(port.queue)]
    if port.latched:
        words.append("latched")
    words += [setting.replace("_", " ") for policy, setting in port.qos if (policy, setting) in _TOLD]
    return " ".join(words)


def answer_label(port: Port) -> str:
    """The callback, and the library between it and the topic."""
    words = [port.callback] if port.callback else []
    if port.via not in ("plain", "lambda", ""):
        words.append(f"via {port.via}")
    return " ".join(words)


def parameter_labels(model: ComponentModel) -> list[str]:
    """Each parameter once, by name, with its default."""
    found: dict[str, str] = {}
    for parameter in model.params:
        default = "" if parameter.default is None else f"={parameter.default}"
        if parameter.name not in found or (default and not found[parameter.name]):
            found[parameter.name] = default
    return [f"{name}{default}" for name, default in sorted(found.items())]


def counted(number: int, noun: str) -> str:
    """`1 node`, `2 nodes`."""
    if number == 1:
        return f"1 {noun}"
    return f"{number} {noun[:-1]}ies" if noun.endswith("y") else f"{number} {noun}s"


def underlay_text(underlay: Underlay) -> str:
    """What is installed, as the end of a sentence."""
    if not underlay.prefixes:
        return ""
    first = ", ".join(map(printable, underlay.prefixes[:_MOST]))
    more = f" and {len(underlay.prefixes) - _MOST} more" if len(underlay.prefixes) > _MOST else ""
    return f"; with {counted(underlay.count, 'package')} installed below {first}{more}"
