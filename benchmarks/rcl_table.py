"""What rcl makes of names, remapping rules, files of parameters, qualities of service and transitions: the table beside this program.

    PYTHON benchmarks/rcl_table.py [--out FILE]

PYTHON is one with rclpy, see `benchmarks/README.md`. Nodes are made, asked and destroyed; nothing is sent and nobody is met. Each line of
the table is a case, as JSON: its subject, what is given, and the answer. `tests/observation/test_rcl.py` compares rosarch with it.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

TABLE = Path(__file__).with_suffix(".jsonl")
NODE = "n"
REFUSED = "refused"
"""The answer where the node does not start, or the call raises."""
Case = dict[str, Any]

# -- names and remapping rules ------------------------------------------------------------------------------------------------

NAMES = (
    "x", "/x", "x/y", "/a/x", "~", "~/x", "~x", "~/x/y", "", "/", "x/", "x//y", "/x/", "//x", "~/", "a~", "~/~", "x/~",
    "{node}", "{node}/x", "/{node}/x", "{ns}/x", "{namespace}/x", "x{node}", "x_{node}_y/{node}", "~/{node}", "{other}/x", "{node", "node}",
    "1x", "x1", "_x", "x_", "x__y", "x-y", "x.y", "x/1y", "~/1", "X/Y", "x y", "/_hidden/x",
)  # fmt: skip
NAMESPACES = ("/", "/a", "/a/b")
_RULES = r"""
    x:=y | x ; x:=y | /x ; x:=y | /a/x ; x:=y | x/z ; x:=y | ~/x ; x:=y | {node}/x ; /x:=y | x ; /x:=/y | /x ; /a/x:=y | x ;
    /a/x:=z/y | x ; x:=/y | x ; x:=~/y | x ; ~/x:=y | ~/x ; ~/x:=~/y | ~/x ; ~/x:=/y | /a/n/x ; ~/x:=y | n/x ; n/x:=y | ~/x ; ~:=y | ~ ;
    x:=y x:=z | x ; x:=z /a/x:=y | x ; /a/x:=y x:=z | x ; x:=y y:=z | x ; y:=z x:=y | x ; x:=y y:=x | y ; x:=x x:=y | x ; w:=q x:=y | x ;
    n:x:=y | x ; m:x:=y | x ; n:x:=y x:=z | x ; x:=z n:x:=y | x ; m:x:=y x:=z | x ; n:~/x:=y | ~/x ; program:x:=y | x ; n:/x:=y | /x ;
    a/n:x:=y | x ; /a/n:x:=y | x ; rostopic://x:=y | x ; rosservice://x:=y | x ; rostopic:///x:=y | /x ; rostopic://~/x:=y | ~/x ;
    rosservice://~/x:=/y | ~/x ; n:rostopic://x:=y | x ; n:rosservice://x:=y | x ; m:rosservice://x:=y | x ; rostopic://x:=y x:=z | x ;
    x:=z rosservice://x:=y | x ; rosaction://x:=y | x ; x:={node}/y | x ; {node}/x:=y | n/x ; x:= | x ; :=y | x ; x | x ; x/:=y | x ;
    x:=y/ | x ; x//w:=y | x ; x:=y//z | x ; x:=1y | x ; 1x:=y | x ; x:=y.z | x ; x-w:=y | x ; x:=y:=z | x ; ~x:=y | ~x ; x:=~y | x ;
    *:=y | x ; **:=y | x ; */x:=y | a/x ; x:=\1 | x ; /x:=/x__y | /x ; x:=_y | x ; __node:=m | ~/x ; __name:=m | ~/x ;
    __node:=m __node:=k | ~/x ; n:__node:=m | ~/x ; program:__node:=m | ~/x ; m:__node:=k | ~/x ; __ns:=/b | x ; __ns:=/b/c | ~/x ;
    __ns:=b | x ; __ns:=/ | x ; __ns:=~/b | x ; n:__ns:=/b | x ; program:__ns:=/b | x ; m:__ns:=/b | x ; __node:=m m:x:=y | x ;
    __node:=m n:x:=y | x ; __ns:=/b /b/x:=y | x ; __ns:=/b /a/x:=y | x ; __node:=m __ns:=/b ~/x:=~/y | ~/x ; __node:=a/b | x ;
    __node:=/m | x ; __node:=1m | x ; __ns:=/b/ | x ; __ns:=/1b | x ; __ns:= | x ; __other:=m | x ; _x:=3 | x ; __ns:=/b __ns:=/c | x ;
    x_:=y_ | x_ ; _x:=y | _x ; x:=~ | x ; x:=/ | x ; /:=y | x ; ~/:=y | x ; x:=~/y/z | x ; ~/x/w:=y | ~/x/w ; x_y:=z | x_y ;
    ___x:=y | x ; n:__ns:=/b n:x:=y | x ; x:=/a/__y | x ; x1:=y2 | x1 ; n:n:x:=y | x ; rostopic://n/x:=y | n/x ; rostopic:x:=y | x ;
    RX:=Y | RX ; __node:=m_ | x ; __node:=m__k | x ; __ns:=/b__c | x ; __node:= | x
"""
RULES = [(tuple(given.split()), name.strip()) for given, _, name in (case.partition("|") for case in _RULES.split(";"))]


def command_line(name: str, namespace: str, words: Sequence[str]) -> list[str]:
    """As launch_ros writes it: what the launch file gives, then name and namespace."""
    return ["--ros-args", *words, "--ros-args", "-r", f"__node:={name}", "-r", f"__ns:={namespace}"]


def rule_words(rules: Iterable[str]) -> list[str]:
    """The words of a command line that give remapping rules."""
    return [word for rule in rules for word in ("-r", rule)]


def name_cases() -> Iterator[Case]:
    """A name, alone and with rules, in several namespaces."""
    for namespace, name in itertools.product(NAMESPACES, NAMES):
        yield {"subject": "name", "kind": "topic", "namespace": namespace, "rules": [], "name": name}
    for kind, namespace, (rules, name) in itertools.product(("topic", "service"), NAMESPACES[:2], RULES):
        yield {"subject": "name", "kind": kind, "namespace": namespace, "rules": list(rules), "name": name}


def name_answer(case: Case, made: Any) -> str:
    """The name on the graph."""
    from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException
    from rclpy.validate_full_topic_name import validate_full_topic_name

    node = made(rule_words(case["rules"]), case["namespace"])
    resolve = node.resolve_topic_name if case["kind"] == "topic" else node.resolve_service_name
    name: str = resolve(case["name"])
    try:
        validate_full_topic_name(name, is_service=case["kind"] == "service")
    except (InvalidServiceNameException, InvalidTopicNameException):
        return REFUSED
    return name


# -- parameters ---------------------------------------------------------------------------------------------------------------

FILES: tuple[tuple[str, ...], ...] = tuple(
    tuple(texts)
    for texts in (
        ["/**:\n  ros__parameters:\n    p: 1\n"],
        ["/*:\n  ros__parameters:\n    p: 1\n"],
        ["/*/*:\n  ros__parameters:\n    p: 1\n"],
        ["/**/n:\n  ros__parameters:\n    p: 1\n"],
        ["/*/n:\n  ros__parameters:\n    p: 1\n"],
        ["/a/*:\n  ros__parameters:\n    p: 1\n"],
        ["/a/**:\n  ros__parameters:\n    p: 1\n"],
        ["/**/a/n:\n  ros__parameters:\n    p: 1\n"],
        ["/a/**/n:\n  ros__parameters:\n    p: 1\n"],
        ["**:\n  ros__parameters:\n    p: 1\n"],
        ["'*':\n  ros__parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    p: 1\n"],
        ["/n:\n  ros__parameters:\n    p: 1\n"],
        ["a/n:\n  ros__parameters:\n    p: 1\n"],
        ["/a/n:\n  ros__parameters:\n    p: 1\n"],
        ["a:\n  n:\n    ros__parameters:\n      p: 1\n"],
        ["/a:\n  n:\n    ros__parameters:\n      p: 1\n"],
        ["/a:\n  /n:\n    ros__parameters:\n      p: 1\n"],
        ["a:\n  b:\n    n:\n      ros__parameters:\n        p: 1\n"],
        ["a:\n  '*':\n    ros__parameters:\n      p: 1\n"],
        ["'**':\n  n:\n    ros__parameters:\n      p: 1\n"],
        ["/a*:\n  ros__parameters:\n    p: 1\n"],
        ["/n*:\n  ros__parameters:\n    p: 1\n"],
        ["/**n:\n  ros__parameters:\n    p: 1\n"],
        ["/a/n/:\n  ros__parameters:\n    p: 1\n"],
        ["//n:\n  ros__parameters:\n    p: 1\n"],
        ["program:\n  ros__parameters:\n    p: 1\n"],
        ["/**:\n  ros__parameters:\n    p: 1\nn:\n  ros__parameters:\n    p: 2\n"],
        ["n:\n  ros__parameters:\n    p: 2\n/**:\n  ros__parameters:\n    p: 1\n"],
        ["/**:\n  ros__parameters:\n    p: 1\n/a/n:\n  ros__parameters:\n    p: 2\n/*:\n  ros__parameters:\n    p: 3\n"],
        ["/a/*:\n  ros__parameters:\n    p: 1\n/**/n:\n  ros__parameters:\n    p: 2\n"],
        ["n:\n  ros__parameters:\n    p: 1\nn:\n  ros__parameters:\n    p: 2\n    q: 3\n"],
        ["n:\n  ros__parameters:\n    p: 1\n    p: 2\n"],
        ["/n:\n  ros__parameters:\n    p: 1\nn:\n  ros__parameters:\n    p: 2\n"],
        ["/**:\n  ros__parameters:\n    p: 1\n", "n:\n  ros__parameters:\n    p: 2\n"],
        ["n:\n  ros__parameters:\n    p: 2\n", "/**:\n  ros__parameters:\n    p: 1\n    q: 4\n"],
        ["/a/n:\n  ros__parameters:\n    p: 2\n", "n:\n  ros__parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    p: 2\n", "n:\n  ros__parameters:\n    p: text\n"],
        ["n:\n  ros__parameters:\n    a: {b: 1, c: {d: two}}\n    a.b: 3\n"],
        ["n:\n  ros__parameters:\n    a:\n      b: 1\n", "n:\n  ros__parameters:\n    a.b: 2\n    a.c: 3\n"],
        ["n:\n  a:\n    ros__parameters:\n      p: 1\n  ros__parameters:\n    q: 2\n"],
        ["n:\n  ros__parameters:\n    ros__parameters:\n      p: 1\n"],
        ["n:\n  ros__parameters: {}\n"],
        ["n:\n  ros__parameters:\n"],
        ["n: {}\n"],
        ["n:\n"],
        ["{}\n"],
        [""],
        ["ros__parameters:\n  p: 1\n"],
        ["n:\n  p: 1\n"],
        ["n:\n  ros_parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    p:\n"],
        ["n:\n  ros__parameters:\n    p: []\n"],
        ["n:\n  ros__parameters:\n    p: [1, 2.0]\n"],
        ["n:\n  ros__parameters:\n    p: [1, x]\n"],
        ["n:\n  ros__parameters:\n    p: [[1], [2]]\n"],
        ["n:\n  ros__parameters:\n    p: &one 1\n    q: *one\n"],
        ["n:\n  ros__parameters:\n    1: 2\n    true: 3\n"],
        ["n, m:\n  ros__parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    p: [true, false]\n    q: [a, 'b']\n    r: [1.5, 2.0]\n    s: [1, -2]\n"],
        ["- n\n- m\n"],
        ["n:\n- p\n"],
        ["n:\n  ros__parameters: [1]\n"],
        ["n:\n  ros__parameters: 1\n"],
        ["text\n"],
        *(
            [f"{json.dumps(key)}:\n  ros__parameters:\n    p: 1\n"]
            for key in (
                "1n",
                "n-m",
                "",
                "/",
                "n__m",
                "n.m",
                "n m",
                "a//n",
                "*n",
                "***",
                "/**/**",
                "/**/*",
                "_n",
                "~",
                "~/n",
                "a/",
                "/a/*/n",
                "/a/**/b/n",
            )
        ),
        *(
            [f"{json.dumps(key)}:\n  n:\n    ros__parameters:\n      p: 1\n"]
            for key in ("", "/", "a/", "/a/", "a/b", "/**", "/**/", "a-b", "1a", "*", "/*")
        ),
        *(
            [f"n:\n  ros__parameters:\n    {json.dumps(key)}: 1\n"]
            for key in ("", ".", "a.", ".a", "a..b", "a-b", "a b", "1", "~", "a/b", "a:b", "é")
        ),
        ["n:\n  ros__parameters:\n    a: {}\n    b: 1\n"],
        ["n:\n  ros__parameters:\n    a:\n      b: {}\n    c: 1\n"],
        ["n:\n  ros__parameters:\n    a: {}\nm:\n  ros__parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    a: {b: {}}\n"],
        ["n:\n  ros__parameters:\n    p: [1, 2\n"],
        ["n:\n\tros__parameters:\n    p: 1\n"],
        ["n:\n  ros__parameters:\n    p: 1\nn:\n  q: 2\n"],
        ["n:\n  ros__parameters:\n    p: 1\n", "n:\n  ros__parameters:\n    q:\n"],
        ["n:\n  ros__parameters:\n    p: [a, '1', \"b\"]\n    q: ['1', 2]\n"],
        ["n:\n  ros__parameters:\n    p: [yes, true]\n    q: [1e3, .5]\n    r: [0x10, 8]\n"],
        ["n:\n  ros__parameters:\n    p: [1, ]\n    q: [~, null]\n"],
        ["n:\n  ros__parameters:\n    b: 1\n    a: {}\n"],
        ["n:\n  ros__parameters:\n    p: {a: [1], b: {c: x}}\n"],
        ["n:\n  ros__parameters:\n    p: 1\n  ros__parameters:\n    p: 2\n    q: 3\n"],
    )
)
SCALARS = (
    *r"""
    1  -1  +1  1.0  1.  .5  1e3  -1E-3  0x1F  010  0o17  0b1  1_000  true  True  TRUE  tRue  yes  Yes  no  y  n  on  Off  null  ~  Null
    .inf  -.inf  .nan  inf  nan  1e  '1'  "true"  !!str 1  !!int '3'  !!float 3  !!bool 'yes'  abc  1:30  2020-01-01
    9223372036854775807  9223372036854775808  -9223372036854775808  1 2  'it''s'  "a\nb"  0  -0  00  08  1.5.2  1,5  =  <<  ''  ""  0x
    0xG  0x.8  0x1p3  0x1.8  1e400  -1e400  1e-400  2.3e-308  2.2e-308  +.inf  .INF  +.nan  -nan  Infinity  -0x1F  1.e2  e5  +  -  .
    1__0  5e-324  %x  a:b
""".replace("\n    ", "  ")
    .strip()
    .split("  "),
    "|\n      a\n      b",
)
_ON_COMMAND_LINE = r"""
    p:=1 ; p:=1.0 ; p:=true ; p:=abc ; p:='1' ; p:=[1, 2] ; p:=[a, b] ; p:= ; p:='' ; p:=yes ; p:=0x10 ; p:=1e3 ; p:=a:b ; p:=a: b ;
    p:={a: 1} ; p.q:=1 ; p/q:=1 ; n:p:=1 ; m:p:=1 ; program:p:=1 ; p:=1 -p p:=2 ; p:=1 -p n:p:=2 ; n:p:=2 -p p:=1 ; p:=1 -p p:=text ;
    ~p:=1 ; _p:=1 ; p q:=1 ; p:=:= ; p:=[1, 2.0] ; p:=[] ; 1p:=1 ; p-q:=1 ; /a/n:p:=1 ; /*:p:=1 ; /**:p:=3 ; p:=!!str 1 ; p:=# 1 ; p ;
    :=1 ; p:=null ; p:=1 2 ; p:="x" ; p:=%x ; p:=*x ; p:=&x ; p__q:=1 ; p.:=1 ; .p:=1 ; p..q:=1 ; p.1:=1 ; p.q.r:=x ; ~/p:=1 ; P1_:=1 ;
    __p:=1 ; p:= 1 ; p :=1 ; p:=[1 ; p:=- 1 ; p:=[true, 'x'] ; p:=-1 ; p:=.inf ; p:=-5.0 ; p:=| ; p:=@x ; p:=!x ; p:=? ; p:=a #b ;
    *:p:=1 ; n::p:=1 ; p:=1 -p q:=2 ; p:=[1] -p p:=[2, 3] ; p:=true -p p:=1 ; p:=x -p p:=1.5
"""
ON_COMMAND_LINE = [tuple(case.strip().split(" -p ")) for case in _ON_COMMAND_LINE.split(" ;")]
BOTH: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("n:\n  ros__parameters:\n    p: 1\n", ("p:=2",)),
    ("n:\n  ros__parameters:\n    p: 1\n", ("n:p:=2",)),
    ("/**:\n  ros__parameters:\n    p: 1\n", ("p:=2",)),
    ("/a/n:\n  ros__parameters:\n    p: 1\n", ("p:=2",)),
    ("n:\n  ros__parameters:\n    p: {q: 1}\n", ("p.q:=2",)),
)


def parameter_cases() -> Iterator[Case]:
    """Files, scalars and assignments."""
    for namespace, texts in itertools.product(NAMESPACES, FILES):
        yield {"subject": "parameters", "namespace": namespace, "files": list(texts), "assigned": []}
    for scalar in SCALARS:
        yield {"subject": "parameters", "namespace": "/", "files": [f"n:\n  ros__parameters:\n    p: {scalar}\n"], "assigned": []}
    for namespace, assigned in itertools.product(NAMESPACES[:2], ON_COMMAND_LINE):
        yield {"subject": "parameters", "namespace": namespace, "files": [], "assigned": list(assigned)}
    for namespace, (text, assigned) in itertools.product(NAMESPACES[:2], BOTH):
        for first in ("files", "assigned"):
            yield {"subject": "parameters", "namespace": namespace, "files": [text], "assigned": list(assigned), "first": first}


def parameter_words(case: Case, files: Sequence[str]) -> list[str]:
    """The words of a command line that give a case's parameters."""
    given = [word for file in files for word in ("--params-file", file)]
    assigned = [word for one in case["assigned"] for word in ("-p", one)]
    return [*assigned, *given] if case.get("first") == "assigned" else [*given, *assigned]


_OF_EVERY_NODE = ("use_sim_time", "start_type_description_service")


def parameter_answer(case: Case, made: Any) -> dict[str, Any]:
    """The parameters that the node has a value for, by name."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, text in enumerate(case["files"]):
            path = Path(folder, f"{number}.yaml")
            path.write_text(text, encoding="utf-8")
            files.append(str(path))
        node = made(parameter_words(case, files), case["namespace"])
    given = sorted(node._parameter_overrides.items())
    return {name: plain(one.value) for name, one in given if name not in _OF_EVERY_NODE and one.value is not None}


def plain(value: Any) -> Any:
    """A value as JSON has it; a number that JSON does not have as text."""
    if isinstance(value, float) and (value != value or value in (float("inf"), float("-inf"))):
        return str(value)
    return value if isinstance(value, (str, bool, int, float, bytes, type(None))) else [plain(each) for each in value]


# -- qualities of service -----------------------------------------------------------------------------------------------------

POLICIES: dict[str, tuple[str, ...]] = {
    "reliability": ("reliable", "best_effort", "system_default", "best_available"),
    "durability": ("volatile", "transient_local", "system_default", "best_available"),
    "liveliness": ("automatic", "manual_by_topic", "system_default", "best_available"),
    "deadline": ("infinite", "1", "2"),
    "lease_duration": ("infinite", "1", "2"),
}
PROFILES = (
    "system_default",
    "sensor_data",
    "services_default",
    "parameters",
    "parameter_events",
    "action_status_default",
    "best_available",
)


def quality_cases() -> Iterator[Case]:
    """One policy of a publisher beside that of a subscriber; two policies at once; profiles."""
    for policy, settings in POLICIES.items():
        for offered, requested in itertools.product(settings, settings):
            yield {"subject": "qualities", "offered": {policy: offered}, "requested": {policy: requested}}
    for offered, requested in itertools.product(PROFILES[:-1], PROFILES[:-1]):  # the last one is not compared by rmw
        yield {"subject": "qualities", "offered": {"profile": offered}, "requested": {"profile": requested}}
    for profile in PROFILES:
        yield {"subject": "profile", "profile": profile}


def quality_of(settings: dict[str, str]) -> Any:
    """A profile of rclpy: reliable, volatile, without limits in time, but for these settings."""
    from rclpy.duration import Duration
    from rclpy.qos import QoSDurabilityPolicy, QoSLivelinessPolicy, QoSPresetProfiles, QoSProfile, QoSReliabilityPolicy

    if "profile" in settings:
        return QoSPresetProfiles.get_from_short_key(settings["profile"])
    enumerations = {"reliability": QoSReliabilityPolicy, "durability": QoSDurabilityPolicy, "liveliness": QoSLivelinessPolicy}
    given: dict[str, Any] = {"reliability": "reliable", "durability": "volatile", "liveliness": "automatic", **settings}
    values: dict[str, Any] = {policy: kind[given[policy].upper()] for policy, kind in enumerations.items()}
    for policy, field in (("deadline", "deadline"), ("lease_duration", "liveliness_lease_duration")):
        if given.get(policy, "infinite") != "infinite":
            values[field] = Duration(seconds=float(given[policy]))
    return QoSProfile(depth=10, **values)


def quality_answer(case: Case, _made: Any) -> Any:
    """Whether the two meet (ok, warning, error), or the policies of a profile."""
    from rclpy.qos import qos_check_compatible

    if case["subject"] == "profile":
        found = quality_of({"profile": case["profile"]})
        policies = {policy: getattr(found, policy).name.lower() for policy in ("reliability", "durability", "history", "liveliness")}
        return {**policies, "depth": found.depth}
    answer, _ = qos_check_compatible(quality_of(case["offered"]), quality_of(case["requested"]))
    return answer.name.lower()


# -- managed nodes ------------------------------------------------------------------------------------------------------------

CALLBACKS = ("on_configure", "on_activate", "on_deactivate", "on_cleanup", "on_shutdown", "on_error")
WAYS: dict[str, tuple[str, ...]] = {
    "unconfigured": (), "inactive": ("configure",), "active": ("configure", "activate"), "finalized": ("shutdown",),
}  # fmt: skip
ASKED = ("configure", "activate", "deactivate", "cleanup", "shutdown")


def life_cases() -> Iterator[Case]:
    """In each state each transition, with each outcome of its callback; what a managed node has beside its own ports."""
    for state, transition, outcome in itertools.product(WAYS, ASKED, ("success", "failure", "error", "raises")):
        for recovery in ("success", "failure") if outcome in ("error", "raises") else ("",):
            yield {"subject": "life", "state": state, "transition": transition, "outcome": outcome, "recovery": recovery}
    yield {"subject": "ports of a managed node"}


def life_answer(case: Case, _made: Any) -> Any:
    """The callbacks that ran, and the state thereafter."""
    import rclpy
    from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn

    ran: list[str] = []
    outcome = {"now": "success"}

    def called(name: str) -> Any:
        def run(_self: Any, _state: Any) -> Any:
            ran.append(name)
            told = case.get("recovery", "") if name == "on_error" else outcome["now"]
            if told == "raises":
                raise ValueError(told)
            return getattr(TransitionCallbackReturn, (told or "success").upper())

        return run

    node = type("Managed", (LifecycleNode,), {name: called(name) for name in CALLBACKS})("managed", enable_rosout=False)
    try:
        if case["subject"] != "life":
            name, space = node.get_name(), node.get_namespace()
            sides = {"publisher": node.get_publisher_names_and_types_by_node, "service_server": node.get_service_names_and_types_by_node}
            found = {kind: [[port, types[0]] for port, types in ask(name, space)] for kind, ask in sides.items()}
            return {kind: sorted(row for row in rows if "lifecycle_msgs" in row[1]) for kind, rows in found.items()}
        machine = node._state_machine
        for step in WAYS[case["state"]]:
            getattr(node, f"trigger_{step}")()
        ran.clear()
        outcome["now"] = case["outcome"]
        try:
            getattr(node, f"trigger_{case['transition']}")()
        except rclpy._rclpy_pybind11.RCLError:
            return REFUSED
        return {"ran": ran, "state": machine.current_state[1]}
    finally:
        node.destroy_node()


# -- the table ----------------------------------------------------------------------------------------------------------------

ANSWERS = {
    "name": name_answer, "parameters": parameter_answer, "qualities": quality_answer, "profile": quality_answer, "life": life_answer,
    "ports of a managed node": life_answer,
}  # fmt: skip


def cases() -> list[Case]:
    """All cases, without answers."""
    return [*name_cases(), *parameter_cases(), *quality_cases(), *life_cases()]


def answered(case: Case) -> Case:
    """A case with what rcl says; it raises for what it rejects."""
    from rclpy.node import Node

    nodes: list[Any] = []

    def made(words: Sequence[str], namespace: str) -> Any:
        given = command_line(NODE, namespace, words)
        node = Node("program", cli_args=given, use_global_arguments=False, start_parameter_services=False, enable_rosout=False)
        nodes.append(node)
        return node

    try:
        answer = ANSWERS[case["subject"]](case, made)
    except Exception:  # rclpy has many, and all of them mean that it does not take what it is given
        answer = REFUSED
    for node in nodes:
        node.destroy_node()
    return {**case, "answer": answer}


def table() -> list[Case]:
    """The whole table, by this Python's rclpy."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "OFF"
    import rclpy
    from rclpy.logging import LoggingSeverity, set_logger_level

    rclpy.init(args=[], domain_id=int(os.environ.get("ROS_DOMAIN_ID", "0")))
    set_logger_level("rcl", LoggingSeverity.FATAL)
    try:
        return [answered(case) for case in cases()]
    finally:
        rclpy.shutdown()


def text(rows: Iterable[Case]) -> str:
    """A table as it is kept."""
    return "".join(f"{json.dumps(row, ensure_ascii=False)}\n" for row in rows)


def main() -> None:
    """Make the table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--out", type=Path, default=TABLE, help="the file that is written")
    given = parser.parse_args()
    given.out.write_text(text(table()), encoding="utf-8")


if __name__ == "__main__":
    main()
