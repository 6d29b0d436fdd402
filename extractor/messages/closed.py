"""Packages whose messages, services and actions are all known."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from rosarch.base.files import path_text, read_file
from rosarch.extractor.workspace.model import Package

_INTERFACES = (".msg", ".srv", ".action")
_HEADERS = (".h", ".hh", ".hpp", ".hxx", ".in", ".em", ".cfg", ".proto")
_MAKES_FILES = re.compile(
    r"\b(?:configure_file|execute_process|add_custom_\w+|ExternalProject\w*|FetchContent\w*|include|\w*protobuf\w*|\w*(?<!rosidl_)generate_(?!messages\b)\w+)\s*\("
    r"|\bfile\s*\(\s*(?:WRITE|APPEND|GENERATE|DOWNLOAD|COPY)",
    re.IGNORECASE,
)
_COMMENT = re.compile(r"#[^\n]*")


def closed_packages(packages: Iterable[Package]) -> dict[str, set[tuple[str, ...]]]:
    """Rows about the packages whose definitions are those that were read: whether all their headers are made of these, what they define."""
    packages = list(packages)
    names = Counter(package.name for package in packages)
    closed: set[tuple[str, ...]] = set()
    defined: set[tuple[str, ...]] = set()
    for package in packages:
        headers = ("some" if package.installed else _headers(package)) if names[package.name] == 1 and _declared(package) else None
        if headers is not None:
            closed.add((package.name, headers))
            files = (path for kind in _INTERFACES for path in (package.path / kind[1:]).glob(f"*{kind}"))
            defined.update((package.name, path_text(path.stem)) for path in (*_declared(package), *files))
    return {"interfaces_closed": closed, "interface_defined": defined}


def _declared(package: Package) -> set[Path]:
    return {*package.message_files, *package.service_files, *package.action_files}


def _headers(package: Package) -> str | None:
    declared = _declared(package)
    if _makes_files(package.path / "CMakeLists.txt"):
        return None
    headers = "all"
    for folder, folders, files in os.walk(package.path):
        folders[:] = [name for name in folders if not name.startswith(".")]
        base = os.path.basename(folder)
        if base in ("msg", "srv", "action") and "__init__.py" in files:
            return None
        for name in files:
            path = Path(folder, name)
            if name.endswith(".idl") or (name.endswith(_INTERFACES) and path not in declared and path.parent.parent != package.path):
                return None
            if name.endswith(_HEADERS):
                headers = "some"
    return headers


def _makes_files(path: Path) -> bool:
    """Whether a build may make definitions, headers or modules by other means."""
    try:
        text = read_file(path).decode(errors="replace")
    except OSError:
        return True
    return _MAKES_FILES.search(_COMMENT.sub("", text)) is not None
