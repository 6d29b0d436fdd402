"""Launch XML as elements with positions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from rosarch.base.xml_reader import Reader, XmlError
from rosarch.extractor.launch.unknowns import cleaned


@dataclass(eq=False)
class Element:
    """One element. `text` is its own character data, without that of its children; `line` and `column` count from 1."""

    tag: str
    attributes: dict[str, str]
    line: int
    column: int
    children: list[Element] = field(default_factory=list)
    text: str = ""

    def walk(self) -> Iterator[Element]:
        """This element and all below it, in document order."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack.extend(reversed(element.children))


def read_launch(data: bytes, _path: str) -> Element:
    """The one `<launch>` element of a document; roslaunch looks for it at any depth.

    Raises:
        XmlError: the document is malformed, declares entities, is too deep, or has no or several `<launch>`.
    """
    root = _LaunchReader().element(data)
    found = [element for element in root.walk() if element.tag == "launch"]
    if not found:
        raise XmlError(f"root element is <{root.tag}>, not <launch>", root.line, root.column)
    if len(found) > 1:
        raise XmlError("a second <launch> in this file", found[1].line, found[1].column)
    return found[0]


class _LaunchReader(Reader):
    """Makes the elements of a launch file."""

    def __init__(self) -> None:
        super().__init__()
        self.root: Element | None = None
        self.open: list[Element] = []
        self.texts: list[list[str]] = []

    def element(self, data: bytes) -> Element:
        """The root of a document."""
        self.read(data)
        if self.root is None:
            raise XmlError("broken XML: no element found", 1, 1)
        return self.root

    def start(self, tag: str, attributes: dict[str, str], line: int, column: int) -> None:
        element = Element(tag, {name: cleaned(value) for name, value in attributes.items()}, line, column)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)
        self.texts.append([])

    def end(self) -> None:
        self.open.pop().text = cleaned("".join(self.texts.pop()))

    def characters(self, data: str) -> None:
        if self.texts:
            self.texts[-1].append(data)
