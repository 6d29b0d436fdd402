"""Launch XML as elements with positions.

A document may come from anyone: entity declarations are refused, nothing outside the text is read, and depth is bounded.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from .unknowns import cleaned

MAX_DEPTH = 150  # elements within elements; far above any launch file, far below what the interpreter's stack holds
_SEPARATOR = " "  # between namespace, name and prefix; expat refuses a namespace that contains it


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


class XmlError(Exception):
    """A document that cannot be read, and where."""

    def __init__(self, message: str, line: int, column: int) -> None:
        super().__init__(message)
        self.message, self.line, self.column = message, line, column


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


class Reader:
    """Reads a document with expat. Names keep their prefixes, as in the text; subclasses make of it what they need."""

    def __init__(self) -> None:
        self.parser = expat.ParserCreate(namespace_separator=_SEPARATOR)
        self.parser.namespace_prefixes = True
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self.characters
        self.parser.EntityDeclHandler = self._entity
        self.depth = 0

    def read(self, data: bytes) -> None:
        """Parse a whole document.

        Raises:
            XmlError: it is malformed, declares entities, or is too deep.
        """
        try:
            self.parser.Parse(data, True)
        except expat.ExpatError as error:
            reason = expat.ErrorString(error.code)
            raise XmlError(f"broken XML: {reason}", error.lineno, error.offset + 1) from None
        except (ValueError, LookupError) as error:  # an encoding that Python does not know
            raise XmlError(f"broken XML: {error}", 1, 1) from None

    def start(self, tag: str, attributes: dict[str, str], line: int, column: int) -> None:
        """An element begins."""
        raise NotImplementedError

    def end(self) -> None:
        """The element that began last ends."""
        raise NotImplementedError

    def characters(self, data: str) -> None:
        """Character data of the element that is open."""
        raise NotImplementedError

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        line, column = self._position()
        if self.depth >= MAX_DEPTH:
            raise XmlError(f"elements nested more than {MAX_DEPTH} deep", line, column)
        self.depth += 1
        self.start(_qualified(name), {_qualified(key): cleaned(value) for key, value in attributes.items()}, line, column)

    def _end(self, _name: str) -> None:
        self.depth -= 1
        self.end()

    def _entity(self, name: str, *_rest: object) -> None:
        raise XmlError(f"entity `{name}` is declared here; entities are not expanded", *self._position())

    def _position(self) -> tuple[int, int]:
        return self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1


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
        element = Element(tag, attributes, line, column)
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


def _qualified(name: str) -> str:
    """`prefix:name` of expat's `namespace name prefix`."""
    parts = name.split(_SEPARATOR)
    return f"{parts[2]}:{parts[1]}" if len(parts) == 3 else parts[-1]
