"""The sub-commands of `rosarch`: each is a module that is imported when it is run, since all together take longer than most answers."""

from __future__ import annotations

from importlib import import_module
from typing import Any, cast

import typer
from typer.core import TyperGroup

COMMANDS = {
    "extract": "extract",
    "analyze": "analyze",
    "show": "show:app",
    "export": "export:app",
    "diff": "diff",
    "launch": "launch",
    "check": "check",
    "report": "report",
    "serve": "serve",
    "corpus": "corpus",
    "library": "library:app",
    "score": "score",
    "experiment": "experiment",
    "verify": "verify",
    "simulate": "simulate",
    "observe": "observe",
    "compare": "compare",
    "probe": "probe",
    "doctor": "doctor",
    "ask": "ask",
    "why-silent": "why_silent",
    "query": "query",
    "explain": "explain",
    "why-not": "explain:why_not",
    "rules": "rules:app",
    "options": "list_options:options",
    "new": "new:app",
    "watch": "watch",
    "browse": "browse",
    "language-server": "language_server",
}
"""Where each is, `module` or `module:name`."""
SUMMARIES = {
    "extract": "Read the packages below DIR and write their facts, one folder of Soufflé .facts files per node or nodelet.",
    "analyze": "List the ports and parameters of each node and nodelet below DIR, with types and source lines.",
    "diff": "Compare two folders or git revisions: ports, rates, reactions, states, connections, findings. Exits with 1 when something"
    " differs.",
    "launch": "List the nodes that launch files start, with names, remappings and parameters, without running anything.",
    "check": "Check the systems that launch files below DIR start: report names, types, parameters and files that do not fit together.",
    "report": "Write a report on the packages below DIR as one HTML page: components, graphs, state machines, findings.",
    "serve": "Serve the report on this machine only, and update it whenever sources or rules are saved. Ends with Ctrl-C.",
    "corpus": "Analyse and check many workspaces, each as a task of a Dask cluster. Exits with 2 when one failed, else 1 when one has"
    " findings.",
    "verify": "Check temporal properties of the system that launch files start, whatever comes from outside.",
    "simulate": "Simulate the system that launch files start: rates, queues, lost messages, latencies.",
    "observe": "Compare a recording or a live graph with the system that launch files start, and report what the sources do not show.",
    "compare": "Count, for each kind of element, how many the model predicts and how many a recording or a live graph shows.",
    "probe": "Run one node, send it the messages of its model, and report which reactions and transitions it really has.",
    "doctor": "Report what was replaced, missing, unresolved or slow in the packages below DIR, and what to do about it.",
    "ask": "Answer a QUESTION about the systems that launch files below DIR start: which message can, or must, cause which, and how often.",
    "why-silent": "Say why nothing arrives on TOPIC in the systems that launch files below DIR start: the chain back to the first broken"
    " link.",
    "query": "List the rows that match QUERY, for each node and nodelet below DIR.",
    "explain": "Print the proof of ROW: the rules and rows it depends on, down to the source lines.",
    "why-not": "Show, for every rule that could derive ROW, how far it gets and what is missing, with the nearest rows that exist.",
    "show": "Show one aspect of a system.",
    "export": "Write systems in the languages of other tools.",
    "library": "List, show and build interfaces of components whose source is missing.",
    "rules": "Run, test and document rules.",
    "score": "Score the models of the components in TRUTH: recall, precision, F1, and how far attributes agree.",
    "experiment": "Compare variants of the analysis on many subjects: precision, recall and F1 with intervals, tests, cost.",
    "options": "List the options of the rules, and the decisions with several variants, with their defaults.",
    "new": "Create a check, a relation or the API of a library: rules, docs and a test that passes.",
    "watch": "Print what rules derive, and what changes whenever a rule or a source is saved. Ends with Ctrl-C.",
    "browse": "Browse relations in the terminal: what each means, its rows, the proof of a row, the source.",
    "language-server": "Run the language server for rule files on stdin and stdout; editors start it themselves (docs/editor.md).",
}
"""The first paragraph of the help of each."""


class Group(TyperGroup):
    """A group whose help lists all that its sub-commands do, and not the beginning of that."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """What each sub-command does."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, self.summary(name)) for name in self.list_commands(ctx)])

    def summary(self, name: str) -> str:
        """The first paragraph of the help of a sub-command."""
        return (self.commands[name].help or "").partition("\n\n")[0].replace("\n", " ")


class Commands(Group):
    """The group of all sub-commands."""

    def __init__(self, **attributes: Any) -> None:
        super().__init__(**attributes)
        self.commands.update(cast(dict[str, Any], dict.fromkeys(COMMANDS)))  # their names, for suggestions

    def list_commands(self, ctx: Any) -> list[str]:
        """The names, in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """The sub-command of this name, imported; None when there is none."""
        return load_command(cmd_name) if cmd_name in COMMANDS else None

    def summary(self, name: str) -> str:
        """The first paragraph of the help of a sub-command."""
        return SUMMARIES[name]


def load_command(name: str) -> Any:
    """A sub-command, a group of its own or a function."""
    module, _, attribute = COMMANDS[name].partition(":")
    found = getattr(import_module(f"rosarch.cli.commands.{module}"), attribute or module)
    app = typer.Typer(rich_markup_mode=None)
    if isinstance(found, typer.Typer):
        app.add_typer(found, name=name, cls=Group)
    else:
        app.command(name)(found)
    return typer.main.get_group(app).commands[name]
