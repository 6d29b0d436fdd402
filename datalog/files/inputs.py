"""What `.input` directives name: files, standard input, JSON documents, SQLite tables."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog.files.tables import Layout, decode, parse_table, read_bytes, read_text
from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location, Report, did_you_mean
from rosarch.datalog.language.syntax import Directive
from rosarch.datalog.language.values import ValueReader

if TYPE_CHECKING:
    from rosarch.datalog.program import Program, RelationDecl

Row = tuple[Any, ...]
DEFAULT_NAMES = {"file": "{}.facts", "jsonfile": "{}.json", "sqlite": "{}.sqlite"}


def failure(program: Program, directive: Directive, message: str, hint: str = "") -> DatalogError:
    """An error at a directive, with its source line."""
    report = Report(program.sources)
    report.error(message, directive.location, hint)
    return DatalogError(report.errors)


def layout_of(params: Mapping[str, str], program: Program, directive: Directive) -> Layout:
    """How the rows of a directive are written in a text."""
    rfc4180 = params.get("rfc4180") == "true"
    delimiter = params.get("delimiter", "," if rfc4180 else "\t")
    if not delimiter or "\n" in delimiter or (rfc4180 and '"' in delimiter):
        raise failure(program, directive, f"`{delimiter}` cannot be a delimiter")
    columns: tuple[int, ...] = ()
    if params.get("columns"):
        parts = params["columns"].split(":")
        arity = len(program.relations[directive.relation].attributes)
        if len(parts) < arity or not all(p.isdigit() for p in parts):
            raise failure(program, directive, f"`columns` names a position for each of {arity} attributes, as in `0:2:1`")
        columns = tuple(int(p) for p in parts[:arity])
    return Layout(delimiter, params.get("headers") == "true", rfc4180, columns, wider=True)


class InputReader:
    """Reads the inputs of one program; `strict`: a file that is missing is an error."""

    def __init__(self, program: Program, folder: Path, *, strict: bool) -> None:
        self.program = program
        self.folder = folder
        self.strict = strict
        self.errors: list[Diagnostic] = []
        self.pool: dict[str, str] = {}
        self.reader = ValueReader(program.types)
        self.readers: dict[str, Callable[[Directive, Mapping[str, str], RelationDecl], list[Row]]] = {
            "file": self._file, "stdin": self._stdin, "jsonfile": self._json_file, "json": self._json_stdin, "sqlite": self._sqlite,
        }  # fmt: skip

    def read(self) -> dict[str, list[Row]]:
        """The rows of every relation with an input that is there. Raises DatalogError with all errors."""
        result: dict[str, list[Row]] = {}
        for directive in self.program.directives:
            if directive.kind != "input":
                continue
            params = dict(directive.params)
            read = self.readers.get(params.get("IO", "file"))
            if read is None:
                hint = did_you_mean(params["IO"], self.readers) or f"expected one of {', '.join(sorted(self.readers))}"
                raise failure(self.program, directive, f"`{params['IO']}` is not a way to read facts", hint)
            try:
                rows = read(directive, params, self.program.relations[directive.relation])
            except DatalogError as error:
                self.errors.extend(error.diagnostics)
            except FileNotFoundError:
                continue
            else:
                result.setdefault(directive.relation, []).extend(rows)
        if self.errors:
            raise DatalogError(self.errors)
        return result

    def _path(self, directive: Directive, params: Mapping[str, str]) -> Path:
        """The file of a directive; FileNotFoundError when it may be and is missing."""
        name = params.get("filename") or params.get("dbname") or DEFAULT_NAMES[params.get("IO", "file")].format(directive.relation)
        path = self.folder / name
        if not path.exists():
            if not self.strict:
                raise FileNotFoundError
            raise failure(self.program, directive, f"no such file: `{path}`")
        return path

    def _file(self, directive: Directive, params: Mapping[str, str], relation: RelationDecl) -> list[Row]:
        layout = layout_of(params, self.program, directive)
        path = self._path(directive, params)
        return parse_table(read_text(path, strict=True), str(path), relation, self.errors, self.reader, layout, self.pool)

    def _stdin(self, directive: Directive, params: Mapping[str, str], relation: RelationDecl) -> list[Row]:
        layout = layout_of(params, self.program, directive)
        return parse_table(_standard_input(), "<stdin>", relation, self.errors, self.reader, layout, self.pool)

    def _json_file(self, directive: Directive, params: Mapping[str, str], relation: RelationDecl) -> list[Row]:
        from rosarch.datalog.files.json_rows import parse_rows

        path = self._path(directive, params)
        return parse_rows(read_text(path, strict=True), str(path), relation, self.program)

    def _json_stdin(self, directive: Directive, params: Mapping[str, str], relation: RelationDecl) -> list[Row]:
        from rosarch.datalog.files.json_rows import parse_rows

        return parse_rows(_standard_input(), "<stdin>", relation, self.program)

    def _sqlite(self, directive: Directive, params: Mapping[str, str], relation: RelationDecl) -> list[Row]:
        from rosarch.datalog.files.sqlite_rows import read_rows

        return read_rows(self._path(directive, params), params.get("name", directive.relation), relation, self.reader, self.errors)


def _standard_input() -> str:
    return decode(read_bytes(sys.stdin.buffer, "<stdin>"), "<stdin>", strict=True)


def check_directive(directive: Directive, location: Location, report: Report) -> None:
    """Warn of parameters that mean nothing to the kind of directive."""
    known = KNOWN[directive.kind]
    for name, _ in directive.params:
        if name not in known:
            report.warning(f"parameter `{name}` of `.{directive.kind}` is not known", location, did_you_mean(name, known))


_SHARED = ("IO", "name", "filename", "dbname", "delimiter", "headers", "rfc4180", "attributeNames", "operation", "format", "compress")
KNOWN = {
    "input": (*_SHARED, "columns", "fact-dir", "auxArity"),
    "output": (*_SHARED, "output-dir"),
    "printsize": (*_SHARED, "output-dir"),
    "limitsize": ("n",),
}
