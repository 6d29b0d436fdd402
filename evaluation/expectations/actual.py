"""What rosarch finds in a workspace or in single sources, as far as expectations ask for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

from rosarch.base.limits import LIMITS
from rosarch.datalog import DatalogError, Program, Result, RowStore, query, why_not
from rosarch.datalog.inspection.queries import check_query, table_cells
from rosarch.datalog.language.values import symbols
from rosarch.evaluation.expectations.comments import Marked
from rosarch.evaluation.expectations.elements import Element, elements, finding_element
from rosarch.evaluation.expectations.judgement import PlacedRow
from rosarch.extractor.pipeline import ComponentFacts, Extraction
from rosarch.findings.model import Finding
from rosarch.models.component import ComponentModel, build_model, to_json

_MOST = 3
_SOURCES = frozenset({".c", ".cc", ".cpp", ".cxx", ".c++", ".cu", ".h", ".hh", ".hpp", ".hxx", ".inl", ".ipp", ".tpp", ".py"})


@dataclass
class ObservedComponent:
    """A component with the rows that rules derive of it."""

    facts: ComponentFacts
    program: Program
    engine: str
    system: str

    @cached_property
    def rows(self) -> dict[str, Any]:
        """Its facts."""
        return {name: list(rows) for name, rows in self.facts.rows().items()}

    @cached_property
    def result(self) -> Result:
        """The rows of all relations."""
        return self.program.evaluate(self.rows, engine=self.engine, keep="all", time_limit=LIMITS.evaluation)

    @cached_property
    def store(self) -> RowStore:
        """All rows, those of facts too."""
        return RowStore(self.result, self.rows)

    @cached_property
    def model(self) -> ComponentModel:
        """Its model."""
        found = {name: self.result.rows(name) for name in self.program.outputs}
        return build_model(self.system, self.facts.name, self.facts.package, self.facts.kind, self.facts.sources, found)

    @cached_property
    def elements(self) -> tuple[Element, ...]:
        """The elements of its model."""
        return tuple(elements(to_json(self.model)))

    @cached_property
    def sources(self) -> frozenset[str]:
        """The sources that it is made of, those of libraries too."""
        return frozenset(path for _, path in self.rows.get("source_file", ()))


class Systems(Protocol):
    """What is known about the systems of a case."""

    def findings(self, models: Sequence[ComponentModel]) -> Sequence[Finding]:
        """What checks find; `models` are those of the components of the case."""

    def findings_with(self, models: Sequence[ComponentModel]) -> Sequence[Finding]:
        """What checks would find if the components of the case that are among `models` were so; found in this process."""

    def rows(self) -> Sequence[dict[str, list[tuple[Any, ...]]]]:
        """The facts about each system."""

    @property
    def program(self) -> Program:
        """The rules of systems."""


@dataclass
class ActualWorkspace:
    """What is found below `root`, or is `supposed` to be; the systems there are looked at when they are asked for."""

    root: Path
    extraction: Extraction
    program: Program
    engine: str
    systems: Systems
    supposed: bool = False
    components: list[ObservedComponent] = field(init=False)

    def __post_init__(self) -> None:
        name = self.root.resolve().name
        self.components = [ObservedComponent(facts, self.program, self.engine, name) for facts in self.extraction.components]

    def with_component(self, component: ObservedComponent, other: ObservedComponent) -> ActualWorkspace:
        """What would be found if there were another in the place of a component."""
        seen = replace(self, supposed=True)
        seen.components = [other if each is component else each for each in self.components]
        return seen

    def of(self, path: str) -> list[ObservedComponent]:
        """The components that a file is a source of; all where it is a source of none."""
        return [component for component in self.components if path in component.sources] or self.components

    def elements(self, path: str) -> list[Element]:
        """The elements of the components that a file is a source of."""
        return [element for component in self.of(path) for element in component.elements]

    @cached_property
    def _findings(self) -> tuple[Element, ...]:
        find = self.systems.findings_with if self.supposed else self.systems.findings
        return tuple(map(finding_element, find([component.model for component in self.components])))

    def findings(self) -> tuple[Element, ...]:
        """All that checks found."""
        return self._findings

    def rows(self, marked: Marked, text: str) -> list[str]:
        """The rows that answer a query in a component that the file is a source of."""
        found = []
        for program, store in self._stores(marked.path):
            table = query(program, store, text)
            found += [_row_text(table.columns, cells) or "it holds" for cells in table_cells(table, program)]
        return found

    def placed_rows(self, marked: Marked, text: str) -> list[PlacedRow]:
        """The rows that answer a query in a component that the file is a source of, and lie in it."""
        found = []
        for program, store in self._stores(marked.path):
            files = {file for file, path in store.rows("source_file") if path == marked.path}
            lines = {node: line for node, file, line, _ in store.rows("location") if file in files}
            table = query(program, store, text)
            for row, cells in zip(table.rows, table_cells(table, program), strict=True):
                line = next((lines[value] for value in symbols(row) if value in lines), None)
                if line is not None:
                    found.append(PlacedRow(_row_text(table.columns, cells), line))
        return found

    def near_rows(self, marked: Marked, text: str) -> list[str]:
        """The rows nearest to the one that a query is about; none where it is about several."""
        found: list[str] = []
        for program, store in self._stores(marked.path):
            try:
                found += why_not(program, store, text).nearest
            except DatalogError:
                return []  # a query that is no row with `_`
        return list(dict.fromkeys(found))[:_MOST]

    def _stores(self, path: str) -> list[tuple[Program, RowStore]]:
        """The rows that a query in a file is about: of components in a source, of systems in a launch file."""
        if is_source(path):
            return [(self.program, component.store) for component in self.of(path)]
        return [(self.systems.program, store) for store in self._systems]

    @cached_property
    def _systems(self) -> list[RowStore]:
        return [RowStore(self.systems.program.evaluate(rows, engine=self.engine, keep="all"), rows) for rows in self.systems.rows()]


def _row_text(columns: Sequence[str], cells: Sequence[str]) -> str:
    """A row as text."""
    return ", ".join(f"{name} = {cell}" for name, cell in zip(columns, cells, strict=True))


def is_source(path: str) -> bool:
    """Whether a file is about components, as C++ is."""
    return Path(path).suffix.lower() in _SOURCES


def require_query(program: Program, marked: Marked, text: str) -> str:
    """What is wrong with a query, "" when nothing is."""
    try:
        check_query(program, text)
    except DatalogError as error:
        diagnostic = error.diagnostics[0]
        column = marked.text_column + (diagnostic.location.column - 1 if diagnostic.location else 0)
        hint = f", {diagnostic.hint}" if diagnostic.hint else ""
        return f"{marked.path}:{marked.line}:{column}: {diagnostic.message}{hint}"
    return ""
