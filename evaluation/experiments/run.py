"""Evaluating configurations of the rules on the facts of subjects; what was evaluated before is taken from a cache."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from rosarch.base.cache import Cache, hash_of, version_of_packages
from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.datalog import Program
from rosarch.datalog.language.values import ValueWriter, symbols
from rosarch.evaluation.experiments.comparison import Document
from rosarch.evaluation.experiments.subjects import OpenSubject
from rosarch.extractor.stored_facts import Facts
from rosarch.models.component import build_models, to_json
from rosarch.rule_programs.sets import SHIPPED, RuleSet

Row = tuple[str, str]
"""A row as text and its place, `path:line` or ""."""


@dataclass(frozen=True)
class Configuration:
    """A way to analyse: `program` is made of `rules`; rows of the relations in `kept` are kept."""

    name: str
    program: Program
    kept: tuple[str, ...]
    rules: RuleSet = SHIPPED


@dataclass(frozen=True)
class Evaluated:
    """What a configuration makes of a component: its models (see `build_models`), rows of relations, and the processor time it took."""

    models: tuple[Document, ...]
    rows: Mapping[str, tuple[Row, ...]]
    seconds: float

    def model(self, component: str) -> Document:
        """The model of the component, or of one of its nodes; an empty one when it has no such node."""
        return next((model for model in self.models if model["component"] == component), {})


@dataclass(frozen=True)
class Cell:
    """A component of a subject under a configuration."""

    subject: OpenSubject
    facts: Facts
    configuration: Configuration

    def key(self, engine: str) -> str:
        """A hash of all that the result depends on."""
        names = (self.subject.subject.name, self.facts.package, self.facts.name)
        return hash_of(
            ["experiment", _version(), engine, self.configuration.program.hash, *self.configuration.kept, *names, self.facts.key]
        )


@dataclass(frozen=True)
class Runner:
    """How cells are evaluated. `progress` is called with how many are done, of how many."""

    engine: str = "embedded"
    jobs: int | None = None
    cache: Cache | None = None
    progress: Callable[[str, int, int], None] | None = None

    def run(self, cells: Sequence[Cell]) -> Iterator[tuple[Cell, Evaluated | Failure]]:
        """What becomes of each cell, in no particular order; each is kept as soon as it is done."""
        waiting = []
        done = 0
        for cell in cells:
            known = self._load(cell)
            if known is None:
                waiting.append(cell)
                continue
            done += 1
            yield cell, known
        self._report_progress(done, len(cells))
        for program in {id(cell.configuration.program): cell.configuration.program for cell in waiting}.values():
            program.evaluate({})  # what workers share is made once, before they are forked

        def work(index: int) -> bytes:
            return _evaluate(waiting[index], self.engine)

        for index, outcome in run_tasks(work, range(len(waiting)), jobs=self.jobs or default_jobs(), timeout=LIMITS.evaluation):
            done += 1
            self._report_progress(done, len(cells))
            if isinstance(outcome, Failure):
                yield waiting[index], outcome
            else:
                if self.cache:
                    self.cache.store(waiting[index].key(self.engine), outcome)
                yield waiting[index], _evaluated(outcome)
        if self.cache and waiting:
            self.cache.trim()

    def _load(self, cell: Cell) -> Evaluated | None:
        data = self.cache.load(cell.key(self.engine)) if self.cache else None
        return _evaluated(data) if data is not None else None

    def _report_progress(self, done: int, total: int) -> None:
        if self.progress:
            self.progress("components", done, total)


def _evaluate(cell: Cell, engine: str) -> bytes:
    """Evaluate a cell, as it is kept."""
    facts = cell.facts.rows()
    start = sum(os.times()[:4])  # of this process and those it starts: the time on the clock depends on what else runs
    result = cell.configuration.program.evaluate(facts, engine=engine, keep=cell.configuration.kept)
    seconds = sum(os.times()[:4]) - start
    found = result.all_rows()
    component = cell.facts
    models = build_models(cell.subject.subject.name, component.name, component.package, component.kind, component.sources, found)
    return json.dumps([list(map(to_json, models)), _texts(cell.configuration.program, found, facts), seconds]).encode()


def _evaluated(data: bytes) -> Evaluated:
    models, rows, seconds = json.loads(data)
    return Evaluated(tuple(models), {name: tuple((text, at) for text, at in found) for name, found in rows.items()}, seconds)


def _texts(
    program: Program, found: Mapping[str, Sequence[tuple[Any, ...]]], facts: Mapping[str, Iterable[tuple[Any, ...]]]
) -> dict[str, list[Row]]:
    """Rows as texts, each with the place of the first thing in it that has one."""
    show = ValueWriter(program.types).show
    files = {key: path for key, path in facts.get("source_file", ())}
    nodes = {value for rows in found.values() for row in rows for value in symbols(row)}
    places = {node: f"{files[file]}:{line}" for node, file, line, _ in facts.get("location", ()) if node in nodes and file in files}
    texts = {}
    for name, rows in found.items():
        types = [attribute.type for attribute in program.relations[name].attributes]
        texts[name] = [
            (
                ", ".join(show(value, type_) for value, type_ in zip(row, types, strict=True)),
                next((places[value] for value in symbols(row) if value in places), ""),
            )
            for row in rows
        ]
    return texts


@lru_cache(maxsize=1)
def _version() -> str:
    """A hash of all but facts and rules that results depend on: the engine, and what makes models of rows."""
    return version_of_packages("analysis", "base", "datalog", "evaluation", "models", "rule_programs")
