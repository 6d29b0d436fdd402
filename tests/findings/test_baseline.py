"""The file of a baseline."""

from __future__ import annotations

import json
import random

import pytest
from handmade_findings import FULL, STYLE, finding

from rosarch.findings.baseline import Baseline, BaselineError, baseline_text, read_baseline

FINDINGS = [FULL, finding(), finding(line=9), finding(STYLE, "größe \x1b \u202e {}", "ü/b.cpp")]


def test_what_is_written_is_read() -> None:
    baseline = Baseline.of(FINDINGS)
    assert read_baseline(baseline_text(baseline), "b.json") == baseline


def test_the_text_does_not_depend_on_the_order_of_findings_nor_on_their_lines() -> None:
    mixed = [FINDINGS[0], finding(line=900), finding(line=1, column=7), FINDINGS[3]]
    random.Random(1).shuffle(mixed)
    assert baseline_text(Baseline.of(mixed)) == baseline_text(Baseline.of(FINDINGS))


def test_the_text() -> None:
    assert baseline_text(Baseline.of([finding()])) == (
        "{\n"
        '  "rosarch_baseline": 1,\n'
        '  "findings": [\n'
        "    {\n"
        '      "file": "a.cpp",\n'
        '      "check": "type-mismatch",\n'
        '      "message": "m",\n'
        f'      "fingerprint": "{finding().fingerprint}"\n'
        "    }\n"
        "  ]\n"
        "}\n"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "b.json:1:1: not a baseline: expecting value"),
        ('{\n<<<<<<< HEAD\n  "rosarch_baseline": 1}', "b.json:2:1: not a baseline: expecting property name enclosed in double quotes"),
        ("[]", "b.json:1:1: not a baseline: `rosarch check --write-baseline FILE` writes one"),
        ('{"findings": []}', "b.json:1:1: not a baseline: `rosarch check --write-baseline FILE` writes one"),
        ('{"rosarch_baseline": 2}', "b.json:1:1: a baseline of format 2, this version reads format 1"),
        ('{"rosarch_baseline": 1}', "b.json:1:1: not a baseline: finding 1 lacks one of file, check, message, fingerprint"),
        (
            json.dumps({"rosarch_baseline": 1, "findings": [{"file": "a", "check": "b", "message": "c", "fingerprint": 1}]}),
            "b.json:1:1: not a baseline: finding 1 lacks one of file, check, message, fingerprint",
        ),
        ("[" * 100_000, "b.json:1:1: not a baseline: nested too deeply"),
    ],
    ids=range(8),
)
def test_what_is_no_baseline(text: str, message: str) -> None:
    with pytest.raises(BaselineError) as caught:
        read_baseline(text, "b.json")
    assert str(caught.value) == message
