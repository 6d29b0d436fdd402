"""What earlier runs found of the units of a workspace, in one entry, with the files that each rests on.

A unit none of whose files has changed needs no other look: its includes are not followed again, and its rows not read unless they are
wanted. That holds while all names in the workspace are the same, and all else that units rest on but their files.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeVar

from rosarch.base import tracing
from rosarch.base.boundary import folders
from rosarch.base.cache import Cache, hash_of
from rosarch.extractor.units import AnyUnit, Outcomes, UnitFile
from rosarch.extractor.version import extractor_version

Unit = TypeVar("Unit", bound=AnyUnit)


@dataclass
class UnitIndex:
    """The units that are as they were; `trace` is what all of them rest on together, `guard` a hash of what else they rest on."""

    cache: Cache
    name: str
    guard: str
    trace: tracing.Trace
    units: dict[str, UnitFile] = field(default_factory=dict)

    @classmethod
    def load(cls, cache: Cache, key: Iterable[str], rests_on: tracing.Recording) -> UnitIndex:
        """The index of the units that are made by the parameters `key` from what `rests_on` has seen, in addition to their files."""
        name = hash_of(["units", extractor_version(), *folders(), "", *rests_on.trees, "", *key])
        index = cls(cache, name, _guard(rests_on), tracing.Trace(rests_on.trees, {}, {}, {}))
        guard, then, units = cache.load_value(name, tuple) or ("", index.trace, {})
        if guard == index.guard and tracing.Present({}).confirms(replace(then, trees={}, reads={})):
            changes = dict(tracing.changes(then.reads))
            changed = {path for path, now in changes.items() if now is None}
            index.units = {unit: file for unit, file in units.items() if changed.isdisjoint(file.files)}
            index.trace = replace(then, reads={**then.reads, **{path: now for path, now in changes.items() if now is not None}})
        return index

    def read(self, units: Sequence[Unit], read: Callable[[Sequence[Unit], Mapping[Unit, UnitFile]], Outcomes[Unit]]) -> Outcomes[Unit]:
        """What becomes of units when they are `read` with those that are known; there may be no file of the rows of these."""
        names = {unit: repr(unit) for unit in units}
        known = {unit: self.units[name] for unit, name in names.items() if name in self.units}
        tracing.seen(replace(self.trace, trees={}, reads=self._reads(known.values())))
        with tracing.recording(self.trace.trees) as seen:
            found = read(units, known)
        if len(known) < len(units) and not seen.uncertain:
            self._keep({names[unit]: file for unit, file in found.files.items() if isinstance(file, UnitFile) and file.certain}, seen)
        return found

    def _keep(self, found: Mapping[str, UnitFile], seen: tracing.Recording) -> None:
        self.trace = replace(self.trace, reads={**self.trace.reads, **seen.reads}, probes={**self.trace.probes, **seen.probes})
        paths: dict[str, str] = {}
        for name, file in found.items():
            files = tuple(paths.setdefault(path, os.path.abspath(path)) for path in file.files)
            if self.trace.reads.keys() >= set(files):
                self.units[name] = replace(file, files=files)
        self.trace = replace(self.trace, reads=self._reads(self.units.values()))
        self.cache.store_value(self.name, (self.guard, self.trace, self.units))

    def _reads(self, files: Iterable[UnitFile]) -> dict[str, tracing.Read]:
        return {path: self.trace.reads[path] for path in {path for file in files for path in file.files}}


def _guard(rests_on: tracing.Recording) -> str:
    """A hash of what was seen."""
    reads = (f"{path} {digest}" for path, (digest, _) in sorted(rests_on.reads.items()))
    others = (repr(sorted(found.items())) for found in (rests_on.trees, rests_on.probes, rests_on.variables))
    return hash_of([*reads, "", *others])
