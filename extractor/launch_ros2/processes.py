"""Programs that launch runs as processes and that are nodes all the same, as the rules know them."""

from __future__ import annotations

from functools import lru_cache

from rosarch.datalog import load_program
from rosarch.extractor.manifest import rules_folder

_RELATION = "api_process_is_node"


@lru_cache(maxsize=1)
def node_programs() -> dict[str, tuple[str, str, str]]:
    """The package, executable and node of each program."""
    rows = load_program(rules_folder() / "api" / "loaders.dl").evaluate({}, keep=[_RELATION]).rows(_RELATION)
    return {str(program): (str(package), str(executable), str(name)) for program, package, executable, name in rows}
