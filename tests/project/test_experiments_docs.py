"""What `docs/experiments.md` shows is so."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from rosarch.evaluation.experiments.truth import read_truth
from rosarch.evaluation.experiments.truth_fields import LISTS

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs/experiments.md").read_text(encoding="utf-8")
YAML = re.findall(r"```yaml\n(.*?)```", TEXT, re.DOTALL)


def test_the_truth_is_truth(tmp_path: Path) -> None:
    (tmp_path / "truth.yml").write_text(YAML[0])
    (truth,) = read_truth(tmp_path)
    assert (truth.system, truth.title) == ("mobile_base", "base_driver/base_driver")
    assert set(LISTS) - {"configuration"} <= set(truth.document)


def test_the_experiments_are_the_examples() -> None:
    for name, shown in zip(("state_variables", "name_matching"), YAML[1:], strict=True):
        assert (ROOT / f"examples/experiments/{name}.yml").read_text() == shown


def test_every_key_is_described(rosarch: Callable, tmp_path: Path) -> None:
    (tmp_path / "e.yml").write_text("subjects: {}\nwrong: 1\n")
    (known,) = re.findall(r"there are (.*)", rosarch("experiment", tmp_path / "e.yml").err)
    described = re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (`.*?) \|", TEXT, re.MULTILINE)))
    assert sorted(described) == sorted(known.split(", "))
    for shown in YAML[1:]:
        assert set(yaml.safe_load(shown)) <= set(described)
