"""Facts of Python programs."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from rosarch.extractor.facts import validate
from rosarch.extractor.python.extract import Rows, extract_program
from rosarch.extractor.workspace.model import PythonEntry


def extract(folder: Path, source: str | bytes, function: str | None = None, **others: str) -> tuple[Rows, list[str]]:
    """The facts of a program, whose modules are called `main` and like the `others`, and its problems without their file."""
    sources = {"main": source, **others}
    modules = []
    for name, text in sources.items():
        path = folder / f"{name.replace('.', '/')}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        modules.append((name.removesuffix(".__init__"), path))
    rows, problems = extract_program(folder, PythonEntry(folder / "main.py", "main", function, (folder,), tuple(modules)))
    validate(rows)
    return rows, [f"{line}:{column}: {message}" for _, line, column, message in problems]


def callees(rows: Rows) -> dict[str, set[str]]:
    """The names of the functions that each call enters, by the line of the call."""
    names = dict(rows["function_name"])
    found: dict[str, set[str]] = {}
    for call, function in rows["call_function"]:
        found.setdefault(str(call).split(":")[1], set()).add(str(names[function]))
    return found


def test_names_lead_through_modules(tmp_path: Path) -> None:
    rows, problems = extract(
        tmp_path,
        "import pkg.deep as d\nfrom pkg import *\nfrom pkg.deep import Base as B\nimport pkg\n"
        "d.run()\nrun()\nB().go()\npkg.deep.run()\nhelper()\nTwist()\npkg.below()\n",
        **{
            "pkg.__init__": "from .deep import run\nfrom .tools import helper\nfrom geometry_msgs.msg import Twist\n"
            "from . import deep\ndef below():\n    deep.dig()\n",
            "pkg.deep": "def run(): pass\ndef dig(): pass\nclass Base:\n    def go(self): pass\n",
            "pkg.tools": "try:\n    from nowhere import helper\nexcept ImportError:\n    from .deep import run as helper\n",
        },
    )
    assert problems == []
    found = callees(rows)
    assert found["5"] == found["6"] - {"pkg.deep::dig"} == found["8"] == found["9"] == {"pkg.deep::run"}
    assert "pkg.deep::dig" in found["6"]  # of the package, which imports the module below it
    assert found["7"] == {"pkg.deep::Base::go"}
    assert found["10"] == {"geometry_msgs.msg::Twist::__init__"}
    assert ("geometry_msgs.msg::Twist", "message", "geometry_msgs/Twist") in rows["message_class"]


def test_methods_are_found_through_bases_members_and_containers(tmp_path: Path) -> None:
    rows, _ = extract(
        tmp_path,
        "from base import Base\nclass Part:\n    def move(self): pass\n"
        "class Robot(Base):\n    def __init__(self):\n        super().__init__('r')\n        self.part = Part()\n        self.parts = [Part()]\n"
        "    def step(self):\n        self.part.move()\n        for part in self.parts:\n            part.move()\n        self.tell()\n"
        "    def hook(self): pass\n"
        "def use(robot):\n    robot.step()\nuse(Robot())\n",
        base="class Base(object):\n    def __init__(self, name):\n        self.name = name\n    def tell(self):\n        self.hook()\n    def hook(self): pass\n",
    )
    found = callees(rows)
    assert found["6"] == {"base::Base::__init__"}
    assert found["10"] == found["12"] == {"main::Part::move"}
    assert found["13"] == {"base::Base::tell"}
    assert found["16"] == {"main::Robot::step"}
    names = dict(rows["function_name"])
    assert {(names[a], names[b]) for a, b in rows["function_overrides"]} == {("main::Robot::hook", "base::Base::hook")}
    types = dict(rows["variable_type"])
    assert (types["base::Base::name"], types["main::Robot::part"], types["main::Robot::parts"]) == ("str", "main::Part object", "list")


def test_arguments_stand_at_the_index_of_their_parameter(tmp_path: Path) -> None:
    rows, _ = extract(tmp_path, "import rospy\nrospy.Publisher('a', queue_size=5, data_class=int)\nf(1, how=2)\n")
    arguments = {(call.split(":")[1], index): dict(rows["expr_text"]).get(value) for call, index, value in rows["call_argument"]}
    assert arguments == {("2", 0): "'a'", ("2", 6): "5", ("2", 1): "int", ("3", 0): "1"}
    assert {name for _, name in rows["keyword_argument"]} == {"how"}


def test_getters_are_calls_and_constants_of_enumerations_literals(tmp_path: Path) -> None:
    rows, _ = extract(
        tmp_path,
        "from enum import Enum\nclass S(Enum):\n    IDLE = 0\nclass A:\n    @property\n    def state(self):\n        return S.IDLE\nprint(A().state)\n",
    )
    assert "main::A::state" in callees(rows)["8"]
    assert ("enum", "main::S::IDLE") in {row[1:] for row in rows["literal"]}


def test_what_a_loop_else_and_finally_follow(tmp_path: Path) -> None:
    source = "def f(a):\n    while a:\n        if g(): break\n    else:\n        h()\n    try:\n        i()\n    except E:\n        j()\n    finally:\n        k()\n"
    rows, _ = extract(tmp_path, source)
    blocks = {expr.split(":")[1]: block for block, _, expr in rows["block_expr"] if ":call" in str(expr)}
    edges = {(a, b) for a, b, _ in rows["block_edge"]}

    def leads(start: str, end: str) -> bool:
        seen, waiting = {blocks[start]}, [blocks[start]]
        while waiting:
            here = waiting.pop()
            new = {b for a, b in edges if a == here} - seen
            seen |= new
            waiting += new
        return blocks[end] in seen

    assert leads("3", "7") and leads("5", "7") and leads("7", "9") and leads("9", "11") and not leads("9", "3")
    assert {label for a, b, label in rows["block_edge"] if a == blocks["3"] and b == blocks["5"]} == set()
    assert ("while",) in {row[1:] for row in rows["loop_head"]}


def test_modules_imported_by_a_name_that_is_written_out(tmp_path: Path) -> None:
    rows, problems = extract(
        tmp_path,
        "import importlib\nimportlib.import_module('pkg.one').go()\n__import__('pkg.one').one.go()\n__import__('pkg.one', fromlist=['go']).go()\n",
        **{"pkg.__init__": "X = 1\n", "pkg.one": "def go(): pass\n"},
    )
    assert problems == []
    assert all("pkg.one::go" in callees(rows)[line] for line in "234")
    assert sum(name == "import" for _, name in rows["call"]) >= 3


def test_main_is_what_is_run_and_not_what_is_imported(tmp_path: Path) -> None:
    source = "def main(): pass\nif __name__ == '__main__':\n    main()\n"
    script, _ = extract(tmp_path, source)
    imported, _ = extract(tmp_path, source, function="main")
    assert {value for _, value in script["expr_constant"]} == {"1"}
    assert {value for _, value in imported["expr_constant"]} == {"0"}
    assert (len(script["program_entry"]), len(imported["program_entry"])) == (1, 2)


def test_what_is_not_understood_is_told_and_the_rest_is_read(tmp_path: Path) -> None:
    rows, problems = extract(tmp_path, "def ok(): pass\nok()\ndef broken(:\n")
    assert problems == ["3:12: syntax error: invalid syntax; what stands from line 3 on is left out"]
    assert {row[1:] for row in rows["source_lost"]} == {(3, 3, "a syntax error, with all that follows")}
    rows, problems = extract(tmp_path, "class A:\n\tdef f(self):\n\t\tprint 'x', self\n        def g(self): pass\nA().g()\n")
    assert problems == ["3:3: Python 2: read as what 2to3 makes of it"]
    assert callees(rows)["5"] == {"main::A::g"}
    taken_apart = "def f((a, b), (c, d)):\n    '''Doc.'''\n    g(a)\ndef g(a): pass\ntry:\n    g(1)\nexcept OSError, (a, b):\n    g(2)\n"
    assert set(callees(extract(tmp_path, taken_apart)[0])) == {"3", "6", "8"}  # not those of the lines that 2to3 adds
    assert extract(tmp_path, b"a = 1\nb = '\0'\n") == ({}, ["2:1: not a text file"])
    assert extract(tmp_path, b"# -*- coding: latin-1 -*-\na = '\xe4'\n")[1] == []
    assert extract(tmp_path, b"a = '\xe4'\n")[1] == ["1:6: not UTF-8 (byte 0xe4); read as Latin-1"]
    assert extract(tmp_path, "import importlib\nimportlib.import_module('a')\nimportlib.import_module(b)\n")[1] == [
        "3:1: imports a module by a name that is made up at run time; it is not read"
    ]
    assert len(extract(tmp_path, "a = " + "(" * 5000 + ")" * 5000)[1]) == 1
    assert len(extract(tmp_path, "a = " + "-" * 50000 + "1")[1]) == 1


@pytest.mark.parametrize(
    ("source", "problems"),
    [
        ("super()." * 10_000 + "x", ["1:1: not analysed: nested too deeply"]),
        ("-1" * 10_000, ["1:1: not analysed: nested too deeply"]),
        ("f = " + "-" * 1800 + "1", []),
        (("1" + "-1" * 1400 + "\n") * 4, []),
        ("999999999999999" + " * 999999999999999" * 400, []),
        ("if x: pass\n" + "elif x: pass\n" * 5000, ["1:1: not analysed: nested too deeply"]),
        ("x = " + "(" * 100_000, ["1:205: syntax error: too many nested parentheses; what stands from line 1 on is left out"]),
        ("import a" + ".imports" * 1000 + "\nimport " + "rospy" * 500, []),
        ("x = " + " or ".join(["a"] * 10_000), []),
        ("a0 = 1\n" + "".join(f"a{n + 1} = a{n}\n" for n in range(3000)), []),
        ("".join(f"def f{n}(): return f{n + 1}()\n" for n in range(3000)), []),
        ("class C0: pass\n" + "".join(f"class C{n + 1}(C{n}): pass\n" for n in range(1000)), []),
    ],
)  # fmt: skip
def test_what_is_deep_long_or_chained(
    tmp_path: Path, source: str, problems: list[str], at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    with at_most(4):
        rows, told = extract(tmp_path, source + "\n")
    assert told == problems
    assert problems or rows["source_file"]


def test_modules_that_import_each_other_and_themselves(tmp_path: Path) -> None:
    rows, problems = extract(
        tmp_path, "from other import *\nfrom main import *\nf()\nclass A(A): pass\n", other="from main import *\nfrom other import *\n"
    )
    assert problems == [] and ("main::A", "main::A") not in rows.get("class_base", ())


def test_an_assignment_to_a_property_calls_its_setter(tmp_path: Path) -> None:
    source = (
        "class A:\n    @property\n    def level(self):\n        return 1\n    @level.setter\n    def level(self, value):\n"
        "        self.x = value\n    def f(self):\n        self.level = 5\n"
    )
    rows, _ = extract(tmp_path, source)
    assert callees(rows)["9"] == {"main::A::level"}
    texts = dict(rows["expr_text"])
    assert {(index, texts[value]) for call, index, value in rows["call_argument"] if str(call).split(":")[1] == "9"} == {(0, "5")}
    assert not [expr for expr, sign in rows["operator"] if sign == "=" and str(expr).split(":")[1] == "9"]


def test_parts_of_what_is_unpacked_are_told_apart(tmp_path: Path) -> None:
    rows, _ = extract(tmp_path, "a = b = c = d = 0\na, b = f()\nc, d = 1, 2\nc, d = d, c\n")
    texts, parts = dict(rows["expr_text"]), {(expr, index): part for expr, index, part in rows["operand"]}
    given = [
        (texts[parts[expr, 0]], texts[parts[expr, 1]]) for expr, sign in rows["operator"] if sign == "=" and str(expr).split(":")[1] != "1"
    ]
    assert set(given) == {("a", "f()[0]"), ("b", "f()[1]"), ("c", "1"), ("d", "2"), ("c", "(d, c)[0]"), ("d", "(d, c)[1]")}


def test_texts_are_written_with_one_kind_of_quotes(tmp_path: Path) -> None:
    rows, _ = extract(tmp_path, 'print(f("x"), f(\'x\'), f("it\'s"))\n')
    texts = {text for _, text in rows["expr_text"]}
    assert {"f('x')", 'f("it\'s")'} <= texts and 'f("x")' not in texts


def test_an_assertion_raises_and_elements_may_be_absent(tmp_path: Path) -> None:
    rows, _ = extract(
        tmp_path, "def f(d, k):\n    assert k > 0, 'k'\n    try:\n        d[k]\n    except KeyError:\n        return 1\n    return 2\n"
    )
    assert {str(expr).split(":")[1] for expr, sign in rows["operator"] if sign == "throw"} == {"2"}
    element = next(expr for expr, sign in rows["operator"] if sign == "[]")
    block = next(block for block, _, expr in rows["block_expr"] if expr == element)
    assert "exception" in {label for start, _, label in rows["block_edge"] if start == block}


@pytest.mark.parametrize(
    "source",
    [
        "".join(f"{' ' * n}try:\n{' ' * n} f()\n{' ' * n}finally:\n" for n in range(60)) + " " * 60 + "f()\n",
        "def g(x):\n try:\n" + "".join(f"  if x == {n}:\n   return f()\n" for n in range(500)) + " finally:\n" + "  f()\n" * 500,
    ],
)
def test_what_is_in_finally_is_not_read_for_all_ways_where_these_are_many(tmp_path: Path, source: str) -> None:
    rows, _ = extract(tmp_path, f"def f(): pass\n{source}")
    assert len(rows["call"]) < 10_000


def test_what_is_in_finally_is_read_for_each_way(tmp_path: Path) -> None:
    rows, _ = extract(tmp_path, "def f(): pass\ndef g():\n try:\n  return 1\n finally:\n  f()\n")
    assert len(rows["call"]) == 3
