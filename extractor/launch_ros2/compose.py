"""From ROS 2 launch files to a `Composition`."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from rosarch.extractor.launch.compose import finished
from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.meant import file_meant, meant
from rosarch.extractor.launch.model import Composition, FileMeant, FileNamed, LaunchError, Place, Reference
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import Exhausted, State
from rosarch.extractor.launch.unknowns import cleaned, is_known
from rosarch.extractor.launch_ros2 import starts  # noqa: F401  (registers its actions)
from rosarch.extractor.launch_ros2.actions import joined, visit_one_or_all
from rosarch.extractor.launch_ros2.context import Context
from rosarch.extractor.launch_ros2.controllers import controllers
from rosarch.extractor.launch_ros2.expressions import Raised, Stopped, Undecided
from rosarch.extractor.launch_ros2.includes import read
from rosarch.extractor.launch_ros2.left_out import left_out
from rosarch.extractor.launch_ros2.misjoined import misjoined
from rosarch.extractor.launch_ros2.truths import truths
from rosarch.extractor.launch_ros2.world import World
from rosarch.extractor.python_syntax import parse_python


def compose_ros2(
    launch_files: Sequence[Path | str],
    arguments: Mapping[str, str] | None = None,
    *,
    files: Files,
    environment: Mapping[str, str] | None = None,
    namespace: str | None = None,
) -> Composition:
    """What `ros2 launch` would make of launch files, one after the other; see `rosarch.extractor.launch.compose`."""
    state = State(files, environment or {})
    world = World(state)
    files.allow_named(arguments or {})
    for path in map(str, launch_files):
        context = Context(path, outside=world.environment, namespace=joined("", namespace or ""))
        context.configurations.update({name: cleaned(value) for name, value in (arguments or {}).items()})
        world.context = context
        world.argv = ["ros2", "launch", path, *(f"{name}:={value}" for name, value in (arguments or {}).items())]
        _top(world, path, context)
    with suppress(Exhausted):
        state.controllers += controllers(world, world.context)
    composition = replace(finished(state, _references(world)), ros=2)
    more = (*_meant(world, composition), *_truths(world))
    return replace(composition, references=tuple(dict.fromkeys((*composition.references, *more))))


def _top(world: World, path: str, context: Context) -> None:
    state = world.state
    state.here, state.scope = Place(path, 1), Scope("/", path)
    state.files.allow_beside(path)
    try:
        visit_one_or_all(world, read(world, path), context)
        world.agenda.run()
    except (Exhausted, RecursionError, Stopped, Undecided) as error:
        reason = str(error) if isinstance(error, (Exhausted, Stopped)) else "nested too deeply, the rest is left out"
        state.report(LaunchError("size", path, reason))
    except LaunchError as error:
        state.report(error)
    except Raised as error:
        world.interpreter.raised(error, Place(path, 1))


def _meant(world: World, composition: Composition) -> Iterator[FileMeant]:
    """The files that are meant; those that a launch file looks for first need not be there."""
    packages = world.state.files.packages
    read = (("read", path, place) for path, place in world.read if is_known(path))
    for role, path, place in (*read, *meant(composition)):
        made = path in world.written or world.is_handed(path)
        if packages.of_file(path) is not None and path not in world.looked_for and not made:
            yield file_meant(role, path, place, packages, there=os.path.exists(world.located(path)))


def _truths(world: World) -> Iterator[Reference]:
    """Where Python launch files take configurations for values, and which actions they leave out."""
    for path in world.state.read:
        if path.endswith(".py"):
            with suppress(LaunchError, SyntaxError):
                text = world.state.files.read(path)
                tree = parse_python(text)
                yield from truths(tree, path)
                yield from misjoined(tree, path)
                yield from left_out(tree, text.decode(errors="replace"), path)


def _references(world: World) -> tuple[Reference, ...]:
    """What the launch files name, as far as it was come across."""
    found: dict[Reference, None] = dict.fromkeys(world.references)
    for problem in world.state.problems:
        if problem.kind == "file" and os.path.isabs(problem.subject):
            found[FileNamed("value", problem.subject, True, problem.place)] = None
    return tuple(found)
