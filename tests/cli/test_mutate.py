"""`rosarch rules mutate`: tests that pin a rule, and tests that do not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.slow

RULES = """\
/// `call` is a call of a function of this `name` with an argument. May.
.decl own_called(call: Expr, name: symbol)
.output own_called
own_called(C, Name) :- call(C, Name), call_argument(C, 0, _).
"""


def case(folder: Path, names: list[tuple[str, str]], arguments: list[str], expected: list[tuple[str, str]]) -> None:
    for name, rows in (
        ("facts/call.facts", names),
        ("facts/call_argument.facts", [(a, "0", "x") for a in arguments]),
        ("expected/own_called.csv", expected),
    ):
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join("\t".join(row) + "\n" for row in rows))


def test_what_no_test_notices(rosarch: Callable[..., Any], tmp_path: Path) -> None:
    """A test in which every call has an argument does not pin that it needs one; a second test does."""
    (tmp_path / "own.dl").write_text(RULES)
    case(tmp_path / "tests" / "one", [("c", "f")], ["c"], [("c", "f")])
    found = rosarch("rules", "mutate", tmp_path / "tests", "--rules", tmp_path / "own.dl")
    assert (found.code, found.out, found.err) == (
        1,
        f"{tmp_path}/own.dl:4: without call_argument(C, 0, _)\n1 of 2 mutants killed (50.0%)\n",
        "",
    )
    case(tmp_path / "tests" / "two", [("c", "f"), ("d", "g")], ["c"], [("c", "f")])
    found = rosarch("rules", "mutate", tmp_path / "tests", "--rules", tmp_path / "own.dl")
    assert (found.code, found.out) == (0, "2 of 2 mutants killed (100.0%)\n")


def test_expectations_notice_what_they_are_about(rosarch: Callable[..., Any], tmp_path: Path) -> None:
    """What is expected of a model is met whatever rows a relation has that no model is made from."""
    (tmp_path / "own.dl").write_text(RULES)
    source = tmp_path / "tests" / "node.cpp"
    source.parent.mkdir()
    source.write_text(
        '#include <ros/ros.h>\n#include <std_msgs/Empty.h>\n// expect: publisher /out\n'
        'int main() { ros::NodeHandle nh; ros::Publisher pub = nh.advertise<std_msgs::Empty>("/out", 1); ros::spin(); }\n'
    )  # fmt: skip
    found = rosarch("rules", "mutate", tmp_path / "tests", "--rules", tmp_path / "own.dl")
    assert (found.code, found.out.splitlines()[-1]) == (1, "0 of 2 mutants killed (0.0%)")
    source.write_text(source.read_text().replace("publisher /out", 'Count = count : { own_called(_, "advertise") }, Count = 1'))
    found = rosarch("rules", "mutate", tmp_path / "tests", "--rules", tmp_path / "own.dl")
    assert found.out.splitlines()[-1] == "1 of 2 mutants killed (50.0%)"
