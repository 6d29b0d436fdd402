"""`query`: a rule body asked of rows that are already there; a table with a column for every variable it names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

from rosarch.datalog.inspection.clauses import Rules, rules_of
from rosarch.datalog.inspection.rows import Given, row_store
from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location, Report
from rosarch.datalog.language.ground import outer_variables
from rosarch.datalog.language.inference import ClauseTypes
from rosarch.datalog.language.parser import parse_text
from rosarch.datalog.language.semantics import check
from rosarch.datalog.language.sources import Sources
from rosarch.datalog.language.strata import atoms_of
from rosarch.datalog.language.syntax import Atom, AttributeDecl, Clause, Directive, Relation, Unit, Variable
from rosarch.datalog.language.types import Types
from rosarch.datalog.program import Program, Result, compile_unit

if TYPE_CHECKING:
    from rosarch.datalog.inspection.rows import Row

QUERY = "<query>"
_PRIMITIVES = {"i": "number", "u": "unsigned", "f": "float", "s": "symbol"}


@dataclass(frozen=True)
class Table:
    """The answer to a query; `types` are those of the columns. Without columns it has one row for yes, none for no."""

    columns: tuple[str, ...]
    types: tuple[str, ...]
    rows: tuple[Row, ...]


def query(program: Program, rows: Given, text: str, *, engine: str = "embedded") -> Table:
    """The values of the variables of a rule body, such as `edge(X, Y), !blocked(Y), X != "a"`.

    `rows`: a result with the rows of the relations that are named, or facts to evaluate. Columns are the variables in
    the order of the text, except those that start with `_`. Raises DatalogError with the place in the text.
    """
    store = row_store(program, rows, engine=engine)
    rules = rules_of(program)
    compiled, columns, types = _compile(text, rules)
    compiled.functors = program.functors
    facts = {name: store.rows(name) for name in compiled.inputs}
    return Table(columns, types, tuple(compiled.evaluate(facts).rows(compiled.outputs[0])))


def relation_table(program: Program, result: Result, name: str) -> Table:
    """All rows of a relation."""
    attributes = program.relations[name].attributes
    return Table(tuple(a.name for a in attributes), tuple(a.type for a in attributes), tuple(result.rows(name)))


def check_query(program: Program, text: str) -> tuple[str, ...]:
    """The columns of a query; DatalogError when it is wrong. Needs no rows."""
    return _compile(text, rules_of(program))[1]


def _compile(text: str, rules: Rules) -> tuple[Program, tuple[str, ...], tuple[str, ...]]:
    try:
        return _compiled(text, rules)
    except DatalogError as error:
        own = [d for d in error.diagnostics if d.location is None or d.location.line > 1]
        raise DatalogError([_moved(d) for d in own or error.diagnostics]) from None


def _moved(diagnostic: Diagnostic) -> Diagnostic:
    """A diagnostic with its place in the query, which was parsed from the second line on and ended by a dot."""
    at = diagnostic.location
    if at is None:
        return diagnostic
    message, source = diagnostic.message, diagnostic.source.removesuffix(".")
    if at.column == len(source) + 1:
        message = message.replace("unexpected `.`", "unexpected end of the query")
    return replace(diagnostic, message=message, location=Location(at.path, max(at.line - 1, 1), at.column), source=source)


@lru_cache(maxsize=256)  # an expectation is asked again for every mutant
def _compiled(text: str, rules: Rules) -> tuple[Program, tuple[str, ...], tuple[str, ...]]:
    name = "query"
    while name in rules.relations:
        name += "_"
    source = f"{name}() :-\n{text.strip().removesuffix('.')}.\n"
    report = Report({QUERY: source})
    items = parse_text(source, QUERY, report)
    clauses = [item for item in items if isinstance(item, Clause)]
    at = Location(QUERY, 2, 1)
    if not report.errors and (not clauses or len(clauses) != len(items) or any(c.head.name != name for c in clauses)):
        report.error("a query is one rule body, such as `edge(X, Y), X != Y`", at)
    report.raise_errors()
    asked = Relation(name, (), frozenset(), (), at)
    checked = check(_unit(rules, [*rules.relations.values()], asked, clauses), report, rules.types.bits)
    columns = _columns(clauses)
    types = tuple(_type(column, [t for _, t in checked.clauses[name]], rules.types) for column in columns)
    declared = replace(asked, attributes=tuple(AttributeDecl(c, t, at) for c, t in zip(columns, types, strict=True)))
    head = Atom(name, tuple(Variable(c, at) for c in columns), at)
    used = dict.fromkeys(atom.name for c in clauses for literal in c.body for atom, _ in atoms_of(literal))
    relations = [replace(rules.relations[n], qualifiers=frozenset(), choices=()) for n in used]
    unit = _unit(rules, relations, declared, [Clause(head, c.body, c.location) for c in clauses])
    unit.directives = [*(Directive("input", n, (), at) for n in used), Directive("output", name, (), at)]
    texts = {QUERY: source}
    return compile_unit(unit, Sources(texts, texts), Report(texts), rules.types.bits), columns, types


def _unit(rules: Rules, relations: Sequence[Relation], asked: Relation, clauses: Sequence[Clause]) -> Unit:
    return Unit(list(rules.unit.types), [*relations, asked], list(clauses), functors=list(rules.unit.functors))


def _columns(clauses: Sequence[Clause]) -> tuple[str, ...]:
    """The named variables outside of aggregates that every alternative of the body has."""
    found: dict[str, None] = {}
    common: set[str] | None = None
    for clause in clauses:
        names = [v.name for literal in clause.body for v in outer_variables(literal) if isinstance(v, Variable)]
        found.update(dict.fromkeys(n for n in names if not n.startswith("_")))
        common = set(names) if common is None else common & set(names)
    return tuple(n for n in found if n in (common or ()))


def _type(variable: str, clauses: Sequence[ClauseTypes], types: Types) -> str:
    """A declared type that holds the values of a variable."""
    names = {name for clause in clauses for name in clause.sets.get(variable) or ()}
    declared = sorted(name for name in names if not name.startswith("@"))
    if len(names) == 1 and declared:
        return declared[0]
    kind = types.kind(next(iter(sorted(names)))) if names else "i"
    return types.root(declared[0]).name if kind in "r+" else _PRIMITIVES[kind]


def table_text(table: Table, program: Program, *, most: int | None = None) -> str:
    """A table with aligned columns and the number of rows; without columns `yes` or `no`."""
    if not table.columns:
        return "yes\n" if table.rows else "no\n"
    cells = table_cells(table, program)
    shown = cells if most is None else cells[:most]
    widths = [max(len(c) for c in column) for column in zip(table.columns, *shown, strict=True)]
    lines = ["  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)).rstrip() for row in (table.columns, *shown)]
    lines.insert(1, "  ".join("-" * w for w in widths))
    left = len(cells) - len(shown)
    if left:
        lines.append(f"... {left} more")
    count = len(table.rows)
    return "".join(f"{line}\n" for line in (*lines, f"{count} row{'s' * (count != 1)}"))


def table_cells(table: Table, program: Program) -> list[tuple[str, ...]]:
    """The rows as text, as in `.csv` files."""
    from rosarch.datalog.language.values import ValueWriter

    show = ValueWriter(program.types).show
    return [tuple(show(v, t) for v, t in zip(row, table.types, strict=True)) for row in table.rows]


def table_values(table: Table) -> list[dict[str, object]]:
    """The rows as objects for JSON; records are lists, branches lists that start with their name."""
    return [dict(zip(table.columns, map(_plain, row), strict=True)) for row in table.rows]


def _plain(value: object) -> object:
    return [_plain(v) for v in value] if isinstance(value, tuple) else value
