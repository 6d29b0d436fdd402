"""Programs that were compiled when they were installed, for the user who runs them first.

They are kept beside their rules, wherever these lie by then: a file holds no path of the folder it was made in, and says which engine and
which texts it was made from. One that does not fit is as good as none.
"""

from __future__ import annotations

import io
import os
import pickle
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, NamedTuple

from rosarch.datalog.cache import engine_source, unchanged

if TYPE_CHECKING:
    from rosarch.datalog.program import Program


class _Head(NamedTuple):
    """What a program was made from: the engine, what it was asked for, and the content of all files; and by which Python."""

    engine: str
    key: str
    digests: dict[str, str]
    python: str


class _Packer(pickle.Pickler):
    """Writes paths below a folder without that."""

    def __init__(self, stream: IO[bytes], above: str) -> None:
        super().__init__(stream, protocol=pickle.HIGHEST_PROTOCOL)
        self._above = above

    def persistent_id(self, value: Any) -> str | None:
        return value[len(self._above) :] if type(value) is str and value.startswith(self._above) else None


class _Unpacker(pickle.Unpickler):
    """Reads paths as those below another folder."""

    def __init__(self, stream: IO[bytes], above: str) -> None:
        super().__init__(stream)
        self._above = above

    def persistent_load(self, below: str) -> str:
        return self._above + below


def write_program(file: Path, roots: Sequence[Path], key: str, digests: dict[str, str], program: Program) -> None:
    """Write a program; ValueError when not all of its files lie in the folder of the first of its `roots` or below."""
    above, stream = _above(roots), io.BytesIO()
    for part in (_Head(engine_source(), _full_key(roots, key), digests, sys.version), program):
        _Packer(stream, above).dump(part)
    if os.fsencode(above) in stream.getvalue() or not all(path.startswith(above) for path in digests):
        raise ValueError(f"what goes to {file} depends on where {above} is")
    file.parent.mkdir(parents=True, exist_ok=True)
    temporary = file.with_name(f"{file.name}.{os.getpid()}")
    temporary.write_bytes(stream.getvalue())
    temporary.replace(file)


def is_shipped(file: Path, roots: Sequence[Path], key: str) -> bool:
    """Whether a file has the program as this engine would compile it now."""
    try:
        with file.open("rb") as stream:
            return _head(stream, roots, key) is not None
    except Exception:  # whatever pickle says of a file that is damaged
        return False


def read_shipped(file: Path, roots: Sequence[Path], key: str) -> tuple[Program, str, dict[str, str]] | None:
    """The program as this engine would compile it now, the Python that its bytecode is for, and the hashes of its files."""
    try:
        with file.open("rb") as stream:
            head = _head(stream, roots, key)
            return None if head is None else (_Unpacker(stream, _above(roots)).load(), head.python, head.digests)
    except Exception:
        return None


def _head(stream: IO[bytes], roots: Sequence[Path], key: str) -> _Head | None:
    head: _Head = _Unpacker(stream, _above(roots)).load()
    return head if (head.engine, head.key) == (engine_source(), _full_key(roots, key)) and unchanged(head.digests) else None


def _above(roots: Sequence[Path]) -> str:
    return f"{roots[0].parent}{os.sep}"


def _full_key(roots: Sequence[Path], key: str) -> str:
    return "\0".join([*(os.path.relpath(root, roots[0].parent) for root in roots), key])
