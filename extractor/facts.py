"""Facts on disk: one folder of Soufflé `.facts` files per component, checked against the schema."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path

from rosarch.base.files import path_below
from rosarch.datalog import RelationDecl, load_declarations, write_facts
from rosarch.extractor.manifest import FactsEntry, folder_digest, rules_folder

Row = tuple[str | int, ...]
Rows = Mapping[str, Iterable[Row]]


class SchemaError(ValueError):
    """A row that the schema does not allow: a defect of the extractor."""


@lru_cache(maxsize=1)
def schema() -> Mapping[str, RelationDecl]:
    """The relations of `rules/schema/`."""
    return load_declarations(rules_folder() / "schema.dl")


def validate(rows: Rows) -> None:
    """Check relation names, arities and base types; raise `SchemaError` at the first row that does not fit."""
    for relation, found in rows.items():
        declaration = schema().get(relation)
        if declaration is None:
            raise SchemaError(f"{relation}: no such relation in the schema")
        types = tuple(int if attribute.base == "number" else str for attribute in declaration.attributes)
        for row in found:
            if len(row) != len(types) or any(type(value) is not wanted for value, wanted in zip(row, types, strict=True)):
                raise SchemaError(f"{relation}: {row!r} does not fit ({', '.join(f'{a.name}: {a.type}' for a in declaration.attributes)})")


def write_component(out: Path, package: str, component: str, kind: str, sources: tuple[str, ...], rows: Rows) -> FactsEntry:
    """Write the facts of one component to `out`/`package`/`component`; every relation of the schema gets a file."""
    validate(rows)
    folder = path_below(out, package, component)
    folder.mkdir(parents=True, exist_ok=True)
    complete = {relation: sorted(rows.get(relation, ())) for relation in schema()}
    write_facts(folder, complete, schema())
    counts = {relation: len(found) for relation, found in complete.items()}
    return FactsEntry(package, component, kind, f"{package}/{component}", sources, counts, folder_digest(folder))
