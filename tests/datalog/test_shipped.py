"""Programs that were compiled when they were installed: taken wherever they lie, and never when anything has changed since."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from rosarch.datalog import DatalogError, Program, is_compiled, load_program, ship_program
from rosarch.datalog import program as programs
from rosarch.datalog.engine import shipped as shipping

RULES = '.decl edge(a: symbol, b: symbol)\n.input edge\n.include "more/path.dl"\n'
PATHS = (
    ".decl path(a: symbol, b: symbol)\n.output path\npath(A, B) :- edge(A, B).\npath(A, C) :- path(A, B), edge(B, C).\n"
    '.decl bad(n: number)\n.output bad\nbad(to_number(A)) :- edge(A, "bad").\n'
)
EDGES = {"edge": [("a", "b"), ("b", "c")]}


@pytest.fixture
def installed(tmp_path: Path) -> Path:
    """A folder of rules that was moved after its rules were compiled."""
    made = tmp_path / "made"
    (made / "more").mkdir(parents=True)
    (made / "main.dl").write_text(RULES)
    (made / "more" / "path.dl").write_text(PATHS)
    ship_program(made / "compiled" / "main.pickle", [made / "main.dl"])
    return Path(shutil.move(made, tmp_path / "installed"))


@pytest.fixture
def compilations(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The programs that were compiled since."""
    found: list[Path] = []
    compiled: Callable[..., object] = programs._compiled

    def recording(paths: list[Path], *rest: object) -> object:
        found.append(paths[0])
        return compiled(paths, *rest)

    monkeypatch.setattr(programs, "_compiled", recording)
    return found


def load(folder: Path) -> Program:
    return load_program([folder / "main.dl"], shipped=folder / "compiled" / "main.pickle")


def is_stored(folder: Path) -> bool:
    return is_compiled([folder / "main.dl"], shipped=folder / "compiled" / "main.pickle")


def test_it_is_taken_where_it_lies_now(installed: Path, compilations: list[Path]) -> None:
    assert is_stored(installed)
    program = load(installed)
    assert program.evaluate(EDGES).rows("path") == [("a", "b"), ("a", "c"), ("b", "c")]
    assert not compilations
    assert sorted(program.sources) == [str(installed / "main.dl"), str(installed / "more" / "path.dl")]
    assert program.relations["path"].location == (str(installed / "more" / "path.dl"), 1, 7)
    with pytest.raises(DatalogError) as caught:
        program.evaluate({"edge": [("x", "bad")]})
    assert str(caught.value).startswith(f"{installed}/more/path.dl:7:1: ")


def edit(folder: Path, _patch: pytest.MonkeyPatch) -> None:
    with (folder / "more" / "path.dl").open("a") as file:
        file.write('path("new", "rule").\n')


def other_engine(_folder: Path, patch: pytest.MonkeyPatch) -> None:
    patch.setattr(shipping, "engine_source", lambda: "another")


def damage(folder: Path, _patch: pytest.MonkeyPatch) -> None:
    file = folder / "compiled" / "main.pickle"
    file.write_bytes(file.read_bytes()[:1000])


def remove(folder: Path, _patch: pytest.MonkeyPatch) -> None:
    (folder / "compiled" / "main.pickle").unlink()


@pytest.mark.parametrize("change", [edit, other_engine, damage, remove])
def test_it_is_not_taken_when_something_has_changed(
    change: Callable[[Path, pytest.MonkeyPatch], None], installed: Path, compilations: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    change(installed, monkeypatch)
    if change is not damage:  # whether the rest of a file is whole, only reading it tells
        assert not is_stored(installed)
    rows = load(installed).evaluate(EDGES).rows("path")
    assert compilations == [installed / "main.dl"]
    assert (("new", "rule") in rows) == (change is edit)
    assert is_stored(installed)  # kept by now, for the next run
    load(installed)
    assert len(compilations) == 1


def test_other_roots_are_another_program(installed: Path, compilations: list[Path]) -> None:
    (installed / "check.dl").write_text('path("of", "check").\n')
    program = load_program([installed / "main.dl", installed / "check.dl"], shipped=installed / "compiled" / "main.pickle")
    assert ("of", "check") in program.evaluate(EDGES).rows("path")
    assert len(compilations) == 1


def test_another_python_compiles_the_functions_only(installed: Path, compilations: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    found = shipping.read_shipped

    def of_another(*arguments: object) -> object:
        program, _, digests = found(*arguments)  # type: ignore[arg-type, misc]
        program.bytecode = b""
        return program, "another Python", digests

    monkeypatch.setattr(programs, "read_shipped", of_another)
    assert load(installed).evaluate(EDGES).count("path") == 3
    monkeypatch.undo()
    (installed / "compiled" / "main.pickle").unlink()
    assert load(installed).evaluate(EDGES).count("path") == 3  # kept
    assert not compilations


def test_it_is_compiled_once(installed: Path, compilations: list[Path]) -> None:
    file = installed / "compiled" / "main.pickle"
    ship_program(file, [installed / "main.dl"])
    assert not compilations
    edit(installed, pytest.MonkeyPatch())
    ship_program(file, [installed / "main.dl"])
    assert len(compilations) == 1
    assert is_stored(installed)


def test_a_program_of_files_elsewhere_is_not_shipped(tmp_path: Path) -> None:
    (tmp_path / "rules").mkdir()
    (tmp_path / "rules" / "main.dl").write_text(f'.include "{tmp_path}/facts.dl"\n')
    (tmp_path / "facts.dl").write_text('.decl known(a: symbol)\nknown("x").\n')
    with pytest.raises(ValueError, match="depends on where"):
        ship_program(tmp_path / "main.pickle", [tmp_path / "rules" / "main.dl"])
