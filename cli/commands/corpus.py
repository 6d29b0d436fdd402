"""`rosarch corpus`: many workspaces, on this machine or on a cluster."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from rosarch.base.files import file_name
from rosarch.cli.errors import FINDINGS, USAGE, InputError
from rosarch.cli.inputs import check_folder, read_input
from rosarch.cli.options import Format, path_argument
from rosarch.cli.outputs import check_output, write_output
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.terminal import emit, progress

Words = Annotated[
    list[Path],
    typer.Argument(
        parser=path_argument,
        metavar="DIR|FILE...",
        help="Workspaces, or files with one on each line; `#` starts a comment.",
        show_default=False,
    ),
]
Out = Annotated[
    Path,
    typer.Option(
        "--out", "-o", parser=path_argument, metavar="OUT", help="Where the reports go: OUT/<workspace>/*.json and OUT/corpus.json."
    ),
]
Scheduler = Annotated[
    str | None,
    typer.Option(
        "--scheduler",
        metavar="ADDRESS",
        help="A Dask scheduler, as tcp://host:8786; workers of this machine by default.",
        show_default=False,
    ),
]
Workers = Annotated[
    int | None, typer.Option("--workers", metavar="N", min=1, help="Without --scheduler: processes; one per processor by default.")
]
Jobs = Annotated[int, typer.Option("--jobs", "-j", metavar="N", min=1, help="Worker processes within each task.")]
Retries = Annotated[int, typer.Option("--retries", metavar="N", min=0, help="How often to retry a task that was killed or took too long.")]
Limit = Annotated[float, typer.Option("--limit", metavar="SECONDS", min=0.001, help="The time limit of one workspace.")]


def corpus(
    words: Words,
    out: Out,
    scheduler: Scheduler = None,
    workers: Workers = None,
    jobs: Jobs = 1,
    retries: Retries = 2,
    limit: Limit = 3600.0,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    output_format: Annotated[Format, typer.Option("--format", help="The summary on stdout.")] = Format.table,
) -> None:
    """Analyse and check many workspaces, each as a task of a Dask cluster. Exits with 2 when one failed, else 1 when one has findings."""
    from rosarch.base.pool import default_jobs
    from rosarch.evaluation.corpus.cluster import Cluster, NoCluster, run
    from rosarch.evaluation.corpus.task import Failed, Job
    from rosarch.reports.corpus import WRITERS

    check_output(out)
    parse_rules(own, variants, settings)  # what is wrong with them is reported once, and before anything is done
    of_rules = {"--rules": [os.path.abspath(path) for path in own or ()], "--variant": variants or (), "--option": settings or ()}
    options = ("--jobs", str(jobs), *(word for option, values in of_rules.items() for value in values for word in (option, value)))
    folders = _named(_folders(words))
    tasks = [Job(os.path.abspath(folder), options, limit) for folder in folders.values()]
    names = list(folders)
    outcomes = {}
    try:
        with progress() as report:
            for index, outcome in run(tasks, Cluster(scheduler, workers or default_jobs(), retries)):
                name = names[index]
                outcomes[name] = str(folders[name]), outcome
                if not isinstance(outcome, Failed):
                    _write(out / name, outcome.reports)
                if report:
                    report("workspaces", len(outcomes), len(tasks))
    except NoCluster as error:
        raise InputError(str(error)) from None
    write_output(out / "corpus.json", WRITERS["json"](outcomes))
    emit(WRITERS[output_format.value](outcomes))
    if any(isinstance(outcome, Failed) for _, outcome in outcomes.values()):
        raise typer.Exit(USAGE)
    if any(outcome.reports.get("findings", {}).get("findings") for _, outcome in outcomes.values() if not isinstance(outcome, Failed)):
        raise typer.Exit(FINDINGS)


def _folders(words: Sequence[Path]) -> list[Path]:
    """The workspaces that are named, each once; those of a file are relative to it."""
    found: dict[Path, None] = {}
    for word in words:
        if os.path.isfile(word):
            lines = (line.partition("#")[0].strip() for line in read_input(word).splitlines())
            found.update(dict.fromkeys(word.parent / line for line in lines if line))
        else:
            found[check_folder(word)] = None
    if not found:
        raise InputError("no workspace is named")
    return list(found)


def _named(folders: Sequence[Path]) -> dict[str, Path]:
    """The workspaces by the names of their folders; of those with one name, the later ones have a number."""
    found: dict[str, Path] = {}
    for folder in folders:
        first = file_name(os.path.basename(os.path.abspath(folder)))
        name, number = first, 1
        while name in found:
            number += 1
            name = f"{first}_{number}"
        found[name] = folder
    return found


def _write(folder: Path, reports: Mapping[str, Any]) -> None:
    from rosarch.reports.printable import json_text

    for name, document in reports.items():
        write_output(folder / f"{name}.json", json_text(document))
