"""What Mermaid's and PlantUML's state diagrams have in common: both write states, arrows and descriptions alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from rosarch.models.machine.build import Region, StateMachine
from rosarch.reports.machine_labels import ANY, always_labels, edges, region_title, state_id, state_text, wrapped


@dataclass(frozen=True)
class StateDiagram:
    """How a notation writes a diagram: `escape` its texts, break a line within a label, and `indent` all lines."""

    escape: Callable[[str], str]
    line_break: str
    indent: str

    def lines(self, machine: StateMachine) -> Iterator[str]:
        """A composite state for each region; reactions that stay in a state are written into it."""
        for number, region in enumerate(machine.regions, 1):
            yield from self._region(machine, region, f"r{number}")
        if machine.always:
            yield f'{self.indent}state "in every state" as always'
            yield from self._inside("always", always_labels(machine), self.indent)

    def _region(self, machine: StateMachine, region: Region, name: str) -> Iterator[str]:
        inner = self.indent + "  "
        yield f'{self.indent}state "{self.escape(region_title(region))}" as {name} {{'
        for state in range(len(region.states)):
            yield f'{inner}state "{self.escape(state_text(region, state))}" as {name}_{state}'
        for state in region.initial:
            yield f"{inner}[*] --> {name}_{state}"
        found = edges(machine, region)
        if any(edge.source == ANY for edge in found):
            yield f'{inner}state "any state" as {state_id(name, ANY)}'
        for edge in found:
            if edge.source == edge.target:
                yield from self._inside(state_id(name, edge.source), edge.labels, inner)
            else:
                label = self.line_break.join(self.escape(line) for label in edge.labels for line in wrapped(label))
                yield f"{inner}{state_id(name, edge.source)} --> {state_id(name, edge.target)} : {label}"
        yield f"{self.indent}}}"

    def _inside(self, state: str, labels: Iterable[str], indent: str) -> Iterator[str]:
        for label in labels:
            for line in wrapped(label):
                yield f"{indent}{state} : {self.escape(line)}"
