"""Guards: the formula under which an activity reaches a point of the program, from the steps that the rules derive."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from rosarch.base.limits import deep_recursion
from rosarch.base.logic import FALSE, TRUE, alternatives, atoms, conjuncts, from_alternatives
from rosarch.base.places import Place, precise
from rosarch.models.formula import Condition, Formula, both, condition, either, joined, loosest
from rosarch.models.machine.conditions import choice, constant, parse_condition
from rosarch.models.normal import WORD, expanded, folded, normal_text, replaced, truth_of, with_values

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]

LOCAL = "local_"
"""Begins what a local is called that has the name of a state variable."""

MOST_STEPS = 20_000
"""For one guard: among functions that call each other in circles the ways multiply. What lies beyond is taken as possible."""

MOST_WAYS = 128
"""To one point. Of what has more, calls do not say what is given and in which order: nobody would read so many transitions."""

_CAST = re.compile(r"\w+_cast<(?P<type>[^<>]*)>\s*\((?P<inner>.*)\)|\((?P<plain>[\w: ]+)\)\s*(?P<bare>.*)", re.DOTALL)

CANCEL = "cancel request"
"""The condition under which a server runs the function that it hands wishes to end a goal to; what it hands goals to runs else."""

CREATION = "creation "
"""Begins the root of what is made at any time, the start of the program included; a function may follow that is taken as entered."""


@dataclass(frozen=True)
class Way:
    """An activity comes to a point of the program under `guard`; there, an expression is `value`.

    `fixed` are names in it that no call gives a value, `through` the calls by which it comes there, as far as these make ways of their own.
    Where an activity does things in the order of its calls, `trail` says where it does this: those calls and the point, nothing where they
    are not known.
    """

    guard: Formula
    value: str
    fixed: frozenset[str] = frozenset()
    through: tuple[Place, ...] = ()
    trail: tuple[Place, ...] | None = None
    found: bool = False  # in a row of a table

    def names(self, known: Collection[str]) -> set[str]:
        """Those of the `known` names that occur in what is meant."""
        meant = (item.meaning or item.text for item in atoms(self.guard))
        words = {word for source in (self.value, *meant) for word in WORD.findall(source)}
        return words.intersection(known)

    def given(self, values: Mapping[str, str], fixed: Collection[str], calls: tuple[Place, ...]) -> Way:
        """Seen from the caller: the words of conditions stay, their meaning gets the values; a constant is what an expression is."""
        constants = {name: value for name, value in values.items() if _is_constant(value)}
        fill = partial(with_values, values=values)
        guard = either(_given(conjunction, fill) for conjunction in alternatives(self.guard)) if values else self.guard
        return Way(guard, with_values(self.value, constants), self.fixed.union(fixed), (*calls, *self.through), self.trail, self.found)

    def called_by(self, calls: tuple[Place, ...]) -> Way:
        """The same, where what conditions ask may differ from one call of their function to the next, and these make it so far."""
        conjunctions = ([item.called_by(calls) for item in each] for each in alternatives(self.guard))
        return replace(self, guard=from_alternatives(conjunctions))

    def in_row(self, row: Mapping[str, str]) -> Way:
        """The same, in the round of a loop that finds this row of a table."""
        fill = partial(_filled, row=row)
        guard = either(_given(conjunction, fill) for conjunction in alternatives(self.guard)) if row else self.guard
        value = fill(self.value)
        return replace(self, guard=guard, value=value, found=self.found or (guard, value) != (self.guard, self.value))


def trail_json(trail: tuple[Place, ...] | None) -> dict[str, list[str]]:
    """What a document has of the trail of a way."""
    return {} if trail is None else {"trail": list(map(precise, trail))}


def meant_json(guard: Formula) -> dict[str, list[str]]:
    """The normal forms of the conditions of a guard that all have to hold, where that of the guard does not have them one by one.

    Two may be alike, but asked at different times; one may be a conjunction itself.
    """
    items, *others = alternatives(guard)
    parts = len(conjuncts(parse_condition(normal_text(guard) or "true")))
    return {} if others or len(items) == parts or guard == TRUE else {"meant": [normal_text(item) or "true" for item in items]}


class _TooManyWays(Exception):
    """There are more than `MOST_WAYS`."""


@dataclass(frozen=True)
class _Search:
    """What makes ways of their own: calls that give nothing that matters, rows of a table."""

    calls: bool = False
    rows: bool = True


_NO_TABLE: Sequence[Mapping[str, str]] = ({},)


def _filled(source: str, row: Mapping[str, str]) -> str:
    """`source` with what a row of a table has in its places."""
    for written, value in row.items():
        source = replaced(source, written, value)
    return source


def _given(items: Iterable[Condition], fill: Callable[[str], str]) -> Formula:
    """A conjunction with values in their places; what they decide is decided."""
    found: list[Condition] = []
    for item in items:
        before = item.meaning or item.text
        meaning = fill(before)
        if meaning == before:
            found.append(item)
            continue
        truth = truth_of(meaning)
        if truth is None:
            found.append(replace(item, meaning=folded(meaning)))
        elif truth != item.holds:
            return FALSE
    kept = joined(found)
    return FALSE if kept is None else from_alternatives([kept])


def _is_constant(value: str) -> bool:
    """Whether a value is a constant, or a condition chooses between two."""
    if constant(value) is not None:
        return True
    chosen = choice(value)
    return chosen is not None and all(constant(part) is not None for part in chosen[1:])


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
        for node, name, value in sorted((*relations["settled_local"], *relations.get("named_number", ()))):
            self._locals[node].append((name, value))
        shadowing = sorted(relations.get("shadows_state", ()))
        shadows = {name for _, name in shadowing}
        self._meant = _converted(_apart_from_state(self._texts, shadowing, self._locals), relations.get("cast_written", ()))
        self._tests: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for node, written, function in sorted(relations.get("test_written", ())):
            self._tests[node].append((written, function))
        self._returned: dict[str, list[str]] = defaultdict(list)
        for function, value in sorted(relations.get("test_value", ())):
            self._returned[function].append(value)
        self._entries: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for function, call, block in sorted(relations.get("entered_by", ())):
            self._entries[function].append((call, block))
        self._given: dict[tuple[str, str], dict[str, str]] = defaultdict(dict)
        for call, function, name, argument in sorted(relations.get("argument_given", ()), reverse=True):
            if argument in self._meant:
                self._given[call, function] |= dict.fromkeys(_names(name, shadows), self._meant[argument])
        self._rows = _tables(relations.get("row_value", ()))
        self._searching = _entered_from(set(self._rows), self._entries)
        self._ordered = {root for (root,) in relations.get("ordered_by_calls", ())}
        self._own: dict[str, set[str]] = defaultdict(set)
        for function, name in relations.get("own_name", ()):
            self._own[function].update(_names(name, shadows))
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
        self._asked = {root: condition(CANCEL, ends == "true") for root, ends in relations.get("handles_goals", ())}
        self._guards: dict[tuple[str, str], Formula] = {}
        self._cuts = 0
        self._left = MOST_STEPS
        self._reached = 0

    def guard(self, root: str, node: str) -> Formula:
        """When the activity of `root` evaluates `node`: true when nothing is known, false when what calls give rules it out."""
        return either(way.guard for way in self._come_to(root, node, "", _Search(rows=False)))

    def those_that_run(self, roots: Iterable[str], node: str) -> list[str]:
        """The roots whose activities come to `node`; all of them when that is not seen of any."""
        known = list(roots)
        return [root for root in known if any(self._runs(root, block) for block in self._blocks.get(node, ()))] or known

    def ways(self, root: str, node: str, value: str) -> list[Way]:
        """How the activity of `root` comes to `node`, and what `value`, an expression of its function, is then: calls may give it.

        One way for each chain of calls that leads there where their order is that of what the activity does. Empty when what the calls
        give decides that it does not come there.
        """
        return self._come_to(root, node, value, _Search(self.is_ordered_by_calls(root)))

    def is_ordered_by_calls(self, root: str) -> bool:
        """Whether the activity of `root` does things in the order of its calls, which is not that of the lines."""
        return root in self._ordered

    def calls_apart(self, root: str, node: str) -> list[Way]:
        """How the activity of `root` comes to `node`, one way for each chain of calls that leads there."""
        return self._come_to(root, node, "", _Search(calls=True))

    def _come_to(self, root: str, node: str, value: str, search: _Search) -> list[Way]:
        self._left, self._reached = MOST_STEPS, 0
        blocks = [block for block in self._blocks.get(node, ()) if self._runs(root, block)]
        with deep_recursion():
            begun = [(block, row) for block in blocks for row in self._table(block, search)]
            try:
                found = [way for block, row in begun for way in self._ways(root, block, Way(TRUE, value), (), search, row)]
            except _TooManyWays:
                found = [Way(self._of(root, block, ()), value) for block in blocks]
        if blocks and not found:
            return []
        asked = self._asked.get(root, TRUE)
        ways = [replace(way, guard=both(asked, way.guard)) for way in found if way.guard != FALSE] or [Way(asked, value)]
        return [self._with_trail(way, node) for way in dict.fromkeys(ways)] if self.is_ordered_by_calls(root) else list(dict.fromkeys(ways))

    def _table(self, block: str, search: _Search) -> Sequence[Mapping[str, str]]:
        """The rows of the tables that the function of a block searches."""
        return self._rows.get(_function(block), _NO_TABLE) if search.rows else _NO_TABLE

    def _with_trail(self, way: Way, node: str) -> Way:
        """The way to `node` with all of its trail."""
        known = way.trail is not None and node in self._places
        return replace(way, trail=(*way.through, self._places[node]) if known else ())

    def _ways(
        self, root: str, block: str, beyond: Way, path: tuple[str, ...], search: _Search, row: Mapping[str, str]
    ) -> list[Way]:  # fmt: skip
        """Ways to `block`, and from there on as `beyond` has it; `path` are the functions that lie beyond, `row` is what a search found.

        Calls make ways of their own where what they give matters.
        """
        function = _function(block)
        self._left -= 1
        own = self._own.get(function, set())
        told = search.calls or (search.rows and function in self._searching)
        inner = replace(beyond, guard=both(self._of(function, block, ()), beyond.guard)).in_row(row) if own or told else beyond
        names = inner.names(own) - beyond.fixed
        entries = [(call, before) for call, before in self._entries.get(function, ()) if self._runs(root, before)]
        again = any(_function(before) in (function, *path) for _, before in entries)
        ordered, begins = search.calls and self.is_ordered_by_calls(root), function in (root, _function(root))
        again |= ordered and not self._are_all(root, function, entries)
        if not (names or told) or not entries or again or begins or self._left < 0:
            trail = beyond.through if ordered and begins else None
            way = replace(beyond, guard=both(self._of(root, block, ()), beyond.guard), trail=trail)
            if way.guard != FALSE and way.in_row(row).guard == FALSE:
                return []
            self._reached += 1
            if self._reached > MOST_WAYS:
                raise _TooManyWays
            return [way.in_row(row)]
        found = []
        for call, before in entries if inner.guard != FALSE or beyond.guard == FALSE else ():
            calls = (self._places[call],) if call in self._places else ()
            for found_row in self._table(before, search):
                given = {name: _filled(text, found_row) for name, text in self._given[call, function].items() if name in names}
                called = inner.given(given, names - given.keys(), calls)
                called = called.called_by(calls) if ordered else called
                if called.guard != FALSE or inner.guard == FALSE:
                    found += self._ways(root, before, called, (*path, function), search, found_row)
        return found

    def _are_all(self, root: str, function: str, entries: Iterable[tuple[str, str]]) -> bool:
        """Whether these calls, whose places are known, are all by which the activity of `root` comes to a function."""
        known = {before for call, before in entries if call in self._places}
        return all(before in known for before, *_ in self._steps.get(function, ()) if self._runs(root, before))

    def meaning(self, node: str) -> str | None:
        """What an expression that is assigned stands for, None where its text is not known."""
        return expanded(node, self._meant, self._locals) if node in self._meant else None

    def created(self, node: str, through: Iterable[str]) -> Formula:
        """When `node` is evaluated, from the start of the program, or of what runs later; `through`: the calls that enter its function."""
        blocks = self._blocks.get(node, ())
        entries = [self.created(call, ()) for call in through if call in self._blocks]
        self._left = MOST_STEPS
        with deep_recursion():
            found = either(self._of(CREATION + _function(block) if entries else CREATION, block, ()) for block in blocks)
        if entries:
            found = both(either(entries), found)
        return TRUE if found == FALSE else found

    def _runs(self, root: str, block: str) -> bool:
        return root.startswith(CREATION) or block in self._parts[root] or _function(block) in self._entered[root]

    def _of(self, root: str, node: str, path: tuple[str, ...]) -> Formula:
        """The guard of a block or function; a way that comes back to where it was adds nothing."""
        if node in (root, _function(root)) or (root.startswith(CREATION) and (node in self._roots or node == root[len(CREATION) :])):
            return TRUE
        if node in path:
            self._cuts += 1
            return FALSE
        known = self._guards.get((root, node))
        if known is not None:
            return known
        self._left -= 1
        if self._left < 0:
            return TRUE
        cuts, steps = self._cuts, self._steps.get(node, ())
        found = either(self._step(root, row, (*path, node)) for row in steps) if steps else TRUE
        if not path or cuts == self._cuts:  # else it lacks the ways that lead back
            self._guards[root, node] = found
        return found

    def _step(self, root: str, row: Row, path: tuple[str, ...]) -> Formula:
        before, chooser, sense, value = row
        if before == root and sense != "case":  # a call there may choose what it enters
            return TRUE
        if sense == "always" and before != _function(path[-1]) and not self._runs(root, before):
            return FALSE  # a call that this activity does not make
        beyond = self._of(root, before, path)
        if root.startswith(CREATION) and chooser in self._loops:
            return beyond  # what a loop makes is made for each element there is
        return FALSE if beyond == FALSE else both(beyond, self._condition(chooser, sense, value))

    def _condition(self, chooser: str, sense: str, value: str) -> Formula:
        text = self._texts.get(chooser)
        if chooser in self._silent or sense not in ("true", "false", "case", "default"):
            return TRUE
        if text is None:
            return condition(f"called({self._places.get(value, value)})", True) if sense == "case" else TRUE
        place = self._places.get(chooser)
        meaning = self._meaning(chooser, ())
        if sense == "case":
            return self._case(text, meaning, value, True, place)
        if sense == "default":
            formula: Formula = TRUE
            for label in self._cases[chooser]:
                formula = both(formula, self._case(text, meaning, label, False, place))
            return formula
        return condition(text, sense == "true", place, stable=chooser in self._stable, meaning=meaning, words=chooser in self._worded)

    def _meaning(self, node: str, within: tuple[str, ...]) -> str:
        """The text of a condition with its local variables, and its calls of tests, replaced by what they stand for."""
        found = expanded(node, self._meant, self._locals)
        for written, function in self._tests.get(node, ()):
            if function not in within and (returned := self._return_expression(function, (*within, function))) is not None:
                found = replaced(found, written, returned)
        return found

    def _return_expression(self, function: str, within: tuple[str, ...]) -> str | None:
        """What a test returns, as one expression: of several returns, when a true one is reached; None when that cannot be written."""
        values = self._returned[function]
        if any(len(self._blocks.get(value, ())) != 1 or value not in self._texts for value in values):
            return None
        reached = {value: self._of(function, self._blocks[value][0], ()) for value in values}
        if len(values) == 1 and reached[values[0]] == TRUE:
            return self._meaning(values[0], within)
        return normal_text(either(both(guard, self._holds(value, within)) for value, guard in reached.items())) or "true"

    def _holds(self, value: str, within: tuple[str, ...]) -> Formula:
        """When a value that a test returns is true."""
        text, words = self._texts[value], value in self._worded
        if (truth := truth_of(text)) is not None:
            return TRUE if truth else FALSE
        return condition(text, True, self._places.get(value), meaning=self._meaning(value, within), words=words)

    def _case(self, text: str, meaning: str, label: str, holds: bool, place: Place | None) -> Formula:
        value = self._texts.get(label, "?")
        chosen = f"({meaning})" if loosest(meaning) else meaning
        return condition(f"{text} == {value}", holds, place, meaning=f"{chosen} == {value}")


def _tables(values: Iterable[Row]) -> dict[str, list[Mapping[str, str]]]:
    """The rows of the tables that functions search, by what is written for their parts."""
    rows: dict[str, dict[int, dict[str, str]]] = defaultdict(lambda: defaultdict(dict))
    for function, row, part, text in sorted(values):
        rows[function][row][part] = text
    return {function: list(own.values()) for function, own in rows.items()}


def _entered_from(functions: set[str], entries: Mapping[str, Iterable[tuple[str, str]]]) -> set[str]:
    """Those functions, and all that their calls enter."""
    found, size = set(functions), -1
    while size != len(found):
        size = len(found)
        found |= {entered for entered, calls in entries.items() if any(_function(before) in found for _, before in calls)}
    return found


def _apart_from_state(
    texts: Mapping[str, str], shadowing: Iterable[Row], settled: Mapping[str, Iterable[tuple[str, str]]]
) -> Mapping[str, str]:
    """The texts in which locals that are called like state variables are called otherwise, unless what they stand for is known."""
    found = dict(texts)
    for node, name in shadowing:
        if node in found and name not in {local for local, _ in settled.get(node, ())}:
            found[node] = replaced(found[node], name, LOCAL + name)
    return found


def _converted(texts: Mapping[str, str], casts: Iterable[Row]) -> Mapping[str, str]:
    """The texts in which casts that may give another number than they are given are calls: they do not stand for what is in them."""
    found = dict(texts)
    for node, written in sorted(casts):
        if node in found and (match := _CAST.fullmatch(written)):
            found[node] = replaced(found[node], written, f"{match['type'] or match['plain']}({match['inner'] or match['bare']})")
    return found


def _names(name: str, shadows: Collection[str]) -> tuple[str, ...]:
    """What a local is called: another thing, too, where a state variable has its name."""
    return (name, LOCAL + name) if name in shadows else (name,)


def _function(block: str) -> str:
    """The function that a block belongs to: its identifier is the function's and a number."""
    function, separator, number = block.rpartition(" B")
    return function if separator and number.isdigit() else block
