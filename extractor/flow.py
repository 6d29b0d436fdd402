"""The control-flow graph of one function, grown while its body is read."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Protocol

Mark = tuple[int, str, int]


class Rows(Protocol):
    """Takes rows."""

    def add(self, relation: str, *row: str | int) -> None:
        """Add one row to `relation`."""


@dataclass(eq=False)
class Block:
    """A basic block: what it evaluates, and where control goes next."""

    exprs: list[str] = field(default_factory=list)
    acts: bool = False
    edges: list[tuple[Block, str]] = field(default_factory=list)
    cases: list[tuple[Block, str]] = field(default_factory=list)
    condition: str | None = None
    loop: str | None = None


@dataclass(eq=False)
class Loop:
    """A loop: the block that chooses between a further round and the end, and the blocks of its test and of its body."""

    head: Block | None = None
    test: list[Block] = field(default_factory=list)
    body: list[Block] = field(default_factory=list)


@dataclass
class Switch:
    """A switch in work: the block that chooses, and whether it has a default."""

    chooser: Block
    default: bool = False


class Flow:
    """Builds the graph; `current` is the block that the next expression goes into."""

    def __init__(self) -> None:
        self.entry = self.current = Block()
        self.exit = Block()
        self._blocks = [self.entry]
        self._breaks: list[Block] = []
        self._continues: list[Block] = []
        self._handlers: list[tuple[list[Block], bool]] = []
        self._switches: list[Switch] = []
        self._labels: dict[str, Block] = {}
        self._loops: list[Loop] = []
        self._open: list[list[Block]] = []
        self._marks: list[tuple[int, Block, int]] = []

    def evaluate(self, expr: str) -> None:
        """Record that `expr`, which may have an effect, is evaluated now."""
        self.current.acts = True
        if expr not in self.current.exprs[-1:]:
            self.current.exprs.append(expr)

    @property
    def guarded(self) -> bool:
        """Whether what is evaluated now is in a try block with handlers."""
        return any(handlers for handlers, _ in self._handlers)

    def read(self, expr: str) -> None:
        """Record that the variable named by `expr` is read (or named as a target) now."""
        self.current.exprs.append(expr)

    def mark(self, offset: int) -> None:
        """What stands after `offset`, and clang drops, would be evaluated now."""
        self._marks.append((offset, self.current, len(self.current.exprs)))

    def block(self) -> Block:
        """Make a block; inside a try block it may pass to each handler, out to the first that catches everything."""
        block = Block()
        self._blocks.append(block)
        for part in self._open:
            part.append(block)
        for handlers, everything in reversed(self._handlers):
            block.edges += [(handler, "exception") for handler in handlers]
            if everything:
                break
        return block

    def to(self, block: Block, label: str = "next") -> None:
        """Control may pass from the current block to `block`."""
        self.current.edges.append((block, label))

    def start(self, block: Block) -> None:
        """Go on in `block`."""
        self.current = block

    def branch(self, condition: str) -> tuple[Block, Block]:
        """End the current block by `condition`; return the blocks for true and for false."""
        self.current.condition = condition
        yes, no = self.block(), self.block()
        self.to(yes, "true")
        self.to(no, "false")
        return yes, no

    def maybe(self, condition: str, lower: Callable[[], str], *, taken: bool) -> str:
        """Read, by `lower`, an expression that is evaluated only when `condition` is `taken`: a branch of its own when it does anything."""
        before, inner = self.current, self.block()
        self.start(inner)
        expr = lower()
        if self.current is inner and not inner.acts:
            before.exprs += inner.exprs
            inner.exprs.clear()
            self.start(before)
            return expr
        after = self.block()
        before.condition = condition
        before.edges.append((inner, "true" if taken else "false"))
        before.edges.append((after, "false" if taken else "true"))
        self.to(after)
        self.start(after)
        return expr

    def either(self, condition: str, yes: Callable[[], str], no: Callable[[], str]) -> tuple[str, str]:
        """Read two expressions of which `condition` chooses one; they are branches when either does anything."""
        before, first, second = self.current, self.block(), self.block()
        self.start(first)
        left = yes()
        first_end = self.current
        self.start(second)
        right = no()
        second_end = self.current
        if first_end is first and second_end is second and not first.acts and not second.acts:
            before.exprs += first.exprs + second.exprs
            first.exprs.clear()
            second.exprs.clear()
            self.start(before)
            return left, right
        after = self.block()
        before.condition = condition
        before.edges += [(first, "true"), (second, "false")]
        first_end.edges.append((after, "next"))
        second_end.edges.append((after, "next"))
        self.start(after)
        return left, right

    @property
    def loops(self) -> int:
        """How many loops and switches are around."""
        return len(self._breaks)

    def leave(self) -> None:
        """Return from the function; what follows is reached only by other ways."""
        self.to(self.exit)
        self.start(self.block())

    def throw(self) -> None:
        """Throw: to the handlers of the blocks around, and out of the function when none catches everything."""
        if not any(everything for _, everything in self._handlers):
            self.to(self.exit, "exception")
        self.start(self.block())

    def break_(self) -> None:
        """Leave the innermost loop or switch."""
        self.to(self._breaks[-1] if self._breaks else self.exit)
        self.start(self.block())

    def continue_(self) -> None:
        """Start the next round of the innermost loop."""
        self.to(self._continues[-1] if self._continues else self.exit)
        self.start(self.block())

    def label(self, name: str) -> Block:
        """The block that `goto name` leads to."""
        if name not in self._labels:
            self._labels[name] = self.block()
        return self._labels[name]

    @contextmanager
    def breaking(self, after: Block, again: Block | None = None) -> Iterator[None]:
        """Within, `break` leads to `after` and, in a loop, `continue` to `again`."""
        self._breaks.append(after)
        if again is not None:
            self._continues.append(again)
        yield
        self._breaks.pop()
        if again is not None:
            self._continues.pop()

    @contextmanager
    def catching(self, handlers: list[Block], everything: bool) -> Iterator[None]:
        """Within, every block may pass to `handlers`; one of them catches `everything`, or none does."""
        self._handlers.append((handlers, everything))
        yield
        self._handlers.pop()

    def loop(self) -> Loop:
        """A loop to be grown."""
        self._loops.append(Loop())
        return self._loops[-1]

    @contextmanager
    def within(self, part: list[Block]) -> Iterator[None]:
        """Within, every block that is made belongs to `part` of a loop."""
        self._open.append(part)
        yield
        self._open.pop()

    @contextmanager
    def switching(self, after: Block) -> Iterator[Switch]:
        """Within, `case` and `default` are entered from the current block, `break` leads to `after`."""
        switch = Switch(self.current)
        self._switches.append(switch)
        with self.breaking(after):
            yield switch
        self._switches.pop()

    @property
    def switch(self) -> Switch | None:
        """The innermost switch."""
        return self._switches[-1] if self._switches else None

    def write(self, unit: Rows, function: str) -> list[Mark]:
        """Add the graph's rows, without blocks that nothing enters and nothing is evaluated in. The marks, by names of blocks."""
        self.to(self.exit)
        entered = {id(target) for block in self._blocks for target, _ in block.edges + block.cases}
        kept = [b for b in self._blocks if b is self.entry or id(b) in entered or b.exprs or b.condition]
        names = {id(block): f"{function} B{number}" for number, block in enumerate([*kept, self.exit])}
        unit.add("block_entry", names[id(self.entry)], function)
        unit.add("block_exit", names[id(self.exit)], function)
        unit.add("block", names[id(self.exit)], function)
        for block in kept:
            name = names[id(block)]
            unit.add("block", name, function)
            for index, expr in enumerate(block.exprs):
                unit.add("block_expr", name, index, expr)
            for target, label in block.edges:
                unit.add("block_edge", name, names[id(target)], label)
            for target, value in block.cases:
                unit.add("block_edge", name, names[id(target)], "case")
                unit.add("block_case", name, names[id(target)], value)
            if block.condition is not None:
                unit.add("block_condition", name, block.condition)
            if block.loop is not None:
                unit.add("loop_head", name, block.loop)
        for loop in self._loops:
            for part, blocks in (("test", loop.test), ("body", loop.body)):
                for block in blocks:
                    if id(block) in names and id(loop.head) in names:
                        unit.add("loop_block", names[id(loop.head)], names[id(block)], part)
        return sorted((offset, names[id(block)], index) for offset, block, index in self._marks if id(block) in names)
