"""What a component does: periodic and reactive sending, state variables and their transitions, from the relations that the rules derive."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from rosarch.base.logic import FALSE, TRUE
from rosarch.base.places import Place
from rosarch.models import formula
from rosarch.models.contents import NO_CONTENTS, Contents, sent_contents
from rosarch.models.formula import Formula
from rosarch.models.guards import Guards, Way
from rosarch.models.machine.conditions import constant
from rosarch.models.numbers import calculated, frequency
from rosarch.models.switches import Switched, sent_while_starting, switched_things

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]
PortIds = Mapping[Any, str]
_Rates = tuple[tuple[float | None, str | None], ...]
_Key = TypeVar("_Key", bound=Hashable)


@dataclass(frozen=True)
class Sending:
    """One of several ways in which something is sent: a place, or a chain of calls to it, under a guard of its own.

    `publishes` is what is sent, where that is not all that is; `trail` is as that of `Way`.
    """

    at: Place
    guard: Formula
    trail: tuple[Place, ...] | None = None
    publishes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Periodic:
    """What a timed loop or timer sends under one guard; `hz` is None when the frequency is not known.

    `ways` are the chains of calls that lead to the places that send, where there are several.
    """

    mechanism: str
    hz: float | None
    hz_from_param: str | None
    publishes: tuple[str, ...]
    at: Place
    guard: Formula
    ways: tuple[Sending, ...] = ()


@dataclass(frozen=True)
class Reactive:
    """The component sends through `output` when something arrives at `input`; `must`: always.

    `ways` are the places that send, each with a guard of its own, where there are several.
    """

    input: str
    output: str
    at: tuple[Place, ...]
    must: bool
    guard: Formula
    ways: tuple[Sending, ...] = ()


@dataclass(frozen=True)
class OneShot:
    """The component sends through `output` when a timer that runs once has run out, after `after` seconds; `must`: always."""

    after: float | None
    after_from_param: str | None
    output: str
    sent_at: tuple[Place, ...]
    must: bool
    at: Place
    guard: Formula
    ways: tuple[Sending, ...] = ()


@dataclass(frozen=True)
class Deferred:
    """What arrives at `input` is kept in `variable`, from which a timed loop or timer later makes what it sends through `output`."""

    input: str
    output: str
    variable: str


@dataclass(frozen=True)
class StateVariable:
    """A variable that decides what the component does; `initial` is C++ text, or the default of `from_param`.

    `domain` has the values that it can have, in C++; it is None when they cannot be listed.
    """

    name: str
    type: str
    initial: str | None
    from_param: str | None
    domain: tuple[str, ...] | None
    at: Place


@dataclass(frozen=True)
class Transition:
    """An assignment to a state variable; `field` is the part that is assigned, `trigger` has port ids and kinds of activities.

    `timed_by` are the places of the timed loops and timers among the triggers, as those of `Periodic` and `OneShot`. `meaning` is the value
    with locals replaced by what they stand for, where that differs. `trail` is as that of `Way`.
    """

    variable: str
    field: str | None
    trigger: tuple[str, ...]
    guard: Formula
    value: str | None
    at: Place
    timed_by: tuple[Place, ...] = ()
    meaning: str | None = None
    trail: tuple[Place, ...] | None = None


@dataclass(frozen=True)
class Behavior:
    """All of it."""

    periodic: tuple[Periodic, ...]
    reactive: tuple[Reactive, ...]
    state_variables: tuple[StateVariable, ...]
    configuration: tuple[StateVariable, ...]
    transitions: tuple[Transition, ...]
    deferred: tuple[Deferred, ...]
    one_shot: tuple[OneShot, ...] = ()
    switched: tuple[Switched, ...] = ()
    lifecycle: tuple[tuple[Place, str], ...] = ()  # what is done in a transition of the node's life, and in which
    starting: tuple[tuple[str, Place, str], ...] = ()  # what is sent before callbacks run, where, and whether certainly or perhaps
    contents: Contents = NO_CONTENTS


NOTHING = Behavior((), (), (), (), (), ())


def sent_in_loop(loop: Mapping[str, Any]) -> list[str]:
    """The ports that a timed loop or timer of a document sends through: topics, then what it calls."""
    return [*(loop.get("publishes") or ()), *(loop.get("calls") or ())]


def build_behavior(
    relations: Relations, places: Mapping[str, Place], guards: Guards, ports: PortIds, callbacks: Iterable[tuple[Any, str]]
) -> Behavior:
    """Assemble the behaviour; `ports` gives the ids of port records, `callbacks` pairs ports with their functions."""
    names = variable_names(relations)
    triggers = _triggers(relations, ports, callbacks)
    transitions = _transitions(relations, places, names, guards, ports, triggers)
    given = _given(transitions)
    return Behavior(
        _periodic(relations, places, ports, guards),
        _reactive(relations, places, ports, guards, callbacks),
        _variables("state_variable", relations, places, names, given),
        _variables("configuration_variable", relations, places, names, given),
        transitions,
        _deferred(relations, ports, names),
        _one_shot(relations, places, ports, guards),
        switched_things(relations, places, guards, ports, triggers, _timers(relations, places)),
        tuple(sorted((places[node], name) for node, name in relations.get("in_transition", ()) if node in places)),
        sent_while_starting(relations, places, ports),
        sent_contents(relations, places, guards, ports, triggers, _timers(relations, places)),
    )


def _periodic(relations: Relations, places: Mapping[str, Place], ports: PortIds, guards: Guards) -> tuple[Periodic, ...]:
    rates = _rates(relations)
    for_sink = _rates_of(((site, sink), row) for site, sink, *row in relations["period_for_sink"])
    sent: dict[tuple[str, str], dict[tuple[_Rates, Formula], set[str]]] = defaultdict(lambda: defaultdict(set))
    calls: dict[tuple[str, str, Formula], dict[str, tuple[str, ...]]] = defaultdict(dict)
    roots = sorted(relations["periodic"])
    for site, port, call in sorted(relations["sends_periodically"], key=repr):
        if port in ports:
            for other, root, _mechanism in roots:
                if other == site and (guard := guards.guard(root, call)) != FALSE:
                    sent[site, root][for_sink.get((site, port), rates[site]), guard].add(ports[port])
                    own = calls[site, root, guard]
                    own[call] = (*own.get(call, ()), ports[port])
    found = []
    for site, root, mechanism in roots:
        for (known, guard), published in (sent[site, root] or {(rates[site], TRUE): set()}).items():
            ways = _chains(guards, root, places, calls[site, root, guard])
            for hz, parameter in _best_rates(known):
                told = None if hz is None else round(hz, 6)
                found.append(Periodic(mechanism, told, parameter, tuple(sorted(published, key=_number)), places[site], guard, ways))
    return tuple(sorted(dict.fromkeys(found), key=lambda p: (p.at, p.publishes, formula.text(p.guard) or "")))


def _chains(guards: Guards, root: str, places: Mapping[str, Place], sent: Mapping[str, tuple[str, ...]]) -> tuple[Sending, ...]:
    """The chains of calls by which the activity of `root` comes to calls that send, each through these ports.

    They are needed where their order counts, and where several lead to the only call that sends.
    """
    found = dict.fromkeys(
        Sending(places[call], way.guard, way.trail, sent[call] if guards.is_ordered_by_calls(root) else ())
        for call in sent if len(sent) == 1 or guards.is_ordered_by_calls(root)
        for way in guards.calls_apart(root, call)
    )  # fmt: skip
    return tuple(found) if len(found) > 1 or guards.is_ordered_by_calls(root) else ()


def _rates(relations: Relations) -> Mapping[str, _Rates]:
    return _rates_of((site, row) for site, *row in relations["period"])


def _rates_of(rows: Iterable[tuple[_Key, Sequence[Any]]]) -> defaultdict[_Key, _Rates]:
    rates: defaultdict[_Key, _Rates] = defaultdict(tuple)
    for key, (amount, per_second, parameter) in sorted(rows, key=repr):
        rates[key] += ((frequency(amount, per_second), parameter or None),)
    return rates


def _best_rates(rates: _Rates) -> tuple[tuple[float | None, str | None], ...]:
    """The known frequencies, one of which it is; of those that may be read from a parameter one, with the parameter."""
    best = _best_rate(rates)
    known = tuple(dict.fromkeys(rate for rate in rates if rate[0] is not None))
    return known if best[1] is None and known else (best,)


def _best_rate(rates: _Rates) -> tuple[float | None, str | None]:
    """A known frequency if there is one, with the parameter it may be read from: what a variable begins with gives way to that."""
    parameter = min((name for _, name in rates if name), default=None)
    known = [rate for rate in rates if rate[0] is not None]
    return next((hz for hz, name in known if name == parameter), known[0][0] if known else None), parameter


def _reactive(
    relations: Relations, places: Mapping[str, Place], ports: PortIds, guards: Guards, callbacks: Iterable[tuple[Any, str]]
) -> tuple[Reactive, ...]:
    functions: dict[Any, list[str]] = defaultdict(list)
    for port, function in callbacks:
        functions[port].append(function)
    calls: dict[tuple[Any, Any], list[str]] = defaultdict(list)
    for source, sink, call in relations["reacts"]:
        calls[source, sink].append(call)
    always = set(relations["always_reacts"])
    found = []
    for (source, sink), sites in calls.items():
        if source in ports and sink in ports:
            come = [(function, site) for site in sorted(sites) for function in guards.those_that_run(sorted(functions[source]), site)]
            ways = [
                Sending(places[site], way.guard, way.trail)
                for function, site in come
                for way in guards.ways(function, site, "")
                if way.guard != FALSE
            ]
            guard = formula.either(guards.guard(function, site) for function, site in come)
            if guard == FALSE:
                continue
            at = tuple(sorted(places[site] for site in sites))
            if len(functions[source]) == 1:
                ways = list(_chains(guards, functions[source][0], places, dict.fromkeys(sites, ()))) or ways
            ordered = any(way.trail is not None for way in ways)
            apart = tuple(dict.fromkeys(ways)) if ordered or len({way.guard for way in ways}) > 1 else ()
            found.append(Reactive(ports[source], ports[sink], at, (source, sink) in always, guard, apart))
    return tuple(sorted(found, key=lambda r: (_number(r.input), _number(r.output))))


def _one_shot(relations: Relations, places: Mapping[str, Place], ports: PortIds, guards: Guards) -> tuple[OneShot, ...]:
    rates = _rates(relations)
    functions: dict[str, list[str]] = defaultdict(list)
    for timer, function in sorted(relations["timer_callback"]):
        functions[timer].append(function)
    calls: dict[tuple[str, Any], list[str]] = defaultdict(list)
    for timer, sink, call in relations["sends_once"]:
        calls[timer, sink].append(call)
    always = set(relations["always_sends_once"])
    found = []
    for (timer, sink), sites in calls.items():
        guard = formula.either(guards.guard(function, site) for function in functions[timer] for site in sorted(sites))
        if sink in ports and guard != FALSE:
            hz, parameter = _best_rate(rates[timer])
            at = tuple(sorted(places[site] for site in sites))
            after = None if not hz else round(1 / hz, 6)
            called = dict.fromkeys(sorted(sites), ())
            ways = tuple(way for function in functions[timer] for way in _chains(guards, function, places, called) if way.trail is not None)
            found.append(OneShot(after, parameter, ports[sink], at, (timer, sink) in always, places[timer], guard, ways))
    return tuple(sorted(found, key=lambda o: (o.at, _number(o.output))))


def _deferred(relations: Relations, ports: PortIds, names: Mapping[str, str]) -> tuple[Deferred, ...]:
    found = {
        Deferred(ports[source], ports[sink], names[variable])
        for source, sink, variable in relations["reacts_deferred"]
        if source in ports and sink in ports and variable in names
    }
    return tuple(sorted(found, key=lambda d: (_number(d.input), _number(d.output), d.variable)))


def _number(port: str) -> int:
    return int(port[1:])


def variable_names(relations: Relations) -> dict[str, str]:
    """What models call the variables of a component."""
    return {row[0]: _variable_name(row[1], row[2], row[3]) for row in sorted(relations["variable_display"])}


def _variable_name(scope: str, owner: str, name: str) -> str:
    """`Class::member`, `Class::method::static`, `function::static`, `::global`, without namespaces."""
    parts = owner.split("::")
    return f"{'::'.join(parts[-2:] if scope else parts[-1:])}::{name}"


def _variables(
    relation: str, relations: Relations, places: Mapping[str, Place], names: Mapping[str, str], given: Mapping[str, set[str | None]]
) -> tuple[StateVariable, ...]:
    texts: dict[str, str] = dict(relations["node_text"])
    types = {row[0]: row[4] for row in relations["variable_display"]}
    read = {node: (text, parameter) for node, text, parameter in sorted(relations["node_value"], reverse=True)}
    values: dict[str, list[tuple[int, Place, str]]] = defaultdict(list)
    for variable, order, node in relations["initial_value"]:
        if node in places:
            values[variable].append((order, places[node], node))
    constants = {texts[node] for (node,) in relations["constant_node"] if node in texts}
    found = []
    for (variable,) in relations[relation]:
        if variable in places and variable in names:
            initial, parameter = _initial(sorted(values[variable]), texts, read, names[variable].rpartition("::")[2])
            known = {texts.get(node) for _, _, node in values[variable]} | given.get(names[variable], set())
            domain = _domain(types[variable], known, constants) if parameter is None else None
            found.append(StateVariable(names[variable], types[variable], initial, parameter, domain, places[variable]))
    return tuple(sorted(found, key=lambda v: (v.at, v.name)))


def _given(transitions: Iterable[Transition]) -> dict[str, set[str | None]]:
    """What assignments give each variable, by its name."""
    given: dict[str, set[str | None]] = defaultdict(set)
    for transition in transitions:
        given[transition.variable].add(transition.value)
    return given


def _domain(type_: str, given: Collection[str | None], constants: Collection[str]) -> tuple[str, ...] | None:
    """Both truth values, or the constants that a variable is given when it is given nothing else."""
    if type_.rpartition(" ")[2] == "bool":
        return ("false", "true")
    known = [text for text in given if text is not None and text in constants]
    return tuple(sorted(known)) if known and len(known) == len(given) else None


def _initial(
    values: list[tuple[int, Place, str]], texts: Mapping[str, str], read: Mapping[str, tuple[str, str]], name: str
) -> tuple[str | None, str | None]:
    """The value that is given last, and the parameter that it is read from; of several parts of a variable none is its value.

    None where another one may be given: under a condition, or by what is done later, too.
    """
    initial, parameter = None, None
    for order, _place, node in values:
        if order == 5:
            initial, parameter = None, None
        elif order == 6:
            initial = initial if parameter or _constructed(texts.get(node, initial), name) == initial else None
        elif node in read:
            parameter = read[node][1]
            initial = _number_text(read[node][0]) if read[node][0] != "?" else initial
        elif order > 0 or len(values) == 1:
            initial = _constructed(texts.get(node, initial), name)
    return initial, parameter


def _number_text(text: str) -> str:
    """Numbers that are left to be calculated as the number that they make."""
    value = calculated(text) if text.startswith("(") else None
    return text if value is None else repr(value)


def _constructed(text: str | None, name: str) -> str | None:
    """The argument in `name(argument)`, a declaration's or an initialiser list's way to give a value; of a mere `name` nothing is known."""
    if text == name:
        return None
    match = re.fullmatch(rf"{re.escape(name)}\s*(?:\((.*)\)|(\{{.*\}}))", text or "", re.DOTALL)
    given = (match.group(1) or match.group(2) or None) if match else text
    return _unbraced(given) if given else None


def _unbraced(text: str) -> str | None:
    """What is alone in braces: they say no more than that it is given."""
    if not (text.startswith("{") and text.endswith("}")):
        return text
    inner = text[1:-1].strip()
    return text if "," in inner else inner or None


def _triggers(relations: Relations, ports: PortIds, callbacks: Iterable[tuple[Any, str]]) -> dict[str, tuple[str, ...]]:
    """What starts each activity: port ids for callbacks, else a word."""
    found: dict[str, set[str]] = defaultdict(set)
    same = ("thread", "signal", "main", "parameters", "lifecycle")
    words = {"timer": "periodic", "loop": "periodic", "once": "timer", "end": "main"} | {kind: kind for kind in same}
    for root, kind in relations["activity"]:
        if kind in words:
            found[root].add(words[kind])
    for port, function in callbacks:
        if port in ports:
            found[function].add(ports[port])
    return {root: tuple(sorted(triggers)) for root, triggers in found.items()}


def _transitions(
    relations: Relations, places: Mapping[str, Place], names: Mapping[str, str], guards: Guards, ports: PortIds,
    triggers: Mapping[str, tuple[str, ...]],
) -> tuple[Transition, ...]:  # fmt: skip
    texts: dict[str, str] = dict(relations["node_text"])
    parts = {row[0]: row[1:] for row in sorted(relations["assignment_parts"])}
    timers = _timers(relations, places)
    found: dict[_Change, set[str]] = defaultdict(set)
    timed: dict[_Change, set[Place]] = defaultdict(set)
    elsewhere = defaultdict(set)
    for port, assignment in relations["done_for_others"]:
        elsewhere[assignment].add(ports.get(port, ""))
    for assignment, variable, root in relations["transition"]:
        how, target, value = parts.get(assignment, ("call", "", ""))
        written = _value(how, texts.get(assignment), texts.get(target), texts.get(value)) or ""
        meant = _value(how, texts.get(assignment), texts.get(target), guards.meaning(value)) or ""
        for way in _distinct_ways(guards.ways(root, assignment, meant)):
            shown = written if way.value == meant or constant(way.value) is None else way.value
            change = _Change(assignment, variable, way.guard, shown or None, way.value or None, way.through[:1], way.trail)
            found[change].update(set(triggers.get(root, ())) - elsewhere[assignment])
            timed[change].update(timers.get(root, ()))
    result = []
    for change, causes in found.items():
        target = parts.get(change.assignment, ("", "", ""))[1]
        if change.assignment in places and change.variable in names:
            name, at = names[change.variable], places[change.assignment]
            field = _field(texts.get(target, ""), name)
            meaning = None if change.meaning == change.value else change.meaning
            timed_by = tuple(sorted(timed[change]))
            made = Transition(name, field, tuple(sorted(causes)), change.guard, change.value, at, timed_by, meaning, change.trail)
            result.append(((*change.called, at)[0], made))
    result.sort(key=lambda row: (row[1].at, row[1].variable, row[0], formula.text(row[1].guard) or "", row[1].trigger))
    return tuple(transition for _, transition in result)


@dataclass(frozen=True)
class _Change:
    """An assignment, as an activity comes to it; `called` distinguishes those that it comes to with different values."""

    assignment: str
    variable: str
    guard: Formula
    value: str | None
    meaning: str | None
    called: tuple[Place, ...]
    trail: tuple[Place, ...] | None


def _distinct_ways(ways: list[Way]) -> list[Way]:
    """The ways to an assignment: one for each call, or row of a table, that gives it a value or a place of its own, or all in one."""
    if len({way.value for way in ways}) == 1 and all(way.trail is None and not way.found for way in ways):
        return [Way(formula.either(way.guard for way in ways), next(way.value for way in ways))]
    return ways


def _timers(relations: Relations, places: Mapping[str, Place]) -> dict[str, set[Place]]:
    """The places of what times each activity."""
    found: dict[str, set[Place]] = defaultdict(set)
    for site, root in [row[:2] for row in relations["periodic"]] + list(relations["timer_callback"]):
        if site in places:
            found[root].add(places[site])
    return found


def _field(target: str, name: str) -> str | None:
    """The part of the variable that is assigned: of `cmd->linear.x` it is `linear.x`."""
    match = re.search(rf"\b{re.escape(name.rpartition('::')[2])}\b(?:\.|->)(.+)$", target)
    return match.group(1) if match else None


def _value(how: str, whole: str | None, target: str | None, value: str | None) -> str | None:
    """The new value as C++ text."""
    if how == "=":
        return value
    if how.endswith("=") and target is not None and value is not None:
        operator = how[:-1]
        looser = formula.loosest(value) and not (operator in "+-" and re.fullmatch(r"[^+-]*", value)) and not value.startswith("(")
        return f"{target} {operator} ({value})" if looser else f"{target} {operator} {value}"
    return whole
