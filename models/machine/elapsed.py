"""How long ago something was: comparisons of the time since a moment that a variable keeps with a limit.

When the variable gets its next moment, the time since then is short; at some time later it is long, and stays so until the next moment.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from rosarch.base.logic import TRUE, Not, substituted
from rosarch.models.machine.cells import Cell, Document
from rosarch.models.machine.conditions import Comparison, compact, parse_condition
from rosarch.models.machine.epochs import Guard, guard_of
from rosarch.models.machine.logic import Formula, Is, Subject, subjects
from rosarch.models.machine.meaning import Assignment
from rosarch.models.machine.steps import Step

SHORT, LONG = "short", "long"
_OLDER, _YOUNGER = (">", ">="), ("<", "<=")


def with_elapsed(document: Document, steps: Mapping[str, Sequence[Step]]) -> tuple[dict[str, list[Step]], dict[str, Cell]]:
    """The steps, where such comparisons are tests of cells that are short from each new moment on, and these cells."""
    moments = [str(name) for (name,) in (document.get("traits") or {}).get("keeps_moment", ())]
    names = {_last(row["name"]) for row in document.get("state_variables") or ()}
    known: dict[Subject, Formula] = {}
    cells: dict[str, dict[str, Cell]] = {}
    for subject in {subject for own in steps.values() for step in own for subject in step.tested()} if moments else ():
        for name in moments:
            if (found := _compared(subject, name, names)) is not None:
                cell, when = found
                known[subject] = Is(cell.subject, frozenset({when}))
                cells.setdefault(name, {})[cell.subject.key] = cell
    changed = {trigger: [_changed(step, known, cells, document) for step in own] for trigger, own in steps.items()}
    doubtful = {trigger for trigger, own in changed.items() if any(_asked_again(own, name, cells[name], document) for name in cells)}
    clear = {trigger: [replace(step, unclear=True) if trigger in doubtful else step for step in own] for trigger, own in changed.items()}
    return clear, {key: cell for own in cells.values() for key, cell in own.items()}


def _asked_again(steps: Sequence[Step], name: str, cells: Mapping[str, Cell], document: Document) -> bool:
    """Whether one reaction may take a new moment and then ask for the time since then at another place than before."""
    taken: list[tuple[Guard, set[str]]] = []
    asked: set[str] = set()
    for step in steps:
        guard, places = guard_of(_tree(step, document)), set()
        if any(subject.key in cells for formula in step.guard for subject in subjects(formula)):
            places = {place for place, leaves in guard.at.items() if any(_last(name) in leaf.text for leaf in leaves)} or set(guard.at)
            if len(asked | places) > 1 and any(places - before and not other.excludes(guard) for other, before in taken):
                return True
        asked |= places
        if any(assignment.cell.subject.key in cells for assignment in step.assignments):
            taken.append((guard, places))
    return False


def _tree(step: Step, document: Document) -> object:
    """The guard that the row of a step has."""
    rows = document.get(step.row.kind) or ()
    row = rows[step.row.index] if step.row.index < len(rows) else {}
    return next((row[kind] for kind in ("guard_tree", "when_tree", "conditional_tree") if row.get(kind)), None)


def _last(name: str) -> str:
    return name.rsplit("::", 1)[-1]


def _compared(subject: Subject, name: str, names: Iterable[str]) -> tuple[Cell, str] | None:
    """The cell for the time since the moment that a variable keeps, and its value where the comparison holds; the limit is no variable."""
    condition = None if subject.cell or subject.hidden else parse_condition(subject.text)
    if not isinstance(condition, Comparison) or condition.op not in (*_OLDER, *_YOUNGER):
        return None
    if set(re.findall(r"\w+", subject.text)).intersection(names) != {_last(name)}:
        return None
    since = re.compile(rf"-\s*(?:this\s*->\s*|self\.)?{re.escape(_last(name))}(?!\w)")
    found = [bool(since.search(side)) for side in (condition.left, condition.right)]
    if found[0] is found[1]:
        return None
    limit = condition.right if found[0] else condition.left
    key = f"time since {name} beside {compact(limit)}"
    cell = Cell(Subject(key, f"time since {_last(name)}", (SHORT, LONG), True), key, "", "", (SHORT,), "")
    return cell, LONG if (condition.op in _OLDER) is found[0] else SHORT


def _changed(step: Step, known: Mapping[Subject, Formula], cells: Mapping[str, Mapping[str, Cell]], document: Document) -> Step:
    if not known:
        return step

    def replacement(atom: Is) -> Formula:
        found = known.get(atom.subject)
        return atom if found is None else found if atom.values == {"true"} else Not(found)

    guard = tuple(substituted(formula, replacement) for formula in step.guard)
    tables = [replace(a, table=tuple((substituted(formula, replacement), value) for formula, value in a.table)) for a in step.assignments]
    if step.row.kind == "transitions":
        row = document["transitions"][step.row.index]
        tables += [Assignment(cell, ((TRUE, SHORT),)) for cell in cells.get(str(row["variable"]), {}).values()]
    return replace(step, guard=guard, assignments=tuple(tables))
