"""How sources are read."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rosarch.base.limits import SOURCE_SECONDS
from rosarch.extractor.underlay import NOTHING_INSTALLED, Underlay

if TYPE_CHECKING:
    from rosarch.base.cache import Cache

Progress = Callable[[str, int, int], None]
"""Is called with the stage and how many are done, and of how many."""


@dataclass(frozen=True)
class Settings:
    """How sources are read: by `jobs` processes, or as many as there are processors, with `timeout` as the limit in seconds for one source.

    `defines` are CMake cache variables, `underlay` is what is installed. With a `cache`, only what has changed since an
    earlier time is read again. `whole`: sources that nothing builds, imports or starts are read, too, as components of their own.
    """

    jobs: int | None = None
    timeout: float = SOURCE_SECONDS
    defines: Mapping[str, str] = field(default_factory=dict)
    cache: Cache | None = None
    progress: Progress | None = None
    underlay: Underlay = NOTHING_INSTALLED
    whole: bool = False

    def key(self) -> list[str]:
        """All that the result depends on, but for the sources."""
        return [repr(sorted(self.defines.items())), repr(self.timeout), repr(self.whole), *self.underlay.key()]


DEFAULT = Settings()
