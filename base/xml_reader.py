"""XML read with expat. A document may come from anyone: entities are rejected, nothing outside the text is read, depth is bounded."""

from __future__ import annotations

from typing import NoReturn
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

MAX_DEPTH = 150  # elements within elements; far above any file of ROS, far below what the interpreter's stack holds
_SEPARATOR = " "  # between namespace, name and prefix; expat rejects a namespace that contains it


class XmlError(Exception):
    """A document that cannot be read, and where."""

    def __init__(self, message: str, line: int, column: int) -> None:
        super().__init__(message)
        self.message, self.line, self.column = message, line, column


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

    def read(self, data: bytes | str) -> None:
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
        self.start(_qualified(name), {_qualified(key): value for key, value in attributes.items()}, line, column)

    def _end(self, _name: str) -> None:
        self.depth -= 1
        self.end()

    def _entity(self, name: str, *_rest: object) -> NoReturn:
        raise XmlError(f"entity `{name}` is declared here; entities are not expanded", *self._position())

    def _position(self) -> tuple[int, int]:
        return self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1


def read_tree(data: bytes | str) -> Element:
    """The root of a document as a plain tree; names keep their prefixes.

    Raises:
        XmlError: see `Reader.read`.
    """
    reader = _TreeReader()
    reader.read(data)
    return reader.builder.close()


class _TreeReader(Reader):
    """Builds a plain tree."""

    def __init__(self) -> None:
        super().__init__()
        self.builder = TreeBuilder()
        self.tags: list[str] = []

    def start(self, tag: str, attributes: dict[str, str], line: int, column: int) -> None:
        self.tags.append(tag)
        self.builder.start(tag, attributes)

    def end(self) -> None:
        self.builder.end(self.tags.pop())

    def characters(self, data: str) -> None:
        self.builder.data(data)


def _qualified(name: str) -> str:
    """`prefix:name` of expat's `namespace name prefix`."""
    parts = name.split(_SEPARATOR)
    return f"{parts[2]}:{parts[1]}" if len(parts) == 3 else parts[-1]
