"""`xml.etree.ElementTree`, as far as Python launch files read robot descriptions with it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.natives_files import text_at
from rosarch.extractor.launch_ros2.registry import native
from rosarch.extractor.launch_ros2.values import NOTHING, PathText, TextFile
from rosarch.extractor.urdf.document import DocumentError, Element, parse

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.calls import Calls


@native("xml.etree.ElementTree.fromstring", "xml.etree.ElementTree.XML")
def _from_text(run: Calls, text: Any, *_more: Any) -> Any:
    if not isinstance(text, str) or run.world.state.unknowns.is_open(text):
        return NOTHING
    run.world.state.spend(len(text))
    try:
        return parse(text.encode(), run.world.state.here.path).root
    except DocumentError as error:
        raise Raised("ParseError", error.message) from None


@native("xml.etree.ElementTree.parse")
def _of_file(run: Calls, source: Any, *_more: Any) -> Any:
    """A document, which its root stands for: it is asked for its elements in the same way."""
    if isinstance(source, TextFile):
        return _from_text(run, source.text)
    return _from_text(run, text_at(run, source)) if isinstance(source, (str, PathText)) else NOTHING


def _found(owner: Element, path: Any) -> Iterator[Element]:
    """The elements at a path of tags: `link/visual`, `.//joint`."""
    first, _, rest = path.removeprefix("./").partition("/")
    if not first:
        yield from _within(owner, rest)
        return
    for element in owner.elements():
        if first in ("*", element.tag):
            yield from _found(element, rest) if rest else (element,)


def _within(owner: Element, tag: Any = None) -> Iterator[Element]:
    for element in owner.elements():
        if tag in (None, "*", element.tag):
            yield element
        yield from _within(element, tag)


def _all(_run: Calls, owner: Element, path: Any) -> Any:
    simple = isinstance(path, str) and is_known(path) and "[" not in path
    return list(_found(owner, path)) if simple else NOTHING


def _first(run: Calls, owner: Element, path: Any) -> Any:
    found = _all(run, owner, path)
    return found if found is NOTHING else next(iter(found), None)


def _iterated(_run: Calls, owner: Element, tag: Any = None) -> Any:
    return [*([owner] if tag in (None, "*", owner.tag) else []), *_within(owner, tag)]


ELEMENT_METHODS: dict[str, Callable[..., Any]] = {
    "getroot": lambda _run, owner: owner,
    "get": lambda _run, owner, name, default=None: owner.attributes.get(name, default),
    "find": _first,
    "findall": _all,
    "iter": _iterated,
}


def of_element(owner: Element, name: str) -> Any:
    """`owner.tag`, `owner.attrib`, `owner.text`."""
    return {"tag": owner.tag, "attrib": dict(owner.attributes), "text": owner.text() or None}.get(name, NOTHING)
