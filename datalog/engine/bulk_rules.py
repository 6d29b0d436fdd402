"""Recursive clauses over pairs as Python functions that join whole sets of values at a time.

A relation of pairs is a mapping from a code of its first column to the set of codes of its second, or the other way
round; a code is a small number that stands for a value (`bulk.py`). A head variable that occurs in one atom of the body
needs no loop of its own: the set that the atom has for the rest of the row goes into the result as it is.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from rosarch.datalog.engine.plan import Grouping
from rosarch.datalog.language.normalise import Scan, Step
from rosarch.datalog.language.syntax import Atom, Constraint, Variable

Pair = tuple[str, str]


@dataclass(slots=True)
class BulkFunction:
    """The text of a function while it is written."""

    slots: Mapping[str, int]
    lines: list[str] = field(default_factory=list)
    depth: int = 1
    groupings: list[Grouping] = field(default_factory=list)

    def line(self, text: str) -> None:
        """Write one line."""
        self.lines.append("    " * self.depth + text)

    def open(self, text: str) -> None:
        """Write a loop header."""
        self.line(text)
        self.depth += 1

    def grouped(self, relation: str, *, by_second: bool) -> str:
        """The name of the argument that holds a relation, grouped by one of its columns."""
        grouping = Grouping(self.slots[relation], by_second)
        if grouping not in self.groupings:
            self.groupings.append(grouping)
        return f"g{self.groupings.index(grouping)}"


def pair_of(atom: Atom) -> Pair | None:
    """The variables of an atom of two different ones."""
    names = [a.name for a in atom.args if isinstance(a, Variable)]
    return (names[0], names[1]) if len(atom.args) == len(names) == len(set(names)) == 2 else None


@dataclass(frozen=True, slots=True)
class PairClause:
    """A clause over pairs: a head, atoms, and inequalities of variables."""

    head: Pair
    atoms: tuple[tuple[str, Pair], ...]
    unequal: tuple[Pair, ...]

    def uses(self, variable: str) -> int:
        """How often the body has a variable."""
        return sum(variable in pair for _, pair in self.atoms) + sum(variable in pair for pair in self.unequal)


def pair_clause(head: Atom, steps: Sequence[Step]) -> PairClause | None:
    """The clause in this form, if it has it."""
    goal = pair_of(head)
    atoms: list[tuple[str, Pair]] = []
    unequal: list[Pair] = []
    for step in steps:
        match step:
            case Scan() if step.index >= 0 and (pair := pair_of(step.atom)) is not None:
                atoms.append((step.atom.name, pair))
            case Constraint(op="!=", left=Variable() as left, right=Variable() as right):
                unequal.append((left.name, right.name))
            case _:
                return None
    return None if goal is None else PairClause(goal, tuple(atoms), tuple(unequal))


def write_bulk(clause: PairClause, delta: int, name: str, slots: Mapping[str, int]) -> tuple[list[str], bool, tuple[Grouping, ...]]:
    """The lines of the function of a clause whose atom at `delta` is the delta, how that is grouped, and its arguments."""
    function = BulkFunction(slots)
    whole = next((v for v in reversed(clause.head) if clause.uses(v) == 1 and any(v in pair for _, pair in clause.atoms)), None)
    _, (first, second) = clause.atoms[delta]
    rest = [atom for i, atom in enumerate(clause.atoms) if i != delta]
    reversed_delta = whole == first
    key = second if reversed_delta else first
    names = {v: f"v{i}" for i, v in enumerate(dict.fromkeys(v for _, pair in clause.atoms for v in pair))}
    function.open(f"for {names[key]}, group in delta.items():")
    bound = {key}
    source = next((atom for atom in rest if whole in atom[1]), None)  # the atom with the set that is not looped over
    if source is not None:
        rest.remove(source)
        other = source[1][source[1][0] == whole]
        if other == second and clause.uses(second) == 2 and second not in clause.head:
            _leading(function, rest, bound, names)
            function.line(f"group = merged({function.grouped(source[0], by_second=source[1][1] == other)}, group)")
            function.line("if not group: continue")
            source = None
        else:
            function.open(f"for {names[second]} in group:")
            bound.add(second)
    elif whole is None:
        function.open(f"for {names[second]} in group:")
        bound.add(second)
    _joins(function, clause, rest, bound, names)
    if source is not None:
        other = source[1][source[1][0] == whole]
        function.line(f"group_ = {function.grouped(source[0], by_second=source[1][1] == other)}.get({names[other]})")
        function.line("if not group_: continue")
    group = "group_" if source is not None else "group"
    left, right = clause.head
    if whole is None:
        function.line(f"single[{names[left]}].append({names[right]})")
    elif whole == right:
        function.line(f"forward[{names[left]}].append({group})")
    else:
        function.line(f"backward[{names[right]}].append({group})")
    arguments = ", ".join(["delta", "forward", "backward", "single", *(f"g{i}" for i in range(len(function.groupings)))])
    return [f"def {name}({arguments}):", *function.lines], reversed_delta, tuple(function.groupings)


def _leading(function: BulkFunction, rest: Sequence[tuple[str, Pair]], bound: set[str], names: Mapping[str, str]) -> None:
    """Continue with the next key of the delta when an atom has nothing for it."""
    for relation, pair in rest:
        for position, variable in enumerate(pair):
            if variable in bound:
                function.line(f"if {names[variable]} not in {function.grouped(relation, by_second=position == 1)}: continue")


def _joins(
    function: BulkFunction, clause: PairClause, rest: list[tuple[str, Pair]], bound: set[str], names: Mapping[str, str]
) -> None:  # fmt: skip
    """Loops and tests for the remaining atoms."""
    unequal = list(clause.unequal)
    while True:
        for left, right in [u for u in unequal if bound.issuperset(u)]:
            unequal.remove((left, right))
            function.line(f"if {names[left]} == {names[right]}: continue")
        tests = [atom for atom in rest if bound.issuperset(atom[1])]
        for atom in tests:
            rest.remove(atom)
            groups = function.grouped(atom[0], by_second=False)
            function.line(f"if {names[atom[1][1]]} not in {groups}.get({names[atom[1][0]]}, EMPTY): continue")
        if not rest:
            return
        atom = next((a for a in rest if bound.intersection(a[1])), rest[0])
        rest.remove(atom)
        relation, (left, right) = atom
        if left in bound:
            function.open(f"for {names[right]} in {function.grouped(relation, by_second=False)}.get({names[left]}, EMPTY):")
        elif right in bound:
            function.open(f"for {names[left]} in {function.grouped(relation, by_second=True)}.get({names[right]}, EMPTY):")
        else:
            function.open(f"for {names[left]}, others in {function.grouped(relation, by_second=False)}.items():")
            function.open(f"for {names[right]} in others:")
        bound |= {left, right}
