"""The evaluation of a document: every element of xacro is replaced by what it stands for.

The source is never changed; what is evaluated is built from scratch, of elements that keep the places of those they come from. The steps
and their order are those of xacro.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.urdf.comments import Comments
from rosarch.extractor.urdf.context import Context
from rosarch.extractor.urdf.definitions import Macro, Parameter, define_macro, define_property, find, required
from rosarch.extractor.urdf.document import Comment, Document, DocumentError, Element, Text, parse
from rosarch.extractor.urdf.expressions import Texts
from rosarch.extractor.urdf.model import PREFIX, Dialect, XacroError
from rosarch.extractor.urdf.symbols import Symbols, Table, truth

BARE_TAGS = frozenset({"property", "macro", "insert_block", "include", "if", "unless", "arg"})  # once xacro's without its prefix
ELEMENT_COST = 256  # work of one element, in characters


@dataclass(frozen=True)
class Frame:
    """The definitions that an element sees."""

    macros: Table
    symbols: Symbols


Handler = Callable[[Element, Element, Frame, bool], None]


class Expander:
    """Evaluates the documents of one expansion.

    A handler gets an element, the evaluated one around it, the definitions, and whether another node follows.
    """

    def __init__(self, context: Context, dialect: Dialect) -> None:
        self.context, self.dialect = context, dialect
        self.texts = Texts(context, dialect)
        self.bare_tags = False
        self.comments = Comments()
        self.undecided = 0  # how many conditions that are not known are around what is evaluated
        self.expanding: dict[str, int] = {}  # the macros that are being called, and how many were around their first calls
        self.handlers: dict[str, Handler] = {
            "include": self.include,
            "property": self.property,
            "macro": self.macro,
            "arg": self.arg,
            "insert_block": self.insert_block,
            "element": self.element,
            "attribute": self.attribute,
            "if": self.condition,
            "unless": self.condition,
        }

    def root(self, document: Document, frame: Frame) -> Document:
        """The evaluated document."""
        source = document.root
        if self.dialect.prefixed and (namespace := source.attributes.get("xacro:targetNamespace")):
            source = Element(source.tag, {**source.attributes, "xmlns": namespace}, source.place, source.children)
        root = self.plain(source, frame)
        return Document(root, [root if node is document.root else node for node in document.children])

    def plain(self, source: Element, frame: Frame) -> Element:
        """An element that is not xacro's, evaluated."""
        self.context.here = source.place
        target = Element(source.tag, self.attributes(source, frame), source.place)
        self.content(source, target, frame)
        return target

    def attributes(self, source: Element, frame: Frame) -> dict[str, str]:
        """The attributes of an element, evaluated, without those for xacro."""
        evaluated = {name: self.texts.text(value, frame.symbols) for name, value in source.attributes.items() if not self.is_own(name)}
        evaluated.pop("xmlns:xacro" if self.dialect.prefixed else "", None)
        return evaluated

    def is_own(self, attribute: str) -> bool:
        """Whether an attribute is for xacro alone."""
        return self.dialect.prefixed and attribute.startswith(PREFIX)

    def content(self, source: Element, target: Element, frame: Frame) -> None:
        """Evaluate what is in `source`, and add it to `target`."""
        with self.context.deeper():
            evaluates_comments = False
            for index, node in enumerate(source.children):
                if isinstance(node, Element):
                    evaluates_comments = False
                    self.context.spend(ELEMENT_COST)
                    self.context.here = node.place
                    self.child(node, target, frame, index + 1 < len(source.children))
                elif isinstance(node, Text):
                    text = Text(self.texts.text(node.data, frame.symbols))
                    evaluates_comments = evaluates_comments and not text.data.strip()
                    target.children.append(text)
                elif isinstance(node, Comment) and self.dialect.prefixed and "xacro:eval-comments" in node.data:
                    evaluates_comments = "xacro:eval-comments:off" not in node.data
                elif isinstance(node, Comment) and evaluates_comments:
                    target.children.append(Comment(self.texts.text(node.data, frame.symbols)))
                else:
                    target.children.append(node)

    def child(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """Evaluate an element."""
        name = self.own_name(node)
        if name in self.handlers:
            self.handlers[name](node, target, frame, followed)
        elif not self.call(node, name, target, frame, followed):
            if name is not None:
                self.unknown_macro(name)
            else:
                target.children.append(self.plain(node, frame))

    def own_name(self, node: Element) -> str | None:
        """The name of an element of xacro, without the prefix."""
        if node.tag.startswith(PREFIX):
            return node.tag[len(PREFIX) :]
        is_bare = node.tag in BARE_TAGS and not (node.tag == "include" and _has_content(node))
        if is_bare and self.dialect.prefixed:
            self.bare_tags = True
        return node.tag if is_bare and not self.dialect.prefixed else None

    def unknown_macro(self, name: str) -> None:
        """Reject a call, unless a file that may define the macro is missing."""
        if not self.context.incomplete:
            raise XacroError(f"macro `{name}` is not defined", name)

    # the elements of xacro

    def include(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:include>`: the content of other files."""
        pattern = self.texts.text(required(node, "filename"), frame.symbols)
        is_optional = self.dialect.prefixed and truth(node.attributes.get("optional", "false"), "optional", self.dialect)
        namespace = node.attributes.get("ns")
        if namespace:
            name = self.texts.text(namespace, frame.symbols)
            is_nested = self.dialect.prefixed
            symbols = frame.symbols.scope(is_namespace=True) if is_nested else Symbols(self.dialect, is_namespace=True)
            inner = Frame(Table(), symbols)
            frame.macros.values[name] = inner.macros
            frame.symbols.set(name, inner.symbols, lazy=False)
        else:
            inner = frame
        contents = [self.included(document, path, target, inner) for path, document in self.files(pattern, is_optional)]
        self.comments.replace(contents, target, followed)

    def included(self, document: Document, path: str, target: Element, frame: Frame) -> Element:
        """The evaluated root of an included file, whose namespaces are declared in `target`."""
        here = self.context.here
        with self.context.file(path):
            root = self.plain(document.root, frame)
        self.context.here = here
        lift_namespaces(root, target)
        return root

    def files(self, pattern: str, is_optional: bool) -> list[tuple[str, Document]]:
        """The files that an include names. One that cannot be known, or that must not be read, is left out."""
        if not is_known(pattern):
            self.context.incomplete = True
            return []
        path = self.context.beside(pattern)
        is_one = not re.search(r"[*\[?]", path)
        if is_one and not is_optional and self.context.installed and os.path.isabs(pattern):
            self.context.meant[(os.path.normpath(pattern), self.context.here)] = None
        found = []
        try:
            for name in [path] if is_one else self.context.files.matching(path):
                found.append((name, self.context.files.parsed(name, parse)))
        except LaunchError as error:
            if error.is_limit or error.kind == "made":
                self.context.incomplete = True
                self.context.report(error, fatal=False)
            elif not is_optional:
                raise XacroError(error.message, error.subject) from None
        except DocumentError as error:
            self.context.here = error.place
            raise XacroError(error.message) from None
        return found

    def property(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:property>`: define a property, or a block when it has no value."""
        self.comments.replace([], target, followed)
        define_property(node, frame.symbols, self.texts)

    def macro(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:macro>`: define a macro."""
        self.comments.replace([], target, followed)
        define_macro(node, frame.macros, self.dialect)

    def arg(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:arg>`: a default of an argument."""
        name, default = required(node, "name"), required(node, "default")
        arguments = self.context.scope.args
        if name not in arguments:
            arguments[name] = self.texts.text(default, frame.symbols)
        self.comments.replace([], target, followed)

    def insert_block(self, node: Element, target: Element, frame: Frame, _followed: bool) -> None:
        """`<xacro:insert_block>`: an element, or what is in it, that was passed to a macro or defined as a property."""
        name = required(node, "name")
        blocks, block = frame.symbols.get(f"**{name}"), frame.symbols.get(f"*{name}")
        if isinstance(blocks, Element):
            content = Element(node.tag, {}, node.place)
            self.content(blocks, content, frame)
            self.comments.splice(content, target)
        elif isinstance(block, Element):
            target.children.append(self.plain(block, frame))
        elif not self.context.incomplete:
            raise XacroError(f"block `{name}` is not defined", name)

    def element(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:element>`: an element whose name is evaluated."""
        name = self.texts.text(required(node, "xacro:name"), frame.symbols)
        if not name:
            raise XacroError("<xacro:element> has an empty name")
        attributes = {key: value for key, value in node.attributes.items() if key != "xacro:name"}
        self.child(Element(name, attributes, node.place, node.children), target, frame, followed)

    def attribute(self, node: Element, target: Element, frame: Frame, _followed: bool) -> None:
        """`<xacro:attribute>`: an attribute of the element around it."""
        name, value = (self.texts.text(required(node, key), frame.symbols) for key in ("name", "value"))
        if not name:
            raise XacroError("<xacro:attribute> has an empty name")
        target.attributes[name] = value

    def condition(self, node: Element, target: Element, frame: Frame, followed: bool) -> None:
        """`<xacro:if>` and `<xacro:unless>`: what is in it, or nothing. What depends on something unknown is kept."""
        precedes = self.comments.drop(target.children)
        text = required(node, "value")
        value = self.texts.value(text, frame.symbols)
        undecided = isinstance(value, str) and not is_known(value)
        keep = undecided or truth(value, text, self.dialect) is not node.tag.endswith("unless")
        moves, content = self.comments.moves, Element(node.tag, {}, node.place)
        if keep:
            self.undecided += undecided
            self.content(node, content, frame)
            self.undecided -= undecided
            self.comments.splice(content, target)
        if precedes and followed and self.comments.moves == moves:
            self.comments.protect(target.children)

    # calls of macros

    def call(self, node: Element, name: str | None, target: Element, frame: Frame, followed: bool) -> bool:
        """Evaluate the call of a macro; False when `node` is none."""
        found = find(node.tag if name is None else name, frame.macros, frame.symbols, self.dialect)
        if name is None and self.dialect.prefixed:
            self.bare_tags = self.bare_tags or found is not None
            return False
        if found is not None:
            macro, macros, symbols = found
            self.expand(node, macro, target, Frame(macros, symbols), followed)
        elif name == "call":
            called = self.texts.text(required(node, "macro"), frame.symbols).removeprefix("" if self.dialect.prefixed else PREFIX)
            attributes = {key: value for key, value in node.attributes.items() if key != "macro"}
            renamed = Element(PREFIX + called, attributes, node.place, node.children)
            if not self.call(renamed, called, target, frame, followed):
                self.unknown_macro(called)
        else:
            return False
        return True

    def expand(self, node: Element, macro: Macro, target: Element, frame: Frame, followed: bool) -> None:
        """Replace the call of `macro` by its body. Under a condition that is not known it calls itself no more."""
        before = self.expanding.get(macro.name)
        if before is not None and self.undecided > before:
            self.context.incomplete = True
            return
        self.expanding[macro.name] = self.undecided if before is None else before
        try:
            self.expand_once(node, macro, target, frame, followed)
        finally:
            if before is None:
                del self.expanding[macro.name]

    def expand_once(self, node: Element, macro: Macro, target: Element, frame: Frame, followed: bool) -> None:
        """Replace the call of `macro` by its body."""
        symbols = frame.symbols.scope()
        self.bind(node, macro, frame, symbols)
        macros = Table(frame.macros) if self.dialect.prefixed else frame.macros
        here = self.context.here
        inner = Frame(macros, symbols)
        body = Element(macro.body.tag, self.attributes(macro.body, inner), macro.body.place)
        self.content(macro.body, body, inner)
        self.context.here = here
        if self.dialect.prefixed:
            lift_namespaces(body, target)
        self.comments.replace([body], target, followed)

    def bind(self, node: Element, macro: Macro, frame: Frame, symbols: Symbols) -> None:
        """Set the parameters of `macro` in its scope, `symbols`."""
        missing = {parameter.name: parameter for parameter in macro.parameters}
        for name, text in node.attributes.items():
            if name not in missing:
                raise XacroError(f"macro `{macro.name}` has no parameter `{name}`", name)
            del missing[name]
            symbols.set(name, self.texts.value(text, frame.symbols), lazy=False)
        here, evaluated = self.context.here, Element(node.tag, {}, node.place)
        self.content(node, evaluated, frame)
        self.context.here = here
        blocks = evaluated.elements()
        for parameter in [parameter for parameter in missing.values() if parameter.is_block]:
            block = next(blocks, None)
            if block is None:
                raise XacroError(f"macro `{macro.name}` needs a block for `{parameter.name}`", macro.name)
            symbols.set(parameter.name, block, lazy=False)
            del missing[parameter.name]
        unused = next(blocks, None)
        if unused is not None:
            raise XacroError(f"macro `{macro.name}` takes no block <{unused.tag}>", macro.name)
        for parameter in missing.values():
            symbols.set(parameter.name, self.default(parameter, macro, frame.symbols), lazy=False)

    def default(self, parameter: Parameter, macro: Macro, symbols: Symbols) -> Any:
        """The value of a parameter that the call does not set."""
        if parameter.forwards:
            try:
                return symbols.value(parameter.name, self.texts.value)
            except KeyError:
                pass
        if parameter.default is not None:
            return self.texts.value(parameter.default, symbols)
        if parameter.forwards and self.context.incomplete:
            return self.context.unknowns.mark(f"${{{parameter.name}}}")
        raise XacroError(f"macro `{macro.name}` needs parameter `{parameter.name}`", parameter.name)


def lift_namespaces(source: Element, target: Element) -> None:
    """Declare the XML namespaces of `source` in `target`, too."""
    for name, value in source.attributes.items():
        if name.startswith("xmlns:"):
            target.attributes.setdefault(name, value)


def _has_content(node: Element) -> bool:
    """Whether an <include> has more in it than a text: then it is not xacro's but, say, Gazebo's."""
    return bool(node.children) and not (len(node.children) == 1 and isinstance(node.children[0], Text))
