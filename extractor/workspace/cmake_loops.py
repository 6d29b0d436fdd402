"""Loops and procedure calls of the CMake language (commands `foreach`, `while`, `function`, `macro`)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from rosarch.extractor.workspace.cmake_expand import join_list
from rosarch.extractor.workspace.cmake_limits import MAX_ROUNDS
from rosarch.extractor.workspace.cmake_state import Procedure, Scope, StopFile, StopLoop
from rosarch.extractor.workspace.cmake_syntax import Argument, Block, Branch, Command, If, Statement

if TYPE_CHECKING:
    from rosarch.extractor.workspace.evaluator import Evaluator


def run_foreach(run: Evaluator, block: Block) -> None:
    """All forms of `foreach`. The loop variables get their former values back."""
    words = run.expand_all(block.opener.arguments)
    if not words:
        return
    names, rounds = _rounds(run, words)
    before = {name: run.scope.variables.get(name) for name in names}
    for number, values in enumerate(rounds):
        if number == MAX_ROUNDS:
            run.complain(block.opener, "cmake-limit", f"`foreach` left after {MAX_ROUNDS} rounds")
            break
        for name, value in zip(names, values, strict=False):
            run.set(name, value)
        try:
            run.run(block.body)
        except StopLoop as stop:
            if stop.leave:
                break
    for name, old in before.items():
        if old is None:
            run.scope.variables.pop(name, None)
        else:
            run.set(name, old)


def _rounds(run: Evaluator, words: Sequence[str]) -> tuple[list[str], Iterable[tuple[str, ...]]]:
    rest = list(words[1:])
    if rest and rest[0] == "RANGE":
        return [words[0]], ((str(number),) for number in _range(rest[1:]))
    if "IN" not in words or "ZIP_LISTS" not in words:
        return [words[0]], [(value,) for value in _items(run, rest)]
    lists = [run.elements(name) for name in words[words.index("ZIP_LISTS") + 1 :]]
    names = list(words[: words.index("IN")])
    if len(names) == 1 and len(lists) > 1:
        names = [f"{names[0]}_{index}" for index in range(len(lists))]
    length = max((len(one) for one in lists), default=0)
    return names, [tuple(one[i] if i < len(one) else "" for one in lists) for i in range(length)]


def _range(words: Sequence[str]) -> Sequence[int]:
    try:
        numbers = [int(word) for word in words]
    except ValueError:
        return []
    if len(numbers) == 1:
        return range(numbers[0] + 1)
    if len(numbers) in (2, 3):
        step = numbers[2] if len(numbers) == 3 else (1 if numbers[0] <= numbers[1] else -1)
        if step:
            return range(numbers[0], numbers[1] + (1 if step > 0 else -1), step)
    return []


def _items(run: Evaluator, words: Sequence[str]) -> list[str]:
    if not words or words[0] != "IN":
        return list(words)
    result: list[str] = []
    mode = ""
    for word in words[1:]:
        if word in ("LISTS", "ITEMS") and mode != "ITEMS":
            mode = word
        elif mode == "LISTS":
            result.extend(run.elements(word))
        else:
            result.append(word)
    return result


def run_while(run: Evaluator, block: Block) -> None:
    """`while`, at most `MAX_ROUNDS` times."""
    for _round in range(MAX_ROUNDS):
        if not run.holds(block.opener):
            return
        try:
            run.run(block.body)
        except StopLoop as stop:
            if stop.leave:
                return
    run.complain(block.opener, "cmake-limit", f"`while` left after {MAX_ROUNDS} rounds")


def call_procedure(run: Evaluator, procedure: Procedure, args: list[str]) -> None:
    """Call a function (in its own scope) or a macro (its text replaced, in the caller's scope)."""
    run.enter()
    bindings = _bindings(procedure, args)
    try:
        if procedure.is_macro:
            run.run(_substitute(procedure.body, bindings))
            return
        outer = run.scope
        run.scope = Scope(outer)
        run.scope.variables.update(bindings)
        run.set("CMAKE_CURRENT_FUNCTION", procedure.name)
        try:
            run.run(procedure.body)
        except StopFile:
            pass
        finally:
            run.scope = outer
    finally:
        run.depth -= 1


def _bindings(procedure: Procedure, args: list[str]) -> dict[str, str]:
    count = len(procedure.parameters)
    bindings = {f"ARGV{index}": value for index, value in enumerate(args)}
    bindings |= {"ARGC": str(len(args)), "ARGV": join_list(args), "ARGN": join_list(args[count:])}
    for index, name in enumerate(procedure.parameters):
        bindings[name] = args[index] if index < len(args) else ""
    return bindings


_REFERENCE = re.compile(r"\$\{([A-Za-z0-9_]+)\}")


def _substitute(body: Sequence[Statement], bindings: Mapping[str, str]) -> tuple[Statement, ...]:
    return tuple(_substituted(statement, bindings) for statement in body)


def _substituted(statement: Statement, bindings: Mapping[str, str]) -> Statement:
    if isinstance(statement, Command):
        return _substituted_command(statement, bindings)
    if isinstance(statement, If):
        branches = (
            Branch(branch.condition and _substituted_command(branch.condition, bindings), _substitute(branch.body, bindings))
            for branch in statement.branches
        )
        return If(tuple(branches))
    return Block(_substituted_command(statement.opener, bindings), _substitute(statement.body, bindings))


def _substituted_command(command: Command, bindings: Mapping[str, str]) -> Command:
    if not any("${" in argument.text for argument in command.arguments):
        return command
    arguments = tuple(_substituted_argument(argument, bindings) for argument in command.arguments)
    return Command(command.name, command.written, arguments, command.line, command.column)


def _substituted_argument(argument: Argument, bindings: Mapping[str, str]) -> Argument:
    if argument.raw or "${" not in argument.text:
        return argument
    text = _REFERENCE.sub(lambda match: bindings.get(match.group(1), match.group()), argument.text)
    return Argument(text, argument.line, argument.column, argument.quoted)
