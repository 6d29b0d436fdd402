"""The private graph: its master, its parameters, and that nothing of it is left."""

from __future__ import annotations

import http.server
import os
import socket
import threading
from pathlib import Path

import pytest

from rosarch.observation.graph import Graph
from rosarch.observation.master import Master
from rosarch.observation.parameters import Parameters
from rosarch.observation.peer import MessageType, Peer
from rosarch.observation.private import Start, StartError, private_graph
from rosarch.observation.processes import wait_until
from rosarch.observation.rpc import CallError, Remote, Server

BOOL = MessageType("std_msgs/Bool", "8b94c1b53db61fb6aed406028ad6332a")
STUBBORN = "#!/bin/sh\ntrap '' INT TERM\nsleep 600 &\necho $! > {child}\necho waiting for hardware\nwait\n"


def script(path: Path, text: str) -> tuple[str]:
    path.write_text(text)
    path.chmod(0o755)
    return (str(path),)


def runs(process: int) -> bool:
    """Whether it runs: one that has ended but was not waited for has no command line."""
    try:
        return bool(Path(f"/proc/{process}/cmdline").read_bytes())
    except (FileNotFoundError, ProcessLookupError):
        return False


def test_all_that_a_node_has_started_ends_with_the_graph(tmp_path: Path) -> None:
    child = tmp_path / "child"
    command = script(tmp_path / "stubborn", STUBBORN.format(child=child))
    with private_graph() as graph:
        with pytest.raises(StartError, match=r"^/arm/stubborn did not come up within 0.5 s: waiting for hardware$"):
            graph.start(Start(command, "/arm/stubborn"), seconds=0.5)
        folder = Path(graph.environment()["ROS_HOME"])
        process = int(child.read_text())
        assert runs(process)
    assert wait_until(lambda: not runs(process), 2)
    assert not folder.exists()


def test_a_node_that_ends_at_once_is_told(tmp_path: Path) -> None:
    with private_graph() as graph:
        with pytest.raises(StartError, match=r"^/broken exited with 3: no map$"):
            graph.start(Start(script(tmp_path / "broken", "#!/bin/sh\necho no map\nexit 3\n"), "/broken"))
        with pytest.raises(StartError, match=r"^/crashed was killed by SIGSEGV$"):
            graph.start(Start(script(tmp_path / "crashed", "#!/bin/sh\nkill -SEGV $$\n"), "/crashed"))
        with pytest.raises(StartError, match=r"gone: No such file or directory$"):
            graph.start(Start((str(tmp_path / "gone"),), "/gone"))


def test_what_one_peer_sends_the_other_reads() -> None:
    heard: list[tuple[str, bytes]] = []
    arrived = threading.Event()

    def hear(sender: str, _at: float, message: bytes) -> None:
        heard.append((sender, message))
        arrived.set()

    with Master() as master, Peer(master.uri, "/reader") as reader:
        reader.subscribe("/flag", hear)
        with Peer(master.uri, "/sender") as sender:
            sender.advertise("/flag", BOOL)
            assert wait_until(lambda: sender.readers("/flag"), 3)
            sender.publish("/flag", b"\1")
            assert arrived.wait(3)
            state = Graph(master.uri).state()
        assert heard == [("/sender", b"\1")]
        assert state.publishers == {("/sender", "/flag")}
        assert state.subscribers == {("/reader", "/flag")}
        assert Graph(master.uri).state().publishers == frozenset()
        assert Graph(master.uri).snapshot().types == {("topic", "/flag"): "std_msgs/Bool"}


def test_the_master_keeps_parameters_and_knows_who_asks() -> None:
    with Master() as master:
        node = Remote(master.uri, "/arm/gripper")
        node.call("setParam", "~force", 2.5)
        node.call("setParam", "limits", {"low": 0, "high": 9})
        assert node.call("getParam", "/arm") == {"gripper": {"force": 2.5}, "limits": {"low": 0, "high": 9}}
        assert node.call("searchParam", "limits/high") == "/arm/limits/high"
        assert node.call("hasParam", "/arm/limits/middle") is False
        assert node.call("subscribeParam", "http://127.0.0.1:1/", "speed") == {}
        assert sorted(node.call("getParamNames")) == ["/arm/gripper/force", "/arm/limits/high", "/arm/limits/low"]
        node.call("deleteParam", "limits/low")
        with pytest.raises(CallError, match=r"getParam failed: Parameter \[/arm/limits/low\] is not set$"):
            node.call("getParam", "limits/low")
        with pytest.raises(CallError, match=r"lookupService failed"):
            node.call("lookupService", "/arm/open")
        assert {(kind, name) for _, kind, name in master.asked} >= {("parameter", "/arm/speed"), ("service", "/arm/open")}


@pytest.mark.parametrize(
    ("key", "name"), [("x", "/a/x"), ("~x", "/a/b/x"), ("/x", "/x"), ("/x/", "/x"), ("~", "/a/b")], ids=lambda text: text.replace("/", ":")
)
def test_names_of_parameters(key: str, name: str) -> None:
    assert Parameters.absolute("/a/b", key) == name


def test_an_older_node_of_the_same_name_is_told_to_end() -> None:
    ended = threading.Event()
    older = Server({"shutdown": lambda _caller, _reason: ended.set() or 0})
    with Master() as master:
        node = Remote(master.uri, "/twin")
        node.call("registerPublisher", "/a", "a/A", older.uri)
        node.call("registerPublisher", "/b", "a/A", "http://127.0.0.1:1/")
        assert ended.wait(3)
        assert Graph(master.uri).state().publishers == {("/twin", "/b")}
    older.close()


def test_a_master_that_does_not_answer_is_one_line() -> None:
    with pytest.raises(CallError, match=r"^http://127.0.0.1:9/: no answer to getSystemState: Connection refused$"):
        Graph("http://127.0.0.1:9/").state()
    with pytest.raises(CallError, match=r"^nowhere: not the address of a master, such as http://localhost:11311$"):
        Graph("nowhere")


def test_a_master_that_keeps_silent_times_out() -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent:
        uri = f"http://127.0.0.1:{silent.getsockname()[1]}/"
        with pytest.raises(CallError, match=r"no answer to getSystemState: timed out$"):
            Graph(uri, seconds=0.2).state()


def test_a_web_server_is_no_master() -> None:
    class Page(http.server.BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            self.send_response(200)
            self.send_header("Content-Length", "5")
            self.end_headers()
            self.wfile.write(b"hello")

        def log_message(self, format: str, *args: object) -> None:
            pass

    with http.server.HTTPServer(("127.0.0.1", 0), Page) as server:
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True).start()
        with pytest.raises(CallError, match="what answers to getSystemState is no ROS master or node"):
            Graph(f"http://127.0.0.1:{server.server_address[1]}/").state()
        server.shutdown()


def test_this_process_is_no_node(tmp_path: Path) -> None:
    """What nodes find in their environment is the private master, whatever is set here."""
    with private_graph() as graph, pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROS_MASTER_URI", "http://robot:11311")
        patch.setenv("ROS_HOSTNAME", "robot")
        environment = graph.environment()
        assert environment["ROS_MASTER_URI"] == graph.master.uri
        assert "ROS_HOSTNAME" not in environment
        assert os.environ["ROS_MASTER_URI"] == "http://robot:11311"
