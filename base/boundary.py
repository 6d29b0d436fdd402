"""What may be read while a workspace is analysed: what is below some folders, wherever `..` and links seem to lead."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

OUTSIDE = "outside of the workspace"
_OWN = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))  # what rosarch brings is read whatever is analysed

_folders: tuple[str, ...] = ()
_inside_by_folder: dict[str, bool] = {}


@contextmanager
def confined(folders: Iterable[str | os.PathLike[str]]) -> Iterator[None]:
    """Nothing but what is below these folders, or those of a confinement around this one, is inside meanwhile."""
    global _folders
    before = _folders
    absolute = [os.path.abspath(folder) for folder in folders]
    _folders = tuple(dict.fromkeys([*before, *absolute, *map(os.path.realpath, absolute)]))
    _inside_by_folder.clear()
    try:
        yield
    finally:
        _folders = before
        _inside_by_folder.clear()


def folders() -> tuple[str, ...]:
    """The folders of the confinement, as they were named and without links; none when there is no confinement."""
    return _folders


def is_inside(path: str | os.PathLike[str]) -> bool:
    """Whether a file or folder may be read."""
    if not _folders:
        return True
    above, name = os.path.split(os.path.abspath(path))
    if os.path.islink(path) or not name:
        return _holds(os.path.realpath(path))
    if above not in _inside_by_folder:
        _inside_by_folder[above] = _holds(os.path.realpath(above))
    return _inside_by_folder[above] or _holds(os.path.realpath(path))


def _holds(real: str) -> bool:
    return any(real == folder or real.startswith(folder.rstrip("/") + "/") for folder in (*_folders, _OWN))


def ros_package_path(variables: Mapping[str, str] = os.environ) -> list[Path]:
    """The folders of `ROS_PACKAGE_PATH`."""
    return [Path(folder) for folder in variables.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if os.path.isdir(folder)]
