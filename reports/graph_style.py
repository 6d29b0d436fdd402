"""How drawings of the system graph distinguish things: the words, shapes and colours that all formats share."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from rosarch.models.system.view import View, ViewConnector, ViewEdge, ViewNode
from rosarch.reports.labels import counted
from rosarch.reports.printable import printable

MOST_NAMES = 4  # of what was merged, in one label
MOST_EDGE_NAMES = 2
LONGEST_CONDITION = 40


@dataclass(frozen=True)
class Style:
    """A kind of connector: its word, Graphviz' and Mermaid's shape (the texts around a label), and colours of its edge and inside."""

    word: str
    shape: str
    brackets: tuple[str, str]
    line: str
    fill: str


STYLES = MappingProxyType(
    {
        "topic": Style("topic", "box", ("[", "]"), "#404040", "#f2f2f2"),
        "service": Style("service", "hexagon", ("{{", "}}"), "#1f5fa8", "#e3eefb"),
        "action": Style("action", "octagon", ("[[", "]]"), "#2c7a36", "#e4f4e5"),
        "tf": Style("transforms", "cds", ("[/", "/]"), "#7a4a9c", "#f1e8f7"),
    }
)
NODE_LINE, NODE_FILL, GROUP_FILL, ONE_SIDED_LINE = "#303030", "#ffffff", "#fdf6e3", "#b03a2e"


def node_lines(node: ViewNode) -> list[str]:
    """The label of a node."""
    if node.members:
        return [printable(node.name), counted(len(node.members), "node")]
    lines = [printable(node.name)]
    if node.conditions:
        lines.append(_short(f"if {' and '.join(map(printable, node.conditions))}"))
    return lines


def node_details(node: ViewNode) -> str:
    """What is shown of a node beside its label."""
    if node.members:
        return printable(", ".join(node.members))
    words = [node.type if node.type.startswith(f"{node.package}/") else f"{node.package}/{node.type}"]
    if node.origin == "unknown":
        words.append("no model")
    if node.open:
        words.append("may have more ports")
    if node.lines:
        words.append(" > ".join(map(str, node.lines)))
    return printable(", ".join(words))


def connector_lines(connector: ViewConnector, *, types: bool) -> list[str]:
    """The label of a connector, with its types if asked for."""
    lines = merged_names(connector.names, STYLES[connector.kind].word)
    return [*lines, *(printable(type_) for type_ in connector.types[:MOST_NAMES])] if types else lines


def edge_lines(edge: ViewEdge, connectors: Mapping[str, ViewConnector], *, ports: bool) -> list[str]:
    """The label of an edge: the connectors it stands for, or how many ports; if asked for, with names that the source has for them."""
    if edge.names:
        return [_amount(edge)] if len(edge.names) > MOST_EDGE_NAMES else list(map(printable, edge.names))
    amount = [f"{edge.count}x"] if edge.count > 1 else []
    if not ports:
        return amount
    shown = {name for end in (edge.source, edge.target) if end in connectors for name in connectors[end].names}
    written = tuple(name for name in edge.ports if name not in shown)
    return [*amount, *merged_names(written, "port")]


def edge_details(edge: ViewEdge) -> str:
    """What is shown of an edge beside its label."""
    return printable(", ".join(edge.names or edge.ports))


def merged_names(names: tuple[str, ...], word: str) -> list[str]:
    """Names, the first of them if there are many."""
    if len(names) <= MOST_NAMES:
        return [printable(name) for name in names]
    return [plural(len(names), word), *map(printable, names[: MOST_NAMES - 1]), "..."]


def plural(number: int, word: str) -> str:
    """`1 topic`, `2 topics`, `2 transforms`."""
    return f"{number} {word}" if word.endswith("s") else counted(number, word)


def _amount(edge: ViewEdge) -> str:
    return plural(len(edge.names), STYLES[edge.kind].word)


@dataclass(frozen=True)
class LegendEntry:
    """A sample: a node, or of `style` a connector."""

    text: str
    fill: str
    line: str
    style: str = "solid"
    rounded: bool = False


def legend(view: View) -> Iterator[LegendEntry]:
    """An entry for everything that the drawing has."""
    if any(not node.members and node.origin != "unknown" for node in view.nodes):
        yield LegendEntry("node", NODE_FILL, NODE_LINE, rounded=True)
    if any(not node.members and node.origin == "unknown" for node in view.nodes):
        yield LegendEntry("node without model", NODE_FILL, NODE_LINE, "dashed", rounded=True)
    if any(node.members for node in view.nodes):
        yield LegendEntry("several nodes", GROUP_FILL, NODE_LINE)
    kinds = {connector.kind for connector in view.connectors} | {edge.kind for edge in view.edges}
    for kind, style in STYLES.items():
        if kind in kinds:
            yield LegendEntry(style.word, style.fill, style.line)
    if any(connector.one_sided for connector in view.connectors):
        yield LegendEntry("one side only", NODE_FILL, ONE_SIDED_LINE, "dashed")


def hidden_text(view: View) -> str:
    """What was left out, as text."""
    words = {"implicit": "implicit", "inside": "inside one group", "one-sided": "one-sided", "tf": "of transforms"}
    parts = [f"{number} {words[reason]}" if reason in words else plural(number, reason) for reason, number in view.hidden.items()]
    return f"not shown: {', '.join(parts)}" if parts else ""


def title(view: View) -> str:
    """What the drawing is of."""
    return printable(view.name)


def _short(text: str) -> str:
    return text if len(text) <= LONGEST_CONDITION else text[: LONGEST_CONDITION - 3] + "..."
