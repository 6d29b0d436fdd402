"""`rosarch language-server`: rules while they are written, in any editor that speaks the Language Server Protocol."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.cli.errors import InputError

if TYPE_CHECKING:
    from rosarch.datalog.editor.programs import Entry


def language_server() -> None:
    """Run the language server for rule files on stdin and stdout; editors start it themselves (docs/editor.md)."""
    from importlib.metadata import version

    try:
        from rosarch.datalog.editor.server import serve
    except ImportError as error:
        raise InputError(f"the language server needs {error.name}: pip install '.[interactive]' in the checkout of rosarch") from None
    serve(version("rosarch"), entries)


def entries(path: Path) -> list[Entry]:
    """The programs that a rule file may be part of: one of rosarch's, one of them with it, itself, or with its neighbours."""
    from rosarch.datalog.editor.programs import Entry
    from rosarch.extractor.manifest import rules_folder
    from rosarch.rule_programs.sets import roots
    from rosarch.rule_programs.variants import decisions

    programs = {name: tuple(roots(name)) for name in ("component", "system")}
    decision = next(
        (d for d in decisions() if d.name == path.parent.name and path.parent.parent.name == d.default.parent.parent.name), None
    )
    if decision is not None:
        return [Entry(programs[decision.program], ((decision.default, path),))]
    if path.is_relative_to(rules_folder()):
        return [Entry(program) for program in programs.values()]
    beside = sorted(p for p in path.parent.glob("*.dl") if p != path)
    alone = [*((*program, path) for program in programs.values()), (path,)]
    return [Entry(each) for each in (*alone, *((*program, path, *beside) for program in programs.values() if beside))]
