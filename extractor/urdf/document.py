"""XML as xacro sees it: elements with places, texts, comments."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

from rosarch.base.xml_reader import Reader, XmlError
from rosarch.extractor.launch.model import Place
from rosarch.extractor.launch.unknowns import cleaned


@dataclass(eq=False)
class Text:
    """Character data."""

    data: str


@dataclass(eq=False)
class Verbatim:
    """What is passed on as it is written: a CDATA section or a processing instruction."""

    markup: str
    is_block: bool


@dataclass(eq=False)
class Comment:
    """A comment."""

    data: str


@dataclass(eq=False)
class Element:
    """An element, with what is directly in it."""

    tag: str
    attributes: dict[str, str]
    place: Place
    children: list[Node] = field(default_factory=list)

    def elements(self) -> Iterator[Element]:
        """The elements directly in this one."""
        return (child for child in self.children if isinstance(child, Element))

    def text(self) -> str:
        """The character data directly in this element."""
        return "".join(child.data for child in self.children if isinstance(child, Text))


Node: TypeAlias = Element | Text | Comment | Verbatim


@dataclass(eq=False)
class Document:
    """A document: its root, and what stands before and after it."""

    root: Element
    children: list[Node]


class DocumentError(Exception):
    """A document that is not well-formed or not accepted, and where."""

    def __init__(self, message: str, place: Place) -> None:
        super().__init__(message)
        self.message, self.place = message, place


def parse(data: bytes, path: str) -> Document:
    """The document in `data`, which `path` is shown for.

    Raises:
        DocumentError: it is malformed, declares entities, or is too deep.
    """
    try:
        return _DocumentReader(path).document(data)
    except XmlError as error:
        raise DocumentError(error.message, Place(path, error.line, error.column)) from None


class _DocumentReader(Reader):
    """Makes the nodes of a document."""

    def __init__(self, path: str) -> None:
        super().__init__()
        self.path = path
        self.top: list[Node] = []
        self.open: list[Element] = []
        self.namespaces: dict[str, str] = {}
        self.literal: list[str] | None = None
        self.parser.StartNamespaceDeclHandler = self._namespace
        self.parser.CommentHandler = lambda data: self._add(Comment(cleaned(data)))
        self.parser.ProcessingInstructionHandler = lambda target, data: self._add(Verbatim(cleaned(f"<?{target} {data}?>"), True))
        self.parser.StartCdataSectionHandler = self._start_literal
        self.parser.EndCdataSectionHandler = self._end_literal

    def document(self, data: bytes) -> Document:
        """The document in `data`."""
        self.read(data)
        return Document(next(node for node in self.top if isinstance(node, Element)), self.top)

    def start(self, tag: str, attributes: dict[str, str], line: int, column: int) -> None:
        given = {name: cleaned(value) for name, value in attributes.items()}
        element = Element(tag, {**given, **self.namespaces}, Place(self.path, line, column))
        self.namespaces = {}
        self._add(element)
        self.open.append(element)

    def end(self) -> None:
        self.open.pop()

    def characters(self, data: str) -> None:
        if self.literal is not None:
            self.literal.append(data)
        elif self.open:
            self._add(Text(cleaned(data)))

    def _add(self, node: Node) -> None:
        siblings = self.open[-1].children if self.open else self.top
        last = siblings[-1] if siblings else None
        if isinstance(node, Text) and isinstance(last, Text):
            last.data += node.data
        else:
            siblings.append(node)

    def _namespace(self, prefix: str | None, uri: str | None) -> None:
        self.namespaces[f"xmlns:{prefix}" if prefix else "xmlns"] = cleaned(uri or "")

    def _start_literal(self) -> None:
        self.literal = []

    def _end_literal(self) -> None:
        self._add(Verbatim(f"<![CDATA[{cleaned(''.join(self.literal or ()))}]]>", False))
        self.literal = None
