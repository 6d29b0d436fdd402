"""The old order: includes, then all macros, then all properties of a document are collected before anything is evaluated."""

from __future__ import annotations

from collections.abc import Callable

from rosarch.extractor.urdf.definitions import define_macro, define_property, required
from rosarch.extractor.urdf.document import Document, Element
from rosarch.extractor.urdf.expander import Expander, Frame, lift_namespaces
from rosarch.extractor.urdf.model import XacroError
from rosarch.extractor.urdf.symbols import Symbols


def collect(document: Document, expander: Expander, frame: Frame) -> Document:
    """`document` with its includes replaced and without the macros and properties that it defines, which `frame` then has."""
    root = _included(document.root, expander)
    root = _without(root, "macro", expander, lambda node: define_macro(node, frame.macros, expander.dialect))
    root = _without(root, "property", expander, lambda node: define_property(node, frame.symbols, expander.texts))
    return Document(root, [root if node is document.root else node for node in document.children])


def _included(source: Element, expander: Expander) -> Element:
    """`source` with the content of the files that it includes."""
    target = Element(source.tag, dict(source.attributes), source.place)
    with expander.context.deeper():
        for index, node in enumerate(source.children):
            if not isinstance(node, Element):
                target.children.append(node)
            elif expander.own_name(node) == "include":
                expander.context.here = node.place
                expander.comments.replace(_files(node, target, expander), target, index + 1 < len(source.children))
            else:
                target.children.append(_included(node, expander))
    return target


def _files(node: Element, target: Element, expander: Expander) -> list[Element]:
    """The roots of the files that `node` includes, whose namespaces are declared in `target`."""
    if node.attributes.get("ns"):
        raise XacroError("an include with a namespace needs --inorder")
    pattern = expander.texts.text(required(node, "filename"), Symbols(expander.dialect))
    contents = []
    for path, document in expander.files(pattern, is_optional=False):
        with expander.context.file(path):
            contents.append(_included(document.root, expander))
        lift_namespaces(contents[-1], target)
    return contents


def _without(source: Element, name: str, expander: Expander, define: Callable[[Element], None]) -> Element:
    """`source` without the definitions of one kind, each of which is given to `define`."""
    target = Element(source.tag, source.attributes, source.place)
    for index, node in enumerate(source.children):
        if not isinstance(node, Element):
            target.children.append(node)
        elif expander.own_name(node) == name:
            expander.context.here = node.place
            expander.context.spend(1)
            expander.comments.replace([], target, index + 1 < len(source.children))
            define(node)
        else:
            target.children.append(_without(node, name, expander, define))
    return target
