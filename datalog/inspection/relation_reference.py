"""The relation reference: every relation with its `///` comment and its place among the others, as Markdown."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rosarch.datalog.inspection.clauses import rules_of
from rosarch.datalog.language.strata import turned_around

if TYPE_CHECKING:
    from rosarch.datalog.program import Attribute, Program


@dataclass(frozen=True, slots=True)
class Entry:
    """One relation. `uses` are the relations its rules read, `used_by` those whose rules read it."""

    name: str
    attributes: tuple[Attribute, ...]
    doc: str
    path: str
    line: int
    is_input: bool
    is_output: bool
    rules: int
    facts: int
    uses: tuple[str, ...]
    used_by: tuple[str, ...]
    recursive_with: tuple[str, ...]

    @property
    def private(self) -> bool:
        """Whether the relation is private to its file, by the `_` its name starts with."""
        return self.name.startswith("_")

    @property
    def kind(self) -> str:
        """`input`, `output`, `facts` or `derived`."""
        return "input" if self.is_input else "output" if self.is_output else "derived" if self.rules or not self.facts else "facts"


def reference(program: Program) -> list[Entry]:
    """All relations, in the order of their declarations.

    What a rule uses through a relation that is private to its file counts as used by the rule.
    """
    rules = rules_of(program)
    readers = turned_around(rules.reads)
    entries = []
    for name, declared in program.relations.items():
        own = rules.by_head.get(name, ())
        group = rules.recursive.get(name, frozenset())
        entries.append(
            Entry(
                name, declared.attributes, declared.doc, declared.location.path, declared.location.line, declared.is_input,
                declared.is_output, sum(bool(r.clause.body) for r in own), sum(not r.clause.body for r in own),
                tuple(sorted(_public(name, rules.reads) - {name})), tuple(sorted(_public(name, readers) - {name})),
                tuple(sorted(n for n in group if not n.startswith("_") or n == name)),
            )
        )  # fmt: skip
    return entries


def _public(name: str, edges: Mapping[str, Collection[str]]) -> set[str]:
    """The public relations one step away, steps through private ones not counted."""
    found: set[str] = set()
    seen = {name}
    work = [name]
    while work:
        for other in edges[work.pop()]:
            if other not in seen:
                seen.add(other)
                if other.startswith("_"):
                    work.append(other)
                else:
                    found.add(other)
    return found


def reference_text(
    entries: Sequence[Entry], *, title: str = "Relations", shorten: Callable[[str], str] = str, private: bool = False
) -> str:
    """The reference as Markdown: a section for every file, relations in the order of the file."""
    shown = [e for e in entries if private or not e.private]
    files: dict[str, list[Entry]] = {}
    for entry in shown:
        files.setdefault(entry.path, []).append(entry)
    lines = [f"# {title}", ""]
    lines += [f"- [{shorten(path)}](#{_anchor(shorten(path))}): {', '.join(_link(e.name) for e in own)}" for path, own in files.items()]
    for path, own in files.items():
        lines += ["", f"## {shorten(path)}"]
        for entry in own:
            lines += ["", *_section(entry)]
    return "\n".join(lines) + "\n"


def _anchor(heading: str) -> str:
    """The anchor that Markdown viewers give to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def _link(name: str) -> str:
    return f"[`{name}`](#{_anchor(name)})"


def _section(entry: Entry) -> list[str]:
    signature = ", ".join(f"{a.name}: {a.type}" for a in entry.attributes)
    lines = [f"### {entry.name}", "", f"`{entry.name}({signature})` · {entry.kind}, line {entry.line}"]
    if entry.doc:
        lines += ["", *entry.doc.splitlines()]
    facts = [
        ("Uses", _links(entry.uses)),
        ("Used by", _links(entry.used_by)),
        ("Recursive with", _links(n for n in entry.recursive_with if n != entry.name) or ("itself" if entry.recursive_with else "")),
    ]
    lines += ["", *(f"- {label}: {value}" for label, value in facts if value)] if any(value for _, value in facts) else []
    return lines


def _links(names: Iterable[str]) -> str:
    return ", ".join(_link(n) for n in names)


def summary(entry: Entry) -> str:
    """The first sentence of the documentation of a relation."""
    text = " ".join(entry.doc.split())
    return re.split(r"(?<=[.;])\s", text, maxsplit=1)[0].rstrip(";") if text else ""


def list_text(entries: Sequence[Entry], *, shorten: Callable[[str], str] = str) -> str:
    """One line a relation: kind, signature and place, then what it holds."""
    lines = []
    for entry in entries:
        signature = ", ".join(f"{a.name}: {a.type}" for a in entry.attributes)
        lines.append(f"{entry.kind:<8} {entry.name}({signature})  {shorten(entry.path)}:{entry.line}")
        if entry.doc:
            lines.append(f"         {summary(entry)}")
    return "".join(f"{line}\n" for line in lines)
