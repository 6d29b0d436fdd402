"""State machines as Graphviz graphs."""

from __future__ import annotations

from rosarch.models.machine.build import Region, StateMachine
from rosarch.reports.machine_labels import ANY, always_labels, edges, region_title, state_id, state_text, title, wrapped


def machine_text(machine: StateMachine) -> str:
    """One graph: a cluster for each region; reactions that stay in a state are written into it."""
    out = [
        f"digraph {_quoted([title(machine)])} {{",
        f"  label={_quoted([title(machine)])}; labelloc=t; fontname=Helvetica; compound=true;",
        '  node [shape=box, style="rounded", fontname=Helvetica]; edge [fontname=Helvetica, fontsize=10];',
    ]
    for number, region in enumerate(machine.regions, 1):
        out += _region(machine, region, f"r{number}")
    if machine.always:
        lines = ["in every state", *(line for label in always_labels(machine) for line in wrapped(label))]
        out.append(f"  always [label={_quoted(lines)}, style=dashed];")
    return "\n".join([*out, "}"]) + "\n"


def _region(machine: StateMachine, region: Region, name: str) -> list[str]:
    out = [f"  subgraph cluster_{name} {{", f"    label={_quoted([region_title(region)])}; style=dotted;"]
    found = edges(machine, region)
    inner = {edge.source: edge.labels for edge in found if edge.source == edge.target}
    for state in range(len(region.states)):
        lines = [state_text(region, state), *(line for label in inner.get(state, ()) for line in wrapped(label))]
        out.append(f"    {name}_{state} [label={_quoted(lines)}];")
    for state in region.initial:
        out.append(f"    {name}_start_{state} [shape=point]; {name}_start_{state} -> {name}_{state};")
    if any(edge.source == ANY for edge in found):
        out.append(f'    {state_id(name, ANY)} [label="any state", style="rounded,dashed"];')
    for edge in found:
        if edge.source != edge.target:
            lines = [line for label in edge.labels for line in wrapped(label)]
            out.append(f"    {state_id(name, edge.source)} -> {state_id(name, edge.target)} [label={_quoted(lines, end=True)}];")
    return [*out, "  }"]


def _quoted(lines: list[str], *, end: bool = False) -> str:
    """A quoted string; several lines flush left, below a centred first one unless each is to `end` alike."""
    escaped = [line.replace("\\", "\\\\").replace('"', '\\"') for line in lines]
    if len(escaped) == 1 and not end:
        return f'"{escaped[0]}"'
    if end:
        return '"' + "".join(f"{line}\\l" for line in escaped) + '"'
    return f'"{escaped[0]}\\n' + "".join(f"{line}\\l" for line in escaped[1:]) + '"'
