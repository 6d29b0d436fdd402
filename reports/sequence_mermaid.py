"""Who sends what to whom, one after another, as a Mermaid sequence diagram."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from rosarch.behavior.composition.system import Topic


@dataclass(frozen=True)
class Arrow:
    """A message from one participant to another."""

    source: str
    target: str
    text: str


@dataclass(frozen=True)
class Remark:
    """A note on a participant."""

    participant: str
    text: str


@dataclass(frozen=True)
class Repeated:
    """What happens again and again."""

    items: tuple[Arrow | Remark, ...]


def arrows(sender: str, topic: Topic, text: str) -> Iterator[Arrow]:
    """A message on a topic to each node that receives it; back to the sender, where nobody does."""
    receivers = sorted({node for node, _ in topic.receivers})
    return (Arrow(sender, node, text) for node in receivers or [sender])


def sequence_text(items: Sequence[Arrow | Remark | Repeated], title: str = "") -> str:
    """The diagram."""
    names: dict[str, str] = {}
    for item in _flat(items):
        for name in (item.source, item.target) if isinstance(item, Arrow) else (item.participant,):
            names.setdefault(name, f"n{len(names)}")
    lines = [*(["---", f'title: "{_escaped(title)}"', "---"] if title else []), "sequenceDiagram"]
    lines += [f"  participant {id_} as {_escaped(name)}" for name, id_ in names.items()]
    for part in items:
        if isinstance(part, Repeated):
            lines += ["  loop again and again", *(f"  {_line(inner, names)}" for inner in part.items), "  end"]
        else:
            lines.append(_line(part, names))
    return "\n".join([*lines, ""])


def _flat(items: Iterable[Arrow | Remark | Repeated]) -> Iterable[Arrow | Remark]:
    for item in items:
        yield from item.items if isinstance(item, Repeated) else (item,)


def _line(item: Arrow | Remark, names: dict[str, str]) -> str:
    if isinstance(item, Arrow):
        return f"  {names[item.source]}->>{names[item.target]}: {_escaped(item.text)}"
    return f"  Note over {names[item.participant]}: {_escaped(item.text)}"


_ESCAPES = str.maketrans({"#": "#35;", ";": "#59;", '"': "#quot;", "\n": " "})


def _escaped(text: str) -> str:
    return text.translate(_ESCAPES)
