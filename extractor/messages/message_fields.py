"""The fields of messages, as far as all of a message are known."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from rosarch.extractor.messages.common_interfaces import COMMON
from rosarch.extractor.messages.model import Message, MessageStore
from rosarch.extractor.workspace.model import ROS2, Package

_TIMES = {"time": "builtin_interfaces/Time", "duration": "builtin_interfaces/Duration"}
_SAME_IN_BOTH = frozenset({"std_srvs"})
_EMPTY = re.compile(r"[+-]?0*\.?0*|[Ff]alse|\"\"|''")
_PARTS = {"request": ("Request",), "response": ("Response",), "service": ("Request", "Response"), "action": ("Goal", "Result", "Feedback")}


@dataclass(frozen=True)
class MessageFields:
    """Rows of `message_field` by the type of the message; what has no fields has none. `defaults`: fields of some that begin otherwise."""

    rows: Mapping[str, tuple[tuple[str, str, str, str], ...]]
    defaults: frozenset[str] = frozenset()

    @classmethod
    def of(cls, store: MessageStore | None, packages: Iterable[Package], middleware: str) -> MessageFields:
        """Those of all messages that are read without a doubt."""
        if store is None:
            return cls({})
        doubtful = {problem.path for problem in store.diagnostics}
        twice = {name for name, count in Counter(package.name for package in packages).items() if count > 1}
        known = [message for message in store.messages.values() if message.path not in doubtful and _package(message.name) not in twice]
        if middleware == ROS2:
            known = [message for message in known if not _of_ros1(message.path, message.name)]
        fields = (field for message in store.messages.values() if middleware == ROS2 for field in message.fields)
        defaults = frozenset(field.name for field in fields if field.default and not _EMPTY.fullmatch(field.default))
        return cls({message.name: _rows(message, middleware) for message in known}, defaults)

    def used(self, classes: Iterable[tuple[str | int, ...]]) -> dict[str, set[tuple[str | int, ...]]]:
        """The facts about the messages that rows of `message_class` are of, and about those that they are made of."""
        facts: dict[str, set[tuple[str | int, ...]]] = defaultdict(set)
        waiting = [f"{type_}{part}" for _, kind, type_ in classes for part in _PARTS.get(str(kind), ("",))]
        while waiting:
            name = waiting.pop()
            if (name,) in facts["message_known"] or name not in self.rows:
                continue
            facts["message_known"].add((name,))
            facts["message_field"].update(self.rows[name])
            waiting += [row[2] for row in self.rows[name]]
        return dict(facts)


def _package(name: str) -> str:
    return name.partition("/")[0]


def _of_ros1(path: Path | None, name: str) -> bool:
    """Whether a message is one of those that replace messages of ROS 2, and may differ."""
    return path is not None and path.parent == COMMON and _package(name) not in _SAME_IN_BOTH


def _rows(message: Message, middleware: str) -> tuple[tuple[str, str, str, str], ...]:
    times = _TIMES if middleware == ROS2 else {}
    constants = ((message.name, constant.name, "constant", "one") for constant in message.constants)
    fields = (
        (
            message.name,
            field.name,
            times.get(field.type, field.type) if field.type_exists else "?",
            "one" if field.array is None else "many",
        )
        for field in message.fields
    )
    return (*fields, *constants)
