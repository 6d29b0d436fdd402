"""The live code of a component: functions that its start mentions, through any number of others.

A function counts as mentioned where it is called or its address is taken, and with all methods of its class where an object of that class
may be: where a type shows it. That is rapid type analysis (Bacon and Sweeney, OOPSLA 1996), but for all methods instead of those that
are called: it is for the rules to say what really runs. What no function of the component mentions, as most of a large library, is no
fact of the component.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from rosarch.extractor.workspace.model import LIBRARY
from rosarch.extractor.workspace.plugins import REGISTERS_TREE_NODES

Row = tuple[str | int, ...]
Rows = Mapping[str, Iterable[Row]]

_OWNED = ("expr_function", "block", "variable_function")
"""What says to which function an expression, block or variable belongs."""
_ABOUT = {"return_value": 1, "field_initializer": 2}
"""The column of the expression that a row is about, where it is not the first."""


DECLARED = (
    "function_name", "function_defined", "function_overrides", "function_class", "class_base", "class_base_instance", "variable_type",
    "field_class", "type_class", "type_inner", "type_argument", "type_alias", "program_entry", "class", "location",
)  # fmt: skip
"""What `Declarations` asks for."""


class Mentions(NamedTuple):
    """What a piece of code mentions: `names` are those of functions that are called or used without being known."""

    functions: tuple[str, ...]
    names: tuple[str, ...]
    classes: tuple[str, ...]
    types: tuple[str, ...]


def by_function(rows: Rows) -> dict[str, dict[str, list[Row]]]:
    """Rows apart by the function whose body they are about, in order; with "" declarations, and code outside functions."""
    owner = {row[0]: str(row[1]) for relation in _OWNED for row in rows.get(relation, ())}
    parts: dict[str, dict[str, list[Row]]] = {"": {}}
    for relation, found in rows.items():
        column = _ABOUT.get(relation, 0)
        grouped: dict[str, list[Row]] = defaultdict(list)
        for row in sorted(found):
            grouped[owner.get(row[column], "")].append(row)
        for function, part in grouped.items():
            parts.setdefault(function, {})[relation] = part
    return parts


def mentions_of(code: Rows) -> Mentions:
    """What the rows of one function, or those outside of all, mention."""

    def column(relation: str, index: int) -> Iterator[str]:
        return (str(row[index]) for row in code.get(relation, ()))

    parts = {*column("variable_function", 0)}
    known = {*column("call_function", 0), *column("call_constructs", 0)}
    no_objects = {row[0] for row in code.get("variable", ()) if row[1] in ("field", "parameter")} - parts
    return Mentions(
        tuple({*column("call_function", 1), *column("function_use", 1), *column("lambda", 1)}),
        tuple({str(name) for call, name in code.get("call", ()) if call not in known} | {*column("template_member_use", 2)}),
        tuple({*column("call_constructs", 1), *column("class_use", 1), *column("this_use", 1), *column("instance_member_use", 1)}),
        tuple(
            {*column("expr_type", 1), *column("call_template_argument", 2), *column("template_member_use", 1)}
            | {*column("instance_member_use", 3)}
            | {str(kind) for variable, kind in code.get("variable_type", ()) if variable not in no_objects}
        ),
    )


class Declarations:
    """The declarations of all sources, by what is asked for to find live code."""

    def __init__(self, declared: Rows) -> None:
        self.names = _multimap(_pairs(declared, "function_name"))
        self.named = _multimap((_last(name), function) for function, names in self.names.items() for name in names)
        self.defined = set(_column(declared, "function_defined"))
        self.overriding = _multimap((overridden, function) for function, overridden in _pairs(declared, "function_overrides"))
        self.methods = _multimap((owner, function) for function, owner in _pairs(declared, "function_class"))
        self.bases = _multimap(_pairs(declared, "class_base"))
        self.base_types = _multimap(_pairs(declared, "class_base_instance"))
        kinds = _multimap(_pairs(declared, "variable_type"))  # several where sources disagree
        self.field_types = _multimap((owner, kind) for field, owner in _pairs(declared, "field_class") for kind in kinds.get(field, ()))
        self.classes_of = _multimap(_pairs(declared, "type_class"))
        self.inner = _multimap([*_pairs(declared, "type_inner", 2), *_pairs(declared, "type_argument", 2)])
        self.aliased = _multimap(_pairs(declared, "type_alias"))
        self.entries = tuple(_column(declared, "program_entry"))
        self.classes = {*_column(declared, "class"), *self.aliased}
        self.placed = self.classes.intersection(_column(declared, "location"))

    def entry_classes(self, own: Rows) -> list[Row]:
        """The classes that a component starts with. One that its registration names without a namespace is looked for in all of them."""
        found: list[Row] = []
        for name in _column(own, "component_class"):
            inside = [] if name in self.classes else sorted(other for other in self.placed if other.endswith(f"::{name}"))
            found += [(each,) for each in inside or [name]]
        return found

    def live_functions(self, own: Rows, mentions: Mapping[str, Iterable[Mentions]]) -> set[str]:
        """The functions whose code may run in a component with its `own` rows, by what each mentions; "" is code outside of them."""
        program = _Program(self)
        program.enter(own)
        for mentioned in mentions.get("", ()):
            program.mention(mentioned)
        while program.waiting:
            function = program.waiting.pop()
            program.stand_in(function)
            for mentioned in mentions.get(function, ()):
                program.mention(mentioned)
        return program.live


class _Program:
    """The functions found so far."""

    def __init__(self, declared: Declarations) -> None:
        self.declared = declared
        self.live: set[str] = set()
        self.waiting: list[str] = []
        self.seen_names: set[str] = set()
        self.seen_classes: set[str] = set()
        self.seen_types: set[str] = set()

    def enter(self, own: Rows) -> None:
        """Where the component starts; objects of its class are made by a library, and whatever a library has may be called."""
        self.reach(self.declared.entries)
        self.mention_name("main")
        if any(row[2] == LIBRARY for row in own.get("component", ())):
            self.reach(self.declared.defined)
        for (name,) in self.declared.entry_classes(own):
            for function in REGISTERS_TREE_NODES:
                self.mention_name(function)
            self.mention_classes([str(name).partition("<")[0]])
            self.mention_types([*self.declared.aliased.get(str(name), ()), *([str(name)] if "<" in str(name) else [])])

    def mention(self, mentioned: Mentions) -> None:
        self.reach(mentioned.functions)
        for name in mentioned.names:
            self.mention_name(name)
        self.mention_classes(mentioned.classes)
        self.mention_types(mentioned.types)

    def reach(self, functions: Iterable[str]) -> None:
        for function in functions:
            if function not in self.live:
                self.live.add(function)
                self.waiting.append(function)

    def stand_in(self, function: str) -> None:
        """What may run in the place of a function: what overrides it, and where only its declaration is known all of its name."""
        self.reach(self.declared.overriding.get(function, ()))
        if function not in self.declared.defined:
            for name in self.declared.names.get(function, ()):
                self.mention_name(name)

    def mention_name(self, name: str) -> None:
        """All functions of a name, whatever class or namespace they are in."""
        name = _last(name)
        if name not in self.seen_names:
            self.seen_names.add(name)
            self.reach(self.declared.named.get(name, ()))

    def mention_classes(self, classes: Iterable[str]) -> None:
        """Classes with what they consist of."""
        waiting = list(classes)
        while waiting:
            found = waiting.pop()
            if found in self.seen_classes:
                continue
            self.seen_classes.add(found)
            self.reach(self.declared.methods.get(found, ()))
            waiting += self.declared.bases.get(found, ())
            for kind in (*self.declared.base_types.get(found, ()), *self.declared.field_types.get(found, ())):
                waiting += self._classes_within(kind)

    def mention_types(self, types: Iterable[str]) -> None:
        for kind in types:
            self.mention_classes(self._classes_within(kind))

    def _classes_within(self, kind: str) -> Iterator[str]:
        """The classes that a type is made of, those of types seen before left out."""
        waiting = [kind]
        while waiting:
            found = waiting.pop()
            if found not in self.seen_types:
                self.seen_types.add(found)
                yield from self.declared.classes_of.get(found, ())
                waiting += self.declared.inner.get(found, ())


def _last(name: str) -> str:
    return name.rpartition("::")[2].rpartition(".")[2]


def _column(rows: Rows, relation: str) -> Iterator[str]:
    return (str(row[0]) for row in rows.get(relation, ()))


def _pairs(rows: Rows, relation: str, second: int = 1) -> Iterator[tuple[str, str]]:
    return ((str(row[0]), str(row[second])) for row in rows.get(relation, ()))


def _multimap(pairs: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    result: dict[str, list[str]] = defaultdict(list)
    for key, value in pairs:
        result[key].append(value)
    return dict(result)
