"""Measure time and memory of `rosarch check`, on workspaces made for it or on given ones.

    benchmarks/check_speed.py [--nodes N]... [--components N] [--bus N] [--runs N]
    benchmarks/check_speed.py SYSTEM_DIR... [--runs N]

A workspace made for it has a package for every ten components, a launch file for every ten nodes, and one that includes all of these, each
in a namespace of its own and with an argument. Nodes have remappings, parameters and YAML files; each reads what the one before it sends,
but for every tenth, which reads what nobody sends. With a bus, so many nodes at a time send to and read from one topic.

Prints a Markdown table. A cold run starts with empty caches, a warm run is the cold one again, in an edited run one launch file sets one
more parameter; of several runs it is the median. Processor time is that of all processes of a run, memory the largest resident set of any
one of them. A workspace that was given is copied, and the copy edited.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

KILOBYTES = 1 if sys.platform != "darwin" else 1024  # the unit of ru_maxrss
GROUP = 10
HEAD = (
    "| workspace | cold | processor | warm | processor | edited | processor | peak memory | found |\n|---|---|---|---|---|---|---|---|---|"
)

CMAKE = """cmake_minimum_required(VERSION 3.0)
project({package})
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)
catkin_package()
{targets}
"""
MANIFEST = """<package format="2">
  <name>{package}</name><version>1.0.0</version><description>Made for a benchmark</description>
  <maintainer email="nobody@example.com">nobody</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend><depend>std_msgs</depend>
</package>
"""
SOURCE = """#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>

class Stage {{
public:
  Stage() : private_("~"), total_(0.0) {{
    private_.param("gain", gain_, 1.0);
    private_.param<std::string>("report", report_, "report_{index}");
    output_ = node_.advertise<std_msgs::Float64>("output", 10);
    state_ = node_.advertise<std_msgs::Float64>(report_, 1, true);
    input_ = node_.subscribe("input", 10, &Stage::onInput, this);
    reset_ = private_.advertiseService("reset", &Stage::onReset, this);
  }}
  void spin() {{
    ros::Rate rate(10);
    while (ros::ok()) {{
      std_msgs::Float64 message;
      message.data = total_;
      state_.publish(message);
      ros::spinOnce();
      rate.sleep();
    }}
  }}
private:
  void onInput(const std_msgs::Float64::ConstPtr& message) {{
    total_ += gain_ * message->data;
    std_msgs::Float64 answer;
    answer.data = total_;
    if (total_ > {index}.0) output_.publish(answer);
  }}
  bool onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {{
    total_ = 0.0;
    response.success = true;
    return true;
  }}
  ros::NodeHandle node_, private_;
  ros::Publisher output_, state_;
  ros::Subscriber input_;
  ros::ServiceServer reset_;
  std::string report_;
  double gain_, total_;
}};

int main(int argc, char** argv) {{
  ros::init(argc, argv, "stage_{index}");
  Stage stage;
  stage.spin();
}}
"""
NODE = """  <node pkg="{package}" type="{type}" name="stage_{index}">
    <remap from="input" to="/{source}"/>
    <remap from="output" to="/{sent}"/>
    <param name="gain" value="{index}.5"/>
    <param name="report" value="report_$(arg suffix)_{index}"/>
  </node>
"""
GROUP_FILE = """<launch>
  <arg name="suffix" default="none"/>
  <rosparam command="load" file="$(find {package})/config/group.yaml"/>
{nodes}</launch>
"""
INCLUDE = """  <group ns="group_{group}">
    <include file="$(find {package})/launch/group_{group}.launch"><arg name="suffix" value="s{group}"/></include>
  </group>
"""


def make_workspace(root: Path, nodes: int, components: int, bus: int = 0) -> None:
    """Write a workspace of so many components, and launch files that start so many nodes of them; `bus` of these share a topic."""
    packages = [f"stages_{number}" for number in range((components + GROUP - 1) // GROUP)]
    for number, package in enumerate(packages):
        _make_package(root / package, range(number * GROUP, min((number + 1) * GROUP, components)))
    includes = []
    for group in range((nodes + GROUP - 1) // GROUP):
        package = packages[group % len(packages)]
        texts = []
        for index in range(group * GROUP, min((group + 1) * GROUP, nodes)):
            component = index % components
            source = f"lost_{index}" if index % GROUP == GROUP // 2 else f"link_{(index - 1) % nodes}"
            read, sent = [f"bus_{index // bus}"] * 2 if bus else (source, f"link_{index}")
            kind = f"stage_{component}"
            texts.append(NODE.format(package=packages[component // GROUP], type=kind, index=index, source=read, sent=sent))
        write(root / package / "launch" / f"group_{group}.launch", GROUP_FILE.format(package=package, nodes="".join(texts)))
        includes.append(INCLUDE.format(package=package, group=group))
    write(root / packages[0] / "launch" / "all.launch", f"<launch>\n{''.join(includes)}</launch>\n")


def _make_package(folder: Path, components: range) -> None:
    targets = [f"add_executable(stage_{i} src/stage_{i}.cpp)\ntarget_link_libraries(stage_{i} ${{catkin_LIBRARIES}})" for i in components]
    write(folder / "package.xml", MANIFEST.format(package=folder.name))
    write(folder / "CMakeLists.txt", CMAKE.format(package=folder.name, targets="\n".join(targets)))
    write(folder / "config" / "group.yaml", f"limits: {{low: {components[0]}, high: {components[-1]}.5}}\nframes: [base, map]\n")
    for index in components:
        write(folder / "src" / f"stage_{index}.cpp", SOURCE.format(index=index))


def write(path: Path, text: str) -> None:
    """Write a file, and the folders that it is in."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


@dataclass(frozen=True)
class Run:
    """What one run cost, and how many findings its report lists."""

    seconds: float
    processor_seconds: float
    mebibytes: float
    summary: str


def measure(folder: Path, cache: Path) -> Run:
    """Check a workspace; stop the benchmark when that ends with anything but clean or findings."""
    command = [sys.executable, "-m", "rosarch.cli", "check", str(folder)]
    environment = {**os.environ, "ROSARCH_CACHE_DIR": str(cache)}
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as log:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.perf_counter()
        process = subprocess.Popen(command, env=environment, stdout=output, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in (0, 1):
            log.seek(0)
            raise SystemExit(f"{' '.join(command)} ended with {process.returncode}:\n{log.read()}")
        output.seek(0)
        found = re.search(r"^(\d+|no) findings?", output.read(), re.MULTILINE)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(seconds, spent, usage.ru_maxrss / KILOBYTES / 1024, found[0] if found else "?")


def edit(folder: Path) -> None:
    """Let the first launch file set one more parameter."""
    path = min(folder.rglob("*.launch"))
    text = path.read_text(encoding="utf-8", errors="surrogateescape")
    path.write_text(re.sub(r"<launch[^>]*>", r'\g<0><param name="/edited" value="1"/>', text, count=1), "utf-8", "surrogateescape")


def row(title: str, folder: Path, runs: int) -> str:
    """The row of a workspace."""
    cold, warm, edited = [], [], []
    for _ in range(runs):
        with tempfile.TemporaryDirectory(prefix="rosarch-check-speed-") as scratch:
            cache, copy = Path(scratch) / "cache", Path(scratch) / "copy" / folder.name
            shutil.copytree(folder, copy, symlinks=True)
            cold.append(measure(copy, cache))
            warm.append(measure(copy, cache))
            edit(copy)
            edited.append(measure(copy, cache))
    summaries = {run.summary for run in (*cold, *warm)}
    if len(summaries) > 1:
        raise SystemExit(f"{title}: runs do not agree: {summaries}")
    cells = [title]
    for kind in (cold, warm, edited):
        times = statistics.median(run.seconds for run in kind), statistics.median(run.processor_seconds for run in kind)
        cells += [f"{value:.2f} s" for value in times]
    cells += [f"{max(run.mebibytes for run in (*cold, *warm, *edited)):.0f} MiB", summaries.pop()]
    return f"| {' | '.join(cells)} |"


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", nargs="*", type=Path)
    parser.add_argument("--nodes", type=int, action="append")
    parser.add_argument("--components", type=int, help="of a workspace that is made; as many as nodes, but at most 100, by default")
    parser.add_argument("--bus", type=int, default=0, metavar="N", help="N nodes at a time share a topic, so that each has N connections")
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    print(HEAD, flush=True)
    for system in options.systems:
        print(row(system.name, system, options.runs), flush=True)
    for nodes in options.nodes or ([] if options.systems else [100, 1000, 10000]):
        components = options.components or min(nodes, 100)
        with tempfile.TemporaryDirectory(prefix="rosarch-check-speed-") as folder:
            make_workspace(Path(folder), nodes, components, options.bus)
            connections = f", {nodes * options.bus} connections" if options.bus else ""
            print(row(f"{nodes} nodes of {components} components{connections}", Path(folder), options.runs), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
