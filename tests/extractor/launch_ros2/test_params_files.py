"""What nodes refuse of files of parameters: the lines that rcl of ROS 2 Kilted refused, and files that it took."""

from pathlib import Path

import pytest
from ros2_launch_builder import composed, described, params, problems

from rosarch.extractor.launch_ros2.params_files import refused

REFUSED = {
    "- n\n": (1, "it is a list"),
    "/a:\n  /n:\n    ros__parameters:\n      p: 1\n": (2, "`/a//n` is no name of nodes"),
    "/n*:\n  ros__parameters:\n    p: 1\n": (1, "`/n*` is no name of nodes"),
    "'':\n  n: {}\n": (1, "a name of a node is empty"),
    "n:\n  ros__parameters:\n    '': 1\n": (3, "the name of a parameter is empty"),
    "n:\n  ros__parameters:\n    a:\n      b: {}\n    c: 1\n": (5, "`c` follows an empty map"),
    "n:\n  ros__parameters:\n  - 1\n": (2, "`ros__parameters` is no map"),
    "n:\n  p: 1\n": (2, "the value of `p` stands before `ros__parameters`"),
    "n:\n  ros_parameters:\n    p: 1\n": (2, "`ros_parameters` is written for `ros__parameters`"),
    "n:\n": (1, "the value of `n` stands before `ros__parameters`"),
    "n:\n  ros__parameters:\n    p: 1\n  q: 2\n": (4, "the value of `q` stands before `ros__parameters`"),
    "n:\n  [1, 2]\n": (1, "the value of `n` stands before `ros__parameters`"),
    "n:\n  ros__parameters:\n": (2, "`ros__parameters` is no map"),
    "ros__parameters:\n  p: 1\n": (1, "no name of a node stands before `ros__parameters`"),
    "n:\n  ros__parameters:\n    p:\n": (3, "the parameter `p` has no value"),
    "n:\n  ros__parameters:\n    p: [1, 2.0]\n": (3, "the elements of `p` are of several types: integers and doubles"),
    'n:\n  ros__parameters:\n    p: [1, "x"]\n': (3, "the elements of `p` are of several types: integers and texts"),
    "n:\n  ros__parameters:\n    p: [[1], [2]]\n": (3, "the parameter `p` is a list of lists"),
    "n:\n  ros__parameters:\n    p:\n    - a: 1\n      b: x\n": (4, "the parameter `p` is a list of maps"),
    "n:\n  ros__parameters:\n    p: &x 1\n    q: *x\n": (4, "rcl reads no aliases: `*x`"),
    "a: &x\n  ros__parameters:\n    p: 1\nn:\n  <<: *x\n": (5, "rcl reads no aliases: `*x`"),
}
TAKEN = (
    "# nothing\n",
    "n:\n  ros__parameters:\n    p: ''\n    q: ~\n    r: [1, -2, 0x3]\n    s: [1.0, .5, 1e3]\n    t: [yes, off]\n    u: &x [a, '1']\n",
    "n:\n  ros__parameters:\n    - p: 1\n",
    "n:\n  ros__parameters:\n    p:\n    - {a: x, b: z, c: [1]}\n",
    "n:\n  ros__parameters:\n    p: [1.0, inf, -Infinity, nan, 0x1.8p3, -.inf]\n    q: [!!str 1, a]\n",
    "/**/n:\n  ros__parameters:\n    a.b: {c: 1}\nm: {}\n",
    "n:\n  ros__parameters:\n    p: [[-2.4, 2.4]]\n    q: [[]]\n    r: [[[1]]]\n    s: [1, [2, 3]]\n",
)


@pytest.mark.parametrize("text", REFUSED, ids=str)
def test_refused(text: str) -> None:
    line, message = REFUSED[text]
    found = refused(text)
    assert found is not None
    assert (found.message, found.line) == (message, line)
    assert found.meant == (("ros_parameters", "ros__parameters") if "is written for" in message else None)


@pytest.mark.parametrize("text", TAKEN, ids=str)
def test_taken(text: str) -> None:
    assert refused(text) is None


def test_a_list_that_ends_with_a_list_is_that_one(tmp_path: Path) -> None:
    """As rclpy has it from the real rcl."""
    written = "n:\n  ros__parameters:\n    p: [[-2.4, 2.4]]\n    q: [[[1]]]\n    r: [1, [2, 3]]\n"
    launch = '<node pkg="here" exec="run" name="n" args="--ros-args -p s:=[[2,3]]"><param from="$(dirname)/p.yaml"/></node>'
    found = composed(tmp_path, {"main.launch.xml": f"<launch>{launch}</launch>", "p.yaml": written})
    assert params(found) == {"/n/p": [-2.4, 2.4], "/n/q": [1], "/n/r": [2, 3], "/n/s": [2, 3]}
    assert not found.problems


def told(folder: Path, launch: str, written: str) -> list[str]:
    files = {"main.launch.xml": f'<launch><node pkg="here" exec="run" name="n">{launch}</node></launch>', "p.yaml": written}
    return problems(composed(folder, files, environment={"HOME": "/home"}), folder)


def test_what_nodes_and_launch_do_not_make_of_a_file(tmp_path: Path) -> None:
    empty = "n:\n  ros__parameters:\n    p: []\n"
    found = told(tmp_path / "a", '<param from="$(dirname)/p.yaml"/>', empty)
    assert found == ["p.yaml:3:1: the list `p` is empty: rclcpp finds no type for it"]
    open_ = "n:\n  ros__parameters:\n    p: $(env HOME)/map\n"
    literal = "p.yaml:3:1: `$(env HOME)` is taken as it is written: no `allow_substs` is given with the file"
    assert told(tmp_path / "b", '<param from="$(dirname)/p.yaml"/>', open_) == [literal]
    assert told(tmp_path / "c", '<param from="$(dirname)/p.yaml" allow_substs="true"/>', open_) == []
    assert told(tmp_path / "d", '<param from="$(dirname)/p.yaml"/>', empty.replace("n:", "other:", 1)) == []


def test_a_path_of_pathlib_names_a_file_for_a_node_without_a_name(tmp_path: Path) -> None:
    (tmp_path / "n.yaml").write_text("n:\n  ros__parameters:\n    p: 1\n")
    found = described(tmp_path, f"Node(package='here', executable='run', parameters=[Path('{tmp_path}') / 'n.yaml'])")
    assert not found.problems
    assert params(found) == {"/n/p": 1}
