"""Components as rows of `rules/schema/interfaces.dl`."""

from __future__ import annotations

from dataclasses import replace

from rosarch.analysis.systems.interfaces import Rows, library_rows, model_rows
from rosarch.base.logic import TRUE
from rosarch.base.places import Place
from rosarch.datalog import load_declarations
from rosarch.extractor.manifest import rules_folder
from rosarch.library import LibraryComponent, LibraryParameter, LibraryPort
from rosarch.models import formula
from rosarch.models.behavior import NOTHING, Periodic, Reactive, StateVariable, Transition
from rosarch.models.component import ComponentModel, Parameter, Plugin, Port
from rosarch.models.traits import TRAITS, Trait

AT = Place("base/src/base.cpp", 7, 3)
OUT = Port(
    "p1",
    "publisher",
    "odom",
    "~odom_topic",
    "nav_msgs/Odometry",
    10,
    True,
    None,
    "plain",
    AT,
    in_namespace="first",
    qos=(("durability", "volatile"),),
)
IN = Port(
    "p2", "subscriber", "cmd_vel", None, "geometry_msgs/Twist", 1, False, "Base::onCommand", "plain", Place("base/src/base.cpp", 8, 3)
)
COUNT = StateVariable("Base::count_", "int", "0", None, None, AT)
COUNTED = Transition("Base::count_", None, ("p2",), TRUE, "++count_", Place("base/src/base.cpp", 20, 5))
THIRD = Reactive("p2", "p1", (Place("base/src/base.cpp", 21, 5),), True, formula.condition("count_ % 3 == 0", True))
LOG = Port("p3", "publisher", "/rosout", None, None, None, False, None, "plain", AT, implicit=True)
VALUES: dict[str, str | Place] = {"port": "p1", "place": AT, "variable": "speed_", "text": "x"}
MODEL = ComponentModel(
    "ws", "base", "robot", "node", "base", ("base/src/base.cpp",), (OUT, IN, LOG),
    (Parameter("~odom_topic", "read", "string", "odom", Place("base/src/base.cpp", 5, 1)), Parameter("rate", "write", None, None, AT)),
    replace(
        NOTHING,
        periodic=(Periodic("timer", 20.0, "~rate", ("p1",), Place("base/src/base.cpp", 9, 1), formula.condition("!x", True)),),
        reactive=(THIRD,),
        state_variables=(COUNT,),
        transitions=(COUNTED,),
    ),
    plugin=Plugin("robot/Base", "nodelet::Nodelet"),
    reconfigurable=(Parameter("~gain", "read", "double", None, AT),),
    loads=("robot/Filter",),
    loads_any=("robot::Filter",),
    traits=tuple(Trait(name, tuple(VALUES[kind] for kind in kinds)) for name, kinds in TRAITS.items()),
    middleware="ROS 2",
)  # fmt: skip
NEW = StateVariable("Base::new_", "bool", "false", None, None, AT)
TIMED = Periodic("timer", 20.0, None, ("p1",), Place("base/src/base.cpp", 9, 1), formula.condition("new_", True))
TAKES = Transition(
    "Base::new_", None, ("periodic",), formula.condition("new_", True), "false", Place("base/src/base.cpp", 31, 5), timed_by=(TIMED.at,)
)
SETS = Transition("Base::new_", None, ("p2",), TRUE, "true", Place("base/src/base.cpp", 30, 5))
TAKING = replace(MODEL, traits=(), behavior=replace(NOTHING, periodic=(TIMED,), state_variables=(NEW,), transitions=(SETS, TAKES)))
WINDOW = StateVariable("Base::w_", "std::deque<float>", None, None, None, AT)
ADDS = Transition("Base::w_", None, ("p2",), TRUE, "w_.push_back(x)", Place("base/src/base.cpp", 40, 5))
DROPS = Transition(
    "Base::w_", None, ("p2",), formula.condition("w_.size() > size_", True), "w_.pop_front()", Place("base/src/base.cpp", 41, 5)
)
SLIDING = replace(
    MODEL,
    traits=(Trait("keeps_value_of", ("size_", "~size")),),
    behavior=replace(
        NOTHING,
        reactive=(Reactive("p2", "p1", (Place("base/src/base.cpp", 43, 5),), False, formula.condition("w_.size() >= size_", True)),),
        state_variables=(WINDOW,),
        transitions=(ADDS, DROPS),
    ),
)
FOUND = LibraryComponent(
    "tools", "mux", "gazebo_plugin",
    (
        LibraryPort("publisher", "selected", "std_msgs/String", from_arg=1, suffix="selected", latched=True, queue=0, conditional="lazy"),
        LibraryPort("subscriber", None, from_arg=2, rest=True, if_arg={1: "mux"}),
        LibraryPort("subscriber", param_pattern="~in[0-9]+"),
        LibraryPort("publisher", "out", from_param="~topic", implicit=True),
    ),
    (LibraryParameter("~lazy", type="bool", default=False), LibraryParameter(pattern="~in.*"), LibraryParameter("name", default="a")),
    loads=("tools/other",), open_ports=True, open_params=True, options=("-r",), elements={"topic": "scan", "gone": None}, namespace_element="ns", ros=(1,),
)  # fmt: skip


def test_a_model() -> None:
    rows = model_rows(MODEL)
    at = f"{AT}:3"
    assert rows["interface"] == {("robot/base", "robot", "robot/Base", "node", "source")}
    assert rows["interface_port"] == {
        ("robot/base", "robot/base#p1", "publisher", "odom"),
        ("robot/base", "robot/base#p2", "subscriber", "cmd_vel"),
        ("robot/base", "robot/base#p3", "publisher", "/rosout"),
    }
    assert rows["interface_port_type"] == {("robot/base#p1", "nav_msgs/Odometry"), ("robot/base#p2", "geometry_msgs/Twist")}
    assert rows["interface_port_queue"] == {("robot/base#p1", 10), ("robot/base#p2", 1)}
    assert rows["interface_port_parameter"] == {("robot/base#p1", "~odom_topic")}
    assert (rows["interface_port_latched"], rows["interface_port_implicit"]) == ({("robot/base#p1",)}, {("robot/base#p3",)})
    assert rows["interface_port_quality"] == {("robot/base#p1", "durability", "volatile")}
    assert rows["interface_middleware"] == {("robot/base", "ROS 2")}
    assert rows["interface_port_in_namespace"] == {("robot/base#p1", "first")}
    assert rows["interface_port_callback"] == {("robot/base#p2", "Base::onCommand")}
    assert ("robot/base#p1", at) in rows["interface_port_at"]
    assert (at, AT.path, 7, 3) in rows["place"]
    assert rows["interface_base"] == {("robot/base", "nodelet::Nodelet")}
    assert (rows["interface_loads"], rows["interface_loads_any"]) == ({("robot/base", "robot/Filter")}, {("robot/base", "robot::Filter")})


def test_parameters_of_a_model() -> None:
    rows = model_rows(MODEL)
    assert rows["interface_parameter"] == {
        ("robot/base", "robot/base#a1", "read", "~odom_topic"),
        ("robot/base", "robot/base#a2", "write", "rate"),
        ("robot/base", "robot/base#d1", "read", "~gain"),
    }
    assert rows["interface_parameter_type"] == {("robot/base#a1", "string"), ("robot/base#d1", "double")}
    assert rows["interface_parameter_default"] == {("robot/base#a1", "odom")}
    assert ("robot/base#a1", "base/src/base.cpp:5:1") in rows["interface_parameter_at"]


def test_behavior_of_a_model() -> None:
    rows = model_rows(MODEL)
    assert rows["interface_reacts"] == {("robot/base#p2", "robot/base#p1", "always")}
    assert rows["interface_periodic"] == {("robot/base#p1", 20.0, "~rate")}
    assert rows["interface_loop"] == {("robot/base", "base/src/base.cpp:9:1", 20.0, "~rate")}
    assert rows["interface_sent_at_start"] == {("robot/base", "robot/base#p1", f"{AT}:3")}
    assert rows["interface_sends_frame"] == {("robot/base", f"{AT}:3", "x", "x")}
    loop, sent = "base/src/base.cpp:9:1", "robot/base#p1"
    assert rows["interface_way"] == {
        (f"robot/base#{loop} p1 1", "robot/base", loop, sent, "wholly"),
        ("robot/base#robot/base#p2 p1 1", "robot/base", "robot/base#p2", sent, "partly"),
    }
    assert rows["interface_way_needs"] == {(f"robot/base#{loop} p1 1", "x", "true", "no")}
    assert rows["interface_rhythm"] == {("robot/base", "robot/base#p2", sent, "", 3, 1)}


def test_what_a_timer_sends_once_for_what_came() -> None:
    assert model_rows(TAKING)["interface_uses_up"] == {("robot/base", "base/src/base.cpp:9:1", "robot/base#p1", "robot/base#p2", "each")}


def test_a_rhythm_whatever_a_parameter_is() -> None:
    rows = model_rows(SLIDING)
    assert rows["interface_rhythm_beside"] == {("robot/base", "robot/base#p2", "robot/base#p1", "~size", 1, 1)}


def test_of_managed_nodes_nothing_is_sent_for_certain() -> None:
    rows = model_rows(replace(MODEL, kind="lifecycle_node"))
    assert {told for *_, told in rows["interface_way"]} == {"partly"}
    assert "interface_rhythm" not in rows


def test_a_rate_that_is_not_known() -> None:
    loop = replace(MODEL.behavior.periodic[0], hz=None, hz_from_param=None)
    sometimes = replace(MODEL.behavior.reactive[0], must=False)
    rows = model_rows(replace(MODEL, behavior=replace(MODEL.behavior, periodic=(loop,), reactive=(sometimes,))))
    assert rows["interface_periodic"] == {("robot/base#p1", 0.0, "")}
    assert rows["interface_reacts"] == {("robot/base#p2", "robot/base#p1", "sometimes")}


def test_a_component_of_the_library() -> None:
    rows = library_rows(FOUND)
    assert rows["interface"] == {("tools/mux", "tools", "mux", "gazebo_plugin", "library")}
    assert rows["interface_port"] == {
        ("tools/mux", "tools/mux#p1", "publisher", "selected"),
        ("tools/mux", "tools/mux#p2", "subscriber", "?"),
        ("tools/mux", "tools/mux#p3", "subscriber", "?"),
        ("tools/mux", "tools/mux#p4", "publisher", "out"),
    }
    assert rows["interface_port_argument"] == {("tools/mux#p1", 1), ("tools/mux#p2", 2)}
    assert (rows["interface_port_rest"], rows["interface_port_suffix"]) == ({("tools/mux#p2",)}, {("tools/mux#p1", "selected")})
    assert rows["interface_port_if_argument"] == {("tools/mux#p2", 1, "mux")}
    assert rows["interface_port_pattern"] == {("tools/mux#p3", "~in[0-9]+")}
    assert rows["interface_port_queue"] == {("tools/mux#p1", 0)}
    assert rows["interface_port_conditional"] == {("tools/mux#p1", "lazy")}
    assert rows["interface_open"] == {("tools/mux", what, "library", "tools/mux", "") for what in ("ports", "params")}
    assert rows["interface_option"] == {("tools/mux", ""), ("tools/mux", "-r")}
    assert rows["interface_element"] == {("tools/mux", "topic", "scan")}
    assert rows["interface_namespace_element"] == {("tools/mux", "ns")}
    assert rows["interface_parameter_pattern"] == {("tools/mux", "tools/mux#a2", "read", "~in.*")}
    assert rows["interface_parameter_default"] == {("tools/mux#a1", "false"), ("tools/mux#a3", "a")}


def test_rows_are_those_of_the_schema() -> None:
    declared = load_declarations(rules_folder() / "system_schema.dl")
    filled: Rows = {}
    for rows in (
        model_rows(MODEL),
        model_rows(TAKING),
        model_rows(SLIDING),
        model_rows(replace(MODEL, configuration="key")),
        library_rows(FOUND),
    ):
        for name, found in rows.items():
            filled.setdefault(name, set()).update(found)
    assert set(filled) <= set(declared)
    for name, found in filled.items():
        assert {len(row) for row in found} == {len(declared[name].attributes)}, name
    interfaces = {name for name in declared if name.startswith("interface")}
    assert interfaces - set(filled) == set()
