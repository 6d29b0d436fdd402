"""The component model: what one node or nodelet sends, receives and reads, from the relations that the rules derive."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from rosarch.base.logic import TRUE, atoms
from rosarch.base.places import Place
from rosarch.datalog.language.values import symbols
from rosarch.models import formula
from rosarch.models.behavior import NOTHING, Behavior, Sending, StateVariable, build_behavior, variable_names
from rosarch.models.contents import contents_json
from rosarch.models.formula import Formula
from rosarch.models.guards import Guards, meant_json, trail_json
from rosarch.models.machine.conditions import constant
from rosarch.models.node_configuration import InnerNode, PluginArgument
from rosarch.models.normal import normal_text
from rosarch.models.numbers import calculated
from rosarch.models.openness import Unseen
from rosarch.models.rhythm import NO_RHYTHMS, Rhythms, rhythms_of, with_few_changes
from rosarch.models.switches import switched_json
from rosarch.models.traits import Trait, traits

Row = tuple[Any, ...]
Relations = Mapping[str, Iterable[Row]]


@dataclass(frozen=True)
class Port:
    """A place where a component meets others; the fields are those of `FORMAT.md`.

    `unknown` says why a name is not known, `in_namespace` where it has the namespace of the node: `first` (though it looks
    absolute) or `inside`. `qos` are the policies of its quality of service that are known, each with its setting. `inside` is the call
    of the library in the function that `at` calls, when that only passes on what it is given.
    """

    id: str
    kind: str
    name: str
    from_param: str | None
    type: str | None
    queue: int | None
    latched: bool
    callback: str | None
    via: str
    at: Place
    implicit: bool = False
    unknown: str | None = None
    guard: Formula = TRUE
    in_namespace: str | None = None
    qos: tuple[tuple[str, str], ...] = ()
    inside: Place | None = None


@dataclass(frozen=True)
class Parameter:
    """An access to a ROS parameter."""

    name: str
    op: str
    type: str | None
    default: str | None
    at: Place


CONFIGURED = "@"
"""Appears in the title of a model before the key of a configuration."""


def component_of(title: str) -> str:
    """The component that the title of a model is of, whatever its configuration."""
    return title.partition(CONFIGURED)[0]


@dataclass(frozen=True)
class Plugin:
    """How programs load a component that is a class: by `name`, where they want an object of class `base`."""

    name: str
    base: str | None


@dataclass(frozen=True)
class ComponentModel:
    """One component.

    `reconfigurable` are the parameters that servers of dynamic_reconfigure keep, `loads` the names of the plug-ins that it loads,
    `unseen` says what it may have beside all that, `left_out` what its sources have and nothing makes,
    `loads_any` the base classes of those whose names are not known, `executables` what launch files start it as, where that need not be its
    name, and `traits` what only matters in a system. `executable` is set for a node that is one of several of a program: it is the program.
    `configuration` is the key of the configuration that it was analysed with, empty for the component by itself; `inner` are the nodes that
    it makes inside of its own, `plugin_arguments` what it gives the plug-ins that it loads; `asks_name` where its code asks what the node
    is called, `asks_namespace` where it asks for its namespace, `asks_command_line` for words of its command line. `tree_files` are the
    behavior trees that it carries out, `tree_hosts` the names of the nodes that it makes for the nodes of these trees, where these do not
    use the component's own. `asks_plugins` are functions of bases of plug-ins that it calls for what they return, `results` what those of
    a plug-in return.
    """

    system: str
    component: str
    package: str
    kind: str
    node_name: str | None
    sources: tuple[str, ...]
    ports: tuple[Port, ...]
    params: tuple[Parameter, ...]
    behavior: Behavior = NOTHING
    plugin: Plugin | None = None
    reconfigurable: tuple[Parameter, ...] = ()
    loads: tuple[str, ...] = ()
    loads_any: tuple[str, ...] = ()
    traits: tuple[Trait, ...] = ()
    executables: tuple[str, ...] = ()
    executable: str | None = None
    middleware: str | None = None
    unseen: tuple[Unseen, ...] = ()
    left_out: tuple[Unseen, ...] = ()
    configuration: str = ""
    inner: tuple[InnerNode, ...] = ()
    plugin_arguments: tuple[PluginArgument, ...] = ()
    asks_name: bool = False
    asks_namespace: bool = False
    asks_command_line: bool = False
    tree_files: tuple[str, ...] = ()
    tree_hosts: tuple[str, ...] = ()
    asks_plugins: tuple[tuple[str, str], ...] = ()
    results: tuple[tuple[str, str], ...] = ()

    @property
    def title(self) -> str:
        """Unique among models: package, component and, where it is that of certain nodes, the key of their configuration."""
        return f"{self.package}/{self.component}{CONFIGURED * bool(self.configuration)}{self.configuration}"

    @property
    def types(self) -> tuple[str, ...]:
        """What launch files know the component as: the name of a class that is loaded, names of programs."""
        return (*([self.plugin.name] if self.plugin else []), *self.executables) or (self.component,)

    @cached_property
    def rhythms(self) -> Rhythms:
        """In which rhythms it sends. It takes a while to find, and is kept with the model: who makes many models asks for it at once.

        Of a managed node none is known: what it sends while it is not active is dropped.
        """
        if self.kind == MANAGED or not self.behavior.state_variables:
            return NO_RHYTHMS
        return rhythms_of(document_json(replace(self, behavior=with_few_changes(self.behavior))))


def build_models(
    system: str, component: str, package: str, kind: str, sources: tuple[str, ...], relations: Relations
) -> tuple[ComponentModel, ...]:
    """The model of a component, and of a program that makes several nodes also one of each node, with what belongs to it or to none."""
    own: dict[str, set[str]] = defaultdict(set)
    for name, element in relations["node_element"]:
        own[name].add(element)
    known = set().union(*own.values())
    whole = build_model(system, component, package, kind, sources, relations)
    nodes = []
    for name in sorted(own):
        foreign, others = known - own[name], {port for node, port in relations["port_of_other_node"] if node == name}
        rows = {
            relation: [row for row in found if foreign.isdisjoint(symbols(row)) and others.isdisjoint(row)]
            for relation, found in relations.items()
        }
        nodes.append(replace(build_model(system, name, package, kind, sources, rows), node_name=name, executable=component, executables=()))
    return (whole, *nodes)


def distinct(models: Iterable[ComponentModel]) -> tuple[ComponentModel, ...]:
    """Models by package and name; nodes of programs are called `program.node` where their package has their name twice."""
    found = list(models)
    called = Counter(model.title for model in found)
    for index, model in enumerate(found):
        if model.executable and called[model.title] > 1:
            found[index] = replace(model, component=f"{model.executable}.{model.component}")
    return tuple(sorted(found, key=lambda model: (model.package, model.component, model.configuration)))


def build_model(system: str, component: str, package: str, kind: str, sources: tuple[str, ...], relations: Relations) -> ComponentModel:
    """Assemble the model from the rows of the rules' output relations."""
    places = {row[0]: Place(*row[1:]) for row in relations["node_location"]}
    names = sorted(name for (name,) in relations["node_name"])
    guards = Guards(relations, places)
    ports, ids = _ports(relations, places, guards)
    behavior = build_behavior(relations, places, guards, ids, tuple(relations["port_callback"]))
    plugins = [Plugin(name, base or None) for name, base in sorted(relations["component_plugin"])]
    return ComponentModel(
        system,
        component,
        package,
        MANAGED if kind in _MAY_BE_MANAGED and any(relations["managed_node"]) else kind,
        names[0] if names else None,
        sources,
        ports,
        _parameters(relations, places),
        behavior,
        plugins[0] if plugins else None,
        _reconfigurable(relations, places),
        tuple(sorted({name for _, name in relations["plugin_load"]})),
        tuple(sorted({base for _, base in relations["plugin_load_any"]})),
        (*traits(relations, ids, places, variable_names(relations)), *_asking_messages(behavior, relations, ids)),
        tuple(sorted(name for (name,) in relations["component_executable"])),
        middleware=" and ".join(sorted(name for (name,) in relations["component_middleware"])) or None,
        unseen=tuple(sorted(Unseen(what, kind, subject, Place(*at)) for what, kind, subject, *at in relations["unseen"])),
        left_out=tuple(sorted(Unseen("ports", "uncalled", function, Place(*at)) for function, *at in relations["port_unreached"])),
        inner=_inner_nodes(relations),
        asks_name=any(relations["own_name_call"]),
        asks_namespace=any(relations["own_namespace_call"]),
        asks_command_line=any(relations["asks_command_line"]),
        tree_files=tuple(sorted(file for (file,) in relations["tree_file"])),
        tree_hosts=tuple(sorted(name for (name,) in relations["tree_host"])),
        asks_plugins=tuple(sorted({(base, function) for _, base, function in relations["plugin_asked"]})),
        results=tuple(sorted(relations["plugin_result"])),
        plugin_arguments=tuple(
            PluginArgument(base, name, (f, index, text)) for base, name, f, index, text in sorted(relations["plugin_argument"])
        ),
    )


_ROOT = re.compile(r"(?<![\w.>:'\"])[A-Za-z_]\w*")
_WORDS = ("not", "and", "or", "is", "in", "None")


def _asking_messages(behavior: Behavior, relations: Relations, ids: Mapping[Any, str]) -> tuple[Trait, ...]:
    """The reactions about which nothing decides but what the message holds."""
    names: dict[str, set[str]] = defaultdict(set)
    for port, name in relations.get("names_message", ()):
        names[ids.get(port, "")].add(name)
    found = []
    for each in behavior.reactive:
        texts = [_QUOTED.sub("", item.meaning or item.text) for item in atoms(each.guard)]
        roots = {word for text in texts for word in _ROOT.findall(text)}
        asked = roots & names[each.input]
        words = {word for word in roots - asked if word not in _WORDS and constant(word) is None}
        if not each.must and asked and not words - _namespaces(texts):
            found.append(Trait("asks_message", (each.input, each.output)))
    return tuple(found)


_QUOTED = re.compile(r"\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])*'")


def _namespaces(texts: Iterable[str]) -> set[str]:
    """The words before `::`, which name no variable."""
    return {word for text in texts for word in re.findall(r"(?<![\w.>:])(\w+)::", text)}


def _inner_nodes(relations: Relations) -> tuple[InnerNode, ...]:
    namespaces = tuple(sorted((text, how == "relative") for text, how in relations["inner_namespace"]))
    given: dict[str, list[tuple[str, int, str]]] = defaultdict(list)
    for class_, function, index, text in sorted(relations["inner_given"]):
        given[class_].append((function, index, text))
    made = sorted({(class_, name) for _, class_, name in relations["inner_node"]})
    return tuple(InnerNode(class_, name, namespaces, tuple(given[class_])) for class_, name in made)


UNUSED = "unused"  # a source that nothing builds, imports or starts
MANAGED, _MAY_BE_MANAGED = "lifecycle_node", ("node", "component")


def _first(rows: Iterable[Row]) -> dict[Any, Any]:
    """The least value of each key: a choice that does not depend on the order of rows."""
    return {row[0]: row[1] for row in sorted(rows, key=lambda row: (repr(row[0]), str(row[1])), reverse=True)}


def _only(rows: Iterable[Row]) -> dict[Any, Any]:
    """The value of each key that has one: of several, none is known to be it."""
    found: dict[Any, set[Any]] = defaultdict(set)
    for key, value in rows:
        found[key].add(value)
    return {key: values.pop() for key, values in found.items() if len(values) == 1}


def _ports(relations: Relations, places: Mapping[str, Place], guards: Guards) -> tuple[tuple[Port, ...], dict[Row, str]]:
    """The ports, and the ids of those by their record that are not implicit or that something is known to react to."""
    types, parameters = _only(relations["port_type"]), _first(relations["port_parameter"])
    queues, unknown, via = _only(relations["port_queue"]), _first(relations["port_unknown"]), _first(relations["port_via"])
    latched = {port for (port,) in relations["port_latched"]}
    relative, qualities = _first(relations["port_in_namespace"]), _qualities(relations)
    functions = {row[0]: _short_name(row[1], row[2]) for row in relations["function_display"]}
    functions |= {function: f"lambda in {functions[outer]}" for function, outer in relations["lambda_within"]}
    callbacks = _first((port, functions[function]) for port, function in relations["port_handler"])
    inner = _first((port, functions[function]) for port, function in relations["implicit_port_callback"])
    calls = defaultdict(list)
    for port, call in sorted(relations["port_made_through"], key=repr):
        calls[port].append(call)
    passed = _only(relations["port_made_for"])
    found: list[tuple[Row | None, Port]] = []
    for (port,) in relations["port"]:
        site, kind, name = port
        if site not in places:
            continue
        asked = places.get(passed[port]) if port in passed else None
        found.append(
            (
                port,
                Port(
                    "",
                    kind,
                    name,
                    parameters.get(port),
                    types.get(port),
                    int(queues[port]) if port in queues else None,
                    port in latched,
                    callbacks.get(port),
                    via.get(port, "plain"),
                    asked or places[site],
                    False,
                    unknown.get(port),
                    guards.created(site, calls[port]),
                    relative.get(port),
                    qualities.get(port, ()),
                    places[site] if asked else None,
                ),
            )
        )
    heard = {port for port, _ in relations["port_callback"]}
    for port, type_ in relations["implicit_port"]:
        site, kind, name = port
        if site in places:
            record = port if port in heard else None
            found.append((record, Port("", kind, name, None, type_, None, False, inner.get(port), "plain", places[site], True)))
    found.sort(key=lambda item: (item[1].implicit, item[1].at, item[1].kind, item[1].name, item[1].type or ""))
    ports = tuple(replace(port, id=f"p{number}") for number, (_, port) in enumerate(found, 1))
    return ports, {record: port.id for (record, _), port in zip(found, ports, strict=True) if record is not None}


def _qualities(relations: Relations) -> dict[Any, tuple[tuple[str, str], ...]]:
    """The settings of each port's policies; of a policy that may have several none is given."""
    settings: dict[tuple[Any, str], list[str]] = defaultdict(list)
    for port, policy, setting in relations["port_quality"]:
        settings[port, policy].append(setting)
    found: dict[Any, list[tuple[str, str]]] = defaultdict(list)
    for (port, policy), values in settings.items():
        if len(values) == 1:
            found[port].append((policy, _setting(values[0])))
    return {port: tuple(sorted(policies)) for port, policies in found.items()}


def _setting(text: str) -> str:
    """A setting as it is shown: what was calculated, a time, as its number."""
    number = calculated(text) if text.startswith("(") else None
    return text if number is None else format(number, "g")


def _short_name(owner: str, name: str) -> str:
    """`Class::method`, or a free function's name, both without namespaces."""
    parts = name.split("::")
    return "::".join(parts[-2:]) if owner else parts[-1]


_PARAMETER_TYPES = {
    "std::string": "string", "std::basic_string<char>": "string", "float": "double", "boolean": "bool", "integer": "int", "char": "string",
    "XmlRpc::XmlRpcValue": "XmlRpcValue",
    "signed char": "int", "unsigned char": "int", "short": "int", "unsigned short": "int", "unsigned int": "int",
    "long": "int", "unsigned long": "int", "long long": "int", "unsigned long long": "int",
}  # fmt: skip


def _parameter_type(type_: str) -> str:
    """A C++ type as parameters have it: ROS names for single values, C++ names for what holds several."""
    return _PARAMETER_TYPES.get(type_, type_.replace("std::basic_string<char>", "std::string"))


def _parameters(relations: Relations, places: Mapping[str, Place]) -> tuple[Parameter, ...]:
    types, defaults = (
        _first(((call, name), value) for call, name, value in relations[relation])
        for relation in ("parameter_access_type", "parameter_access_default")
    )
    found: dict[tuple[str, str, Place], Parameter] = {}
    for call, op, name in relations["parameter_access"]:
        type_ = types.get((call, name))
        at = places.get(call)
        if at is None:
            continue
        found[name, op, at] = Parameter(name, op, _parameter_type(type_) if type_ else None, defaults.get((call, name)), at)
    return tuple(sorted(found.values(), key=lambda parameter: (parameter.at.path, parameter.at.line, parameter.at.column, parameter.name)))


def _reconfigurable(relations: Relations, places: Mapping[str, Place]) -> tuple[Parameter, ...]:
    rows = sorted((name, kind, default, site) for (site, *_), name, kind, default in relations["reconfigure_parameter"] if site in places)
    return tuple(Parameter(name, "read", kind, None if default == "?" else default, places[site]) for name, kind, default, site in rows)


def to_json(model: ComponentModel) -> dict[str, Any]:
    """The document of `FORMAT.md`; its keys are always all there."""
    return {
        "system": model.system,
        "component": model.component,
        "package": model.package,
        "kind": model.kind,
        "middleware": model.middleware,
        "node_name": model.node_name,
        **({"executable": model.executable} if model.executable else {}),
        "sources": list(model.sources),
        "ports": list(map(port_json, model.ports)),
        "params": list(map(parameter_json, model.params)),
        **_behavior_json(model.behavior, {port.id for port in model.ports if port.kind in _ASKED}),
        "open": _open_json((*model.unseen, *model.left_out)),
        **({"plugin": vars(model.plugin)} if model.plugin else {}),
        **({"executables": list(model.executables)} if model.executables else {}),
        **({"loads": list(model.loads)} if model.loads else {}),
        **({"loads_any": list(model.loads_any)} if model.loads_any else {}),
        **({"behavior_trees": list(model.tree_files)} if model.tree_files else {}),
    }


def _open_json(unseen: Iterable[Unseen]) -> list[dict[str, Any]]:
    """What is open, with all that one reason at one place opens together."""
    opened: dict[tuple[Place, str], list[str]] = defaultdict(list)
    for each in unseen:
        opened[each.at, each.reason].append(each.what)
    return [{"what": sorted(what), "reason": reason, "at": str(at)} for (at, reason), what in sorted(opened.items())]


def traits_json(model: ComponentModel) -> dict[str, list[list[str]]]:
    """What rules say of the component for the sake of systems, by relation; `to_json` leaves it out."""
    found: dict[str, list[list[str]]] = {}
    for trait in model.traits:
        found.setdefault(trait.name, []).append([str(value) for value in trait.values])
    return found


def document_json(model: ComponentModel) -> dict[str, Any]:
    """The component as `to_json` shows it, and what rules say of it for the sake of systems: what is worked out from models needs both."""
    return {**to_json(model), "traits": traits_json(model)}


def switches_json(model: ComponentModel) -> dict[str, Any]:
    """What goes on at times only, what is done in transitions of a managed node, what is sent at the start, what messages hold."""
    life = [[str(place), name] for place, name in model.behavior.lifecycle]
    return {"switched": [switched_json(each) for each in model.behavior.switched], "in_transition": life,
            "starting": [[port, str(place), how] for port, place, how in model.behavior.starting],
            "contents": contents_json(model.behavior.contents)}  # fmt: skip


_ASKED = ("service_client", "action_client")  # kinds of ports that are called, and answered


def _behavior_json(behavior: Behavior, asked: Collection[str]) -> dict[str, Any]:
    return {
        "periodic": [
            {"mechanism": p.mechanism, "hz": p.hz, "hz_from_param": p.hz_from_param,
             "publishes": [port for port in p.publishes if port not in asked],
             **({"calls": calls} if (calls := [port for port in p.publishes if port in asked]) else {}),
             "at": str(p.at), **_guard_json("conditional", p.guard),
             **({"ways": [{**_guard_json("conditional", way.guard), **_way_json(way)} for way in p.ways]} if p.ways else {})}
            for p in behavior.periodic
        ],
        "reactive": [
            {"input": r.input, "output": r.output, "at": [str(place) for place in r.at], "must": r.must, **_guard_json("when", r.guard),
             **({"ways": [{"at": str(way.at), **_guard_json("when", way.guard), **_way_json(way)} for way in r.ways]} if r.ways else {})}
            for r in behavior.reactive
        ],
        "state_variables": [_variable_json(variable) for variable in behavior.state_variables],
        "configuration": [_variable_json(variable) for variable in behavior.configuration],
        "transitions": [
            {"variable": t.variable, **({} if t.field is None else {"field": t.field}), "trigger": list(t.trigger),
             **({"timed_by": [str(place) for place in t.timed_by]} if t.timed_by else {}),
             **_guard_json("guard", t.guard), "value": t.value, **({"value_normal": t.meaning} if t.meaning else {}), "at": str(t.at),
             **trail_json(t.trail)}
            for t in behavior.transitions
        ],
        "reactive_deferred": [vars(deferred) for deferred in behavior.deferred],
        "one_shot": [
            {"after": o.after, "after_from_param": o.after_from_param, "output": o.output, "sent_at": [str(place) for place in o.sent_at],
             "must": o.must, "at": str(o.at), **_guard_json("when", o.guard),
             **({"ways": [{**_guard_json("when", way.guard), **_way_json(way)} for way in o.ways]} if o.ways else {})}
            for o in behavior.one_shot
        ],
    }  # fmt: skip


def _way_json(way: Sending) -> dict[str, Any]:
    return {**({"publishes": list(way.publishes)} if way.publishes else {}), **trail_json(way.trail)}


def _guard_json(key: str, guard: Formula) -> dict[str, Any]:
    return {key: formula.text(guard), f"{key}_normal": normal_text(guard), f"{key}_tree": formula.tree(guard), **meant_json(guard)}


def _variable_json(variable: StateVariable) -> dict[str, Any]:
    domain = None if variable.domain is None else list(variable.domain)
    data = {"name": variable.name, "type": variable.type, "initial": variable.initial, "domain": domain, "at": str(variable.at)}
    return data if variable.from_param is None else {**data, "from_param": variable.from_param}


def parameter_json(parameter: Parameter) -> dict[str, Any]:
    """A parameter as `to_json` shows it."""
    default = default_value(parameter)
    return {"name": parameter.name, "op": parameter.op, "type": parameter.type, "default": default, "at": str(parameter.at)}


def port_json(port: Port) -> dict[str, Any]:
    """A port as `to_json` shows it."""
    data: dict[str, Any] = {
        "id": port.id, "kind": port.kind, "name": port.name, "from_param": port.from_param, "type": port.type, "queue": port.queue,
        "latched": port.latched, "callback": port.callback, "via": port.via, "at": str(port.at),
        "conditional": formula.text(port.guard),
    }  # fmt: skip
    if port.qos:
        data["qos"] = dict(port.qos)
    if port.implicit:
        data["implicit"] = True
    if port.unknown:
        data["unknown"] = port.unknown
    if port.in_namespace:
        data["in_namespace"] = port.in_namespace
    if port.inside:
        data["inside"] = str(port.inside)
    return data


_NUMBER = re.compile(r"-?(0|[1-9][0-9]*)(\.[0-9]+)?(e[-+]?[0-9]+)?", re.ASCII)


Value = str | float | int | bool | None


def default_value(parameter: Parameter) -> Value | list[Value]:
    """A parameter's default as the value that it is, `[a, b]` as the list that it is."""
    text = parameter.default
    if text is not None and parameter.type != "string" and text.startswith("[") and text.endswith("]"):
        return [_literal(part, None) for part in text[1:-1].split(", ") if part]
    return _literal(text, parameter.type)


def _literal(text: str | None, type_: str | None) -> Value:
    """A text as the value that it is; a string stays the text it is."""
    if text is None or type_ == "string":
        return text
    if text in ("true", "false"):
        return text == "true"
    if text.startswith("(") and (value := calculated(text)) is not None:
        return value
    number = _NUMBER.fullmatch(text)
    if number is None:
        return text
    return float(text) if number.group(2) or number.group(3) else int(text)
