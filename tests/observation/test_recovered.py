"""Ports of real nodes of Debian's ROS 1, against those that are recovered from their sources or known to the library.

Nodes that are not installed are skipped, and those whose sources Debian does not hand out here.
"""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.slow

PROGRAM = Path(__file__).parents[2] / "benchmarks" / "recovered.py"


def _loaded() -> Any:
    spec = importlib.util.spec_from_file_location("recovered", PROGRAM)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules["recovered"] = module
    spec.loader.exec_module(module)
    return module


recovered = _loaded()


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path | None]:
    """The folder with the sources of a package, None when they cannot be had."""
    folder = tmp_path_factory.mktemp("sources")

    @lru_cache
    def fetch(source: str) -> Path | None:
        try:
            found: Path = recovered.fetched(source, folder)
        except (OSError, subprocess.SubprocessError):
            return None
        return found

    return fetch


@pytest.mark.parametrize("node", (*recovered.NODES, *recovered.OF_THE_LIBRARY), ids=lambda node: f"{node.package}-{node.type}")
def test_ports_are_those_of_the_running_node(node: Any, sources: Callable[[str], Path | None], tmp_path: Path) -> None:
    if node.program is None:
        pytest.skip(f"{node.debian} is not installed")
    root = sources(node.source)
    if root is None:
        pytest.skip(f"the sources of {node.source} cannot be had")
    outcomes = Counter(element["outcome"] for element in recovered.compared(node, root, tmp_path))
    assert outcomes["confirmed"] > 0
    assert set(outcomes) == {"confirmed"}
