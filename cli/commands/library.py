"""`rosarch library`: the interfaces of components whose source is not available."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_folder
from rosarch.cli.options import Input, Libraries, ModelFormat, Packages, path_argument
from rosarch.cli.outputs import check_output, output_folder
from rosarch.cli.questions import ReadingOptions, asks
from rosarch.cli.terminal import emit, show_diagnostics

if TYPE_CHECKING:
    from rosarch.base.diagnostics import Diagnostic
    from rosarch.library import Library
    from rosarch.library.model import Source

app = typer.Typer(help="List, show and build interfaces of components whose source is missing.", no_args_is_help=False)


@app.command("list")
def list_(
    packages: Packages = None,
    libraries: Libraries = None,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the report on stdout.")] = ModelFormat.table,
) -> None:
    """List the components that are known, with the number of their ports and where they come from."""
    from rosarch.reports.library import list_json, list_text

    found = [component for component in _library(libraries).components if not packages or component.package in packages]
    if not found:
        raise InputError(f"the library has no package {', '.join(packages or ())}")
    emit(list_json(found) if output_format is ModelFormat.json else list_text(found))


@app.command("show")
def show(
    name: Annotated[str, typer.Argument(metavar="NAME", help="PACKAGE/COMPONENT, or the lookup name of a plug-in.", show_default=False)],
    libraries: Libraries = None,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the report on stdout.")] = ModelFormat.table,
) -> None:
    """Show one component: its ports and parameters, and the file they are from."""
    from rosarch.reports.library import component_json, component_text

    library = _library(libraries)
    package, _, component = name.partition("/")
    found = library.find(package, component) or library.find(None, name)
    if found is None:
        from rosarch.base.hints import hint

        raise InputError(f"the library has no component {name}{hint(name, {c.title for c in library.components})}")
    emit(component_json(found) if output_format is ModelFormat.json else component_text(found))


@app.command("build")
@asks("own", "variants", "settings")
def build(
    reading: ReadingOptions,
    folder: Input,
    origin: Annotated[str, typer.Option(metavar="URL", help="Where the sources come from.", show_default=False)],
    revision: Annotated[str, typer.Option(metavar="REV", help="The commit or tag of the sources.", show_default=False)],
    out: Annotated[
        Path,
        typer.Option("--out", "-o", parser=path_argument, metavar="FOLDER", help="Where to write a file per package.", show_default=False),
    ],
    packages: Packages = None,
    distributions: Annotated[
        list[str] | None,
        typer.Option(
            "--distribution", metavar="NAME", help="A distribution of ROS that has this revision; may be repeated.", show_default=False
        ),
    ] = None,
    files: Annotated[
        bool,
        typer.Option("--files", help="Also keep what others include of the packages: launch files, parameters, interfaces, descriptions."),
    ] = False,
) -> None:
    """Write library files for the packages below DIR, from their sources."""
    from rosarch.library.build import library_documents, write_library
    from rosarch.library.model import Source
    from rosarch.rule_programs.choice import of_any_name

    for option, text in (("--origin", origin), ("--revision", revision)):
        if not text.strip():
            raise InputError(f"{option}: is empty")
    check_output(out)
    analysis = reading.analysis(of_any_name(reading.rules()), folder, packages)
    chosen = [model for model in analysis.models if not packages or model.package in packages]
    source = Source(origin, revision, tuple(distributions or ()))
    diagnostics = analysis.diagnostics
    with output_folder(out) as written:
        paths = write_library(library_documents(chosen, source), written)
        if files:
            kept, problems = _systems(folder, packages, source, written)
            paths, diagnostics = (*paths, *kept), (*diagnostics, *problems)
    show_diagnostics(diagnostics, reading.verbose)
    emit("".join(f"{out / path.relative_to(written)}\n" for path in paths))


def _systems(folder: Path, packages: list[str] | None, source: Source, out: Path) -> tuple[list[Path], list[Diagnostic]]:
    """Write what others include of the packages below a folder."""
    from rosarch.base.boundary import confined
    from rosarch.extractor.workspace import discover
    from rosarch.library.files import write_files

    with confined([folder]):
        workspace = discover(folder, packages or None)
        return write_files([one for one in workspace.packages if one.name in workspace.selected], folder, source, out)


def _library(folders: list[Path] | None) -> Library:
    from rosarch.library import load

    library = load([check_folder(folder) for folder in folders or ()])
    show_diagnostics(library.problems, verbose=True)
    return library
