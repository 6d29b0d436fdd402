"""ROS packages, their CMake targets and the components these make up, read from the source tree alone.

`discover` reads a workspace, `components` lists what runs, `closure` and `include_path` answer questions about one target.
"""

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.workspace.components import components, programs, registered, without_library
from rosarch.extractor.workspace.discovery import discover
from rosarch.extractor.workspace.graph import closure, include_path
from rosarch.extractor.workspace.loose import loose_workspace
from rosarch.extractor.workspace.model import (
    PYTHON_NODE,
    Component,
    Configured,
    EntryPoint,
    Exports,
    Package,
    PluginClass,
    Program,
    PythonEntry,
    Target,
    Workspace,
)

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
