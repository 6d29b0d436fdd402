"""Library files: what they may hold, and the documents in them. One file that is wrong costs that file."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosarch.base.diagnostics import Diagnostic, why
from rosarch.base.files import read_file
from rosarch.base.hints import hint
from rosarch.library.model import BY_HAND, GENERATED

COMPONENT_KINDS = ("node", "nodelet", "component", "plugin", "gazebo_plugin")
PORT_KINDS = (
    "publisher", "subscriber", "service_server", "service_client", "action_server", "action_client", "tf_broadcaster", "tf_listener",
    "dynamic_reconfigure_server",
)  # fmt: skip
OPERATIONS = ("read", "write", "has", "delete", "declare")
SHARE = "share"
"""The folder of a library that has the files of packages."""
_OF_NODE = ("node", "ns")
"""What braces may hold of any node of ROS 2: its name, its namespace."""
BRACES = re.compile(r"\{([^{}]*)\}")

Document = dict[str, Any]
Check = Callable[[Any], str | None]


@dataclass(frozen=True)
class LibraryFile:
    """A file that is as it should be."""

    path: Path
    package: str
    origin: str
    revision: str
    made: str
    components: tuple[Document, ...]
    ros: tuple[int, ...] = ()
    distributions: tuple[str, ...] = ()


def library_files(folder: Path) -> list[Path]:
    """The files of JSON below a folder, but for those of packages, which are data for other readers."""
    found = []
    for here, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name != SHARE]
        found += [Path(here, name) for name in names if name.endswith(".json")]
    return sorted(found)


def read_folder(folder: Path) -> tuple[tuple[LibraryFile, ...], tuple[Diagnostic, ...]]:
    """The files below a folder, and what is wrong with the others."""
    files, problems = [], []
    for path in library_files(folder):
        found = read_library_file(path)
        if isinstance(found, LibraryFile):
            files.append(found)
        else:
            problems.append(found)
    return tuple(files), tuple(problems)


def read_library_file(path: Path) -> LibraryFile | Diagnostic:
    """One file, or the first thing that is wrong with it."""
    try:
        data = json.loads(read_file(path).decode("utf-8"), parse_constant=_no_number)
    except OSError as error:
        return _problem(path, f"cannot be read: {why(error)}")
    except json.JSONDecodeError as error:
        return _problem(path, f"broken JSON: {error.msg.lower()}", error.lineno, error.colno)
    except UnicodeDecodeError:
        return _problem(path, "is not UTF-8")
    except ValueError as error:
        return _problem(path, f"broken JSON: {str(error).partition(';')[0]}")
    except RecursionError:
        return _problem(path, "is nested too deeply")
    wrong = next(_file_problems(data), None)
    if wrong is not None:
        return _problem(path, wrong)
    return LibraryFile(
        path,
        *(data[key] for key in ("package", "origin", "revision", "made")),
        *(tuple(data.get(key, ())) for key in ("components", "ros", "distributions")),
    )


def _no_number(text: str) -> None:
    raise ValueError(f"{text} is no number of JSON")


def _problem(path: Path, message: str, line: int = 1, column: int = 1) -> Diagnostic:
    return Diagnostic("library", path, line, column, message)


def _text(value: Any) -> str | None:
    return None if isinstance(value, str) and value else "must be a text that is not empty"


def _flag(value: Any) -> str | None:
    return None if isinstance(value, bool) else "must be true or false"


def _count(least: int) -> Check:
    def check(value: Any) -> str | None:
        fits = isinstance(value, int) and not isinstance(value, bool) and value >= least
        return None if fits else f"must be a whole number of {least} or more"

    return check


def _one_of(known: Iterable[str]) -> Check:
    choices = tuple(known)

    def check(value: Any) -> str | None:
        if value in choices:
            return None
        near = hint(value, choices) if isinstance(value, str) else ""
        return f"{json.dumps(value)} is none of {', '.join(choices)}{near}"

    return check


def _pattern(value: Any) -> str | None:
    if _text(value):
        return _text(value)
    try:
        re.compile(value)
    except (re.error, RecursionError, OverflowError) as error:
        return f"is no regular expression ({error})"
    return None


def _open(value: Any) -> str | None:
    return None if isinstance(value, bool) or value in ("ports", "params") else 'must be true, false, "ports" or "params"'


def _texts(value: Any) -> str | None:
    return None if isinstance(value, list) and all(isinstance(item, str) for item in value) else "must be a list of texts"


def _arguments(value: Any) -> str | None:
    if isinstance(value, dict) and all(
        re.fullmatch("[1-9][0-9]*", key) and (item == "" or _pattern(item) is None) for key, item in value.items()
    ):
        return None
    return 'must map numbers of arguments to regular expressions, as in {"1": "messages"}'


def _elements(value: Any) -> str | None:
    if isinstance(value, dict) and all(item is None or isinstance(item, str) for item in value.values()):
        return None
    return "must map names of elements to their default text, or to null"


def _made_nodes(value: Any) -> str | None:
    if isinstance(value, dict) and all(isinstance(one, str) and re.fullmatch(r"[^/]+/[^/]+", one) for one in value.values()):
        return None
    return "must map names of nodes to `PACKAGE/COMPONENT`"


def _versions(value: Any) -> str | None:
    fits = isinstance(value, list) and value and all(item in (1, 2) and not isinstance(item, bool) for item in value)
    return None if fits else "must be a list of versions of ROS, 1 or 2"


def _scalar(value: Any) -> str | None:
    return None if isinstance(value, str | int | float | bool) else "must be a single value"


def _list(value: Any) -> str | None:
    return None if isinstance(value, list) else "must be a list"


_FILE: Mapping[str, Check] = {
    "package": _text, "origin": _text, "revision": _text, "ros": _versions, "distributions": _texts,
    "made": _one_of((GENERATED, BY_HAND)), "components": _list,
}  # fmt: skip
_COMPONENT: Mapping[str, Check] = {
    "component": _text, "kind": _one_of(COMPONENT_KINDS), "node_name": _text, "base": _text, "loads": _texts, "open": _open,
    "replace": _flag, "options": _texts, "elements": _elements, "namespace_element": _text, "makes": _made_nodes, "ports": _list,
    "params": _list,
}  # fmt: skip
_PORT: Mapping[str, Check] = {
    "kind": _one_of(PORT_KINDS), "name": _text, "type": _text, "from_param": _text, "queue": _count(0), "latched": _flag, "via": _text,
    "implicit": _flag, "conditional": _text, "from_arg": _count(1), "rest": _flag, "if_arg": _arguments, "param_pattern": _pattern,
    "suffix": _text,
}  # fmt: skip
_PARAMETER: Mapping[str, Check] = {"name": _text, "op": _one_of(OPERATIONS), "type": _text, "default": _scalar, "pattern": _pattern}


def _fields(data: Any, where: str, known: Mapping[str, Check], required: Iterable[str]) -> Iterator[str]:
    """What is wrong with the fields of an object, each of which must be known."""
    if not isinstance(data, dict):
        yield f"{where}: must be an object"
        return
    for key, value in data.items():
        if key not in known:
            yield f"{where}: unknown field `{key}`{hint(key, known)}"
        elif (wrong := known[key](value)) is not None:
            yield f"{where}: `{key}` {wrong}"
    for key in required:
        if key not in data:
            yield f"{where}: `{key}` is missing"


def _file_problems(data: Any) -> Iterator[str]:
    yield from _fields(data, "file", _FILE, [key for key in _FILE if key not in ("ros", "distributions")])
    seen = set()
    for number, component in enumerate(data["components"]):
        yield from _fields(component, f"components[{number}]", _COMPONENT, ("component", "kind"))
        name = component["component"]
        if name in seen:
            yield f"components[{number}]: {name} is there twice"
        seen.add(name)
        for key, known in (("ports", _PORT), ("params", _PARAMETER)):
            for index, item in enumerate(component.get(key, ())):
                yield from _fields(item, f"{name}: {key}[{index}]", known, ("kind",) if key == "ports" else ())
                yield from (
                    f"{name}: {key}[{index}]: {wrong}" for wrong in (_port_problems if key == "ports" else _parameter_problems)(item)
                )
        yield from (f"{name}: {wrong}" for wrong in _undeclared_elements(component))


def _port_problems(port: Document) -> Iterator[str]:
    if not port.keys() & {"name", "from_param", "from_arg", "param_pattern"}:
        yield "nothing names it: give `name`, `from_param`, `from_arg` or `param_pattern`"
    if port.get("rest") and "from_arg" not in port:
        yield "`rest` needs `from_arg`"


def _parameter_problems(parameter: Document) -> Iterator[str]:
    if ("name" in parameter) == ("pattern" in parameter):
        yield "needs either `name` or `pattern`"


def _undeclared_elements(component: Document) -> Iterator[str]:
    """The names in braces of a plug-in of gazebo are elements, those of others the numbers of arguments, or options."""
    elements = component.get("elements", {})
    for index, port in enumerate(component.get("ports", ())):
        for key in ("name", "type"):
            for name in BRACES.findall(port.get(key) or ""):
                if component["kind"] == "gazebo_plugin":
                    if name not in elements:
                        yield f"ports[{index}]: `{name}` is none of the component's `elements`{hint(name, elements)}"
                elif name not in (*elements, *_OF_NODE) and not re.fullmatch("0|[1-9][0-9]*", name):
                    yield f"ports[{index}]: {{{name}}} is no number of an argument"
