"""Programs that cannot be run, or that nobody finds."""

from __future__ import annotations

import configparser
import os
import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from rosarch.analysis.systems.builds.defect import Defect
from rosarch.base.files import read_file, text_or_nothing
from rosarch.extractor.package_names import NO_PACKAGES
from rosarch.extractor.python_syntax import parse_python
from rosarch.extractor.workspace.built import Built


def of_script(package: Built, program: str, ros: int) -> Iterator[Defect]:
    """A script that the system cannot run.

    Its first line names no interpreter, or one that ends in a carriage return; it is in Python 2, which ROS 2 and python3 do not run.
    """
    for path in _files_called(package.folder, program):
        data = read_file(path) if os.path.isfile(path) else b""
        first = data.split(b"\n", 1)[0]
        if not first.startswith(b"#!"):
            yield Defect(path, 1, "no interpreter", program)
        elif first.endswith(b"\r"):
            yield Defect(path, 1, "carriage return", program)
        elif ros == 2 or b"python3" in first:
            yield from (Defect(path, line, "python 2", program) for line in _python2(data))
        yield from _of_imports(package, path, data.decode("utf-8", "replace"))


def of_setup(package: Built, program: str) -> Iterator[Defect]:
    """Programs that are installed where nobody looks for them, since `setup.cfg` does not say where."""
    if package.build_type != "ament_python" or program not in {one.name for one in package.entry_points if one.is_command}:
        return
    if "install_scripts" in text_or_nothing(package.folder / "setup.py"):
        return
    config = package.folder / "setup.cfg"
    text = text_or_nothing(config)
    reader = configparser.ConfigParser(interpolation=None)
    try:
        reader.read_string(text)
    except configparser.Error:
        return  # that is reported where it is read
    given = reader.get("install", "install_scripts", fallback=None) or reader.get("install", "install-scripts", fallback=None)
    if given is None or given.strip().rstrip("/") != f"$base/lib/{package.name}":
        line = next((n for n, written in enumerate(text.splitlines(), 1) if re.match(r"install[-_]scripts", written)), 1)
        yield Defect(config if os.path.isfile(config) else package.folder / "setup.py", line, "programs elsewhere", f"lib/{package.name}")


def _of_imports(package: Built, path: Path, text: str) -> Iterator[Defect]:
    """Modules of its own package that a script imports in vain: it has the name itself, or the build does not set them up.

    What the build generates itself, such as `from package.msg import ...`, is put on the path all the same.
    """
    own = rf"^(?:from|import)[ \t]+{re.escape(package.name)}\b"
    found = re.search(own, text, re.MULTILINE)
    if found is None or path.parent.name == package.name:
        return
    written = re.search(rf"{own}(?!\.(?:msg|srv|action|cfg)\b)", text, re.MULTILINE)
    modules = package.folder / "src" / package.name
    if path.stem == package.name:
        yield Defect(path, 1 + text.count("\n", 0, found.start()), "hides its package", path.name)
    elif (
        written is not None
        and package.build_type == "catkin"
        and not package.unsure
        and os.path.isfile(modules / "__init__.py")
        and not package.called("catkin_python_setup")
    ):
        yield Defect(path, 1 + text.count("\n", 0, written.start()), "modules not set up", package.name)


def _python2(data: bytes) -> Iterator[int]:
    """The line of the first statement that only Python 2 has."""
    try:
        parse_python(data)
    except SyntaxError as error:
        if re.match(r"Missing parentheses in call to|multiple exception types must be parenthesized", error.msg):
            yield error.lineno or 1


@lru_cache(maxsize=1024)
def _files_called(folder: Path, name: str) -> tuple[Path, ...]:
    """The scripts of Python of this name in a package."""
    found = []
    for here, folders, names in os.walk(folder):
        folders[:] = [one for one in folders if not one.startswith(".") and one not in NO_PACKAGES and not _is_package(here, one)]
        if name in names and name.endswith(".py"):
            found.append(Path(here, name))
    return tuple(found) if len(found) == 1 else ()


def _is_package(folder: str, name: str) -> bool:
    return os.path.isfile(os.path.join(folder, name, "package.xml"))
