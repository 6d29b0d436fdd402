"""The C preprocessor that existing rule bases rely on: `#include`, `#define`, `#ifdef`, and macros from the command line.

Soufflé passes every program through one; rosarch's own rules do without. The expanded text holds `#line` marks, which the parser follows,
so that messages name the file and line as written; `origin_column` finds the column where a macro has moved it.
"""

from __future__ import annotations

import io
import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import IO, Any

from rosarch.datalog.language.errors import Location, Report

_NEEDED = re.compile(r"^[ \t]*#[ \t]*[a-z]|\b__[A-Z_]+__\b", re.MULTILINE)
LINE_MARK = re.compile(r'^[ \t]*#(?:line)?[ \t]*(\d+)(?:[ \t]+"([^"\n]*)")?[^\n]*$', re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Loading:
    """How files are found and read.

    `preprocess`: texts with C preprocessor directives are expanded first, with `macros` (`NAME` or `NAME=VALUE`) defined.
    `folders`: where `.include` and `#include` look in addition to the folder of the including file.
    `instead`: files, and others that an `.include` of them takes.
    """

    preprocess: bool = False
    macros: tuple[str, ...] = ()
    folders: tuple[Path, ...] = ()
    instead: tuple[tuple[Path, Path], ...] = ()


def expand(
    text: str, path: str, report: Report, texts: dict[str, str], *, macros: Sequence[str] = (), folders: Iterable[Path] = ()
) -> str:  # fmt: skip
    """The text with its directives carried out. `texts` receives the files of `#include`; `macros` are `NAME` or `NAME=VALUE`."""
    if not _NEEDED.search(text) and not any(re.search(rf"\b{re.escape(m.partition('=')[0])}\b", text) for m in macros):
        return text  # as most programs are: the preprocessor takes longer than the rest of loading
    import pcpp

    class Expander(pcpp.Preprocessor):  # type: ignore[misc, unused-ignore]
        """Keeps comments, and reports instead of printing."""

        def on_comment(self, tok: Any) -> bool:
            return True

        def on_error(self, file: str, line: int, msg: str) -> None:
            report.error(msg.strip().replace("\n", " "), Location(_as_given(file or path, texts), max(line, 1), 1))
            self.return_code += 1

        def on_include_not_found(self, is_malformed: bool, is_system_include: bool, curdir: str, includepath: str) -> None:
            report.error(f"cannot find `{includepath}`", _place_of_include(includepath, {path: text, **texts}))
            raise pcpp.OutputDirective(pcpp.Action.IgnoreAndRemove)

        def on_file_open(self, is_system_include: bool, includepath: str) -> IO[str]:
            found = Path(includepath).read_text(encoding="utf-8")
            texts[includepath] = found
            return io.StringIO(found)

    expander = Expander()
    expander.rewrite_paths = []
    folder = os.path.dirname(path)
    for place in (folder or ".", *map(str, folders)):
        expander.add_path(place)
    for macro in macros:
        name, equals, value = macro.partition("=")
        expander.define(f"{name} {value if equals else 1}")
    try:
        expander.parse(text, path)
        result = io.StringIO()
        expander.write(result)
    except RecursionError:
        report.error("files include each other without end", Location(path, 1, 1))
        return ""
    except (OSError, UnicodeDecodeError) as error:
        report.error(f"cannot read an included file: {error}", Location(path, 1, 1))
        return ""
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:  # of the library, for what it does not expect
        report.error(f"cannot preprocess this file: {' '.join(str(error).split())}", Location(path, 1, 1))
        return ""
    return result.getvalue()


def _place_of_include(name: str, texts: dict[str, str]) -> Location:
    """Where a file is included."""
    directive = re.compile(rf'^[ \t]*#[ \t]*include[ \t]*["<]{re.escape(name)}[">]', re.MULTILINE)
    found = next(((path, m) for path, text in texts.items() if (m := directive.search(text))), None)
    if found is None:
        return Location(next(iter(texts)), 1, 1)
    return Location(found[0], texts[found[0]].count("\n", 0, found[1].start()) + 1, 1)


def _as_given(path: str, texts: dict[str, str]) -> str:
    """A path as the program names the file: the preprocessor makes paths relative."""
    return next((known for known in texts if os.path.abspath(known) == os.path.abspath(path)), path)


class Origins:
    """Where the lines of an expanded text come from, by its `#line` marks."""

    def __init__(self, text: str, path: str, texts: dict[str, str]) -> None:
        self._lines = text.splitlines()
        self._texts = texts
        self._originals: dict[str, list[str]] = {}
        self._places: list[tuple[str, int]] = []
        at, number = path, 1
        shown: dict[str, str] = {}
        for line in self._lines:
            mark = LINE_MARK.match(line)
            if mark is not None:
                if mark[2] is not None:
                    at = shown.setdefault(mark[2], _as_given(mark[2], {path: "", **texts}))
                number = int(mark[1])
                self._places.append((at, number))
                continue
            self._places.append((at, number))
            number += 1

    def locate(self, line: int, column: int) -> Location:
        """The place in the files as written."""
        if not 0 < line <= len(self._places):
            return Location(*(self._places[-1] if self._places else ("", 1)), column)
        path, number = self._places[line - 1]
        if path not in self._originals:
            self._originals[path] = self._texts.get(path, "").splitlines()
        original = self._originals[path]
        if not 0 < number <= len(original):
            return Location(path, number, column)
        return Location(path, number, origin_column(original[number - 1], self._lines[line - 1], column))


def origin_column(original: str, expanded: str, column: int) -> int:
    """The column of `original` for one of `expanded`: the same before the first macro, counted from the end after the last one."""
    before, word, after = _unchanged(original, expanded)
    if column <= before + 1 or original == expanded:
        return min(column, before + 1) if column > len(original) + 1 else column
    return column + len(original) - len(expanded) if column > len(expanded) - after else word + 1


@lru_cache(maxsize=16)  # of a line there are many columns
def _unchanged(original: str, expanded: str) -> tuple[int, int, int]:
    """How much two texts have in common at their beginning, where the word begins that ends there, and how much at their end."""
    before = word = _common_prefix(original, expanded)
    while word and (original[word - 1].isalnum() or original[word - 1] == "_"):
        word -= 1
    return before, word, _common_prefix(original[before:][::-1], expanded[before:][::-1])


def _common_prefix(one: str, other: str) -> int:
    return next((i for i, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))
