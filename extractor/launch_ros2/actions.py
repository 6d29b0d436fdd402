"""Actions, carried out as launch does, in their order. One that is rejected costs itself only."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.model import ArgumentDeclared, ArgumentLeaked, LaunchError, Remap
from rosarch.extractor.launch.names import canonical
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import PART_COST
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.conditions import condition_held, holds
from rosarch.extractor.launch_ros2.context import Context, Given
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.parameters import evaluated
from rosarch.extractor.launch_ros2.registry import NATIVES
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import (
    CLASSES,
    NOTHING,
    Bound,
    Class,
    Constructor,
    Either,
    Function,
    Instance,
    Made,
    Native,
    Unknown,
    class_of,
    in_order,
    is_derived,
)

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World

Handler = Callable[["World", Made, Context], None]
HANDLERS: dict[str, Handler] = {}
_SILENT = frozenset({"Shutdown", "ReadyToTest"})


def carries_out(*kinds: str) -> Callable[[Handler], Handler]:
    """Register the function for actions of these classes."""

    def register(function: Handler) -> Handler:
        for kind in kinds:
            HANDLERS[kind] = function
        return function

    return register


def visit_one_or_all(world: World, found: Any, context: Context) -> None:
    """Carry out an action, or a list of them, or nothing: what a launch file has, or what answers to an event."""
    (visit_all if isinstance(found, (list, tuple, type(None))) else visit)(world, found, context)


def visit_all(world: World, entities: Any, context: Context) -> None:
    """Carry out what stands where launch takes a list of actions, or none; it ends where something else does."""
    if isinstance(entities, (list, tuple, set, frozenset)):
        world.state.spend(PART_COST * len(entities))
        for item in in_order(entities) if isinstance(entities, (set, frozenset)) else entities:
            visit(world, item, context)
    elif isinstance(entities, Either):
        for condition, item in entities.alternatives():
            if context.allows(condition):
                with context.within(condition):
                    visit_all(world, item, context)
    elif isinstance(entities, Unknown):
        visit(world, entities, context)
    elif isinstance(entities, (Made, Instance, str, int, float)):
        world.interpreter.raised(Raised("TypeError", f"'{class_of(entities)}' object is not iterable"), world.state.here)


def visit(world: World, entity: Any, context: Context) -> None:
    """Carry out an action; launch ends where something else stands for one."""
    if entity is NOTHING:
        return
    if isinstance(entity, Either):
        for condition, item in entity.alternatives():
            if context.allows(condition):
                with context.within(condition):
                    visit(world, item, context)
    elif isinstance(entity, _NO_ACTIONS) or (isinstance(entity, Made) and not _is_entity(entity.kind)):
        world.interpreter.raised(Raised("AttributeError", f"'{class_of(entity)}' object has no attribute 'visit'"), world.state.here)
    elif isinstance(entity, Instance) and entity.made is not None:
        _visit_instance(world, entity, context)
    elif isinstance(entity, Made):
        _visit_made(world, entity, context)
    elif isinstance(entity, Unknown):
        reason = f" ({entity.reason})" if entity.reason else ""
        world.interpreter.misunderstood(entity.place, f"what `{world.state.unknowns.render(entity.text)}` starts is not known{reason}")
        context.put_unknown(world.as_text(entity))


_NO_ACTIONS = (list, tuple, set, dict, str, int, float, Class, Constructor, Function, type(None))


def _is_entity(kind: str) -> bool:
    """Whether an object of a class of launch may stand for an action."""
    return kind not in CLASSES or is_derived(kind, "Action") or is_derived(kind, "LaunchDescriptionEntity")


def _visit_instance(world: World, entity: Instance, context: Context) -> None:
    """An object of a class of the launch file: as its base class is, unless it says itself what is executed."""
    run = world.interpreter
    for name in ("execute", "visit"):
        method = run.member_of(entity, name)
        if isinstance(method, (Function, Bound)):
            condition = entity.made.arguments.get("condition") if entity.made is not None and name == "execute" else None
            with conditional(world, condition, context) as starts:
                found = run.apply(method, [context], {}) if starts else None
                # the method of a base class gives its object
                (visit if isinstance(found, (Made, Instance)) else visit_all)(world, found, context)
            return
    if entity.made is not None:
        _visit_made(world, entity.made, context)


def _visit_made(world: World, action: Made, context: Context) -> None:
    state = world.state
    state.count()
    world.here(action.place)
    state.scope = Scope("/", context.file, conditions=context.conditions)
    try:
        handler = HANDLERS.get(action.kind)
        with conditional(world, action.arguments.get("condition"), context) as starts:
            state.scope = Scope("/", context.file, conditions=context.conditions)
            if handler is not None and starts:
                handler(world, action, context)
                world.agenda.carried_out(action, context)
            elif handler is None and action.kind not in _SILENT:
                state.warn("python", action.kind, f"{action.kind} is not carried out")
    except LaunchError as error:
        world.here(action.place)
        state.report(error)
    except Raised as error:
        world.interpreter.raised(error, action.place)


@contextmanager
def conditional(world: World, condition: Any, context: Context) -> Iterator[bool]:
    """Whether the condition of an action lets it start; what follows is under it when that cannot be known."""
    found = holds(world, condition, context)
    if isinstance(found, bool):
        with context.since(condition_held(world, condition)) if found and condition is not None else nullcontext():
            yield found
    elif not context.allows(found):
        yield False
    else:
        before = dict(context.configurations)
        with context.within(found):
            yield True
        for name, value in context.configurations.items():
            if name in before and before[name] != value:
                context.configurations[name] = world.as_text(Either(found, value, before[name]))


@carries_out("LaunchDescription")
def _description(world: World, made: Made, context: Context) -> None:
    visit_all(world, made.get("initial_entities"), context)


@carries_out("GroupAction")
def _group(world: World, made: Made, context: Context) -> None:
    scoped, forwarding = made.arguments.get("scoped", True), made.arguments.get("forwarding", True)
    given = made.get("launch_configurations") or {}
    if scoped is False:
        context.put(_performed(world, given, context))
        visit_all(world, made.get("actions"), context)
        return
    with context.scoped():
        own = _performed(world, given, context)
        if forwarding is False:
            context.environment = {}
        _put(context, own, alone=forwarding is False)
        visit_all(world, made.get("actions"), context)
        _warn_of_idle(world, made.get("actions"))


_FOR_WHAT_FOLLOWS = frozenset({"PushRosNamespace", "PushROSNamespace", "SetParameter", "SetParametersFromFile", "SetRemap"})
_STARTS = frozenset({"Node", "LifecycleNode", "ComposableNodeContainer", "LoadComposableNodes", "IncludeLaunchDescription", "GroupAction"})


def _warn_of_idle(world: World, actions: Any) -> None:
    """Note what would hold for actions that follow it in a group, where none follows that starts anything, and some are before it."""
    if not isinstance(actions, (list, tuple)) or not all(isinstance(one, Made) for one in actions):
        return
    kinds = [one.kind for one in actions]
    idle = len(kinds) - next((number for number, kind in enumerate(reversed(kinds)) if kind not in _FOR_WHAT_FOLLOWS), len(kinds))
    if not _STARTS.isdisjoint(kinds[:idle]):
        for one in actions[idle:]:
            name = one.get("namespace", "name", "src")
            about = f"{one.kind} `{name}`" if isinstance(name, str) else one.kind
            message = f"{about} holds for what follows it in its group, and nothing does: move it to the beginning"
            world.state.warn("idle", one.kind, message, one.place)


def _put(context: Context, configurations: Mapping[str, str], *, alone: bool) -> None:
    """Set configurations, `alone` in the place of all others: of these, one whose name is not known may be any."""
    if alone and all(map(is_known, configurations)):
        context.clear()
    context.put(configurations)


@carries_out("PushLaunchConfigurations")
def _push_configurations(_world: World, _made: Made, context: Context) -> None:
    context.push_configurations()


@carries_out("PopLaunchConfigurations")
def _pop_configurations(_world: World, _made: Made, context: Context) -> None:
    context.pop_configurations()


@carries_out("PushEnvironment")
def _push_environment(_world: World, _made: Made, context: Context) -> None:
    context.push_environment()


@carries_out("PopEnvironment")
def _pop_environment(_world: World, _made: Made, context: Context) -> None:
    context.pop_environment()


@carries_out("LogInfo", "SetROSLogDir")
def _told(world: World, made: Made, context: Context) -> None:
    """Nothing starts, but launch ends when the text cannot be made."""
    text = made.get("msg", "new_log_dir")
    if text is not None:
        perform(world, text, context)


@carries_out("ResetEnvironment")
def _reset_environment(_world: World, _made: Made, context: Context) -> None:
    context.environment.clear()


def _performed(world: World, given: Any, context: Context) -> dict[str, str]:
    pairs = given.items() if isinstance(given, dict) else given if isinstance(given, (list, tuple)) else ()
    return {perform(world, name, context): perform(world, value, context) for name, value in pairs}


@carries_out("TimerAction", "RosTimer", "ROSTimer")
def _timer(world: World, made: Made, context: Context) -> None:
    period = made.get("period")
    text, moment = str(period) if isinstance(period, float) else perform(world, period, context), context.moment()

    def fire() -> None:
        with context.resumed(moment):
            visit_all(world, made.get("actions"), context)

    world.agenda.put(_seconds(world, text), fire)


def _seconds(world: World, text: str) -> float:
    """The period of a timer; 0 when it is not known.

    Raises:
        Raised: it is no number.
    """
    try:
        return max(float(text), 0.0)
    except ValueError as error:
        if world.state.unknowns.is_open(text):
            return 0.0
        raise Raised("ValueError", str(error)) from None


_HANDLED = ("on_exit", "on_start", "on_completion", "on_shutdown", "on_stdout", "on_stderr", "entities")


@carries_out("RegisterEventHandler")
def _events(world: World, made: Made, context: Context) -> None:
    """What an event starts is started when it happens, but for what the end of launch itself starts."""
    handler = made.get("event_handler")
    if isinstance(handler, Instance):
        handler = handler.made
    if not isinstance(handler, Made):
        return
    world.agenda.known.append(handler)
    if handler.kind == "OnShutdown":
        return
    outcomes = [handler.arguments[name] for name in _HANDLED if name in handler.arguments]
    place = world.state.here

    def handle() -> None:
        for outcome in outcomes:
            if isinstance(outcome, (Function, Bound)):
                outcome = world.interpreter.apply(outcome, [Unknown("event", world.state.here), context], {})
            if outcome == [] and is_derived(handler.kind, "OnActionEventBase"):  # which asks it as if it were a function
                world.state.report(LaunchError("python", "AttributeError", f"{handler.kind} has nothing to start"), place=place)
            visit_one_or_all(world, outcome, context)

    world.agenda.register(handler, context, handle)


@carries_out("UnregisterEventHandler")
def _no_event(world: World, made: Made, _context: Context) -> None:
    handler = made.get("event_handler")
    handler = handler.made if isinstance(handler, Instance) else handler
    if isinstance(handler, Made) and not world.agenda.forget(handler):
        raise Raised("ValueError", f"{handler.kind} is not registered")


@carries_out("EmitEvent", "LifecycleTransition")
def _emit(world: World, _made: Made, _context: Context) -> None:
    """Which nodes get the event, and what they do then, is not followed."""
    world.state.commands.setdefault(world.state.here)


def must_be_passed(name: str) -> LaunchError:
    """What is wrong where an argument is not passed that must be."""
    return LaunchError("argument", name, f"argument `{name}` must be passed, it has no default")


@carries_out("DeclareLaunchArgument")
def _declare(world: World, made: Made, context: Context) -> None:
    state = world.state
    name = world.as_text(made.get("name"))
    given = made.arguments.get("default_value")
    default = None if given is None else perform(world, given, context)
    state.declared.append(ArgumentDeclared(context.file, name, None, default, state.here))
    if name not in context.configurations:
        if default is None:
            if not context.may_have(name):
                state.report(must_be_passed(name))
            default = state.unknowns.mark(f"$(var {name})", context.file)
        context.give(name, default, state.here)
    elif default is not None:
        _note_leak(world, name, default, context)
    choices = made.arguments.get("choices")
    value = context.configurations[name]
    if isinstance(choices, (list, tuple)) and choices and not state.unknowns.is_open(value):
        texts = [perform(world, choice, context) for choice in choices]
        if value not in texts and not any(map(state.unknowns.is_open, texts)):
            raise LaunchError("choice", name, f"argument `{name}` is `{value}`, but must be one of {', '.join(texts)}")


def _note_leak(world: World, name: str, default: str, context: Context) -> None:
    """Note that an argument, which a file included before left set, has another value than its default."""
    origin, is_open = context.leaked(name), world.state.unknowns.is_open
    if origin is not None and origin.value.lower() != default.lower() and not is_open(default) and not is_open(origin.value):
        world.references.append(ArgumentLeaked(name, origin.value, world.state.here, origin.place))


@carries_out("SetLaunchConfiguration")
def _set(world: World, made: Made, context: Context) -> None:
    name = perform(world, made.get("name"), context)
    context.put({name: perform(world, made.get("value"), context)})


@carries_out("UnsetLaunchConfiguration")
def _unset(world: World, made: Made, context: Context) -> None:
    context.configurations.pop(perform(world, made.get("name"), context), None)


@carries_out("ResetLaunchConfigurations")
def _reset(world: World, made: Made, context: Context) -> None:
    _put(context, _performed(world, made.get("launch_configurations") or {}, context), alone=True)


@carries_out("SetEnvironmentVariable", "AppendEnvironmentVariable")
def _set_environment(world: World, made: Made, context: Context) -> None:
    name, value = perform(world, made.get("name"), context), perform(world, made.get("value"), context)
    before = context.variable(name)
    if made.kind == "AppendEnvironmentVariable" and before:
        separator = ":" if made.get("separator") is None else perform(world, made.get("separator"), context)
        value = separator.join((value, before) if made.get("prepend") else (before, value))
    context.environment[name] = value


@carries_out("UnsetEnvironmentVariable")
def _unset_environment(world: World, made: Made, context: Context) -> None:
    context.environment[perform(world, made.get("name"), context)] = None


@carries_out("PushRosNamespace", "PushROSNamespace")
def _namespace(world: World, made: Made, context: Context) -> None:
    context.namespace = joined(context.namespace, perform(world, made.get("namespace"), context))
    require_namespace(context.namespace)
    context.is_in_namespace = True


_WORD = r"[A-Za-z_][A-Za-z0-9_]*"


def require_namespace(namespace: str) -> None:
    """Require that a namespace is one, as far as it is known.

    Raises:
        LaunchError: launch rejects it.
    """
    if is_known(namespace) and not re.fullmatch(rf"(/{_WORD})*", namespace):
        raise LaunchError("namespace", namespace, f"`{namespace}` is no namespace")


def require_node_name(name: str) -> None:
    """Require that the name of a node is one, as far as it is known.

    Raises:
        LaunchError: launch rejects it.
    """
    if is_known(name) and not re.fullmatch(_WORD, name):
        raise LaunchError("node", name, f"`{name}` is no name of a node")


def joined(outer: str, inner: str) -> str:
    """A namespace within another one, absolute: an absolute one stays as it is."""
    text = inner if inner.startswith("/") else f"{outer}/{inner}"
    text = canonical(text if text.startswith("/") else f"/{text}")
    return "" if text == "/" else text


@carries_out("SetRemap")
def _remap(world: World, made: Made, context: Context) -> None:
    remap = Remap(perform(world, made.get("src"), context), perform(world, made.get("dst"), context), world.state.here, context.conditions)
    world.state.remaps.append(remap)
    context.add_remap(remap)


@carries_out("SetParameter")
def _parameter(world: World, made: Made, context: Context) -> None:
    name = perform(world, made.get("name"), context)
    value = evaluated(world, made.arguments.get("value"), context)  # as it is now, whatever changes later
    context.add_params(Given(value, world.state.here, context.conditions, name=name, shared=True))


@carries_out("SetUseSimTime")
def _sim_time(_world: World, made: Made, _context: Context) -> None:
    """The clock of launch's own node; no other gets the parameter."""
    if not isinstance(made.arguments.get("value"), (Unknown, Either)) and made.arguments.get("value") is not True:
        raise LaunchError("parameter", "use_sim_time", "SetUseSimTime fails unless its value is the Boolean True")


@carries_out("SetParametersFromFile")
def _parameters(world: World, made: Made, context: Context) -> None:
    node = made.get("node_name")
    name = None if node is None else perform(world, node, context)
    context.add_params(Given(made.get("filename"), world.state.here, context.conditions, node=name, shared=True))


@carries_out("OpaqueFunction")
def _function(world: World, made: Made, context: Context) -> None:
    arguments = made.arguments.get("args") or ()
    named = made.arguments.get("kwargs") or {}
    function = made.get("function")
    if isinstance(function, (list, tuple, str, Made, type(None))):
        raise Raised("TypeError", f"OpaqueFunction expected a callable for 'function', got '{class_of(function)}'")
    rest = list(arguments) if isinstance(arguments, (list, tuple)) else []
    visit_all(world, called(world, function, [context, *rest], named if isinstance(named, dict) else {}), context)


def called(world: World, function: Any, arguments: list[Any], named: dict[str, Any]) -> Any:
    """What a function of a launch file returns; what it adds belongs to the conditions that it is called under."""
    if not isinstance(function, (Function, Bound, Native)):
        return function if isinstance(function, (Unknown, Either)) else None
    run = world.interpreter
    run.path, kept = [], run.path
    try:
        return run.apply(function, arguments, named)
    finally:
        run.path = kept


@carries_out("ForEach")
def _for_each(world: World, made: Made, context: Context) -> None:
    """The values are YAML documents, separated by semicolons; each is handed to the function as named arguments."""
    text = perform(world, made.get("input_values", "values"), context)
    if world.state.unknowns.is_open(text):
        world.interpreter.misunderstood(world.state.here, f"the values of ForEach are not known: {world.state.unknowns.render(text)}")
        return
    for part in filter(str.strip, text.split(";")):
        values = NATIVES["yaml.safe_load"].call(world.interpreter, part.strip())
        if isinstance(values, dict):
            _round(world, made, [], {str(key): value for key, value in values.items()}, context)


@carries_out("ForLoop")
def _for(world: World, made: Made, context: Context) -> None:
    text = perform(world, made.get("length", "len"), context)
    if not text.strip().isdigit() or int(text) > 1000:
        world.interpreter.misunderstood(
            world.state.here, f"the number of rounds of ForLoop is not known: {world.state.unknowns.render(text)}"
        )
        return
    for index in range(int(text)):
        _round(world, made, [index], {"index": index, str(made.get("name") or "index"): index}, context)


def _round(world: World, made: Made, arguments: list[Any], values: dict[str, Any], context: Context) -> None:
    if made.get("function") is not None:
        visit_all(world, called(world, made.get("function"), arguments, {} if arguments else values), context)
        return
    kept, context.loop = context.loop, {**context.loop, **values}
    visit_all(world, made.get("actions"), context)
    context.loop = kept
