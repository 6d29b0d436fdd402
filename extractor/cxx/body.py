"""A function body in work."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.extractor.cxx import kinds, libclang
from rosarch.extractor.cxx.libclang import Tree
from rosarch.extractor.cxx.unit import Span, UnitFacts
from rosarch.extractor.flow import Flow


@dataclass
class Body:
    """The function whose body is read; `function` is empty for initialisers of globals and of fields."""

    unit: UnitFacts
    flow: Flow
    function: str = ""
    owner: str = ""

    def node(self, tree: Tree, form: str) -> tuple[str, Span]:
        """Give out the identifier of the expression at `tree`."""
        span: Span = tree.span or self.unit.span_of(tree)
        return self.at(span, form), span

    def at(self, span: Span, form: str) -> str:
        """Give out the identifier of an expression at `span`."""
        identifier = self.unit.node(span, form)
        if self.function:
            self.unit.rows["expr_function"].add((identifier, self.function))
        return identifier

    def this(self) -> str:
        """The implicit `this` of the function."""
        identifier = f"{self.function or self.owner} this"
        self.unit.add("this_use", identifier, self.owner)
        if self.function:
            self.unit.add("expr_function", identifier, self.function)
        return identifier


def expressions(tree: Tree) -> list[Tree]:
    """The children of `tree` that are expressions."""
    return [child for child in tree.children if 100 <= child.kind <= 199]  # `is_expression`, but a call each is too much here


def strip(tree: Tree) -> Tree:
    """Leave out parentheses, implicit casts and temporaries."""
    while tree.kind in (kinds.UNEXPOSED_EXPR, kinds.PAREN):
        if len(tree.children) == 1 and 100 <= tree.children[0].kind <= 199:  # nearly always
            tree = tree.children[0]
            continue
        inner = expressions(tree)
        if len(inner) != 1 or len(inner) != len([c for c in tree.children if c.kind not in kinds.REFERENCES]):
            break
        tree = inner[0]
    return tree


def template_argument_texts(callee: str) -> list[str]:
    """Split the explicit template arguments at the end of a callee's text: `nh.param<std::string>` gives one."""
    if not callee.endswith(">") or callee.endswith(("->", ">>=", "operator>")):
        return []
    depth, end, parts = 0, len(callee) - 1, []
    for index in range(len(callee) - 1, -1, -1):
        char = callee[index]
        if char in ">)]" and callee[index - 1 : index + 1] != "->":
            depth += 1
        elif char in "<([":
            depth -= 1
            if depth == 0:
                parts.append(callee[index + 1 : end].strip())
                return [part for part in reversed(parts) if part]
        elif char == "," and depth == 1:
            parts.append(callee[index + 1 : end].strip())
            end = index
    return []


def operands(tree: Tree) -> list[Tree]:
    """The operands of an operator in source order."""
    return sorted(expressions(tree), key=lambda child: libclang.extent(child.cursor).begin)
