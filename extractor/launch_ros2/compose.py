"""From ROS 2 launch files to a `Composition`."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from rosarch.extractor.launch.compose import finished
from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import Composition, FileNamed, LaunchError, Place, Reference
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import Exhausted, State
from rosarch.extractor.launch.unknowns import cleaned

from . import starts  # noqa: F401  (registers its actions)
from .actions import joined, visit
from .context import Context
from .expressions import Raised, Stopped, Undecided
from .includes import read
from .world import World


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
    for path in map(str, launch_files):
        context = Context(path, outside=world.environment, namespace=joined("", namespace or ""))
        context.configurations.update({name: cleaned(value) for name, value in (arguments or {}).items()})
        _top(world, path, context)
    return replace(finished(state, _references(world)), ros=2)


def _top(world: World, path: str, context: Context) -> None:
    state = world.state
    state.here, state.scope = Place(path, 1), Scope("/", path)
    state.files.allow_beside(path)
    try:
        visit(world, read(world, path), context)
    except (Exhausted, RecursionError, Stopped, Undecided) as error:
        reason = str(error) if isinstance(error, (Exhausted, Stopped)) else "nested too deeply, the rest is left out"
        state.report(LaunchError("size", path, reason))
    except LaunchError as error:
        state.report(error)
    except Raised as error:
        world.interpreter.misunderstood(error.place or Place(path, 1), f"not understood from here on: {error.kind}: {error.message}")


def _references(world: World) -> tuple[Reference, ...]:
    """What the launch files name, as far as it was come across."""
    found: dict[Reference, None] = dict.fromkeys(world.references)
    for problem in world.state.problems:
        if problem.kind == "file" and os.path.isabs(problem.subject):
            found[FileNamed("value", problem.subject, True, problem.place)] = None
    return tuple(found)
