"""Several sources of one component laid over each other.

What was generated from sources is the base, the first that exists; what was written by hand is laid over it, so that a base can be
generated again without loss.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from rosarch.library.model import BY_HAND, GENERATED, LibraryComponent, LibraryParameter, LibraryPort
from rosarch.library.reading import Document, LibraryFile

Source = tuple[LibraryFile, Document]
COMPLETED = f"{GENERATED}, completed {BY_HAND}"


def merged(files: Sequence[LibraryFile]) -> Iterator[LibraryComponent]:
    """Each component of `files`, by package and name, once for each version of ROS that has its own; earlier files come first."""
    found: dict[tuple[str, str], list[Source]] = {}
    for file in files:
        for component in file.components:
            found.setdefault((file.package, component["component"]), []).append((file, component))
    for key in sorted(found):
        versions = sorted({version for file, _ in found[key] for version in file.ros}) or [0]
        layers = [[source for source in found[key] if not source[0].ros or version in source[0].ros] for version in versions]
        yield from map(_component, [layer for number, layer in enumerate(layers) if layer not in layers[:number]])


def _component(sources: Sequence[Source]) -> LibraryComponent:
    bases = [source for source in sources if source[0].made == GENERATED]
    overlays = [source for source in reversed(sources) if source[0].made == BY_HAND]
    file, document = bases[0] if bases else overlays.pop(0)
    made = file.made
    for upper, overlay in overlays:
        document = _laid_over(document, overlay)
        if overlay.get("replace") or made == BY_HAND:
            file, made = upper, upper.made
        else:
            made = COMPLETED
    return _build(file, document, made)


def _laid_over(base: Document, overlay: Document) -> Document:
    """Fields of the overlay count; its ports and parameters replace those of the same name and are otherwise added."""
    if overlay.get("replace"):
        return overlay
    return {
        **base,
        **overlay,
        "elements": {**base.get("elements", {}), **overlay.get("elements", {})},
        "ports": _joined(base.get("ports", ()), overlay.get("ports", ())),
        "params": _joined(base.get("params", ()), overlay.get("params", ())),
    }


def _joined(base: Iterable[Document], overlay: Iterable[Document]) -> list[Document]:
    new = {_identity(item) for item in overlay}
    return [*(item for item in base if _identity(item) not in new), *overlay]


def _identity(item: Document) -> tuple[Any, ...]:
    """What distinguishes a port or parameter from the others: its name, or else what gives the name."""
    if "name" in item:
        return item.get("kind"), item["name"]
    return item.get("kind"), *(item.get(source) for source in ("from_param", "from_arg", "param_pattern", "pattern"))


def _build(file: LibraryFile, document: Document, made: str) -> LibraryComponent:
    fields: dict[str, Any] = {
        key: document[key] for key in ("node_name", "base", "elements", "namespace_element", "makes") if key in document
    }
    is_open = document.get("open", False)
    return LibraryComponent(
        package=file.package,
        component=document["component"],
        kind=document["kind"],
        ports=tuple(_port(port) for port in document.get("ports", ())),
        params=tuple(LibraryParameter(**parameter) for parameter in document.get("params", ())),
        open_ports=is_open in (True, "ports"),
        open_params=is_open in (True, "params"),
        loads=tuple(document.get("loads", ())),
        options=tuple(document["options"]) if "options" in document else None,
        origin=file.origin,
        revision=file.revision,
        made=made,
        ros=file.ros,
        distributions=file.distributions,
        path=Path(file.path),
        **fields,
    )


def _port(port: Document) -> LibraryPort:
    arguments = {int(number): pattern for number, pattern in port.get("if_arg", {}).items()}
    return LibraryPort(**{**port, "if_arg": arguments})
