"""The values of launch files in addition to Python's own: actions and substitutions, unknowns, alternatives, functions and classes."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Set
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.extractor.launch.formulas import Formula
from rosarch.extractor.launch.model import Condition, Place


@dataclass(eq=False)
class Made:
    """An object of a class of launch or launch_ros (`kind`), with the arguments it was made with and where.

    `command` is the command line of a node from when code asks for it, which may change it then.
    """

    kind: str
    arguments: dict[str, Any]
    place: Place
    rest: tuple[Any, ...] = ()
    command: list[Any] | None = None

    def get(self, *names: str) -> Any:
        """The first of these arguments that was given."""
        return next((self.arguments[name] for name in names if self.arguments.get(name) is not None), None)


ROS_ARGUMENTS = Made("RosArguments", {}, Place("", 0))
"""What launch_ros puts behind the arguments of a node's command line."""


class Written(tuple[Any, ...]):
    """A tuple that a launch file writes at `place`."""

    place: Place


def in_order(found: Set[Any]) -> list[Any]:
    """The items of a set, whose order changes from run to run, as they are written."""
    return sorted(found, key=lambda one: (one.place.line, one.place.column) if isinstance(one, Written) else (0, 0))


@dataclass(frozen=True, eq=False)
class Unknown:
    """A value that cannot be determined; `text` is how the source writes it, `reason` why. `truth` is when a Boolean is true."""

    text: str
    place: Place
    reason: str = ""
    truth: Formula | None = None


class Several(Unknown):
    """Any number of values of a list that cannot be determined."""


MORE = "**"
"""The name of what is passed by keywords that are not known."""


class Nothing:
    """What is there when an alternative is not: no value at all."""


NOTHING = Nothing()


@dataclass(frozen=True, eq=False)
class Either:
    """`first` when the condition holds, else `second`: which cannot be determined."""

    condition: Condition
    first: Any
    second: Any

    def alternatives(self) -> tuple[tuple[Condition, Any], tuple[Condition, Any]]:
        """Both values, each with the condition that it is there under."""
        return (self.condition, self.first), (self.condition.contrary(), self.second)


def cases(value: Any) -> Iterator[tuple[tuple[Condition, ...], Any]]:
    """The values that a value may be, each with the conditions under which it is that one."""
    if isinstance(value, Either):
        for condition, one in value.alternatives():
            yield from (((condition, *more), case) for more, case in cases(one))
    else:
        yield (), value


@dataclass(eq=False)
class Frame:
    """The names of a module, function or class. `above` is the frame that a function was defined in."""

    variables: dict[str, Any]
    module: ModuleFrame
    above: Frame | None = None
    returns: list[tuple[Condition, Any]] = field(default_factory=list)
    shared: set[str] = field(default_factory=set)
    yielded: list[Any] | None = None


@dataclass(eq=False)
class ModuleFrame:
    """A module that was run: its file, its name and its names. `described` are the launch descriptions made in it.

    `bound` are the names that its text binds anywhere; None when these are not known to be all.
    """

    name: str
    file: str
    is_launch_file: bool = False
    variables: dict[str, Any] = field(default_factory=dict)
    described: list[Made] = field(default_factory=list)
    bound: frozenset[str] | None = None

    @property
    def is_helper(self) -> bool:
        """Whether its source is one that rosarch has, which is called like the module."""
        return self.file == self.name and "/" not in self.file


@dataclass(frozen=True, eq=False)
class Function:
    """A function of a launch file, or a lambda, with the values of its defaults."""

    node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
    frame: Frame
    defaults: tuple[Any, ...]
    named_defaults: dict[str, Any]
    owner: Class | None = None
    kind: str = ""
    """The decorator that says what it is in a class: `property`, `staticmethod`, ..."""


@dataclass(eq=False)
class Class:
    """A class of a launch file; `bases` are classes, constructors of launch, or unknown."""

    name: str
    bases: tuple[Any, ...]
    members: dict[str, Any]
    fields: tuple[str, ...] = ()

    def find(self, name: str) -> Any:
        """A member of the class or of those above it; KeyError when there is none."""
        if name in self.members:
            return self.members[name]
        for base in self.bases:
            if isinstance(base, Class):
                try:
                    return base.find(name)
                except KeyError:
                    continue
        raise KeyError(name)

    def all_fields(self) -> tuple[str, ...]:
        """Its fields, those of the classes above it first."""
        above = (name for base in self.bases if isinstance(base, Class) for name in base.all_fields())
        return tuple(dict.fromkeys((*above, *self.fields)))

    def is_derived(self, other: Class) -> bool:
        """Whether this is another class of a launch file, or derived from it."""
        return self is other or any(isinstance(base, Class) and base.is_derived(other) for base in self.bases)

    def constructors(self) -> list[Constructor]:
        """The classes of launch that this one is derived from."""
        found = [base for base in self.bases if isinstance(base, Constructor)]
        return found or [one for base in self.bases if isinstance(base, Class) for one in base.constructors()]


@dataclass(frozen=True, eq=False)
class Default:
    """What a function makes for each object of a class that is not given the field."""

    function: Any


@dataclass(eq=False)
class Instance:
    """An object of a class of a launch file; `made` is what it is for launch, once its base was initialised."""

    of: Class
    attributes: dict[str, Any] = field(default_factory=dict)
    made: Made | None = None


@dataclass(frozen=True, eq=False)
class Constructor:
    """A class of launch or launch_ros."""

    kind: str


@dataclass(frozen=True, eq=False)
class Native:
    """A function that is known here. It gets the interpreter, and the arguments."""

    name: str
    call: Callable[..., Any]


@dataclass(frozen=True, eq=False)
class Bound:
    """A function together with the object it is called on."""

    function: Function
    owner: Any


@dataclass(frozen=True, eq=False)
class Super:
    """`super()` in a method of `of`."""

    of: Class
    instance: Instance


@dataclass(frozen=True, eq=False)
class Module:
    """A module by its name: one that is known here, or (`frame`) one of the workspace."""

    name: str
    frame: ModuleFrame | None = None


@dataclass(frozen=True)
class PathText:
    """A `pathlib.Path`."""

    text: str

    def joined(self, *parts: str) -> PathText:
        """A path below this one."""
        return PathText(str(Path(self.text, *parts)))


@dataclass(frozen=True)
class Installed:
    """The packages that are installed where launch runs, as a map of names or a list of them."""


def installed(package: str) -> str:
    """What conditions say of a package that is there."""
    return f"the package {package} is installed"


@dataclass(eq=False)
class TextFile:
    """An open file: its text as far as it was read or written, None when that is not known."""

    name: str
    text: str | None
    written: bool = False


CLASSES: dict[str, tuple[str, ...]] = {}
"""The classes of launch with the names of their parameters."""
KEYWORDS: dict[str, frozenset[str]] = {}
"""The classes of launch of which all names of parameters are known, with these."""
MODULES: dict[str, list[str]] = {}
"""The modules of launch with the names of their classes."""
BASES: dict[str, str] = {}
"""The classes of launch with the class that each is derived from."""
_BASE_IN = {
    "actions": "Action",
    "conditions": "Condition",
    "event_handlers": "EventHandler",
    "events": "Event",
    "substitutions": "Substitution",
}
"""What the classes of a module are derived from, unless the list says another one."""


def is_derived(kind: str | None, base: str) -> bool:
    """Whether a class of launch is another one, or derived from it."""
    while kind is not None and kind != base:
        kind = BASES.get(kind)
    return kind is not None


_CLASSES_IN_PYTHON = ((PathText, "PosixPath"), (Written, "tuple"), ((Class, Constructor), "type"), (Function, "function"))


def class_of(value: Any) -> str:
    """What Python calls the class of a value."""
    named = next((name for kind, name in _CLASSES_IN_PYTHON if isinstance(value, kind)), None)
    if named is not None:
        return named
    return value.kind if isinstance(value, Made) else value.of.name if isinstance(value, Instance) else type(value).__name__


def _read_api() -> None:
    shared: dict[str, list[str]] = {}
    for line in (Path(__file__).parent / "api.txt").read_text(encoding="utf-8").splitlines():
        words, bar, keywords = line.partition(" |")
        first, *rest = words.split()
        if first.startswith("@"):
            shared[first] = rest
        elif first != "#":
            name, *parameters = rest
            name, _, base = name.rstrip(")").partition("(")
            base = base or _BASE_IN.get(first.rpartition(".")[2], "")
            if base not in ("", name):
                BASES.setdefault(name, base)  # of an action and an event of one name, the action
            CLASSES[name] = tuple(parameters)
            MODULES.setdefault(first, []).append(name)
            if bar:
                named = (one for word in keywords.split() for one in shared.get(word, [word]))
                KEYWORDS[name] = KEYWORDS.get(name, frozenset()).union(parameters, named)


_read_api()
