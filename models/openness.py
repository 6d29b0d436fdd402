"""What was not seen of components and systems, as text: the reasons that rules give (`openness.dl` of components and systems)."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.base.places import Place

_REASONS = {
    # of components
    "handed": "the node is handed to {}, which was not seen",
    "given": "the node is given as {} to something that was not seen",
    "undefined": "the node is handed to {}, whose body is not among the sources",
    "base": "the base class {} was not seen",
    "makes": "{}, which was not seen, makes ports of its own",
    "factory": "{} makes a node of a class that only its library names",
    "call": "the call of {} was not understood",
    "otherwise": "a port may have another name: {}",
    "import": "{} imports a module whose name is not known",
    "member": "a method of {} is called whose name is not known",
    "source": "the source was not analysed: {}",
    "lost": "a function was not understood: {}",
    "macro": "the macro {} stands in a class of nodes and was not seen",
    # of code that does not run
    "uncalled": "nothing calls {}",
    "unused": "nothing builds, imports or starts the source",
    # of nodes
    "model": "{} has no model",
    "library": "the model of {} in the library is not complete",
    "plugin": "it loads plug-ins that were not seen: {}",
    "name": "the name of a parameter is not known: {}",
    "parameters": "a file of parameters for {} was not read",
    "tree": "not all of the behavior tree was read: {}",
    "tree node": "its behavior tree has nodes that were not seen: {}",
    # of systems
    "include": "the included file {} was not read",
    "launch": "{}",
}


def reason_text(kind: str, subject: str) -> str:
    """A reason as text; `subject` is the name of a function, a class, a file."""
    return _REASONS[kind].format(subject)


@dataclass(frozen=True, order=True)
class Unseen:
    """There may be more of `what` (ports, params) than is known, because of something at `at`; `kind` and `subject` are the reason."""

    what: str
    kind: str
    subject: str
    at: Place

    @property
    def reason(self) -> str:
        """The reason as text."""
        return reason_text(self.kind, self.subject)


@dataclass(frozen=True, order=True)
class OpenPart:
    """What was not seen of a system, for `reason`, because of what is at `at`.

    `node` is the name of the node that may have more than is known, "" where it is nodes that may run unseen.
    """

    node: str
    reason: str
    at: Place
