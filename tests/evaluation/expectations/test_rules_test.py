"""`rosarch rules test` on sources that say what is expected of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
NODE = """#include <ros/ros.h>
#include <std_msgs/String.h>
bool g_on = false;
ros::Publisher g_pub;
void onMessage(const std_msgs::String& message)
{
  if (message.data == "on")
    g_on = true;
  g_pub.publish(message);
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::String>("/out", 1, true);
  ros::Subscriber sub = nh.subscribe("/in", 1, onMessage);
  ros::Rate rate(10);
  while (ros::ok())
  {
    if (g_on)
      g_pub.publish(std_msgs::String());
    rate.sleep();
  }
}
"""


@pytest.fixture
def outcome(rosarch: Callable, tmp_path: Path) -> Callable:
    """The lines that are printed of a node with expectations above it, and the exit code."""

    def run(*expectations: str, **options: object) -> tuple[int, list[str]]:
        path = tmp_path / "node.cpp"
        path.write_text("".join(f"// {each}\n" for each in expectations) + NODE)
        more = [word for name, value in options.items() for word in (f"--{name}", value)]
        done = rosarch("rules", "test", path, *more)
        return done.code, (done.out + done.err).replace(f"{tmp_path}/", "").splitlines()

    return run


@pytest.mark.slow
def test_the_examples(rosarch: Callable) -> None:
    done = rosarch("rules", "test", ROOT / "examples/delivery_robot", ROOT / "examples/expectations")
    assert (done.code, "FAILED" in done.out) == (0, False), done.out
    assert done.out.splitlines()[-1] == "29 expectations in 5 files, 0 not met"


def test_met(outcome: Callable) -> None:
    assert outcome("expect: publisher /out latched", "expect-not: publisher out", "expect: reactive /in -> /out must") == (
        0,
        ["ok       node.cpp: 3 expectations", "3 expectations in 1 file, 0 not met"],
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("expectation", "instead"),
    [
        ("expect: publisher /cmd std_msgs/String", ["nearest   publisher /out std_msgs/String  node.cpp:16 (other name)"]),
        ("expect: publisher /out std_msgs/Bool queue=5", ["nearest   publisher /out std_msgs/String  node.cpp:16 (queue is 1, other type)"]),
        ("expect: service_server reset", ["there is no service_server"]),
        ("expect: reactive /in -> /out may", ["nearest   reactive /in -> /out  node.cpp:10 (must is true)"]),
        ("expect: periodic /out 5 Hz", ["nearest   periodic /out 10.0  node.cpp:23 (other hz)"]),
        ('expect: transition g_on = true if "message.data == \\"off\\""', ['nearest   transition ::g_on = true  node.cpp:9 (guard is message.data == "on")']),
        ("expect: state g_on = true", ["nearest   state ::g_on = false  node.cpp:4 (other initial)"]),
        ("expect: finding topic-type-mismatch", ["nearest   finding subscriber-without-publisher /node reads /in (std_msgs/String), and no publisher of it was seen  node.cpp:17 (other check and line)"]),
        ("expect-not: publisher /*", ["there is  publisher /out std_msgs/String  node.cpp:16"]),
        ('expect: port([_, "subscriber", "/inn"])', ['nearest   port(["node.cpp#6898:17:25:call", "subscriber", "/in"])']),
        ('expect: port([_, "subscriber", X]), X != "/in"', ["no such row"]),
        ('expect-not: port([_, "subscriber", X])', ["there is  X = /in"]),
        ('expect-not: !port_type(_, "x")', ["there is  it holds"]),
        ("expect-only: publisher", ["there is  publisher /out std_msgs/String  node.cpp:16"]),
    ],
)  # fmt: skip
def test_unmet(outcome: Callable, expectation: str, instead: list[str]) -> None:
    code, lines = outcome(expectation)
    word, _, text = expectation.partition(": ")
    told = {"expect": "expected", "expect-not": "not expected", "expect-only": "nothing else expected"}[word]
    here = " here" if "finding" in text else ""
    assert code == 1
    assert lines[:2] == [
        "FAILED   node.cpp: 1 of 1 expectation",
        f"  node.cpp:1:4: {told}{here}: {text}",
    ]
    assert lines[2:-1] == [f"    {each}" for each in instead]
    assert lines[-1] == "1 expectation in 1 file, 1 not met"


def test_nothing_else(outcome: Callable) -> None:
    ports = ("expect: publisher /out latched", "expect: subscriber /in", "expect-only: publisher", "expect-only: subscriber /i*")
    assert outcome(*ports) == (0, ["ok       node.cpp: 4 expectations", "4 expectations in 1 file, 0 not met"])
    assert outcome(*ports, "expect-not: publisher /other", "expect-only: *") == (
        1,
        [
            "FAILED   node.cpp: 1 of 6 expectations",
            "  node.cpp:6:4: nothing else expected: *",
            "    there is  periodic /out 10.0  node.cpp:28",
            "    there is  reactive /in -> /out  node.cpp:15",
            "    there is  state ::g_on = false  node.cpp:9",
            "    there is  transition ::g_on = true  node.cpp:14",
            "6 expectations in 1 file, 1 not met",
        ],
    )


def test_beside_code_it_is_about_that_line(rosarch: Callable, tmp_path: Path) -> None:
    path = tmp_path / "node.cpp"
    path.write_text(NODE.replace("onMessage);", "onMessage);  // expect: publisher /out"))
    done = rosarch("rules", "test", path)
    assert done.code == 1
    assert done.out.splitlines()[1:3] == [
        f"  {path}:16:64: expected here: publisher /out",
        "    nearest   publisher /out std_msgs/String  node.cpp:15 (other line)",
    ]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lines", "query", "unmet"),
    [
        ((9, 21), "sends(C, _)", []),
        ((9,), "sends(C, _)", ["9:31: expected here only: sends(C, _)", "there is  C = node.cpp#6898:21:7:call  node.cpp:21"]),
        ((8,), "sends(C, _), operator(C, _)", ["8:22: expected here only: sends(C, _), operator(C, _)", "no such row"]),
    ],
)
def test_rows_that_are_here_only(rosarch: Callable, tmp_path: Path, lines: tuple[int, ...], query: str, unmet: list[str]) -> None:
    path = tmp_path / "node.cpp"
    text = [f"{line}  // expect-only: {query}" if number in lines else line for number, line in enumerate(NODE.splitlines(), 1)]
    path.write_text("\n".join(text) + "\n")
    done = rosarch("rules", "test", path)
    assert [line.strip().removeprefix(f"{path}:") for line in done.out.splitlines()[1:-1]] == unmet


@pytest.mark.parametrize(
    ("expectation", "error"),
    [
        ("expect: publishr /out", "1:12: unknown kind of element `publishr`, did you mean `publisher`?"),
        ("expect: prt(_)", "1:12: unknown relation `prt`, did you mean `port`?"),
        ("expect: port([_, _)", "1:22: syntax error, unexpected `)`, expected `]`"),
        ("expect: finding topic-typ-mismatch", "1:20: unknown check `topic-typ-mismatch`, did you mean `topic-type-mismatch`?"),
    ],
)
def test_refused(outcome: Callable, expectation: str, error: str) -> None:
    code, lines = outcome(expectation, "expect: publisher /out")
    assert (code, lines) == (2, [f"rosarch: error: node.cpp:{error}"])


@pytest.mark.slow
def test_rules_of_ones_own(outcome: Callable, tmp_path: Path) -> None:
    (tmp_path / "own.dl").write_text('/// x. May.\n.decl echo(name: symbol)\necho(N) :- port([_, "publisher", N]).\n')
    assert outcome('expect: echo("/out")', rules=tmp_path / "own.dl")[0] == 0
    assert outcome('expect: echo("/out")')[1] == ["rosarch: error: node.cpp:1:12: unknown relation `echo`"]
    assert outcome("expect-not: state g_on", variant="state-variable=rosinfer")[0] == 1


@pytest.mark.slow
def test_a_workspace(rosarch: Callable, workspace: Path) -> None:
    source = workspace / "talker/talker.cpp"
    source.write_text(source.read_text().replace(", 10);", ", 10);  // expect: publisher chatter std_msgs/String"))
    (workspace / "talker/talker.launch").write_text(
        '<launch>\n  <!-- expect: finding missing-executable -->\n  <node pkg="talker" type="taker" name="a"/>\n'
        '  <!-- expect: started_name("/b", Name, _), Name = "/b" -->\n'
        '  <!-- expect: publisher chatter -->\n  <node pkg="talker" type="talker" name="b"/>\n</launch>\n'
    )
    done = rosarch("rules", "test", workspace.parent)
    assert done.code == 0, done.out + done.err
    assert done.out.splitlines() == [
        f"ok       {workspace}/talker/talker.cpp: 1 expectation",
        f"ok       {workspace}/talker/talker.launch: 3 expectations",
        "4 expectations in 2 files, 0 not met",
    ]
    (workspace / "talker/talker.launch").write_text(
        '<launch>\n  <!-- expect: port(_) -->\n  <node pkg="talker" type="talker" name="b"/>\n</launch>\n'
    )
    done = rosarch("rules", "test", workspace)
    assert (done.code, done.err) == (
        2,
        f"rosarch: error: {workspace}/talker/talker.launch:2:16: unknown relation `port`\n",
    )


def test_a_file_that_is_no_source(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "a.launch").write_text("<launch/> <!-- expect: finding launch-error -->\n")
    done = rosarch("rules", "test", tmp_path / "a.launch")
    told = f"{tmp_path}/a.launch: not a C++ or Python source; other files are tested with the workspace that they are in"
    assert (done.code, done.err) == (2, f"rosarch: error: {told}\n")


def test_no_tests(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    done = rosarch("rules", "test", workspace)
    told = "a test is a source with comments `expect: ...`, or a folder with facts/*.facts and expected/*.csv"
    assert (done.code, done.err) == (2, f"rosarch: error: {workspace}: no tests; {told}\n")
    done = rosarch("rules", "test", tmp_path / "none.cpp")
    assert (done.code, done.err) == (2, f"rosarch: error: {tmp_path}/none.cpp: cannot be read (no such file or directory)\n")
