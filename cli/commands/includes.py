"""`rosarch show includes`: which launch file includes which."""

from __future__ import annotations

from enum import Enum
from typing import Annotated

import typer

from rosarch.cli.delivery import Out, deliver, systems_of
from rosarch.cli.questions import SystemQuestion, asks
from rosarch.cli.terminal import emit


class TreeFormat(str, Enum):
    """The formats of a tree of launch files."""

    text = "text"
    json = "json"
    dot = "dot"


@asks()
def includes(
    question: SystemQuestion,
    output_format: Annotated[TreeFormat, typer.Option("--format", help="The form of the tree.")] = TreeFormat.text,
    out: Out = None,
) -> None:
    """Show which launch file includes which, and the nodes that each of them starts."""
    from rosarch.reports.include_tree import tree_dot, trees_json, trees_text

    systems = systems_of(question)
    write = trees_json if output_format is TreeFormat.json else trees_text
    if output_format is TreeFormat.dot:
        deliver(question.folder, systems, tree_dot, "dot", out)
    elif out is not None:
        deliver(question.folder, systems, lambda system: write([system]), output_format.value, out)
    else:
        emit(write(systems))
