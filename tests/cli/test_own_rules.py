"""Rules of one's own in a folder, variants, options, hints, and what `rosarch new` makes."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosarch.cli.command_table import load_command
from rosarch.rule_programs.own_files import own_programs

pytestmark = pytest.mark.slow

Run = Callable[..., Any]
LOUD = """// id: loud
// title: t
// help: h
// impact: low
// confidence: high
// description: d
// scenario: s
// recommendation: r
// message: {pub} sends {topic}
// at: pub

/// `pub` sends on `topic`. Must.
.decl loud(pub: NodePort, topic: symbol)
loud(Pub, Topic) :- joins_connector("topic", Topic, "source", Pub).
"""
NODE = """#include <ros/ros.h>
#include <std_msgs/String.h>

std::string topic();
double rate();

int main(int argc, char** argv)
{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::String>(topic(), 10);
  ros::Rate wait(rate());
  while (ros::ok()) {
    pub.publish(std_msgs::String());
    wait.sleep();
  }
}
"""


def write(folder: Path, **texts: str) -> Path:
    for name, text in texts.items():
        path = folder / f"{name.replace('__', '/')}.dl"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


@pytest.mark.slow
def test_a_folder_has_rules_of_components_and_of_systems(rosarch: Run, examples: Path, tmp_path: Path) -> None:
    rules = write(
        tmp_path / "my_rules",
        sent='/// `topic` is sent. May.\n.decl sent(topic: symbol)\nsent(Topic) :- port([_, "publisher", Topic]).\n',
        more__twice=".decl twice(topic: symbol)\ntwice(Topic) :- sent(Topic).\n",
        checks__loud=LOUD,
        tests__case="this is no rule",
    )
    done = rosarch("query", examples / "mobile_base", "twice(T)", "--rules", rules, "-c", "odometry_node")
    assert (done.code, done.out, done.err) == (0, "T\n----------------\nodom\n~odometry_status\n2 rows\n", "")
    found = json.loads(rosarch("check", examples / "patrol_robot", "--rules", rules, "--format", "json", "--exit-zero").out)
    assert "loud" in {finding["check"] for finding in found["findings"]}
    assert [Path(each["file"]).name for each in found["rules"]["own"]] == ["loud.dl", "twice.dl", "sent.dl"]
    assert found["rules"]["variants"]["state-variable"] == "data-flow"
    assert "rules" not in json.loads(rosarch("check", examples / "patrol_robot", "--format", "json", "--exit-zero").out)


def test_files_go_to_the_program_whose_relations_they_use(tmp_path: Path) -> None:
    write(
        tmp_path,
        a=".decl a(x: symbol)\na(X) :- node_port_type(_, X).\n",
        b=".decl b(x: symbol)\nb(X) :- a(X).\n",
        c='.decl c(x: symbol)\nc(X) :- port([_, "joins_connector(", X]). // joins_connector(\n',
        d='option_meaning("mine", "text").\n',
    )
    programs = own_programs(sorted(tmp_path.glob("*.dl")))
    names = {program: "".join(path.stem for path in files) for program, files in programs.items()}
    assert names == {"component": "cd", "system": "abd"}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("texts", "error"),
    [
        ({"a": ".decl a(x: symbol)\na(X) :- prt(X).\n"}, "a.dl:2:9: unknown relation `prt`, did you mean `port`?\n    a(X) :- prt(X).\n            ^"),
        (
            {"a": ".decl a(x: symbol)\na(X) :- started(X, _, _), reacts(_, _, X).\n"},
            "a.dl:2:9: `started` is a relation of systems, `reacts` one of components; a file can use either",
        ),
        ({"loud": LOUD.replace("// at: pub\n", "")}, "loud.dl:1:1: the check has no field `at`"),
        ({"loud": LOUD, "more__loud": LOUD}, "more/loud.dl:1:1: there is a check `loud` already, in {folder}/loud.dl"),
        ({"a": 'port("x"'}, "a.dl:1:9: syntax error, unexpected end of file\n    port(\"x\"\n            ^"),
        ({"variants__stat-variable__mine": ""}, "variants/stat-variable: there is no decision `stat-variable`, did you mean `state-variable`?"),
        ({}, ": no file of rules (*.dl) in this folder"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_before_anything_is_done(
    rosarch: Run, workspace: Path, tmp_path: Path, texts: dict[str, str], error: str
) -> None:
    folder = tmp_path / "own"
    folder.mkdir()
    write(folder, **texts)
    done = rosarch("analyze", workspace, "--rules", folder, "--out", tmp_path / "out")
    separator = "" if error.startswith(":") else "/"
    assert (done.code, done.out) == (2, "")
    assert done.err == f"rosarch: error: {folder}{separator}{error.format(folder=folder)}\n"


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("--variant", "state-variable=rosinfr"), "state-variable has no variant `rosinfr`, did you mean `rosinfer`?"),
        (("--variant", "state-variable=xyz"), "state-variable has no variant `xyz`, there are data-flow, enumerated, rosinfer"),
        (
            ("--variant", "states=rosinfer"),
            "there is no decision `states`, there are context-depth, member-alias, name-matching, publish-guard, state-variable",
        ),
        (("--variant", "rosinfer"), "--variant rosinfer: not of the form NAME=VALUE"),
        (("--option", "name-edit=2"), "there is no option `name-edit`, did you mean `name-edits`?"),
        (("--option", "name-edits=9"), "the option `name-edits` is one of 1, 2, 3, 4, not `9`"),
        (("--rules", "gone.dl"), "gone.dl: no such file or folder"),
    ],
)
def test_variants_and_options_that_do_not_exist(rosarch: Run, workspace: Path, arguments: tuple[str, str], error: str) -> None:
    done = rosarch("query", workspace, "port(_)", *arguments)
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: {error}\n")


@pytest.mark.parametrize("command", [("rules", "list"), ("rules", "checks"), ("rules", "doc"), ("rules", "mutate")], ids=" ".join)
def test_commands_about_rules_take_variants(rosarch: Run, command: tuple[str, ...], tmp_path: Path) -> None:
    done = rosarch(*command, "--variant", "state-variable=rosinfr")
    assert (done.code, done.out, done.err) == (2, "", "rosarch: error: state-variable has no variant `rosinfr`, did you mean `rosinfer`?\n")


@pytest.mark.slow
def test_the_relations_are_those_of_the_variant(rosarch: Run) -> None:
    wanted = ("rules", "list", "_entered_by", "--private")
    assert rosarch(*wanted).err.startswith("rosarch: error: no relation _entered_by")
    assert "rules/variants/context-depth/two-calls.dl:" in rosarch(*wanted, "--variant", "context-depth=two-calls").out


def test_a_relation_is_overridden_and_told(rosarch: Run, examples: Path, tmp_path: Path) -> None:
    rules = write(tmp_path / "r", all='.pragma "override" "state_variable"\nstate_variable(V) :- changes(_, _, V).\n')
    done = rosarch("query", examples / "docking_states", "state_variable(V)", "--rules", rules, "-c", "docking")
    assert done.out.splitlines()[2:] == ["auto_docking::Docking::bearing_", "auto_docking::Docking::state_", "2 rows"]
    assert done.err == (
        f"rosarch: {rules}/all.dl:1:9: `state_variable` is overridden: 4 clauses of rules/variants/state-variable/data-flow.dl dropped\n"
    )
    done = rosarch("analyze", examples / "docking_states", "--rules", rules, "--out", tmp_path / "out")
    told = json.loads((tmp_path / "out" / "rules.json").read_text(encoding="utf-8"))
    assert (done.code, told["overridden"], told["options"]["name-edits"]) == (0, ["state_variable"], "2")
    explained = rosarch("explain", examples / "docking_states", "state_variable(_)", "--rules", rules, "-c", "docking", "--depth", "1")
    assert explained.out.splitlines()[0].endswith("all.dl:2")


def test_a_variant_of_ones_own(rosarch: Run, examples: Path, tmp_path: Path) -> None:
    rules = write(tmp_path / "r", **{"variants__state-variable__nothing": "// Nothing is state.\n"})
    listed = rosarch("options", "--rules", rules).out
    assert re.search(r"^  nothing  .*\n +Nothing is state\.$", listed, re.MULTILINE)
    chosen = ("--rules", rules, "--variant", "state-variable=nothing")
    assert rosarch("query", examples / "docking_states", "state_variable(V)", *chosen).out == "no rows in any component\n"


def test_models_of_another_variant_are_not_taken_from_the_cache(rosarch: Run, examples: Path) -> None:
    def states(*arguments: str) -> int:
        models = json.loads(rosarch("analyze", examples / "docking_states", "--format", "json", *arguments).out)
        return sum(len(model["state_variables"]) for model in models)

    assert (states(), states("--variant", "state-variable=rosinfer"), states()) == (4, 3, 4)


def test_what_is_shown_is_by_the_chosen_variant(rosarch: Run, examples: Path) -> None:
    shown = rosarch("show", "behavior", examples / "docking_states", "dock_lamp", "--variant", "state-variable=rosinfer").out
    assert "::g_alarm" in shown
    assert "::g_lit   " not in shown


def test_options_as_json(rosarch: Run) -> None:
    data = json.loads(rosarch("options", "--json").out)
    assert {each["name"]: each["default"] for each in data["decisions"]} == {
        "context-depth": "call",
        "member-alias": "variable",
        "name-matching": "spelling",
        "publish-guard": "control-dependence",
        "state-variable": "data-flow",
    }
    assert data["options"][0] == {
        "name": "name-edits",
        "doc": "by how many letters names differ at most that the variant `edits` of name-matching takes for one",
        "default": "2",
        "allowed": ["1", "2", "3", "4"],
    }


def test_an_option_of_ones_own(rosarch: Run, workspace: Path, tmp_path: Path) -> None:
    rules = write(
        tmp_path / "r",
        mine='option_meaning("loudness", "how loud"). option_default("loudness", "low"). option_allowed("loudness", "low"). option_allowed("loudness", "high").\n',
    )
    done = rosarch("query", workspace, 'option("loudness", Value)', "--rules", rules, "--option", "loudness=high")
    assert done.out == "Value\n-----\nhigh\n1 row\n"


def test_hints_settle_what_the_source_does_not_tell(rosarch: Run, workspace: Path, tmp_path: Path) -> None:
    (workspace / "talker" / "talker.cpp").write_text(NODE, encoding="utf-8")
    path = "talker/talker.cpp"
    rules = write(
        tmp_path / "r",
        hints=f'hint_value("{path}", 11, "name", "greetings"). hint_rate("{path}", 15, "25"). hint_type("{path}", 11, "std_msgs/Header").\n',
        stale=f'hint_value("{path}", 3, "name", "nowhere").\n',
    )
    (before,) = json.loads(rosarch("analyze", workspace, "--format", "json").out)
    (after,) = json.loads(rosarch("analyze", workspace, "--format", "json", "--rules", rules).out)
    assert [(port["name"], port["type"]) for port in before["ports"]] == [("?", "std_msgs/String")]
    assert [(port["name"], port["type"]) for port in after["ports"]] == [("greetings", "std_msgs/Header")]
    assert ([each["hz"] for each in before["periodic"]], [each["hz"] for each in after["periodic"]]) == ([None], [25.0])
    unused = rosarch("query", workspace, "hint_unused(File, Line)", "--rules", rules)
    assert unused.out.splitlines()[2:] == [f"{path}  3", "1 row"]


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (("check", "Foo"), "`Foo` is no name for a check: small letters and digits with dashes between: `queue-too-short`"),
        (("relation", "a-b"), "`a-b` is no name for a relation: small letters and digits with underscores between: `answers_late`"),
        (("relation", "count"), "`count` is a word of the language of rules and no name for a relation"),
        (("api", "1st"), "`1st` is no name for an api: a C++ namespace in small letters: `my_library`"),
    ],
)
def test_new_refuses_names(rosarch: Run, tmp_path: Path, arguments: tuple[str, str], error: str) -> None:
    done = rosarch("new", *arguments, "--into", tmp_path / "r")
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: {error}\n")
    assert not (tmp_path / "r").exists()


def test_new_refuses_what_is_there(rosarch: Run, tmp_path: Path) -> None:
    assert "there is a check `topic-type-mismatch` already, in " in rosarch("new", "check", "topic-type-mismatch", "--into", tmp_path).err
    assert "there is a relation `port` already, declared at " in rosarch("new", "relation", "port", "--into", tmp_path).err
    assert "the API of `roscpp` is known already, in " in rosarch("new", "api", "roscpp", "--into", tmp_path).err
    assert rosarch("new", "relation", "mine", "--into", tmp_path).code == 0
    again = rosarch("new", "relation", "mine", "--into", tmp_path)
    assert (again.code, again.err) == (2, f"rosarch: error: {tmp_path}/mine.dl: there is such a file already\n")


def test_what_is_new_passes_its_tests(rosarch: Run, tmp_path: Path) -> None:
    rules = tmp_path / "r"
    made = [
        rosarch("new", kind, name, "--into", rules).out
        for kind, name in (("check", "long-queue"), ("relation", "sent_only"), ("api", "my_lib"))
    ]
    assert [text.splitlines()[:-2] for text in made] == [
        [f"{rules}/{file}" for file in files]
        for files in (
            ["checks/long-queue.dl", "tests/long_queue.cpp", "docs/long-queue.md"],
            ["sent_only.dl", "docs/sent_only.md", "tests/sent_only.cpp"],
            ["api/my_lib.dl", "docs/my_lib.md", "tests/my_lib.cpp"],
        )
    ]
    done = rosarch("rules", "test", rules, "--rules", rules)
    assert (done.code, done.out.splitlines()[-1]) == (0, "7 expectations in 3 files, 0 not met")
    # without the rules they test, they fail
    assert rosarch("rules", "test", rules / "tests" / "my_lib.cpp").code == 1
    assert rosarch("rules", "checks", "long-queue", "--rules", rules).code == 0
    lint = rosarch("rules", "lint", rules)
    assert (lint.code, lint.out) == (0, "")


TOPICS_ALONE = """.pragma "override" "joins_connector"
joins_connector("topic", Name, Side, Port) :- node_port(Port, Kind), port_side(Kind, "topic", Side), port_name(Port, Name).
"""


def test_reports_on_systems_take_other_rules(rosarch: Run, examples: Path, tmp_path: Path) -> None:
    rules = write(tmp_path / "r", all=TOPICS_ALONE)
    kinds = []
    for more in ((), ("--rules", rules)):
        done = rosarch("show", "graph", examples / "delivery_robot", "--format", "json", *more)
        kinds.append({connector["kind"] for graph in json.loads(done.out) for connector in graph["connectors"]})
    assert kinds == [{"topic", "service"}, {"topic"}]
    assert done.err.endswith("`joins_connector` is overridden: 1 clause of rules/system/connections.dl dropped\n")


@pytest.mark.parametrize(
    "command", ["analyze", "check", "diff", "doctor", "score", "query", "explain", "why-not", "watch", "browse", "ask", "verify", "simulate",
    "report", "serve", "observe", "compare", "probe",
    "show ports", "show behavior", "show machine", "show graph", "show includes", "export acme", "rules run", "rules test"],
)  # fmt: skip
def test_whatever_derives_takes_rules_variants_and_options(command: str) -> None:
    name, *rest = command.split()
    found = load_command(name)
    for part in rest:
        found = found.commands[part]
    assert {"own", "variants", "settings"} <= {parameter.name for parameter in found.params}
