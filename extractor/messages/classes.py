"""The C++ classes that stand for interfaces."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.extractor.messages.model import MessageStore


@dataclass(frozen=True, slots=True)
class MessageClass:
    """A C++ class and the interface it stands for.

    `kind` is `message`, `service`, `action` (the wrapper class that `SimpleActionServer` takes) or `config`. `role` and `owner` say, for a
    part of a service or action, which part of which.
    """

    cxx_class: str
    type: str
    kind: str
    role: str = ""
    owner: str | None = None


def message_classes(store: MessageStore) -> list[MessageClass]:
    """All classes of a store, sorted by name."""
    result: list[MessageClass] = []
    for name, message in store.messages.items():
        kind = "action" if message.role == "action" else "message"
        result.append(MessageClass(f"{_scoped(name)}_", name, kind, message.role, message.owner))
    for name in store.services:
        if name not in store.messages:
            result.append(MessageClass(_scoped(name), name, "service", "service"))
    for name in store.configs:
        result.append(MessageClass(f"{_scoped(name)}Config", name, "config", "config"))
    return sorted(result, key=lambda found: found.cxx_class)


def _scoped(name: str) -> str:
    return name.replace("/", "::")
