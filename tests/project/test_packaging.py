"""Every folder and every data file of the packages is installed."""

from __future__ import annotations

import fnmatch
from pathlib import Path

import pytest

tomllib = pytest.importorskip("tomllib", reason="needs Python 3.11")

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]
FOLDERS = {name: ROOT / folder for name, folder in SETTINGS["package-dir"].items()}


def packages() -> dict[str, Path]:
    found = {}
    for name, folder in FOLDERS.items():
        for init in folder.rglob("__init__.py"):
            found[".".join([name, *init.parent.relative_to(folder).parts])] = init.parent
    return found


def test_every_package_is_listed() -> None:
    assert sorted(SETTINGS["packages"]) == sorted(packages())


@pytest.mark.parametrize("name", sorted(FOLDERS))
def test_every_data_file_is_listed(name: str) -> None:
    inside = {package: folder for package, folder in packages().items() if package == name or package.startswith(f"{name}.")}
    for path in FOLDERS[name].rglob("*"):
        if not path.is_file() or path.suffix in (".py", ".pyc") or any(part.startswith(".") for part in path.parts):
            continue
        owner = max((p for p, folder in inside.items() if path.is_relative_to(folder)), key=len)
        relative = path.relative_to(inside[owner]).as_posix()
        patterns = SETTINGS["package-data"].get(owner, [])
        assert any(fnmatch.fnmatch(relative, pattern.replace("**/*", "*")) for pattern in patterns), path
