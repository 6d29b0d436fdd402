"""The components that a question is about: their facts, from sources or from a folder of facts."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.base.diagnostics import Diagnostic
from rosarch.base.hints import hint, hint_or_all
from rosarch.datalog import read_facts
from rosarch.extractor.facts import schema
from rosarch.extractor.settings import DEFAULT, Settings
from rosarch.extractor.stored_facts import has_facts, read_stored

Facts = Mapping[str, Iterable[tuple[Any, ...]]]


class SelectionError(Exception):
    """There is no component of the given name."""


@dataclass(frozen=True)
class SelectedComponent:
    """A component; `root` is the folder that paths of its sources start from, `key` a hash of its facts, where there is one."""

    name: str
    package: str
    root: Path
    load: Callable[[], Facts]
    key: str | None = None

    @property
    def title(self) -> str:
        """`package/component`."""
        return f"{self.package}/{self.name}" if self.package else self.name


@dataclass(frozen=True)
class Selection:
    """The selected components, sorted by package and name, and what was not understood on the way."""

    components: tuple[SelectedComponent, ...]
    diagnostics: tuple[Diagnostic, ...] = ()


def is_component_facts(folder: Path) -> bool:
    """Whether a folder holds the facts of one component."""
    return next(folder.glob("*.facts"), None) is not None


@contextmanager
def select(
    folder: Path,
    packages: Collection[str] | None = None,
    component: str | None = None,
    settings: Settings = DEFAULT,
) -> Iterator[Selection]:
    """The components of `packages` (all by default) below a folder of sources, or of stored facts, or one of them.

    `component` is NAME or PACKAGE/NAME. Facts are read when they are asked for, before the context ends.
    """
    if has_facts(folder):
        facts = read_stored(folder)
        stored = [SelectedComponent(c.name, c.package, facts.root, c.rows) for c in facts.components]
        for package in sorted(set(packages or ()) - {c.package for c in stored}):
            raise SelectionError(f"no package {package} among these facts{hint(package, {c.package for c in stored})}")
        yield Selection(_named([c for c in stored if not packages or c.package in packages], component))
    elif is_component_facts(folder):  # written by hand
        own = SelectedComponent(folder.resolve().name, folder.resolve().parent.name, folder, lambda: read_facts(folder, schema()))
        yield Selection((own,))
    else:
        from rosarch.extractor.pipeline import extract  # and with it libclang

        with extract(folder, packages, settings) as extraction:
            found = [SelectedComponent(c.name, c.package, extraction.root, c.rows, c.key) for c in extraction.components]
            yield Selection(_named(found, component), tuple(extraction.diagnostics))


def _named(components: Collection[SelectedComponent], name: str | None) -> tuple[SelectedComponent, ...]:
    found = tuple(c for c in components if name is None or name in (c.name, c.title))
    if name is not None and components and not found:
        raise SelectionError(f"no component {name}{hint_or_all(name, {n for c in components for n in (c.name, c.title)})}")
    return tuple(sorted(found, key=lambda c: (c.package, c.name)))
