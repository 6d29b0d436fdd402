"""The systems that a sub-command works on: a workspace, what is started in it, and the analysis of that."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_diagnostics, check_engine, check_folder, check_sources
from rosarch.cli.options import Engine, parse_environment
from rosarch.cli.terminal import progress

if TYPE_CHECKING:
    from rosarch.analysis.method import Method
    from rosarch.analysis.systems.analysis import SystemAnalysis
    from rosarch.analysis.systems.check_result import CheckResult
    from rosarch.analysis.systems.influences import SystemDetails
    from rosarch.analysis.systems.requests import LaunchEnvironment, Request
    from rosarch.analysis.systems.shared import Launch, SharedFacts
    from rosarch.base.memo import Memo
    from rosarch.extractor.settings import Progress
    from rosarch.findings.configuration import Configuration

Launches = Annotated[
    list[str] | None,
    typer.Option(
        "--launch",
        "-l",
        metavar="'FILE... [NAME:=VALUE,... ...]'",
        help="Launch files that are started together, and arguments; with several values for one, a system for each. May be repeated."
        " By default every launch file that no other includes.",
        show_default=False,
    ),
]
PackagePath = Annotated[
    list[Path] | None,
    typer.Option(
        metavar="DIR",
        help="Where to look for packages, in addition to DIR; may be repeated. By default ROS_PACKAGE_PATH.",
        show_default=False,
    ),
]
Systems = Annotated[
    list[str] | None,
    typer.Option(
        "--launch",
        "-l",
        metavar="'FILE... [NAME:=VALUE ...]'",
        help="Ask about the system that these launch files start, not about components; `*` for every launch file in DIR. May be repeated.",
        show_default=False,
    ),
]
Environment = Annotated[
    list[str] | None,
    typer.Option("--env", metavar="NAME=VALUE", help="An environment variable of the robot; may be repeated.", show_default=False),
]


@dataclass(frozen=True)
class SystemInputs:
    """What is analysed, and how."""

    folder: Path
    method: Method
    launches: Sequence[str] | None = None
    package_path: Sequence[Path] | None = None
    environment: Sequence[str] | None = None


EVERY = "*"
"""The launch files that no other includes."""


def load_systems(inputs: SystemInputs, configuration: Configuration | None = None, *, required: bool = False) -> SystemAnalysis:
    """Compose and check the systems of a workspace: those that the options name, or else the configuration, or else all.

    When some are `required`, a workspace without launch files is rejected.
    """
    where = _environment(inputs, configuration)
    with _confined(inputs, where):
        return _analyze(inputs, configuration, where, _memo(inputs, where), required=required)


def check_systems(inputs: SystemInputs, configuration: Configuration) -> CheckResult:
    """What is wrong with these systems, see `load_systems`; as it was found before when nothing has changed since.

    In a workspace without launch files it is each program by itself.
    """
    where = _environment(inputs, configuration)
    memo = _memo(inputs, where)

    def check() -> CheckResult:
        from rosarch.analysis.systems.check_result import checked

        return checked(_analyze(inputs, configuration, where, memo, required=True, alone=True))

    if memo is None:
        with _confined(inputs, where):
            return check()
    folders = [os.path.abspath(folder) for folder in (*where.package_path, *inputs.method.library)]
    asked = [repr(_requests(inputs, configuration)), repr(folders), *_method(inputs, configuration).key(), repr(configuration.rates)]
    with _confined(inputs, where):
        return memo.recall(["check", os.path.abspath(inputs.folder), os.getcwd(), *asked], folders, check)


def load_shared_facts(inputs: SystemInputs, configuration: Configuration | None = None) -> tuple[SharedFacts, list[Launch]]:
    """The launches that the options name, or else the configuration, and what is known around them, for questions about the systems."""
    from rosarch.analysis.systems.shared import shared_facts

    with progress() as report:
        where = _environment(inputs, configuration)
        memo = _memo(inputs, where)
        with _confined(inputs, where):
            launches = _launches(inputs, configuration, where, memo)
            return shared_facts(inputs.folder, launches, _method(inputs, configuration, report), memo), launches


def load_systems_in_detail(
    inputs: SystemInputs, configuration: Configuration, shorten: Callable[[str], str] | None
) -> tuple[SystemAnalysis, Mapping[str, SystemDetails]]:
    """The systems, how often their topics are sent on, by rules of data flow what influences what, and why all that is so.

    See `analyse_in_detail`.
    """
    from rosarch.analysis.systems.influences import analyse_in_detail

    shared, launches = load_shared_facts(inputs, configuration)
    with progress() as report:
        analysis, details = analyse_in_detail(shared, launches, _method(inputs, configuration, report), shorten)
    if not analysis.systems:
        check_diagnostics(inputs.folder, 0, analysis.diagnostics)
    return analysis, details


def text_reader(inputs: SystemInputs, configuration: Configuration | None = None) -> Callable[[str], str | None]:
    """Reads texts for reports on these systems: from where the analysis may read; None for what cannot be read."""
    from rosarch.base.files import folder_reader

    return folder_reader(inputs.folder, *_readable(inputs, _environment(inputs, configuration)))


def _confined(inputs: SystemInputs, where: LaunchEnvironment) -> AbstractContextManager[None]:
    from rosarch.base.boundary import confined, ros_package_path

    return confined([*_readable(inputs, where), *ros_package_path()])


def _readable(inputs: SystemInputs, where: LaunchEnvironment) -> list[Path]:
    """What may be read: the workspace, the package path, and what else the options name."""
    named = [*inputs.method.library, *inputs.method.rules.own]
    requests = _requests(inputs, None)
    launches = [path for request in requests for file in request.files for path in (Path(file), inputs.folder / file)]
    arguments = [Path(value) for request in requests for _, values in request.arguments for value in values if os.path.isfile(value)]
    return [*where.package_path, *map(Path, where.underlay.folders), *named, *launches, *arguments]


def _analyze(
    inputs: SystemInputs,
    configuration: Configuration | None,
    where: LaunchEnvironment,
    memo: Memo | None,
    *,
    required: bool,
    alone: bool = False,
) -> SystemAnalysis:
    from rosarch.analysis.systems.analysis import analyze_systems
    from rosarch.analysis.systems.launches import by_themselves, has_launch_files

    with progress() as report:
        launches = _launches(inputs, configuration, where, memo)
        if required and not launches and not has_launch_files(inputs.folder):
            launches = by_themselves(where, inputs.method.sources.defines) if alone else []
            if not launches:
                raise InputError(f"{inputs.folder}: no launch file below this folder")
        analysis = analyze_systems(inputs.folder, launches, _method(inputs, configuration, report), memo)
    if not analysis.systems:
        check_diagnostics(inputs.folder, 0, analysis.diagnostics)
    return analysis


def _method(inputs: SystemInputs, configuration: Configuration | None, report: Progress | None = None) -> Method:
    """By what these systems are analysed, with what the configuration says."""
    library = tuple(map(check_folder, inputs.method.library))
    return replace(inputs.method.reporting_to(report), library=library, rates=configuration.rates if configuration else ())


def _memo(inputs: SystemInputs, where: LaunchEnvironment) -> Memo | None:
    """What is known about earlier runs; nothing of those of another program than rosarch's own engine, which may be another one now."""
    from rosarch.base.memo import Memo

    cache = inputs.method.sources.cache
    return Memo(cache, where.variables()) if cache and inputs.method.engine == Engine.embedded.value else None


def _launches(inputs: SystemInputs, configuration: Configuration | None, where: LaunchEnvironment, memo: Memo | None) -> list[Launch]:
    """What is started together; as it was before when nothing that launch files read has changed since."""
    from rosarch.analysis.systems.launches import given, unincluded
    from rosarch.analysis.systems.requests import LaunchWordError

    requests = _requests(inputs, configuration)

    def compose() -> list[Launch]:
        return given(requests, where) if requests else unincluded(where, inputs.method.sources.jobs)

    folders = [os.path.abspath(folder) for folder in where.package_path]
    key = ["launches", os.path.abspath(inputs.folder), os.getcwd(), repr(requests), repr(folders), *where.underlay.key()]
    try:
        return memo.recall(key, folders, compose) if memo else compose()
    except LaunchWordError as error:
        raise InputError(str(error)) from None


def _requests(inputs: SystemInputs, configuration: Configuration | None) -> list[Request]:
    from rosarch.analysis.systems.requests import LaunchWordError, Request, parse_request

    if list(inputs.launches or ()) == [EVERY]:
        return []
    if inputs.launches or configuration is None:
        try:
            return list(map(parse_request, inputs.launches or ()))
        except LaunchWordError as error:
            raise InputError(str(error)) from None
    return [Request(choice.files, choice.arguments) for choice in configuration.launch]


def _environment(inputs: SystemInputs, configuration: Configuration | None) -> LaunchEnvironment:
    from rosarch.analysis.systems.requests import LaunchEnvironment

    check_sources(inputs.folder)
    check_engine(inputs.method.engine)
    environment = dict(os.environ)
    from rosarch.extractor.underlay import source_folders

    folders = source_folders(os.environ)
    if configuration is not None:
        environment.update(configuration.environment)
        folders = [check_folder(Path(folder)) for folder in configuration.package_path] or folders
    environment.update(parse_environment(inputs.environment))
    given = [check_folder(folder) for folder in inputs.package_path or ()]
    return LaunchEnvironment(inputs.folder, (inputs.folder, *(given or folders)), environment, inputs.method.sources.underlay)
