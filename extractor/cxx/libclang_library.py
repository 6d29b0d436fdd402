"""The shared library libclang: the structures that its functions are given and return, and how one of them is bound.

It comes with the `libclang` wheel; https://clang.llvm.org/doxygen/group__CINDEX.html says what the structures mean.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from ctypes import POINTER, Structure, c_char_p, c_int, c_uint, c_void_p
from pathlib import Path
from typing import Any

import clang.native


class Cursor(Structure):
    """CXCursor. `data[1]` distinguishes expressions and statements, `data[0]` declarations."""

    _fields_ = [("kind", c_int), ("xdata", c_int), ("d0", c_void_p), ("d1", c_void_p), ("d2", c_void_p)]
    kind: int
    d0: int | None
    d1: int | None


class Type(Structure):
    """CXType."""

    _fields_ = [("kind", c_int), ("d0", c_void_p), ("d1", c_void_p)]
    kind: int
    d0: int | None


class Location(Structure):
    """CXSourceLocation. `raw` is clang's own offset over all files; its top bit marks a macro expansion."""

    _fields_ = [("p0", c_void_p), ("p1", c_void_p), ("raw", c_uint)]
    raw: int


class Range(Structure):
    """CXSourceRange."""

    _fields_ = [("p0", c_void_p), ("p1", c_void_p), ("begin", c_uint), ("end", c_uint)]
    begin: int
    end: int


class String(Structure):
    """CXString."""

    _fields_ = [("data", c_char_p), ("flags", c_uint)]
    data: bytes | None
    flags: int


class RangeList(Structure):
    """CXSourceRangeList."""

    _fields_ = [("count", c_uint), ("ranges", POINTER(Range))]


def _library() -> ctypes.CDLL:
    folder = Path(next(iter(clang.native.__path__)))
    path = next(iter(sorted(folder.glob("libclang.*"))), None)
    if path is None:
        raise ImportError(f"{folder}: there is no libclang here")
    try:
        return ctypes.CDLL(str(path))
    except OSError as error:
        raise ImportError(f"{path}: cannot be loaded ({error})") from None


_lib = _library()
Visitor = ctypes.CFUNCTYPE(c_int, Cursor, Cursor, c_void_p)
FieldVisitor = ctypes.CFUNCTYPE(c_int, Cursor, c_void_p)


def bind(name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    """The function `clang_` + `name` with the types of its result and arguments; ImportError when this libclang has none of that name."""
    try:
        function = getattr(_lib, "clang_" + name)
    except AttributeError:
        raise ImportError(f"{_lib._name}: this libclang has no clang_{name}") from None
    function.restype = result
    function.argtypes = arguments
    return function  # type: ignore[no-any-return]
