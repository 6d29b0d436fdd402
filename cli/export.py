"""`rosarch export`: composed systems in the languages of other tools."""

from __future__ import annotations

import typer

from rosarch.cli.delivery import Out, deliver, systems_of
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Folder, Jobs, Libraries, Timeout, Verbose, parse_defines
from rosarch.cli.systems import Environment, Launches, PackagePath, SystemInputs

app = typer.Typer(help="Write systems in the languages of other tools.", no_args_is_help=False)


@app.callback()
def export() -> None:
    """Write systems in the languages of other tools."""


@app.command("acme")
def acme(
    folder: Folder,
    launches: Launches = None,
    out: Out = None,
    package_path: PackagePath = None,
    environment: Environment = None,
    libraries: Libraries = None,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Write the architecture of a system in Acme, in the family of ROSDiscover's architectures."""
    from rosarch.reports.acme import acme_text

    inputs = SystemInputs(folder, launches, package_path, environment, libraries, engine, jobs, timeout, parse_defines(defines), cached)
    deliver(folder, systems_of(inputs, verbose), acme_text, "acme", out)
