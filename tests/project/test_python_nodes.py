"""Python nodes: each file of `python/` says what is to be found in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

NODES = Path(__file__).parent / "python"


def test_python_nodes(rosarch: Callable) -> None:
    outcome = rosarch("rules", "test", NODES)
    assert outcome.code == 0, outcome.out
    assert outcome.out.count("\nok ") + 1 == len(list(NODES.glob("*.py")))
    assert outcome.err.count("Python 2: read as what 2to3 makes of it") == 1
