"""Sources in C: names that C++ reserves, conversions that C++ refuses."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, build_prelude, extract_unit

SOURCE = """#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct buffer { char* data; int class; };

bool fill(struct buffer* new, const char* text)
{
  char* copy = malloc(strlen(text) + 1);
  if (copy == NULL || isnan(sqrt(2.0)))
    return false;
  strcpy(copy, text);
  new->data = copy;
  new->class = 3;
  return true;
}
"""


def rows_of(folder: Path, suffix: str) -> Mapping[str, set[tuple[str | int, ...]]]:
    """The rows of the source, written to a file with this suffix."""
    path = folder / f"fill{suffix}"
    path.write_text(SOURCE)
    prelude = folder / "prelude.pch"
    build_prelude(prelude)
    return extract_unit(CompileUnit(path), folder, HeaderFinder(folder, folder / "scratch", lambda _name: None), prelude)


def variables(rows: Mapping[str, set[tuple[str | int, ...]]]) -> set[str | int]:
    """The names of all variables of the source."""
    return {name for variable, name in rows["variable_name"] if "fill" in str(variable) or "buffer" in str(variable)}


def test_a_c_source_is_c(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, ".c")
    assert {name for _call, name in rows["call"]} == {"malloc", "strlen", "isnan", "sqrt", "strcpy"}
    assert not rows.get("call_unresolved")
    assert variables(rows) >= {"new", "text", "copy", "class"}


def test_the_same_text_is_broken_cxx(tmp_path: Path) -> None:
    assert not variables(rows_of(tmp_path, ".cpp")) & {"new", "class"}
