"""What changed between two states of a workspace: its components, its systems, what checks find in them."""

from rosarch.analysis.comparison.changes import Change, Detail
from rosarch.analysis.comparison.compare import Snapshot, compare

__all__ = ["Change", "Detail", "Snapshot", "compare"]
