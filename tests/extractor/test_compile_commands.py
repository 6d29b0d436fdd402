"""`compile_commands.json` and installed headers: used when there, with the same model as without."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.extractor.workspace.compile_commands import read_compile_commands

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def documents(folder: Path) -> dict[str, object]:
    return {path.relative_to(folder).as_posix(): json.loads(path.read_text()) for path in sorted(folder.glob("*/*.json"))}


def write(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def command(directory: Path, source: Path, *words: str, output: str = "") -> dict[str, object]:
    entry: dict[str, object] = {"directory": str(directory), "file": str(source), "arguments": ["c++", *words, "-c", str(source)]}
    return {**entry, "output": output} if output else entry


@pytest.mark.slow
@pytest.mark.parametrize("name", ["services_and_actions", "mobile_base"])
def test_a_built_workspace_has_the_same_models(name: str, rosarch: Callable, tmp_path: Path) -> None:
    root = tmp_path / name
    shutil.copytree(EXAMPLES / name, root)
    # an installation whose headers are of no use to anybody but must not be preferred
    ros = write(tmp_path / "opt/ros/include/ros/ros.h", "#error\n").parent.parent
    write(root / "devel/include/std_msgs/String.h", "#error\n")
    for package in root.glob("src/*"):
        entries = [
            command(root / "build", source, f"-I{package}/include", f"-I{root}/devel/include", "-isystem", str(ros), "-DNDEBUG", "-O2")
            for source in sorted(package.glob("src/*.cpp"))
        ]
        write(root / "build" / package.name / "compile_commands.json", json.dumps(entries))
    outcome = rosarch("analyze", root, "-o", tmp_path / "models")
    assert (outcome.code, outcome.err) == (0, "")
    assert rosarch("analyze", EXAMPLES / name, "-o", tmp_path / "plain").code == 0
    assert documents(tmp_path / "models") == documents(tmp_path / "plain") != {}


NODE = """#include <ros/ros.h>
#include <std_msgs/String.h>
#include <vendor/board.h>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::String>(BOARD_TOPIC, vendor::QUEUE);
#ifdef WITH_DEBUG
  ros::Publisher debug = nh.advertise<std_msgs::String>("debug", 1);
#endif
}
"""


def ports(rosarch: Callable, root: Path) -> set[tuple[str, int | None]]:
    (model,) = json.loads(rosarch("analyze", root, "--format", "json").out)
    return {(port["name"], port["queue"]) for port in model["ports"]}


@pytest.mark.slow
def test_installed_headers_of_others_are_read(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    source = write(workspace / "talker/talker.cpp", NODE)
    header = write(tmp_path / "vendor_prefix/vendor/board.h", '#define BOARD_TOPIC "board"\nnamespace vendor { enum { QUEUE = 3 }; }\n')
    assert ("board", None) not in ports(rosarch, workspace)
    folder = str(header.parent.parent)
    write(workspace / "build/compile_commands.json", json.dumps([command(workspace, source, "-isystem", folder, "-DWITH_DEBUG=1")]))
    names = {name for name, _queue in ports(rosarch, workspace)}
    assert names == {"board", "debug"}


def test_the_command_of_the_target_counts(tmp_path: Path) -> None:
    source = write(tmp_path / "a.cpp", "")
    entries = [
        command(tmp_path, source, "-DA", output="CMakeFiles/one.dir/a.cpp.o"),
        command(tmp_path, source, "-DB", "-o", "p/CMakeFiles/two.dir/a.cpp.o"),
    ]
    write(tmp_path / "compile_commands.json", json.dumps(entries))
    found = read_compile_commands(tmp_path)
    assert [found.find(source, name).definitions for name in ("one", "two", "three")] == [("A",), ("B",), ("A",)]  # type: ignore[union-attr]


def test_shell_commands_and_flags(tmp_path: Path) -> None:
    source = write(tmp_path / "a.cpp", "")
    (tmp_path / "include").mkdir()
    text = r"g++ -DNAME=\"x\" -D A=1 -DGONE -UGONE -I include -Imissing -o a.o -c a.cpp"
    write(tmp_path / "compile_commands.json", json.dumps([{"directory": str(tmp_path), "file": "a.cpp", "command": text}]))
    found = read_compile_commands(tmp_path).find(source, "a")
    assert found is not None
    assert (found.definitions, found.include_dirs, found.output) == (('NAME="x"', "A=1"), (tmp_path / "include",), "a.o")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[{]", "not read: Expecting property name enclosed in double quotes"),
        ("{}", "not read: not a list of commands"),
        ('[{"file": 3}]', "entry 1 names no file and command"),
        ('[{"file": "a.cpp", "directory": ".", "command": "\'"}]', "entry 1 names no file and command"),
    ],
)
def test_a_broken_file_costs_that_file(text: str, message: str, tmp_path: Path) -> None:
    path = write(tmp_path / "build/compile_commands.json", text)
    found = read_compile_commands(tmp_path)
    assert not found.by_source
    (problem,) = found.diagnostics
    assert str(problem).startswith(f"{path}:1:")
    assert problem.message == message
