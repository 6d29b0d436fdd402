"""`rosarch experiment`: its tables, what it keeps, and what it refuses."""

from __future__ import annotations

import csv
import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import rosarch.evaluation.experiments.run as evaluation
from rosarch.evaluation.experiments.run import Runner

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[3]
EXPERIMENT = ROOT / "examples/experiments/state_variables.yml"
TRUTH = "component: talker\npackage: talker\nsystem: ws\nports:\n  - {id: p1, kind: publisher, name: chatter, type: std_msgs/String, queue: 10}\n"
HEARD = '/// A port that is listened to. Must.\n.decl heard(topic: symbol)\n.output heard\nheard(T) :- port([_, "publisher", T]).\n'


def table(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture
def plan(tmp_path: Path, workspace: Path) -> Callable[[str], Path]:
    """Writes an experiment beside the workspace `ws`, its truth and rules of one's own."""
    (tmp_path / "truth").mkdir()
    (tmp_path / "truth/talker.yml").write_text(TRUTH)
    (tmp_path / "heard.dl").write_text(HEARD)

    def write(text: str) -> Path:
        (tmp_path / "e.yml").write_text(text)
        return tmp_path / "e.yml"

    return write


def test_the_example(rosarch: Callable, tmp_path: Path) -> None:
    done = rosarch("experiment", EXPERIMENT, "-o", tmp_path, "--most", "1")
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith("Elements of 7 components, with 95 % intervals over components (of findings: over subjects)\n")
    figures = {(row["variant"], row["category"]): row for row in table(tmp_path / "figures.csv")}
    assert len(figures) == 18
    for category in ("ports", "params", "periodic", "reactive", "state variables", "transitions"):
        assert float(figures["default", category]["F1"]) == 1
    states = figures["every assigned variable", "state variables"]
    assert states["truth"] == states["found"] and float(states["recall"]) == 1
    assert int(states["extra"]) == 4 and float(states["precision low"]) < float(states["precision"]) < 1
    elements = table(tmp_path / "differences.csv")
    bearing = next(row for row in elements if row["what"] == "Docking::bearing_")
    assert (bearing["change"], bearing["kind"], bearing["component"], bearing["truth"]) == (
        "gained",
        "state variables",
        "auto_docking/docking",
        "not true",
    )
    assert bearing["at"] == "src/auto_docking/include/auto_docking/docking.h:47"
    assert f"{len(elements) - 2} more in differences.csv" in done.out
    rows = [row for row in table(tmp_path / "rows.csv") if row["second"] == "every assigned variable"]
    assert {row["kind"] for row in rows} == {"state_variable"} and len(rows) == 4
    assert {row["at"] for row in rows} >= {bearing["at"]}
    assert int(figures["rosinfer", "state variables"]["found"]) < int(states["found"])
    assert {row["seconds"] > "0" for row in table(tmp_path / "cost.csv")} == {True}
    tests = {(row["second"], row["category"], row["figure"]): row for row in table(tmp_path / "tests.csv")}
    test = tests["every assigned variable", "state variables", "F1"]
    assert float(test["difference"]) < 0 and float(test["p"]) == 0.25 and float(test["corrected p"]) == 1


def test_every_format(plan: Callable, rosarch: Callable) -> None:
    path = plan("name: tiny\nsubjects: {ws: ws}\ntruth: truth\nvariants: {default: {}, two: {rules: heard.dl}}\n")
    shown = {form: rosarch("experiment", path, "--format", form).out for form in ("text", "markdown", "latex", "csv", "json")}
    assert shown["markdown"].startswith("# tiny\n\n## Elements of ")
    assert "| default | ports |" in shown["markdown"]
    assert shown["latex"].startswith("% needs \\usepackage{booktabs}\n\\begin{table}\n")
    assert shown["latex"].count("\\begin{tabular}") == shown["latex"].count("\\end{tabular}") == shown["markdown"].count("\n## ")
    assert shown["csv"].splitlines()[1].startswith("default,ports,")
    found = json.loads(shown["json"])
    assert set(found) == {"experiment", "made_from", "variants", "figures", "agreement", "tests", "cost", "elements", "rows"}
    names = {
        "rosarch",
        "python",
        "engine",
        "experiment",
        "seed",
        "samples",
        "rules of default",
        "facts of ws",
        "truth of ws",
    }
    assert names <= set(found["made_from"])
    assert rosarch("experiment", path, "--format", "json").out == shown["json"]


def test_an_interrupted_run_goes_on(plan: Callable, rosarch: Callable, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", str(tmp_path / "cache"))
    path = plan("subjects: {ws: ws}\ntruth: truth\nvariants: {one: {}, two: {rules: heard.dl}}\n")
    report = Runner._report_progress

    def stop(runner: Runner, done: int, total: int) -> None:
        report(runner, done, total)
        if done == total:
            raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(Runner, "_report_progress", stop)
        assert rosarch("experiment", path, "-o", tmp_path / "out", "--jobs", "1").code == 130
    assert not (tmp_path / "out").exists()
    assert kept(tmp_path) == 1

    def work(*_arguments: Any) -> bytes:
        raise AssertionError

    done = rosarch("experiment", path, "--format", "csv")
    assert (done.code, kept(tmp_path)) == (0, 2)
    monkeypatch.setattr(evaluation, "_evaluate", work)
    assert rosarch("experiment", path, "--format", "csv").out == done.out
    (tmp_path / "heard.dl").write_text(HEARD + 'heard("x").\n')
    assert "two not analysed" not in rosarch("experiment", path).err
    assert "talker/talker not analysed as two: error (AssertionError: , in " in rosarch("experiment", path, "-v").err


def kept(folder: Path) -> int:
    return len([path for path in (folder / "cache/experiments").glob("*/*")])


def test_facts_options_and_what_is_not_judged(plan: Callable, rosarch: Callable, tmp_path: Path, workspace: Path) -> None:
    assert rosarch("extract", workspace, "-o", tmp_path / "facts").code == 0
    shutil.copytree(workspace, tmp_path / "other")
    path = plan(
        "subjects:\n  ws: facts\n  other: {folder: other, packages: talker}\ntruth: truth\nvariants: {one: {}, two: {rules: heard.dl}}\n"
    )
    found = json.loads(rosarch("experiment", path, "--format", "json").out)
    assert found["figures"][0]["hit"] == 1 and found["cost"][0]["components"] == 2
    rows = [(each["gained"], each["component"], each["kind"], each["text"]) for each in found["rows"]]
    assert rows == [(True, {"subject": name, "title": "talker/talker"}, "heard", "chatter") for name in ("ws", "other")]
    path = plan("subjects: {other: other}\nrelations: port\n")
    assert rosarch("experiment", path).out.startswith("Cost: ")
    assert rosarch("experiment", path, "--format", "csv").out.count("\n") == 1


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("subject: {ws: ws}\n", "1:1: unknown key `subject`, did you mean `subjects`?\n{e}:1:1: an experiment without `subjects`"),
        (
            "subjects: {ws: ws}\nvariants:\n  one: {}\n  two: {rule: heard.dl}\n",
            "4:9: unknown key of a variant `rule`, did you mean `rules`?",
        ),
        ("subjects: {ws: ws}\nvariants: {one: {}}\ncompare: [[one, two]]\n", "3:17: unknown variant `two`, there are one"),
        ("subjects: {ws: ws}\nvariants: {one: {}}\ncompare: [[one]]\n", "3:11: two variants are expected here"),
        ("subjects:\n  ws: ws\n  ws: other\n", "3:3: `ws` stands here for the second time, first in line 2"),
        ("subjects:\n  ws: w\n", "2:7: {tmp}/w: no such folder"),
        ("subjects:\n  ws: {truth: truth}\n", "2:7: a subject without `folder`"),
        ("subjects: {ws: ws}\nseed: many\n", "2:7: a number from 0 to 9223372036854775808 is expected here, not `many`"),
        ("subjects: {ws: ws}\nvariants: {a: {rules: none.dl}}\n", "2:23: {tmp}/none.dl: no such file or folder"),
        ("subjects: {ws: ws}\nvariants: {a: {rules: truth}}\n", "2:23: {tmp}/truth: no file of rules (*.dl) in this folder"),
        (
            "subjects: {ws: ws}\nvariants: {a: {decisions: {state-variabl: rosinfer}}}\n",
            "2:28: unknown decision `state-variabl`, did you mean `state-variable`?",
        ),
        (
            "subjects: {ws: ws}\nvariants: {a: {decisions: {state-variable: rosinfr}}}\n",
            "2:44: unknown variant `rosinfr` of `state-variable`, did you mean `rosinfer`?",
        ),
        ("subjects: {ws: ws}\noptions: {name-edit: 2}\n", "2:11: unknown option `name-edit`, did you mean `name-edits`?"),
        ("subjects: {ws: ws}\noptions: {name-edits: [2, 77]}\n", "2:27: the option `name-edits` is one of 1, 2, 3, 4, not `77`"),
        (
            "subjects: {ws: ws}\nvariants: {a: {options: {name-edits: [1, 2]}}}\n",
            "2:25: `name-edits` of a variant has one value; several go below `options` of the experiment",
        ),
        ("subjects: {ws: ws}\nrelations: [port, prt]\n", "2:19: unknown relation `prt`, did you mean `port`?"),
        ("subjects: {ws: ws\n", "2:1: while parsing a flow mapping expected ',' or '}}', but got '<stream end>'"),
        ("subjects: {}\n", "1:11: no subjects"),
        ("subjects: {ws: {folder: ws, packages: [talker, taker]}}\n", "1:48: no package taker in {tmp}/ws, did you mean `talker`?"),
        ("", "1:1: an experiment without `subjects`"),
    ],
)
def test_wrong_experiments(plan: Callable, rosarch: Callable, tmp_path: Path, text: str, error: str) -> None:
    path = plan(text)
    done = rosarch("experiment", path, "-o", tmp_path / "out")
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: {path}:{error.format(e=path, tmp=tmp_path)}\n")
    assert not (tmp_path / "out").exists()


def test_decisions_and_options(plan: Callable, rosarch: Callable) -> None:
    path = plan(
        "subjects: {ws: ws}\ntruth: truth\nvariants: {one: {}, two: {decisions: {state-variable: rosinfer}}}\n"
        "options: {name-edits: [1, 2]}\ncompare: [[one name-edits=2, two name-edits=1]]\n"
    )
    found = json.loads(rosarch("experiment", path, "--format", "json").out)
    assert list(found["variants"]) == ["one name-edits=1", "one name-edits=2", "two name-edits=1", "two name-edits=2"]
    assert found["variants"]["two name-edits=1"]["variants"]["state-variable"] == "rosinfer"
    assert found["variants"]["two name-edits=1"]["options"]["name-edits"] == "1"
    assert {(test["one"], test["other"]) for test in found["tests"]} == {("one name-edits=2", "two name-edits=1")}


def test_wrong_rules_and_truth(plan: Callable, rosarch: Callable, tmp_path: Path) -> None:
    path = plan("subjects: {ws: ws}\ntruth: truth\nvariants: {one: {}, two: {rules: heard.dl}}\n")
    (tmp_path / "heard.dl").write_text(HEARD.replace("port(", "prt("))
    done = rosarch("experiment", path, "-o", tmp_path / "out")
    assert (done.code, done.err.splitlines()[0]) == (
        2,
        f"rosarch: error: {tmp_path}/heard.dl:4:13: unknown relation `prt`, did you mean `port`?",
    )
    (tmp_path / "heard.dl").write_text(HEARD)
    (tmp_path / "truth/talker.yml").write_text(TRUTH.replace("component: talker", "component: walker"))
    done = rosarch("experiment", path, "-o", tmp_path / "out")
    expected = f"{tmp_path}/truth/talker.yml:1:12: no component talker/walker in {tmp_path}/ws, did you mean `talker`?"
    assert (done.code, done.out, done.err) == (2, "", f"rosarch: error: {expected}\n")
    assert not (tmp_path / "out").exists()


CHECK = """// id: old-position
// title: Position that may be old
// help: A node reads odometry from a queue of several messages.
// impact: medium
// confidence: medium
// description: The oldest message comes first.
// scenario:
// |   nh.subscribe("odom", 50, onOdometry);
// recommendation: Use a queue of one message.
// message: {sub} reads {topic} from a queue of {length} messages
// at: sub

/// `sub` reads odometry on `topic` from a queue of `length` messages, more than one. Must.
.decl old_position(sub: NodePort, topic: symbol, length: number)

old_position(Sub, Topic, Length) :-
    joins_connector("topic", Topic, "sink", Sub), node_port_type(Sub, "nav_msgs/Odometry"),
    Sub = [_, Model, _], interface_port_queue(Model, Length), Length > 1.
"""


def test_findings(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    (tmp_path / "old-position.dl").write_text(CHECK)
    path = tmp_path / "e.yml"
    systems = {
        name: f"{{folder: examples/{name}, findings: examples/{name}/expected/findings.txt}}" for name in ("patrol_robot", "delivery_robot")
    }
    told = "".join(f"  {name}: {value}\n" for name, value in systems.items())
    path.write_text(f"subjects:\n{told}variants: {{default: {{}}, more: {{rules: old-position.dl}}}}\nrelations: []\n")
    done = rosarch("experiment", path, "-o", tmp_path / "out", "--format", "csv")
    assert done.code == 0, done.err
    figures = {row["variant"]: row for row in table(tmp_path / "out/figures.csv") if row["category"] == "findings"}
    assert [figures["default"][name] for name in ("truth", "found", "extra")] == ["15", "15", "0"]
    assert [figures["more"][name] for name in ("truth", "found", "extra")] == ["15", "15", "1"]
    (gained,) = table(tmp_path / "out/differences.csv")
    assert (gained["change"], gained["kind"], gained["subject"], gained["component"], gained["truth"]) == (
        "gained",
        "findings",
        "patrol_robot",
        "",
        "not true",
    )
    assert gained["what"] == "old-position: /patrol reads /odom from a queue of 5 messages"
    assert gained["at"] == "src/patrol_robot/src/patrol.cpp:15"


def test_wrong_findings(plan: Callable, rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "findings.txt").write_text("a.cpp:3: warning: what  [a-check]\n\nnothing\n")
    done = rosarch("experiment", plan("subjects: {ws: {folder: ws, findings: findings.txt}}\n"))
    assert (done.code, done.err) == (2, f"rosarch: error: {tmp_path}/findings.txt:3:1: not of the form `path:line: message  [check]`\n")
    done = rosarch("experiment", plan("subjects: {ws: {folder: ws, findings: none.txt}}\n"))
    assert (done.code, done.err) == (
        2,
        f"rosarch: error: {tmp_path}/e.yml:1:39: {tmp_path}/none.txt: cannot be read (no such file or directory)\n",
    )
    assert rosarch("extract", tmp_path / "ws", "-o", tmp_path / "facts").code == 0
    done = rosarch("experiment", plan("subjects: {ws: facts}\nfindings: true\n"))
    assert (done.code, done.err) == (
        2,
        f"rosarch: error: {tmp_path}/e.yml:1:12: the systems of `ws` cannot be checked: {tmp_path}/facts has facts, not sources\n",
    )
