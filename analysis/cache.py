"""Component models of earlier runs, kept beside what was extracted: found by a hash of the facts and of all that makes models of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

from rosarch.base.cache import Cache, hash_of, version_of_packages
from rosarch.models.component import ComponentModel


@lru_cache(maxsize=1)
def models_version() -> str:
    """A hash of all but facts that models depend on: the rules, the engine, what makes models of rows."""
    return version_of_packages("analysis", "base", "datalog", "models", "rule_programs", "rules")


@dataclass(frozen=True)
class ModelCache:
    """The models of the components of `system` that `engine` derives; `rules` is a hash of rules other than those that ship."""

    cache: Cache
    system: str
    engine: str
    rules: str = ""
    _loaded: dict[str, tuple[ComponentModel, ...]] = field(default_factory=dict)

    def load(self, component: str, facts: str | None) -> tuple[ComponentModel, ...] | None:
        """The models of a component (see `build_models`), found by the hash of its facts; None when there are none."""
        if facts is None:
            return None
        key = self._key(component, facts)
        if key not in self._loaded:
            models = self.cache.load_value(key, tuple)
            if models is None:
                return None
            self._loaded[key] = models
        return self._loaded[key]

    def store(self, component: str, facts: str | None, models: tuple[ComponentModel, ...]) -> None:
        """Keep the models of a component, when its facts have a hash."""
        if facts:
            self.cache.store_value(self._key(component, facts), models)

    def _key(self, component: str, facts: str) -> str:
        return hash_of(["model", models_version(), self.system, self.engine, self.rules, component, facts])
