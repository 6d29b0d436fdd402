"""What conditions ask of an evaluation and of the machine: values, targets, commands, files.

What finding a package that is not in the workspace may have set (cmake-packages(7), cmake-developer(7)) is there, whether the files of
that package would set it or not: conditions such as `if(X_DIR)` and `if(TARGET X::core)` ask whether `X` is installed.
"""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

from rosarch.extractor.workspace.cmake_conditions import CMakeEnvironment

if TYPE_CHECKING:
    from rosarch.extractor.workspace.evaluator import Evaluator

_NEWEST = "9999"  # true, and newer than any version that a condition asks for
_RESULT = re.compile(r"_(?:FOUND|DIRS?|CONFIG|VERSION|LIBRARY|LIBRARIES|LIBS|INCLUDES|DEFINITIONS|EXECUTABLE)$")


def cmake_environment(run: Evaluator) -> CMakeEnvironment:
    """What the conditions of an evaluation may ask."""
    return CMakeEnvironment(
        value=lambda name: _value(run, name),
        defined=lambda name: _is_defined(run, name),
        is_command=run.is_command,
        is_target=lambda name: (
            name in run.targets or name in run.aliases or ("::" in name and name.partition("::")[0] in run.found_packages)
        ),
        exists=run.exists,
        is_directory=lambda path: run.exists(path) if run.is_outside(path) else os.path.isdir(path),
        set_matches=run.set_matches,
    )


def _value(run: Evaluator, name: str) -> str | None:
    if name.startswith("CMAKE_CURRENT_"):
        return run.location(name)
    value = run.get(name)
    if not value and _RESULT.search(name) and any(name.startswith(f"{found}_") for found in run.found_packages):
        return _NEWEST
    return value


def _is_defined(run: Evaluator, name: str) -> bool:
    if name.startswith("ENV{"):
        return name[4:-1] in run.environment
    if name.startswith("CACHE{"):
        return name[6:-1] in run.cache
    return _value(run, name) is not None
