"""The shortest way to violate a property: a search of the states of a system together with the automaton of the property's opposite."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

from rosarch.base.logic import Not
from rosarch.behavior.verification.automaton import Automaton, automaton
from rosarch.behavior.verification.ltl import Formula
from rosarch.behavior.verification.transitions import Expression, TransitionSystem, atom_expression, required, written
from rosarch.datalog.language.graphs import strongly_connected

State = tuple[int, ...]
Product = tuple[State, int]
MOST_STATES = 200_000
MOST_ENTRIES = 50  # states from which a loop is looked for, to take the shortest run
_SIGNS = {
    "==": "==", "<": "<", "&": " and ", "|": " or ", "+": "+", "-": "-", "?": "({1} if {0} else {2})", "true": "True", "false": "False",
}  # fmt: skip


class TooManyStates(Exception):
    """The search would have to keep more states than it may."""


@dataclass(frozen=True)
class Lasso:
    """A run as the transitions taken: those of `stem` once, then those of `loop` forever, or anything when there are none."""

    stem: tuple[int, ...]
    loop: tuple[int, ...]


def _compiled(text: str) -> Any:
    """A function of the state; the text has nothing in it but numbers, signs and places in the state."""
    return eval(f"lambda s: {text}", {"__builtins__": {}})


class Explorer:
    """Runs a transition system."""

    def __init__(self, system: TransitionSystem) -> None:
        self.system = system
        self._places = {number.name: place for place, number in enumerate(system.numbers)}
        self.initial: State = tuple(number.initial for number in system.numbers)
        self._steps: list[tuple[Callable[[State], bool], Callable[[State], State]]] = []
        for transition in system.transitions:
            given = {self._places[name]: self._python(value) for name, value in transition.updates}
            following = "".join(given.get(place, f"s[{place}]") + ", " for place in range(len(system.numbers)))
            self._steps.append((self.function(transition.guard), _compiled(f"({following})")))

    def _python(self, part: Expression) -> str:
        return written(part, _SIGNS, lambda name: f"s[{self._places[name]}]")

    def function(self, part: Expression) -> Callable[[State], bool]:
        """An expression as a function of the state."""
        found: Callable[[State], bool] = _compiled(self._python(part))
        return found

    def begun(self) -> dict[State, tuple[int, ...]]:
        """The states in which first values are chosen, with the transitions that choose them."""
        found: dict[State, tuple[int, ...]] = {self.initial: ()}
        for _ in range(self.system.choices):
            found = {after: (*way, index) for state, way in found.items() for index, after in self.following(state)}
        return found

    def step(self, state: State, index: int) -> State:
        """Where a transition leads."""
        return self._steps[index][1](state)

    def following(self, state: State) -> Iterator[tuple[int, State]]:
        """The transitions that a state allows, and where they lead."""
        for index, (guard, step) in enumerate(self._steps):
            if guard(state):
                yield index, step(state)


def violation(system: TransitionSystem, formula: Formula, most: int = MOST_STATES) -> Lasso | None:
    """A run that violates a property, None when there is none.

    Raises:
        TooManyStates: the search would go through more than `most` states.
    """
    whole = required(system, formula)
    search = _Search(Explorer(system), automaton(Not(whole)), most)
    return search.run()


class _Search:
    def __init__(self, explorer: Explorer, opposite: Automaton, most: int) -> None:
        self.explorer = explorer
        self.automaton = opposite
        self.most = most
        atoms = {atom for found in (*opposite.true, *opposite.false) for atom in found}
        tests = {atom: explorer.function(atom_expression(explorer.system, atom)) for atom in atoms}
        self._tests = [
            ([tests[atom] for atom in true], [tests[atom] for atom in false])
            for true, false in zip(opposite.true, opposite.false, strict=True)
        ]
        commands = explorer.system.model.commands
        own = enumerate(explorer.system.transitions)
        self._assuming = {index for index, taken in own if taken.command is not None and commands[taken.command].assumes}
        self._free = {node for node in range(len(opposite.following)) if _is_free(opposite, node)}
        self.reached: dict[Product, tuple[Product | None, int]] = {}
        self.edges: dict[Product, list[tuple[int, Product]]] = {}
        self._begun: dict[Product, tuple[int, ...]] = {}

    def _fits(self, state: State, node: int) -> bool:
        true, false = self._tests[node]
        return all(test(state) for test in true) and not any(test(state) for test in false)

    def run(self) -> Lasso | None:
        """A run through an accepting component, by a breadth-first search that takes as few steps that rest on assumptions as it can."""
        begun = self.explorer.begun()
        start = {(state, node): way for state, way in begun.items() for node in self.automaton.initial if self._fits(state, node)}
        self._begun = start
        self.reached = {product: (None, -1) for product in start}
        waiting, assumed = deque(start), deque[tuple[Product, int, Product]]()
        while waiting or assumed:
            if not waiting:
                product, index, other = assumed.popleft()
                if other not in self.reached:
                    self.reached[other] = (product, index)
                    waiting.append(other)
                continue
            product = waiting.popleft()
            self.edges[product] = list(self._following(product))
            for index, other in self.edges[product]:
                if other[1] in self._free:
                    return Lasso(self._way_to(product), ())
                if other in self.reached:
                    continue
                if index in self._assuming:
                    assumed.append((product, index, other))
                else:
                    self.reached[other] = (product, index)
                    waiting.append(other)
            if len(self.reached) > self.most:
                raise TooManyStates
        components = map(set, strongly_connected(self.reached, lambda product: [other for _, other in self.edges[product]]))
        accepting = [component for component in components if self._accepts(component)]
        if not accepting:
            return None
        home = {product: component for component in accepting for product in component}
        early = islice((product for product in self.reached if product in home), MOST_ENTRIES)
        runs = (Lasso(self._way_to(entry), self._around(entry, home[entry])) for entry in early)
        transitions = self.explorer.system.transitions
        return min(runs, key=lambda run: sum(transitions[index].command is not None for index in (*run.stem, *run.loop)))

    def _following(self, product: Product) -> Iterator[tuple[int, Product]]:
        state, node = product
        for index, other in self.explorer.following(state):
            for after in self.automaton.following[node]:
                if self._fits(other, after):
                    yield index, (other, after)

    def _accepts(self, component: set[Product]) -> bool:
        nodes = {node for _, node in component}
        if not all(nodes & accepting for accepting in self.automaton.accepting):
            return False
        return any(other in component for product in component for _, other in self.edges[product])

    def _way_to(self, product: Product) -> tuple[int, ...]:
        found: list[int] = []
        before, index = self.reached[product]
        while before is not None:
            found.append(index)
            product = before
            before, index = self.reached[before]
        return (*self._begun[product], *reversed(found))

    def _around(self, entry: Product, component: set[Product]) -> tuple[int, ...]:
        """A way from `entry` back to it within the component, through each of the accepting sets."""
        here, way = entry, []
        for accepting in self.automaton.accepting:
            if here[1] not in accepting:
                wanted = {product for product in component if product[1] in accepting}
                steps, here = self._walk(here, component, wanted)
                way += steps
        steps, _ = self._walk(here, component, {entry})
        return (*way, *steps)

    def _walk(self, start: Product, component: set[Product], wanted: set[Product]) -> tuple[list[int], Product]:
        """The shortest way of at least one step to a product state that is wanted."""
        before: dict[Product, tuple[Product, int]] = {}
        waiting = deque([start])
        while waiting:
            product = waiting.popleft()
            for index, other in self.edges[product]:
                if other in component and other not in before:
                    before[other] = (product, index)
                    if other in wanted:
                        return _backwards(before, start, other), other
                    waiting.append(other)
        raise ValueError("not strongly connected")


def _is_free(automaton: Automaton, node: int) -> bool:
    """Whether anything that follows is accepted."""
    literals = automaton.true[node] | automaton.false[node]
    return not literals and node in automaton.following[node] and all(node in accepting for accepting in automaton.accepting)


def _backwards(before: Mapping[Product, tuple[Product, int]], start: Product, end: Product) -> list[int]:
    found = []
    while True:
        end, index = before[end]
        found.append(index)
        if end == start:
            return found[::-1]
