"""Are models right about real nodes? The ports of nodes of Debian's ROS 1, recovered from sources, against those of the running nodes.

Nothing is installed: the program says which packages are missing. Sources are fetched by `apt-get source` to --folder; those that are
there already (a folder called like the source package) are used as they are.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import os
import subprocess
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from rosbags.typesys import Stores, get_typestore

from rosarch.cli.main import main as rosarch
from rosarch.observation.compare import Accuracy
from rosarch.observation.peer import MessageType, Peer
from rosarch.observation.private import Start, private_graph
from rosarch.observation.processes import wait_until

PORTS = ("publisher", "subscriber", "service_server")
DEB_SRC = "deb-src http://deb.debian.org/debian bookworm main\n"
JOINT = '<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>'
URDF = f'<robot name="r"><link name="base"/><link name="arm"/>{JOINT}</robot>'
PROGRAMS = (Path("/usr/lib"), Path("/usr/bin"))
NAME = "subject"
ZEROS = bytes(512)
"""A message of any of the types below: zeros, and texts and lists of no length."""


@dataclass(frozen=True)
class Node:
    """A node of Debian packages; `source` is their source package, "" where the model is that of the library.

    `inputs` are topics that something is sent on, with types; `outputs` are topics that are read, for nodes that do nothing otherwise.
    `loads` is the description of the plug-ins that the program loads: without it the program runs and does nothing.
    """

    debian: str
    source: str
    package: str
    type: str
    arguments: tuple[str, ...] = ()
    inputs: tuple[tuple[str, str], ...] = ()
    outputs: tuple[str, ...] = ()
    remappings: dict[str, str] = field(default_factory=dict)
    globals: dict[str, Any] = field(default_factory=dict)
    loads: Path | None = None

    @property
    def program(self) -> Path | None:
        """The executable, if it is installed and can load what it loads."""
        if self.loads and not self.loads.exists():
            return None
        found = [PROGRAMS[0] / self.package / self.type, PROGRAMS[1] / self.type]
        return next((path for path in found if path.exists()), None)


BOOL, IMAGE, JOINTS = "std_msgs/msg/Bool", "sensor_msgs/msg/Image", "sensor_msgs/msg/JointState"
NODES = (
    Node("rosout", "ros-ros-comm", "rosout", "rosout"),
    Node("tf-tools", "ros-geometry", "tf", "static_transform_publisher", ("0", "0", "0", "0", "0", "0", "/a", "/b", "100")),
    Node("tf-tools", "ros-geometry", "tf", "tf_echo", ("a", "b")),
    Node("tf-tools", "ros-geometry", "tf", "tf_monitor"),
    Node("tf-tools", "ros-geometry", "tf", "tf_empty_listener"),
    Node("tf2-tools", "ros-geometry2", "tf2_ros", "static_transform_publisher", ("0", "0", "0", "0", "0", "0", "a", "b")),
    Node("tf2-tools", "ros-geometry2", "tf2_ros", "buffer_server"),
    Node("libnodeletlib-tools", "ros-nodelet-core", "nodelet", "nodelet", ("manager",)),
    Node(
        "image-transport-tools", "ros-image-common", "image_transport", "republish", ("raw", "raw"), (("/in", IMAGE),), ("/out",),
        {"in": "/in", "out": "/out"},
    ),
    Node(
        "ros-robot-state-publisher", "ros-robot-state-publisher", "robot_state_publisher", "robot_state_publisher",
        inputs=(("/joint_states", JOINTS),), globals={"/robot_description": URDF},
    ),
    Node("libdiagnostic-aggregator-tools", "ros-diagnostics", "diagnostic_aggregator", "aggregator_node"),
    Node("libself-test-tools", "ros-diagnostics", "self_test", "selftest_example"),
    Node(
        "ros-image-rotate libimage-rotate-dev", "ros-image-pipeline", "image_rotate", "image_rotate",
        inputs=(("/image", IMAGE),), outputs=("/rotated/image",), loads=Path("/usr/share/image_rotate/nodelet_plugins.xml"),
    ),
)  # fmt: skip
# their topics are named on the command line, which the sources alone do not say
OF_THE_LIBRARY = (
    Node("topic-tools", "", "topic_tools", "relay", ("/in", "/out"), (("/in", BOOL),)),
    Node("topic-tools", "", "topic_tools", "throttle", ("messages", "/in", "5", "/out"), (("/in", BOOL),)),
    Node("topic-tools", "", "topic_tools", "mux", ("/out", "/one", "/two"), (("/one", BOOL), ("/two", BOOL))),
    Node("topic-tools", "", "topic_tools", "demux", ("/in", "/one", "/two"), (("/in", BOOL),)),
    Node("topic-tools", "", "topic_tools", "drop", ("/in", "1", "2", "/out"), (("/in", BOOL),)),
)


def fetched(source: str, folder: Path) -> Path:
    """The folder with the sources of a package, unpacked."""
    target = folder / (source or "empty")
    if not source:
        target.mkdir(exist_ok=True)
    elif not target.exists():
        lists = folder / "lists"
        if not lists.exists():
            (lists / "partial").mkdir(parents=True)
            (folder / "sources.list").write_text(DEB_SRC)
            subprocess.run(["apt-get", *_apart(folder), "--quiet", "update"], check=True, stdout=subprocess.DEVNULL)
        (folder / f"{source}.part").mkdir(exist_ok=True)
        command = ["apt-get", *_apart(folder), "--quiet", "source", source]
        subprocess.run(command, check=True, cwd=folder / f"{source}.part", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        (folder / f"{source}.part").rename(target)
    return target


def _apart(folder: Path) -> list[str]:
    """Options that keep the machine's own settings of apt as they are."""
    lists = {"Dir::Etc::SourceList": folder / "sources.list", "Dir::Etc::SourceParts": "/dev/null", "Dir::State::Lists": folder / "lists"}
    return [word for name, value in lists.items() for word in ("-o", f"{name}={value}")]


def launch_text(node: Node) -> str:
    """The launch file that starts a node as it is run here."""
    inside = [f"<remap from={quoteattr(a)} to={quoteattr(b)}/>" for a, b in node.remappings.items()]
    above = [f"<param name={quoteattr(name)} value={quoteattr(str(value))}/>" for name, value in node.globals.items()]
    words = quoteattr(" ".join(node.arguments))
    opened = f'<node pkg="{node.package}" type="{node.type}" name="{NAME}" args={words}>'
    return f"<launch>{''.join(above)}{opened}{''.join(inside)}</node></launch>\n"


def sent(peer: Peer, node: Node) -> None:
    """Send something on each input, again and again, so that what a node makes when it hears something is made."""
    store = get_typestore(Stores.ROS1_NOETIC)
    for topic, type_ in node.inputs:
        definition, checksum = store.generate_msgdef(type_, ros_version=1)
        peer.advertise(topic, MessageType(type_.replace("/msg/", "/"), checksum, definition))
    for topic in node.outputs:
        peer.subscribe(topic, lambda *_: None)
    wait_until(lambda: all(peer.readers(topic) for topic, _ in node.inputs), 3)
    for _ in range(10):
        for topic, _ in node.inputs:
            peer.publish(topic, ZEROS)
        time.sleep(0.05)


def compared(node: Node, root: Path, folder: Path) -> list[dict[str, Any]]:
    """The elements of a node that runs, and what became of each."""
    launch = folder / f"{node.package}_{node.type}.launch"
    launch.write_text(launch_text(node))
    with private_graph() as graph, Peer(graph.master.uri, "/rosarch") as peer:
        for name, value in node.globals.items():
            graph.master.parameters.set(name, value)
        graph.start(Start((str(node.program), *node.arguments), f"/{NAME}", node.remappings))
        sent(peer, node)
        time.sleep(1.0)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            code = rosarch(["compare", str(root), "--launch", str(launch), "--master", graph.master.uri, "--format", "json"])
    if code:
        raise SystemExit(f"{node.package}/{node.type}: rosarch compare exits with {code}")
    return [element for element in json.loads(out.getvalue())["elements"] if element["kind"] in PORTS]


def main() -> None:
    """Run each node, and count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folder", type=Path, default=Path("/tmp/rosarch-recovered"))
    parser.add_argument("--node", action="append", help="only this type; may be repeated")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("ROSARCH_CACHE_DIR", str(given.folder / "cache"))
    absent = sorted({node.debian for node in (*NODES, *OF_THE_LIBRARY) if node.program is None})
    if absent:
        print(f"not installed, left out: {' '.join(absent)}")
    for title, nodes in (("recovered from sources", NODES), ("of the library", OF_THE_LIBRARY)):
        _table(title, [node for node in nodes if node.program and (not given.node or node.type in given.node)], given.folder)


def _table(title: str, nodes: list[Node], folder: Path) -> None:
    """Run nodes and print how their models agree."""
    total: Counter[str] = Counter()
    print(f"{title:44} {'predicted':>9} {'seen':>5} {'missed':>7} {'unseen':>7}")
    for node in nodes:
        elements = compared(node, fetched(node.source, folder), folder)
        counted = Counter(element["outcome"] for element in elements)
        total += counted
        print(_line(f"{node.package}/{node.type}", _accuracy(counted)))
        for element in elements:
            if element["outcome"] != "confirmed":
                print(f"    {element['outcome']} {element['kind']} {element['name']}  {'; '.join(element['reasons'])}")
    every = _accuracy(total)
    print(_line("all", every))
    if every.under is not None:
        print(f"under-approximation {100 * every.under:.1f} %, over-approximation {100 * (every.over or 0):.1f} %\n")


def _line(name: str, found: Accuracy) -> str:
    return f"{name:44} {found.predicted:>9} {found.observed:>5} {found.missed + found.filled:>7} {found.unseen:>7}"


def _accuracy(counted: Counter[str]) -> Accuracy:
    return Accuracy("port", counted["confirmed"], counted["filled"], counted["missed"], counted["unseen"], complete=True)


if __name__ == "__main__":
    main()
