"""The facts of a Python component: of all its modules together, as a translation unit has those of all its headers."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path

from rosarch.base.diagnostics import SourceProblem, why
from rosarch.base.files import path_text, shown_path
from rosarch.base.limits import deep_recursion
from rosarch.extractor.cxx.unit import file_key
from rosarch.extractor.flow import Flow
from rosarch.extractor.python.body import Body, Facts
from rosarch.extractor.python.decorated import read_decorated
from rosarch.extractor.python.definitions import lower_module
from rosarch.extractor.python.inference import Inference
from rosarch.extractor.python.model import Class, Function, Module, Symbol
from rosarch.extractor.python.normal import name_what_texts_name
from rosarch.extractor.python.program import Program
from rosarch.extractor.python.records import give_constructors
from rosarch.extractor.python.scopes import open_module
from rosarch.extractor.python.source import Problem, read_source
from rosarch.extractor.workspace.model import PythonEntry

_DEEPEST = 2000
"""Nodes within nodes: each takes several calls, of which there is room for `deep_recursion`."""

Rows = dict[str, set[tuple[str | int, ...]]]


def extract_program(root: Path, entry: PythonEntry) -> tuple[Rows, list[SourceProblem]]:
    """The facts of the component that `entry` starts, and what was not understood of its sources."""
    problems: list[SourceProblem] = []
    with deep_recursion():
        modules = {module.name: module for name, path in entry.modules for module in _read(root, entry, name, path, problems)}
        rows = _rows(modules, entry, problems) if modules else {}
    return rows, problems


def _read(root: Path, entry: PythonEntry, name: str, path: Path, problems: list[SourceProblem]) -> Iterator[Module]:
    """A module; none when its source is no Python."""
    try:
        parsed = read_source(path)
    except OSError as error:
        parsed = Problem(1, 1, f"not analysed: {why(error)}")
    found = (parsed,) if isinstance(parsed, Problem) else parsed.problems
    problems += [(str(path), problem.line, problem.column, problem.message) for problem in found]
    if isinstance(parsed, Problem):
        return
    for depth, nodes in enumerate(_levels(parsed.tree)):
        if depth > _DEEPEST:
            problems.append((str(path), 1, 1, "not analysed: nested too deeply"))
            return
        for line, column in _dynamic_imports(nodes):
            problems.append((str(path), line, column, "imports a module by a name that is made up at run time; it is not read"))
    name_what_texts_name(parsed.tree)
    read_decorated(parsed.tree)
    give_constructors(parsed.tree)
    relative = path_text(shown_path(root, path))
    main = path == entry.file and entry.function is None
    module = Module(name, parsed.tree, file_key(relative), relative, tuple(parsed.data.split(b"\n")), main, path.name == "__init__.py")
    module.left_out = parsed.left_out
    open_module(module)
    yield module


def _rows(modules: dict[str, Module], entry: PythonEntry, problems: list[SourceProblem]) -> Rows:
    program = Program(modules)
    facts = Facts(program, Inference(program, modules.values()))
    paths = dict(entry.modules)
    for module in modules.values():
        facts.add("source_file", module.key, module.path)
        facts.add("source_language", module.key, "python")
        if module.left_out:
            facts.add("source_lost", module.key, module.left_out, module.left_out, "a syntax error, with all that follows")
        try:
            lower_module(Body(facts, module, module.scope, Flow()), module)
        except RecursionError:
            problems.append((str(paths[module.name]), 1, 1, "not analysed as a whole: nested too deeply"))
    first = modules.get(entry.module)
    if first is not None:
        facts.add("program_entry", first.function.identifier)
        function = _entered(program, entry) if entry.function else None
        if isinstance(function, Function):
            facts.add("program_entry", facts.function(function))
    facts.rows["class_by_reference"].add(("?",))
    return dict(facts.rows)


def _entered(program: Program, entry: PythonEntry) -> Symbol | None:
    """What the entry point names: a function of the module, or one of a class in it (`Talker.main`)."""
    first, *rest = (entry.function or "").split(".")
    symbol = program.symbol_of(entry.module, first)
    for name in rest:
        symbol = symbol.find(name) if isinstance(symbol, Class) else None
    return symbol


def _levels(tree: ast.Module) -> Iterator[list[ast.AST]]:
    """The nodes of a tree, those that are nested equally deeply together."""
    level: list[ast.AST] = [tree]
    while level:
        yield level
        level = [child for node in level for child in ast.iter_child_nodes(node)]


def _dynamic_imports(nodes: Iterable[ast.AST]) -> Iterator[tuple[int, int]]:
    """Where a module imports something by a name that is made up at run time."""
    for node in nodes:
        match node:
            case ast.Call(func=ast.Name(id="__import__") | ast.Attribute(attr="import_module"), args=[ast.Constant(value=str()), *_]):
                continue
            case ast.Call(func=ast.Name(id="__import__") | ast.Attribute(attr="import_module")):
                yield node.lineno, node.col_offset + 1
