"""`rosarch show graph`: composed systems as graphs."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.delivery import Out, deliver, systems_of
from rosarch.cli.errors import InputError
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit

if TYPE_CHECKING:
    from rosarch.models.system.model import SystemModel
    from rosarch.models.system.view import Selection, View


class GraphFormat(str, Enum):
    """The formats of a graph."""

    dot = "dot"
    mermaid = "mermaid"
    graphml = "graphml"
    json = "json"
    svg = "svg"


class ConnectorKind(str, Enum):
    """The kinds of connectors."""

    topic = "topic"
    service = "service"
    action = "action"
    tf = "tf"


class Grouping(str, Enum):
    """What nodes have in common."""

    namespace = "namespace"
    package = "package"


_DRAWN = (ConnectorKind.topic, ConnectorKind.service, ConnectorKind.action)
Names = list[str] | None


def _option(flag: str, text: str, metavar: str = "PATTERN") -> typer.models.OptionInfo:
    option: typer.models.OptionInfo = typer.Option(flag, metavar=metavar, help=text, show_default=False, rich_help_panel="What is shown")
    return option


NodePatterns = Annotated[Names, _option("--node", "Only nodes of this name; `*` stands for anything; may be repeated.")]
Excluded = Annotated[Names, _option("--exclude", "No nodes, topics, services and actions of this name; may be repeated.")]
Namespaces = Annotated[Names, _option("--namespace", "Only nodes in this namespace or below; may be repeated.")]
PackagePatterns = Annotated[Names, _option("--package", "Only nodes of this package; may be repeated.")]
ConnectorPatterns = Annotated[Names, _option("--name", "Only topics, services and actions of this name; may be repeated.")]
Focus = Annotated[Names, _option("--focus", "Only this node and what is near it; may be repeated.")]
Kinds = Annotated[
    list[ConnectorKind] | None, _option("--kind", "Only connectors of this kind; may be repeated. By default all but tf.", "KIND")
]
Collapse = Annotated[Grouping | None, _option("--collapse", "Show nodes of one namespace or package as one.", "BY")]
Group = Annotated[Grouping | None, _option("--group", "Draw a box around nodes of one namespace or package.", "BY")]


@asks()
def graph(
    question: SystemQuestion,
    output_format: Annotated[GraphFormat, typer.Option("--format", help="The form of the graph.")] = GraphFormat.dot,
    out: Out = None,
    nodes: NodePatterns = None,
    exclude: Excluded = None,
    namespaces: Namespaces = None,
    packages: PackagePatterns = None,
    names: ConnectorPatterns = None,
    kinds: Kinds = None,
    focus: Focus = None,
    hops: Annotated[int, typer.Option("--hops", metavar="N", min=0, help="How many connectors away from --focus.")] = 1,
    implicit: Annotated[bool, typer.Option("--implicit", help="Show connectors that only libraries create.")] = False,
    leaves: Annotated[bool, typer.Option("--leaves/--no-leaves", help="Show connectors that are seen from one side only.")] = True,
    collapse: Collapse = None,
    group: Group = None,
    depth: Annotated[int, typer.Option("--depth", metavar="N", min=1, help="How many names of a namespace count.")] = 1,
    nodes_only: Annotated[bool, typer.Option("--nodes-only", help="Draw arrows from node to node.")] = False,
    ports: Annotated[bool, typer.Option("--ports", help="Label arrows with names in the source, connectors with types.")] = False,
    legend: Annotated[bool, typer.Option("--legend/--no-legend", help="Draw a legend.")] = True,
) -> None:
    """Draw the nodes that launch files start, and the topics, services and actions that connect them."""
    from rosarch.models.system.view import Selection

    selection = Selection(
        nodes=tuple(nodes or ()),
        exclude=tuple(exclude or ()),
        namespaces=tuple(namespaces or ()),
        packages=tuple(packages or ()),
        names=tuple(names or ()),
        kinds=tuple(kind.value for kind in kinds or _DRAWN),
        focus=tuple(focus or ()),
        hops=hops,
        implicit=implicit,
        leaves=leaves,
        collapse=collapse.value if collapse else None,
        group=group.value if group else None,
        depth=depth,
        connectors=not nodes_only,
    )
    views = _views(systems_of(question), selection)
    if output_format is GraphFormat.json and out is None:
        from rosarch.reports.graph_json import graphs_text

        emit(graphs_text(views))
    else:
        deliver(question.folder, views, lambda view: _graph_text(view, output_format, ports, legend), output_format.value, out)


def _views(systems: Sequence[SystemModel], selection: Selection) -> list[View]:
    """What is shown of each system. A node in focus has to be in one of them; the others are left out."""
    from rosarch.models.system.view import UnknownName, build_view

    views, unknown = [], []
    for system in systems:
        try:
            views.append(build_view(system, selection))
        except UnknownName as error:
            unknown.append(error)
    if unknown and not views:
        from rosarch.base.hints import hint

        raise InputError(f"no node {unknown[0].name}{hint(unknown[0].name, {name for error in unknown for name in error.candidates})}")
    return views


def _graph_text(view: View, output_format: GraphFormat, ports: bool, legend: bool) -> str:
    from rosarch.reports import graph_dot, graph_graphml, graph_json, graph_mermaid, graph_svg

    if output_format is GraphFormat.mermaid:
        return graph_mermaid.graph_text(view, ports=ports, with_legend=legend)
    if output_format is GraphFormat.graphml:
        return graph_graphml.graph_text(view)
    if output_format is GraphFormat.json:
        return graph_json.graphs_text([view])
    dot = graph_dot.graph_text(view, ports=ports, with_legend=legend)
    if output_format is GraphFormat.dot:
        return dot
    try:
        return graph_svg.svg_text(dot)
    except graph_svg.DrawingError as error:
        raise InputError(f"{view.name}: {error}") from None
