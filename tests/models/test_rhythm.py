"""What counters let through: how many of as many messages, or rounds of a timer."""

from __future__ import annotations

from typing import Any

import pytest

from rosarch.models import formula
from rosarch.models.rhythm import Rhythm, rhythms, way_needs, with_numbers


def _counting(
    initial: str, guard: str, *changes: tuple[str, str | None], type_: str = "int", traits: dict[str, Any] | None = None
) -> dict[str, Any]:
    rows = [
        {"variable": "N::n_", "trigger": ["p1"], "value": value, "guard": condition, "at": f"n.cpp:{line}"}
        for line, (value, condition) in enumerate(changes, 10)
    ]
    sent = {"input": "p1", "output": "p2", "when": guard, "must": False, "at": ["n.cpp:20"]}
    variable = {"name": "N::n_", "type": type_, "initial": initial, "at": "n.h:3"}
    return {"state_variables": [variable], "transitions": rows, "reactive": [sent], "traits": traits or {}}


@pytest.mark.parametrize(
    ("document", "rounds", "sends"),
    [
        (_counting("0", "++n_ % 10 == 0", ("++n_", None)), 10, 1),
        (_counting("0", "n_++ % 4 == 0", ("n_++", None)), 4, 1),
        (_counting("0", "n_ % 3", ("n_ + 1", None)), 3, 2),
        (_counting("0", "++n_ >= 5", ("++n_", None), ("0", "++n_ >= 5")), 5, 1),
        (_counting("4", "--n_ == 0", ("--n_", None), ("4", "--n_ == 0")), 4, 1),
        (_counting("0", "n_ == 0", ("(n_ + 1) % 6", None)), 6, 1),
        (_counting("0", "n_ < 3", ("n_ + 1", "n_ < 3")), 1, 0),
        (_counting("0", "n_ <= 3", ("n_ + 1", None)), 1, 0),
        (_counting("[]", "len(self.n_) >= 4", ("self.n_.append(x)", None), ("self.n_.clear()", "len(self.n_) >= 4"), type_="list"), 4, 1),
        (_counting("", "!(n_.size() < 3)", ("n_.push_back(x)", None), ("n_.clear()", "!(n_.size() < 3)"), type_="std::vector<int>"), 3, 1),
    ],
)  # fmt: skip
def test_a_counter_gives_a_rhythm(document: dict[str, Any], rounds: int, sends: int) -> None:
    assert list(rhythms(document)) == [Rhythm("p1", "p2", "", rounds, sends)]


@pytest.mark.parametrize(
    "document",
    [
        _counting("0", "++n_ % 10 == 0 && ready", ("++n_", None)),
        _counting("start", "++n_ % 10 == 0", ("++n_", None)),
        _counting("0", "++n_ % 10 == 0", ("++n_", "ready")),
        _counting("0", "n_ >= 3", ("++n_", None), ("read()", "n_ >= 3")),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"repeated": [["n.cpp:10"]]}),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"changed_at_once": [["N::n_", "n.cpp:10", "n.cpp:30"]]}),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"several_orders": [["n.cpp:10", "n.cpp:20"]]}),
        _counting("0", "++n_ % 1000 == 0", ("++n_", None)),
        _counting("", "n_.size() >= 3", ("n_.push_back(x)", None), ("n_.clear()", "n_.size() >= 3"), type_="boost::circular_buffer<int>"),
        {**_counting("0", "++n_ % 10 == 0", ("++n_", None)), "reactive": []},
    ],
    ids=["more", "start", "condition", "value", "loop", "threads", "orders", "large", "ring", "nothing"],
)
def test_no_rhythm_is_told_of_what_hangs_on_more(document: dict[str, Any]) -> None:
    assert list(rhythms(document)) == []


def test_others_that_count_too_leave_no_rhythm() -> None:
    document = _counting("0", "++n_ % 10 == 0", ("++n_", None))
    reset = {"variable": "N::n_", "trigger": ["p3"], "value": "0", "guard": None, "at": "n.cpp:30"}
    assert list(rhythms({**document, "transitions": [*document["transitions"], reset]})) == []


def test_a_timer_counts_behind_where_it_is_made() -> None:
    counted = {"variable": "N::n_", "trigger": ["periodic"], "timed_by": ["n.cpp:5"], "value": "++n_", "guard": None, "at": "n.cpp:10"}
    again = {**counted, "value": "0", "guard": "++n_ >= 4", "at": "n.cpp:11"}
    tree = {"all": [{"condition": "++n_ >= 4", "holds": True, "at": "n.cpp:10"}]}
    sent = {"mechanism": "timer", "hz": 20.0, "publishes": ["p2"], "at": "n.cpp:5", "conditional": "++n_ >= 4", "conditional_tree": tree}
    variable = {"name": "N::n_", "type": "int", "initial": "0", "at": "n.h:3"}
    document = {"state_variables": [variable], "transitions": [counted, again], "periodic": [sent]}
    assert list(rhythms(document)) == [Rhythm("n.cpp:5", "p2", "", 4, 1)]
    other = {**counted, "timed_by": ["n.cpp:6"]}
    assert list(rhythms({**document, "transitions": [other, again]})) == []


def test_a_rhythm_that_a_parameter_gives() -> None:
    document = _counting("skip_", "--n_ == 0", ("--n_", None), ("skip_", "--n_ == 0"), traits={"keeps_value_of": [["skip_", "~skip"]]})
    assert list(rhythms(document)) == [Rhythm("p1", "p2", "~skip", 0, 1)]
    document = _counting("0", "++n_ > skip_", ("++n_", None), ("0", "++n_ > skip_"), traits={"keeps_value_of": [["skip_", "~skip"]]})
    assert list(rhythms(document)) == [Rhythm("p1", "p2", "~skip", 1, 1)]


def test_names_that_stand_for_numbers() -> None:
    document = {"transitions": [{"guard": 'this->skip_ > a.skip_ && skip_(1) && skip_ == "skip_"', "value": "skip_++", "at": "n.cpp:1"}]}
    (row,) = with_numbers(document, {"skip_": 3})["transitions"]
    assert (row["guard"], row["value"]) == ('3 > a.skip_ && skip_(1) && 3 == "skip_"', "skip_++")


def test_ways_that_parameters_open() -> None:
    kept = {"active_": "~active", "mode_": "~mode"}
    guard = formula.both(formula.condition("active_", True), formula.condition('mode_ == "auto"', False))
    assert list(way_needs(guard, kept)) == [(True, [("~active", "true", True), ("~mode", "auto", False)])]
    guard = formula.both(formula.condition("!this->active_", True), formula.condition("ready_", True))
    assert list(way_needs(guard, kept)) == [(False, [("~active", "true", False)])]
    assert list(way_needs(formula.TRUE, kept)) == [(False, [])]


def test_constants_have_names() -> None:
    document = _counting("0", "++n_ >= MOST", ("++n_", None), ("0", "++n_ >= MOST"), traits={"names_number": [["MOST", "6"]]})
    assert list(rhythms(document)) == [Rhythm("p1", "p2", "", 6, 1)]


@pytest.mark.parametrize(
    ("type_", "guard", "told"),
    [
        ("uint8_t", "++n_ % 4 == 0", True),  # 256 is a multiple of four
        ("uint8_t", "++n_ % 3 == 0", False),  # 255 is sent, and so is 0 behind it
        ("uint8_t", "++n_ < 3", False),  # 0 comes again after 255
        ("std::int8_t", "++n_ == 3", False),
        ("unsigned short", "++n_ == 3", False),
        ("int", "++n_ == 3", True),
        ("uint64_t", "++n_ % 3 == 0", True),
        ("", "++n_ == 3", True),
    ],
)
def test_a_counter_of_few_bits_begins_anew(type_: str, guard: str, told: bool) -> None:
    assert bool(list(rhythms(_counting("0", guard, ("++n_", None), type_=type_)))) is told


def test_an_unsigned_counter_is_never_below_zero() -> None:
    assert list(rhythms(_counting("1", "--n_ < 1", ("--n_", None), type_="int"))) == [Rhythm("p1", "p2", "", 1, 1)]
    assert list(rhythms(_counting("1", "--n_ < 1", ("--n_", None), type_="unsigned int"))) == []
