"""What `.output` and `.printsize` directives ask for: files, standard output, JSON documents, SQLite tables.

Files are written beside their destination and renamed once all of them are complete, so that a failure leaves nothing behind.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog.files.inputs import failure, layout_of
from rosarch.datalog.files.row_text import Show, column_writer
from rosarch.datalog.files.tables import Layout
from rosarch.datalog.language.errors import DatalogError, did_you_mean
from rosarch.datalog.language.syntax import Directive
from rosarch.datalog.language.values import ValueWriter

if TYPE_CHECKING:
    from rosarch.datalog.program import Attribute, Program, Result

Row = tuple[Any, ...]
STDOUT = "-"
RULE = "==============="


class OutputWriter:
    """Writes the outputs of one result to a folder, or all of them to standard output when the folder is `-`."""

    def __init__(self, program: Program, result: Result, folder: str) -> None:
        self.program = program
        self.result = result
        self.folder = folder
        self.printed: list[Iterable[str]] = []
        self.staged: dict[Path, Path] = {}  # temporary file -> destination
        self.later: list[Callable[[], None]] = []
        self.writers: dict[str, Callable[[Directive, Mapping[str, str]], None]] = {
            "file": self._file, "stdout": self._stdout, "stdoutprintsize": self._size, "jsonfile": self._json_file,
            "json": self._json_stdout, "sqlite": self._sqlite,
        }  # fmt: skip

    def write(self) -> None:
        """Write everything. Raises DatalogError, and then no file is new."""
        try:
            for directive in self.program.directives:
                if directive.kind in ("output", "printsize"):
                    self._write(directive)
            for action in self.later:
                action()
            for temporary, path in self.staged.items():
                os.replace(temporary, path)
        except OSError as error:
            raise DatalogError(f"{error.filename2 or error.filename or self.folder}: cannot write: {error.strerror}") from None
        finally:
            for temporary in self.staged:
                temporary.unlink(missing_ok=True)
        if self.printed:
            sys.stdout.flush()
            out = sys.stdout.buffer
            for pieces in self.printed:
                out.writelines(piece.encode("utf-8", "surrogateescape") for piece in pieces)
            out.flush()

    def _write(self, directive: Directive) -> None:
        params = dict(directive.params)
        io = "stdoutprintsize" if directive.kind == "printsize" else params.get("IO", "file")
        if self.folder == STDOUT and directive.kind == "output":
            io, params["headers"] = "stdout", "true"
        write = self.writers.get(io)
        if write is None:
            hint = did_you_mean(io, self.writers) or f"expected one of {', '.join(sorted(self.writers))}"
            raise failure(self.program, directive, f"`{io}` is not a way to write rows", hint)
        write(directive, params)

    def _path(self, directive: Directive, params: Mapping[str, str], ending: str) -> Path:
        return Path(self.folder) / (params.get("filename") or params.get("dbname") or f"{directive.relation}{ending}")

    def _stage(self, path: Path, pieces: Iterable[str], *, compress: bool = False) -> None:
        """Write a file under a temporary name."""
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        os.close(handle)
        self.staged[Path(name)] = path
        os.chmod(name, 0o666 & ~_umask())
        if compress:
            import gzip

            with gzip.open(name, "wt", encoding="utf-8", errors="surrogateescape", newline="") as packed:
                packed.writelines(pieces)
            return
        with open(name, "w", encoding="utf-8", errors="surrogateescape", newline="") as stream:
            stream.writelines(pieces)

    def _file(self, directive: Directive, params: Mapping[str, str]) -> None:
        compress = "compress" in params
        pieces = self._lines(directive, params, layout_of(params, self.program, directive))
        self._stage(self._path(directive, params, ".csv.gz" if compress else ".csv"), pieces, compress=compress)

    def _stdout(self, directive: Directive, params: Mapping[str, str]) -> None:
        name = params.get("name", directive.relation)
        self.printed.append((f"---------------\n{name}\n",))
        layout = layout_of(params, self.program, directive)
        lines = self._lines(directive, params, layout)
        if layout.headers:
            self.printed.append((next(lines),))
        self.printed.extend(((f"{RULE}\n",), lines, (f"{RULE}\n",)))

    def _size(self, directive: Directive, params: Mapping[str, str]) -> None:
        self.printed.append((f"{params.get('name', directive.relation)}\t{self.result.count(directive.relation)}\n",))

    def _json_file(self, directive: Directive, params: Mapping[str, str]) -> None:
        self._stage(self._path(directive, params, ".json"), self._json(directive, params))

    def _json_stdout(self, directive: Directive, params: Mapping[str, str]) -> None:
        self.printed.append(list(self._json(directive, params)))

    def _json(self, directive: Directive, params: Mapping[str, str]) -> Iterator[str]:
        from rosarch.datalog.files.json_rows import show_rows

        relation = self.program.relations[directive.relation]
        return show_rows(self.result.rows(directive.relation), relation, self.program.types, params.get("format") == "object")

    def _sqlite(self, directive: Directive, params: Mapping[str, str]) -> None:
        from rosarch.datalog.files.sqlite_rows import write_rows

        path, name = self._path(directive, params, ".sqlite"), directive.relation
        relation, rows = self.program.relations[name], self.result.rows(name)
        self.later.append(lambda: write_rows(path, params.get("name", name), rows, relation, self.program.types))

    def _lines(self, directive: Directive, params: Mapping[str, str], layout: Layout) -> Iterator[str]:
        """The header, if one is wanted, and a line for each row."""
        relation = self.program.relations[directive.relation]
        if layout.headers:
            yield params.get("attributeNames", params.get("delimiter", "\t").join(a.name for a in relation.attributes)) + "\n"
        writers = [self._quoting(a) if layout.rfc4180 else column_writer(a.type, self.program.types) for a in relation.attributes]
        yield from self.result.lines(relation.name, writers, layout.delimiter)

    def _quoting(self, attribute: Attribute) -> Show:
        """What writes the cells of a column in quotes where they may need them."""
        if attribute.base not in ("symbol", "record", "adt"):
            return column_writer(attribute.type, self.program.types)
        show = ValueWriter(self.program.types, quoted=True).show
        return lambda value: '"' + show(value, attribute.type).replace('"', '""') + '"'


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
