"""Calls, attributes and modules of Python launch files."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.evaluation import PYTHON_ERRORS
from rosarch.extractor.launch.formulas import Test
from rosarch.extractor.launch.model import Condition, LaunchError, Place
from rosarch.extractor.launch_ros2.argument_types import OF_NODES, RENAMED, WITH_OLD_NAMES, refused
from rosarch.extractor.launch_ros2.decisions import is_certain
from rosarch.extractor.launch_ros2.expressions import Expressions, Raised, Undecided
from rosarch.extractor.launch_ros2.natives import attribute
from rosarch.extractor.launch_ros2.natives_files import environment, environment_has, environment_item, set_environment
from rosarch.extractor.launch_ros2.natives_objects import members_of
from rosarch.extractor.launch_ros2.registry import CONSTANTS, KNOWN_MODULES, NATIVES
from rosarch.extractor.launch_ros2.values import (
    CLASSES,
    KEYWORDS,
    MORE,
    NOTHING,
    Bound,
    Class,
    Constructor,
    Default,
    Either,
    Frame,
    Function,
    Instance,
    Made,
    Module,
    ModuleFrame,
    Native,
    PathText,
    Several,
    Super,
    TextFile,
    Unknown,
)
from rosarch.extractor.python_syntax import FUNCTIONS, nodes_within

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

MAX_DEPTH = 60
_LAUNCH = ("launch", "launch_ros", "launch_xml", "launch_yaml", "launch_testing", "launch_testing_ros")
_OBJECTS = (Made, Instance, Class, PathText, TextFile, Module)
_DECORATORS = frozenset({"staticmethod", "classmethod", "property", "cached_property"})

_BUILTINS = frozenset(dir(builtins)) | {
    *(
        "__builtins__",
        "__file__",
        "__name__",
        "__doc__",
        "__package__",
        "__spec__",
        "__loader__",
        "__path__",
        "__cached__",
        "__annotations__",
    ),
    *("__class__", "__debug__", "__dict__", "__module__", "__qualname__", "copyright", "credits", "exit", "license", "quit", "_"),
    *("aiter", "anext", "BaseExceptionGroup", "ExceptionGroup", "EncodingWarning", "PythonFinalizationError", "WindowsError"),
}
"""Names that are there in some version of Python 3, or somewhere in a module, without being bound by it."""

GENERAL = frozenset({"Exception", "BaseException"})


@dataclass
class Attempt:
    """A `try`: the exceptions that it handles by name, and the conditions without which one of `kinds` is raised."""

    handled: frozenset[str]
    missed: list[Condition] = field(default_factory=list)
    kinds: frozenset[str] = frozenset()


class Calls(Expressions):
    """What is called, and what is asked of objects."""

    def __init__(self, world: World) -> None:
        super().__init__()
        self.world = world
        self.modules: dict[str, ModuleFrame] = {}
        self.depth = 0
        self.attempts: list[Attempt] = []
        self.unset = False
        """Whether a variable of the environment was asked for that is not set here, where nobody launches the file."""

        self.of_unset: set[str] = set()
        """Parts of texts that are what such variables may have."""

    def text_of_none(self, node: ast.expr, frame: Frame) -> str:
        """`None` as a part of a text; where such a variable is asked for it may be what that has."""
        if not self.unset:
            return "None"
        mark = self.text(self.unknown(node, frame))
        self.of_unset.add(mark)
        return mark

    def text(self, value: Any) -> str:
        return self.world.as_text(value)

    def misunderstood(self, place: Place, message: str) -> None:
        """Report what was not understood, once."""
        self.world.state.warn("python", message, message, place)

    def raised(self, error: Raised, place: Place) -> None:
        """Report an exception that ends a launch file, or an action of it."""
        if error.certain:
            self.world.state.report(LaunchError("python", error.kind, f"{error.kind}: {error.message}"), place=error.place or place)
        else:
            self.misunderstood(error.place or place, f"not understood from here on: {error.kind}: {error.message}")

    def installs(self, package: str) -> bool:
        return self.world.state.files.packages.find(package) is not None

    def has_variable(self, name: str) -> bool:
        return environment_has(self, name)

    def optional(self, kinds: set[str], what: str) -> bool:
        """Whether the launch file goes on when an exception of these kinds says that `what` is not there; on goes the case that it is."""
        attempt = next((one for one in reversed(self.attempts) if one.handled & (kinds | GENERAL)), None)
        if attempt is None:
            return False
        condition = Condition(what, True, self.world.state.here, Test(what))
        attempt.missed.append(condition)
        attempt.kinds = attempt.kinds or frozenset(kinds | GENERAL)
        self.path.append(condition)
        return True

    def builtin(self, node: ast.Name, frame: Frame) -> Any:
        bound = frame.module.bound
        if bound is not None and node.id not in bound and node.id not in _BUILTINS and node.id not in NATIVES:
            raise Raised("NameError", f"name '{node.id}' is not defined", self.place(node, frame))
        return NATIVES.get(node.id) or super().builtin(node, frame)

    # -- attributes -----------------------------------------------------------------------------------------------------------

    def _attribute(self, node: ast.Attribute, frame: Frame) -> Any:
        return self.member(self.value(node.value, frame), node.attr, node, frame)

    def member(self, owner: Any, name: str, node: ast.AST, frame: Frame) -> Any:
        """`owner.name`."""
        if isinstance(owner, Module):
            return self._of_module(owner, name, node, frame)
        if isinstance(owner, Class):
            return self._of_class(owner, name, node, frame)
        if isinstance(owner, Instance):
            return self._of_instance(owner, name, node, frame)
        if isinstance(owner, Super):
            return self._of_super(owner, name, node, frame)
        found = attribute(self, owner, name)
        if found is NOTHING:
            return Unknown(_text_of(node), self.place(node, frame))
        return found

    def _of_module(self, module: Module, name: str, node: ast.AST, frame: Frame) -> Any:
        full = f"{module.name}.{name}"
        if module.frame is not None and name in module.frame.variables:
            return module.frame.variables[name]
        if module.name.partition(".")[0] in _LAUNCH and name in CLASSES:
            return Constructor(name)
        if full == "sys.argv":
            return list(self.world.argv)
        if full in NATIVES or full in CONSTANTS:
            return NATIVES.get(full, CONSTANTS.get(full))
        if full in self.modules:
            return Module(full, self.modules[full])
        if module.frame is not None or full in KNOWN_MODULES or module.name.partition(".")[0] in _LAUNCH:
            inner = self.module(full, frame)
            return inner if isinstance(inner, Module) else Unknown(full, self.place(node, frame))
        return Unknown(full, self.place(node, frame))

    def _of_class(self, owner: Class, name: str, node: ast.AST, frame: Frame) -> Any:
        try:
            found = owner.find(name)
        except KeyError:
            return Unknown(_text_of(node), self.place(node, frame))
        return Bound(found, owner) if isinstance(found, Function) and found.kind == "classmethod" else found

    def _of_instance(self, owner: Instance, name: str, node: ast.AST, frame: Frame) -> Any:
        if name in owner.attributes:
            return owner.attributes[name]
        if owner.made is not None and name.startswith(f"_{owner.made.kind}__"):  # a private attribute of the base class
            return owner.made.arguments.get(name.partition("__")[2], Unknown(_text_of(node), self.place(node, frame)))
        try:
            found = owner.of.find(name)
        except KeyError:
            found = attribute(self, owner.made, name) if owner.made else NOTHING
            return Unknown(_text_of(node), self.place(node, frame)) if found is NOTHING else found
        if isinstance(found, Function):
            kind = found.kind
            if kind in ("property", "cached_property"):
                return self.call_function(found, [owner], {})
            return found if kind == "staticmethod" else Bound(found, owner.of if kind == "classmethod" else owner)
        return found

    def member_of(self, owner: Instance, name: str) -> Any:
        """A method of an object, bound to it; unknown when its class has none of this name."""
        try:
            found = owner.of.find(name)
        except KeyError:
            return Unknown(f"{owner.of.name}.{name}", owner.made.place if owner.made else Place("", 1))
        return Bound(found, owner) if isinstance(found, Function) else found

    def _of_super(self, owner: Super, name: str, node: ast.AST, frame: Frame) -> Any:
        above = Class("", owner.of.bases, {})
        try:
            found = above.find(name)
        except KeyError:
            if name == "__init__":
                return Native(
                    "__init__", lambda _run, *arguments, **named: self._initialise(owner, arguments, named, self.place(node, frame))
                )
            if name in ("execute", "visit") and owner.instance.made is not None:
                # what starts is what the class of launch would start by itself
                return Native(name, lambda _run, *_arguments, **_named: owner.instance.made)
            return Unknown(_text_of(node), self.place(node, frame))
        return Bound(found, owner.instance) if isinstance(found, Function) else found

    def _initialise(self, owner: Super, arguments: tuple[Any, ...], named: dict[str, Any], place: Place) -> None:
        for constructor in owner.of.constructors()[:1]:
            owner.instance.made = self.make(constructor.kind, list(arguments), named, place)

    # -- modules --------------------------------------------------------------------------------------------------------------

    def module(self, name: str, frame: Frame, place: Place | None = None) -> Any:
        """A module by its full name: one that is known here, one of the workspace, or unknown; `place` imports it.

        What a helper imports comes with it.
        """
        first = name.partition(".")[0]
        if first in _LAUNCH or name in KNOWN_MODULES:
            return Module(name)
        if place is not None and not frame.module.is_helper:
            self.asked_at = place
            self.world.import_from(first, place)
        if name in self.modules:
            return Module(name, self.modules[name])
        source = self.world.module_source(name, frame.module.file)
        if source is None:
            return Unknown(name, Place(frame.module.file, 1))
        try:
            return Module(name, self.run_module(name, *source))
        except (SyntaxError, Raised) as error:
            self.misunderstood(Place(source[0], getattr(error, "lineno", None) or 1), f"module {name} not read to its end: {error}")
            return Module(name, self.modules.get(name))

    def module_of_file(self, path: str) -> Any:
        """The module that a file is, run by itself."""
        try:
            return Module(path, self.run_module(path, path, self.world.state.files.read_text(self.world.located(path))))
        except LaunchError as error:
            self.world.state.report_unread(error)
            return NOTHING

    def run_module(self, name: str, file: str, text: str, *, is_launch_file: bool = False) -> ModuleFrame:
        """The names of a module after it has run."""
        raise NotImplementedError

    # -- calls ----------------------------------------------------------------------------------------------------------------

    def _call(self, node: ast.Call, frame: Frame) -> Any:
        if isinstance(node.func, ast.Name) and node.func.id == "super" and not node.args:
            return self._super(frame)
        function = self.value(node.func, frame)
        arguments = list(self._items(node.args, frame))
        named: dict[str, Any] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value, frame)
            if keyword.arg is not None:
                named[keyword.arg] = value
            elif isinstance(value, dict):
                named.update((MORE if isinstance(key, Unknown) else str(key), item) for key, item in value.items())
            else:
                named[MORE] = value
        return self.call(function, arguments, named, node, frame)

    def _super(self, frame: Frame) -> Any:
        here: Frame | None = frame
        while here is not None:
            if "__class__" in here.variables:
                return Super(here.variables["__class__"], next(iter(here.variables.values())))
            here = here.above
        return Unknown("super()", Place(frame.module.file, 1))

    def call(self, function: Any, arguments: list[Any], named: dict[str, Any], node: ast.expr, frame: Frame) -> Any:
        """The value of a call."""
        if not frame.module.is_helper:
            self.asked_at = self.place(node, frame)
        if isinstance(function, (Function, Bound)):
            return self.apply(function, arguments, named)
        if isinstance(function, Constructor):
            made = self.make(function.kind, arguments, named, self.place(node, frame))
            if function.kind == "LaunchDescription":
                frame.module.described.append(made)
            return made
        if isinstance(function, Class):
            return self.instance(function, arguments, named, self.place(node, frame))
        if isinstance(function, Native):
            if frame.module.is_launch_file or frame.module.is_helper:
                self.world.here(self.place(node, frame))
            named.pop(MORE, None)
            found = function.call(self, *arguments, **named)
            if found is NOTHING:
                return self.unknown(node, frame)
            return found if isinstance(found, dict) else self.weighed(found)
        if callable(function) and not isinstance(function, (Unknown, Either)):
            if not all(map(self._plain, (*arguments, *named.values()))):
                return self.unknown(node, frame)
            wrapped = {name: self._callable(value) for name, value in named.items()}
            try:
                return self.weighed(function(*map(self._callable, arguments), **wrapped))
            except PYTHON_ERRORS as error:
                raise Raised(type(error).__name__, str(error), self.place(node, frame)) from None
        self.world.hand(*arguments, *named.values())
        return self.unknown(node, frame)

    def _plain(self, value: Any) -> bool:
        """Whether a value may be handed to a function of Python's own."""
        return isinstance(value, (Function, Bound)) or (is_certain(value) and not isinstance(value, _OBJECTS))

    def _callable(self, value: Any) -> Any:
        return (lambda *arguments: self.apply(value, list(arguments), {})) if isinstance(value, (Function, Bound)) else value

    def apply(self, function: Any, arguments: list[Any], named: dict[str, Any]) -> Any:
        """The value of a call, of whatever a launch file can call."""
        if isinstance(function, Bound):
            return self.call_function(function.function, [function.owner, *arguments], named)
        if isinstance(function, Native):
            return function.call(self, *arguments, **named)
        if isinstance(function, Function):
            return self.call_function(function, arguments, named)
        if isinstance(function, Constructor):
            return self.make(function.kind, arguments, named, self.asked_at or Place("", 1))
        if isinstance(function, Class):
            return self.instance(function, arguments, named, self.asked_at or Place("", 1))
        return Unknown("a call", Place("", 1))

    def call_function(self, function: Function, arguments: list[Any], named: dict[str, Any]) -> Any:
        """The value of a call of a function of a launch file."""
        if self.depth >= MAX_DEPTH:
            return Unknown("calls nested too deeply", Place(function.frame.module.file, function.node.lineno))
        frame = Frame(dict(_bound(function, arguments, named)), function.frame.module, function.frame)
        if function.owner is not None:
            frame.variables["__class__"] = function.owner
        self.depth += 1
        try:
            if _is_generator(function.node):
                frame.yielded = []
            if isinstance(function.node, ast.Lambda):
                return self.value(function.node.body, frame)
            return self.body_of(function.node.body, frame)
        except Undecided:
            if self.path:
                raise
            return Unknown("too much that is not known", Place(function.frame.module.file, function.node.lineno))
        finally:
            self.depth -= 1

    def body_of(self, body: list[ast.stmt], frame: Frame) -> Any:
        """What a function with this body returns."""
        raise NotImplementedError

    def make(self, kind: str, arguments: list[Any], named: dict[str, Any], place: Place) -> Made:
        """An object of a class of launch."""
        names = CLASSES[kind]
        if len(arguments) > len(names) and kind in KEYWORDS and not any(isinstance(one, Several) for one in arguments):
            most = f"{len(names) + 1} positional argument{'s' if names else ''}"
            raise Raised("TypeError", f"{kind}.__init__() takes {most} but {len(arguments) + 1} were given", place)
        for name in named.keys() - {MORE} - KEYWORDS.get(kind, named.keys()):
            now = RENAMED.get(name) if kind in OF_NODES else None
            if now is None:
                self.world.state.report(LaunchError("keyword", name, f"{kind} has no argument `{name}`"), place=place)
            elif self.world.environment.get("ROS_DISTRO") not in WITH_OLD_NAMES:
                message = f"{kind} has no argument `{name}`: since Galactic it is `{now}`"
                self.world.state.report(LaunchError("keyword", name, message, (name, now)), place=place)
        given = {**dict(zip(names, arguments, strict=False)), **named}
        for name, reason in refused(kind, given):
            self.world.state.report(LaunchError("type", name, f"{kind}: {reason}"), place=place)
        return Made(kind, given, place, tuple(arguments[len(names) :]))

    def _fill(self, made: Instance, arguments: list[Any], named: dict[str, Any]) -> None:
        """The fields of an object whose class says only which ones it has."""
        fields = made.of.all_fields()
        if (arguments or named) and not fields and made.made is None and _is_plain(made.of):
            raise Raised("TypeError", f"{made.of.name}() takes no arguments")
        made.attributes.update(zip(fields, arguments, strict=False))
        made.attributes.update(named)
        for name in fields:
            with suppress(KeyError):
                default = made.of.find(name)
                if isinstance(default, Default) and name not in made.attributes:
                    made.attributes[name] = self.apply(default.function, [], {})
        with suppress(KeyError):
            self.apply(Bound(made.of.find("__post_init__"), made), [], {})

    def instance(self, of: Class, arguments: list[Any], named: dict[str, Any], place: Place) -> Any:
        """An object of a class of a launch file; of an enumeration, the member with the value."""
        if (members := members_of(of)) is not None:
            wanted = arguments[0] if arguments and is_certain(arguments[0]) else NOTHING
            found = next((one for one in members if one.attributes["value"] == wanted), None)
            return found or Unknown(f"{of.name}(...)", place)
        made = Instance(of)
        for constructor in of.constructors()[:1]:
            made.made = Made(constructor.kind, {}, place)
        try:
            start = of.find("__init__")
        except KeyError:
            self._fill(made, arguments, named)
            if made.made is not None:
                made.made = self.make(made.made.kind, arguments, named, place)
            return made
        if isinstance(start, Function):
            self.call_function(start, [made, *arguments], named)
        return made

    def decorated(self, function: Function, decorators: list[ast.expr], frame: Frame) -> Any:
        """A function with its decorators: those of methods, and functions of the workspace; others are taken for such as change nothing."""
        found: Any = function
        for decorator in reversed(decorators):
            if isinstance(decorator, ast.Name) and decorator.id in _DECORATORS:
                found = replace(found, kind=decorator.id) if isinstance(found, Function) else found
            elif isinstance(wrap := self.value(decorator, frame), (Function, Bound)):
                found = self.apply(wrap, [found], {})
        return found

    def own(self, made: Class) -> None:
        """Record in the methods of a class which class they are of."""
        for name, member in made.members.items():
            if isinstance(member, Function) and member.owner is None:
                made.members[name] = replace(member, owner=made)

    # -- items ----------------------------------------------------------------------------------------------------------------

    def iterated(self, value: Any, node: ast.expr, frame: Frame) -> list[Any]:
        return super().iterated(self.gone_through(value), node, frame)

    def spread(self, value: Any) -> list[Any]:
        return super().spread(self.gone_through(value))

    def gone_through(self, value: Any) -> Any:
        """The list of what Python finds where it goes through an object of a launch file, or through an enumeration."""
        if isinstance(value, Class) and (members := members_of(value)) is not None:
            return members
        if isinstance(value, Instance) and isinstance(method := self.member_of(value, "__iter__"), Bound):
            return self.apply(method, [], {})
        return value

    def item(self, value: Any, node: ast.Subscript, frame: Frame) -> Any:
        if isinstance(value, Native) and value.name == "os.environ":
            self.world.here(self.place(node, frame))
            return environment_item(self, self.value(node.slice, frame))
        if isinstance(value, Class) and members_of(value) is not None and isinstance(name := self.value(node.slice, frame), str):
            return self.member(value, name, node, frame)
        return self.unknown(node, frame)

    def entries(self, value: Any, owner: dict[Any, Any]) -> Iterator[tuple[Any, Any]]:
        is_environment = isinstance(value, Native) and value.name == "os.environ"
        return super().entries(environment(self) if is_environment else value, owner)

    def guarded(self, value: Any, otherwise: Any = NOTHING) -> Any:
        """A value that is added to something under the unknown conditions of the present branch."""
        for condition in reversed(self.path):
            value = Either(condition, value, otherwise)
        return value

    def set_item(self, owner: Any, key: Any, value: Any) -> None:
        """`owner[key] = value`."""
        if isinstance(owner, dict) and is_certain(key):
            owner[key] = self.guarded(value, owner.get(key, NOTHING))
        elif isinstance(owner, dict):
            if not self.is_widened(owner):  # who goes through the entries comes to one more
                more = key if isinstance(key, Unknown) else Unknown("?", Place("", 1))
                owner[more] = Unknown("?", more.place)
        elif isinstance(owner, list) and isinstance(key, int) and -len(owner) <= key < len(owner):
            owner[key] = self.guarded(value, owner[key])
        elif isinstance(owner, Native) and owner.name == "os.environ":
            set_environment(self, key, value)

    def close(self, file: TextFile) -> None:
        """What was written into a file can be read."""
        if file.written:
            self.world.written[file.name] = self.world.content_of(file.name) if file.text is None else file.text


def _is_plain(of: Class) -> bool:
    """Whether all that a class has is known, and it is made as Python does by itself."""
    if "__new__" in of.members:
        return False
    return all(_is_plain(base) if isinstance(base, Class) else getattr(base, "text", "") == "object" for base in of.bases)


def _bound(function: Function, arguments: list[Any], named: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """The names of parameters with what they stand for in a call."""
    spec = function.node.args
    places = [*spec.posonlyargs, *spec.args]
    defaults = dict(zip((arg.arg for arg in places[len(places) - len(function.defaults) :]), function.defaults, strict=True))
    rest = dict(named)
    for index, arg in enumerate(places):
        if index < len(arguments):
            yield arg.arg, arguments[index]
        elif arg.arg in rest:
            yield arg.arg, rest.pop(arg.arg)
        elif arg.arg in defaults:
            yield arg.arg, defaults[arg.arg]
        elif MORE in rest:
            yield arg.arg, Unknown(arg.arg, Place(function.frame.module.file, function.node.lineno))
        else:
            raise Raised("TypeError", f"missing argument `{arg.arg}`")
    for arg in spec.kwonlyargs:
        if arg.arg in rest or arg.arg in function.named_defaults:
            yield arg.arg, rest.pop(arg.arg, function.named_defaults.get(arg.arg))
    if spec.vararg is not None:
        yield spec.vararg.arg, tuple(arguments[len(places) :])
    if spec.kwarg is not None:
        yield spec.kwarg.arg, rest


@lru_cache(maxsize=4096)
def _is_generator(node: ast.AST) -> bool:
    """Whether a function yields; what functions within it yield is theirs."""
    inside = nodes_within(ast.iter_child_nodes(node), lambda inner: isinstance(inner, (*FUNCTIONS, ast.ClassDef)))
    return any(isinstance(inner, (ast.Yield, ast.YieldFrom)) for inner in inside)


def _text_of(node: ast.AST) -> str:
    return ast.unparse(node) if isinstance(node, ast.expr) else getattr(node, "module", None) or "import"
