"""`rosarch explain` and `rosarch why-not`: why a row is there, and why another is not."""

from __future__ import annotations

from typing import Annotated

import typer

from rosarch.cli.derivations import datalog_errors, evaluate, heading, shorten
from rosarch.cli.errors import InputError
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit_lines

Goal = Annotated[
    str,
    typer.Argument(
        metavar="ROW",
        help="A row, `_` for any value: 'port([_, publisher, odom])'. Quotes are needed around commas only.",
        show_default=False,
    ),
]
Depth = Annotated[int, typer.Option("--depth", metavar="N", min=0, help="How many steps of the proof to print; 0 for all.")]
Most = Annotated[int, typer.Option("--most", "-n", metavar="N", min=1, help="Explain no more rows than this per component.")]


@asks()
def explain(
    question: Question,
    goal: Goal,
    depth: Depth = 4,
    show_rules: Annotated[bool, typer.Option("--show-rules", help="Print every rule under the row it derives.")] = False,
    most: Most = 1,
) -> None:
    """Print the proof of ROW: the rules and rows it depends on, down to the source lines."""
    from rosarch.base.files import folder_reader
    from rosarch.datalog import Layout, RowStore, SourceLines, explain_all, proof_text
    from rosarch.datalog.inspection.prover import check_goal, has_rows, no_row

    layout = Layout(depth=depth or None, rules=show_rules, shorten=shorten)
    with datalog_errors():
        rules, program = question.asked_by(goal)
        check_goal(program, goal)
        texts = []
        with question.asked(rules) as components:
            title = heading(components)
            for each in components:
                store = RowStore(*evaluate(program, each, question.engine))
                if not has_rows(program, store, goal):
                    continue
                lines = SourceLines(program, store, folder_reader(each.root))
                proofs = explain_all(program, store, goal, most=most)
                texts.append(title(each) + "\n".join(proof_text(proof, layout=layout, lines=lines) for proof in proofs))
        if not texts:
            raise no_row(program, goal)
    emit_lines("\n".join(texts))


@asks()
def why_not(
    question: Question,
    goal: Goal,
) -> None:
    """Show, for every rule that could derive ROW, how far it gets and what is missing, with the nearest rows that exist."""
    from rosarch.datalog import RowStore, why_not_text
    from rosarch.datalog import why_not as ask
    from rosarch.datalog.inspection.prover import check_goal

    with datalog_errors():
        rules, program = question.asked_by(goal)
        check_goal(program, goal)
        with question.asked(rules) as components:
            if len(components) > 1:
                names = ", ".join(c.title for c in components)
                raise InputError(f"{question.folder}: {len(components)} components; choose one with --component: {names}")
            store = RowStore(*evaluate(program, components[0], question.engine))
        text = why_not_text(ask(program, store, goal), shorten)
    emit_lines(text)
