"""`rosarch browse`, driven by key presses as at a terminal."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import DataTable, OptionList, Static, Tree

from rosarch.cli.browser import Browser, ProofScreen, Robot, SourceScreen
from rosarch.cli.main import main
from rosarch.datalog import RowStore, load_program

RULES = """\
.decl source_file(file: symbol, path: symbol)
.input source_file
.decl location(node: symbol, file: symbol, line: number, column: number)
.input location
/// `node` calls `name`.
.decl call(node: symbol, name: symbol)
.input call
/// A call of the API. Must.
.decl api_call(node: symbol)
api_call(N) :- call(N, "advertise"), !_hidden(N).
.decl _hidden(node: symbol)
_hidden("none") :- call(_, "hide").
"""
SOURCE = "int main() {\n  advertise(\x1b[31m);\n}\n"


def robots(tmp_path: Path, count: int = 1) -> list[Robot]:
    (tmp_path / "rules.dl").write_text(RULES)
    (tmp_path / "a.cpp").write_text(SOURCE)
    program = load_program(tmp_path / "rules.dl")
    facts = {
        "source_file": [("f", "a.cpp")],
        "location": [("c1", "f", 2, 3)],
        "call": [("c1", "advertise"), ("c2", "[bold]spin\x1b[31m")],
    }
    return [Robot(f"robot {i}", tmp_path, program, lambda: RowStore(program.evaluate(facts, keep="all"), facts)) for i in range(count)]


def drive(app: Browser, script: Callable[[Pilot[None]], Awaitable[None]]) -> None:
    async def run() -> None:
        async with app.run_test(size=(120, 40)) as pilot:
            await pilot.pause()
            await script(pilot)

    asyncio.run(run())


def shown(app: Browser, selector: str) -> str:
    return str(app.screen.query_one(selector, Static).render())


async def choose(app: Browser, pilot: Pilot[None], name: str) -> None:
    options = app.query_one("#relations", OptionList)
    options.highlighted = options.get_option_index(name)
    await pilot.pause()


def test_relations_with_docs_and_rows(tmp_path: Path) -> None:
    """The relations with rows come first; one is shown with its documentation, columns and rows, control characters escaped."""
    app = Browser(robots(tmp_path))

    async def script(pilot: Pilot[None]) -> None:
        options = app.query_one("#relations", OptionList)
        names = [options.get_option_at_index(i).id for i in range(options.option_count)]
        assert names == ["api_call", "call", "location", "source_file", "_hidden"]
        await choose(app, pilot, "call")
        assert "call(node: symbol, name: symbol)" in shown(app, "#about") and "`node` calls `name`." in shown(app, "#about")
        table = app.query_one("#rows", DataTable)
        assert [str(cell) for cell in table.get_row_at(1)] == ["c2", "[bold]spin\\x1b[31m"] and shown(app, "#count") == "2 rows"

    drive(app, script)


def test_filters(tmp_path: Path) -> None:
    """What is typed into the fields leaves fewer relations, and fewer rows."""
    app = Browser(robots(tmp_path))

    async def script(pilot: Pilot[None]) -> None:
        await pilot.press("ctrl+r", *"all")
        assert app.query_one("#relations", OptionList).option_count == 2
        await choose(app, pilot, "call")
        await pilot.press("ctrl+f", *"ADV")
        assert app.query_one("#rows", DataTable).row_count == 1 and shown(app, "#count") == "1 of 2 rows"

    drive(app, script)


@pytest.mark.slow
def test_proof_and_source(tmp_path: Path) -> None:
    """A row leads to its proof, a row of the proof to its rule and to the source."""
    app = Browser(robots(tmp_path))

    async def script(pilot: Pilot[None]) -> None:
        await choose(app, pilot, "api_call")
        app.query_one("#rows").focus()
        await pilot.press("enter")
        await pilot.pause()
        assert isinstance(app.screen, ProofScreen)
        tree = app.screen.query_one(Tree)
        assert [str(n.label) for n in tree.root.children] == ['call("c1", "advertise")  input', '!_hidden("c1")']
        assert 'rules.dl:10  api_call(N) :- call(N, "advertise"), !_hidden(N).' in shown(app, "#rule")
        await pilot.press("s")
        await pilot.pause()
        assert isinstance(app.screen, SourceScreen) and (app.screen.path, app.screen.line) == ("a.cpp", 2)
        await pilot.press("escape", "escape")
        await pilot.pause()
        assert not isinstance(app.screen, (ProofScreen, SourceScreen))
        await pilot.press("ctrl+s")
        await pilot.pause()
        assert isinstance(app.screen, SourceScreen)

    drive(app, script)


def test_a_row_without_a_place_and_the_next_component(tmp_path: Path) -> None:
    """Where there is no source to show, it says so; the next component keeps the relation that is looked at."""
    app = Browser(robots(tmp_path, 2))

    async def script(pilot: Pilot[None]) -> None:
        await choose(app, pilot, "source_file")
        app.query_one("#rows").focus()
        await pilot.press("ctrl+s")
        await pilot.pause()
        assert not isinstance(app.screen, SourceScreen)
        assert [n.message for n in app._notifications] == ["no value of this row has a place in the source"]
        await pilot.press("ctrl+n")
        await pilot.pause()
        assert shown(app, "#title") == "robot 1  (2 of 2)" and app.relation == "source_file"

    drive(app, script)


def test_not_at_a_terminal(capsys: object) -> None:
    """Without a terminal there is nothing to browse with."""
    assert main(["browse", "examples/mobile_base"]) == 2
    assert capsys.readouterr().err == "rosarch: error: browse is for a terminal; rosarch query prints rows\n"  # type: ignore[attr-defined]
