"""Proofs as text: a tree with the rule of every row, and the source lines that its leaves stand for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from rosarch.datalog.inspection.proofs import Absent, AggregateValue, Condition, Premise, Proof
from rosarch.datalog.inspection.source_lines import SourceLines

BRANCH, LAST, THROUGH, BLANK = "├─ ", "└─ ", "│  ", "   "
MOST_ROWS = 5
_KINDS = {"input": "input", "unexplained": "through rows that are gone"}


@dataclass(frozen=True)
class Layout:
    """How much of a proof to print; `shorten` makes the path of a rule file shorter."""

    depth: int | None = None
    rules: bool = False
    shorten: Callable[[str], str] = str
    most_rows: int | None = MOST_ROWS


def proof_text(proof: Proof, *, layout: Layout | None = None, lines: SourceLines | None = None) -> str:
    """A proof as a tree, one row a line; a row that was proven further up is not proven again.

    With `lines`, the source lines that the leaves of the whole proof are about follow.
    """
    text = "".join(f"{line}\n" for line in _lines(proof, layout or Layout()))
    found = lines.of(leaf.row for leaf in proof.leaves()) if lines is not None else []
    return text + "".join(f"{line}\n" for line in ("source lines:", *(f"  {line}" for line in found)) if found)


def _lines(proof: Proof, layout: Layout) -> Iterator[str]:
    printed: set[int] = set()
    work: list[tuple[Premise, str, str, int]] = [(proof, "", "", 0)]
    while work:
        premise, first, rest, depth = work.pop()
        below: tuple[Premise, ...] = ()
        match premise:
            case Proof():
                again = id(premise) in printed
                below = () if again or depth == layout.depth else premise.premises
                if below:
                    printed.add(id(premise))
                yield f"{first}{premise.text}  {_note(premise, layout, again, bool(below))}"
                if layout.rules and premise.kind == "rule" and not again:
                    yield f"{rest}{THROUGH if below else BLANK}{premise.rule}"
            case Absent():
                yield f"{first}{premise.text}  absent"
            case Condition():
                yield f"{first}{premise.values}"
            case AggregateValue():
                yield from _aggregate(premise, first, rest, layout.most_rows)
        last = len(below) - 1
        for number, child in reversed(list(enumerate(below))):
            work.append((child, rest + (LAST if number == last else BRANCH), rest + (BLANK if number == last else THROUGH), depth + 1))


def _note(proof: Proof, layout: Layout, again: bool, more: bool) -> str:
    if proof.location is None:
        return _KINDS[proof.kind]
    place = f"{layout.shorten(proof.location.path)}:{proof.location.line}"
    if again:
        return f"{place}, proven above"
    return f"{place}, ..." if proof.premises and not more else place


def _aggregate(premise: AggregateValue, first: str, rest: str, most: int | None) -> Iterator[str]:
    yield f"{first}{premise.text} = {premise.value}{'' if premise.rows else '  no rows'}"
    shown = premise.rows if most is None or len(premise.rows) <= most + 1 else premise.rows[:most]
    lines = [row.text for row in shown]
    if len(shown) < len(premise.rows):
        lines.append(f"... {len(premise.rows) - len(shown)} more")
    for number, line in enumerate(lines):
        yield f"{rest}{LAST if number == len(lines) - 1 else BRANCH}{line}"
