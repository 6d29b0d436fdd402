"""A model against the truth, element by element: what is found, missed and extra, and how far the attributes of what is found agree.

Ports are matched by kind and resolved name (unknown names by line), parameters by name and access, periodic and reactive behaviour by its
ports, variables by name, transitions by variable and line. What truth calls `optional` counts neither when it is found nor when it is not;
ports that a library makes inside itself (`implicit`), and behaviour on these, are not compared. `~name` and `~/name` are the
same name.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from rosarch.evaluation.experiments.normal_texts import conjuncts, jaccard, line_of, normal, same_name, short

Document = Mapping[str, Any]
Key = tuple[Hashable, ...]
Names = dict[tuple[str, Any], Key]

CATEGORIES = ("ports", "params", "periodic", "reactive", "state variables", "transitions")
HIT, EXTRA, MISSED, OPTIONAL = "hit", "extra", "missed", "optional"
FINDINGS = "findings"
"""The category of what checks find in the systems of a subject."""
_UNKNOWN = "?"
_IMPLICIT: Key = ("implicit", "")
_TRUTH, _FOUND = "truth", "found"


@dataclass(frozen=True)
class Element:
    """An element of a model for a reader: what it is and where (`path:line`); `verdict` is one of the words above."""

    text: str
    at: str
    verdict: str


@dataclass(frozen=True)
class Counts:
    """How many elements are found that are true, found that are not, and true but not found."""

    hit: int = 0
    extra: int = 0
    missed: int = 0

    def __add__(self, other: Counts) -> Counts:
        return Counts(self.hit + other.hit, self.extra + other.extra, self.missed + other.missed)

    @property
    def recall(self) -> float:
        """The share of the truth that is found; 0 where there is none."""
        return self.hit / max(1, self.hit + self.missed)

    @property
    def precision(self) -> float:
        """The share of what is found that is true; 0 where nothing is found."""
        return self.hit / max(1, self.hit + self.extra)

    @property
    def f1(self) -> float:
        """The harmonic mean of both."""
        return 2 * self.hit / max(1, 2 * self.hit + self.extra + self.missed)


@dataclass
class Comparison:
    """Of one component: its elements by category and key, and for each attribute how far the matched elements agree, from 0 to 1."""

    elements: dict[str, dict[Key, Element]] = field(default_factory=lambda: {category: {} for category in CATEGORIES})
    agreement: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))

    def counts(self, category: str) -> Counts:
        """Those of a category."""
        verdicts = [element.verdict for element in self.elements[category].values()]
        return Counts(verdicts.count(HIT), verdicts.count(EXTRA), verdicts.count(MISSED))

    def agrees(self, attribute: str, wanted: Any, found: Any) -> None:
        """Compare an attribute, if the truth has it."""
        if wanted is not None:
            self.agreement[attribute].append(float(normal(wanted) == normal(found)))


def compare(truth: Document, found: Document) -> Comparison:
    """A model against the truth, both with the fields of a model's document; an empty model has found nothing."""
    comparison = Comparison()
    names = _ports(comparison, truth, found)
    _parameters(comparison, truth, found)
    _periodic(comparison, truth, found, names)
    _reactive(comparison, truth, found, names)
    alias = _state_variables(comparison, truth, found)
    _transitions(comparison, truth, found, names, alias)
    return comparison


class _Side:
    """The elements of one document in a category: whether each is optional, and its place."""

    def __init__(self) -> None:
        self.optional: dict[Key, bool] = {}
        self.at: dict[Key, Any] = {}
        self.entries: dict[Key, list[Document]] = defaultdict(list)

    def add(self, key: Key, entry: Document, *, optional: bool = False) -> None:
        """An entry of the document; several may be one element."""
        self.optional[key] = self.optional.get(key, True) and optional
        self.at.setdefault(key, entry.get("at"))
        self.entries[key].append(entry)


def _settle(comparison: Comparison, category: str, truth: _Side, found: _Side, show: Callable[[Key], str]) -> None:
    elements = comparison.elements[category]
    for key in found.optional:
        verdict = EXTRA if key not in truth.optional else OPTIONAL if truth.optional[key] else HIT
        elements[key] = Element(show(key), _first_place(found.at[key]), verdict)
    for key, optional in truth.optional.items():
        if key not in found.optional and not optional:
            elements[key] = Element(show(key), _first_place(truth.at[key]), MISSED)


def _first_place(at: Any) -> str:
    if isinstance(at, list):
        at = at[0] if at else ""
    return str(at or "")


def _optional(entry: Document) -> bool:
    return bool(entry.get("optional"))


def _entries(document: Document, field_: str) -> Iterable[Document]:
    return document.get(field_) or ()


def _ports(comparison: Comparison, truth: Document, found: Document) -> Names:
    """Compare ports; the result has the key of each port by side and id."""
    names: Names = {}
    wanted, got = _Side(), _Side()
    for port in _entries(truth, "ports"):
        key = names[_TRUTH, port["id"]] = _port_key(port)
        wanted.add(key, port, optional=_optional(port))
    for index, port in enumerate(_entries(found, "ports")):
        id_ = port.get("id", f"#{index}")
        if port.get("implicit"):
            names[_FOUND, id_] = _IMPLICIT
            continue
        key = _port_key(port)
        if _UNKNOWN in str(key[1]) and key not in wanted.optional:  # an unknown name at the line of an unknown name
            line = f"@{line_of(port.get('at'))}"
            same = (k for k in wanted.optional if k[0] == key[0] and _UNKNOWN in str(k[1]) and str(k[1]).endswith(line))
            key = next(same, key)
        names[_FOUND, id_] = key
        got.add(key, port)
        for other in wanted.entries.get(key, ())[:1]:
            _port_attributes(comparison, other, port)
    _settle(comparison, "ports", wanted, got, _show_port)
    return names


def _port_key(port: Document) -> Key:
    name = "/tf" if str(port["kind"]).startswith("tf_") else _name(port.get("name") or _UNKNOWN)
    return (port["kind"], f"{name}@{line_of(port.get('at'))}" if _UNKNOWN in name else name)


def _name(written: Any) -> str:
    """A name as ROS 1 writes it: ROS 2 has `~/name` for `~name` (https://design.ros2.org/articles/topic_and_service_names.html)."""
    name = str(written)
    return f"~{name[2:]}" if name.startswith("~/") else name


def _show_port(key: Key) -> str:
    return f"{key[0]} {str(key[1]).partition('@')[0]}"


def _port_attributes(comparison: Comparison, wanted: Document, found: Document) -> None:
    comparison.agrees("port type", wanted.get("type"), found.get("type"))
    comparison.agrees("port queue", wanted.get("queue"), found.get("queue"))
    comparison.agrees("port latched", bool(wanted.get("latched")), bool(found.get("latched")))
    if wanted.get("callback"):
        comparison.agreement["port callback"].append(float(same_name(wanted["callback"], found.get("callback"))))


def _parameters(comparison: Comparison, truth: Document, found: Document) -> None:
    sides = []
    for document in (truth, found):
        side = _Side()
        for parameter in _entries(document, "params"):
            access = "read" if parameter.get("op") in {"read", "has", None} else parameter["op"]
            side.add((_name(parameter["name"]), access), parameter, optional=_optional(parameter))
        sides.append(side)
    _settle(comparison, "params", sides[0], sides[1], lambda key: f"{key[1]} {key[0]}")
    by_name = {_name(parameter["name"]): parameter for parameter in _entries(found, "params")}
    for parameter in _entries(truth, "params"):
        if (name := _name(parameter["name"])) in by_name:
            comparison.agrees("param default", parameter.get("default"), by_name[name].get("default"))


def _periodic(comparison: Comparison, truth: Document, found: Document, names: Names) -> None:
    """One behaviour is one port that one timed loop or timer sends through."""
    sides = {}
    for side, document in ((_TRUTH, truth), (_FOUND, found)):
        sides[side] = _Side()
        for loop in _entries(document, "periodic"):
            for port in loop.get("publishes") or ():
                key = _named(names, side, port)
                if key != _IMPLICIT:
                    sides[side].add(key, loop, optional=_optional(loop))
    _settle(comparison, "periodic", sides[_TRUTH], sides[_FOUND], _show_end)
    for key in _both(sides):
        rates = [{normal(loop.get("hz")) for loop in side.entries[key]} for side in sides.values()]
        comparison.agreement["periodic hz"].append(float(bool(rates[0] & rates[1])))


def _reactive(comparison: Comparison, truth: Document, found: Document, names: Names) -> None:
    sides = {}
    for side, document in ((_TRUTH, truth), (_FOUND, found)):
        sides[side] = _Side()
        for entry in _entries(document, "reactive"):
            ends = tuple(_end(names, side, entry[end]) for end in ("input", "output"))
            if _IMPLICIT not in ends:
                sides[side].add(ends, entry, optional=_optional(entry))
    _settle(comparison, "reactive", sides[_TRUTH], sides[_FOUND], lambda key: f"{_show_end(key[0])} -> {_show_end(key[1])}")
    for key in _both(sides):
        must = [any(entry.get("must") for entry in side.entries[key]) for side in sides.values()]
        comparison.agreement["reactive must"].append(float(must[0] == must[1]))


def _named(names: Names, side: str, port: Any) -> Key:
    """The key of a port that one side calls `port`; unknown ids are of that side only."""
    return names.get((side, port), (side, port))


def _end(names: Names, side: str, port: Any) -> Hashable:
    """The key of a port, or a word (`thread`, `main`) that both sides may have."""
    word: Hashable = port
    return names.get((side, port), word)


def _show_end(end: Hashable) -> str:
    return _show_port(end) if isinstance(end, tuple) else str(end)


def _both(sides: Mapping[str, _Side]) -> list[Key]:
    """The keys that both sides have."""
    return [key for key in sides[_TRUTH].optional if key in sides[_FOUND].optional]


def _state_variables(comparison: Comparison, truth: Document, found: Document) -> dict[str, str]:
    """Compare state variables; the result has the name in the truth of each that is found."""
    known = [*_entries(truth, "state_variables"), *_entries(truth, "configuration")]
    alias = {}
    wanted, got = _Side(), _Side()
    by_name: dict[str, Document] = {}
    for variable in _entries(truth, "state_variables"):
        wanted.optional[(short(variable["name"]),)] = _optional(variable)
        wanted.at[(short(variable["name"]),)] = variable.get("at")
    for variable in _entries(found, "state_variables"):
        match = next((each for each in known if same_name(each["name"], variable["name"])), variable)
        name = alias[variable["name"]] = short(match["name"])
        by_name[name] = variable
        got.add((name,), variable)
    _settle(comparison, "state variables", wanted, got, lambda key: str(key[0]))
    for variable in _entries(truth, "state_variables"):
        if (other := by_name.get(short(variable["name"]))) is not None:
            comparison.agrees("state initial", variable.get("initial"), other.get("initial"))
    return alias


def _transitions(comparison: Comparison, truth: Document, found: Document, names: Names, alias: Mapping[str, str]) -> None:
    """One transition is one assignment: a variable and a line."""
    sides = {}
    for side, document in ((_TRUTH, truth), (_FOUND, found)):
        sides[side] = _Side()
        for entry in _entries(document, "transitions"):
            name = short(entry["variable"])
            name = alias.get(entry["variable"], name) if side == _FOUND else name
            key: Key = (name, *line_of(entry.get("at")))
            sides[side].add(key, entry, optional=bool(entry.get("optional") or entry.get("build_condition")))
    _settle(comparison, "transitions", sides[_TRUTH], sides[_FOUND], lambda key: f"{key[0]} is assigned")
    for key in _both(sides):
        wanted, got = sides[_TRUTH].entries[key], sides[_FOUND].entries[key]
        triggers = [
            {str(_end(names, side, trigger)) for entry in sides[side].entries[key] for trigger in entry.get("trigger") or ()}
            for side in sides
        ]
        pairs = [(one, other) for one in wanted for other in got]
        guard = max(jaccard(conjuncts(one.get("guard")), conjuncts(other.get("guard"))) for one, other in pairs)
        value = max(float(normal(one.get("value")) == normal(other.get("value"))) for one, other in pairs)
        comparison.agreement["transition trigger"].append(jaccard(*triggers))
        comparison.agreement["transition guard"].append(guard)
        comparison.agreement["transition value"].append(value)
