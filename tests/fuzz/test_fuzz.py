"""A short run over every reader; `run.py` beside this file makes long ones."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from mutations import LONGEST, mutants
from run import OWN_PROCESS, Costs, defects, inputs, seeds
from targets import TARGETS, Target

COUNT = {name: 3 if name in OWN_PROCESS else 30 for name in TARGETS}


def test_every_corpus_has_a_target() -> None:
    assert {path.name for path in (Path(__file__).parent / "corpus").iterdir()} == set(TARGETS)


@pytest.mark.slow
@pytest.mark.parametrize("name", TARGETS)
def test_no_input_is_too_much(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSARCH_CACHE_DIR", "")  # restored afterwards: a run has a cache of its own
    count = max(COUNT[name], len(seeds(name)))
    found = defects(TARGETS[name], inputs(TARGETS[name], count, 0), 2, Costs())
    assert [(defect.reason, defect.data[:200]) for defect in found] == []


def test_inputs_are_the_same_every_time_and_bounded() -> None:
    made = list(mutants([b"seed", b"other"], [b"word"], 500, "x"))
    assert made == list(mutants([b"seed", b"other"], [b"word"], 500, "x"))
    assert made[:2] == [b"seed", b"other"]
    assert len(set(made)) > 300
    assert max(map(len, made)) == LONGEST


def _fails(data: bytes, _folder: Path) -> None:
    if data == b"error":
        raise KeyError("x")
    if data == b"memory":
        bytearray(2 << 30)
    if data == b"crash":
        import os

        os.abort()


def test_what_fails_is_told() -> None:
    given = [b"good", b"error", b"good", b"memory", b"crash", b"good"]
    random.Random(0).shuffle(given)
    costs = Costs()
    found = {defect.data: defect.reason for defect in defects(Target("x", _fails, ()), given, 2, costs)}
    assert found.keys() == {b"error", b"memory", b"crash"}
    assert found[b"error"].startswith("KeyError: 'x': test_fuzz.py:")
    assert found[b"memory"].startswith("MemoryError: test_fuzz.py:")
    assert found[b"crash"] == "crash: the worker process ended with code -6"
    assert costs.ended == 1
    assert 0 <= costs.seconds < 3
    assert costs.memory > 1 << 20
