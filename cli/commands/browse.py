"""`rosarch browse`: the relations of a robot, to look through at the terminal."""

from __future__ import annotations

from functools import partial

from rosarch.cli.derivations import datalog_errors, evaluate, load_rules
from rosarch.cli.errors import InputError
from rosarch.cli.questions import Question, asks
from rosarch.cli.terminal import is_terminal


@asks()
def browse(question: Question) -> None:
    """Browse relations in the terminal: what each means, its rows, the proof of a row, the source."""
    from rosarch.datalog import RowStore

    try:
        from rosarch.cli.browser import Browser, Robot
    except ImportError as error:
        raise InputError(f"browse needs {error.name}: pip install '.[interactive]' in the checkout of rosarch") from None
    if not is_terminal():
        raise InputError("browse is for a terminal; rosarch query prints rows")
    with datalog_errors():
        rules = question.rules()
        program = load_rules(rules, systems=question.systems)
        with question.asked(rules) as components:

            def rows(number: int) -> RowStore:
                return RowStore(*evaluate(program, components[number], question.engine))

            Browser([Robot(c.title, c.root, program, partial(rows, i)) for i, c in enumerate(components)]).run()
