"""`rosarch score`, and its agreement with the program that scores the ground truth, `score.py`.

`scored/table.txt` is what that program prints of `scored/`. With its path in ROSARCH_SCORER it is run on models that were changed at random.
"""

from __future__ import annotations

import json
import os
import random
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from rosarch.evaluation.experiments.single import score_models
from rosarch.evaluation.experiments.truth import TruthError, read_truth
from rosarch.reports.scores import head_text, score_json

HERE = Path(__file__).parent / "scored"
EXAMPLES = Path(__file__).parents[3] / "examples"
CATEGORY = re.compile(r"^(\S.*?) +truth +(\d+)  found +(\d+)  extra +(\d+)  recall ([\d.]+)  precision ([\d.]+)$", re.MULTILINE)
ATTRIBUTE = re.compile(r"^  (\S.*?) +agree ([\d.]+) of (\d+)$", re.MULTILINE)


def figures(truth: Path, models: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(score_json(score_models(read_truth(truth), models)))
    return found


def test_the_table_of_the_scorer() -> None:
    table = (HERE / "table.txt").read_text()
    found = figures(HERE / "truth", HERE / "models")
    assert head_text(score_models(read_truth(HERE / "truth"), HERE / "models")) == table.partition("\n")[0]
    rows = [
        (name, str(row["truth"]), str(row["found"]), str(row["extra"]), f"{row['recall']:.3f}", f"{row['precision']:.3f}")
        for name, row in found["categories"].items()
    ]
    assert rows == CATEGORY.findall(table) and len(rows) == 6
    agreement = {(name, f"{row['agree']:.3f}", str(row["compared"])) for name, row in found["attributes"].items()}
    assert agreement == set(ATTRIBUTE.findall(table)) and len(agreement) == 11


def test_f1_is_the_harmonic_mean() -> None:
    for row in figures(HERE / "truth", HERE / "models")["categories"].values():
        assert row["f1"] == pytest.approx(2 * row["recall"] * row["precision"] / (row["recall"] + row["precision"]))


def test_private_names_of_both_kinds_are_the_same(tmp_path: Path) -> None:
    for side, slash in (("truth", "/"), ("models", "")):
        (tmp_path / side).mkdir()
        document = {
            "system": "robot",
            "package": "p",
            "component": "c",
            "ports": [{"id": "p1", "kind": "publisher", "name": f"~{slash}out", "at": "c.cpp:1"}],
            "params": [{"name": f"~{slash}rate", "op": "read", "at": "c.cpp:2"}],
        }
        (tmp_path / side / "c.json").write_text(json.dumps(document))
    categories = figures(tmp_path / "truth", tmp_path / "models")["categories"]
    assert [(categories[name]["found"], categories[name]["extra"]) for name in ("ports", "params")] == [(1, 0), (1, 0)]


@pytest.mark.skipif("ROSARCH_SCORER" not in os.environ, reason="ROSARCH_SCORER does not name score.py")
@pytest.mark.parametrize("seed", range(12))
def test_the_scorer_itself(seed: int, tmp_path: Path) -> None:
    draw = random.Random(seed)
    for side in ("truth", "models"):
        (tmp_path / side).mkdir()
    documents = [json.loads(path.read_text()) for path in EXAMPLES.glob("*/expected/*/*.json")]
    documents += [yaml.safe_load(path.read_text()) for path in (HERE / "truth").rglob("*.yml")]
    for number, document in enumerate(documents):
        (tmp_path / "truth" / f"{number}.json").write_text(json.dumps(document))
        if draw.random() < 0.9:
            (tmp_path / "models" / f"{number}.json").write_text(json.dumps(changed(document, draw)))
    command = [sys.executable, os.environ["ROSARCH_SCORER"], tmp_path / "truth", tmp_path / "models", "--json", tmp_path / "figures.json"]
    subprocess.run([str(part) for part in command], check=True, capture_output=True)
    wanted, found = json.loads((tmp_path / "figures.json").read_text()), figures(tmp_path / "truth", tmp_path / "models")
    assert found["components"] == wanted["components"] and len(found["without a model"]) == wanted["without a model"]
    assert {name: {key: round(row[key], 4) for key in wanted["categories"][name]} for name, row in found["categories"].items()} == wanted[
        "categories"
    ]
    assert {name: {**row, "agree": round(row["agree"], 4)} for name, row in found["attributes"].items()} == wanted["attributes"]
    assert sum(row["missed"] for row in [{"missed": row["truth"] - row["found"]} for row in found["categories"].values()]) > 20


def changed(document: dict[str, Any], draw: random.Random) -> dict[str, Any]:
    """A document with entries left out, doubled, moved by lines, with other texts, names and flags."""
    words = ["?", "~x", "true", "false", "x && (y || !z)", "(x==true)&&y", "1.0f", "p1", "p2", None, "Class::member", True, 3]
    result = dict(document)
    for field in ("ports", "params", "periodic", "reactive", "state_variables", "transitions"):
        entries = [dict(entry) for entry in result.get(field) or [] for _ in range(draw.choice((0, 1, 1, 1, 1, 1, 2)))]
        for entry in entries:
            for key in entry:
                if draw.random() < 0.15:
                    entry[key] = other(key, entry[key], draw, words)
            if draw.random() < 0.05:
                entry[draw.choice(("implicit", "optional"))] = True
        result[field] = entries
    return result


def other(key: str, value: Any, draw: random.Random, words: list[Any]) -> Any:
    if key in ("id", "kind", "op"):
        return value
    if key in ("publishes", "trigger"):
        return [word for word in (*value, "p1", "main") if draw.random() < 0.6]
    if key == "at":
        return re.sub(r":(\d+)", lambda match: f":{int(match[1]) + draw.randint(-1, 1)}", value) if isinstance(value, str) else value[1:]
    text = [word for word in words if isinstance(word, str)]
    return draw.choice(text if key in ("name", "variable", "input", "output") else words)


TRUTH = "component: talker\npackage: talker\nsystem: ws\nports:\n  - {id: p1, kind: publisher, name: chatter, type: std_msgs/String, queue: 10}\n"


@pytest.mark.slow
def test_the_single_run(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "truth").mkdir()
    (tmp_path / "truth" / "talker.yml").write_text(TRUTH)
    for folder in (tmp_path, workspace):
        done = rosarch("score", tmp_path / "truth", folder, "-o", tmp_path / "models", "--format", "csv")
        assert (done.code, done.err) == (0, "")
        assert done.out.splitlines()[:2] == ["category,truth,found,extra,recall,precision,F1", "ports,1,1,0,1.0,1.0,1.0"]
    assert rosarch("score", tmp_path / "truth", "--models", tmp_path / "models", "--format", "csv").out == done.out
    assert rosarch("extract", workspace, "-o", tmp_path / "facts" / "ws").code == 0
    assert rosarch("score", tmp_path / "truth", tmp_path / "facts", "--format", "csv").out == done.out
    assert rosarch("extract", workspace, "--text", "-o", tmp_path / "texts" / "ws.txt").code == 0
    for text in (tmp_path / "texts", tmp_path / "texts" / "ws.txt"):
        assert rosarch("score", tmp_path / "truth", text, "--format", "csv").out == done.out
    (tmp_path / "truth" / "talker.yml").write_text(f'{TRUTH}params:\n  - {{name: "", op: has}}\n')  # a name that code can ask for
    assert (
        rosarch("score", tmp_path / "truth", "--models", tmp_path / "models", "--format", "csv")
        .out.splitlines()[2]
        .startswith("params,1,0,0,")
    )
    (tmp_path / "truth" / "talker.yml").write_text(TRUTH.replace("chatter", "chat"))
    listed = rosarch("score", tmp_path / "truth", tmp_path, "--misses").out
    assert listed.endswith(
        "\nmissed ports: talker/talker: publisher chat\nextra  ports: talker/talker: publisher chatter  talker/talker.cpp:8\n"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (TRUTH.replace("component: talker", "component: takler"), "1:12: no component talker/takler in {ws}, did you mean `talker`?"),
        (TRUTH.replace("package: talker", "package: talk"), "1:12: no component talk/talker in {ws}"),
        (TRUTH.replace("kind: publisher, ", ""), "5:5: an entry of `ports` without `kind`"),
        (TRUTH.replace("package: talker\n", ""), "1:1: a component without `package`"),
        (TRUTH.replace("id: p1", "id: [p1]"), "5:10: a text is expected here, not a list"),
        (TRUTH + "periodic:\n  - {publishes: p1}\n", "7:17: a list is expected here, not a text"),
        (TRUTH.replace("ports:", "prts:"), "4:1: unknown key of a component `prts`, did you mean `ports`?"),
        (TRUTH.replace("kind: publisher", "kind: publisher, quue: 3"), "5:31: unknown field of `ports` `quue`, did you mean `queue`?"),
        (TRUTH.replace("queue: 10", "queue: ten"), "5:76: a whole number is expected here, not `ten`"),
        (TRUTH.replace("kind: publisher", "kind: publisher, latched: maybe"), "5:40: true or false is expected here, not `maybe`"),
        (
            TRUTH.replace("kind: publisher", "kind: publisher, at: talker.cpp"),
            "5:35: a place, `file:line`, is expected here, not `talker.cpp`",
        ),
        (TRUTH + "periodic:\n  - {publishes: [p2]}\n", "7:18: no port `p2` in this document"),
        (TRUTH + "periodic:\n  - {publishes: [p1], hz: [10]}\n", "7:27: a number is expected here, not a list"),
        (TRUTH + "  - {id: p1, kind: publisher}\n", "6:10: a second port with the id `p1`"),
        ("component: talker\npackage: talker\nports: {id: p1}\n", "3:8: a list is expected here, not a map"),
        ("component: talker\npackage: [talker\n", "3:1: while parsing a flow sequence did not find expected ',' or ']'"),
    ],
)
def test_wrong_truth(rosarch: Callable, workspace: Path, tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "truth").mkdir()
    (tmp_path / "truth" / "talker.yml").write_text(text)
    done = rosarch("score", tmp_path / "truth", workspace, "-o", tmp_path / "models")
    expected = f"rosarch: error: {tmp_path}/truth/talker.yml:{message.format(ws=workspace)}"
    assert (done.code, done.out, done.err.splitlines()[0]) == (2, "", expected)
    assert not (tmp_path / "models").exists()


PROGRAM = {
    "package.xml": "<package format='3'><name>pair</name><version>1.0.0</version><description/><maintainer email='a@b.org'>a</maintainer>"
    "<license>MIT</license><export><build_type>ament_python</build_type></export></package>",
    "setup.py": "from setuptools import setup\nsetup(name='pair', packages=['pair'], entry_points={'console_scripts': ['both = pair.both:main']})\n",
    "pair/__init__.py": "",
    "pair/both.py": """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self, topic):
        super().__init__('talker')
        self.talks = self.create_publisher(String, topic, 10)

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.hears = self.create_subscription(String, 'chatter', print, 10)

def main():
    rclpy.init()
    nodes = [Talker('chatter'), Listener()]
""",
}


@pytest.mark.slow
def test_truth_about_a_node_of_a_program(rosarch: Callable, tmp_path: Path) -> None:
    for name, text in PROGRAM.items():
        path = tmp_path / "ws" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    (tmp_path / "truth").mkdir()
    head = "system: ws\npackage: pair\nexecutable: both\n"
    port = "  - {id: p1, kind: publisher, name: chatter, type: std_msgs/String, queue: 10}\n"
    (tmp_path / "truth" / "talker.yml").write_text(f"{head}component: talker\nports:\n{port}")
    (tmp_path / "truth" / "listener.yml").write_text(f"{head}component: listener\nports:\n{port.replace('publisher', 'subscriber')}")
    done = rosarch("score", tmp_path / "truth", tmp_path / "ws", "--format", "csv")
    assert (done.code, done.out.splitlines()[1]) == (0, "ports,2,2,0,1.0,1.0,1.0")
    shown = rosarch("show", "ports", tmp_path / "ws").out
    assert ("pair/talker  node of both" in shown, "1 component, 2 ports" in shown) == (True, True)
    (tmp_path / "truth" / "listener.yml").unlink()
    (tmp_path / "truth" / "talker.yml").write_text(f"{head}component: takler\nports:\n{port}")
    assert "1 component, 1 without a model: pair/takler" in rosarch("score", tmp_path / "truth", tmp_path / "ws").out


def test_truth_that_is_no_text(tmp_path: Path) -> None:
    (tmp_path / "a.yml").write_bytes(b"component: talker\npackage: \xff\n")
    with pytest.raises(TruthError) as caught:
        read_truth(tmp_path)
    assert str(caught.value) == f"{tmp_path}/a.yml:2:1: not UTF-8 text: byte 0xff"


def test_truth_that_is_told_twice(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.yml").write_text(TRUTH)
    with pytest.raises(TruthError) as caught:
        read_truth(tmp_path)
    assert str(caught.value) == f"{tmp_path}/b.yml:1:12: talker/talker of ws is told of for the second time, first in {tmp_path}/a.yml:1"


def test_wrong_use(rosarch: Callable, workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "truth").mkdir()
    done = rosarch("score", tmp_path / "truth")
    assert (done.code, done.err) == (2, "rosarch: error: name either the folder of the systems or, with --models, that of their models\n")
    done = rosarch("score", tmp_path / "truth", workspace)
    assert done.code == 2 and done.err.startswith(f"rosarch: error: {tmp_path}/truth: no truth below this folder; ")
    (tmp_path / "truth" / "talker.yml").write_text(TRUTH)
    (tmp_path / "truth" / "other.yml").write_text(TRUTH.replace("system: ws", "system: other"))
    done = rosarch("score", tmp_path / "truth", tmp_path)
    assert (done.code, done.err) == (
        2,
        f"rosarch: error: {tmp_path}/truth/other.yml:1:12: no folder {tmp_path}/other of the system other\n",
    )
    done = rosarch("score", tmp_path / "truth", tmp_path, "--allow-absent", "--format", "json")
    assert (done.code, json.loads(done.out)["without a model"]) == (0, ["talker/talker"])
