"""The version of the extractor: facts of another one are extracted again."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import clang.native

from rosarch.base.cache import hash_of, version_of, version_of_packages
from rosarch.extractor.manifest import rules_folder


@lru_cache(maxsize=1)
def extractor_version() -> str:
    """A hash of everything but the input that facts depend on: the extractor with its headers, the schema, libclang, Python."""
    folders = (rules_folder() / "schema", *map(Path, clang.native.__path__))
    return hash_of([version_of_packages("base", "extractor"), version_of(folders)])
