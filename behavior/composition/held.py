"""What the messages in queues hold, as far as their readers distinguish it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from rosarch.behavior.composition.cone import Cone
from rosarch.behavior.composition.contents import as_read
from rosarch.behavior.composition.reactions import Effect
from rosarch.behavior.composition.system import End, System
from rosarch.models.machine.logic import Subject

MOST_CONTENTS = 16
Content = tuple[str | None, ...]
"""The values of what a reader distinguishes of a message, in its order; None where it is not known."""


@dataclass
class Held:
    """What each reader distinguishes of its messages (`read`: the field that it is), and what those in each queue may hold.

    The first of the `contents` of a queue is that nothing is known.
    """

    system: System
    cone: Cone
    read: dict[End, dict[Subject, str]] = field(default_factory=dict)
    contents: dict[int, list[Content]] = field(default_factory=dict)

    def find(self, queue_of: Mapping[End, int], is_given: Callable[[str, Subject], bool]) -> None:
        """Look for what readers distinguish of messages into which some sender puts what is known, unless it `is_given` otherwise."""
        for end in self.cone.steps:
            component, topic = self.system.nodes[end[0]], self.system.inlet(end)
            if end not in queue_of or topic is None:
                continue
            paths = [component.paths_read(end[1], step) for step in self.cone.steps[end]]
            known = {subject: path for own in paths for subject, path in own.items() if not is_given(topic.name, subject)}
            sent = {
                subject
                for subject, path in known.items()
                for node, port in topic.senders
                if not self.cone.fields.isdisjoint((node, key) for key in self.system.nodes[node].fields_sent(port, path))
            }
            ordered = sorted(sent, key=lambda subject: subject.key)
            self.read[end] = {subject: known[subject] for subject in ordered}

    def noted(self, end: End, queue: int, found: Mapping[End, Sequence[Effect]]) -> tuple[str, ...]:
        """What the messages in a queue may hold, as texts, noted; nothing where nothing is known, or too much."""
        topic, unknown = self.system.inlet(end), (None,) * len(self.read[end])
        known: set[Content] = {
            self._as_read(sender, end, effect.content(sender[1]))
            for sender in (topic.senders if topic else ())
            for trigger, effects in found.items()
            if trigger[0] == sender[0]
            for effect in effects
            if sender[1] in effect.sent
        } - {unknown}
        if not known or len(known) >= MOST_CONTENTS:
            del self.read[end]
            return ()
        self.contents[queue] = [unknown, *sorted(known, key=repr)]
        return ("something", *(self._text(end, content) for content in self.contents[queue][1:]))

    def put(self, node: str, effect: Effect, queue_of: Mapping[End, int]) -> tuple[tuple[int, int], ...]:
        """What the messages hold that a reaction sends, by number, with the queues that they come into."""
        found: dict[int, set[int]] = {}
        for port in dict.fromkeys(effect.sent):
            for reader in (end for topic in self.system.outlet((node, port)) for end in topic.receivers):
                queue = queue_of.get(reader)
                if queue is not None and queue in self.contents:
                    own = self.contents[queue].index(self._as_read((node, port), reader, effect.content(port)))
                    found.setdefault(queue, set()).add(own)
        return tuple((queue, min(own) if len(own) == 1 else 0) for queue, own in sorted(found.items()))

    def cases(self, end: End, queue: int, case: Mapping[str, frozenset[str]]) -> Iterator[tuple[frozenset[int], list[Subject]]]:
        """The contents, by number, that are certainly one of a case, and those that may be, with what is not known about them."""
        subjects = list(self.read[end])
        unsure = []
        sure = set()
        for number, content in enumerate(self.contents[queue]):
            known = [(subject, value) for subject, value in zip(subjects, content, strict=True) if subject.key in case]
            if all(value is None or value in case[subject.key] for subject, value in known):
                open_ = [subject for subject, value in known if value is None]
                if open_:
                    unsure.append((frozenset({number}), open_))
                else:
                    sure.add(number)
        if sure:
            yield frozenset(sure), []
        yield from unsure

    def _text(self, end: End, content: Content) -> str:
        known = zip(self.read[end], content, strict=True)
        return ", ".join(f"{subject.text} {value}" for subject, value in known if value is not None)

    def _as_read(self, sender: End, reader: End, content: Mapping[str, str]) -> Content:
        """A content as its reader distinguishes it."""
        sent_by, read_by = (self.system.nodes[node].constants for node, _ in (sender, reader))
        known = {path.removeprefix("request."): value for path, value in content.items()}
        return tuple(
            as_read(known[path], sent_by, subject.values, read_by) if path in known else None for subject, path in self.read[reader].items()
        )
