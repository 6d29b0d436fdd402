"""`rosarch rules`: for those who write rules."""

from __future__ import annotations

from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.checks import checks
from rosarch.cli.derivations import Component, Profiled, asked, check_profile, datalog_errors, evaluate, heading, load_rules, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import unwritable
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Input, Jobs, Packages, Timeout, Verbose
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.rules_mutate import mutate
from rosarch.cli.rules_test import test
from rosarch.cli.systems import Systems
from rosarch.cli.terminal import emit

if TYPE_CHECKING:
    from rosarch.datalog import Program

app = typer.Typer(help="Run, test and document rules.", no_args_is_help=False)

Files = Annotated[
    list[Path] | None, typer.Argument(metavar="[FILE]...", help="Files of rules of your own, beside rosarch's.", show_default=False)
]


@app.command("list")
def list_rules(
    pattern: Annotated[str, typer.Argument(metavar="[PATTERN]", help="Only relations of this name; `*` for any text.")] = "*",
    own: Rules = None,
    private: Annotated[bool, typer.Option("--private", help="Also those private to a file, whose names start with `_`.")] = False,
) -> None:
    """List relations with the place of their declaration and what they hold."""
    from rosarch.datalog import reference
    from rosarch.datalog.relation_reference import list_text

    with datalog_errors():
        entries = [e for e in reference(load_rules(parse_rules(own))) if (private or not e.private) and fnmatchcase(e.name, pattern)]
    if not entries:
        raise InputError(f"no relation {pattern}")
    emit(list_text(entries, shorten=shorten))


@app.command("run")
def run(
    folder: Input,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Files of rules of your own, beside rosarch's.", show_default=False)
    ],
    relations: Annotated[
        list[str] | None,
        typer.Option("--relation", "-R", metavar="NAME", help="Print this relation; by default the `.output` of FILE.", show_default=False),
    ] = None,
    packages: Packages = None,
    component: Component = None,
    launches: Systems = None,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    profile: Profiled = False,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Run rules of your own on each node and nodelet below DIR and print the relations they put out."""
    from rosarch.datalog.queries import relation_table, table_text

    check_profile(profile, engine)
    with datalog_errors():
        rules = parse_rules([*files, *(own or ())], variants, settings)
        program = load_rules(rules, systems=bool(launches))
        names = _wanted(program, files, relations or [])
        texts = []
        with asked(
            folder,
            packages,
            component,
            launches,
            rules=rules,
            jobs=jobs,
            timeout=timeout,
            defines=defines,
            cached=cached,
            verbose=verbose,
            engine=engine,
        ) as components:
            title = heading(components)
            for each in components:
                result, _ = evaluate(program, each, engine, profiled=profile)
                tables = [f"{name}\n{table_text(relation_table(program, result, name), program)}" for name in names]
                texts.append(title(each) + "\n".join(tables))
    emit("\n".join(texts))


def _wanted(program: Program, files: list[Path], relations: list[str]) -> list[str]:
    for name in relations:
        if name not in program.relations:
            from rosarch.extractor.hints import hint

            raise InputError(f"--relation {name}: no such relation{hint(name, program.relations)}")
    own = {str(path) for path in files}
    found = relations or [r.name for r in program.relations.values() if r.is_output and r.location.path in own]
    if not found:
        raise InputError(f"{files[0]}: nothing to print; add an `.output` directive or name a relation with --relation")
    return found


@app.command("lint")
def lint(
    own: Annotated[
        list[Path] | None,
        typer.Argument(metavar="[PATH]...", help="Rules of your own; by default rosarch's are looked at.", show_default=False),
    ] = None,
) -> None:
    """Tell what rules do not keep to: comments that say when a row holds, names, relations of no use. Exit code 1 if there is anything."""
    from rosarch.models.rule_lint import lint_rules

    with datalog_errors():
        found = lint_rules(own or ())
    emit("".join(f"{diagnostic.headline}\n" for diagnostic in found))
    if found:
        raise typer.Exit(1)


@app.command("doc")
def doc(
    rules: Files = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FILE", help="Write to FILE, not to stdout.", show_default=False)
    ] = None,
    private: Annotated[bool, typer.Option("--private", help="Also relations private to a file, whose names start with `_`.")] = False,
) -> None:
    """Write the reference of all relations, as Markdown: what they hold, what they use, what uses them."""
    from rosarch.datalog import reference, reference_text

    with datalog_errors():
        text = reference_text(reference(load_rules(parse_rules(rules))), shorten=shorten, private=private)
    if out is None:
        emit(text)
        return
    try:
        out.write_text(text, encoding="utf-8")
    except OSError as error:
        raise unwritable(out, error) from None


app.command("test")(test)
app.command("mutate")(mutate)
app.command("checks")(checks)
