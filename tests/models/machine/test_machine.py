"""State machines of small documents: what is a state, what is a transition, what cannot happen."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from machine_documents import DOOR, Document, document

from rosarch.models.machine.build import StateMachine, build_machine
from rosarch.reports.machine_labels import formula_text, state_text

MODE = ("N::mode_", "Mode", "Mode::A")


def arrows(machine: StateMachine, region: int = 0) -> set[str]:
    """The transitions of a region as text, those that change nothing and send nothing left out."""
    found = set()
    shown = machine.regions[region]
    for t in shown.transitions:
        if t.visible:
            guard, sent = formula_text(t.guard), ",".join(output.port for output in t.outputs)
            found.add(
                f"{state_text(shown, t.source)} {t.trigger}{f'[{guard}]' if guard else ''}{f'/{sent}' if sent else ''} {state_text(shown, t.target)}"
            )
    return found


def modes(*transitions: tuple[str, str | None, str | None], initial: str | None = "Mode::A", **rest: Sequence) -> StateMachine:
    """A node with one enumeration; its transitions as (trigger, guard, value)."""
    rows = [("N::mode_", trigger, guard, value) for trigger, guard, value in transitions]
    return build_machine(document(variables=[("N::mode_", "Mode", initial)], transitions=rows, **rest))


def test_what_a_condition_chooses_between_is_assigned_under_it() -> None:
    machine = modes(("toggle", None, "mode_ == Mode::A ? Mode::B : Mode::A"), ("set", None, "m.data ? Mode::B : Mode::A"))
    assert arrows(machine) == {"A toggle B", "B toggle A", "A set[m.data] B", "B set[!m.data] A"}


def test_the_cases_of_a_switch_are_arcs_of_their_own() -> None:
    machine = modes(("go", "mode_ == Mode::A", "Mode::B"), ("go", "mode_ == Mode::B", "Mode::C"), ("go", "mode_ == Mode::C", "Mode::A"))
    assert arrows(machine) == {"A go B", "B go C", "C go A"}
    assert machine.regions[0].initial == (0,)
    assert (machine.regions[0].unreachable, machine.dead, machine.messages) == ((), (), ())


def test_else_branches_see_the_value_of_the_first_test() -> None:
    machine = modes(("go", "mode_ == Mode::A", "Mode::B"), ("go", "!(mode_ == Mode::A)", "Mode::A"))
    assert arrows(machine) == {"A go B", "B go A"}


def test_what_is_assigned_before_the_first_test_is_seen() -> None:
    machine = modes(("set", None, "msg->mode"), ("reset", None, "Mode::A"), reactive=[("set", "out", "mode_ == Mode::B")])
    assert arrows(machine) == {
        "A set[msg->mode == B]/out B",
        "B set[msg->mode == A] A",
        "B set[msg->mode == B]/out B",
        "A set[msg->mode not in {A, B}] other",
        "B set[msg->mode not in {A, B}] other",
        "other set[msg->mode == A] A",
        "other set[msg->mode == B]/out B",
        "B reset A",
        "other reset A",
    }


def test_one_input_decides_what_is_assigned_and_what_is_sent() -> None:
    machine = modes(("in", "c == 'a'", "Mode::A"), ("in", "c == 'b'", "Mode::B"), reactive=[("in", "out", "c == 'b'")])
    assert arrows(machine) == {"A in[c == 'b']/out B", "B in[c == 'a'] A", "B in[c == 'b']/out B"}


def test_conditions_of_outputs_alone_split_no_transition() -> None:
    machine = modes(
        ("in", "mode_ == Mode::A", "Mode::B"),
        reactive=[("in", "out", "mode_ == Mode::A && msg->loud"), ("in", "too", "mode_ == Mode::A && far")],
    )
    (transition,) = (t for t in machine.regions[0].transitions if t.visible)
    assert [(output.port, formula_text(output.when)) for output in transition.outputs] == [("out", "msg->loud"), ("too", "far")]


def test_a_publish_that_is_not_always_made_for_unknown_reasons() -> None:
    node = document(reactive=[("in", "out", None)])
    node["reactive"][0]["must"] = False
    (transition,) = build_machine(node).always
    assert transition.outputs[0].sometimes


def test_values_are_copied_between_variables() -> None:
    node = document(
        variables=[MODE, ("N::last_", "Mode", "Mode::A")],
        transitions=[("N::mode_", "flip", "mode_ == Mode::A", "Mode::B"), ("N::last_", "periodic", "last_ != mode_", "mode_")],
        periodic=[(10.0, ["changed"], "last_ != mode_")],
    )
    machine = build_machine(node)
    assert arrows(machine) == {"mode_=A, last_=A flip mode_=B, last_=A", "mode_=B, last_=A periodic/changed mode_=B, last_=B"}
    assert machine.regions[0].unreachable == (("A", "B"),)


@pytest.mark.parametrize(
    ("type_", "initial", "rows", "expected"),
    [
        ("bool", "false", [("in", None, "true"), ("in2", None, "0")], {"false in true", "true in2 false"}),
        ("volatile bool", "false", [("in", None, "!flag_")], {"false in true", "true in false"}),
        ("std::atomic<bool>", "false", [("in", None, "msg.x > 3 && !flag_")], {"false in[msg.x > 3] true", "true in false"}),
        ("int", "0", [("in", "flag_ < 2", "flag_ + 1"), ("in2", "flag_ == 2", "0")], {"0 in 1", "1 in 2", "2 in2 0"}),
        ("int", "0", [("in", "flag_ < 20", "flag_ + 1"), ("in2", "flag_ == 20", "0")], {"0 in other", "other in[flag_ < 20] 20", "other in[flag_ < 20] 0", "20 in2 0"}),
        ("int", "limit", [("in", "flag_ != 0", "--flag_"), ("in2", None, "limit")], {"not 0 in 0", "not 0 in2[limit == 0] 0", "0 in2[limit != 0] not 0"}),
        ("int", "0", [("in", None, "flag_++"), ("in2", "flag_", "0")], {"0 in not 0", "not 0 in2 0"}),
        ("Goal*", "NULL", [("in", "!flag_", "new Goal()"), ("in2", "flag_ != NULL", "nullptr")], {"null in set", "set in2 null"}),
        ("boost::shared_ptr<Goal>", None, [("in", "!flag_", "boost::make_shared<Goal>()")], {"null in set"}),
        ("std::string", '"RED"', [("in", 'flag_ == "RED"', '"GREEN"')], {'"RED" in "GREEN"'}),
        ("std::vector<int>", None, [("in", "flag_.empty()", "flag_.push_back(1)"), ("in2", "flag_.size() > 0", "flag_.clear()")], {"true in false", "false in2 true"}),
        ("std::vector<int>", None, [("in", "flag_.size() < 1", "flag_.push_back(1)")], {"true in false"}),
        ("std::vector<int>", None, [("in", "flag_.size() == 3", "flag_.clear()"), ("in2", None, "flag_.push_back(1)")], {"0 in2 1", "1 in2 2", "2 in2 3", "3 in 0", "3 in2 other"}),
        ("std::map<int, int>", None, [("in", "flag_.size() >= 3", "flag_.erase(3)"), ("in2", None, "flag_.emplace(1, 2)")], {"false in[flag_.size() >= 3] true", "true in2 false"}),
    ],
)  # fmt: skip
def test_kinds_of_variables(type_: str, initial: str | None, rows: list, expected: set[str]) -> None:
    machine = build_machine(document(variables=[("N::flag_", type_, initial)], transitions=[("N::flag_", *row) for row in rows]))
    reached = {arrow.replace(" in[flag_ < 2]", " in") for arrow in arrows(machine)}
    assert reached == expected


def test_an_optional_is_null_or_set() -> None:
    rows = [
        ("N::got_", "copied", None, "*msg"), ("N::got_", "made", None, "Pose()"), ("N::got_", "emplaced", None, "got_.emplace(1)"),
        ("N::got_", "reset", None, "got_.reset()"), ("N::got_", "nothing", "got_.has_value()", "std::nullopt"), ("N::got_", "empty", None, "{}"),
    ]  # fmt: skip
    machine = build_machine(document(variables=[("N::got_", "std::optional<geometry_msgs::msg::Pose_>", None)], transitions=rows))
    assert arrows(machine) == {
        *(f"null {trigger} set" for trigger in ("copied", "made", "emplaced")),
        *(f"set {trigger} null" for trigger in ("reset", "nothing", "empty")),
    }
    assert machine.regions[0].initial == (0,)


def test_what_a_function_gives_may_be_null() -> None:
    rows = [("N::got_", "asked", None, "find()"), ("N::got_", "sent", "got_", "{}")]
    machine = build_machine(document(variables=[("N::got_", "std::optional<Pose>", None)], transitions=rows))
    assert {arrow.partition("[")[0] for arrow in arrows(machine)} == {"null asked", "set asked", "set sent null"}


@pytest.mark.parametrize("given", ["msg", "msg.pose.pose", "std::move(msg)"])
def test_what_is_kept_of_a_message_is_not_null(given: str) -> None:
    rows = [("N::last", "in", None, given), ("N::last", "sent", "last is not None", "None")]
    kept = {**document(variables=[("N::last", "", "None")], transitions=rows), "traits": {"names_message": [["in", "msg"]]}}
    assert arrows(build_machine(kept)) == {"null in set", "set sent null"}


def test_what_a_message_says_may_count_as_false() -> None:
    node = document(
        variables=[("N::on", "object", "false")], transitions=[("N::on", "in", None, "msg.data")], periodic=[(1.0, ["out"], "not self.on")]
    )
    node["traits"] = {"names_message": [["in", "msg"]]}
    assert arrows(build_machine(node)) == {"false in[msg.data] true", "true in[!msg.data] false", "false periodic/out false"}


@pytest.mark.parametrize(
    ("guard", "changes"), [("5 >= 0 && msg.on", {"false in[msg.on] true"}), ("5 < 0 && msg.on", set()), ("3 == 3.0", {"false in true"})]
)
def test_two_numbers_are_compared(guard: str, changes: set[str]) -> None:
    node = document(
        variables=[("N::on_", "bool", "false")], transitions=[("N::on_", "in", guard, "true")], periodic=[(1.0, ["out"], "on_")]
    )
    assert {arrow for arrow in arrows(build_machine(node)) if arrow.startswith("false in")} == changes


def test_fields_are_variables_of_their_own() -> None:
    node = document(
        variables=[("N::cmd_", "Twist", None)],
        transitions=[("N::cmd_", "stop", None, "0.0"), ("N::cmd_", "set", None, "*msg")],
        periodic=[(5.0, ["out"], "cmd_.linear.x != 0")],
    )
    node["transitions"][0]["field"] = "linear.x"
    machine = build_machine(node)
    assert [cell.subject.text for cell in machine.regions[0].cells] == ["cmd_.linear.x"]
    assert "0 set[msg->linear.x != 0] not 0" in arrows(machine)
    assert "not 0 periodic/out not 0" in arrows(machine)


def test_a_first_value_that_is_not_told_may_be_any() -> None:
    machine = modes(("go", "mode_ == Mode::A", "Mode::B"), initial=None)
    assert [state_text(machine.regions[0], state) for state in machine.regions[0].initial] == ["A", "B", "other"]
    static = build_machine(document(variables=[("::flag", "bool", None)], transitions=[("::flag", "in", None, "true")]))
    assert static.regions[0].states[0] == ("false",)


def test_variables_without_finite_values_are_named() -> None:
    node = document(
        variables=[("N::stamp_", "ros::Time", None), ("N::x_", "double", "0.0")],
        transitions=[("N::stamp_", "in", None, "ros::Time::now()"), ("N::x_", "in", "x_ < limit", "msg->x")],
    )
    machine = build_machine(node)
    assert (machine.regions, machine.left_out) == ((), ("N::stamp_", "N::x_"))


def test_what_cannot_happen_is_told() -> None:
    machine = modes(
        ("go", "mode_ == Mode::C", "Mode::B"),
        ("go", "mode_ == Mode::A && mode_ == Mode::B", "Mode::A"),
        ("on", "mode_ == Mode::B", "Mode::A"),
    )
    assert arrows(machine) == set()
    assert machine.regions[0].never == (("N::mode_", ("C", "B")),)
    assert [(row.kind, row.at) for row in machine.dead] == [
        ("transitions", "n.cpp:10"),
        ("transitions", "n.cpp:11"),
        ("transitions", "n.cpp:12"),
    ]


def test_independent_variables_are_regions_of_their_own() -> None:
    node = document(
        variables=[("N::a_", "bool", "false"), ("N::b_", "bool", "false")],
        transitions=[("N::a_", "in", None, "true"), ("N::b_", "in", None, "true")],
        reactive=[("in", "out", None)],
    )
    machine = build_machine(node)
    assert [arrows(machine, 0), arrows(machine, 1)] == [{"false in/out true", "true in/out true"}, {"false in true"}]


def test_variables_of_which_every_combination_occurs_are_shown_alone_unless_asked_for() -> None:
    node = document(
        variables=[("N::a_", "bool", "false"), ("N::b_", "bool", "false")],
        transitions=[("N::a_", "in", "!b_", "msg.a"), ("N::b_", "on", None, "msg.b")],
    )
    alone, joint = build_machine(node), build_machine(node, joint=True)
    assert [len(region.states) for region in alone.regions] == [2, 2]
    assert arrows(alone) == {"false in[!b_ && msg.a] true", "true in[!b_ && !msg.a] false"}
    assert [len(region.states) for region in joint.regions] == [4]
    assert alone.messages == joint.messages == ()


def counters(number: int) -> Document:
    """Variables that all depend on one another; of 4 values each, and one is never ahead of the one before by more than the others."""
    variables = [(f"N::c{i}_", "Mode", "Mode::A") for i in range(number)]
    steps = [
        (f"N::c{i}_", f"in{i}", f"c{i}_ == Mode::{old}" + (f" && c{i - 1}_ == Mode::{new}" if i else ""), f"Mode::{new}")
        for i in range(number)
        for old, new in zip("ABC", "BCD", strict=True)
    ]
    return document(variables=variables, transitions=steps)


def test_too_many_states_are_shown_by_variable() -> None:
    machine = build_machine(counters(3), max_states=4)
    assert [len(region.states) for region in machine.regions] == [4, 4, 4]
    assert machine.messages == ("c0_, c1_, c2_ depend on each other: 20 states together, so each is shown alone",)
    assert "A in1[c0_ == B] B" in arrows(machine, 1)
    assert [len(region.states) for region in build_machine(counters(3), max_states=20).regions] == [20]


def test_a_huge_machine_is_cut_off() -> None:
    machine = build_machine(counters(30))
    assert [len(region.states) for region in machine.regions] == [4] * 30
    assert "more than 256 states together, so each is shown alone" in machine.messages[0]


def test_a_reaction_with_a_huge_number_of_cases_is_shown_by_assignment() -> None:
    guard = " && ".join(f"(a{i} || b{i})" for i in range(12))
    machine = modes(("in", guard, "Mode::B"), *(("in", f"x{i} && !y{i}", f"Mode::{'AB'[i % 2]}") for i in range(12)))
    assert machine.messages == ("mode_: more than 256 cases of one reaction; each assignment is shown for itself",)
    assert "A in[x1 && !y1] B" in arrows(machine)


def test_a_huge_reaction_of_several_variables_is_shown_by_assignment() -> None:
    rows = [(f"N::{name}_", "in", f"x{i} && !{'ba'[name == 'b']}_", f"msg.{i}" if i % 2 else "true") for i in range(12) for name in "ab"]
    machine = build_machine(document(variables=[("N::a_", "bool", "false"), ("N::b_", "bool", "false")], transitions=rows))
    assert [message.partition(":")[0] for message in machine.messages] == ["a_, b_ depend on each other", "a_", "b_"]
    assert "false in[x0 && !b_] true" in arrows(machine)
    assert "true in[x1 && !a_ && !msg.1] false" in arrows(machine, 1)


def test_what_cannot_happen_together_is_not_shown_apart() -> None:
    node = counters(2)
    node["transitions"].append(
        {"variable": "N::c1_", "trigger": ["x"], "guard": "c0_ == Mode::A && c1_ == Mode::D", "value": "Mode::A", "at": "n.cpp:99"}
    )
    machine = build_machine(node, max_states=3)
    assert len(machine.regions) == 2
    assert [row.at for row in machine.dead] == ["n.cpp:99"]
    assert not any(arrow.split()[1].startswith("x") for arrow in arrows(machine, 1))


def test_outputs_are_shown_with_the_assignment_under_the_same_guard() -> None:
    machine = build_machine(DOOR)
    state, locked = machine.regions
    assert [cell.subject.text for cell in (*state.cells, *locked.cells)] == ["state_", "locked_"]
    assert arrows(machine) == {"CLOSED open[!locked_]/motor OPEN", "OPEN close CLOSED", "OPEN periodic/lamp OPEN"}
    assert arrows(machine, 1) == {"false lock[msg->data] true", "true lock[!msg->data] false", "true open/alarm true"}
    assert [(t.trigger, t.outputs[0].port) for t in machine.always] == [("ping", "pong")]


def test_several_loops_are_one_trigger_and_that_is_told() -> None:
    node = document(
        variables=[("N::on_", "bool", "false")],
        transitions=[("N::on_", "periodic", None, "!on_")],
        periodic=[(1.0, ["a"], None), (5.0, ["b"], "on_")],
    )
    machine = build_machine(node)
    assert machine.messages == ("2 timed loops are shown as one, `periodic`, that does what each of them does",)
    assert arrows(machine) == {"false periodic/a,b true", "true periodic/a false"}


def test_loops_are_told_apart_where_assignments_tell_what_times_them() -> None:
    node = document(
        variables=[("N::on_", "bool", "false")],
        transitions=[("N::on_", "periodic", None, "!on_"), ("N::on_", ["reset", "periodic"], None, "false")],
        periodic=[(1.0, ["a"], None), (5.0, ["b"], "on_"), (5.0, ["c"], "on_")],
    )
    node["transitions"][0]["timed_by"] = ["n.cpp:80"]
    node["transitions"][1]["timed_by"] = ["n.cpp:81", "once.cpp:3"]
    machine = build_machine(node)
    assert machine.messages == ()
    assert [(t.id, t.label) for t in machine.triggers] == [
        ("periodic n.cpp:80", "1 Hz"), ("reset", "reset"), ("periodic n.cpp:81", "5 Hz n.cpp:81"), ("periodic n.cpp:82", "5 Hz n.cpp:82"),
    ]  # fmt: skip


def test_a_timer_that_runs_once_is_a_trigger() -> None:
    node = document(variables=[("N::late_", "bool", "false")], transitions=[("N::late_", "timer", None, "true")])
    node["one_shot"] = [
        {"after": 3.0, "after_from_param": None, "output": "alarm", "sent_at": ["n.cpp:5"], "must": True, "at": "n.cpp:9", "when": "!late_"}
    ]
    machine = build_machine(node)
    assert arrows(machine) == {"false timer/alarm true"}
    assert [row.kind for row in machine.regions[0].transitions[0].rows] == ["one_shot", "transitions"]


def test_rows_and_places_are_kept() -> None:
    (transition,) = (t for t in build_machine(DOOR).regions[0].transitions if t.trigger == "open" and t.visible)
    assert [(row.kind, row.index, row.at) for row in transition.rows] == [("reactive", 1, "n.cpp:51"), ("transitions", 0, "n.cpp:10")]
    assert build_machine(DOOR).regions[0].cells[0].at == "n.h:1"


def test_names_resolve_to_the_variable_they_mean() -> None:
    node = document(
        variables=[("Left::on_", "bool", "false"), ("Right::on_", "bool", "false")],
        transitions=[("Left::on_", "in", "!on_", "true"), ("Right::on_", "in2", "!left_.on_ && !this->on_", "true")],
        reactive=[("in3", "out", "on_")],
    )
    machine = build_machine(node, joint=True)
    assert [cell.subject.text for region in machine.regions for cell in region.cells] == ["Left::on_", "Right::on_"]
    assert "!Left::on_, !Right::on_ in2 !Left::on_, Right::on_" in arrows(machine)
    assert formula_text(machine.always[0].outputs[0].when) == "on_"


def test_an_empty_document() -> None:
    machine = build_machine({})
    assert (machine.regions, machine.always, machine.messages, machine.triggers) == ((), (), (), ())


def test_the_same_document_gives_the_same_machine() -> None:
    assert build_machine(DOOR) == build_machine(DOOR)


def test_a_value_that_a_condition_chooses_is_compared_by_its_ways() -> None:
    machine = modes(("set", "!((m.on ? Mode::B : Mode::A) == mode_)", "m.on ? Mode::B : Mode::A"), ("off", None, "Mode::A"))
    assert arrows(machine) == {"A set[m.on] B", "B set[!m.on] A", "B off A"}


def test_truth_values_are_joined_bit_by_bit_as_well() -> None:
    rows = [("N::stopped_", "stop", None, "stopped_ | m.data"), ("N::stopped_", "reset", "stopped_", "false")]
    machine = build_machine(document(variables=[("N::stopped_", "bool", "false")], transitions=rows))
    assert arrows(machine) == {"false stop[m.data] true", "true reset false"}


def test_membership_is_a_choice_of_equalities() -> None:
    machine = modes(("go", "mode in (Mode::A, Mode::C)", "Mode::B"), ("back", "mode_ not in [Mode::A]", "Mode::A"))
    assert "B back A" in arrows(machine)


def test_a_list_of_python_is_true_when_something_is_in_it() -> None:
    rows = [
        ("N::kept", "in", None, "self.kept.append(msg)"),
        ("N::kept", "flush", "not self.kept", "[]"),
        ("N::kept", "send", "self.kept", "[]"),
    ]
    machine = build_machine(document(variables=[("N::kept", "list", "[]")], transitions=rows))
    assert arrows(machine) == {"true in false", "false send true"}
