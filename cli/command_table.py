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
    "analyze": "Say what each node and nodelet below DIR is connected to: its ports, with types and source lines, and its parameters.",
    "diff": "Compare two folders or git revisions: ports, rates, reactions, states, connections, findings. Exits with 1 when something"
    " differs.",
    "launch": "Say which nodes roslaunch would start, with which names, remappings and parameters, without running anything.",
    "check": "Say what is wrong with the systems that launch files below DIR start: names, types, parameters, files that do not fit"
    " together.",
    "report": "Write all that is known of the packages below DIR as one page for a browser: components, graphs, state machines, findings.",
    "serve": "Serve the report on this machine only, and make it anew whenever sources or rules are saved. Ends with Ctrl-C.",
    "corpus": "Analyse and check many workspaces, each as a task of a Dask cluster. Exits with 2 when one failed, else 1 when one has"
    " findings.",
    "verify": "Say whether temporal properties hold in the system that launch files start, whatever comes from outside.",
    "simulate": "Run the system that launch files start, in simulated time: rates, queues, lost messages, latencies.",
    "observe": "Tell what a recording or a live graph shows of the system that launch files start, and what of that the sources do not"
    " say.",
    "compare": "Count, for each kind of element, what is predicted of a system and what a recording or a live graph shows of it.",
    "probe": "Run a node by itself, put messages in that its model tells of, and say which reactions and transitions it really has.",
    "doctor": "Tell what of the packages below DIR was replaced, missing, unresolved or slow, and what to do about it.",
    "ask": "Answer a QUESTION about the systems that launch files below DIR start: what can, or must, cause what; how often.",
    "query": "List the values of the variables of QUERY for which it holds, in each node and nodelet below DIR.",
    "explain": "Print the proof of ROW: the rules and rows it rests on, down to the source lines they are about.",
    "why-not": "Tell, for every rule that could derive ROW, how far it gets and what is missing, with the nearest rows that are there.",
    "show": "Show one aspect of a system.",
    "export": "Write systems in the languages of other tools.",
    "library": "The interfaces of common components, for systems that use them without their source.",
    "rules": "Run, test and document rules.",
    "score": "Analyse the components that TRUTH is about and say how much of it was found, how much of what was found is true, and what"
    " agrees.",
    "experiment": "Run every variant on every subject: precision, recall and F1 with intervals, differences, whether these are chance, and"
    " the cost.",
    "options": "List the options of the rules, and the decisions that have several variants, with their defaults.",
    "new": "Begin a check, a relation or the API of a library: rules, docs and a test that passes.",
    "watch": "Print what rules derive and, whenever a rule or a source is saved, what that has changed. Ends with Ctrl-C.",
    "browse": "Look through relations: what each holds, its rows, the proof of a row and the source it is about.",
    "language-server": "Serve the Language Server Protocol on stdin and stdout, for rule files; editors start this themselves"
    " (docs/editor.md).",
}
"""The first paragraph of the help of each."""


class Group(TyperGroup):
    """A group whose help tells all that its sub-commands do, and not the beginning of that."""

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
