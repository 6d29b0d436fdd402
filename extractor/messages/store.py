"""Collect the interfaces of workspace packages and the common ones into one store."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path

from rosarch.base.diagnostics import Diagnostic, unreadable
from rosarch.base.files import LARGEST_PARSED, path_text, read_file
from rosarch.extractor.messages.common_interfaces import common_interfaces
from rosarch.extractor.messages.dynamic_reconfigure import parse_config
from rosarch.extractor.messages.model import PRIMITIVES, Action, Config, Message, MessageStore, Service
from rosarch.extractor.messages.parse import parse_action, parse_message, parse_service
from rosarch.extractor.workspace.model import ROS1, Package


def load_messages(packages: Iterable[Package], *, with_common: bool = True, middleware: str = ROS1) -> MessageStore:
    """The interfaces of `packages`, which win over common ones of the same name. A file that cannot be read costs that file."""
    packages = list(packages)
    messages, services, actions = common_interfaces(middleware) if with_common else ({}, {}, {})
    loader = _Loader(packages, messages, services, actions)
    own: set[str] = set()
    for package in packages:
        own.update(loader.load(package))
    for name in sorted(own):
        messages[name] = loader.checked(messages[name])
    diagnostics = sorted(set(loader.problems), key=lambda d: (str(d.path), d.line, d.column, d.message))
    return MessageStore(messages, services, actions, loader.configs, tuple(diagnostics))


class _Loader:
    def __init__(
        self, packages: list[Package], messages: dict[str, Message], services: dict[str, Service], actions: dict[str, Action]
    ) -> None:
        self.packages = packages
        self.messages = messages
        self.services = services
        self.actions = actions
        self.configs: dict[str, Config] = {}
        self.problems: list[Diagnostic] = []

    def load(self, package: Package) -> list[str]:
        """Read a package's files; the names of its messages."""
        own: list[str] = []
        for path, text in self._texts(package, package.message_files, "msg"):
            message = parse_message(text, f"{package.name}/{path_text(path.stem)}", path, self.problems)
            self.messages[message.name] = message
            own.append(message.name)
        for path, text in self._texts(package, package.service_files, "srv"):
            service, parts = parse_service(text, f"{package.name}/{path_text(path.stem)}", path, self.problems)
            self.services[service.name] = service
            own.extend(self._add(parts))
        for path, text in self._texts(package, package.action_files, "action"):
            action, parts = parse_action(text, f"{package.name}/{path_text(path.stem)}", path, self.problems)
            self.actions[action.name] = action
            own.extend(self._add(parts))
        for path, text in self._texts(package, package.cfg_files, None):
            config = parse_config(text, package, path, self.packages, self.problems)
            if config is not None:
                self.configs[config.name] = config
        return own

    def _add(self, parts: list[Message]) -> list[str]:
        self.messages.update({part.name: part for part in parts})
        return [part.name for part in parts]

    def _texts(self, package: Package, declared: tuple[Path, ...], kind: str | None) -> Iterable[tuple[Path, str]]:
        """The declared files, then the others of the usual folder: code may use what a commented line of CMake hides."""
        others = sorted((package.path / kind).glob(f"*.{kind}")) if kind else ()
        files = dict.fromkeys((*declared, *others))
        for path in files:
            try:
                data = read_file(path, LARGEST_PARSED)
            except OSError as error:
                self.problems.append(unreadable(path, error))
                continue
            try:
                yield path, data.decode("utf-8-sig")
            except UnicodeDecodeError as error:
                line = data.count(b"\n", 0, error.start) + 1
                self.problems.append(Diagnostic("encoding", path, line, 1, "not UTF-8"))
                yield path, data.decode(errors="replace")

    def checked(self, message: Message) -> Message:
        """The message with fields of unknown types marked and reported."""
        if all(field.type in PRIMITIVES or field.type in self.messages for field in message.fields):
            return message
        fields = []
        for field in message.fields:
            if field.type in PRIMITIVES or field.type in self.messages:
                fields.append(field)
                continue
            fields.append(replace(field, type_exists=False))
            text = f"unknown type {field.type} of field {field.name}{_hint(field.type, self.messages)}"
            self.problems.append(Diagnostic("unknown-type", message.path or Path(), field.line, field.column, text))
        return replace(message, fields=tuple(fields))


def _hint(name: str, known: Iterable[str]) -> str:
    short = name.rpartition("/")[2]
    same = sorted(other for other in known if other.rpartition("/")[2] == short)
    close = same or get_close_matches(name, sorted(known), n=1, cutoff=0.8)
    return f", did you mean `{close[0]}`?" if close else ""
