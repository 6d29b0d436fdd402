"""Every folder of Python and every data file of the packages is installed, and imports follow the layers."""

from __future__ import annotations

import ast
import fnmatch
from collections.abc import Iterator
from pathlib import Path

import pytest

tomllib = pytest.importorskip("tomllib", reason="needs Python 3.11")

ROOT = Path(__file__).resolve().parents[2]
DATA = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]["package-data"]
# from the first to the last: a package imports those before it, never those behind it
LAYERS = (
    *("base", "rules", "datalog", "extractor", "rule_programs", "models", "library", "findings", "analysis"),
    *("behavior", "observation", "evaluation", "reports", "cli"),
)
NO_PACKAGES = {"benchmarks", "docs", "examples", "tests"}


def packages(top: str) -> dict[str, Path]:
    """The packages below a top folder, by their names."""
    return {".".join(init.parent.relative_to(ROOT).parts): init.parent for init in (ROOT / top).rglob("__init__.py")}


def files(top: str) -> Iterator[Path]:
    """What is installed of a top folder: not what is for readers of the sources only."""
    for path in sorted((ROOT / top).rglob("*")):
        if (
            path.is_file()
            and path.name != "README.md"
            and not any(part.startswith(".") or part in ("viewer", "__pycache__") for part in path.parts)
        ):
            yield path


def imported(path: Path) -> Iterator[str]:
    """The packages of rosarch that a module imports anywhere."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom):
            assert not node.level, f"{path}:{node.lineno}: imports are absolute"
            names = [f"rosarch.{alias.name}" for alias in node.names] if node.module == "rosarch" else [node.module or ""]
        yield from (name.split(".")[1] for name in names if name.startswith("rosarch."))


def test_every_top_folder_with_modules_has_a_layer() -> None:
    tops = {path.parent.name for path in ROOT.glob("*/__init__.py")}
    assert tops - NO_PACKAGES == set(LAYERS)


@pytest.mark.parametrize("top", LAYERS)
def test_every_file_is_installed(top: str) -> None:
    inside = packages(top)
    for path in files(top):
        if path.name == "README.md":
            continue  # for who reads the repository
        owner = max((name for name, folder in inside.items() if path.is_relative_to(folder)), key=len)
        relative = path.relative_to(inside[owner]).as_posix()
        if path.suffix == ".py":
            assert "/" not in relative, f"{path.parent} has no __init__.py"
        else:
            patterns = DATA.get(f"rosarch.{owner}", [])
            assert any(fnmatch.fnmatch(relative, pattern.replace("**/*", "*")) for pattern in patterns), path


@pytest.mark.slow
@pytest.mark.parametrize("top", LAYERS)
def test_imports_follow_the_layers(top: str) -> None:
    behind = set(LAYERS[LAYERS.index(top) + 1 :])
    for path in files(top):
        if path.suffix == ".py":
            assert not behind & set(imported(path)), path
