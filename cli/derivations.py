"""What `query`, `explain`, `why-not` and `rules run` share: the rules and the rows of the components they are asked about."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_diagnostics, check_input
from rosarch.cli.options import Engine
from rosarch.cli.terminal import progress, show_diagnostics

if TYPE_CHECKING:
    from rosarch.datalog import Program, RelationDecl, Result
    from rosarch.extractor.selection import SelectedComponent
    from rosarch.extractor.settings import Settings
    from rosarch.rule_programs.sets import RuleSet

Facts = Mapping[str, list[tuple[Any, ...]]]
Component = Annotated[
    str | None, typer.Option("--component", "-c", metavar="NAME", help="Only this one: NAME or PACKAGE/NAME.", show_default=False)
]
Profiled = Annotated[bool, typer.Option("--profile", help="Report on stderr which rules take the time.")]


@contextmanager
def datalog_errors() -> Iterator[None]:
    """Errors in rules, checks, goals and queries are errors of the user's input."""
    from rosarch.datalog import DatalogError
    from rosarch.rule_programs.checks import CheckError
    from rosarch.rule_programs.variants import RuleSetError

    try:
        yield
    except (DatalogError, CheckError, RuleSetError) as error:
        raise InputError(str(error)) from None


def load_rules(rules: RuleSet, *, systems: bool = False) -> Program:
    """The rules of a component or of a system."""
    from rosarch.rule_programs.sets import component_program, system_rules

    return system_rules(rules).program if systems else component_program(rules)


def shorten(path: str) -> str:
    """The path of one of rosarch's rules from the folder of rules on, any other as it is."""
    from rosarch.extractor.manifest import rules_folder

    inside = Path(path)
    folder = rules_folder()
    return f"rules/{inside.relative_to(folder).as_posix()}" if inside.is_relative_to(folder) else path


@contextmanager
def selected(
    folder: Path,
    packages: Sequence[str] | None,
    component: str | None,
    settings: Settings,
    *,
    verbose: bool,
) -> Iterator[Sequence[SelectedComponent]]:
    """The components below DIR that the options leave; none is an error."""
    from rosarch.extractor.manifest import ManifestError
    from rosarch.extractor.selection import SelectionError, select

    check_input(folder)
    try:
        with progress() as report, select(folder, packages or None, component, replace(settings, progress=report)) as found:
            check_diagnostics(folder, len(found.components), found.diagnostics)
            show_diagnostics(found.diagnostics, verbose)
            if not found.components:
                raise InputError(f"{folder}: no node or nodelet")
            yield found.components
    except (SelectionError, ManifestError) as error:
        raise InputError(str(error)) from None


def facts_of(component: SelectedComponent, program: Program) -> Facts:
    """The facts of a component that the rules read."""
    wanted = set(program.inputs)
    return {name: list(rows) for name, rows in component.load().items() if name in wanted}


def check_profile(profiled: bool, engine: Engine) -> None:
    """Reject a profile of an engine that is not measured."""
    if profiled and engine is not Engine.embedded:
        raise InputError("--profile measures the embedded engine; souffle has a profiler of its own")


def evaluate(program: Program, component: SelectedComponent, engine: Engine, *, profiled: bool = False) -> tuple[Result, Facts]:
    """All relations of a component, and its facts; with a profile on stderr if asked for."""
    facts = facts_of(component, program)
    if not profiled:
        from rosarch.base.limits import LIMITS

        return program.evaluate(facts, engine=engine.value, keep="all", time_limit=LIMITS.evaluation), facts
    from rosarch.datalog import profile, profile_text

    found = profile(program, facts)
    sys.stderr.write(f"== {component.title}\n{profile_text(found, shorten=shorten)}")
    return found.result, facts


def chosen_relations(relations: Mapping[str, RelationDecl], names: Sequence[str], files: Iterable[Path]) -> list[str]:
    """The relations of `--relation`, or else those that files of the user's own put out."""
    for name in names:
        if name not in relations:
            from rosarch.base.hints import hint

            raise InputError(f"--relation {name}: no such relation{hint(name, relations)}")
    own = {str(path) for path in files}
    return list(names) or [r.name for r in relations.values() if r.is_output and r.location.path in own]


def heading(components: Sequence[SelectedComponent]) -> Callable[[SelectedComponent], str]:
    """A line above the answer for each component, when there are several."""
    several = len(components) > 1
    return lambda component: f"== {component.title}\n" if several else ""
