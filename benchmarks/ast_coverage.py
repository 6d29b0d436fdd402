"""Measure how much of the compiled code has a place in clang's syntax tree, parsed without a build.

    benchmarks/ast_coverage.py SYSTEMS_DIR SYSTEM...

A lexer that knows nothing of clang finds the bodies of functions and in them the statement keywords and the identifiers; what conditional
compilation leaves out in every unit does not count. A token has a cursor when one begins, or names something, at its place. A call is lost
when the parse with healed headers, which the facts come from, has fewer calls beginning at a place than the first parse.
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, build_prelude, parsed_unit
from rosarch.extractor.messages import Interfaces
from rosarch.extractor.survey import compile_units
from rosarch.extractor.workspace import components, discover
from rosarch.extractor.workspace.compile_commands import read_compile_commands

_STATEMENTS = "if for while do switch case default return break continue goto try catch throw"
_OTHERS = (
    "else new delete sizeof this nullptr true false int unsigned signed long short char bool float double void auto const constexpr static "
    "volatile struct class enum union typename template using namespace operator static_cast dynamic_cast const_cast reinterpret_cast "
    "typedef mutable register inline extern decltype alignof noexcept static_assert public private protected virtual friend explicit "
    "and or not asm wchar_t typeid override final thread_local NULL"
)
STATEMENTS, OTHER_WORDS = frozenset(_STATEMENTS.split()), frozenset(_OTHERS.split())
TOKEN = re.compile(
    rb'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n\\]|\\.)*|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
    rb"|[A-Za-z_]\w*|[0-9][\w.']*|\S",
    re.DOTALL | re.MULTILINE,
)
SCOPES = frozenset((b"namespace", b"class", b"struct", b"union", b"enum", b"extern"))
Word = tuple[int, bool]  # offset, statement keyword


@dataclass(frozen=True)
class Measured:
    """The words of one file in one unit: those that are compiled, and those that have a cursor."""

    path: str
    compiled: frozenset[Word]
    extracted: frozenset[Word]


def words(data: bytes) -> list[Word]:
    """The statement keywords and identifiers in function bodies, by offset."""
    found: list[Word] = []
    head: list[bytes] = []  # the tokens since the last statement
    braces: list[tuple[bool, bool]] = []  # in a function body; opened by `do`
    previous, after_do = b"", False
    for match in TOKEN.finditer(data):
        token = match.group()
        if token.startswith((b"//", b"/*")) or token.lstrip().startswith(b"#"):
            continue
        inside = bool(braces) and braces[-1][0]
        if token == b"{":
            body = inside or (b")" in head and not (SCOPES & set(head) and b"(" not in head))
            braces.append((body, previous == b"do"))
            head = []
        elif token == b"}":
            after_do = braces.pop()[1] if braces else False
            head = []
        elif token == b";":
            head = []
        else:
            head.append(token)
            name = token.decode("ascii", "replace")
            tail = name == "while" and previous == b"}" and after_do
            if inside and re.fullmatch(r"[A-Za-z_]\w*", name) and name not in OTHER_WORDS and not tail:
                found.append((match.start(), name in STATEMENTS))
        previous = token
    return found


def offsets(cursor: libclang.Cursor) -> Iterator[tuple[str, int]]:
    """The places that a cursor stands for."""
    place = libclang.location(cursor)
    yield libclang.file_location(place)
    yield libclang.spelling_location(place)
    extent = libclang.extent(cursor)
    begin = libclang.Location(extent.p0, extent.p1, extent.begin)
    yield libclang.file_location(begin)
    yield libclang.spelling_location(begin)


def call_places(rows: Mapping[str, set[tuple[str | int, ...]]]) -> Counter[str]:
    """How many calls begin where; without those read from text and without operators that clang took for calls."""
    recovered = {call for call, reason in rows.get("call_unresolved", ()) if reason == "recovered"}
    return Counter(str(call).rpartition(":")[0] for call, name in rows.get("call", ()) if call not in recovered and name != "?")


def measure(unit: CompileUnit, root: Path, finder: HeaderFinder, prelude: Path) -> tuple[list[Measured], int, int]:
    """The files that `unit` compiles, the calls of its first parse, and how many of them are lost by healing."""
    with parsed_unit(unit, root, finder, prelude) as (_first, plain):
        calls = plain.rows
    with parsed_unit(unit, root, finder, prelude, heal=True) as (parsed, facts):
        lost = (call_places(calls) - call_places(facts.rows)).total()
        places: dict[str, set[int]] = {}
        for cursor in libclang.descendants(parsed.cursor):
            for name, offset in offsets(cursor):
                places.setdefault(name, set()).add(offset)
        measured = []
        for name, found in places.items():
            path = Path(name)
            if not name or not path.is_relative_to(root) or not path.is_file():
                continue
            skipped = sorted(facts.skipped.get(str(path), ()))
            compiled = [word for word in words(path.read_bytes()) if not _within(word[0], skipped)]
            measured.append(Measured(name, frozenset(compiled), frozenset(word for word in compiled if word[0] in found)))
    return measured, len(calls.get("call", ())), lost


def _within(offset: int, ranges: Sequence[tuple[int, int]]) -> bool:
    index = bisect_right(ranges, (offset, sys.maxsize)) - 1
    return index >= 0 and offset < ranges[index][1]


def read_system(root: Path, jobs: int) -> tuple[dict[str, tuple[set[Word], set[Word]]], int, int, list[str]]:
    """Per file the words compiled in some unit and those found in some unit; calls, lost calls, failed sources."""
    workspace = discover(root)
    interfaces, commands = Interfaces.of(workspace.packages, workspace.root), read_compile_commands(workspace.root)
    units = sorted({unit for component in components(workspace) for unit in compile_units(workspace, component, commands)}, key=repr)
    files: dict[str, tuple[set[Word], set[Word]]] = {}
    calls = lost = 0
    failed = []
    with ExitStack() as stack:
        scratch = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="rosarch-")))
        build_prelude(scratch / "prelude.pch")
        finder = HeaderFinder(workspace.root, scratch, interfaces.header_text)

        def work(unit: CompileUnit) -> tuple[list[Measured], int, int]:
            return measure(unit, workspace.root, finder, scratch / "prelude.pch")

        for index, outcome in run_tasks(work, units, jobs=jobs, timeout=300.0):
            if isinstance(outcome, Failure):
                failed.append(f"{units[index].source}: {outcome.reason}")
                continue
            for one in outcome[0]:
                compiled, found = files.setdefault(one.path, (set(), set()))
                compiled |= one.compiled
                found |= one.extracted
            calls += outcome[1]
            lost += outcome[2]
    return files, calls, lost, failed


def main() -> int:
    """Print a row per system; the exit code is 1 when a call is lost or a source failed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("names", nargs="+", metavar="SYSTEM")
    parser.add_argument("--jobs", type=int, default=default_jobs())
    parser.add_argument("--list", type=int, default=0, metavar="N", help="list the N files that lack most")
    options = parser.parse_args()
    for name in options.names:
        if not (options.systems / name).is_dir():
            parser.error(f"{options.systems / name}: no such folder")
    print("| system | files | statement keywords | found | identifiers | found | calls | lost | failed |")
    print("|---|---|---|---|---|---|---|---|---|")
    trouble: list[str] = []
    bad = False
    for name in options.names:
        root = (options.systems / name).resolve()
        files, calls, lost, failed = read_system(root, options.jobs)
        cells = [name, str(len(files))]
        for statement in (True, False):
            total = sum(word[1] is statement for compiled, _ in files.values() for word in compiled)
            found = sum(word[1] is statement for _, present in files.values() for word in present)
            cells += [str(total), f"{100 * found / total:.1f} %" if total else "-"]
        print("| " + " | ".join([*cells, str(calls), str(lost), str(len(failed))]) + " |", flush=True)
        bad |= bool(lost or failed)
        worst = sorted(files.items(), key=lambda item: len(item[1][1]) - len(item[1][0]))[: options.list]
        trouble += [f"{name}: {Path(path).relative_to(root)}: {len(c) - len(f)} of {len(c)} words lack a cursor" for path, (c, f) in worst]
        trouble += [f"{name}: failed {text}" for text in failed]
    print("\n".join(["", *trouble]))
    return bad


if __name__ == "__main__":
    sys.exit(main())
