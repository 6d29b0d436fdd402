"""The name in a package manifest."""

from __future__ import annotations

import html
import re

from rosarch.base.files import read_file

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_NAME = re.compile(r"<name>\s*([^<\s]+)\s*</name>")

IGNORE_MARKERS = frozenset({"CATKIN_IGNORE", "COLCON_IGNORE", "AMENT_IGNORE"})
"""Files that hide a folder, with all that is below it, from the tools that build."""
HEAVY_FOLDERS = frozenset({"node_modules", "__pycache__", "venv", "site-packages"})
TEMPLATES = frozenset({"template", "templates"})
NO_PACKAGES = HEAVY_FOLDERS | TEMPLATES | {"test", "tests"}
"""Folders of a package whose manifests are no packages of the workspace: tests and generators use them."""


def quick_name(path: str) -> str | None:
    """The package name without parsing: enough to know which manifests are needed."""
    return name_in(quick_text(path) or "")


def name_in(text: str) -> str | None:
    """The package name in the text of a manifest."""
    match = _NAME.search(text)
    return html.unescape(match.group(1)) if match else None


def quick_text(path: str) -> str | None:
    """The text of a manifest without its comments, its lines as they were; None when it cannot be read."""
    try:
        return without_comments(read_file(path).decode(errors="replace"))
    except OSError:
        return None


def without_comments(text: str) -> str:
    """XML without its comments, its lines as they were."""
    return _COMMENT.sub(lambda found: "\n" * found[0].count("\n"), text)
