"""Definitions of the packages that nearly every ROS system uses but no source tree contains.

Messages come from the type stores of `rosbags`. What these lack, all services and actions among it, is in `common/*.txt`: one file
per package, `=== msg Name`, `=== srv Name` or `=== action Name` before each definition; for ROS 2 also in `common/ros2/*.txt`.
"""

from __future__ import annotations

import json
import re
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from rosarch.base.cache import Cache, hash_of
from rosarch.base.diagnostics import Diagnostic
from rosarch.datalog.cache import cache_folder
from rosarch.extractor.messages.model import UNBOUNDED, Action, Constant, Field, Message, Service
from rosarch.extractor.messages.parse import parse_action, parse_message, parse_service
from rosarch.extractor.version import extractor_version
from rosarch.extractor.workspace.model import ROS1, ROS2

COMMON = Path(__file__).parent / "common"
_STORES = {ROS1: ("ros1_noetic",), ROS2: ("ros2_humble", "ros2_lyrical")}
_SECTION = re.compile(r"^=== (msg|srv|action) (\w+)[ \t]*$", re.MULTILINE)


def common_interfaces(middleware: str = ROS1) -> tuple[dict[str, Message], dict[str, Service], dict[str, Action]]:
    """All common messages, services and actions by `pkg/Name`."""
    stored = stored_messages(middleware)
    messages = dict(stored)
    services: dict[str, Service] = {}
    actions: dict[str, Action] = {}
    problems: list[Diagnostic] = []
    for path in (*sorted(COMMON.glob("*.txt")), *(sorted(COMMON.glob("ros2/*.txt")) if middleware == ROS2 else ())):
        pieces = _SECTION.split(path.read_text(encoding="utf-8"))
        for kind, short, text in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
            name = f"{path.stem}/{short}"
            if kind == "msg":
                messages[name] = parse_message(text, name, path, problems)
            elif kind == "srv":
                services[name], parts = parse_service(text, name, path, problems)
                messages.update({part.name: part for part in parts})
            else:
                actions[name], parts = parse_action(text, name, path, problems)
                messages.update({part.name: part for part in parts})
    if middleware == ROS2:
        messages.update(stored)  # the text files are those of ROS 1 in the first place
    return messages, services, actions


def stored_messages(middleware: str = ROS1) -> dict[str, Message]:
    """The messages of the rosbags stores. Importing these takes longer than all else here, so JSON copies are cached."""
    return {name: message for store in _STORES[middleware] for name, message in _stored(store).items()}


def _stored(store: str) -> dict[str, Message]:
    spec = find_spec("rosbags.typesys")
    origin = Path(spec.origin).parent / "stores" / f"{store}.py" if spec and spec.origin else None
    if origin is None or not origin.is_file():
        return {}
    stat = origin.stat()
    key = hash_of([extractor_version(), str(origin), str(stat.st_size), str(stat.st_mtime_ns)])
    cache = Cache(cache_folder() / "messages")
    data = cache.load(key)
    if data is None:
        data = json.dumps(_store_table(store), separators=(",", ":")).encode()
        cache.store(key, data)
    table = json.loads(data)
    return {name: _message(name, row) for name, row in table.items()}


def _message(name: str, row: list[list[list[Any]]]) -> Message:
    constants, fields = row
    return Message(name, tuple(Field(*parts) for parts in fields), tuple(Constant(*parts) for parts in constants))


_TIMES = {"builtin_interfaces/Time": "time", "builtin_interfaces/Duration": "duration"}


def _store_table(store: str) -> dict[str, list[list[list[Any]]]]:
    definitions = import_module(f"rosbags.typesys.stores.{store}").FIELDDEFS
    table: dict[str, list[list[list[Any]]]] = {}
    for full, (constants, fields) in definitions.items():
        name = full.replace("/msg/", "/")
        rows: list[list[Any]] = [[field, *_type(description)] for field, description in fields]
        constant_rows: list[list[Any]] = [[constant, kind, str(value)] for constant, kind, value in constants]
        table[name] = [constant_rows, rows]
    return {name: row for name, row in table.items() if store not in _STORES[ROS1] or name not in _TIMES}


def _type(description: Any) -> tuple[str, int | None]:
    """A rosbags field description as type and array length."""
    node, detail = int(description[0]), description[1]
    if node == 1:
        return detail[0], None
    if node == 2:
        name = detail.replace("/msg/", "/")
        return _TIMES.get(name, name), None
    inner, _array = _type(detail[0])
    return inner, detail[1] if node == 3 else UNBOUNDED
