"""Whether a run hangs on how fast clocks run beside each other, which models without time do not know."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rosarch.behavior.composition.model import Command, Model

Clocks = frozenset[str]
_NONE: Clocks = frozenset()


def clocks_compared(model: Model, commands: Iterable[int], repeated: Iterable[int] = ()) -> Clocks:
    """The clocks whose rates show whether these commands may follow one another: what one of them sets off finds what another one left.

    What is received without delay, as callbacks take no time, does not pile up in a queue, whatever the clock that sends it. A round that
    does nothing may come at any time where what is `repeated` changes nothing that it looks at.
    """
    variables, queues = _clocks(model)
    found: set[str] = set()
    given = {item for index in repeated for item in model.commands[index].given}
    changing = {variable for variable, value in given if any(other == variable and another != value for other, another in given)}
    steady = {index for index in repeated if _is_idle(model.commands[index], changing)}
    for command in (model.commands[index] for index in commands if index not in steady):
        own = _own(command, queues)
        if not own:
            continue
        others = frozenset().union(*(variables[variable] for variable, _ in command.when)) - own if command.when else _NONE
        full = {*command.full, *(queue for _, queue in command.full_events)} & set(command.puts)
        if others or any(model.queues[queue].prompt for queue in full):
            found |= own | others
    return frozenset(found)


def begins_first(model: Model, commands: Iterable[int], clocks: Clocks) -> bool:
    """Whether these commands are those of a node that begins before the nodes of all other `clocks`: they have one round of one clock.

    Of the clocks of one node the faster ones come first.
    """
    rounds = [command for index in commands if (command := model.commands[index]).clock]
    if len(rounds) != 1:
        return False
    return all(command.actor != rounds[0].actor for command in model.commands if command.clock in clocks - {rounds[0].clock})


def _is_idle(command: Command, changing: Collection[int]) -> bool:
    """Whether a command is a round in which nothing is done, whatever the variables are that change."""
    idle = bool(command.clock) and command.takes is None and not (command.given or command.puts or command.events)
    return idle and all(variable not in changing for variable, _ in command.when)


def _own(command: Command, queues: Sequence[Clocks]) -> Clocks:
    """What sets a command off: its clock, or those of the messages that it takes; none for what comes from outside at any time."""
    if command.clock:
        return frozenset({command.clock})
    return _NONE if command.takes is None else queues[command.takes]


def _clocks(model: Model) -> tuple[list[Clocks], list[Clocks]]:
    """The clocks that variables are changed by, and that messages in queues are from."""
    variables, queues = [_NONE] * len(model.variables), [_NONE] * len(model.queues)
    changed = True
    while changed:
        changed = False
        for command in model.commands:
            own = _own(command, queues)
            for known, places in ((variables, [variable for variable, _ in command.given]), (queues, command.puts)):
                for place in places:
                    if not own <= known[place]:
                        known[place] |= own
                        changed = True
    return variables, queues
