from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosarch.extractor.workspace.cmake_conditions import compare_versions
from rosarch.extractor.workspace.cmake_expand import expand, generator_expression, join_list, split_list
from rosarch.extractor.workspace.cmake_syntax import Block, If, blocks, parse

PATH = Path("CMakeLists.txt")


def words(text: str) -> list[list[str]]:
    commands, diagnostics = parse(text, PATH)
    assert not diagnostics
    return [[command.name, *(argument.text for argument in command.arguments)] for command in commands]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("set(a b c)", ["set", "a", "b", "c"]),
        ("SET ( a\n\tb\r\n)", ["set", "a", "b"]),
        ('set(a "b c;#d (e)")', ["set", "a", "b c;#d (e)"]),
        ('set(a "line\nline \\" quote")', ["set", "a", 'line\nline \\" quote']),
        ("set(a [[raw ${b}]])", ["set", "a", "raw ${b}"]),
        ("set(a [==[\nx]]y]==])", ["set", "a", "x]]y"]),
        ("set(a #[[gone\n(]] b) # c (", ["set", "a", "b"]),
        ("if((a AND (b)) OR c)", ["if", "(", "a", "AND", "(", "b", ")", ")", "OR", "c"]),
        ('add_definitions(-DX="a b" -DY=\\"z\\")', ["add_definitions", '-DX="a b"', '-DY=\\"z\\"']),
        ("f($<$<CONFIG:Debug>:x> ${a}/b $ENV{c} $(make))", ["f", "$<$<CONFIG:Debug>:x>", "${a}/b", "$ENV{c}", "$(make)"]),
        ("\ufefff()", ["f"]),
    ],
)
def test_commands(text: str, expected: list[str]) -> None:
    assert words(text) == [expected]


def test_positions() -> None:
    commands, _ = parse("\n  set(a\n    b)", PATH)
    assert (commands[0].line, commands[0].column) == (2, 3)
    assert (commands[0].arguments[1].line, commands[0].arguments[1].column) == (3, 5)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("set(a b)\nset(c\n", "CMakeLists.txt:3:1: syntax error: unexpected end of file, is a `)` missing?"),
        ("set(a b)\nset(c d))\n", "CMakeLists.txt:2:9: syntax error: unexpected `)`"),
        ('set(a b)\nset(c "d)\n', 'CMakeLists.txt:2:7: syntax error: unexpected `"`'),
        ("set(a b)\n<<<<<<< HEAD\n", "CMakeLists.txt:2:1: syntax error: unexpected `<<<<<<<`"),
    ],
)
def test_syntax_error_keeps_what_came_before(text: str, message: str) -> None:
    commands, diagnostics = parse(text, PATH)
    assert [str(diagnostic) for diagnostic in diagnostics] == [message]
    assert [argument.text for argument in commands[0].arguments] == ["a", "b"]


def test_blocks() -> None:
    commands, _ = parse("if(a)\nf()\nelseif(b)\nelse()\nforeach(x y)\ng()\nendforeach()\nendif()\nh()", PATH)
    statements, diagnostics = blocks(commands, PATH)
    assert not diagnostics
    first = statements[0]
    assert isinstance(first, If)
    assert [branch.condition is None for branch in first.branches] == [False, False, True]
    assert isinstance(first.branches[2].body[0], Block)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("if(a)\nf()", "CMakeLists.txt:1:1: `if` is not closed by `endif`"),
        ("f()\nendforeach()\ng()", "CMakeLists.txt:2:1: `endforeach` closes nothing"),
        ("function(f)\nif(a)\nendfunction()", "CMakeLists.txt:2:1: `if` is not closed by `endif`"),
    ],
)
def test_unbalanced_blocks(text: str, message: str) -> None:
    _, diagnostics = blocks(parse(text, PATH)[0], PATH)
    assert [str(diagnostic) for diagnostic in diagnostics] == [message]


def test_expand() -> None:
    table = {"a": "1", "b1": "x;y", "ENV.H": "/h"}

    def lookup(kind: str, name: str) -> str:
        return table.get(f"{kind}.{name}" if kind else name, "")

    assert expand("${b${a}}-$ENV{H}-${none}", lookup) == "x;y-/h-"
    assert expand("\\${a} \\n\\;${a", lookup) == "${a} \n\\;${a"


@pytest.mark.parametrize(
    ("text", "elements"),
    [("", []), ("a;b;;c", ["a", "b", "c"]), ("a\\;b;c", ["a;b", "c"]), ("a[b;c];d", ["a[b;c]", "d"])],
)
def test_split_list(text: str, elements: list[str]) -> None:
    assert split_list(text) == elements


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("$<BUILD_INTERFACE:/a/include>", "/a/include"),
        ("$<INSTALL_INTERFACE:include>", ""),
        ("$<$<CONFIG:Debug>:-g>x", "x"),
        ("$<$<COMPILE_LANGUAGE:CXX>:-std=c++11>", "-std=c++11"),
        ("$<$<AND:1,$<NOT:0>>:y>", "y"),
        ("$<IF:$<BOOL:OFF>,a,b>", "b"),
        ("$<TARGET_OBJECTS:core>;z", "$<TARGET_OBJECTS:core>;z"),
        ("$<broken", "$<broken"),
    ],
)
def test_generator_expression(text: str, value: str) -> None:
    assert generator_expression(text) == value


@given(st.lists(st.text(alphabet="abc/.", min_size=1), max_size=6))
def test_lists_round_trip(elements: list[str]) -> None:
    assert split_list(join_list(elements)) == elements


@given(st.text(alphabet='set(a)\n"#[]\\${};<>= ', max_size=60))
def test_any_text_parses_or_is_reported(text: str) -> None:
    commands, diagnostics = parse(text, PATH)
    assert isinstance(commands, list)
    assert len(diagnostics) <= 1


@pytest.mark.parametrize(("a", "b", "sign"), [("1.10", "1.9", 1), ("1", "1.0.0", 0), ("", "0.5", -1), ("1.2-rc", "1.2", 0)])
def test_compare_versions(a: str, b: str, sign: int) -> None:
    assert compare_versions(a, b) == sign
