"""`rosarch query`: a rule body asked of the relations of a component."""

from __future__ import annotations

from typing import Annotated

import typer

from rosarch.cli.derivations import Profiled, check_profile, datalog_errors, evaluate, heading
from rosarch.cli.options import ModelFormat
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import emit, emit_lines

Query = Annotated[str, typer.Argument(metavar="QUERY", help="A rule body: 'port(P), !port_type(P, _)'.", show_default=False)]
Most = Annotated[int | None, typer.Option("--most", "-n", metavar="N", min=1, help="No more rows than this; all by default.")]


@asks()
def query(
    question: Question,
    text: Query,
    output_format: Annotated[ModelFormat, typer.Option("--format", help="The form of the answer on stdout.")] = ModelFormat.table,
    most: Most = None,
    profile: Profiled = False,
) -> None:
    """List the rows that match QUERY, for each node and nodelet below DIR."""
    from rosarch.datalog import query as ask
    from rosarch.datalog import table_text
    from rosarch.datalog.inspection.queries import check_query, table_values

    check_profile(profile, question.engine)
    with datalog_errors():
        rules, program = question.asked_by(text)
        check_query(program, text)
        with question.asked(rules) as components:
            answers = []
            for each in components:
                table = ask(program, evaluate(program, each, question.engine, profiled=profile)[0], text)
                answers.append((each, table))
            title = heading(components)
    if output_format is ModelFormat.json:
        values = [{"package": e.package, "component": e.name, "rows": table_values(t)} for e, t in answers]
        from rosarch.reports.printable import json_text

        emit(json_text(values))
    else:
        emit_lines("".join(title(e) + table_text(t, program, most=most) for e, t in answers if t.rows or len(answers) == 1))
        if not any(t.rows for _, t in answers) and len(answers) > 1:
            emit("no rows in any component\n")
