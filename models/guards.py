"""Guards: the formula under which an activity reaches a point of the program, from the steps that the rules derive."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from typing import Any

from rosarch.models.formula import FALSE, TRUE, Formula, both, condition, either, loosest
from rosarch.models.normal import expanded
from rosarch.models.places import Place

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]

MOST_STEPS = 20_000
"""For one guard: among functions that call each other in circles the ways multiply. What lies beyond is taken as possible."""

CREATION = "creation "
"""Begins the root of what is made at any time, the start of the program included; a function may follow that is taken as entered."""


class Guards:
    """Reads the relations once; `guard` answers for one activity and one expression."""

    def __init__(self, relations: Relations, places: Mapping[str, Place]) -> None:
        self._places = places
        self._texts: dict[str, str] = dict(relations["node_text"])
        self._blocks: dict[str, list[str]] = defaultdict(list)
        for node, block in sorted(relations["node_block"]):
            self._blocks[node].append(block)
        self._steps: dict[str, list[Row]] = defaultdict(list)
        for row in sorted(relations["guard_step"]):
            self._steps[row[0]].append(row[1:])
        self._silent = {row[0] for row in relations["silent_condition"]}
        self._worded = {row[0] for row in relations.get("worded_condition", ())}
        self._loops = {row[0] for row in relations["loop_condition"]}
        self._stable = {row[0] for row in relations["stable_condition"]}
        self._locals: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for node, name, value in sorted(relations["settled_local"]):
            self._locals[node].append((name, value))
        self._cases: dict[str, list[str]] = defaultdict(list)
        for chooser, value in sorted(relations["switch_case"]):
            self._cases[chooser].append(value)
        self._parts: dict[str, set[str]] = defaultdict(set)
        for root, block in relations["activity_part"]:
            self._parts[root].add(block)
        self._entered: dict[str, set[str]] = defaultdict(set)
        for root, function in relations["activity_enters"]:
            self._entered[root].add(function)
        self._roots = {root for root, kind in relations["activity"] if kind not in ("loop", "main")}
        self._known: dict[tuple[str, str], Formula] = {}
        self._cuts = 0
        self._left = MOST_STEPS

    def guard(self, root: str, node: str) -> Formula:
        """When the activity of `root` evaluates `node`; true when nothing is known."""
        self._left = MOST_STEPS
        found = either(self._of(root, block, ()) for block in self._blocks.get(node, ()) if self._runs(root, block))
        return found if found.alternatives else TRUE

    def created(self, node: str, through: Iterable[str]) -> Formula:
        """When `node` is evaluated, from the start of the program, or of what runs later; `through`: the calls that enter its function."""
        blocks = self._blocks.get(node, ())
        entries = [self.created(call, ()) for call in through if call in self._blocks]
        self._left = MOST_STEPS
        found = either(self._of(CREATION + _function(block) if entries else CREATION, block, ()) for block in blocks)
        if entries:
            found = both(either(entries), found)
        return found if found.alternatives else TRUE

    def _runs(self, root: str, block: str) -> bool:
        return root.startswith(CREATION) or block in self._parts[root] or _function(block) in self._entered[root]

    def _of(self, root: str, node: str, path: tuple[str, ...]) -> Formula:
        """The guard of a block or function; a way that comes back to where it was adds nothing."""
        if node in (root, _function(root)) or (root.startswith(CREATION) and (node in self._roots or node == root[len(CREATION) :])):
            return TRUE
        if node in path:
            self._cuts += 1
            return FALSE
        known = self._known.get((root, node))
        if known is not None:
            return known
        self._left -= 1
        if self._left < 0:
            return TRUE
        cuts, steps = self._cuts, self._steps.get(node, ())
        found = either(self._step(root, row, (*path, node)) for row in steps) if steps else TRUE
        if not path or cuts == self._cuts:  # else it lacks the ways that lead back
            self._known[root, node] = found
        return found

    def _step(self, root: str, row: Row, path: tuple[str, ...]) -> Formula:
        before, chooser, sense, value = row
        if before == root:
            return TRUE
        if sense == "always" and before != _function(path[-1]) and not self._runs(root, before):
            return FALSE  # a call that this activity does not make
        beyond = self._of(root, before, path)
        if root.startswith(CREATION) and chooser in self._loops:
            return beyond  # what a loop makes is made for each element there is
        return both(beyond, self._condition(chooser, sense, value)) if beyond.alternatives else FALSE

    def _condition(self, chooser: str, sense: str, value: str) -> Formula:
        text = self._texts.get(chooser)
        if chooser in self._silent or text is None or sense not in ("true", "false", "case", "default"):
            return TRUE
        place = self._places.get(chooser)
        meaning = expanded(chooser, self._texts, self._locals)
        if sense == "case":
            return self._case(text, meaning, value, True, place)
        if sense == "default":
            formula = TRUE
            for label in self._cases[chooser]:
                formula = both(formula, self._case(text, meaning, label, False, place))
            return formula
        return condition(text, sense == "true", place, stable=chooser in self._stable, meaning=meaning, words=chooser in self._worded)

    def _case(self, text: str, meaning: str, label: str, holds: bool, place: Place | None) -> Formula:
        value = self._texts.get(label, "?")
        chosen = f"({meaning})" if loosest(meaning) else meaning
        return condition(f"{text} == {value}", holds, place, meaning=f"{chosen} == {value}")


def _function(block: str) -> str:
    """The function that a block belongs to: its identifier is the function's and a number."""
    function, separator, number = block.rpartition(" B")
    return function if separator and number.isdigit() else block
