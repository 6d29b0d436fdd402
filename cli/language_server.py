"""`rosarch language-server`: rules while they are written, in any editor that speaks the Language Server Protocol."""

from __future__ import annotations

from pathlib import Path

from rosarch.cli.errors import InputError


def language_server() -> None:
    """Serve the Language Server Protocol on stdin and stdout, for rule files; editors start this themselves (docs/editor.md)."""
    from importlib.metadata import version

    try:
        from rosarch.datalog.editor.server import serve
    except ImportError as error:
        raise InputError(f"the language server needs {error.name}: pip install 'rosarch[interactive]'") from None
    serve(version("rosarch"), entries)


def entries(path: Path) -> list[tuple[Path, ...]]:
    """The programs that a rule file may be part of: one of rosarch's, one of them with it, itself, or with its neighbours."""
    from rosarch.extractor.manifest import rules_folder
    from rosarch.models.checks import check_files

    programs = [(rules_folder() / "component.dl",), (rules_folder() / "system.dl", *check_files())]
    if path.is_relative_to(rules_folder()):
        return programs
    beside = sorted(p for p in path.parent.glob("*.dl") if p != path)
    return [*((*program, path) for program in programs), (path,), *((*program, path, *beside) for program in programs if beside)]
