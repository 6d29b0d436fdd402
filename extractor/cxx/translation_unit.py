"""One translation unit: parsed without a build, walked, turned into rows."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.cache import hash_of
from rosarch.base.diagnostics import SourceProblem
from rosarch.base.files import path_text
from rosarch.base.limits import deep_recursion
from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.assumed import assumed_classes
from rosarch.extractor.cxx.heal import OPTIONS, files_with_errors, healed, without_unknown, worth_healing
from rosarch.extractor.cxx.includes import CUDA_PRELUDE, Folders, HeaderFinder, Includes, prelude_of, shipped_dirs
from rosarch.extractor.cxx.kept_calls import call_places, keeps_calls
from rosarch.extractor.cxx.libclang_library import Cursor, Location
from rosarch.extractor.cxx.recover import declared_names, recover
from rosarch.extractor.cxx.shared import SharedHeaders
from rosarch.extractor.cxx.unit import SourceFiles, UnitFacts, file_key
from rosarch.extractor.cxx.unseen import unseen
from rosarch.extractor.cxx.walk import walk_declaration
from rosarch.extractor.version import extractor_version
from rosarch.extractor.workspace.model import ROS1, ROS2

# gnu++17: the shipped headers need deduction guides; a fixed target: the same types on every host;
# no access control: a private member is a fact like any other
BASE_ARGUMENTS = (
    "-x", "c++", "-std=gnu++17", "--target=x86_64-unknown-linux-gnu", "-nostdinc", "-nostdinc++", "-Wno-everything",
    "-fno-access-control", "-fbracket-depth=2048", "-fno-spell-checking", "-ferror-limit=0",
)  # fmt: skip

# what the host runs, kernels included; kernels are launched by a syntax of their own
CUDA_ARGUMENTS = ("-x", "cuda", "--cuda-host-only", "-nocudainc", "-nocudalib", *BASE_ARGUMENTS[2:], "-include", str(CUDA_PRELUDE))
C_ARGUMENTS = ("-x", "c", "-std=gnu11", *(word for word in BASE_ARGUMENTS[3:] if word not in ("-nostdinc++", "-fno-access-control")))

Rows = Mapping[str, set[tuple[str | int, ...]]]
"""An error in a source: path, line, column, message."""


@dataclass(frozen=True)
class CompileUnit:
    """A source with what its target compiles it with; headers in `installed` are taken when nothing else provides them.

    The declarations of `middleware` (ros1, ros2) are those that rosarch brings.
    """

    source: Path
    include_dirs: tuple[Path, ...] = ()
    definitions: tuple[str, ...] = ()
    installed: tuple[Path, ...] = ()
    middleware: str = ROS1

    @property
    def folders(self) -> Folders:
        """Where its headers are."""
        return Folders(self.include_dirs, self.installed, self.middleware)

    @property
    def own_sources(self) -> tuple[Path, ...]:
        """The source: headers are read for others too."""
        return (self.source,)

    @property
    def language(self) -> str:
        """`c`, `cuda` or `c++`, by the name of the source."""
        return {".c": "c", ".cu": "cuda"}.get(self.source.suffix, "c++")


def _system(folders: Iterable[Path]) -> list[str]:
    return [word for folder in folders for word in ("-isystem", str(folder))]


def _precompiled(prelude: Path) -> list[str]:
    # its name says which headers it is made of, and when these were changed: clang need not look at each of them again
    return ["-include-pch", str(prelude), "-Xclang", "-fno-validate-pch"]


def build_prelude(path: Path, headers: Iterable[str] = (), middleware: str = ROS1, base: Path | None = None) -> None:
    """Precompile the shipped declarations that nearly every source includes, or those of further shipped `headers` beyond `base`."""
    arguments = ["-x", "c++-header", *BASE_ARGUMENTS[2:], *_system(shipped_dirs(middleware))]
    arguments += _precompiled(base) if base else []
    arguments += [word for header in headers for word in ("-include", header)]
    with libclang.Unit(prelude_of(middleware), arguments, libclang.KEEP_GOING | libclang.INCOMPLETE | libclang.FOR_SERIALIZATION) as unit:
        unit.save(path)


def arguments_of(unit: CompileUnit, includes: Includes, prelude: Path | None) -> list[str]:
    """What clang is called with for a unit."""
    arguments = [
        *{"c": C_ARGUMENTS, "cuda": CUDA_ARGUMENTS, "c++": BASE_ARGUMENTS}[unit.language],
        *(f"-D{definition}" for definition in unit.definitions),
        *(f"-I{folder}" for folder in unit.include_dirs),
        *_system([*shipped_dirs(unit.middleware), *includes.made]),
    ]
    if includes.overlay is not None:
        arguments += ["-ivfsoverlay", str(includes.overlay)]
    if prelude is not None and unit.language == "c++":
        arguments += _precompiled(prelude)
    return arguments


def unit_key(unit: CompileUnit, root: Path, includes: Includes, finder: HeaderFinder) -> str:
    """A hash of all that the rows of a unit depend on."""
    folders = [os.path.relpath(folder, root) for folder in unit.include_dirs]
    installed = [os.path.relpath(folder, root) for folder in unit.installed]
    source = os.path.relpath(unit.source, root)
    return hash_of(
        [
            *(extractor_version(), unit.middleware, source, *folders, "", *installed, "", *unit.definitions, ""),
            *(finder.fingerprint(includes), *finder.underlay.prefixes),
        ]
    )


def extract_unit(
    unit: CompileUnit,
    root: Path,
    finder: HeaderFinder,
    prelude: Path | None,
    *,
    includes: Includes | None = None,
    heal: bool = False,
    problems: list[SourceProblem] | None = None,
    headers: SharedHeaders | None = None,
    sources: SourceFiles | None = None,
) -> Rows:
    """Return the rows of one translation unit; `heal` declares what absent headers would have declared.

    `includes` is the closure of the unit's source, where it is known already. `problems` gets the errors that lose code, `headers`
    those whose facts are kept apart from those of the unit. `sources` are the files that were read for other units.
    Raises `libclang.ParseError` when clang gives no translation unit at all.
    """
    with parsed_unit(unit, root, finder, prelude, includes=includes, heal=heal, headers=headers, sources=sources) as (parsed, facts):
        if problems is not None:
            problems += _lost_code(facts, parsed)
        return facts.rows


@contextmanager
def parsed_unit(
    unit: CompileUnit,
    root: Path,
    finder: HeaderFinder,
    prelude: Path | None,
    *,
    includes: Includes | None = None,
    heal: bool = False,
    headers: SharedHeaders | None = None,
    sources: SourceFiles | None = None,
) -> Iterator[tuple[libclang.Unit, UnitFacts]]:
    """The parse that the facts of a translation unit are taken from, and these facts. See `extract_unit`."""
    includes = includes or finder.closure(unit.source, unit.folders)
    sources = sources or SourceFiles(root, finder.underlay)
    arguments = arguments_of(unit, includes, prelude)
    with deep_recursion(), libclang.Unit(unit.source, arguments, OPTIONS) as parsed:
        facts, declarations = _declarations(sources, includes, parsed, headers)
        hidden = None
        if heal and unit.language != "c" and worth_healing(facts, parsed):
            hidden = unseen(facts, parsed, files_with_errors(facts, parsed))
            with healed(unit.source, arguments, parsed, finder.scratch, unit.middleware == ROS2, hidden) as better:
                if better:
                    again, found = _declarations(sources, includes, better.unit, headers, better.interfaces)
                    if keeps_calls(call_places(facts, declarations), call_places(again, found)):
                        _walk(again, found, headers)
                        without_unknown(again.rows)
                        hidden.add_facts(again, better.unit)
                        yield better.unit, again
                        return
        _walk(facts, declarations, headers)
        if hidden:
            hidden.add_facts(facts, parsed)
        yield parsed, facts


_LOSING = re.compile(
    r"bracket nesting level exceeded maximum of \d+|expected '}'|extraneous closing brace \('}'\)|unterminated .*"
    r"|raw string missing terminating delimiter .*"
)


def _lost_code(facts: UnitFacts, parsed: libclang.Unit) -> Iterable[SourceProblem]:
    """The first error of each file that makes clang pass over what follows, and where code is nested too deeply, once per line.

    Errors that lose code are braces that do not match and comments that do not end. Others cost a declaration or an expression, and
    without third-party headers most sources have some.
    """
    deep: dict[tuple[str, int], int] = {}
    for span in facts.deep:
        line, column = span.file.line_column(span.begin)
        where = str(span.file.path), line
        deep[where] = min(column, deep.get(where, column))
    for (path, line), column in deep.items():
        yield path, line, column, "nested too deeply, left out"
    found: dict[str, list[tuple[int, int, str]]] = {}
    for severity, message, place in parsed.diagnostics:
        if severity >= libclang.FATAL or _LOSING.fullmatch(message):
            file, offset = facts.locate(place)
            if file.key:
                found.setdefault(str(file.path), []).append((*file.line_column(offset), message))
    for path, errors in found.items():
        line, column, message = errors[0]
        more = f", and {len(errors) - 1} more such error{'s' * (len(errors) > 2)}" if len(errors) > 1 else ""
        yield path, line, column, f"code from here on may be missing: {message}{more}"


def _declarations(
    sources: SourceFiles, includes: Includes, parsed: libclang.Unit, headers: SharedHeaders | None, interfaces: Iterable[str] = ()
) -> tuple[UnitFacts, Sequence[Cursor]]:
    """The declarations of a parsed unit that it is to read itself, and the facts that are known without reading them.

    `interfaces` are the headers of interfaces that are declared for it (see `healed`).
    """
    facts, root = UnitFacts(sources), sources.root
    for missing in includes.missing:
        if missing.file.is_relative_to(root):
            relative = path_text(missing.file.relative_to(root))
            facts.add("source_file", file_key(relative), relative)
            facts.add("include_missing", file_key(relative), missing.line, path_text(missing.header))
    for header in (*(missing.header for missing in includes.missing), *interfaces):
        for class_, kind, type_ in assumed_classes(header):
            facts.add("message_class", class_, kind, type_)
    for skipped in parsed.skipped_ranges():
        file, begin = facts.locate(Location(skipped.p0, skipped.p1, skipped.begin))
        _, end = facts.locate(Location(skipped.p0, skipped.p1, skipped.end))
        facts.skipped.setdefault(str(file.path), []).append((begin, end))
        if file.key:
            facts.add("lines_skipped", file.key, file.line_column(begin)[0], file.line_column(end)[0])
    cursors = []
    for cursor in parsed.declarations():
        if cursor.kind == kinds.INCLUSION:
            facts.file(libclang.included_file(cursor))  # it may hold nothing but definitions of macros
        else:
            cursors.append(cursor)
    return facts, headers.leave_out(facts, parsed, cursors) if headers else cursors


def _walk(facts: UnitFacts, declarations: Iterable[Cursor], headers: SharedHeaders | None) -> None:
    """Add the facts of declarations, and of calls in their text that clang dropped."""
    for cursor in declarations:
        walk_declaration(facts, cursor)
    recover(facts, [declared_names(facts.rows), *(headers.names if headers else ())])
