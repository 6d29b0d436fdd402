"""CMake commands on variables, lists and numbers (cmake-commands(7): set, unset, option, list, math, return, ...)."""

from __future__ import annotations

import re
from collections.abc import Callable

from rosarch.extractor.workspace.cmake_expand import is_true, join_list
from rosarch.extractor.workspace.cmake_regex import compile_regex, replace
from rosarch.extractor.workspace.cmake_state import Call, StopFile, StopLoop
from rosarch.extractor.workspace.evaluator import Evaluator, command


@command("set")
def _set(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    name, values = call.args[0], call.args[1:]
    if name.startswith("ENV{"):
        run.environment[name[4:-1]] = values[0] if values else ""
    elif values and values[-1] == "PARENT_SCOPE":
        _set_parent(run, name, values[:-1])
    elif "CACHE" in values:
        place = values.index("CACHE")
        if name not in run.cache or (values[-1] == "FORCE" and name not in run.options.defines):
            run.cache[name] = join_list(values[:place])
            run.scope.variables.pop(name, None)
    elif values:
        run.set(name, join_list(values))
    else:
        run.scope.variables.pop(name, None)


def _set_parent(run: Evaluator, name: str, values: list[str]) -> None:
    parent = run.scope.parent
    if parent is None:
        return
    if values:
        parent.variables[name] = join_list(values)
    else:
        parent.variables.pop(name, None)


@command("unset")
def _unset(run: Evaluator, call: Call) -> None:
    if not call.args:
        return
    name = call.args[0]
    if name.startswith("ENV{"):
        run.environment.pop(name[4:-1], None)
    elif "PARENT_SCOPE" in call.args:
        _set_parent(run, name, [])
    elif "CACHE" in call.args:
        run.cache.pop(name, None)
    else:
        run.scope.variables.pop(name, None)


@command("option")
def _option(run: Evaluator, call: Call) -> None:
    if call.args and run.get(call.args[0]) is None:
        run.cache[call.args[0]] = call.args[2] if len(call.args) > 2 else "OFF"


@command("cmake_dependent_option")
def _dependent_option(run: Evaluator, call: Call) -> None:
    if len(call.args) > 2 and run.get(call.args[0]) is None:
        run.cache[call.args[0]] = call.args[2]


@command("return")
def _return(_run: Evaluator, _call: Call) -> None:
    raise StopFile


@command("break", "continue")
def _leave_loop(_run: Evaluator, call: Call) -> None:
    raise StopLoop(call.name == "break")


@command("message")
def _message(run: Evaluator, call: Call) -> None:
    """A fatal error is recorded and passed: it mostly comes from something assumed wrongly, and the rest still counts."""
    if call.args and call.args[0] in ("FATAL_ERROR", "SEND_ERROR"):
        run.complain(call.command, "cmake-message", "message(" + call.args[0] + "): " + "".join(call.args[1:]).strip())


@command("cmake_language")
def _cmake_language(run: Evaluator, call: Call) -> None:
    if len(call.args) > 1 and call.args[0] == "CALL":
        arguments = call.command.arguments[2:]
        run.run_command(type(call.command)(call.args[1].lower(), call.args[1], arguments, call.command.line, call.command.column))


# -- list ---------------------------------------------------------------------------------------------------------------------


@command("list")
def _list(run: Evaluator, call: Call) -> None:
    if len(call.args) < 2:
        return
    handler = _LIST.get(call.args[0])
    if handler is None:
        run.complain(call.command, "unknown-command", f"unknown command list({call.args[0]})")
        return
    try:
        handler(run, call.args[1], call.args[2:])
    except (IndexError, ValueError) as error:
        run.complain(call.command, "cmake-arguments", f"list({call.args[0]}): {error}")


def _index(elements: list[str], text: str) -> int:
    index = int(text)
    return index + len(elements) if index < 0 else index


def _list_append(run: Evaluator, name: str, rest: list[str]) -> None:
    """Without taking the list apart: a loop that builds a list would take time with its square."""
    before = run.get(name)
    run.set(name, join_list([before, *rest] if before else rest))


def _list_prepend(run: Evaluator, name: str, rest: list[str]) -> None:
    run.set_list(name, [*rest, *run.elements(name)])


def _list_length(run: Evaluator, name: str, rest: list[str]) -> None:
    run.set(rest[0], str(len(run.elements(name))))


def _list_get(run: Evaluator, name: str, rest: list[str]) -> None:
    elements = run.elements(name)
    run.set_list(rest[-1], [elements[_index(elements, text)] for text in rest[:-1]])


def _list_find(run: Evaluator, name: str, rest: list[str]) -> None:
    elements = run.elements(name)
    run.set(rest[1], str(elements.index(rest[0]) if rest[0] in elements else -1))


def _list_insert(run: Evaluator, name: str, rest: list[str]) -> None:
    elements = run.elements(name)
    place = _index(elements, rest[0])
    run.set_list(name, [*elements[:place], *rest[1:], *elements[place:]])


def _list_remove_item(run: Evaluator, name: str, rest: list[str]) -> None:
    run.set_list(name, [element for element in run.elements(name) if element not in rest])


def _list_remove_at(run: Evaluator, name: str, rest: list[str]) -> None:
    elements = run.elements(name)
    dropped = {_index(elements, text) for text in rest}
    run.set_list(name, [element for index, element in enumerate(elements) if index not in dropped])


def _list_remove_duplicates(run: Evaluator, name: str, _rest: list[str]) -> None:
    run.set_list(name, list(dict.fromkeys(run.elements(name))))


def _list_reverse(run: Evaluator, name: str, _rest: list[str]) -> None:
    run.set_list(name, run.elements(name)[::-1])


def _list_sort(run: Evaluator, name: str, rest: list[str]) -> None:
    run.set_list(name, sorted(run.elements(name), reverse="DESCENDING" in rest))


def _list_filter(run: Evaluator, name: str, rest: list[str]) -> None:
    pattern = compile_regex(rest[2])
    run.set_list(name, [e for e in run.elements(name) if (pattern.search(e) is not None) == (rest[0] == "INCLUDE")])


def _list_join(run: Evaluator, name: str, rest: list[str]) -> None:
    elements = run.elements(name)
    run.charge(len(rest[0]) * len(elements))
    run.set(rest[1], rest[0].join(elements))


def _list_sublist(run: Evaluator, name: str, rest: list[str]) -> None:
    begin, length = int(rest[0]), int(rest[1])
    run.set_list(rest[2], run.elements(name)[begin : None if length < 0 else begin + length])


def _list_pop(run: Evaluator, name: str, rest: list[str], front: bool) -> None:
    elements = run.elements(name)
    for variable in rest or [""]:
        value = elements.pop(0 if front else -1) if elements else ""
        if variable:
            run.set(variable, value)
    run.set_list(name, elements)


def _list_transform(run: Evaluator, name: str, rest: list[str]) -> None:
    output = name
    if "OUTPUT_VARIABLE" in rest:
        place = rest.index("OUTPUT_VARIABLE")
        output, rest = rest[place + 1], rest[:place]
    change = _transformation(run, rest)
    selected = set(range(len(run.elements(name))))
    if "REGEX" in rest[1:]:
        pattern = compile_regex(rest[rest.index("REGEX") + 1])
        selected = {index for index, element in enumerate(run.elements(name)) if pattern.search(element)}
    run.set_list(output, [change(e) if i in selected else e for i, e in enumerate(run.elements(name))])


def _transformation(run: Evaluator, rest: list[str]) -> Callable[[str], str]:
    action = rest[0]
    if action == "APPEND":
        return lambda element: _charged(run, element + rest[1])
    if action == "PREPEND":
        return lambda element: _charged(run, rest[1] + element)
    if action == "REPLACE":
        return lambda element: replace(rest[1], rest[2], element, run.charge)
    simple: dict[str, Callable[[str], str]] = {"TOUPPER": str.upper, "TOLOWER": str.lower, "STRIP": str.strip}
    if action not in simple:
        raise ValueError(f"unknown action {action}")
    return simple[action]


def _charged(run: Evaluator, text: str) -> str:
    run.charge(len(text))
    return text


_LIST: dict[str, Callable[[Evaluator, str, list[str]], None]] = {
    "APPEND": _list_append,
    "PREPEND": _list_prepend,
    "LENGTH": _list_length,
    "GET": _list_get,
    "FIND": _list_find,
    "INSERT": _list_insert,
    "REMOVE_ITEM": _list_remove_item,
    "REMOVE_AT": _list_remove_at,
    "REMOVE_DUPLICATES": _list_remove_duplicates,
    "REVERSE": _list_reverse,
    "SORT": _list_sort,
    "FILTER": _list_filter,
    "JOIN": _list_join,
    "SUBLIST": _list_sublist,
    "POP_FRONT": lambda run, name, rest: _list_pop(run, name, rest, True),
    "POP_BACK": lambda run, name, rest: _list_pop(run, name, rest, False),
    "TRANSFORM": _list_transform,
}


# -- math ---------------------------------------------------------------------------------------------------------------------

_ARITHMETIC = re.compile(r"\s*(0[xX][0-9a-fA-F]+|\d+|<<|>>|[-+*/%|&^~()])")
_OPERATORS: list[dict[str, Callable[[int, int], int]]] = [
    {"|": lambda a, b: a | b},
    {"^": lambda a, b: a ^ b},
    {"&": lambda a, b: a & b},
    {"<<": lambda a, b: a << min(b, 63), ">>": lambda a, b: a >> b},
    {"+": lambda a, b: a + b, "-": lambda a, b: a - b},
    {"*": lambda a, b: a * b, "/": lambda a, b: int(a / b), "%": lambda a, b: a - b * int(a / b)},
]


@command("math")
def _math(run: Evaluator, call: Call) -> None:
    if len(call.args) < 3 or call.args[0] != "EXPR":
        return
    tokens = _ARITHMETIC.findall(call.args[2])
    try:
        value = _arithmetic(tokens, 0)
    except (ValueError, ArithmeticError, IndexError):
        run.complain(call.command, "cmake-arguments", f"math: cannot evaluate `{call.args[2]}`")
        return
    run.set(call.args[1], hex(value) if "HEXADECIMAL" in call.args else str(value))


def _arithmetic(tokens: list[str], level: int) -> int:
    if level == len(_OPERATORS):
        return _factor(tokens)
    value = _arithmetic(tokens, level + 1)
    while tokens and tokens[0] in _OPERATORS[level]:
        operator = _OPERATORS[level][tokens.pop(0)]
        value = operator(value, _arithmetic(tokens, level + 1))
    return value


def _factor(tokens: list[str]) -> int:
    token = tokens.pop(0)
    if token == "(":
        value = _arithmetic(tokens, 0)
        tokens.pop(0)
        return value
    if token in "-+~":
        value = _factor(tokens)
        return {"-": -value, "+": value, "~": ~value}[token]
    return int(token, 0) if token.lower().startswith("0x") else int(token)


# -- arguments ----------------------------------------------------------------------------------------------------------------


@command("cmake_parse_arguments")
def _parse_arguments(run: Evaluator, call: Call) -> None:
    args = call.args
    if args[:1] == ["PARSE_ARGV"]:
        count = int(args[1]) if args[1].isdigit() else 0
        args = [*_header(run, call, 2), *run.elements("ARGV")[count:]]
        header, values = args[:4], args[4:]
    else:
        header = _header(run, call, 0)
        values = run.expand_all(call.command.arguments[4:])
    if len(header) < 4:
        return
    prefix, options, singles, multiples = header[0], header[1].split(";"), header[2].split(";"), header[3].split(";")
    result, unparsed = parse_keywords(values, options, singles, multiples)
    for option in filter(None, options):
        run.set(f"{prefix}_{option}", "TRUE" if option in result else "FALSE")
    for name in filter(None, [*singles, *multiples]):
        if result.get(name):
            run.set_list(f"{prefix}_{name}", result[name])
        else:
            run.scope.variables.pop(f"{prefix}_{name}", None)
    run.set_list(f"{prefix}_UNPARSED_ARGUMENTS", unparsed)


def _header(run: Evaluator, call: Call, skip: int) -> list[str]:
    """The prefix and the three keyword lists, each one argument even when it is an unquoted list."""
    return [join_list(run.expand_all([argument])) for argument in call.command.arguments[skip : skip + 4]]


def parse_keywords(
    values: list[str], options: list[str], singles: list[str], multiples: list[str]
) -> tuple[dict[str, list[str]], list[str]]:
    """Sort arguments by the keyword before them; the rest are unparsed."""
    result: dict[str, list[str]] = {}
    unparsed: list[str] = []
    current: list[str] = unparsed
    single = False
    for value in values:
        if value in options:
            result[value] = []
            current, single = unparsed, False
        elif value in singles or value in multiples:
            current = result.setdefault(value, [])
            single = value in singles
        else:
            current.append(value)
            if single:
                current, single = unparsed, False
    return result, unparsed


def truthy(text: str | None) -> bool:
    """Whether a variable's value counts as true."""
    return text is not None and is_true(text) is not False
