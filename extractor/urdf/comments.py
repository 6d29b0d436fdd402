"""Which comments vanish with an element of xacro: those directly before it."""

from __future__ import annotations

from rosarch.extractor.urdf.document import Comment, Element, Node, Text


class Comments:
    """Drops comments as xacro does, which marks how far by an empty text. There is only one; it is moved from where it was before."""

    def __init__(self) -> None:
        self.mark = Text("\n\n")
        self.home: list[Node] = []
        self.moves = 0

    def drop(self, siblings: list[Node]) -> bool:
        """Drop the comments at the end of `siblings`; whether anything stands before them."""
        index = len(siblings)
        while index:
            previous = siblings[index - 1]
            if isinstance(previous, Text) and previous.data.isspace() and previous.data.count("\n") <= 1:
                index -= 1
            if index and isinstance(siblings[index - 1], Comment):
                index -= 1
                del siblings[index]
            else:
                return True
        return False

    def protect(self, siblings: list[Node]) -> None:
        """Let no later element drop comments before the end of `siblings`."""
        index = next((index for index in range(len(self.home) - 1, -1, -1) if self.home[index] is self.mark), None)
        if index is not None:
            del self.home[index]
        siblings.append(self.mark)
        self.home = siblings
        self.moves += 1

    def replace(self, content: list[Element], target: Element, followed: bool) -> None:
        """Add what is in `content` to `target`, for an element that another node follows (`followed`) or not."""
        precedes = self.drop(target.children)
        for element in content:
            self.splice(element, target)
        if precedes and followed:
            self.protect(target.children)

    def splice(self, content: Element, target: Element) -> None:
        """Add what is in `content` to `target`."""
        target.children.extend(content.children)
        if self.home is content.children:
            self.home = target.children
