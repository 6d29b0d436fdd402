"""Results of whole stages, kept in the cache with what they rest on: a stage is done again when any of that has changed."""

from __future__ import annotations

import pickle
import sysconfig
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import TypeVar, cast

from rosarch.base import tracing
from rosarch.base.boundary import folders
from rosarch.base.cache import Cache, hash_of, version_of_packages

Value = TypeVar("Value")
_PACKAGES = ("analysis", "base", "datalog", "extractor", "findings", "library", "models", "rule_programs", "rules")


@lru_cache(maxsize=1)
def stage_version() -> str:
    """A hash of all but input that results depend on: the packages that make them, and which others are installed beside it."""
    installed = [Path(sysconfig.get_path(name)) for name in ("purelib", "platlib")]
    return hash_of([version_of_packages(*_PACKAGES), *(f"{folder} {folder.stat().st_mtime_ns}" for folder in installed)])


@dataclass(frozen=True)
class Memo:
    """Results of earlier runs, for one run: what it finds in files, trees and variables is taken to stay so while it lasts."""

    cache: Cache
    variables: Mapping[str, str] = field(default_factory=dict)
    _present: list[tracing.Present] = field(default_factory=list)

    def recall(self, key: Iterable[str], trees: Iterable[str], make: Callable[[], Value]) -> Value:
        """What `make` comes to with the parameters `key`, made again only when what it saw when it was made last is not so now.

        `make` may look at everything below `trees`, and read files and variables as `tracing` records it.
        """
        name = hash_of(["stage", stage_version(), *folders(), "", *key])
        known = self._stored(name)
        if known is not None:
            tracing.seen(known[0])
            return cast(Value, known[1])
        with tracing.recording(self.present.trees(tuple(trees))) as rests_on:
            value = make()
        if not rests_on.uncertain:
            self._keep(name, rests_on.trace(), pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL))
        return value

    @property
    def present(self) -> tracing.Present:
        """How things are now."""
        if not self._present:
            self._present.append(tracing.Present(self.variables))
        return self._present[0]

    def _stored(self, name: str) -> tuple[tracing.Trace, object] | None:
        data = self.cache.load(name)
        if data is None:
            return None
        try:
            then, value = pickle.loads(data)
            now = self.present.confirms(then)
            if now is None:
                return None
            found = now, pickle.loads(value)
        except Exception:  # the checksum was right, so that it is another version's; whatever pickle then says
            return None
        if now is not then:
            self._keep(name, now, value)
        return found

    def _keep(self, name: str, rests_on: tracing.Trace, value: bytes) -> None:
        self.cache.store(name, pickle.dumps((rests_on, value), protocol=pickle.HIGHEST_PROTOCOL))
