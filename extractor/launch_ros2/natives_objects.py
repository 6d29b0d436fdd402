"""What Python's library has for functions, iterators and classes: `functools.partial`, `next`, named tuples, data classes, enumerations."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch_ros2.decisions import holds_several, is_certain
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.registry import native
from rosarch.extractor.launch_ros2.values import NOTHING, Class, Default, Function, Instance, Native

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.calls import Calls


@native("functools.partial")
def _partial(_run: Calls, function: Any, *arguments: Any, **named: Any) -> Any:
    return Native("partial", lambda run, *more, **others: run.apply(function, [*arguments, *more], {**named, **others}))


@native("functools.wraps")
def _wraps(_run: Calls, _function: Any, **_named: Any) -> Any:
    return Native("wraps", lambda _run, function: function)


@native("iter")
def _iter(_run: Calls, items: Any) -> Any:
    return list(items) if isinstance(items, (list, tuple, set, dict, range)) else NOTHING


@native("next")
def _next(_run: Calls, items: Any, *default: Any) -> Any:
    """What generators and iterators give is a list of their own, which loses its first item."""
    if not isinstance(items, list) or holds_several(items):
        return NOTHING
    if not items and not default:
        raise Raised("StopIteration", "")
    return items.pop(0) if items else default[0]


_MAX_ITEMS = 10_000


def _combined(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function of itertools, for known lists; more items than would be read are not known."""

    def call(run: Calls, *given: Any, **named: Any) -> Any:
        arguments = [*map(run.gone_through, given)]
        plain = (list, tuple, set, dict, range, str, int)
        if not all(
            isinstance(one, plain) and not holds_several(one) and (type(one) is not str or is_certain(one)) for one in arguments
        ) or not all(map(is_certain, named.values())):
            return NOTHING
        found = list(itertools.islice(function(*arguments, **named), _MAX_ITEMS + 1))
        return NOTHING if len(found) > _MAX_ITEMS else found

    return call


for _function in (itertools.product, itertools.chain, itertools.combinations, itertools.permutations, itertools.zip_longest):
    native(f"itertools.{_function.__name__}")(_combined(_function))


@native("collections.namedtuple")
def _namedtuple(_run: Calls, name: Any, fields: Any, **named: Any) -> Any:
    names = fields.replace(",", " ").split() if isinstance(fields, str) else fields
    if not isinstance(names, (list, tuple)) or not all(isinstance(one, str) for one in names):
        return NOTHING
    defaults = named.get("defaults") or ()
    if not isinstance(defaults, (list, tuple)):
        return NOTHING
    return Class(str(name), (), dict(zip(names[len(names) - len(defaults) :], defaults, strict=False)), tuple(names))


@native("dataclasses.field")
def _field(_run: Calls, **named: Any) -> Any:
    return Default(named["default_factory"]) if "default_factory" in named else named.get("default", NOTHING)


@native("enum.Enum", "enum.IntEnum", "enum.StrEnum")
def _enum(_run: Calls, *_arguments: Any, **_named: Any) -> Any:
    return NOTHING


def is_enumeration(bases: tuple[Any, ...]) -> bool:
    """Whether a class with these bases is an enumeration, of which each member is an object."""
    return any(isinstance(base, Native) and base.name.startswith("enum.") for base in bases)


def enumerate_members(made: Class) -> None:
    """Make the members of an enumeration objects of it."""
    number = 0
    for name, value in made.members.items():
        if not name.startswith("_") and not isinstance(value, Function):
            if isinstance(value, Native) and value.name == "enum.auto":
                number += 1
                value = number
            made.members[name] = Instance(made, {"name": name, "value": value})


def members_of(made: Class) -> list[Instance] | None:
    """The members of an enumeration in their order; None where the class is none."""
    if not is_enumeration(made.bases):
        return None
    return [one for one in made.members.values() if isinstance(one, Instance) and one.of is made]
