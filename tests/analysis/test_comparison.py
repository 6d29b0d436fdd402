"""What is different between two states."""

from __future__ import annotations

from dataclasses import replace

import pytest
from systems import at, node, port, small, system

from rosarch.analysis.comparison import Change, Snapshot, compare
from rosarch.base.logic import TRUE
from rosarch.findings.model import Evidence, Finding
from rosarch.models import formula
from rosarch.models.behavior import NOTHING, OneShot, Periodic, Reactive, StateVariable, Transition
from rosarch.models.component import ComponentModel, Parameter, Port
from rosarch.models.system.model import SystemModel
from rosarch.rule_programs.checks import Check


def made_port(
    name: str, kind: str = "publisher", type_: str | None = "T", callback: str | None = None, line: int = 1, **more: object
) -> Port:
    base = Port(f"p{line}", kind, name, None, type_, 10, False, callback, "plain", at("n.cpp", line))
    return replace(base, **more)  # type: ignore[arg-type]


def component(*ports: Port, **more: object) -> ComponentModel:
    return replace(ComponentModel("ws", "n", "pkg", "node", "n", (), ports, ()), **more)  # type: ignore[arg-type]


def changes_between(old: ComponentModel, new: ComponentModel) -> list[str]:
    return [line(change) for change in compare(Snapshot((old,)), Snapshot((new,)))]


def changes_between_systems(old: SystemModel, new: SystemModel) -> list[str]:
    return [line(change) for change in compare(Snapshot((), (old,)), Snapshot((), (new,)))]


def line(change: Change) -> str:
    details = ", ".join(f"{d.name} {d.old} -> {d.new}" for d in change.details)
    return f"{change.how} {change.subject} {change.title}{f': {details}' if details else ''}"


def test_nothing() -> None:
    model = component(made_port("a"), made_port("a"), made_port("b", "subscriber", callback="f"))
    assert compare(Snapshot((model,), (small(),)), Snapshot((model,), (small(),))) == ()


def test_lines_that_move_are_no_difference() -> None:
    assert changes_between(component(made_port("a", line=1)), component(made_port("a", line=9))) == []


def test_implicit_ports_follow_from_others() -> None:
    assert changes_between(component(made_port("a", implicit=True)), component()) == []


def test_components() -> None:
    other = component(made_port("a"), component="other")
    assert [(c.where, line(c)) for c in compare(Snapshot((component(),)), Snapshot((other,)))] == [
        ("pkg/n", "lost component node pkg/n: ports 0 -> None"),
        ("pkg/other", "gained component node pkg/other: ports None -> 1"),
    ]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ([made_port("a")], [], ["lost port publisher a: type T -> None, queue 10 -> None"]),
        ([], [made_port("a", type_=None, queue=None)], ["gained port publisher a"]),
        ([made_port("a")], [made_port("a", queue=1, latched=True)], ["changed port publisher a: queue 10 -> 1, latched None -> yes"]),
        ([made_port("a")], [made_port("a", type_="U")], ["changed port publisher a: type T -> U"]),
        ([made_port("a")], [made_port("a", from_param="~t")], ["changed port publisher a: from None -> ~t"]),
        ([made_port("a")], [made_port("b")], ["renamed port publisher a: name a -> b"]),
        ([made_port("a", "subscriber", callback="f")], [made_port("b", "subscriber", callback="f", queue=1)], ["renamed port subscriber a: name a -> b, queue 10 -> 1"]),
        (
            [made_port("a", "subscriber", callback="f")], [made_port("b", "subscriber", callback="g")],
            ["lost port subscriber a: type T -> None, queue 10 -> None, callback f -> None", "gained port subscriber b: type None -> T, queue None -> 10, callback None -> g"],
        ),
        ([made_port("a", type_=None)], [made_port("b", type_=None)], ["lost port publisher a: queue 10 -> None", "gained port publisher b: queue None -> 10"]),
        (
            [made_port("front/scan", line=1), made_port("rear/scan", line=2)], [made_port("rear/laser", line=1), made_port("front/laser", line=2)],
            ["renamed port publisher front/scan: name front/scan -> front/laser", "renamed port publisher rear/scan: name rear/scan -> rear/laser"],
        ),
        ([made_port("a", type_="T"), made_port("a", type_="U")], [made_port("a", type_="U"), made_port("a", type_="V")], ["changed port publisher a: type T -> V"]),
        ([made_port("?"), made_port("b")], [made_port("?")], ["lost port publisher b: type T -> None, queue 10 -> None"]),
    ],
)  # fmt: skip
def test_ports(old: list[Port], new: list[Port], expected: list[str]) -> None:
    assert changes_between(component(*old), component(*new)) == expected


@pytest.mark.parametrize(("size", "how"), [(50, {"renamed"}), (2000, {"lost", "gained"})])
def test_many_ports_of_one_type(size: int, how: set[str]) -> None:
    old, new = ([made_port(f"{letter}{number}") for number in range(size)] for letter in "ab")
    assert {change.how for change in compare(Snapshot((component(*old),)), Snapshot((component(*new),)))} == how


def test_parameters() -> None:
    old = Parameter("~rate", "read", "double", "10.0", at("n.cpp", 1))
    assert changes_between(component(params=(old,)), component(params=(replace(old, default="20.0"),))) == [
        "changed parameter read ~rate: default 10.0 -> 20.0"
    ]


def test_behavior_is_told_with_the_new_names_of_ports() -> None:
    ready = formula.condition("ready_", True)

    def model(name: str, hz: float, guard: formula.Formula, *, must: bool) -> ComponentModel:
        behavior = replace(
            NOTHING,
            periodic=(Periodic("timer", hz, None, ("p1",), at("n.cpp", 3), TRUE),),
            reactive=(Reactive("p2", "p1", (at("n.cpp", 4),), must, guard),),
        )
        return component(made_port(name), made_port("in", "subscriber", callback="f", line=2), behavior=behavior)

    assert changes_between(model("out", 10, TRUE, must=True), model("out", 10, TRUE, must=True)) == []
    assert changes_between(model("out", 10, TRUE, must=True), model("out2", 12.5, ready, must=False)) == [
        "renamed port publisher out: name out -> out2",
        "changed rate timer sends out2: rate 10 Hz -> 12.5 Hz",
        "changed reaction in sends out2: always yes -> None, when None -> ready_",
    ]


def test_timers_that_fire_once() -> None:
    def model(after: float) -> ComponentModel:
        once = OneShot(after, None, "p1", (at("n.cpp", 3),), True, at("n.cpp", 2), TRUE)
        return component(made_port("out"), behavior=replace(NOTHING, one_shot=(once,)))

    assert changes_between(model(5), model(0.5)) == ["changed rate once sends out: after 5 s -> 0.5 s"]


def test_states_and_transitions() -> None:
    variable = StateVariable("N::s", "State", "IDLE", None, ("BUSY", "IDLE"), at("n.h", 1))
    becomes = Transition("N::s", None, ("p1",), TRUE, "BUSY", at("n.cpp", 2))
    old = component(
        made_port("go", "subscriber", callback="f"), behavior=replace(NOTHING, state_variables=(variable,), transitions=(becomes,))
    )
    more = (replace(becomes, guard=formula.condition("ok", True)), replace(becomes, value="DONE", trigger=("periodic",)))
    new = replace(old, behavior=replace(NOTHING, state_variables=(replace(variable, domain=("BUSY", "DONE", "IDLE")),), transitions=more))
    assert changes_between(old, new) == [
        "changed state N::s: values BUSY | IDLE -> BUSY | DONE | IDLE",
        "gained transition N::s becomes DONE on periodic",
        "changed transition N::s becomes BUSY on go: when None -> ok",
    ]


def test_the_line_of_a_type_without_a_name() -> None:
    def model(line: int) -> ComponentModel:
        variable = StateVariable("N::c", f"N::(unnamed struct at n.h:{line}:3)", None, None, None, at("n.h", line))
        return component(behavior=replace(NOTHING, state_variables=(variable,)))

    assert changes_between(model(3), model(5)) == []


def test_systems() -> None:
    new = replace(small(), name="other")
    assert changes_between_systems(small(), new) == ["gained system other: nodes None -> 5", "lost system robot: nodes 5 -> None"]


def test_connections_of_a_system() -> None:
    def pair(topic: str, **more: object) -> SystemModel:
        return system(
            (
                node("/a", [port("publisher", "/x", "T", written="x")]),
                node("/b", [port("subscriber", topic, "T", written="x")], **more),  # type: ignore[arg-type]
            )
        )

    assert changes_between_systems(pair("/x"), pair("/y", conditions=("arg b",))) == [
        "changed node /b: if None -> arg b",
        "renamed port /b subscriber /x: name /x -> /y",
        "lost connection /a > /x > /b: kind topic -> None",
    ]
    assert changes_between_systems(pair("/x"), system((node("/a", [port("publisher", "/x", "T", written="x")]),))) == [
        "lost node /b: executable pkg/b -> None",
        "lost connection /a > /x > /b: kind topic -> None",
    ]


def test_transforms_and_implicit_topics_are_no_connections() -> None:
    alone = replace(small(), connectors=())
    assert len(changes_between_systems(small(), alone)) == 5
    assert all("/tf" not in told and "/diagnostics" not in told for told in changes_between_systems(small(), alone))


def finding(message: str, line: int, path: str = "a.launch") -> Finding:
    check = Check("near-miss", "t", "h", "high", "high", "d", "s", "r", "m", (), "near_miss", (), "near-miss.dl")
    return Finding(check, "error", message, (Evidence("here", at(path, line)),))


def test_findings() -> None:
    old = Snapshot((), (), (finding("x", 1), finding("y", 2), finding("y", 3)))
    new = Snapshot((), (), (finding("z", 9), finding("y", 30), finding("x", 5, "b.launch")))
    assert [(line(change), str(change.new_at or change.old_at)) for change in compare(old, new)] == [
        ("lost finding error near-miss: x", "a.launch:1"),
        ("lost finding error near-miss: y", "a.launch:2"),
        ("gained finding error near-miss: z", "a.launch:9"),
        ("gained finding error near-miss: x", "b.launch:5"),
    ]
