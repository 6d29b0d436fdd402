"""`rosarch show graph`, `show includes`, `export`: composed systems as graphs, trees of launch files, architectures."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_output
from rosarch.cli.options import Folder
from rosarch.cli.terminal import emit

if TYPE_CHECKING:
    from rosarch.models.system.model import SystemModel
    from rosarch.models.system.view import Selection, View

Named = TypeVar("Named", "SystemModel", "View")
# The systems below a folder that launch files, with the words of `--launch`, compose.
LoadSystems = Callable[[Path, Sequence[str]], "Sequence[SystemModel]"]


class GraphFormat(str, Enum):
    """The formats of a graph."""

    dot = "dot"
    mermaid = "mermaid"
    graphml = "graphml"
    json = "json"
    svg = "svg"


class TreeFormat(str, Enum):
    """The formats of a tree of launch files."""

    text = "text"
    json = "json"
    dot = "dot"


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
Launch = Annotated[
    Names,
    typer.Option(
        "--launch", metavar="'FILE [NAME:=VALUE ...]'", help="The launch file that starts the system; may be repeated.", show_default=False
    ),
]
Out = Annotated[
    Path | None, typer.Option("--output", "-o", metavar="DIR", help="Write a file for each system into DIR.", show_default=False)
]


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


def add_commands(show: typer.Typer, export: typer.Typer, load: LoadSystems) -> None:
    """Add the commands that show and export systems, which `load` makes."""
    show.command("graph")(graph_command(load))
    show.command("includes")(includes_command(load))
    export.command("acme")(acme_command(load))


def graph_command(load: LoadSystems) -> Callable[..., None]:
    """The command that draws the systems that `load` makes."""

    def graph(
        folder: Folder,
        launch: Launch = None,
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
        implicit: Annotated[bool, typer.Option("--implicit", help="Show connectors that only libraries make.")] = False,
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
        views = _views(load(folder, launch or ()), selection)
        if output_format is GraphFormat.json and out is None:
            from rosarch.reports.graph_json import graphs_text

            emit(graphs_text(views))
        else:
            _deliver(folder, views, lambda view: _graph_text(view, output_format, ports, legend), output_format.value, out)

    return graph


def includes_command(load: LoadSystems) -> Callable[..., None]:
    """The command that shows the launch files of the systems that `load` makes."""

    def includes(
        folder: Folder,
        launch: Launch = None,
        output_format: Annotated[TreeFormat, typer.Option("--format", help="The form of the tree on stdout.")] = TreeFormat.text,
        out: Out = None,
    ) -> None:
        """Show which launch file includes which, and the nodes that each of them starts."""
        from rosarch.reports.include_tree import tree_dot, trees_json, trees_text

        systems = load(folder, launch or ())
        write = trees_json if output_format is TreeFormat.json else trees_text
        if output_format is TreeFormat.dot:
            _deliver(folder, systems, tree_dot, "dot", out)
        elif out is not None:
            _deliver(folder, systems, lambda system: write([system]), output_format.value, out)
        else:
            emit(write(systems))

    return includes


def acme_command(load: LoadSystems) -> Callable[..., None]:
    """The command that exports the systems that `load` makes."""

    def acme(folder: Folder, launch: Launch = None, out: Out = None) -> None:
        """Write the system in Acme, in the family of ROSDiscover's architectures."""
        from rosarch.reports.acme import acme_text

        _deliver(folder, load(folder, launch or ()), acme_text, "acme", out)

    return acme


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
        from rosarch.extractor.hints import hint

        raise InputError(f"no node {unknown[0].name}{hint(unknown[0].name, {name for error in unknown for name in error.known})}")
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


def _deliver(folder: Path, systems: Sequence[Named], write: Callable[[Named], str], form: str, out: Path | None) -> None:
    """Print what `write` makes of the only system, or write a file for each."""
    if out is not None:
        from rosarch.extractor.cache import write_whole

        check_output(out)
        suffix = "txt" if form == "text" else form
        for system, file in zip(systems, _file_names(system.name for system in systems), strict=True):
            write_whole(out / f"{file}.{suffix}", write(system).encode("utf-8", "backslashreplace"))
        return
    if len(systems) != 1:
        known = ", ".join(system.name for system in systems) or "none"
        raise InputError(f"{folder}: {len(systems)} systems; choose one for {form} with --launch, or write all with --output DIR: {known}")
    emit(write(systems[0]))


def _file_names(names: Iterable[str]) -> list[str]:
    """A file's name for each system: what is no letter, digit, dot or dash is an underscore."""
    found: list[str] = []
    for name in names:
        first = re.sub(r"[^\w.-]+", "_", name).strip("._") or "system"
        file, number = first, 1
        while file in found:
            number += 1
            file = f"{first}_{number}"
        found.append(file)
    return found
