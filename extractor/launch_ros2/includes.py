"""Launch files that include others."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.xml_reader import XmlError
from rosarch.extractor.launch.compose import MAX_INCLUDE_DEPTH, MAX_INCLUDES
from rosarch.extractor.launch.files import DESCRIBED
from rosarch.extractor.launch.model import ArgumentPassed, Include, LaunchError, Place
from rosarch.extractor.launch.state import Exhausted
from rosarch.extractor.launch.yaml_values import YamlError
from rosarch.extractor.launch_ros2.actions import carries_out, must_be_passed, visit, visit_one_or_all
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.described import description
from rosarch.extractor.launch_ros2.expressions import Raised, Stopped, Undecided
from rosarch.extractor.launch_ros2.frontend import Entity, actions_of
from rosarch.extractor.launch_ros2.frontend_xml import read_xml
from rosarch.extractor.launch_ros2.frontend_yaml import read_yaml
from rosarch.extractor.launch_ros2.substitutions import perform
from rosarch.extractor.launch_ros2.values import Function, Made, ModuleFrame, Unknown

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.world import World


_OF_OTHER_FORMAT = {
    "PythonLaunchDescriptionSource": (".xml", ".yaml", ".yml", ".launch"),
    "XMLLaunchDescriptionSource": (".py", ".yaml", ".yml"),
    "YAMLLaunchDescriptionSource": (".py", ".xml", ".launch"),
}
"""The ends of the names of files that a source of launch descriptions does not read."""


@carries_out("IncludeLaunchDescription")
def _include(world: World, made: Made, context: Context) -> None:
    state = world.state
    source = made.get("launch_description_source")
    location = (
        source.get("location", "launch_file_path", "launch_description") if isinstance(source, Made) and "Source" in source.kind else source
    )
    if isinstance(location, Made) and location.kind == "LaunchDescription":
        _pass(world, made, state.here, context)
        visit(world, location, context)
        return
    path = perform(world, location, context)
    place = state.here
    if len(state.includes) >= MAX_INCLUDES:
        raise Exhausted(f"more than {MAX_INCLUDES} includes, the rest is left out")
    passed = _pass(world, made, place, context)
    if isinstance(source, Made) and path.endswith(_OF_OTHER_FORMAT.get(source.kind, ())):
        state.report(LaunchError("source", path, f"{source.kind} does not read {os.path.basename(path)}: use AnyLaunchDescriptionSource"))
    file = None if state.unknowns.is_open(path) else world.located(path)
    entities = None if file is None else read(world, file, len(context.lines))
    # a library need not have the revision that is installed where the files are launched
    is_certain = file is not None and not state.files.packages.underlay.is_of_library(file)
    for declared in _required(entities, set()) if is_certain else ():
        name = world.as_text(declared.get("name"))
        if name not in passed and not any(map(state.unknowns.is_open, passed)):
            state.report(must_be_passed(name), place=declared.place)
    lines = (*context.lines, place)
    state.includes.append(Include(path, file if entities is not None else None, lines, context.conditions, passes_all=True))
    if file is None or entities is None:
        context.put_unknown(state.unknowns.mark(f"$(arguments of {state.unknowns.render(path)})", place))
        return
    before = len(state.declared), len(world.asked), len(state.includes), len(state.unread)
    with context.included(file, place):
        visit_one_or_all(world, entities, context)
    world.here(place)
    for name in _unused(world, passed, file, before) if is_certain else ():
        state.warn("unused-argument", name, f"{path} neither declares nor uses the argument `{name}` that is passed to it")


def _required(entity: Any, seen: set[str]) -> Iterator[Made]:
    """The declarations of arguments that an include must pass itself, whatever is set already: those that no condition guards."""
    if isinstance(entity, (list, tuple)):
        for item in entity:
            if isinstance(item, Made) and item.kind == "ResetLaunchConfigurations":
                return
            yield from _required(item, seen)
    elif isinstance(entity, Made) and entity.kind == "DeclareLaunchArgument" and isinstance(name := entity.get("name"), str):
        if name not in seen and entity.get("condition", "default_value") is None:
            yield entity
        seen.add(name)
    elif isinstance(entity, Made) and entity.kind == "LaunchDescription":
        yield from _required(entity.get("initial_entities"), seen)
    elif isinstance(entity, Made) and entity.kind == "GroupAction" and entity.get("condition") is None and not _starts_anew(entity):
        yield from _required(entity.get("actions"), seen)


def _starts_anew(group: Made) -> bool:
    """Whether a group sees no configurations but its own."""
    return group.arguments.get("scoped") is not False and group.arguments.get("forwarding") is False


def _unused(world: World, passed: Iterable[str], file: str, before: tuple[int, int, int, int]) -> list[str]:
    """The arguments that an included file, and all that it includes, have no use for; none where not all of that is known."""
    state = world.state
    declared, asked, included, unread = before
    inner = state.includes[included:]
    known = {argument.name for argument in state.declared[declared:]} | set(world.asked[asked:])
    # a file of parameters that is not known may use it, as may Python that is not understood
    if not known or any(include.file is None for include in inner) or len(state.unread) > unread:
        return []
    files = dict.fromkeys([file, *(include.file for include in inner if include.file)])
    if any(problem.kind == "python" and problem.place.path in files for problem in state.problems):
        return []
    texts = [state.files.read_text(path) for path in files]
    named = (name for name in passed if not state.unknowns.is_open(name))
    return [name for name in named if name not in known and not any(name in text for text in texts)]


def _pass(world: World, made: Made, place: Place, context: Context) -> dict[str, str]:
    """Set the arguments that are passed, in their order: later ones see earlier ones."""
    given = made.get("launch_arguments")
    pairs = given.items() if isinstance(given, dict) else given if isinstance(given, (list, tuple)) else ()
    found: dict[str, str] = {}
    for pair in pairs:
        if isinstance(pair, (list, tuple)) and len(pair) == 2:
            name = perform(world, pair[0], context)
            found[name] = _passed(world, name, pair[1], context)
            context.give(name, found[name], made.place, place)
            world.state.passed.append(ArgumentPassed(name, found[name], made.place, made.place))
    return found


def _passed(world: World, name: str, value: Any, context: Context) -> str:
    """The text of an argument; what is no text is rejected by the argument's name."""
    try:
        return perform(world, [value], context)
    except Raised as error:
        raise Raised(error.kind, f"{error.message}: the launch argument `{name}` must be a text or substitutions") from error


def read(world: World, file: str, depth: int = 0) -> Any:
    """The actions of a launch file; None, with a report, when it cannot be read."""
    state = world.state
    if depth >= MAX_INCLUDE_DEPTH:
        state.report(LaunchError("cycle", file, f"includes nested more than {MAX_INCLUDE_DEPTH} deep"))
        return None
    try:
        found = _reader(file)(world, file)
    except LaunchError as error:
        state.report_unread(error)
        return None
    state.read.setdefault(file)
    return found


def _reader(file: str) -> Callable[[World, str], Any]:
    return description if file.endswith(f".py{DESCRIBED}") else _python if file.endswith(".py") else _frontend


def _frontend(world: World, file: str) -> Any:
    state = world.state
    try:
        root: Entity = state.files.parsed(file, read_yaml if file.endswith((".yaml", ".yml")) else read_xml)
    except (XmlError, YamlError) as error:
        state.report(LaunchError("xml", file, error.message), place=Place(file, error.line, error.column))
        return None
    return actions_of(world, root)


def _python(world: World, file: str) -> Any:
    """What `generate_launch_description` of a file returns, or as much of it as was made before interpretation stops."""
    run = world.interpreter
    text = world.state.files.read_text(file)
    name = f"__launch__{os.path.abspath(file)}"
    run.path, kept, depth, run.depth = [], run.path, run.depth, 0
    module: ModuleFrame | None = None
    try:
        module = run.run_module(name, file, text, is_launch_file=True)
        function = module.variables.get("generate_launch_description") or module.variables.get("generate_test_description")
        if function is None:
            raise LaunchError("python", file, f"{Path(file).name} has no function generate_launch_description")
        found = run.apply(function, [], {}) if isinstance(function, Function) else function
        if found is None:
            place = Place(file, function.node.lineno) if isinstance(function, Function) else Place(file, 1)
            problem = LaunchError("python", file, f"generate_launch_description of {Path(file).name} returns nothing")
            world.state.report(problem, place=place)
        return found[0] if isinstance(found, tuple) and found else found
    except SyntaxError as error:
        place = Place(file, error.lineno or 1, error.offset or 1)
        world.state.report(LaunchError("xml", file, f"not Python: {error.msg}"), place=place)
        return None
    except (Raised, Stopped, Undecided, RecursionError) as error:
        place = (error.place if isinstance(error, Raised) else None) or world.state.here
        if isinstance(error, Raised):
            run.raised(error, place)
        else:
            run.misunderstood(place, f"not understood from here on: {str(error) or 'too much depends on what is not known'}")
        frame = module or run.modules.get(name)
        return frame.described[-1] if frame and frame.described else Unknown(Path(file).name, place)
    finally:
        run.path, run.depth = kept, depth
