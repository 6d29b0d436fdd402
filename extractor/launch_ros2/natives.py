"""The functions and methods of Python's library, of ament_index and of launch that Python launch files may use.

Each gets the interpreter first, then its arguments; `NOTHING` says that its value is not known.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any

from rosarch.extractor.launch.eval_functions import BUILTINS, MATH, METHODS
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch_ros2.argument_types import NODES
from rosarch.extractor.launch_ros2.conditions import holds
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.decisions import holds_several, is_certain
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.natives_files import FILE_METHODS, PATH_METHODS, xml_of
from rosarch.extractor.launch_ros2.natives_processes import decoded
from rosarch.extractor.launch_ros2.natives_xml import ELEMENT_METHODS, of_element
from rosarch.extractor.launch_ros2.parameters import yaml_value
from rosarch.extractor.launch_ros2.registry import CONSTANTS, NATIVES, native
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import (
    NOTHING,
    ROS_ARGUMENTS,
    Bound,
    Class,
    Constructor,
    Either,
    Function,
    Installed,
    Instance,
    Made,
    Module,
    Native,
    PathText,
    TextFile,
    Unknown,
    is_derived,
)
from rosarch.extractor.urdf.document import Element

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.calls import Calls

_Call = Callable[..., Any]
_CALLED = (Function, Bound, Native, Class, Constructor)


def attribute(run: Calls, owner: Any, name: str) -> Any:
    """`owner.name` for values of Python's and of launch; NOTHING when it is not known."""
    if isinstance(owner, Native):
        return _of_native(owner, name)
    if isinstance(owner, Installed):
        return Native(name, lambda _run: owner) if name == "keys" else NOTHING
    if isinstance(owner, (Unknown, Either, Constructor)) or owner is None:
        return NOTHING
    method = next((table.get(name) for kinds, table in _METHODS if isinstance(owner, kinds)), None)
    if method is not None:
        return Native(name, lambda run, *arguments, **named: method(run, owner, *arguments, **named))
    if isinstance(owner, PathText):
        return _of_path(owner, name)
    if isinstance(owner, Element):
        return of_element(owner, name)
    if isinstance(owner, Made):
        return _of_made(owner, name)
    if isinstance(owner, Context):
        return {"launch_configurations": owner.configurations, "environment": NATIVES["os.environ"]}.get(name, NOTHING)
    if isinstance(owner, TextFile) and name == "name":
        return owner.name
    return _of_plain(owner, name)


def _of_plain(owner: Any, name: str) -> Any:
    method = METHODS.get(tuple if isinstance(owner, tuple) else type(owner), {}).get(name)
    if method is None:
        return NOTHING

    def call(_run: Calls, *arguments: Any, **named: Any) -> Any:
        if isinstance(owner, str) and not is_known(owner):
            return owner if name in ("lower", "upper", "strip") else NOTHING
        if isinstance(owner, str) and name == "join":
            return _joined(owner, *arguments)
        if isinstance(owner, str) and not all(map(is_certain, (*arguments, *named.values()))):
            return _formatted(owner, name, arguments, named)
        if any(isinstance(item, (Made, Instance, Function, PathText)) for item in arguments) and isinstance(owner, str):
            return NOTHING
        return method(owner, *arguments, **named)

    return Native(name, call)


def _joined(separator: str, items: Any) -> Any:
    known = isinstance(items, (str, list, tuple)) and all(isinstance(item, str) for item in items)
    return METHODS[str]["join"](separator, items) if known else NOTHING


def _formatted(text: str, name: str, arguments: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """`format` and `replace` take texts with unknown parts as they are."""
    if name in ("format", "replace") and all(isinstance(item, str) for item in (*arguments, *named.values())):
        return METHODS[str][name](text, *arguments, **named)
    return NOTHING


def _of_native(owner: Native, name: str) -> Any:
    return NATIVES.get(f"{owner.name}.{name}", NOTHING)


def _of_path(owner: PathText, name: str) -> Any:
    path = PurePosixPath(owner.text)
    if name == "parent":
        return PathText(str(path.parent))
    if name == "parents":
        return [PathText(str(parent)) for parent in path.parents]
    if name in ("name", "stem", "suffix"):
        return str(getattr(path, name))
    return list(path.parts) if name == "parts" else NOTHING


def _of_made(owner: Made, name: str) -> Any:
    if owner.kind == "LaunchDescription" and name == "entities":
        return _entities(owner)
    if name == "cmd" and owner.kind in NODES:
        return _command(owner)
    return owner.arguments.get(name, NOTHING)


def _command(node: Made) -> Any:
    """The command line of a node, a list of lists: its program, its arguments, and what launch_ros adds for ROS."""
    if node.command is None:
        words: list[Any] = []
        for name in ("arguments", "ros_arguments"):
            given = node.get(name)
            if given is not None and not isinstance(given, (list, tuple)):
                return NOTHING
            words += ["--ros-args"] if name == "ros_arguments" and given is not None else []
            words += given or ()
        program = Made("ExecutableInPackage", {name: node.get(name) for name in ("executable", "package")}, node.place)
        node.command = [[program], *(list(word) if isinstance(word, (list, tuple)) else [word] for word in words), [ROS_ARGUMENTS]]
    return node.command


# -- lists, maps, sets --------------------------------------------------------------------------------------------------------


def _append(run: Calls, owner: list[Any], item: Any) -> None:
    owner.append(run.guarded(item))


def _extend(run: Calls, owner: list[Any], items: Any) -> None:
    owner.extend(map(run.guarded, run.spread(items)))


def _insert(run: Calls, owner: list[Any], index: Any, item: Any) -> None:
    owner.insert(index if isinstance(index, int) else len(owner), run.guarded(item))


def _update(run: Calls, owner: dict[Any, Any], *more: Any, **named: Any) -> None:
    if more and more[0] is None:
        raise Raised("TypeError", "'NoneType' object is not iterable")
    for added in (*more[:1], named):
        for key, value in run.entries(added, owner):
            run.set_item(owner, key, value)


def _get(run: Calls, owner: dict[Any, Any], key: Any, default: Any = None) -> Any:
    if key not in owner and run.is_widened(owner):
        return NOTHING
    return owner.get(key, default)


def _setdefault(run: Calls, owner: dict[Any, Any], key: Any, default: Any = None) -> Any:
    if key not in owner:
        run.set_item(owner, key, default)
    return owner[key]


def _pop(_run: Calls, owner: Any, *key: Any) -> Any:
    return owner.pop(*key) if all(map(is_certain, key)) else NOTHING


def _copy(_run: Calls, owner: Any) -> Any:
    return owner.copy()


_LIST: dict[str, _Call] = {"append": _append, "extend": _extend, "insert": _insert, "pop": _pop, "copy": _copy}
_LIST["sort"] = lambda _run, owner, **_named: owner.sort() if is_certain(owner) else None
_LIST["reverse"] = lambda _run, owner: owner.reverse()
_DICT: dict[str, _Call] = {"get": _get, "update": _update, "setdefault": _setdefault, "pop": _pop, "copy": _copy}
_SET: dict[str, _Call] = {"add": lambda _run, owner, item: owner.add(item), "copy": _copy}


# -- launch -------------------------------------------------------------------------------------------------------------------


def _entities(owner: Made) -> list[Any]:
    found = owner.arguments.get("initial_entities")
    if not isinstance(found, list):
        found = owner.arguments["initial_entities"] = list(found) if isinstance(found, (tuple, set)) else [] if found is None else [found]
    return found


def _add(run: Calls, owner: Made, item: Any, *_more: Any) -> Any:
    if owner.kind != "LaunchDescription":
        return NOTHING
    _entities(owner).append(run.guarded(item))
    return None


def _arguments(_run: Calls, owner: Made, *_more: Any) -> Any:
    """The arguments that a description declares; not known when an included file may declare more."""
    found: list[Made] = []
    waiting = list(_entities(owner)) if owner.kind == "LaunchDescription" else [None]
    while waiting:
        entity = waiting.pop(0)
        if not isinstance(entity, Made) or entity.kind in ("IncludeLaunchDescription", "OpaqueFunction"):
            return NOTHING
        if entity.kind == "DeclareLaunchArgument":
            found.append(entity)
        inner = entity.arguments.get("actions") if entity.kind == "GroupAction" else ()
        waiting += inner if isinstance(inner, (list, tuple)) else [inner]
    return found


def _perform(run: Calls, owner: Made, context: Any = None) -> Any:
    return perform(run.world, owner, context) if isinstance(context, Context) else NOTHING


def _evaluate(run: Calls, owner: Made, context: Any = None) -> Any:
    found = holds(run.world, owner, context) if isinstance(context, Context) else None
    return NOTHING if found is None or not isinstance(found, bool) else found


def _find(run: Calls, owner: Made, package: Any) -> Any:
    return run.world.share(package) if isinstance(package, str) and owner.kind.startswith("FindPackage") else NOTHING


_MADE: dict[str, _Call] = {"add_action": _add, "add_entity": _add, "perform": _perform, "evaluate": _evaluate, "find": _find}
_MADE["_predicate_func"] = _evaluate  # what IfCondition and UnlessCondition evaluate by
_MADE["get_launch_arguments"] = _arguments
_MADE["toxml"] = _MADE["toprettyxml"] = lambda run, owner, **_named: xml_of(run, owner) if owner.kind == "XacroDocument" else NOTHING
_MADE["decode"] = decoded
_MADE["describe"] = lambda _run, _owner: NOTHING


def _perform_substitution(run: Calls, context: Context, substitution: Any) -> Any:
    return perform(run.world, substitution, context)


_CONTEXT: dict[str, _Call] = {"perform_substitution": _perform_substitution}


@native("launch.utilities.perform_substitutions")
def _perform_substitutions(run: Calls, context: Any, substitutions: Any) -> Any:
    return _perform_substitution(run, context, substitutions) if isinstance(context, Context) else NOTHING


@native("launch.utilities.normalize_to_list_of_substitutions")
def _normalize(_run: Calls, substitutions: Any) -> Any:
    return list(substitutions) if isinstance(substitutions, (list, tuple)) else [substitutions]


@native("launch.utilities.type_utils.get_typed_value", "launch.utilities.type_utils.coerce_to_type")
def _typed_value(_run: Calls, value: Any, kind: Any = None, **_named: Any) -> Any:
    """A text as a value of a type: by the rules of YAML, but numbers by Python's own."""
    if not isinstance(value, str) or not is_known(value):
        return NOTHING
    kind = _TYPES.get(kind.name) if isinstance(kind, Native) else kind
    if kind is str or (kind is None and not value):
        return value
    if kind in (int, float):
        return kind(value)
    found = yaml_value({"1": "true", "0": "false"}.get(value, value) if kind is bool else value)
    if kind is bool and not isinstance(found, bool):
        raise Raised("ValueError", f"Cannot convert value '{value}' to 'bool'")
    return found if kind in (None, bool) else NOTHING


@native("launch.launch_description_sources.load_python_launch_file_as_module")
def _module_of(run: Calls, path: Any) -> Any:
    return run.module_of_file(path) if isinstance(path, str) and is_known(path) else NOTHING


@native("launch.launch_description_sources.get_launch_description_from_python_launch_file")
def _description_of(run: Calls, path: Any) -> Any:
    module = _module_of(run, path)
    function = module.frame.variables.get("generate_launch_description") if isinstance(module, Module) and module.frame else None
    return run.apply(function, [], {}) if isinstance(function, (Function, Bound)) else NOTHING


@native("launch.LaunchContext")
def _launch_context(run: Calls, **_named: Any) -> Any:
    return Context(run.world.state.here.path, outside=run.world.environment)


for _name in ("load_python_launch_file_as_module", "get_launch_description_from_python_launch_file"):
    NATIVES[f"launch.launch_description_sources.python_launch_file_utilities.{_name}"] = NATIVES[
        f"launch.launch_description_sources.{_name}"
    ]
NATIVES["launch.launch_context.LaunchContext"] = NATIVES["launch.LaunchContext"]


# -- Python's own -------------------------------------------------------------------------------------------------------------


@native("str")
def _str(run: Calls, value: Any = "") -> Any:
    if isinstance(value, (Made, Instance, Function, Class)):
        return NOTHING
    return str(value) if not isinstance(value, (Unknown, Either, PathText)) and is_certain(value) else run.world.as_text(value)


@native("exit", "quit", "sys.exit", "os._exit")
def _exit(_run: Calls, *_arguments: Any, **_named: Any) -> Any:
    raise Raised("SystemExit", "the program ends")


@native("print", "input", "os.remove", "time.sleep", "launch.logging.get_logger")
def _nothing(_run: Calls, *_arguments: Any, **_named: Any) -> Any:
    return NOTHING


_TYPES: dict[str, Any] = {
    **{name: BUILTINS[name] for name in ("bool", "dict", "float", "int", "list", "set", "str", "tuple")},
    "pathlib.Path": PathText,
}


@native("type")
def _type(_run: Calls, value: Any, *more: Any) -> Any:
    if isinstance(value, Instance) and not more:
        return value.of
    name = next((name for name, kind in _TYPES.items() if type(value) is kind), "tuple" if isinstance(value, tuple) else "")
    return NATIVES.get(name) or BUILTINS.get(name, NOTHING) if not more else NOTHING


@native("isinstance")
def _isinstance(_run: Calls, value: Any, kinds: Any) -> Any:
    if isinstance(value, (Unknown, Either)):
        return NOTHING
    found = [_is_of(value, kind) for kind in (kinds if isinstance(kinds, tuple) else (kinds,))]
    return True if True in found else NOTHING if None in found else False


def _is_of(value: Any, kind: Any) -> bool | None:
    """Whether a value is of a class; None when that is not known."""
    kind = _TYPES.get(kind.name) if isinstance(kind, Native) else kind
    if isinstance(kind, Constructor):
        made = value.made if isinstance(value, Instance) else value
        return isinstance(made, Made) and is_derived(made.kind, kind.kind)
    if isinstance(kind, Class):
        return isinstance(value, Instance) and value.of.is_derived(kind)
    return isinstance(value, kind) if kind in _TYPES.values() else None


NATIVES["typing.Text"] = NATIVES["str"]


@native("len")
def _len(_run: Calls, value: Any) -> Any:
    known = isinstance(value, (list, tuple, dict, set, range)) or (isinstance(value, str) and is_known(value))
    return len(value) if known and not holds_several(value) else NOTHING


def _items_of(name: str) -> _Call:
    function = BUILTINS[name]

    def call(run: Calls, *given: Any, **named: Any) -> Any:
        arguments = [*map(run.gone_through, given)]
        if any(isinstance(item, (Unknown, Either, Made, Instance)) for item in arguments):
            return NOTHING
        if arguments and isinstance(arguments[0], Installed):
            return arguments[0]
        key = named.pop("key", None)
        if key is not None:
            named["key"] = lambda item: run.apply(key, [item], {}) if isinstance(key, (Function, Bound, Native)) else key(item)
        if name in ("sorted", "any", "all") and not all(map(is_certain, arguments)):
            return list(arguments[0]) if name == "sorted" else NOTHING
        return function(*arguments, **named)

    return call


for _name in ("list", "tuple", "set", "sorted", "reversed", "enumerate", "zip", "any", "all"):
    native(_name)(_items_of(_name))


@native("dict")
def _dict(run: Calls, *more: Any, **named: Any) -> dict[Any, Any]:
    made: dict[Any, Any] = {}
    for added in (*more[:1], named):
        made.update(run.entries(added, made))
    return made


@native("map")
def _map(run: Calls, function: Any, items: Any) -> Any:
    items = run.gone_through(items)
    if not isinstance(items, (list, tuple)):
        return NOTHING
    return [run.apply(function, [item], {}) if isinstance(function, _CALLED) else function(item) for item in items]


@native("filter")
def _filter(run: Calls, function: Any, items: Any) -> Any:
    kept = items if function is None else _map(run, function, items)
    truths = [run.truth(one) for one in kept] if isinstance(kept, (list, tuple)) else [None]
    return NOTHING if None in truths else [item for item, truth in zip(items, truths, strict=True) if truth]


@native("getattr")
def _getattr(run: Calls, owner: Any, name: Any, *default: Any) -> Any:
    if isinstance(owner, Module) and isinstance(name, str):
        found = NOTHING if owner.frame is None else owner.frame.variables.get(name, NOTHING)
    elif isinstance(owner, Instance) and isinstance(name, str) and name not in owner.attributes:
        found = run.member_of(owner, name)
    else:
        found = attribute(run, owner, name) if isinstance(name, str) else NOTHING
    return default[0] if found is NOTHING and default else found


@native("copy.copy")
def _copied(_run: Calls, value: Any) -> Any:
    return type(value)(value) if type(value) in (dict, list, set) else value


@native("copy.deepcopy")
def _copied_deeply(_run: Calls, value: Any) -> Any:
    copies: dict[int, Any] = {}  # by what they are copies of: a list may contain itself

    def copy(value: Any) -> Any:
        if id(value) not in copies:
            if type(value) is dict:
                made: dict[Any, Any] = {}
                copies[id(value)] = made
                made.update({key: copy(item) for key, item in value.items()})
            elif type(value) is list:
                items: list[Any] = []
                copies[id(value)] = items
                items += map(copy, value)
            else:
                return tuple(map(copy, value)) if isinstance(value, tuple) else set(value) if type(value) is set else value
        return copies[id(value)]

    return copy(value)


for _name, _value in MATH.items():
    if isinstance(_value, float):
        CONSTANTS[f"math.{_name}"] = _value
    if callable(_value):
        native(f"math.{_name}")(lambda _run, *arguments, _value=_value: _value(*arguments) if all(map(is_certain, arguments)) else NOTHING)

_METHODS: tuple[tuple[Any, dict[str, _Call]], ...] = (
    (list, _LIST),
    (dict, _DICT),
    (set, _SET),
    (PathText, PATH_METHODS),
    (TextFile, FILE_METHODS),
    (Element, ELEMENT_METHODS),
    (Made, _MADE),
    (Context, _CONTEXT),
)
