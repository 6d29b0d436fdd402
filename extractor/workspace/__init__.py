"""ROS packages, their CMake targets and the components these make up, read from the source tree alone.

`discover` reads a workspace, `components` lists what runs, `closure` and `include_path` answer questions about one target.
"""

from rosarch.extractor.diagnostics import Diagnostic

from .components import components, programs, registered, without_library
from .discovery import discover
from .graph import closure, include_path
from .loose import loose_workspace
from .model import PYTHON_NODE, Component, Configured, EntryPoint, Exports, Package, PluginClass, Program, PythonEntry, Target, Workspace

__all__ = [
    "PYTHON_NODE",
    "Component",
    "Configured",
    "Diagnostic",
    "EntryPoint",
    "Exports",
    "Package",
    "PluginClass",
    "Program",
    "PythonEntry",
    "Target",
    "Workspace",
    "closure",
    "components",
    "discover",
    "include_path",
    "loose_workspace",
    "programs",
    "registered",
    "without_library",
]
