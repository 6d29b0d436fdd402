"""ROS packages, their CMake targets and the components these make up, read from the source tree alone.

`discover` reads a workspace, `components` lists what runs, `closure` and `include_path` answer questions about one target.
"""

from rosarch.extractor.diagnostics import Diagnostic

from .components import components, programs, without_library
from .discovery import discover
from .graph import closure, include_path
from .loose import loose_workspace
from .model import Component, Configured, Exports, Package, PluginClass, Target, Workspace

__all__ = [
    "Component",
    "Configured",
    "Diagnostic",
    "Exports",
    "Package",
    "PluginClass",
    "Target",
    "Workspace",
    "closure",
    "components",
    "discover",
    "include_path",
    "loose_workspace",
    "programs",
    "without_library",
]
