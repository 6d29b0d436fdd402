"""Dependencies between relations, their strongly connected components, and stratification."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from rosarch.datalog.language.errors import Location, Report
from rosarch.datalog.language.graphs import strongly_connected
from rosarch.datalog.language.syntax import Aggregate, Argument, Atom, Clause, Literal, Negation, children


@dataclass(slots=True)
class Dependencies:
    """Edges from a relation to those its clauses read; `strict` ones must be complete before (with their place)."""

    reads: dict[str, set[str]] = field(default_factory=dict)
    strict: dict[tuple[str, str], tuple[str, Location]] = field(default_factory=dict)


def atoms_of(node: Argument | Literal, strict: str = "") -> Iterator[tuple[Atom, str]]:
    """Every atom below a node, with `negation` or `aggregate` when it is under one."""
    if isinstance(node, Atom):
        yield node, strict
    inside = "negation" if isinstance(node, Negation) else "aggregate" if isinstance(node, Aggregate) else strict
    for child in children(node):
        yield from atoms_of(child, inside or strict)


def dependencies(relations: Iterable[str], clauses: Iterable[Clause]) -> Dependencies:
    """The dependency graph of a program."""
    found = Dependencies({name: set() for name in relations})
    for clause in clauses:
        head = clause.head.name
        nodes: list[Argument | Literal] = [*clause.head.args, *clause.body]
        for node in nodes:
            for atom, strict in atoms_of(node):
                found.reads[head].add(atom.name)
                if strict:
                    found.strict.setdefault((head, atom.name), (strict, atom.location))
        if clause.dominating is not None:
            found.reads[head].add(head)
    return found


def turned_around(reads: Mapping[str, Iterable[str]]) -> dict[str, set[str]]:
    """The graph with every edge the other way: who reads each relation."""
    found: dict[str, set[str]] = {name: set() for name in reads}
    for name, others in reads.items():
        for other in others:
            found.setdefault(other, set()).add(name)
    return found


def reachable(start: Iterable[str], edges: Mapping[str, Iterable[str]]) -> set[str]:
    """Some relations and all that edges lead to from them."""
    found: set[str] = set()
    work = list(start)
    while work:
        name = work.pop()
        if name not in found:
            found.add(name)
            work.extend(edges.get(name, ()))
    return found


def components(graph: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """Strongly connected components, each after the ones it reads."""
    return list(strongly_connected(graph, lambda name: sorted(graph[name])))


def check_stratified(found: Dependencies, strata: Sequence[Sequence[str]], report: Report) -> None:
    """Report every negation or aggregate over a relation of its own stratum, with the cycle."""
    stratum_of = {name: i for i, names in enumerate(strata) for name in names}
    for (head, read), (kind, location) in found.strict.items():
        if stratum_of[head] == stratum_of[read]:
            path = _path(found.reads, read, head, set(strata[stratum_of[head]]))
            cycle = " -> ".join([head, *path])
            report.error(f"cannot stratify: {kind} of `{read}` in a cycle: {cycle}", location)


def _path(reads: Mapping[str, set[str]], start: str, goal: str, within: set[str]) -> list[str]:
    """The shortest path from `start` to `goal` inside a component."""
    came_from: dict[str, str] = {start: ""}
    queue = [start]
    for node in queue:
        if node == goal:
            break
        for successor in sorted(reads[node] & within):
            if successor not in came_from:
                came_from[successor] = node
                queue.append(successor)
    path = [goal]
    while path[-1] != start:
        path.append(came_from[path[-1]])
    return path[::-1]
