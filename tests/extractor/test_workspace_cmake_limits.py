"""CMake code that would never end, or fill the memory: it is left at a limit, told at the command that reached it."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from workspace_builder import evaluated, messages, package

from rosarch.base import patterns
from rosarch.extractor.workspace import discover
from rosarch.extractor.workspace.cmake_limits import OutOfTime, time_limit

LONG = "demo/CMakeLists.txt:{}: a value of more than 4194304 characters, evaluation stopped"
MUCH = "demo/CMakeLists.txt:{}: more than 536870912 characters of values, evaluation stopped"
BIG = 'set(x "0123456789abcdef")\nforeach(i RANGE 15)\nset(x "${x}${x}")\nendforeach()\n'  # 1 MiB


@pytest.mark.slow
@pytest.mark.parametrize(
    ("cmake", "message"),
    [
        ('set(x a)\nwhile(TRUE)\nset(x "${x}${x}")\nendwhile()', LONG.format("6:1")),
        ("foreach(i RANGE 2000000000)\nendforeach()", "demo/CMakeLists.txt:4:1: `foreach` left after 10000 rounds"),
        ("while(TRUE)\nendwhile()", "demo/CMakeLists.txt:4:1: `while` left after 10000 rounds"),
        ("while(TRUE)\nforeach(i RANGE 9000)\nset(x 1)\nendforeach()\nendwhile()", "demo/CMakeLists.txt:6:1: more than 600000 conditions, commands and arguments, evaluation stopped"),
        (f"while(TRUE)\nset(x {'${x} ' * 1000})\nendwhile()", "demo/CMakeLists.txt:5:1: more than 600000 conditions, commands and arguments, evaluation stopped"),
        (f"foreach(i RANGE 1000)\nif({'0 OR ' * 200}0)\nendif()\nendforeach()", "demo/CMakeLists.txt:5:1: more than 600000 conditions, commands and arguments, evaluation stopped"),
        ("macro(again)\nagain()\nendmacro()\nagain()", "demo/CMakeLists.txt:5:1: CMake code nests too deeply, evaluation stopped"),
        ("string(REPEAT abc 2000000000 x)", MUCH.format("4:1")),
        (BIG + 'string(REPLACE 0 "${x}" y "${x}")', MUCH.format("8:1")),
        (BIG + 'string(REGEX REPLACE [0-9] "${x}" y "${x}")', MUCH.format("8:1")),
        (BIG + 'string(REPLACE f ";" y "${x}")\nlist(JOIN y "${x}" z)', MUCH.format("9:1")),
        (BIG + 'string(REPLACE f ";" y "${x}")\nlist(TRANSFORM y APPEND "${x}")', MUCH.format("9:1")),
        (BIG + 'foreach(i RANGE 1000)\nset(x${i} "${x}")\nendforeach()', MUCH.format("9:1")),
        (BIG + 'foreach(i RANGE 1000)\nset_property(GLOBAL APPEND PROPERTY p "${x}")\nendforeach()', LONG.format("9:1")),
        ("math(EXPR x \"1" + "0" * 400 + " / 3\")", "demo/CMakeLists.txt:4:1: math: cannot evaluate `1" + "0" * 400 + " / 3`"),
        ("string(ASCII 99999999999999999999 x)", "demo/CMakeLists.txt:4:1: string(ASCII): character with code 99999999999999999999 does not exist"),
    ],
)  # fmt: skip
def test_limits(tmp_path: Path, cmake: str, message: str, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    with at_most(20):
        _, workspace = evaluated(tmp_path, cmake)
        assert messages(workspace, tmp_path) == [message]


@pytest.mark.parametrize(
    ("cmake", "message"),
    [
        ('string(REGEX REPLACE "(a+)+b" "" x "${a}")', None),
        ('string(REGEX MATCHALL "(a|a?)+b" x "${a}")', None),
        ('if("${a}" MATCHES "^(a|aa)+$b")\nendif()', None),
        ('list(FILTER a INCLUDE REGEX "(a*)*(a|b)*c")', None),
        ("list(TRANSFORM a REPLACE [[(x+x+)+y]] z)", None),
        ("file(GLOB x *a*a*a*a*a*a*a*a*a*a*a*b)", None),
        ('string(REGEX MATCHALL "a.*b|a" x "${a}")', "string(REGEX MATCHALL): bad regular expression `a.*b|a`: takes more than 0.1 s"),
        ('string(REPEAT "(a|b)*" 500 p)\nstring(REGEX MATCH "${p}c" x "${a}")', "string(REGEX MATCH): bad regular expression `PATTERN`: more than 31 groups"),
        ('foreach(i RANGE 300)\nset(p "${p}${i}.|")\nendforeach()\nif("${a}" MATCHES "${p}x")\nendif()', "bad regular expression `PATTERN`: too large for a text of 1048576 bytes"),
        ('string(REPEAT "(" 9000 p)\nif("a" MATCHES "${p}")\nendif()', "bad regular expression `PATTERN`: missing )"),
    ],
)  # fmt: skip
def test_regular_expressions_that_take_for_ever(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    cmake: str,
    message: str | None,
    at_most: Callable[[float], AbstractContextManager[None]],
) -> None:
    """Of what is matched in time linear in the text nothing is said; of the rest, the command has no effect."""
    monkeypatch.setattr(patterns, "MAX_SECONDS", 0.1)
    (tmp_path / "demo").mkdir()
    (tmp_path / "demo" / ("a" * 250)).touch()
    with at_most(3):
        found, workspace = evaluated(tmp_path, f"string(REPEAT a 1048576 a)\n{cmake}\nadd_executable(y x.cpp)\n", {"x.cpp": ""})
        assert [target.name for target in found.targets] == ["y"]
        shown = [re.sub("`[^`]{200}`", "`PATTERN`", text) for text in messages(workspace, tmp_path)]
        assert [text.partition(" ")[2] for text in shown] == ([message] if message else [])


@pytest.mark.parametrize(
    ("expression", "text", "expected"),
    [
        ("^a.c$", "a\nc", "a\nc|0"),  # a dot is any character, also the end of a line
        ("b$", "b\n", ""),
        (r"\d+", "12d", "d|0"),  # a backslash makes a letter a letter
        (r"[\d]+", "1\\d2", "\\d|0"),  # but in brackets it is one
        ("a{2}", "aaa{2}", "a{2}|0"),
        ("[]a]+", "b]a", "]a|0"),
        ("[^]a]+", "]b", "b|0"),
        ("(a|ab)(c|bcd)?", "abcd", "abcd|2"),
        ("(x)?a()", "ba", "a|0"),
    ],
)
def test_the_dialect_of_cmake(tmp_path: Path, expression: str, text: str, expected: str) -> None:
    """As cmake 3.25 has it."""
    _, workspace = evaluated(
        tmp_path, f'string(REGEX MATCH [==[{expression}]==] m [==[{text}]==])\nmessage(FATAL_ERROR "${{m}}|${{CMAKE_MATCH_COUNT}}")'
    )
    assert messages(workspace, tmp_path)[0].partition("FATAL_ERROR): ")[2] == (expected or "|")


def test_a_limit_in_an_included_file_is_told_there(tmp_path: Path) -> None:
    _, workspace = evaluated(tmp_path, "add_subdirectory(sub)", {"sub/CMakeLists.txt": "\nwhile(TRUE)\nset(x a${x}${x})\nendwhile()\n"})
    assert messages(workspace, tmp_path) == ["demo/sub/CMakeLists.txt:3:1: a value of more than 4194304 characters, evaluation stopped"]


def test_properties_that_take_for_ever(tmp_path: Path) -> None:
    cmake = "add_executable(x x.cpp)\nset(d $<1:a>)\nforeach(i RANGE 16)\nset(d ${d}${d})\nendforeach()\ntarget_compile_definitions(x PRIVATE ${d})\n"
    package(tmp_path, "demo", cmake, {"x.cpp": ""})
    workspace = discover(tmp_path, timeout=1.0)
    assert messages(workspace, tmp_path) == ["demo/CMakeLists.txt:1:1: package demo not done after 1 s, left out"]
    assert workspace.packages == ()


def test_a_long_list_is_built_in_linear_time(tmp_path: Path, at_most: Callable[[float], AbstractContextManager[None]]) -> None:
    cmake = "foreach(i RANGE 8000)\nlist(APPEND S s${i}.cpp)\nendforeach()\nlist(LENGTH S n)\nproject(n${n})\nadd_executable(${PROJECT_NAME} x.cpp)\n"
    with at_most(5):
        found, workspace = evaluated(tmp_path, cmake, {"x.cpp": ""})
        assert [target.name for target in found.targets] == ["n8001"]
        assert workspace.diagnostics == ()


@pytest.mark.parametrize(
    ("cmake", "message"),
    [
        ("a(" * 20_000, "4:40025: syntax error: unexpected end of file, is a `)` missing?"),
        ("a(\n" * 20_000, "20004:1: syntax error: unexpected end of file, is a `)` missing?"),
        ("a(" + "[[ " * 20_000, "4:60027: syntax error: unexpected end of file, is a `)` missing?"),
        ("#[[ \n" * 20_000, "4:25: syntax error: `#[[` is not closed"),
        ('a(x" ' * 20_001, '4:100028: syntax error: unexpected `"`'),
        ("${" * 20_000, f"4:25: syntax error: unexpected `{'${' * 30}`"),
        (f'set(x "{"${" * 20_000}{"}" * 20_000}")', None),
        (f'set(x "{"${" * 20_000}")', None),
        (f'set(x "{"$<1:" * 20_000}")', None),
        (f"if({'(' * 20_000}{')' * 20_000})\nendif()", "4:25: CMake code nests too deeply, evaluation stopped"),
    ],
)  # fmt: skip
def test_broken_code_is_read_in_linear_time(
    tmp_path: Path, cmake: str, message: str | None, at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    with at_most(5):
        _, workspace = evaluated(tmp_path, f"add_executable(y x.cpp) {cmake}", {"x.cpp": ""})
    assert [target.name for target in workspace.packages[0].targets] == ["y"]
    assert messages(workspace, tmp_path) == ([f"demo/CMakeLists.txt:{message}"] if message else [])


def test_time_limits_nest() -> None:
    with pytest.raises(OutOfTime), time_limit(0.4):
        with time_limit(30):
            time.sleep(0.1)
        with pytest.raises(OutOfTime), time_limit(0.1):
            time.sleep(30)
        time.sleep(30)
    time.sleep(0.1)


def test_other_threads_have_no_time_limit() -> None:
    done: list[bool] = []

    def work() -> None:
        with time_limit(0.01):
            time.sleep(0.1)
            done.append(True)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert done == [True]
