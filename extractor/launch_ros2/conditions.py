"""Conditions of actions (launch.conditions): whether they hold, or that this cannot be known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.formulas import Formula, Test, equals, truth
from rosarch.extractor.launch.model import Condition, LaunchError
from rosarch.extractor.launch.values import boolean
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import Either, Instance, Made, Unknown

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

_CONDITIONS = frozenset({"Condition", "IfCondition", "UnlessCondition", "LaunchConfigurationEquals", "LaunchConfigurationNotEquals"})


def holds(world: World, condition: Any, context: Context) -> bool | Condition:
    """Whether a condition holds; a `Condition` for one that cannot be known."""
    if condition is None:
        return True
    if isinstance(condition, Instance):
        return _asked(world, world.interpreter.member_of(condition, "evaluate"), context)
    if isinstance(condition, Either):
        first, second = (holds(world, one, context) for one in (condition.first, condition.second))
        if first == second:
            return first
        if first is True and second is False:
            return condition.condition
        return _open(world, world.as_text(condition), True)
    if isinstance(condition, Unknown) or (isinstance(condition, str) and world.state.unknowns.is_open(condition)):
        return _open(world, world.as_text(condition), True)
    if not isinstance(condition, Made) or condition.kind not in _CONDITIONS:
        shown = condition.kind if isinstance(condition, Made) else type(condition).__name__.lower()
        raise LaunchError("python", "AttributeError", f"AttributeError: {shown} is no condition: it has no `evaluate`")
    world.here(condition.place)
    if condition.kind == "Condition":
        return _asked(world, condition.get("predicate"), context)
    if condition.kind.startswith("LaunchConfiguration"):
        return _compared(world, condition, context)
    wanted = condition.kind != "UnlessCondition"
    text = perform(world, condition.get("predicate_expression"), context)
    if world.state.unknowns.is_open(text):
        return _open(world, text, wanted)
    try:
        return boolean(text) is wanted
    except ValueError:
        raise LaunchError("condition", text, f"{'if' if wanted else 'unless'}: `{text}` is not true or false") from None


def _asked(world: World, function: Any, context: Context) -> bool | Condition:
    """What a function of the launch file says about a condition; one without a function does not hold."""
    found = False if function is None else world.interpreter.apply(function, [context], {})
    return found if isinstance(found, bool) else _open(world, world.as_text(found), True)


def _compared(world: World, condition: Made, context: Context) -> bool | Condition:
    """`LaunchConfigurationEquals` and its contrary."""
    wanted = condition.kind == "LaunchConfigurationEquals"
    name = world.as_text(condition.get("launch_configuration_name"))
    expected = condition.get("expected_value")
    if name not in context.configurations:
        return _open(world, f"$(var {name})", wanted) if context.may_have(name) else (expected is None) is wanted
    value, other = context.configurations[name], perform(world, expected, context)
    if value == other:
        return wanted
    if world.state.unknowns.is_open(value) or world.state.unknowns.is_open(other):
        unsure, sure = (value, other) if world.state.unknowns.is_open(value) else (other, value)
        known = not world.state.unknowns.is_open(sure)
        return _open(world, f"{value} == {other}", wanted, equals(unsure, sure) if known else None)
    return not wanted


def _open(world: World, text: str, wanted: bool, value: Formula | None = None) -> Condition:
    unknowns = world.state.unknowns
    return Condition(unknowns.render(text), wanted, world.state.here, value or truth(unknowns, text))


def condition_held(world: World, condition: Any) -> Condition:
    """A condition that holds, as it is written."""
    wanted = not isinstance(condition, Made) or condition.kind != "UnlessCondition"
    text = _written(world, condition)
    return Condition(text, wanted, condition.place if isinstance(condition, Made) else world.state.here, Test(text))


def _written(world: World, value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return "".join(_written(world, part) for part in value)
    if not isinstance(value, Made):
        return world.state.unknowns.render(world.as_text(value))
    parts = [_written(world, part) for part in value.arguments.values()]
    if value.kind in ("IfCondition", "UnlessCondition"):
        return "".join(parts)
    return f"{value.kind}({', '.join(parts)})"
