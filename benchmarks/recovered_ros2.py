"""Are models right about real nodes of ROS 2? Nodes of rclpy, run one by one, beside the models that are recovered from their sources.

    ROSARCH_ROS2_PYTHON=PYTHON benchmarks/recovered_ros2.py CHECKOUT... [--node NAME] [--set PACKAGE/NAME:PARAMETER:=VALUE] [--misses]

Each entry point of each Python package of a checkout runs for some seconds in a domain of its own on loopback. Its ports, their types and
qualities of service, and its parameters are those of the graph at any time; what is filled has a name that the model leaves open. Its
timers and their periods are those that it makes, but for rates, which are loops, and for what parameters say that `--set` gives. Programs
that fail at once, as when a package is missing, are listed. Nothing is built or installed.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import os
import shlex
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from rosarch.cli.main import main as rosarch
from rosarch.extractor.workspace import discover
from rosarch.observation.domain import VARIABLE, Participant, environment, free_domain, python_with_ros
from rosarch.observation.private import last_line
from rosarch.observation.processes import Process, wait_until
from rosarch.observation.rpc import CallError

OF_THE_GRAPH = ("reliability", "durability")
"""The policies that a graph shows."""
RUN = """import json, os, pty, sys, time
os.dup2(pty.openpty()[1], 0)
import rclpy, rclpy.context, rclpy.node
create_timer = rclpy.node.Node.create_timer
def noted(self, period, *given, **named):
    frame = sys._getframe(1)
    if "/rclpy/" not in frame.f_code.co_filename:
        with open({timers!r}, "a") as file:
            print(json.dumps([frame.f_code.co_filename, frame.f_lineno, period]), file=file)
    return create_timer(self, period, *given, **named)
rclpy.node.Node.create_timer = noted
for kind, names in ((rclpy.context.Context, ("shutdown", "try_shutdown", "__exit__")), (rclpy.node.Node, ("destroy_node",))):
    for name in names:
        setattr(kind, name, lambda *_, **__: None)
sys.argv[0] = {name!r}
from {module} import {function} as run
try:
    run()
except Exception as error:
    print(repr(error))
if rclpy.ok():
    time.sleep(60)
"""
"""Runs a program with a terminal, as some nodes read keys, and keeps its nodes when it is through: some are there for a moment only. Timers
are noted with the line that makes them."""


def programs(root: Path) -> Iterator[tuple[str, str, str, str]]:
    """The entry points of a checkout: package, name, module and function."""
    for package in discover(root).packages:
        for entry in package.entry_points:
            yield package.name, entry.name, entry.module, entry.function


def modules(root: Path) -> list[str]:
    """The folders that Python finds the modules of the packages in."""
    return [str(folder) for package in discover(root).packages for folder in {package.path, *package.python_roots}]


def compared(root: Path, program: tuple[str, str, str, str], words: list[str], seconds: float) -> dict[str, Any] | str:
    """What `rosarch compare` and the model's qualities come to; a text where the node cannot be looked at."""
    package, name, module, function = program
    with tempfile.TemporaryDirectory() as folder, free_domain() as domain:
        log, launch, timers = Path(folder, "log"), Path(folder, "main.launch.xml"), Path(folder, "timers")
        args = f" args={quoteattr(shlex.join(words))}" if words else ""
        launch.write_text(f'<launch><node pkg="{package}" exec="{name}"{args}/></launch>', encoding="utf-8")
        path = os.pathsep.join(modules(root))
        given = {**environment(domain), "PYTHONPATH": path}
        os.environ.update(environment(domain))
        command = [
            python_with_ros(),
            "-c",
            RUN.format(name=name, module=module, function=function, timers=str(timers)),
            *words,
        ]
        with Participant(python_with_ros(), domain, private=True) as participant, Process(command, Path(folder), log, given) as process:
            wait_until(lambda: process.ended or participant.ask("graph", parameters=False)["nodes"], 10, step=0.1)
            if process.ended:
                return f"{process.ended}{last_line(log)}"
            if not participant.ask("graph", parameters=False)["nodes"]:
                return f"it made no node{last_line(log)}"
            activate(participant)
            arguments = ["compare", str(root), "--launch", str(launch), "--domain", str(domain), "--seconds", str(seconds), "--every", "1"]
            out, err = io.StringIO(), io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                code = rosarch([*arguments, "--format", "json"])
            if code > 1:
                return f"rosarch compare exits with {code}: {err.getvalue().strip().splitlines()[-1:]}"
            found: dict[str, Any] = json.loads(out.getvalue())
            found["qualities"] = participant.ask("graph", parameters=False)["qualities"]
            found["timers"] = [json.loads(line) for line in timers.read_text(encoding="utf-8").splitlines()] if timers.exists() else []
            return found


def activate(participant: Participant) -> None:
    """Configure and activate managed nodes, and wait until all is there."""
    participant.settle()
    for node in participant.ask("graph", parameters=False)["nodes"]:
        for transition in (1, 3):
            with contextlib.suppress(CallError):
                values = {"transition.id": transition}
                participant.ask("call", service=f"{node}/change_state", type="lifecycle_msgs/srv/ChangeState", values=values)


def models(root: Path, folder: Path) -> dict[tuple[str, str], dict[str, Any]]:
    """The models of a checkout by package and node."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        rosarch(["analyze", str(root), "-o", str(folder)])
    found = {}
    for file in folder.rglob("*.json"):
        document = json.loads(file.read_text(encoding="utf-8"))
        if "component" in document:
            found[document["package"], document["component"]] = document
    return found


def apart_in_quality(model: dict[str, Any], qualities: list[Any]) -> tuple[int, list[str]]:
    """How many policies were compared, and those that differ."""
    count, apart = 0, []
    seen: dict[tuple[str, str], set[str]] = {}
    for kind, _node, topic, policies in qualities:
        for policy in OF_THE_GRAPH:
            seen.setdefault((f"{kind} {topic}", policy), set()).add(policies[policy])
    for port in model.get("ports") or ():
        name = str(port.get("name"))
        topic = name if name.startswith("/") else f"/{model.get('node_name')}/{name.lstrip('~/')}" if name.startswith("~") else f"/{name}"
        told = port.get("qos") or {}
        for policy in OF_THE_GRAPH:
            actual = seen.get((f"{port['kind']} {topic}", policy))
            if actual and len(actual) == 1 and told.get(policy):
                count += 1
                if told[policy] not in (*actual, "system_default", "best_available"):
                    apart.append(f"{port['kind']} {topic} {policy}: {told[policy]}, seen {' '.join(actual)}")
    return count, apart


def apart_in_timers(model: dict[str, Any], timers: list[tuple[str, int, float]], given: set[str]) -> tuple[int, list[str]]:
    """How many timers were compared, and those that the model has not, or with another rate; those of `given` parameters have that."""
    count, apart = 0, []
    loops = [*(model.get("periodic") or ()), *(model.get("one_shot") or ())]
    for file, line, period in timers:
        same = [one for one in loops if str(one.get("at")).rpartition(":")[2] == str(line) and file.endswith(one["at"].rpartition(":")[0])]
        if any(one.get("hz_from_param", one.get("after_from_param")) in given for one in same):
            continue
        count += 1
        told = {1 / one["hz"] if one.get("hz") else one.get("after") for one in same if one.get("hz") or one.get("after")}
        if not any(abs(each - period) <= period / 1000 for each in told):
            apart.append(f"timer {Path(file).name}:{line} of {period} s: {' '.join(f'{each:g} s' for each in told) or 'none'}")
    return count, apart


def main() -> None:
    """Run each node, and count."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("checkout", nargs="+", type=Path)
    parser.add_argument("--node", action="append", help="only this entry point; may be repeated")
    parser.add_argument("--set", action="append", default=[], help="PACKAGE/NAME:PARAMETER:=VALUE; may be repeated")
    parser.add_argument("--words", action="append", default=[], help="PACKAGE/NAME:WORDS of its command line; may be repeated")
    parser.add_argument("--seconds", type=float, default=2.0)
    given = parser.parse_args()
    if VARIABLE not in os.environ:
        raise SystemExit(f"{VARIABLE} names no Python with rclpy")
    total: Counter[tuple[str, str]] = Counter()
    nodes, quality, differing, timers, differing_timers = 0, 0, 0, 0, 0
    for root in given.checkout:
        with tempfile.TemporaryDirectory() as folder:
            known = models(root, Path(folder))
        for program in programs(root):
            if given.node and program[1] not in given.node:
                continue
            title = f"{program[0]}/{program[1]}"
            assigned = [one.partition(":")[2] for one in given.set if one.startswith(f"{title}:")]
            words = [word for one in given.words if one.startswith(f"{title}:") for word in one.partition(":")[2].split()]
            ros = ["--ros-args", *(word for each in assigned for word in ("-p", each))] if assigned else []
            begin = time.monotonic()
            found = compared(root, program, [*words, *ros], given.seconds)
            if isinstance(found, str):
                print(f"{title}: not looked at: {found[:200]}", flush=True)
                continue
            nodes += 1
            outcomes = Counter((element["kind"], element["outcome"]) for element in found["elements"])
            total += outcomes
            count, apart = apart_in_quality(known.get(program[:2], {}), found["qualities"])
            quality, differing = quality + count, differing + len(apart)
            count, otherwise = apart_in_timers(known.get(program[:2], {}), found["timers"], {each.partition(":=")[0] for each in assigned})
            timers, differing_timers = timers + count, differing_timers + len(otherwise)
            confirmed = sum(n for (_, outcome), n in outcomes.items() if outcome == "confirmed")
            print(f"{title}: {confirmed} of {sum(outcomes.values())} [{time.monotonic() - begin:.0f} s]", flush=True)
            for element in found["elements"]:
                if element["outcome"] != "confirmed":
                    print(f"    {element['outcome']} {element['kind']} {element['name']}  {'; '.join(element['reasons'])}")
            wrong = [f"{each['check']} {each['message']}" for each in found["contradictions"]]
            for line in dict.fromkeys((*apart, *otherwise, *wrong)):
                print(f"    {line}")
    print(f"{nodes} nodes")
    for kind in sorted({kind for kind, _ in total}):
        confirmed, filled, missed, unseen = (total[kind, outcome] for outcome in ("confirmed", "filled", "missed", "unseen"))
        seen = confirmed + filled + missed
        print(f"{kind:16} predicted {confirmed + unseen:4}  seen {seen:4}  filled {filled:3}  missed {missed:3}  unseen {unseen:3}")
    print(f"qualities        compared {quality:4}  differing {differing}")
    print(f"timers           compared {timers:4}  differing {differing_timers}")


if __name__ == "__main__":
    main()
