"""What is analysed: a folder of sources or of facts, its components, and the truth about them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.base.cache import hash_of, rows_digest
from rosarch.base.hints import hint
from rosarch.evaluation.experiments.truth import Truth, TruthError
from rosarch.extractor.settings import Settings
from rosarch.extractor.stored_facts import Facts, has_facts, read_stored

if TYPE_CHECKING:
    from rosarch.extractor.workspace import Component, Diagnostic


@dataclass(frozen=True)
class Subject:
    """A system: its folder, and the truth about components of it.

    Only the components that there is truth of are analysed, without truth those of `packages`, or all. If it is `checked`, so are its
    systems; `findings` are the errors and warnings that are true of these, each the id of the check and `path:line`.
    """

    name: str
    folder: Path
    truths: tuple[Truth, ...] = ()
    packages: tuple[str, ...] = ()
    defines: Mapping[str, str] = field(default_factory=dict)
    checked: bool = False
    findings: frozenset[tuple[str, str]] | None = None

    def wants(self, package: str, component: str) -> bool:
        """Whether a component is analysed."""
        if self.truths:
            return any((truth.package, truth.program) == (package, component) for truth in self.truths)
        return not self.packages or package in self.packages


@dataclass(frozen=True)
class OpenSubject:
    """A subject whose facts are available; `absent` is the truth of components that it does not have."""

    subject: Subject
    components: tuple[Facts, ...]
    diagnostics: tuple[Diagnostic, ...]
    absent: tuple[Truth, ...]


@contextmanager
def opened(subject: Subject, settings: Settings, *, absent: bool = False) -> Iterator[OpenSubject]:
    """Read the facts of a subject, or extract them.

    Raises:
        TruthError: truth is of a component that does not exist, and such must not be `absent`.
        ManifestError: a folder of facts is stale or damaged.
    """
    if has_facts(subject.folder):
        found = _stored(subject)
        _require(found, absent)
        yield found
        return
    from rosarch.extractor.pipeline import extract

    seen: set[tuple[str, str]] = set()

    def wanted(component: Component) -> bool:
        seen.add((component.package, component.name))
        return subject.wants(component.package, component.name)

    packages = sorted({truth.package for truth in subject.truths} or set(subject.packages)) or None
    with extract(subject.folder, packages, replace(settings, defines=subject.defines), only=wanted) as extraction:
        components = tuple(
            Facts(c.name, c.package, c.kind, c.sources, c.key or rows_digest(c.rows()), c.rows) for c in extraction.components
        )
        found = OpenSubject(subject, components, tuple(extraction.diagnostics), _absent(subject, seen))
        _require(found, absent, seen)
        yield found


def _stored(subject: Subject) -> OpenSubject:
    stored = read_stored(subject.folder)
    components = tuple(c for c in stored.components if subject.wants(c.package, c.name))
    return OpenSubject(subject, components, stored.diagnostics, _absent(subject, {(c.package, c.name) for c in stored.components}))


def _absent(subject: Subject, known: Collection[tuple[str, str]]) -> tuple[Truth, ...]:
    return tuple(truth for truth in subject.truths if (truth.package, truth.program) not in known)


def _require(found: OpenSubject, absent: bool, known: Collection[tuple[str, str]] = ()) -> None:
    if found.absent and not absent:
        known = known or [(component.package, component.name) for component in found.components]
        raise TruthError("\n".join(_absence_message(truth, found.subject, known) for truth in found.absent))


def _absence_message(truth: Truth, subject: Subject, known: Collection[tuple[str, str]]) -> str:
    names = [name for package, name in known if package == truth.package]
    near = hint(truth.component, names) or hint(truth.title, [f"{package}/{name}" for package, name in known])
    return f"{truth.at}:{truth.at.column}: no component {truth.title} in {subject.folder}{near}"


def about(subject: Subject, component: Facts) -> list[Truth]:
    """The truth about a component and about its nodes."""
    return [truth for truth in subject.truths if (truth.package, truth.program) == (component.package, component.name)]


def digest_of(parts: Sequence[str]) -> str:
    """A short hash of hashes, in whatever order these come."""
    return hash_of(sorted(parts))[:16]
