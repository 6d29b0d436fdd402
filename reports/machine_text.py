"""State machines as text: per region, what happens in which states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from rosarch.models.machine.build import Region, StateMachine, Transition
from rosarch.reports.labels import counted
from rosarch.reports.machine_labels import (
    Arc,
    Lines,
    alternatives,
    arcs,
    formula_text,
    outputs_texts,
    region_title,
    state_text,
    states_text,
    target_text,
    title,
    triggers_text,
    valuation_text,
    value_text,
)

_WIDE = 130


@dataclass(frozen=True)
class Line:
    """What is written about transitions of one kind."""

    on: str
    target: str
    sends: tuple[str, ...]
    lines: str
    guard: str = ""
    guards: tuple[str, ...] = ()

    @property
    def is_short(self) -> bool:
        """Whether it all fits on one line."""
        return len(self.on) + len(self.target) + sum(map(len, self.sends)) + len(self.lines) + len(self.guard) < _WIDE

    @property
    def arrow(self) -> str:
        """Where it leads."""
        return self.target if self.target in ("", "stays") else f"-> {self.target}"


def machine_text(machine: StateMachine) -> str:
    """One machine: a header, its regions, the reactions that no state matters to, and what was found wanting."""
    lines = Lines(machine)
    head = [title(machine)]
    head.append(f"node {machine.node_name}" if machine.kind == "node" and machine.node_name else machine.kind)
    head += [lines.shared] if lines.shared else []
    blocks = ["  ".join(head), *(_region(machine, region, lines) for region in machine.regions)]
    if machine.always:
        rows = [
            Line(triggers_text(machine, [t.trigger for t in same]), "", sends, lines.of(row for t in same for row in t.rows))
            for sends, same in _by_outputs(machine).items()
        ]
        blocks.append("\n".join([f"in every state{'' if machine.regions else ', as there is no state'}", *_aligned(rows)]))
    if not machine.regions and not machine.always:
        blocks.append("no state, no reactions")
    notes = _notes(machine, lines)
    return "\n\n".join(blocks + (["\n".join(notes)] if notes else [])) + "\n"


def _by_outputs(machine: StateMachine) -> dict[tuple[str, ...], list[Transition]]:
    found: dict[tuple[str, ...], list[Transition]] = {}
    for transition in machine.always:
        found.setdefault(tuple(outputs_texts(machine, transition.outputs)), []).append(transition)
    return found


def _region(machine: StateMachine, region: Region, lines: Lines) -> str:
    out = [f"{region_title(region)}  {lines.text([cell.at for cell in region.cells if cell.at])}".rstrip()]
    if len(region.cells) == 1:
        begins = " or ".join(state_text(region, state) for state in region.initial)
        out.append(f"  {' | '.join(state_text(region, state) for state in range(len(region.states)))}, begins {begins}")
    else:
        begins = states_text(region, region.initial)
        out.append(f"  {counted(len(region.states), 'state')}, begins {begins}")
    found = arcs(region)
    for sources in dict.fromkeys(arc.sources for arc in found):
        out.append(f"  {states_text(region, sources)}")
        out += _aligned(_folded([_cells(machine, region, arc, lines) for arc in found if arc.sources == sources]))
    if not found:
        out.append("  never changes")
    return "\n".join([*out, *_never(region)])


def _cells(machine: StateMachine, region: Region, arc: Arc, lines: Lines) -> Line:
    return Line(
        triggers_text(machine, arc.triggers),
        target_text(region, arc) or "stays",
        tuple(outputs_texts(machine, arc.outputs)),
        lines.of(arc.rows),
        formula_text(arc.guard),
        tuple(alternatives(arc.guard)),
    )


def _folded(rows: Sequence[Line]) -> list[Line]:
    """Lines that differ in the target alone, as the source does not say it, as one."""
    found: dict[Line, list[str]] = {}
    for line in rows:
        found.setdefault(replace(line, target=""), []).append(line.target or "stays")
    return [replace(line, target=" or ".join(dict.fromkeys(targets))) for line, targets in found.items()]


def _aligned(rows: Sequence[Line]) -> list[str]:
    """A line for each row, in columns; what does not fit gets lines of its own below."""
    table = {row: _parts(row) for row in rows if row.is_short}
    widths = [max(map(len, column)) for column in zip(*table.values(), strict=True)]
    out = []
    for row in rows:
        if row in table:
            cells = [cell.ljust(width) for cell, width in zip(table[row], widths, strict=True) if width]
            out.append(f"    {'  '.join(cells)}".rstrip())
        else:
            out.append(f"    {'  '.join(filter(None, (row.on, row.arrow, row.lines)))}")
            out += [f"        {'or' if number else 'if'} {part}" for number, part in enumerate(row.guards) if part]
            out += [f"        sends {part}" for part in row.sends]
    return out


def _parts(row: Line) -> tuple[str, str, str, str, str]:
    sends = f"sends {'; '.join(row.sends)}" if row.sends else ""
    return row.on, row.arrow, sends, row.lines, f"if {row.guard}" if row.guard else ""


def _never(region: Region) -> list[str]:
    """Values and states that cannot be reached."""
    subjects = {cell.subject.key: cell.subject for cell in region.cells}
    out = [f"  never {subjects[key].text} = {', '.join(value_text(subjects[key], v) for v in values)}" for key, values in region.never]
    gone = [set(values) for _, values in region.never]
    rest = [v for v in region.unreachable if not any(value in values for value, values in zip(v, _by_cell(region), strict=True))]
    if rest and (len(region.cells) > 1 or not gone):
        out.append(f"  unreachable: {'; '.join(valuation_text(region, values) for values in rest)}")
    return out


def _by_cell(region: Region) -> list[set[str]]:
    never = dict(region.never)
    return [set(never.get(cell.subject.key, ())) for cell in region.cells]


def _notes(machine: StateMachine, lines: Lines) -> list[str]:
    out = []
    if machine.dead:
        out.append(f"never happens: {lines.of(machine.dead)}")
    if machine.left_out:
        out.append(f"without finite values: {', '.join(name.rsplit('::', 1)[-1] for name in machine.left_out)}")
    return [*out, *(f"note: {message}" for message in machine.messages)]
