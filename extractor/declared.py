"""The packages whose declarations rosarch brings: what they do is known to the rules, not read."""

from pathlib import Path

_HERE = Path(__file__).parent
_LINES = (_HERE / "cxx" / "headers" / "packages.txt").read_text(encoding="utf-8").splitlines()

IN_CXX = frozenset(
    (name, middleware)
    for name, *only in (line.split() for line in _LINES if line and not line.startswith("#"))
    for middleware in only or ("ros1", "ros2")
)
"""Names, and for which ROS."""
IN_PYTHON = frozenset(path.stem for path in (_HERE / "python" / "stubs").iterdir())
DECLARED = frozenset(name for name, _ in IN_CXX) | IN_PYTHON
