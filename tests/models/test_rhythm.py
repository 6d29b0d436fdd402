"""What counters let through: how many of as many messages, or rounds of a timer."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from rosarch.base.logic import TRUE
from rosarch.base.places import Place
from rosarch.models import formula
from rosarch.models.behavior import NOTHING, Periodic, Reactive, StateVariable, Transition
from rosarch.models.rhythm import MOST_CHANGES, Reactions, Rhythm, Used, rhythms, used_up, way_needs, with_few_changes, with_numbers


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
    assert list(rhythms(Reactions(document))) == [Rhythm("p1", "p2", "", 0, rounds, sends)]


@pytest.mark.parametrize(
    "document",
    [
        _counting("0", "++n_ % 10 == 0 && ready", ("++n_", None)),
        _counting("start", "++n_ % 10 == 0", ("++n_", None)),
        _counting("0", "++n_ % 10 == 0", ("++n_", "ready")),
        _counting("0", "n_ >= 3", ("++n_", None), ("read()", "n_ >= 3")),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"repeated": [["n.cpp:10"]]}),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"changed_at_once": [["N::n_", "n.cpp:10", "n.cpp:30"]]}),
        _counting("0", "++n_ % 10 == 0", ("++n_", None), traits={"may_be_missed": [["n.cpp:10"]]}),
        _counting("0", "++n_ % 1000 == 0", ("++n_", None)),
        _counting("", "n_.size() >= 3", ("n_.push_back(x)", None), ("n_.clear()", "n_.size() >= 3"), type_="boost::circular_buffer<int>"),
        {**_counting("0", "++n_ % 10 == 0", ("++n_", None)), "reactive": []},
    ],
    ids=["more", "start", "condition", "value", "loop", "threads", "orders", "large", "ring", "nothing"],
)
def test_no_rhythm_is_told_of_what_hangs_on_more(document: dict[str, Any]) -> None:
    assert list(rhythms(Reactions(document))) == []


def test_others_that_count_too_leave_no_rhythm() -> None:
    document = _counting("0", "++n_ % 10 == 0", ("++n_", None))
    reset = {"variable": "N::n_", "trigger": ["p3"], "value": "0", "guard": None, "at": "n.cpp:30"}
    assert list(rhythms(Reactions({**document, "transitions": [*document["transitions"], reset]}))) == []


def test_a_timer_counts_behind_where_it_is_made() -> None:
    counted = {"variable": "N::n_", "trigger": ["periodic"], "timed_by": ["n.cpp:5"], "value": "++n_", "guard": None, "at": "n.cpp:10"}
    again = {**counted, "value": "0", "guard": "++n_ >= 4", "at": "n.cpp:11"}
    tree = {"all": [{"condition": "++n_ >= 4", "holds": True, "at": "n.cpp:10"}]}
    sent = {"mechanism": "timer", "hz": 20.0, "publishes": ["p2"], "at": "n.cpp:5", "conditional": "++n_ >= 4", "conditional_tree": tree}
    variable = {"name": "N::n_", "type": "int", "initial": "0", "at": "n.h:3"}
    document = {"state_variables": [variable], "transitions": [counted, again], "periodic": [sent]}
    assert list(rhythms(Reactions(document))) == [Rhythm("n.cpp:5", "p2", "", 0, 4, 1)]
    other = {**counted, "timed_by": ["n.cpp:6"]}
    assert list(rhythms(Reactions({**document, "transitions": [other, again]}))) == []


def test_a_rhythm_that_a_parameter_gives() -> None:
    document = _counting("skip_", "--n_ == 0", ("--n_", None), ("skip_", "--n_ == 0"), traits={"keeps_value_of": [["skip_", "~skip"]]})
    assert list(rhythms(Reactions(document))) == [Rhythm("p1", "p2", "~skip", 1, 0, 1)]
    document = _counting("0", "++n_ > skip_", ("++n_", None), ("0", "++n_ > skip_"), traits={"keeps_value_of": [["skip_", "~skip"]]})
    assert list(rhythms(Reactions(document))) == [Rhythm("p1", "p2", "~skip", 1, 1, 1)]


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
    assert list(way_needs(TRUE, kept)) == [(False, [])]


def test_constants_have_names() -> None:
    document = _counting("0", "++n_ >= MOST", ("++n_", None), ("0", "++n_ >= MOST"), traits={"names_number": [["MOST", "6"]]})
    assert list(rhythms(Reactions(document))) == [Rhythm("p1", "p2", "", 0, 6, 1)]


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
    assert bool(list(rhythms(Reactions(_counting("0", guard, ("++n_", None), type_=type_))))) is told


def test_an_unsigned_counter_is_never_below_zero() -> None:
    assert list(rhythms(Reactions(_counting("1", "--n_ < 1", ("--n_", None), type_="int")))) == [Rhythm("p1", "p2", "", 0, 1, 1)]
    assert list(rhythms(Reactions(_counting("1", "--n_ < 1", ("--n_", None), type_="unsigned int")))) == []


def _timed(variable: dict[str, Any], sent: str, *changes: tuple[str, str | None]) -> dict[str, Any]:
    """A timer that changes a variable and sends where a condition holds behind that."""
    rows = [
        {"variable": variable["name"], "trigger": ["periodic"], "timed_by": ["n.cpp:5"], "value": value, "guard": guard, "at": f"n.cpp:{line}",
         "guard_tree": {"all": [{"condition": guard, "holds": True, "at": "n.cpp:9"}]} if guard else None}
        for line, (value, guard) in enumerate(changes, 10)
    ]  # fmt: skip
    tree = {"all": [{"condition": sent, "holds": True, "at": "n.cpp:20"}]}
    loop = {"mechanism": "timer", "hz": 20.0, "publishes": ["p2"], "at": "n.cpp:5", "conditional": sent, "conditional_tree": tree}
    return {"state_variables": [variable], "transitions": rows, "periodic": [loop]}


@pytest.mark.parametrize(
    ("variable", "sent", "changes", "rounds", "sends"),
    [
        ({"name": "N::on_", "type": "bool", "initial": "false", "at": "n.h:3"}, "on_", [("!on_", None)], 2, 1),
        ({"name": "N::flip", "type": "bool", "initial": "True", "at": "n.py:3"}, "self.flip", [("not self.flip", None)], 2, 1),
        ({"name": "N::first_", "type": "bool", "initial": "true", "at": "n.h:3"}, "first_", [("false", "first_")], 1, 0),
        ({"name": "N::step_", "type": "Step", "initial": "Step::A", "at": "n.h:3"}, "step_ == Step::B",
         [("Step::B", "step_ == Step::A"), ("Step::A", "!(step_ == Step::A)")], 2, 1),
    ],
)  # fmt: skip
def test_a_state_that_a_timer_alone_changes_gives_a_rhythm(
    variable: dict[str, Any], sent: str, changes: list[tuple[str, str | None]], rounds: int, sends: int
) -> None:
    assert list(rhythms(Reactions(_timed(variable, sent, *changes)))) == [Rhythm("n.cpp:5", "p2", "", 0, rounds, sends)]


def test_a_state_that_may_begin_as_either_gives_no_rhythm() -> None:
    variable = {"name": "N::on_", "type": "bool", "initial": None, "at": "n.h:3"}
    assert list(rhythms(Reactions(_timed(variable, "on_", ("false", "on_"))))) == []


def test_a_sliding_window_sends_for_each_once_it_is_full() -> None:
    window = ("w_.push_back(x)", None), ("w_.pop_front()", "w_.size() > size_")
    document = _timed({"name": "N::w_", "type": "std::deque<float>", "initial": None, "at": "n.h:3"}, "!(w_.size() < size_)", *window)
    document = {**document, "traits": {"keeps_value_of": [["size_", "size"]]}}
    assert list(rhythms(Reactions(document))) == [Rhythm("n.cpp:5", "p2", "size", 0, 1, 1)]


def _flag(*changes: tuple[str, str | None, str], guard: str = "new_") -> dict[str, Any]:
    """A timer that sends where a flag is set; changes as (value, guard, trigger)."""
    rows = [
        {"variable": "N::new_", "trigger": [trigger], "timed_by": ["n.cpp:5"] if trigger == "periodic" else None, "value": value, "guard": condition,
         "at": f"n.cpp:{line}", "guard_tree": {"all": [{"condition": condition, "holds": True, "at": "n.cpp:20"}]} if condition else None}
        for line, (value, condition, trigger) in enumerate(changes, 10 if changes[0][2] != "periodic" else 22)
    ]  # fmt: skip
    tree = {"all": [{"condition": guard, "holds": True, "at": "n.cpp:20"}]}
    loop = {"mechanism": "timer", "hz": 20.0, "publishes": ["p2"], "at": "n.cpp:5", "conditional": guard, "conditional_tree": tree}
    ports = [{"id": "p1", "kind": "subscriber"}, {"id": "p2", "kind": "publisher"}, {"id": "p3", "kind": "service_server"}]
    variable = {"name": "N::new_", "type": "bool", "initial": "false", "at": "n.h:3"}
    return {"ports": ports, "state_variables": [variable], "transitions": rows, "periodic": [loop]}


@pytest.mark.parametrize(
    ("document", "each"),
    [
        (_flag(("true", None, "p1"), ("false", "new_", "periodic")), True),
        (_flag(("true", "m.ok", "p1"), ("false", "new_", "periodic")), False),
        (_flag(("true", None, "p1"), ("false", "new_ && ok()", "periodic"), guard="new_ && ok()"), False),
    ],
)
def test_what_is_sent_once_for_what_came(document: dict[str, Any], each: bool) -> None:
    assert list(used_up(Reactions(document))) == [Used("n.cpp:5", "p2", "p1", each)]


@pytest.mark.parametrize(
    "document",
    [
        _flag(("true", None, "p1"), ("false", "new_ && ok()", "periodic")),  # sent again as long as not ok
        _flag(("true", None, "p1"), ("false", "stop", "p1")),  # nothing takes it away
        _flag(("true", None, "p3"), ("false", "new_", "periodic")),  # a service sets it
        {
            **_flag(("true", None, "p1"), ("false", "new_", "periodic")),
            "traits": {"changed_at_once": [["N::new_", "n.cpp:10", "n.cpp:11"]]},
        },
    ],
)
def test_what_may_be_sent_more_often_than_something_came(document: dict[str, Any]) -> None:
    assert list(used_up(Reactions(document))) == []


def test_nothing_is_claimed_of_what_is_not_clear() -> None:
    document = _timed({"name": "N::on_", "type": "bool", "initial": "false", "at": "n.h:3"}, "on_", ("!on_", None))
    (variable,) = document["state_variables"]
    assert list(rhythms(Reactions({**document, "state_variables": [{**variable, "from_param": "on"}]}))) == []
    tree = {"all": [{"condition": "on_", "holds": True, "at": place} for place in ("n.cpp:9", "n.cpp:20")]}
    again = _timed({**variable, "initial": "true"}, "on_", ("false", "on_"))
    assert list(rhythms(Reactions({**again, "periodic": [{**again["periodic"][0], "conditional_tree": tree}]}))) == []
    kept = _flag(("true", None, "p1"), ("false", "new_", "periodic"))
    assert list(used_up(Reactions({**kept, "traits": {"may_be_missed": [["n.cpp:10"]]}}))) == []


def test_reactions_that_change_very_much_are_left_out_with_what_they_change() -> None:
    def change(variable: str, *trigger: str, line: int, timed_by: tuple[Place, ...] = ()) -> Transition:
        return Transition(variable, None, trigger, TRUE, "1", Place("n.cpp", line, 1), timed_by)

    timer = Place("n.cpp", 9, 1)
    many = [change("N::a_", "p1", line=line) for line in range(100, 101 + MOST_CHANGES)]
    few = [change("N::b_", "p2", line=7), change("N::c_", "periodic", line=8, timed_by=(timer,))]
    also = change("N::a_", "p2", line=10)
    behavior = replace(
        NOTHING,
        transitions=(*many, *few, also),
        state_variables=tuple(StateVariable(f"N::{name}_", "int", "0", None, None, timer) for name in "abc"),
        reactive=tuple(Reactive(port, "out", (timer,), False, TRUE) for port in ("p1", "p2")),
        periodic=(Periodic("timer", 10.0, None, ("out",), timer, TRUE),),
    )
    found = with_few_changes(behavior)
    assert found.transitions == tuple(few)
    assert [each.name for each in found.state_variables] == ["N::b_", "N::c_"]
    assert [each.input for each in found.reactive] == ["p2"] and found.periodic == behavior.periodic
    assert with_few_changes(found) is found
