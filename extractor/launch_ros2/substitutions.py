"""Substitutions: what they come to in a context. Parts that cannot be known stay as the source writes them."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.commands import output, words_of
from rosarch.extractor.launch.decisions import text_decision
from rosarch.extractor.launch.descriptions import evaluated
from rosarch.extractor.launch.eval_functions import MATH
from rosarch.extractor.launch.evaluation import EvalFailed, Evaluator, UnknownInvolved, Unsupported, is_known_value, no_name
from rosarch.extractor.launch.formulas import Every, Formula, Not, Some, Test, bounded, equals
from rosarch.extractor.launch.model import ArgumentUsed, LaunchError
from rosarch.extractor.launch.state import PART_COST
from rosarch.extractor.launch.values import boolean
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.values import NOTHING, Either, Instance, Made, PathText, Unknown, class_of, in_order
from rosarch.extractor.urdf.command import xacro_call

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

MAX_TEXT = 1 << 20
_Performer = Callable[["World", Made, Context], str]
_PERFORMERS: dict[str, _Performer] = {}


def performs(*kinds: str) -> Callable[[_Performer], _Performer]:
    """Register the function for substitutions of these classes."""

    def register(function: _Performer) -> _Performer:
        for kind in kinds:
            _PERFORMERS[kind] = function
        return function

    return register


def perform(world: World, value: Any, context: Context) -> str:
    """The text that a value comes to where launch takes substitutions: a text, a substitution, or a list of them.

    Raises:
        Raised: it is a number, a truth value or a path, or one of a list is None.
    """
    if isinstance(value, (dict, set, frozenset)):  # of a map, the names
        value = in_order(value) if isinstance(value, (set, frozenset)) else list(value)
    if isinstance(value, (list, tuple)):
        world.state.spend(PART_COST * len(value))
        text = "".join([perform(world, _part(item), context) for item in value])
    elif isinstance(value, (bool, int, float, PathText)):
        raise Raised("TypeError", f"'{class_of(value)}' object is not iterable")
    elif isinstance(value, Made):
        performer = _PERFORMERS.get(value.kind)
        # code of the launch file may have set a configuration to anything
        text = world.as_text(performer(world, value, context)) if performer else world.state.unknowns.mark(f"$({value.kind})", value.place)
    elif isinstance(value, Instance):
        text = _by_method(world, value, context)
    elif isinstance(value, Either):
        text = world.as_text(Either(value.condition, perform(world, value.first, context), perform(world, value.second, context)))
    elif value is None or value is NOTHING:
        text = ""
    else:
        text = world.as_text(value)
    if len(text) > MAX_TEXT:
        raise LaunchError("size", "text", f"a text of more than {MAX_TEXT >> 20} Mi characters after substitution")
    world.state.spend(len(text))
    return text


def _part(item: Any) -> Any:
    if item is None:
        raise Raised("TypeError", "'NoneType' object is not iterable")
    return item


def _shown(value: Any) -> Any:
    """A value where launch takes what Python prints of it, too."""
    if isinstance(value, (list, tuple)):
        return [_shown(item) for item in value]
    return value.text if isinstance(value, PathText) else str(value) if isinstance(value, (bool, int, float)) else value


def _by_method(world: World, value: Instance, context: Context) -> str:
    """What a substitution of the workspace comes to; asked again with the same configurations, it is taken to say the same."""
    key = id(value), frozenset(context.configurations.items())
    if key not in world.performed:
        world.interpreter.asked_at = value.made.place if value.made is not None else world.state.here
        found = world.interpreter.apply(world.interpreter.member_of(value, "perform"), [context], {})
        world.performed[key] = value, world.as_text(found)
    return world.performed[key][1]


def _rendered(world: World, text: str) -> str:
    return world.state.unknowns.render(text)


def _mark(world: World, text: str, *identity: str) -> str:
    return world.state.unknowns.mark(text, *identity)


def _is_open(world: World, *texts: str) -> bool:
    return any(map(world.state.unknowns.is_open, texts))


@performs("TextSubstitution")
def _text(world: World, made: Made, context: Context) -> str:
    return perform(world, made.get("text"), context)


@performs("LaunchConfiguration")
def _configuration(world: World, made: Made, context: Context) -> str:
    name = perform(world, made.get("variable_name"), context)
    world.asked.append(name)
    world.references.append(ArgumentUsed(name, world.state.here))
    if name in context.configurations:
        return context.configurations[name]
    if name == "ros_namespace" and context.namespace:
        return context.namespace
    if "default" in made.arguments and made.arguments["default"] is not None:
        return perform(world, _shown(made.arguments["default"]), context)
    if not _is_open(world, name) and not context.may_have(name):
        world.state.report(LaunchError("configuration", name, f"launch configuration `{name}` is not set"))
    return _mark(world, f"$(var {_rendered(world, name)})", context.file)


@performs("EnvironmentVariable")
def _environment(world: World, made: Made, context: Context) -> str:
    name = perform(world, made.get("name"), context)
    value = context.variable(name)
    if value is not None:
        return value
    if made.arguments.get("default_value") is not None:
        return perform(world, made.arguments["default_value"], context)
    if context.lacks(name) and not _is_open(world, name):
        world.state.report(LaunchError("env", name, f"environment variable `{name}` is not set"))
    return _mark(world, f"$(env {_rendered(world, name)})")


@performs("FindPackageShare", "FindPackagePrefix")
def _package(world: World, made: Made, context: Context) -> str:
    found = world.prefix if made.kind == "FindPackagePrefix" else world.share
    return found(perform(world, made.get("package"), context))


@performs("PathJoinSubstitution")
def _path(world: World, made: Made, context: Context) -> str:
    parts = made.get("substitutions")
    parts = parts if isinstance(parts, (list, tuple)) else [parts]
    texts = [perform(world, part, context) for part in parts]
    return os.path.join(*texts) if texts else ""


@performs("PathSubstitution")
def _plain_path(world: World, made: Made, context: Context) -> str:
    return perform(world, made.get("path"), context)


@performs("StringJoinSubstitution")
def _join(world: World, made: Made, context: Context) -> str:
    delimiter = perform(world, made.get("delimiter"), context)
    return delimiter.join(perform(world, part, context) for part in made.get("substitutions") or ())


@performs("ThisLaunchFileDir")
def _folder(_world: World, _made: Made, context: Context) -> str:
    return os.path.dirname(os.path.abspath(context.file))


@performs("ThisLaunchFile")
def _file(_world: World, _made: Made, context: Context) -> str:
    return os.path.abspath(context.file)


@performs("AnonName")
def _anonymous(world: World, made: Made, context: Context) -> str:
    name = perform(world, made.get("name"), context)
    key = f"anon{name}"
    if key not in context.configurations:
        context.configurations[key] = world.state.unknowns.fresh(_rendered(world, name))
    return context.configurations[key]


@performs("ExecutableInPackage")
def _executable(world: World, made: Made, context: Context) -> str:
    names = [_rendered(world, perform(world, made.get(name), context)) for name in ("executable", "package")]
    return _mark(world, f"$(exec-in-pkg {' '.join(names)})")


@performs("FindExecutable")
def _program(world: World, made: Made, context: Context) -> str:
    """Where a program is, which differs from machine to machine."""
    name = perform(world, made.get("name"), context)
    mark = _mark(world, f"$(find-exec {_rendered(world, name)})", name)
    world.programs[mark] = name
    return mark


@performs("FileContent")
def _content(world: World, made: Made, context: Context) -> str:
    path = perform(world, made.get("path"), context)
    if _is_open(world, path) and path not in world.written:
        return _mark(world, f"$(file-content {_rendered(world, path)})")
    try:
        return world.source_of(path)
    except LaunchError as error:
        world.state.report(error)
        return _mark(world, f"$(file-content {path})")


@performs("Command")
def _command(world: World, made: Made, context: Context) -> str:
    """What a command prints: it is not run. rosarch evaluates xacro files itself, and knows what `cat` and `echo` print."""
    command = world.by_names(perform(world, made.get("command"), context))
    unknown = _mark(world, f"$(command {_rendered(world, command)})", command)
    words = words_of(command)
    try:
        printed = printed_by(world, words, command)
    except LaunchError as error:
        world.state.report_unread(error)
        return unknown
    return unknown if printed is None else printed


def printed_by(world: World, words: list[str], handed: Any) -> str | None:
    """What a program prints, None where only running it could show: one that is not known may write to what it is `handed`.

    Raises:
        LaunchError: it certainly fails.
    """
    made_here = any(world.is_made(word.rpartition(":=")[2]) for word in words)
    call = xacro_call(words)
    if call is None:
        world.hand(handed)
    if made_here or (call is not None and _is_open(world, call.file)):
        return None
    if call is None:
        return output(words, world.state.files, world.environment)
    printed, robot = evaluated(world.state, call, installed=True)
    if printed is not None:
        world.described[printed] = robot
    return printed


@performs("PythonExpression")
def _expression(world: World, made: Made, context: Context) -> str:
    text = perform(world, made.get("expression"), context)
    evaluator = _Expression if "\\" in text else _WithUnknowns  # an escape could pose as an unknown
    try:
        value = evaluator(no_name, {"math": _math}).evaluate(text)
    except EvalFailed as error:
        if _is_open(world, text):  # the unknown may be a part of the expression itself
            return _undecided(world, text)
        raise LaunchError("eval", text, f"the expression `{_rendered(world, text)}` fails: {error}") from None
    except (Unsupported, UnknownInvolved):
        value = NOTHING
    if value is not NOTHING and is_known_value(value) and not isinstance(value, set):
        return str(value)
    return value if isinstance(value, str) else _undecided(world, text)


def _undecided(world: World, text: str) -> str:
    mark, truths = _mark(world, f"$(eval {_rendered(world, text)})", text), world.state.unknowns.truths
    if mark not in truths:
        truths[mark] = text_decision(text, lambda lookup: _WithUnknowns(lookup, {"math": _math}))
    return mark


def _math() -> None:
    """What stands for the module math in expressions."""


class _Expression(Evaluator):
    """Evaluates expressions that may use the module math, whose functions are names there, too."""

    def attribute(self, value: Any, name: str) -> Any:
        return MATH[name] if value is _math and name in MATH else super().attribute(value, name)

    def method(self, value: Any, name: str) -> Callable[..., Any]:
        return MATH[name] if value is _math and name in MATH else super().method(value, name)


class _WithUnknowns(_Expression):
    """Evaluates expressions whose texts may have unknown parts."""

    def _constant(self, node: ast.Constant) -> Any:
        return node.value


def _boolean(world: World, text: str) -> bool | None:
    """A text as a Boolean; None when it is not known."""
    if _is_open(world, text):
        return None
    try:
        return boolean(text)
    except ValueError:
        raise LaunchError("condition", text, f"`{text}` is not true or false") from None


def _truth_text(world: World, found: bool | None, name: str, texts: Sequence[str], means: Callable[[], Formula]) -> str:
    if found is None:
        mark = _mark(world, f"$({name} {' '.join(_rendered(world, text) for text in texts)})", *texts)
        world.state.unknowns.truths.setdefault(mark, bounded(means(), mark))
        return mark
    return "true" if found else "false"


@performs("NotSubstitution")
def _not(world: World, made: Made, context: Context) -> str:
    text = perform(world, made.get("value"), context)
    found = _boolean(world, text)
    return _truth_text(world, None if found is None else not found, "not", [text], lambda: Not(world.truth(text)))


@performs("BooleanSubstitution")
def _bool(world: World, made: Made, context: Context) -> str:
    text = perform(world, made.get("value"), context)
    return _truth_text(world, _boolean(world, text), "bool", [text], lambda: world.truth(text))


@performs("AndSubstitution", "OrSubstitution", "AllSubstitution", "AnySubstitution")
def _both(world: World, made: Made, context: Context) -> str:
    parts = [*made.arguments.values(), *made.rest]
    texts = [perform(world, part, context) for part in parts]
    values = [_boolean(world, text) for text in texts]
    wanted = made.kind in ("OrSubstitution", "AnySubstitution")
    found = wanted if wanted in values else None if None in values else not wanted
    joined = Some if wanted else Every
    return _truth_text(world, found, made.kind.removesuffix("Substitution").lower(), texts, lambda: joined(tuple(map(world.truth, texts))))


@performs("EqualsSubstitution", "NotEqualsSubstitution")
def _equals(world: World, made: Made, context: Context) -> str:
    texts = [perform(world, _shown(made.arguments.get(side)), context) for side in ("left", "right")]
    left, right = texts
    name = "equals" if made.kind == "EqualsSubstitution" else "not-equals"
    found = None if left != right and _is_open(world, left, right) else (left == right or _same_value(left, right)) is (name == "equals")
    return _truth_text(
        world, found, name, texts, lambda: _equal(world, left, right) if name == "equals" else Not(_equal(world, left, right))
    )


def _equal(world: World, left: str, right: str) -> Formula:
    """When two texts, one of them not known, are equal."""
    subject, value = (left, right) if _is_open(world, left) else (right, left)
    if _is_open(world, value):
        return Test(f"{left} == {right}", opaque=True)
    if value.lower() in ("true", "false", "1", "0"):
        return world.truth(subject) if value.lower() in ("true", "1") else Not(world.truth(subject))
    return equals(subject, value)


def _same_value(left: str, right: str) -> bool:
    """Whether Booleans or numbers have the same value, which is what counts for launch."""
    if {left.lower(), right.lower()} <= {"true", "false", "1", "0"} and "" not in (left, right):
        return (left.lower() in ("true", "1")) == (right.lower() in ("true", "1"))
    try:
        return float(left) == float(right)
    except ValueError:
        return False


@performs("IfElseSubstitution")
def _if(world: World, made: Made, context: Context) -> str:
    test = perform(world, made.get("condition"), context)
    found = _boolean(world, test)
    values = [perform(world, made.arguments.get(name), context) for name in ("if_value", "else_value")]
    if found is None and values[0] != values[1]:
        return _mark(world, f"$(if {' '.join(_rendered(world, text) for text in (test, *values))})", test)
    return values[0] if found or found is None else values[1]


@performs("ForEachVar", "ForLoopIndex")
def _loop(world: World, made: Made, context: Context) -> str:
    name = perform(world, made.get("name"), context)
    if name in context.loop:
        return world.as_text(context.loop[name])
    default = made.arguments.get("default_value")
    return perform(world, default, context) if default is not None else _mark(world, f"$(for-var {_rendered(world, name)})")


@performs("Parameter")
def _parameter(world: World, made: Made, context: Context) -> str:
    """The first value that was given to all nodes under a name, as Python writes it."""
    name, default = perform(world, made.get("name"), context), made.get("default")
    unknown = _mark(world, f"$(param {_rendered(world, name)})", name)
    if _is_open(world, name):
        return unknown
    for given in context.params:
        if given.name == name:
            sure = set(given.conditions) <= set(context.conditions)
            return world.as_text(tuple(given.value) if isinstance(given.value, list) else given.value) if sure else unknown
    if default is None:
        raise LaunchError("parameter", name, f"the parameter `{name}` is given to no node before")
    return perform(world, default, context) if isinstance(default, (str, list, tuple, Made, Unknown, Either)) else world.as_text(default)


@performs("ParameterFile")
def _parameter_file(world: World, made: Made, context: Context) -> str:
    return perform(world, made.get("param_file"), context)


@performs("ParameterValue")
def _parameter_value(world: World, made: Made, context: Context) -> str:
    return perform(world, made.get("value"), context)
