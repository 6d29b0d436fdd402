"""Small systems whose figures are known by reckoning, and whose rates are those that the rules derive."""

from __future__ import annotations

from typing import Any

import pytest
from hand_made import system_of
from intervals import derived, facts, inputs, outside

from rosarch.base.places import Place
from rosarch.behavior.composition.scenario import ScenarioError, read_scenario
from rosarch.behavior.simulation.engine import TooManyEventsError, simulate
from rosarch.behavior.simulation.records import Record, busy, latencies, queues, rates


def port(id_: str, kind: str, name: str, queue: int = 10) -> dict[str, Any]:
    return {"id": id_, "kind": kind, "name": name, "queue": queue}


def relay(source: str, target: str, *, queue: int = 10, when: str | None = None, **more: Any) -> dict[str, Any]:
    """A node that passes on what it receives."""
    return {
        "ports": [port("p1", "subscriber", source, queue), port("p2", "publisher", target)],
        "reactive": [{"input": "p1", "output": "p2", "must": when is None, "when": when, "at": ["relay.cpp:9"]}],
        **more,
    }


def loop(topic: str, hz: float | None, **more: Any) -> dict[str, Any]:
    """A node that sends again and again."""
    return {
        "ports": [port("p1", "publisher", topic)],
        "periodic": [{"mechanism": "timer", "hz": hz, "publishes": ["p1"], "at": "loop.cpp:9"}],
        **more,
    }


def gate(trigger: str) -> dict[str, Any]:
    """A node that passes on what it receives once it is open; what comes through the port `trigger` opens it."""
    return relay(
        "/a", "/b", when="open_",
        state_variables=[{"name": "Gate::open_", "type": "bool", "initial": "false", "at": "gate.h:4"}],
        transitions=[{"variable": "Gate::open_", "trigger": [trigger], "value": "true", "at": "gate.cpp:5"}],
    )  # fmt: skip


def run(
    nodes: dict[str, Any], scenario: str = "{}", *, duration: float = 10.0, seed: int = 1, serving: dict[str, Any] | None = None
) -> Record:
    """A run that keeps to the intervals of the rules."""
    system = system_of(nodes, serving=serving)
    told = read_scenario(scenario, "s.yml", system)
    record = simulate(system, told, seed=seed, duration=duration)
    assert outside(derived({**facts(nodes, serving), **inputs(told.inputs.entries, duration)}), record) == []
    return record


def number(record: Record, topic: str) -> int:
    return sum(rate.number for rate in rates(record) if rate.topic == topic)


def test_a_loop_sends_at_its_rate() -> None:
    (rate,) = rates(run({"source": loop("/a", 10.0)}))
    assert abs(rate.number - 100) <= 1
    assert (rate.shortest, rate.longest) == pytest.approx((0.1, 0.1))


def test_a_relay_sends_as_often_as_it_receives_and_later() -> None:
    record = run({"source": loop("/a", 10.0), "relay": relay("/a", "/b")}, "execution: {relay: 0.02}")
    assert abs(number(record, "/a") - number(record, "/b")) <= 1
    figures = latencies(record)["/a", "/b"]
    assert (figures.least, figures.most) == pytest.approx((0.02, 0.02))


def test_delays_of_a_chain_add_up() -> None:
    nodes = {"one": relay("/a", "/b"), "two": relay("/b", "/c"), "three": relay("/c", "/d")}
    record = run(nodes, "inputs: [{topic: /a, every: 1}]\nexecution: {one: 0.01, two: 0.02, three: 0.03}")
    figures = latencies(record)["/a", "/d"]
    assert (figures.number, figures.least, figures.most) == (10, pytest.approx(0.06), pytest.approx(0.06))


def test_a_node_that_is_too_slow_loses_what_its_queue_does_not_hold() -> None:
    record = run({"slow": relay("/a", "/b", queue=1)}, "inputs: [{topic: /a, every: 0.1}]\nexecution: {slow: 0.2}")
    (queue,) = queues(record)
    assert abs(number(record, "/b") - 50) <= 1  # one in 0.2 s
    assert abs(queue.dropped - 50) <= 1
    assert queue.most == 1
    assert busy(record)["/slow"] == pytest.approx(1, abs=0.03)


def test_a_queue_without_end_grows() -> None:
    record = run({"slow": relay("/a", "/b", queue=0)}, "inputs: [{topic: /a, every: 0.1}]\nexecution: {slow: 0.2}")
    (queue,) = queues(record)
    assert queue.dropped == 0
    assert abs(queue.most - 50) <= 1  # 10 come and 5 go in a second
    assert queue.mean == pytest.approx(25, abs=1)


def test_the_oldest_message_gives_way() -> None:
    record = run({"slow": relay("/a", "/b", queue=1)}, "inputs: [{topic: /a, at: [0, 0.1, 0.2]}]\nexecution: {slow: 1}")
    assert record.dropped == {("/slow", "/a"): 1}
    figures = latencies(record)["/a", "/b"]
    assert (figures.number, figures.least, figures.most) == (2, pytest.approx(1.0), pytest.approx(1.8))  # sent at 0.2, done at 2


def test_a_node_does_one_thing_after_another() -> None:
    both = relay("/a", "/b")
    both["ports"].append(port("p3", "subscriber", "/c"))
    record = run({"both": both}, "inputs: [{topic: /a, at: 1}, {topic: /c, at: 1}]\nexecution: {both: 1}")
    assert [(work.start, work.end) for work in record.work] == [(1, 2), (2, 3)]


def test_state_decides() -> None:
    node = gate("p3")
    node["ports"].append(port("p3", "subscriber", "/open"))
    record = run({"gate": node}, "inputs: [{topic: /a, every: 0.5, from: 0.25}, {topic: /open, at: 5}]")
    assert (number(record, "/a"), number(record, "/b")) == (20, 10)
    assert [(event.subject, event.detail) for event in record.events if event.kind == "changed"] == [("open_", "false -> true")]


def test_rates_of_several_senders_add_up() -> None:
    record = run({"fast": loop("/a", 10.0), "slow": loop("/a", 5.0)})
    assert abs(number(record, "/a") - 150) <= 2


def test_the_content_of_messages_decides() -> None:
    scenario = "inputs: [{topic: /a, at: [1, 2], fields: {data: true}}, {topic: /a, at: 3, fields: {data: false}}]"
    record = run({"filter": relay("/a", "/b", when="msg->data")}, scenario)
    assert number(record, "/b") == 2
    assert not record.guessed


@pytest.mark.parametrize(("value", "expected"), [("Mode::HIGH", 100), ("Mode::LOW", 0)])
def test_what_senders_put_into_messages_decides(value: str, expected: int) -> None:
    """The sender says it by a name, the reader by a number."""
    sent = {
        "sent": [["p1", "loop.cpp:12", "1"]],
        "rounds": [["p1", "loop.cpp:12", "loop.cpp:9", None]],
        "kinds": [["1", "level", "int"]],
        "constants": [["LOW", "1"], ["HIGH", "2"]],
        "fillings": [
            {"message": "1", "path": "level", "value": value, "trigger": ["periodic"], "timed_by": ["loop.cpp:9"], "at": "loop.cpp:11"}
        ],
    }
    record = run({"sender": loop("/a", 10.0, contents=sent), "filter": relay("/a", "/b", when="msg->level == 2")})
    assert number(record, "/b") == expected
    assert not record.guessed


@pytest.mark.parametrize(("chance", "least", "most"), [("0", 0, 0), ("0.25", 200, 300), ("1", 1000, 1000)])
def test_chances_of_conditions(chance: str, least: int, most: int) -> None:
    scenario = f"inputs: [{{topic: /a, every: 0.01}}]\nconditions: {{filter: {{isFar(): {chance}}}}}"
    record = run({"filter": relay("/a", "/b", when="isFar()")}, scenario, duration=9.995)
    assert least <= number(record, "/b") <= most
    assert not record.guessed


def test_what_is_not_told_is_drawn_by_lot_and_said() -> None:
    record = run({"filter": relay("/a", "/b", when="isFar()")}, "inputs: [{topic: /a, every: 0.01}]")
    assert 400 <= number(record, "/b") <= 600
    assert record.guessed == {("/filter", "isFar()"): 1000}


def test_a_loop_sends_what_it_has_kept() -> None:
    node = loop("/b", 10.0, reactive_deferred=[{"input": "p2", "output": "p1", "variable": "last_"}])
    node["ports"].append(port("p2", "subscriber", "/a"))
    record = run({"node": node}, "inputs: [{topic: /a, every: 1}]")
    figures = latencies(record)["/a", "/b"]
    assert figures.most <= 1.101  # the next message, the next cycle, its execution
    assert figures.mean == pytest.approx(0.5, abs=0.06)


def test_messages_wait_for_the_loop_that_serves_them() -> None:
    """Ten come in a cycle of 0.1 s, the queue holds five: the newest five are handled in the next, at most 0.05 s after they came."""
    scenario = "inputs: [{topic: /a, every: 0.01}]\nexecution: {node: 0}"
    record = run({"node": relay("/a", "/b", queue=5)}, scenario, serving={"node": (Place("node.cpp", 20, 1), 10.0)})
    assert abs(number(record, "/b") - 500) <= 5
    assert abs(record.dropped["/node", "/a"] - 500) <= 5
    figures = latencies(record)["/a", "/b"]
    assert 0 <= figures.least <= figures.most <= 0.05
    assert figures.mean == pytest.approx(0.025, abs=0.006)


def test_inputs_have_a_beginning_and_an_end() -> None:
    record = run({"relay": relay("/a", "/b")}, "inputs: [{topic: /a, every: 0.5, from: 2, to: 4}]")
    assert record.times["/a"] == [2, 2.5, 3, 3.5, 4]


def test_execution_times_differ_within_their_span() -> None:
    record = run({"relay": relay("/a", "/b")}, "inputs: [{topic: /a, every: 1}]\nexecution: {relay: {/a: [0.1, 0.3]}}", duration=500)
    figures = latencies(record)["/a", "/b"]
    assert 0.1 <= figures.least < figures.most <= 0.3
    assert figures.mean == pytest.approx(0.2, abs=0.01)


def test_a_loop_of_unknown_rate_is_told_by_the_scenario() -> None:
    assert run({"source": loop("/a", None)}).notes == ["a loop of /source does not run: its rate is not known; a scenario can tell it"]
    assert abs(number(run({"source": loop("/a", None)}, "rates: {source: 20}"), "/a") - 200) <= 1


def test_a_run_can_be_repeated() -> None:
    nodes, scenario = {"filter": relay("/a", "/b", when="isFar()")}, "inputs: [{topic: /a, every: 0.1}]"
    assert run(nodes, scenario, seed=3).events == run(nodes, scenario, seed=3).events
    assert run(nodes, scenario, seed=3).events != run(nodes, scenario, seed=4).events


@pytest.mark.slow
def test_what_never_ends_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    nodes = {"one": relay("/a", "/b"), "two": relay("/b", "/a")}
    monkeypatch.setattr("rosarch.behavior.simulation.engine.MOST_EVENTS", 20_000)
    with pytest.raises(TooManyEventsError, match=r"more than 20000 events until 1 s, \d+ of them about /[ab]"):
        run(nodes, "inputs: [{topic: /a, at: 1}]\nexecution: {one: 0, two: 0}")


@pytest.mark.parametrize(
    ("scenario", "message"),
    [
        ("inputs: [{topic: /aa, at: 1}]", "s.yml:1:18: no topic `/aa`, did you mean `/a`?"),
        ("inputs: [{topic: /b, at: 1}]", "s.yml:1:18: nobody receives /b"),
        ("inputs: [{topic: /a}]", "s.yml:1:10: an input comes either `at` some times or `every` so many seconds"),
        ("inputs: [{topic: /a, at: 1, every: 2}]", "s.yml:1:10: an input comes either `at` some times or `every` so many seconds"),
        ("inputs: [{topic: /a, every: 1, from: 3, to: 2}]", "s.yml:1:10: an input cannot end at 2 s and begin at 3 s"),
        ("inputs: [{topic: /a, every: 0}]", "s.yml:1:29: a number above 0 is expected here, not `0`"),
        ("inputs: [{at: 1}]", "s.yml:1:10: an input needs a `topic`"),
        ("inputs: [{topic: /a, at: 1, times: 2}]", "s.yml:1:29: unknown key of an input `times`, there are topic, at, every, from, to, fields"),
        ("execution: {relay: [3, 2]}", "s.yml:1:20: at least 3 s and at most 2 s"),
        ("execution: {rely: 1}", "s.yml:1:13: no node `rely`, did you mean `relay`?"),
        ("conditions: {relay: {far: 1.5}}", "s.yml:1:27: a condition cannot hold more often than always, 1, but 1.5"),
        ("rates: {relay: -1}", "s.yml:1:16: a number above 0 is expected here, not `-1`"),
        ("values: {relay.x: 1}", "s.yml:1:10: /relay has no state variable `x`, there are open_"),
        ("values: {relay.open_: true}", "s.yml:1:23: `relay.open_` begins as false, says the source"),
        ("values: {relay.open_: maybe}", "s.yml:1:23: `relay.open_` is never told apart as `maybe`, there are true, false"),
        ("values: {relay.open_: false, relay.open_: true}", "s.yml:1:30: `relay.open_` stands here for the second time, first in line 1"),
        ("input: []", "s.yml:1:1: unknown section `input`, did you mean `inputs`?"),
    ],
)  # fmt: skip
def test_scenarios_with_mistakes(scenario: str, message: str) -> None:
    with pytest.raises(ScenarioError) as error:
        read_scenario(scenario, "s.yml", system_of({"relay": gate("p1")}))
    assert str(error.value) == message


def simulated(nodes: dict[str, Any]) -> Record:
    """A run whose figures the test itself knows."""
    return simulate(system_of(nodes), read_scenario("{}", "s.yml", system_of(nodes)), seed=1, duration=10.0)


@pytest.mark.parametrize(
    ("traits", "expected"),
    [
        ({"answers_most": [["p1", "p2", "3"]], "answers_least": [["p1", "p2", "3"]]}, 300),
        ({"answers_most": [["p1", "p2", "3"]]}, 100),
        ({"sleeps_for_each": [["p1", "200", "1000"]]}, 50),
    ],
)
def test_a_relay_sends_as_many_as_its_source_says(traits: dict[str, Any], expected: int) -> None:
    record = simulated({"source": loop("/a", 10.0), "relay": relay("/a", "/b", queue=1, traits=traits)})
    assert number(record, "/b") == pytest.approx(expected, abs=4)


def test_a_round_of_a_loop_sends_as_many_as_its_source_says() -> None:
    round_ = ["loop.cpp:9", "p1"]
    traits = {"round_sends": [[*round_, "2"]], "round_least": [[*round_, "2"]], "round_always": [round_]}
    assert number(simulated({"source": loop("/a", 10.0, traits=traits)}), "/a") == pytest.approx(200, abs=2)


def test_what_is_let_through_after_a_time_comes_no_more_often() -> None:
    throttle = relay("/a", "/b", when="now - last_ < period_", traits={"least_gap": [["p1", "p2", "500", "1000"]]})
    record = simulated({"source": loop("/a", 10.0), "throttle": throttle})
    assert number(record, "/b") == pytest.approx(20, abs=1)
    assert not record.guessed


def test_messages_that_are_passed_together_are_awaited() -> None:
    pair = {
        "ports": [port("p1", "subscriber", "/a"), port("p2", "subscriber", "/b"), port("p3", "publisher", "/c")],
        "reactive": [{"input": input_, "output": "p3", "must": True, "when": None, "at": ["pair.cpp:9"]} for input_ in ("p1", "p2")],
        "traits": {"synchronised": [["p1", "p2"], ["p2", "p1"]]},
    }
    record = simulated({"one": loop("/a", 10.0), "other": loop("/b", 30.0), "pair": pair})
    assert number(record, "/c") == pytest.approx(100, abs=2)
