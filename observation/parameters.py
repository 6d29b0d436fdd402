"""The parameters of a graph: a tree of values, each under a name such as `/robot/wheels/left`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any


class Parameters:
    """A tree of values; a name that is not there is a LookupError."""

    def __init__(self) -> None:
        self._tree: dict[str, Any] = {}

    @staticmethod
    def absolute(caller: str, key: str) -> str:
        """The name that `key` means for a node: absolute, private (`~x`) or beside the node."""
        name = key if key.startswith("/") else f"{caller}/{key[1:]}" if key.startswith("~") else f"{caller.rpartition('/')[0]}/{key}"
        return f"/{'/'.join(filter(None, name.split('/')))}"

    def value(self, name: str) -> Any:
        """What is at `name`, a tree when there is more below it."""
        found: Any = self._tree
        for part in _parts(name):
            if not isinstance(found, dict) or part not in found:
                raise LookupError(f"Parameter [{name}] is not set")
            found = found[part]
        return found

    def has(self, name: str) -> bool:
        """Whether there is something at `name`."""
        try:
            self.value(name)
        except LookupError:
            return False
        return True

    def set(self, name: str, value: Any) -> None:
        """Put a value, or a tree of them, at `name`."""
        *above, last = _parts(name) or [""]
        if not last:
            self._tree = dict(value)
            return
        tree = self._tree
        for part in above:
            below = tree.get(part)
            tree[part] = tree = below if isinstance(below, dict) else {}
        tree[last] = value

    def delete(self, name: str) -> None:
        """Take away what is at `name`."""
        self.value(name)
        *above, last = _parts(name)
        tree = self.value("/".join(above))
        del tree[last]

    def search(self, caller: str, key: str) -> str:
        """The first name that ends with `key`, from the node upwards, whose first part is there."""
        if key.startswith("/"):
            return key
        first, above = key.split("/")[0], caller
        while True:
            if self.has(f"{above}/{first}"):
                return f"{above}/{key}"
            if not above:
                raise LookupError(f"Cannot find parameter [{key}] in an upwards search")
            above = above.rpartition("/")[0]

    def names(self) -> list[str]:
        """The names of all values that are no trees."""
        return list(_leaves(self._tree))


def _leaves(tree: dict[str, Any], above: str = "") -> Iterator[str]:
    """The names of the values in a tree that are no trees."""
    for part, value in tree.items():
        if isinstance(value, dict):
            yield from _leaves(value, f"{above}/{part}")
        else:
            yield f"{above}/{part}"


def _parts(name: str) -> list[str]:
    return [part for part in name.split("/") if part]
