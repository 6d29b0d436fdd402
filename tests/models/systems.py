"""Composed systems written by hand, and made of a size."""

from __future__ import annotations

import random
from collections import defaultdict
from collections.abc import Iterable

from rosarch.base.places import Place
from rosarch.models.system.model import Connector, Inclusion, SystemModel, SystemNode, SystemPort

SENDING = ("publisher", "service_client", "action_client", "tf_broadcaster")
CONNECTORS = {"publisher": "topic", "subscriber": "topic", "tf_broadcaster": "topic", "tf_listener": "topic"}


def at(path: str, line: int) -> Place:
    return Place(path, line, 1)


def port(
    kind: str, name: str, type_: str | None, *, written: str | None = None, implicit: bool = False, conditional: str | None = None
) -> SystemPort:
    """A port; its id comes from the node it is given to."""
    return SystemPort("", kind, name, written or name, type_, at("src/node.cpp", 1), implicit, conditional)


def node(
    name: str,
    ports: Iterable[SystemPort] = (),
    *,
    package: str = "pkg",
    type_: str | None = None,
    origin: str = "source",
    lines: tuple[Place, ...] = (),
    conditions: tuple[str, ...] = (),
    id_: str | None = None,
) -> SystemNode:
    type_ = type_ or name.rpartition("/")[2]
    own = tuple(
        SystemPort(f"p{number}", p.kind, p.name, p.written, p.type, p.at, p.implicit, p.conditional) for number, p in enumerate(ports, 1)
    )
    component = None if origin == "unknown" else f"{package}/{type_}"
    return SystemNode(id_ or name, name, package, type_, origin, component, lines, own, conditions, origin == "unknown")


def system(
    nodes: Iterable[SystemNode],
    *,
    name: str = "robot",
    launch: tuple[str, ...] = ("launch/robot.launch",),
    inclusions: tuple[Inclusion, ...] = (),
) -> SystemModel:
    """The nodes with a connector for each name of a topic, service or action."""
    nodes = tuple(nodes)
    ends: dict[tuple[str, str], tuple[list, list, set]] = defaultdict(lambda: ([], [], set()))
    for each in nodes:
        for own in each.ports:
            kind = CONNECTORS.get(own.kind, own.kind.partition("_")[0])
            sources, sinks, types = ends[kind, own.name]
            (sources if own.kind in SENDING else sinks).append((each.id, own.id))
            if own.type:
                types.add(own.type)
    connectors = (
        Connector(kind, name_, tuple(sorted(types)), tuple(sources), tuple(sinks))
        for (kind, name_), (sources, sinks, types) in sorted(ends.items())
    )
    return SystemModel(name, launch, nodes, tuple(connectors), inclusions)


def small() -> SystemModel:
    """A mobile base: every kind of port, a node without a model, one that is started on a condition."""
    return system(
        (
            node(
                "/base/driver",
                (
                    port("publisher", "/base/ticks", "base_msgs/WheelTicks", written="ticks"),
                    port("subscriber", "/cmd_vel", "geometry_msgs/Twist", written="cmd_vel"),
                    port("service_server", "/base/reset", "std_srvs/Trigger", written="~reset"),
                    port("publisher", "/diagnostics", "diagnostic_msgs/DiagnosticArray", implicit=True),
                ),
                package="base_driver",
                lines=(at("launch/robot.launch", 3), at("launch/base.launch", 4)),
            ),
            node(
                "/base/odometry",
                (
                    port("subscriber", "/base/ticks", "base_msgs/WheelTicks", written="ticks"),
                    port("publisher", "/odom", "nav_msgs/Odometry", written="odom"),
                    port("tf_broadcaster", "/tf", "tf2_msgs/TFMessage"),
                ),
                package="base_odometry",
                lines=(at("launch/robot.launch", 3), at("launch/base.launch", 9)),
            ),
            node(
                "/planner",
                (
                    port("subscriber", "/odom", "nav_msgs/Odometry"),
                    port("publisher", "/cmd_vel", "geometry_msgs/Twist"),
                    port("action_server", "/plan", "nav_msgs/PlanAction"),
                    port("publisher", "/plan/status", "actionlib_msgs/GoalStatusArray", implicit=True),
                    port("tf_listener", "/tf", "tf2_msgs/TFMessage"),
                ),
                lines=(at("launch/robot.launch", 5),),
            ),
            node(
                "/mission",
                (
                    port("action_client", "/plan", "nav_msgs/PlanAction"),
                    port("service_client", "/base/reset", "std_srvs/Trigger"),
                    port("subscriber", "/battery", "std_msgs/Float32"),
                ),
                conditions=("arg mission",),
                lines=(at("launch/robot.launch", 6),),
            ),
            node("/viewer", package="other", origin="unknown", lines=(at("launch/robot.launch", 7),)),
        ),
        inclusions=(Inclusion(at("launch/robot.launch", 3), "$(find base)/launch/base.launch", "launch/base.launch"),),
    )


def made(size: int, seed: int = 1) -> SystemModel:
    """A system of `size` nodes in namespaces of about ten; most topics stay in their namespace."""
    random_ = random.Random(seed)
    spaces = [f"/area{number}" for number in range(max(1, size // 10))]
    topics = [f"{random_.choice(spaces)}/topic{number}" for number in range(size)]
    shared = ["/clock", "/map", "/diagnostics"]
    nodes = []
    for number in range(size):
        space = random_.choice(spaces)
        near = [topic for topic in topics if topic.startswith(f"{space}/")] or topics
        ports = [port("publisher", random_.choice(near), "std_msgs/String") for _ in range(random_.randint(0, 2))]
        ports += [
            port("subscriber", random_.choice(near if random_.random() < 0.8 else topics), "std_msgs/String")
            for _ in range(random_.randint(0, 3))
        ]
        if random_.random() < 0.2:
            ports.append(port(random_.choice(("publisher", "subscriber")), random_.choice(shared), "std_msgs/Header"))
        if random_.random() < 0.15:
            ports.append(port(random_.choice(("service_server", "service_client")), f"{space}/reset", "std_srvs/Empty"))
        if random_.random() < 0.4:
            ports.append(port(random_.choice(("tf_broadcaster", "tf_listener")), "/tf", "tf2_msgs/TFMessage"))
        origin = "unknown" if random_.random() < 0.05 else "source"
        nodes.append(node(f"{space}/node{number}", () if origin == "unknown" else ports, package=f"package{number % 12}", origin=origin))
    return system(nodes, name=f"made{size}")
