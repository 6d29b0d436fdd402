"""What actions see and change while they are carried out: configurations, environment, namespace, remappings and parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any

from rosarch.extractor.launch.model import Condition, LaunchError, Place, Remap, exclusive
from rosarch.extractor.launch.unknowns import is_known

_ALWAYS_SET = frozenset({"AMENT_PREFIX_PATH", "HOME", "HOSTNAME", "LANG", "PATH", "PWD", "PYTHONPATH", "ROS_DISTRO", "SHELL", "USER"})


@dataclass(frozen=True)
class Given:
    """A parameter, or a file of parameters, that nodes get; `place` is where it is given, `conditions` are its own.

    What is given to a class that is `loaded` into a container is read by launch_ros itself; what is `shared` is given to all nodes that
    follow, by an action of its own.
    """

    value: Any
    place: Place
    conditions: tuple[Condition, ...] = ()
    name: str | None = None
    node: str | None = None
    loaded: bool = False
    shared: bool = False


@dataclass(frozen=True)
class Origin:
    """Where a declaration, or an include that passes an argument, gave a configuration its value; `lines` are the includes up to there."""

    value: str
    place: Place
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...]


@dataclass(frozen=True)
class Moment:
    """Where in the launch files launch is, and under which conditions, when it puts something off."""

    file: str
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...]
    held: tuple[Condition, ...]
    loop: Mapping[str, Any]

    def within(self, *conditions: tuple[Condition, ...]) -> Moment:
        """This moment, under more conditions."""
        return replace(self, conditions=tuple(dict.fromkeys([*self.conditions, *(one for some in conditions for one in some)])))


@dataclass
class Context:
    """The state of launch. What a group keeps to itself is put back when the group ends; an included file changes its includer's.

    Remappings and parameters for all nodes are lists that groups share, as in launch: what a group adds to one of before stays.

    It `is_in_namespace` when one was pushed, be that the root.

    `origins` are those of configurations that are arguments; `environment` is what differs from the environment `outside`, with None for a
    variable that was unset. `kept` and `environments` are what was pushed, the last at the end.
    """

    file: str
    configurations: dict[str, str] = field(default_factory=dict)
    origins: dict[str, Origin] = field(default_factory=dict)
    outside: Mapping[str, str] = field(default_factory=dict)
    environment: dict[str, str | None] = field(default_factory=dict)
    namespace: str = ""
    is_in_namespace: bool = False
    remaps: list[Remap] = field(default_factory=list)
    params: list[Given] = field(default_factory=list)
    conditions: tuple[Condition, ...] = ()
    held: tuple[Condition, ...] = ()
    lines: tuple[Place, ...] = ()
    loop: Mapping[str, Any] = field(default_factory=dict)
    kept: list[Context] = field(default_factory=list)
    environments: list[dict[str, str | None]] = field(default_factory=list)
    anew: bool = False
    """Whether the end of a process starts what is visited: the actions that have started before are started once more."""

    def variable(self, name: str) -> str | None:
        """The value of an environment variable."""
        return self.environment[name] if name in self.environment else self.outside.get(name)

    def lacks(self, name: str) -> bool:
        """Whether an environment variable is not set; some are wherever launch runs, with a value that may not be known."""
        return self.variable(name) is None and (name in self.environment or name not in _ALWAYS_SET)

    def allows(self, condition: Condition) -> bool:
        """Whether something under this condition, too, may be there."""
        return not exclusive(self.conditions, (condition,))

    def variables(self) -> dict[str, str]:
        """All environment variables that are set."""
        return {name: value for name in (*self.outside, *self.environment) if (value := self.variable(name)) is not None}

    def of_commands(self) -> Context:
        """What a program sees that is no node for launch: no namespace, and no remappings and parameters for all nodes."""
        return replace(self, namespace="", is_in_namespace=False, remaps=[], params=[])

    def add_remap(self, remap: Remap) -> None:
        """Give a remapping to all nodes that follow."""
        self.remaps = _extended(self.remaps, remap)

    def add_params(self, given: Given) -> None:
        """Give parameters to all nodes that follow."""
        self.params = _extended(self.params, given)

    def clear(self) -> None:
        """Forget all configurations, of which namespace, remappings and parameters for all nodes are some."""
        self.configurations.clear()
        self.namespace, self.is_in_namespace, self.remaps, self.params = "", False, [], []

    def put(self, values: Mapping[str, str]) -> None:
        """Set configurations, for all that follows."""
        self.configurations.update(values)
        self.origins = {name: origin for name, origin in self.origins.items() if name not in values}

    def put_unknown(self, mark: str) -> None:
        """Note that configurations are set of which neither names nor values are known: `mark` stands for them."""
        self.configurations[mark] = mark

    def may_have(self, name: str) -> bool:
        """Whether a configuration is set, or one is whose name is not known, which may be this one."""
        return name in self.configurations or not all(map(is_known, self.configurations))

    def give(self, name: str, value: str, place: Place, *includes: Place) -> None:
        """Set an argument, for this file or for one that it includes."""
        self.configurations[name] = value
        self.origins[name] = Origin(value, place, (*self.lines, *includes), self.conditions)

    def leaked(self, name: str) -> Origin | None:
        """Where an argument has its value from, if certainly from a file that was included before and does not include this one."""
        origin = self.origins.get(name)
        if origin is None or origin.value != self.configurations.get(name) or not set(origin.conditions) <= set(self.conditions):
            return None
        return None if self.lines[: len(origin.lines)] == origin.lines else origin

    def moment(self) -> Moment:
        """Where launch is now."""
        return Moment(self.file, self.lines, self.conditions, self.held, self.loop)

    @contextmanager
    def resumed(self, moment: Moment, *, anew: bool = False) -> Iterator[None]:
        """What happens meanwhile was put off at a moment, and sees what has been set since; `anew`: a process has ended."""
        now, kept = self.moment(), (self.origins, self.anew)
        self._return_to(moment)
        self.origins, self.anew = {}, anew
        try:
            yield
        finally:
            self._return_to(now)
            self.origins, self.anew = kept

    def _return_to(self, moment: Moment) -> None:
        self.file, self.lines, self.conditions = moment.file, moment.lines, moment.conditions
        self.held, self.loop = moment.held, moment.loop

    def push_configurations(self) -> None:
        """Keep all configurations, of which namespace, remappings and parameters for all nodes are some."""
        self.kept.append(replace(self, configurations=dict(self.configurations), origins=dict(self.origins)))

    def pop_configurations(self) -> None:
        """Put back the configurations that were kept last.

        Raises:
            LaunchError: none were.
        """
        if not self.kept:
            raise LaunchError("scope", "PopLaunchConfigurations", "PopLaunchConfigurations: nothing was pushed before")
        kept = self.kept.pop()
        self.configurations, self.origins, self.remaps, self.params = kept.configurations, kept.origins, kept.remaps, kept.params
        self.namespace, self.is_in_namespace = kept.namespace, kept.is_in_namespace

    def push_environment(self) -> None:
        """Keep all environment variables."""
        self.environments.append(dict(self.environment))

    def pop_environment(self) -> None:
        """Put back the environment variables that were kept last.

        Raises:
            LaunchError: none were.
        """
        if not self.environments:
            raise LaunchError("scope", "PopEnvironment", "PopEnvironment: nothing was pushed before")
        self.environment = self.environments.pop()

    @contextmanager
    def scoped(self) -> Iterator[None]:
        """What changes meanwhile is put back."""
        self.push_configurations()
        self.push_environment()
        try:
            yield
        finally:
            self.pop_environment()
            self.pop_configurations()

    @contextmanager
    def within(self, *conditions: Condition) -> Iterator[None]:
        """What happens meanwhile happens under these conditions only."""
        kept = self.conditions
        self.conditions = (*kept, *(condition for condition in conditions if condition not in kept))
        try:
            yield
        finally:
            self.conditions = kept

    @contextmanager
    def since(self, condition: Condition) -> Iterator[None]:
        """What happens meanwhile happens since this condition holds."""
        kept = self.held
        self.held = (*kept, condition)
        try:
            yield
        finally:
            self.held = kept

    @contextmanager
    def included(self, file: str, place: Place) -> Iterator[None]:
        """The actions of another file, which is included at a line."""
        kept = self.file, self.lines
        self.file, self.lines = file, (*self.lines, place)
        try:
            yield
        finally:
            self.file, self.lines = kept


def _extended(items: list[Any], item: Any) -> list[Any]:
    """A list with one more item: the same list, unless there was none."""
    if not items:
        return [item]
    items.append(item)
    return items
