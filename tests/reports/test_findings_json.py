"""Findings as JSON, and their schema."""

from __future__ import annotations

import json
from typing import Any

import pytest
from findings_reports import BELOW, EVIL, EVIL_SETTING, GONE, HERE, KNOWN, WITH_MANIFEST, everything, hostile, nothing, one, with_fix
from handmade_findings import FULL
from jsonschema import Draft202012Validator

from rosarch.reports.findings_json import findings_schema, findings_text


def valid(text: str) -> Any:
    data = json.loads(text)
    Draft202012Validator(findings_schema()).validate(data)
    return data


def test_schema_is_a_schema() -> None:
    Draft202012Validator.check_schema(findings_schema())


@pytest.mark.parametrize("reported", [one(), nothing(), everything(), hostile()], ids=["one", "nothing", "everything", "hostile"])
def test_documents_follow_the_schema(reported) -> None:
    valid(findings_text(reported, HERE))
    assert valid(findings_text(reported, BELOW))["folder"] == "ws"


def test_a_fix() -> None:
    other, full = valid(findings_text(with_fix(), WITH_MANIFEST))["findings"]
    assert "fix" not in other
    assert full["fix"] == {
        "description": "`/ticks` becomes `/odom/ticks`; add the line `<depend>std_msgs</depend>` below",
        "replacements": [
            {"file": "base/launch/base.launch", "line": 3, "column": 29, "end_line": 3, "end_column": 35, "text": "/odom/ticks"},
            {"file": "base/package.xml", "line": 3, "column": 1, "end_line": 3, "end_column": 1, "text": "  <depend>std_msgs</depend>\n"},
        ],
    }


def test_a_finding() -> None:
    assert valid(findings_text(one(), BELOW))["findings"] == [
        {
            "check": "type-mismatch",
            "severity": "error",
            "confidence": "high",
            "message": "/odom reads /ticks as Float32, but /base publishes it as Int32",
            "file": "odom/src/odom.cpp",
            "line": 3,
            "column": 13,
            "evidence": [
                {"text": "read as Float32", "file": "odom/src/odom.cpp", "line": 3, "column": 13},
                {"text": "remapped", "file": "base/launch/base.launch", "line": 3, "column": 5},
                {"text": "published as Int32", "file": "base/src/base.cpp", "line": 3, "column": 12},
            ],
            "hint": "Use one type,\nor rename one topic.",
            "systems": ["base.launch", "sim.launch"],
            "fingerprint": FULL.fingerprint,
        }
    ]


def test_everything() -> None:
    data = valid(findings_text(everything(), HERE))
    assert [each["message"] for each in data["findings"]] == ["whole file", FULL.message]
    assert [(each["message"], each["reason"], each["comment_line"]) for each in data["suppressed"]] == [("bad style", "as agreed", 2)]
    assert [each["fingerprint"] for each in data["known"]] == [KNOWN.fingerprint]
    assert data["gone"] == [{"check": "near-miss", "message": "one that was repaired", "file": "b.cpp", "fingerprint": GONE.fingerprint}]
    assert data["summary"] == {"error": 1, "warning": 1, "note": 0, "compared": True, "failed": True}


def test_texts_are_as_they_are() -> None:
    (found,) = json.loads(findings_text(hostile(), EVIL_SETTING).encode("utf-8", "backslashreplace"))["findings"]
    assert (found["message"], found["file"]) == (EVIL, EVIL)


@pytest.mark.parametrize("key", ["check", "severity", "message", "file", "line", "fingerprint", "evidence"])
def test_the_schema_refuses_what_is_wrong(key: str) -> None:
    data = json.loads(findings_text(one(), HERE))
    assert not Draft202012Validator(findings_schema()).is_valid({**data, "findings": [{**data["findings"][0], key: None}]})
    assert not Draft202012Validator(findings_schema()).is_valid({**data, "findings": [{**data["findings"][0], "more": 1}]})
    del data["findings"][0][key]
    assert not Draft202012Validator(findings_schema()).is_valid(data)
