"""`rosarch show`: one aspect of a system."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import hint, load_analysis
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Format, Input, Jobs, Packages, Timeout, Verbose, parse_defines
from rosarch.cli.terminal import emit, show_diagnostics

if TYPE_CHECKING:
    from rosarch.models.component import ComponentModel

app = typer.Typer(help="Show one aspect of a system.", no_args_is_help=False)


@app.command("ports")
def ports(
    folder: Input,
    node: Annotated[
        str | None, typer.Argument(metavar="NODE", help="Only this one: NAME, PACKAGE/NAME or its node name.", show_default=False)
    ] = None,
    packages: Packages = None,
    output_format: Annotated[Format, typer.Option("--format", help="The form of the report on stdout.")] = Format.table,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """List the topics, services, actions and transforms of each node and nodelet below DIR."""
    start = time.perf_counter()
    analysis = load_analysis(folder, packages, engine=engine, jobs=jobs, timeout=timeout, defines=parse_defines(defines), cached=cached)
    models = analysis.models if node is None else _named(analysis.models, node)
    show_diagnostics(analysis.diagnostics, verbose)
    if output_format is Format.json:
        from rosarch.reports.json_models import ports_text

        emit(ports_text(models))
    elif output_format is Format.markdown:
        from rosarch.reports.markdown import ports_text as markdown_text

        emit(markdown_text(models))
    else:
        from rosarch.reports.summary import summary_line
        from rosarch.reports.table import models_text

        emit(models_text(models, parameters=False, terminal=sys.stdout.isatty()))
        emit(summary_line(models, time.perf_counter() - start) + "\n")


def _named(models: Sequence[ComponentModel], node: str) -> tuple[ComponentModel, ...]:
    """The components a user may mean by `node`."""
    found = tuple(model for model in models if node in (model.component, f"{model.package}/{model.component}", model.node_name))
    if not found:
        known = {name for model in models for name in (model.component, f"{model.package}/{model.component}")}
        raise InputError(f"no node or nodelet {node}{hint(node, known)}")
    return found
