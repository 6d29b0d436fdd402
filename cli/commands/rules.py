"""`rosarch rules`: for those who write rules."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rosarch.cli.commands.checks import checks
from rosarch.cli.commands.rules_mutate import mutate
from rosarch.cli.commands.rules_test import test
from rosarch.cli.derivations import Profiled, check_profile, chosen_relations, datalog_errors, evaluate, heading, load_rules, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.outputs import write_output
from rosarch.cli.questions import Question, asks
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.terminal import emit, emit_lines

if TYPE_CHECKING:
    pass

app = typer.Typer(help="Run, test and document rules.", no_args_is_help=False)

Files = Annotated[
    list[Path] | None, typer.Argument(metavar="[FILE]...", help="Files of rules of your own, in addition to rosarch's.", show_default=False)
]


@app.command("list")
def list_rules(
    pattern: Annotated[str, typer.Argument(metavar="[PATTERN]", help="Only relations of this name; `*` for any text.")] = "*",
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    private: Annotated[bool, typer.Option("--private", help="Also those private to a file, whose names start with `_`.")] = False,
) -> None:
    """List relations with the place of their declaration and what they hold."""
    from rosarch.datalog import reference
    from rosarch.datalog.inspection.relation_reference import list_text

    with datalog_errors():
        known = [e for e in reference(load_rules(parse_rules(own, variants, settings))) if private or not e.private]
    entries = [e for e in known if fnmatchcase(e.name, pattern)]
    if not entries:
        from rosarch.base.hints import hint

        raise InputError(f"no relation {pattern}{hint(pattern, [e.name for e in known])}")
    emit(list_text(entries, shorten=shorten))


@app.command("run")
@asks()
def run(
    question: Question,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Files of rules of your own, in addition to rosarch's.", show_default=False)
    ],
    relations: Annotated[
        list[str] | None,
        typer.Option("--relation", "-R", metavar="NAME", help="Print this relation; by default the `.output` of FILE.", show_default=False),
    ] = None,
    profile: Profiled = False,
) -> None:
    """Run rules of your own on each node and nodelet below DIR and print the relations they put out."""
    from rosarch.datalog.inspection.queries import relation_table, table_text
    from rosarch.rule_programs.own_files import own_files

    check_profile(profile, question.engine)
    with datalog_errors():
        rules = question.rules(*files)
        program = load_rules(rules, systems=question.systems)
        names = chosen_relations(program.relations, relations or [], own_files(files))
        if not names:
            raise InputError(f"{files[0]}: nothing to print{_nothing_to_print(files, question)}")
        texts = []
        with question.asked(rules) as components:
            title = heading(components)
            for each in components:
                result, _ = evaluate(program, each, question.engine, profiled=profile)
                tables = [f"{name}\n{table_text(relation_table(program, result, name), program)}" for name in names]
                texts.append(title(each) + "\n".join(tables))
    emit_lines("\n".join(texts))


def _nothing_to_print(files: Sequence[Path], question: Question) -> str:
    """Why: rules of systems without --launch or rules of components with it, or none with `.output`."""
    from rosarch.rule_programs.own_files import own_files, own_programs

    program = "system" if question.systems else "component"
    if not own_programs(own_files(files)).get(program):
        return " of systems; leave out --launch" if question.systems else " of components; name systems with --launch, '*' for all"
    return "; add an `.output` directive or name a relation with --relation"


@app.command("lint")
def lint(
    own: Annotated[
        list[Path] | None,
        typer.Argument(metavar="[PATH]...", help="Rules of your own; by default rosarch's are looked at.", show_default=False),
    ] = None,
) -> None:
    """Check the style of rules: comments that say when a row holds, names, relations without use. Exits with 1 when it reports any."""
    from rosarch.rule_programs.lint import lint_rules

    with datalog_errors():
        found = lint_rules(own or ())
    emit("".join(f"{diagnostic.headline}\n" for diagnostic in found))
    if found:
        raise typer.Exit(1)


@app.command("doc")
def doc(
    rules: Files = None,
    variants: Variants = None,
    settings: Settings = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FILE", help="Write to FILE, not to stdout.", show_default=False)
    ] = None,
    private: Annotated[bool, typer.Option("--private", help="Also relations private to a file, whose names start with `_`.")] = False,
) -> None:
    """Write the reference of all relations, as Markdown: what they hold, what they use, what uses them."""
    from rosarch.datalog import reference, reference_text

    with datalog_errors():
        text = reference_text(reference(load_rules(parse_rules(rules, variants, settings))), shorten=shorten, private=private)
    if out is None:
        emit(text)
        return
    write_output(out, text)


app.command("test")(test)
app.command("mutate")(mutate)
app.command("checks")(checks)
