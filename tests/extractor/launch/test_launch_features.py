"""Launch files written for each feature come to what the real roslaunch made of them (`expected.jsonl`)."""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import launch as benchmark
import pytest

from rosarch.extractor.launch import Files, PackagePath, compose

HERE = Path(__file__).resolve().parent
FEATURES = HERE / "features"
RECORDS = [json.loads(line) for line in (HERE / "expected.jsonl").read_text(encoding="utf-8").splitlines()]
OPTIONS = argparse.Namespace(
    oracle_root="ROOT",
    environment={"LAUNCH_TEST_SET": "set", "ROS_MASTER_URI": "http://localhost:11311", "ROS_PACKAGE_PATH": str(FEATURES)},
)


def name_of(record: dict) -> str:
    return " ".join([Path(record["file"]).name, *record.get("arguments", ())])


@pytest.fixture(scope="module")
def files() -> Files:
    return Files(PackagePath([FEATURES]))


@pytest.mark.parametrize("record", RECORDS, ids=map(name_of, RECORDS))
def test_as_roslaunch(record: dict, files: Files) -> None:
    assert benchmark.compare_file(record, FEATURES, files, OPTIONS) == []


def test_every_file_has_a_record() -> None:
    assert {str(path.relative_to(FEATURES)) for path in FEATURES.rglob("*.launch")} == {record["file"] for record in RECORDS}


def test_refused_files_are_named_so() -> None:
    for record in RECORDS:
        if "arguments" not in record and record["file"].startswith("alpha/"):
            assert ("exception" in record) == Path(record["file"]).name.startswith("refused_"), record["file"]


def pythons() -> Sequence[str]:
    candidates = {sys.executable, "/usr/bin/python3", shutil.which("python3") or sys.executable}
    return [
        python for python in sorted(candidates) if subprocess.run([python, "-c", "import roslaunch"], capture_output=True).returncode == 0
    ]


def test_records_are_those_of_roslaunch() -> None:
    """The committed records are what roslaunch makes of the files; only where it is installed."""
    found = pythons()
    if not found:
        pytest.skip("roslaunch is not installed")
    printed = subprocess.run([found[0], str(HERE / "real_roslaunch.py")], capture_output=True, check=True).stdout
    assert printed.decode() == (HERE / "expected.jsonl").read_text(encoding="utf-8")


def test_a_difference_is_found(files: Files) -> None:
    """The comparison can fail: each kind of change to a record is told."""
    record = next(record for record in RECORDS if record["file"] == "alpha/launch/node.launch")
    changed = json.loads(json.dumps(record))
    changed["nodes"][1]["args"] = "other"
    del changed["nodes"][4]
    changed["params"]["/more"] = 1.0
    changed["tests"] = 2
    assert benchmark.compare_file(changed, FEATURES, files, OPTIONS) == [
        "node 1 /arm/full: args is 'other', rosarch has '--rate 10 a:=b _p:=1 __name:=other'",
        "4 nodes, rosarch has 5",
        "2 tests, rosarch has 0",
        "parameter /more is 1.0, rosarch has none",
    ]


@pytest.mark.parametrize(
    ("value", "difference"),
    [(1, "parameter /double is 1, rosarch has 1.0"), (True, "parameter /double is true, rosarch has 1.0")],
)
def test_types_of_parameters_differ(files: Files, value: object, difference: str) -> None:
    record = next(record for record in RECORDS if record["file"] == "alpha/launch/params.launch")
    changed = {**record, "params": {**record["params"], "/double": value}}
    assert benchmark.compare_file(changed, FEATURES, files, OPTIONS) == [difference]


def test_another_cause_is_a_difference(files: Files) -> None:
    other = {"file": "alpha/launch/refused_env.launch", "exception": "ResourceNotFound: missing\nROS path [0]=ROOT"}
    (difference,) = benchmark.compare_file(other, FEATURES, files, OPTIONS)
    assert "environment variable `LAUNCH_TEST_UNSET` is not set" in difference
    loaded = {"file": "alpha/launch/refused_env.launch", "nodes": [], "params": {}}
    (difference,) = benchmark.compare_file(loaded, FEATURES, files, OPTIONS)
    assert difference.startswith("roslaunch loads it, rosarch refuses: ")
    refused = {"file": "alpha/launch/minimal.launch", "exception": "ResourceNotFound: missing\nROS path [0]=ROOT"}
    (difference,) = benchmark.compare_file(refused, FEATURES, files, OPTIONS)
    assert difference.endswith("rosarch: no refusal")


def test_exit_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    oracle = tmp_path / "oracle.jsonl"
    oracle.write_text('{"file": "alpha/launch/minimal.launch", "nodes": [], "params": {"/a": 1}}\n')
    monkeypatch.setattr(sys, "argv", ["launch.py", str(oracle), str(FEATURES)])
    assert benchmark.main() == 1
    assert "alpha/launch/minimal.launch: parameter /a is 1, rosarch has none\n" in capsys.readouterr().out
    oracle.write_text('{"file": "alpha/launch/minimal.launch", "nodes": [], "params": {}}\n')
    assert benchmark.main() == 0


def test_several_files_share_names_and_parameters(files: Files) -> None:
    launches = [FEATURES / "alpha/launch" / name for name in ("node.launch", "params_override.launch", "node.launch")]
    composition = compose([launches[0], launches[0]], files=files)
    assert len(composition.nodes) == 10
    assert composition.refusal is not None
    assert composition.refusal.message == f"a second node `/driver`, the first is at {launches[0]}:2"
