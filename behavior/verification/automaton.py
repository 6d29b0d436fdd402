"""Büchi automata of formulas, by the tableau of Gerth, Peled, Vardi and Wolper (1995)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from rosarch.base.logic import TRUE, All, Any, Not, opposite
from rosarch.behavior.verification import ltl
from rosarch.behavior.verification.ltl import Atom, Formula, Next, Release, Until


@dataclass(frozen=True)
class Automaton:
    """States by number; in a state, the atoms in `true` hold and those in `false` do not.

    A run is accepted when each of the sets in `accepting` is visited again and again.
    """

    initial: tuple[int, ...]
    following: tuple[tuple[int, ...], ...]
    true: tuple[frozenset[Atom], ...]
    false: tuple[frozenset[Atom], ...]
    accepting: tuple[frozenset[int], ...]


@dataclass
class _Node:
    before: set[int]
    new: list[Formula]
    old: set[Formula] = field(default_factory=set)
    next: set[Formula] = field(default_factory=set)


_INITIAL = -1


def automaton(formula: Formula) -> Automaton:
    """The automaton of the runs that satisfy a formula."""
    start = ltl.normal(formula)
    done: list[_Node] = []
    known: dict[tuple[frozenset[Formula], frozenset[Formula]], int] = {}
    waiting = [_Node({_INITIAL}, [start])]
    while waiting:
        node = waiting.pop()
        if node.new:
            waiting += _expanded(node, node.new.pop())
            continue
        key = (frozenset(node.old), frozenset(node.next))
        if key in known:
            done[known[key]].before |= node.before
        else:
            known[key] = len(done)
            done.append(node)
            waiting.append(_Node({known[key]}, list(node.next)))
    following: list[list[int]] = [[] for _ in done]
    for index, node in enumerate(done):
        for before in node.before - {_INITIAL}:
            following[before].append(index)
    return Automaton(
        tuple(index for index, node in enumerate(done) if _INITIAL in node.before),
        tuple(map(tuple, following)),
        tuple(frozenset(part for part in node.old if isinstance(part, Atom)) for node in done),
        tuple(frozenset(part.inner for part in node.old if isinstance(part, Not) and isinstance(part.inner, Atom)) for node in done),
        _acceptance(start, done),
    )


def _expanded(node: _Node, part: Formula) -> list[_Node]:
    """What becomes of a node when a part of what it has to satisfy is taken up."""
    if part in node.old:
        return [node]
    if part == TRUE:
        return [node]
    if isinstance(part, All):
        return [_with(node, part, part.parts, [])]
    if isinstance(part, Any):
        return [_with(node, part, [each], []) for each in part.parts]
    if isinstance(part, Next):
        return [_with(node, part, [], [part.inner])]
    if isinstance(part, Until):
        return [_with(node, part, [part.left], [part]), _with(node, part, [part.right], [])]
    if isinstance(part, Release):
        return [_with(node, part, [part.right], [part]), _with(node, part, [part.left, part.right], [])]
    return [] if opposite(part) in node.old else [_with(node, part, [], [])]


def _with(node: _Node, part: Formula, new: Sequence[Formula], following: Sequence[Formula]) -> _Node:
    return _Node(set(node.before), [*node.new, *new], {*node.old, part}, {*node.next, *following})


def _acceptance(formula: Formula, nodes: Sequence[_Node]) -> tuple[frozenset[int], ...]:
    """For each `until`, the nodes where it is not waited for."""
    untils = [part for part in ltl.parts(formula) if isinstance(part, Until)]
    return tuple(
        frozenset(index for index, node in enumerate(nodes) if until not in node.old or until.right in node.old or until.right == TRUE)
        for until in dict.fromkeys(untils)
    )
