"""`rosarch extract`: sources to facts."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from rosarch.base.limits import SOURCE_SECONDS
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_diagnostics, check_folder, extraction_cache
from rosarch.cli.options import Cached, Defines, Folder, Jobs, Packages, Timeout, Verbose, parse_defines, path_argument
from rosarch.cli.outputs import check_output, output_folder, unwritable
from rosarch.cli.terminal import emit, progress, show_diagnostics
from rosarch.extractor.settings import Settings

Out = Annotated[
    Path,
    typer.Option(
        "--out", "-o", parser=path_argument, metavar="FACTS", help="The folder, or with --text the file, to write to.", show_default=False
    ),
]
Text = Annotated[
    bool, typer.Option("--text", help="Write one text that people can read; every command that takes such a folder takes it too.")
]


def extract(
    folder: Folder,
    out: Out,
    text: Text = False,
    packages: Packages = None,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = SOURCE_SECONDS,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Read the packages below DIR and write their facts, one folder of Soufflé .facts files per node or nodelet."""
    settings = Settings(jobs, timeout, parse_defines(defines), extraction_cache(cached))
    check_folder(folder)
    if text:
        _check_text(out)
    else:
        check_output(out)
        _refuse_sources(out)
    from rosarch.extractor.pipeline import extract as extract_facts

    with progress() as report:
        extraction = extract_facts(folder, packages or None, replace(settings, progress=report))
    with extraction:
        check_diagnostics(folder, len(extraction.components), extraction.diagnostics)
        if text:
            try:
                extraction.write_text(out)
            except OSError as error:
                raise unwritable(out, error) from None
        else:
            with output_folder(out) as folder_of_facts:
                extraction.write(folder_of_facts)
        show_diagnostics(extraction.diagnostics, verbose)
        from rosarch.reports.labels import counted

        emit(f"facts of {counted(len(extraction.components), 'component')} in {out}\n")


def _check_text(out: Path) -> None:
    """Reject a path where no text can be written: better before a long extraction than after it."""
    if os.path.isdir(out):
        raise InputError(f"{out}: a folder; name a file for --text")
    check_output(out.parent)


def _refuse_sources(out: Path) -> None:
    """Facts among sources would be taken for facts, and the sources no longer be read."""
    from rosarch.extractor.workspace.manifests import find_manifests

    here = out.resolve()
    inside = next((folder for folder in (here, *here.parents) if os.path.isfile(folder / "package.xml")), None)
    if inside or find_manifests(here, []):
        raise InputError(f"{out}: a folder {'in a package' if inside else 'with packages'}; choose another one for the facts")
