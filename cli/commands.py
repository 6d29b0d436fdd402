"""The sub-commands of `rosarch`: each is a module that is imported when it is run, since all together take longer than most answers."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import typer
from typer.core import TyperGroup

COMMANDS = {
    "extract": ("extract", "Read the packages below DIR and write their facts, one folder of Soufflé .facts files per node or nodelet."),
    "analyze": ("analyze", "Say what each node and nodelet below DIR is connected to: its ports, with types and source lines, and its parameters."),
    "diff": (
        "diff",
        "Compare two folders or git revisions: ports, rates, reactions, states, connections, findings. Exits with 1 when something differs.",
    ),
    "launch": ("launch", "Say which nodes roslaunch would start, with which names, remappings and parameters, without running anything."),
    "check": (
        "check",
        "Say what is wrong with the systems that launch files below DIR start: names, types, parameters, files that do not fit together.",
    ),
    "score": ("score", ""),
    "experiment": ("experiment", ""),
    "doctor": ("doctor", "Tell what of the packages below DIR was replaced, missing, unresolved or slow, and what to do about it."),
    "query": ("query", "List the values of the variables of QUERY for which it holds, in each node and nodelet below DIR."),
    "explain": ("explain", "Print the proof of ROW: the rules and rows it rests on, down to the source lines they are about."),
    "why-not": (
        "explain:why_not",
        "Tell, for every rule that could derive ROW, how far it gets and what is missing, with the nearest rows that are there.",
    ),
    "show": ("show:app", "Show one aspect of a system."),
    "export": ("export:app", "Write systems in the languages of other tools."),
    "library": ("library:app", "The interfaces of common components, for systems that use them without their source."),
    "rules": ("rules:app", "Run, test and document rules."),
    "language-server": ("language_server", ""),
}
"""Where each is, `module` or `module:name`, and the first paragraph of its help."""


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
        self.commands.update(dict.fromkeys(COMMANDS))  # their names, for suggestions

    def list_commands(self, ctx: Any) -> list[str]:
        """The names, in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """The sub-command of this name, imported; None when there is none."""
        return load_command(cmd_name) if cmd_name in COMMANDS else None

    def summary(self, name: str) -> str:
        """The first paragraph of the help of a sub-command."""
        return COMMANDS[name][1]


def load_command(name: str) -> Any:
    """A sub-command, a group of its own or a function."""
    module, _, attribute = COMMANDS[name][0].partition(":")
    found = getattr(import_module(f"rosarch.cli.{module}"), attribute or module)
    app = typer.Typer(rich_markup_mode=None)
    if isinstance(found, typer.Typer):
        app.add_typer(found, name=name, cls=Group)
    else:
        app.command(name)(found)
    return typer.main.get_group(app).commands[name]
