"""The relations of a robot in the terminal: what each holds, its rows, the proof of a row, the source it is about."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

from rich.syntax import Syntax
from rich.text import Text
from textual import on
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.screen import Screen
from textual.widgets import DataTable, Footer, Input, OptionList, Static, Tree
from textual.widgets.option_list import Option
from textual.widgets.tree import TreeNode

from rosarch.base.files import folder_reader
from rosarch.cli.derivations import shorten
from rosarch.datalog import DatalogError, Program, Proof, RowStore, SourceLines, explain
from rosarch.datalog.inspection.proofs import AggregateValue, Premise
from rosarch.datalog.inspection.queries import Table, table_cells
from rosarch.datalog.inspection.relation_reference import Entry, reference
from rosarch.datalog.language.show import show_row
from rosarch.reports.printable import printable

MOST_ROWS = 1000  # that are shown at once: a filter finds the others
AROUND = 30  # lines shown before and after a place


@dataclass(frozen=True)
class Robot:
    """A component or a system to look at; `evaluate` derives its rows when it is first shown."""

    title: str
    root: Path
    program: Program
    evaluate: Callable[[], RowStore]

    @cached_property
    def store(self) -> RowStore:
        """The rows of all relations."""
        return self.evaluate()

    @cached_property
    def lines(self) -> SourceLines:
        """The places in the source."""
        return SourceLines(self.program, self.store, folder_reader(self.root))

    def cells(self, name: str) -> list[tuple[tuple[Any, ...], tuple[str, ...]]]:
        """The rows of a relation with their text."""
        rows = tuple(self.store.rows(name))
        attributes = self.program.relations[name].attributes
        table = Table(tuple(a.name for a in attributes), tuple(a.type for a in attributes), rows)
        return list(zip(rows, table_cells(table, self.program), strict=True))

    def row_text(self, name: str, row: tuple[Any, ...]) -> str:
        """A row as it is written in rules."""
        return show_row(name, row, [a.type for a in self.program.relations[name].attributes], self.program.types)


class SourceScreen(Screen[None]):
    """The source around a place."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,q", "app.pop_screen", "back")]

    def __init__(self, robot: Robot, path: str, line: int) -> None:
        super().__init__()
        self.robot, self.path, self.line = robot, path, line

    def compose(self) -> ComposeResult:
        """The lines, the one that is meant among them."""
        yield Static(f"{printable(self.path)}:{self.line}", classes="title", markup=False)
        text = self.robot.lines.read(self.path)
        with VerticalScroll():
            if text is None:
                yield Static("this file is not there any more", markup=False)
            else:
                span = max(1, self.line - AROUND), self.line + AROUND
                shown = "\n".join(printable(line) for line in text.splitlines())
                yield Static(Syntax(shown, "cpp", line_numbers=True, line_range=span, highlight_lines={self.line}))
        yield Footer()


class ProofScreen(Screen[None]):
    """The proof of a row as a tree to open and close; a row leads to its source."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,q", "app.pop_screen", "back"), Binding("s", "source", "source")]

    def __init__(self, robot: Robot, proof: Proof) -> None:
        super().__init__()
        self.robot, self.proof = robot, proof

    def compose(self) -> ComposeResult:
        """The tree, with the rule of the row under the cursor below it."""
        tree: Tree[Premise] = Tree(Text(printable(self.proof.text)), data=self.proof)
        self._grow(tree.root, self.proof)
        tree.root.expand()
        yield tree
        yield Static("", id="rule", markup=False)
        yield Footer()

    def _grow(self, node: TreeNode[Premise], proof: Proof) -> None:
        for premise in proof.premises:
            label = Text(printable(_text(premise)))
            if isinstance(premise, Proof) and premise.premises:
                node.add(label, data=premise)  # what is below is added when it is opened: proofs share their parts
            else:
                node.add_leaf(label, data=premise)

    @on(Tree.NodeExpanded)
    def opened(self, event: Tree.NodeExpanded[Premise]) -> None:
        """Show what a row rests on."""
        if isinstance(event.node.data, Proof) and not event.node.children:
            self._grow(event.node, event.node.data)

    @on(Tree.NodeHighlighted)
    def highlighted(self, event: Tree.NodeHighlighted[Premise]) -> None:
        """Show the rule that derives the row under the cursor."""
        data = event.node.data
        text = ""
        if isinstance(data, Proof):
            place = f"{shorten(data.location.path)}:{data.location.line}  " if data.location else f"{data.kind}  "
            text = place + data.rule
        self.query_one("#rule", Static).update(printable(text))

    def action_source(self) -> None:
        """Show the source that the row under the cursor is about."""
        node = self.query_one(Tree).cursor_node
        if node is not None and isinstance(node.data, Proof):
            show_source(self.app, self.robot, node.data.row)


def _text(premise: Premise) -> str:
    match premise:
        case Proof() if premise.location is None:
            return f"{premise.text}  {premise.kind}"
        case AggregateValue():
            return f"{premise.text} = {premise.value}"
        case _:
            return premise.text


def show_source(app: App[Any], robot: Robot, row: tuple[Any, ...]) -> None:
    """Show the source that a row is about, if it is about any."""
    place = robot.lines.place(row)
    if place is None:
        app.notify("no value of this row has a place in the source", severity="warning")
    else:
        app.push_screen(SourceScreen(robot, *place))


class Browser(App[None]):
    """Relations on the left, rows of the one that is chosen on the right."""

    TITLE = "rosarch browse"
    CSS = """
    #left { width: 38; border-right: solid $primary; }
    #about { height: auto; max-height: 12; padding: 0 1; }
    #count { height: 1; padding: 0 1; color: $text-muted; }
    #rule { height: auto; max-height: 10; padding: 0 1; border-top: solid $primary; }
    .title { background: $primary; padding: 0 1; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("ctrl+r", "focus_on('#relation-filter')", "relations"),
        Binding("ctrl+f", "focus_on('#row-filter')", "filter rows"),
        Binding("enter", "prove", "proof", show=True),
        Binding("ctrl+s", "source", "source"),
        Binding("ctrl+n", "next", "next component"),
        Binding("ctrl+q", "quit", "quit"),
    ]

    def __init__(self, robots: Sequence[Robot]) -> None:
        super().__init__()
        self.robots = list(robots)
        self.at = 0
        self.entries: dict[str, Entry] = {e.name: e for e in reference(robots[0].program)}
        self.relation = ""
        self.rows: list[tuple[tuple[Any, ...], tuple[str, ...]]] = []
        self.shown: list[tuple[Any, ...]] = []

    @property
    def robot(self) -> Robot:
        """The component or system that is looked at."""
        return self.robots[self.at]

    def compose(self) -> ComposeResult:
        """Both halves."""
        yield Static("", classes="title", id="title", markup=False)
        with Horizontal():
            with Vertical(id="left"):
                yield Input(placeholder="relations that contain ...", id="relation-filter")
                yield OptionList(id="relations", markup=False)
            with Vertical():
                yield Static("", id="about", markup=False)
                yield Input(placeholder="rows that contain ...", id="row-filter")
                yield Static("", id="count", markup=False)
                yield DataTable(id="rows", cursor_type="row", zebra_stripes=True)
        yield Footer()

    def on_mount(self) -> None:
        """Show the first component."""
        self._show_robot()

    def _show_robot(self) -> None:
        several = f"  ({self.at + 1} of {len(self.robots)})" if len(self.robots) > 1 else ""
        self.query_one("#title", Static).update(printable(self.robot.title) + several)
        self._list_relations(self.query_one("#relation-filter", Input).value)
        if self.relation:
            self._show_relation(self.relation)

    def _list_relations(self, part: str) -> None:
        options = self.query_one("#relations", OptionList)
        options.clear_options()
        names = [n for n in self.entries if part.lower() in n.lower() and n in self.robot.store.names]
        sized = [(self.robot.store.count(n), n) for n in names]
        order = sorted(sized, key=lambda item: (item[0] == 0, self.entries[item[1]].private, item[1]))
        options.add_options([Option(f"{count:>6}  {name}", id=name) for count, name in order])

    @on(Input.Changed, "#relation-filter")
    def filter_relations(self, event: Input.Changed) -> None:
        """List relations whose names contain what is typed."""
        self._list_relations(event.value)

    @on(OptionList.OptionHighlighted, "#relations")
    def choose(self, event: OptionList.OptionHighlighted) -> None:
        """Show the relation under the cursor."""
        if event.option_id is not None:
            self._show_relation(event.option_id)

    @on(OptionList.OptionSelected, "#relations")
    def enter(self) -> None:
        """Go to the rows."""
        self.query_one("#rows").focus()

    def _show_relation(self, name: str) -> None:
        self.relation = name
        entry = self.entries[name]
        signature = ", ".join(f"{a.name}: {a.type}" for a in entry.attributes)
        about = [f"{name}({signature})", f"{entry.kind}, {shorten(entry.path)}:{entry.line}", *entry.doc.splitlines()]
        self.query_one("#about", Static).update("\n".join(map(printable, about)))
        self.rows = self.robot.cells(name)
        table: DataTable[str] = self.query_one("#rows", DataTable)
        table.clear(columns=True)
        table.add_columns(*(a.name for a in entry.attributes))
        self._show_rows(self.query_one("#row-filter", Input).value)

    @on(Input.Changed, "#row-filter")
    def filter_rows(self, event: Input.Changed) -> None:
        """Show rows that contain what is typed."""
        self._show_rows(event.value)

    def _show_rows(self, part: str) -> None:
        found = [row for row in self.rows if any(part.lower() in cell.lower() for cell in row[1])] if part else self.rows
        self.shown = [row for row, _ in found[:MOST_ROWS]]
        table: DataTable[Text] = self.query_one("#rows", DataTable)
        table.clear()
        table.add_rows([[Text(printable(cell)) for cell in cells] for _, cells in found[:MOST_ROWS]])
        more = f", the first {MOST_ROWS} of them shown" if len(found) > MOST_ROWS else ""
        self.query_one("#count", Static).update(f"{len(found)} of {len(self.rows)} rows{more}" if part else f"{len(found)} rows{more}")

    @on(DataTable.RowSelected)
    def prove(self, event: DataTable.RowSelected) -> None:
        """Show why the row is there."""
        goal = self.robot.row_text(self.relation, self.shown[event.cursor_row])
        try:
            proof = explain(self.robot.program, self.robot.store, goal)
        except DatalogError as error:
            self.notify(str(error), severity="error", markup=False)
            return
        self.push_screen(ProofScreen(self.robot, proof))

    def action_source(self) -> None:
        """Show the source that the row under the cursor is about."""
        at = self.query_one("#rows", DataTable).cursor_row
        if 0 <= at < len(self.shown):
            show_source(self, self.robot, self.shown[at])

    def action_next(self) -> None:
        """Look at the next component."""
        self.at = (self.at + 1) % len(self.robots)
        self._show_robot()

    def action_focus_on(self, selector: str) -> None:
        """Go to a field."""
        self.query_one(selector).focus()
