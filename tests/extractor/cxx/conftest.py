"""C++ snippets in, rows out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import pytest

from rosarch.base.diagnostics import SourceProblem
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, build_prelude, extract_unit
from rosarch.extractor.cxx.unit import file_key
from rosarch.extractor.facts import validate

Row = tuple[str | int, ...]


class Snippet:
    """The rows of one source; identifiers lose their file, `n.cpp#1a2b:3:5:call` reads `3:5:call`. `problems` tell what was lost."""

    def __init__(self, rows: Mapping[str, set[Row]], path: str, problems: Sequence[SourceProblem] = ()) -> None:
        self.raw = rows
        self.problems = problems
        self.key = file_key(path)
        self.path = path

    def _short(self, value: str | int) -> str | int:
        return value.replace(f"@{self.key}", "@").replace(f"{self.key}:", "").replace(self.key, "@") if isinstance(value, str) else value

    def __getitem__(self, relation: str) -> list[Row]:
        """The rows of a relation, sorted, with short identifiers."""
        return sorted(tuple(self._short(value) for value in row) for row in self.raw.get(relation, ()))

    def one(self, relation: str, key: str | int, column: int = 1) -> str | int:
        """The value in `column` of the only row that begins with `key`."""
        (row,) = [row for row in self[relation] if row[0] == key]
        return row[column]

    def all(self, relation: str, key: str | int) -> list[Row]:
        """What follows `key` in the rows that begin with it."""
        return [row[1:] for row in self[relation] if row[0] == key]

    def calls(self) -> dict[str, str]:
        """Callee by call, in source order: qualified name, else `?name`."""
        names = dict(self["function_name"])
        functions: dict[str, list[str]] = {}
        for call, function in self["call_function"]:
            functions.setdefault(str(call), []).append(str(names[function]))
        found = {str(call): "|".join(functions.get(str(call), [f"?{name}"])) for call, name in self["call"]}
        return dict(sorted(found.items(), key=lambda item: position(item[0])))

    def callees(self) -> list[str]:
        """The names of all callees in source order."""
        return list(self.calls().values())

    def call(self, name: str) -> str:
        """The only call of something named `name`."""
        (found,) = [call for call, called in self["call"] if called == name]
        return str(found)

    def arguments(self, call: str) -> list[str]:
        """The arguments of a call, by index."""
        found = sorted((index, argument) for index, argument in self.all("call_argument", call))
        assert [index for index, _ in found] == list(range(len(found)))
        return [str(argument) for _, argument in found]

    def show(self, expr: str | int) -> str:
        """An expression as canonical text, from its rows alone."""
        return _Printer(self).show(str(expr))

    def flow(self, function: str) -> str:
        """The control-flow graph of the function called `function`, one block a line, as `flow_text` writes it."""
        (identifier,) = [row[0] for row in self["function_name"] if row[1] == function and (row[0],) in self["function_defined"]]
        return flow_text(self, str(identifier))


def position(identifier: str) -> tuple[int, int, str]:
    """Line and column of a short identifier; those without come first."""
    parts = identifier.split(":")
    return (
        (int(parts[0]), int(parts[1]), identifier) if len(parts) > 2 and parts[0].isdigit() and parts[1].isdigit() else (0, 0, identifier)
    )


class _Printer:
    def __init__(self, facts: Snippet) -> None:
        self.facts = facts
        self.names = {row[0]: row[1] for row in facts["variable_name"]}
        self.functions = {row[0]: row[1] for row in facts["function_name"]}

    def show(self, expr: str) -> str:
        facts = self.facts
        for kind, value in facts.all("literal", expr):
            return f'"{value}"' if kind == "string" else str(value)
        for (variable,) in facts.all("variable_use", expr):
            objects = [self.show(str(base)) + "." for (base,) in facts.all("field_object", expr)]
            return "".join(o for o in objects if o != "this.") + str(self.names[variable])
        if facts.all("this_use", expr):
            return "this"
        for (function,) in facts.all("lambda", expr):
            return f"lambda {str(function).partition('@')[2].lstrip(':')}"
        uses = facts.all("function_use", expr)
        if uses:
            return "&" + "|".join(sorted(str(self.functions[function]) for (function,) in uses))
        for (name,) in facts.all("call", expr):
            if not facts.all("operator", expr):
                receiver = [self.show(str(r)) + "." for (r,) in facts.all("call_receiver", expr)]
                arguments = ", ".join(self.show(a) for a in facts.arguments(expr))
                return f"{''.join(r for r in receiver if r != 'this.')}{name}({arguments})"
        for (operator,) in facts.all("operator", expr):
            parts = [self.show(str(o)) for _, o in sorted(facts.all("operand", expr))]
            if len(parts) == 2 and operator not in ("()", "[]", "{}"):
                return f"({parts[0]} {operator} {parts[1]})"
            return f"{operator}({', '.join(parts)})"
        return "?" + ",".join(str(reason) for (reason,) in facts.all("expr_unknown", expr))


def flow_text(facts: Snippet, function: str) -> str:
    """Blocks numbered in the order of a breadth-first walk: `0: what is evaluated ? condition [loop] -> label target`.

    Reads of variables are left out; blocks that no path from the entry reaches follow as `unreached`.
    """
    (entry,) = [block for block, owner in facts["block_entry"] if owner == function]
    (exit_,) = [block for block, owner in facts["block_exit"] if owner == function]
    edges: dict[str, list[tuple[str, str]]] = {}
    values = {(block, target): value for block, target, value in facts["block_case"]}
    for block, target, label in facts["block_edge"]:
        if label == "case":
            label = f"case {facts.show(values[block, target])}"
        edges.setdefault(str(block), []).append((str(label), str(target)))
    order, queue = [str(entry)], [str(entry)]
    while queue:
        for _, target in sorted(edges.get(queue.pop(0), ()), key=lambda edge: (edge[0], _number(edge[1]))):
            if target not in order:
                order.append(target)
                queue.append(target)
    order = [block for block in order if block != exit_]
    owned = [str(block) for block, owner in facts["block"] if owner == function and block != exit_]
    rest = sorted((block for block in owned if block not in order), key=_number)
    names = {block: str(index) for index, block in enumerate(order + rest)} | {str(exit_): "exit"}
    lines = []
    for block in order + rest:
        acts = [
            facts.show(expr)
            for _, expr in sorted(facts.all("block_expr", block))
            if not str(expr).split("'")[0].endswith((":use", " this"))
        ]
        conditions = "".join(f" ? {facts.show(expr)}" for (expr,) in facts.all("block_condition", block))
        loops = "".join(f" [{kind}]" for (kind,) in facts.all("loop_head", block))
        targets = ", ".join(f"{label} {names[target]}" for label, target in sorted(edges.get(block, ()), key=lambda e: (e[0], names[e[1]])))
        mark = " unreached" if block in rest else ""
        lines.append(f"{names[block]}:{mark} {'; '.join(acts)}{conditions}{loops} -> {targets}".replace(":  ", ": "))
    return "\n".join(lines)


def _number(block: str) -> int:
    return int(block.rpartition(" B")[2])


@pytest.fixture(scope="session")
def prelude(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("prelude") / "prelude.pch"
    build_prelude(path)
    return path


@pytest.fixture
def extract(tmp_path: Path, prelude: Path) -> Callable[..., Snippet]:
    """Extract a source of a small tree of files; every row is checked against the schema."""
    root = tmp_path / "src"
    finder = HeaderFinder(root, tmp_path / "scratch", lambda _name: None)

    def extract_one(
        source: str | bytes, path: str = "n.cpp", files: Mapping[str, str] | None = None, **options: tuple[str, ...]
    ) -> Snippet:
        for name, text in {**(files or {}), path: source}.items():
            target = root / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(text if isinstance(text, bytes) else text.encode())
        problems: list[SourceProblem] = []
        rows = extract_unit(CompileUnit(root / path, **options), root, finder, prelude, problems=problems)
        validate(rows)
        return Snippet(rows, path, problems)

    return extract_one


@pytest.fixture
def facts_of(extract: Callable[..., Snippet]) -> Callable[..., Snippet]:
    """Extract one source."""
    return extract
