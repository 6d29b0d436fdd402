"""What a launch file comes to, as plain data."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.diagnostics import Diagnostic
from rosarch.extractor.launch.formulas import Formula, Not, possible
from rosarch.extractor.launch.names import ns_join

if TYPE_CHECKING:
    from rosarch.extractor.launch.bridges import BridgeFile
    from rosarch.extractor.launch.views import View
    from rosarch.extractor.urdf.hardware import HardwareInterface
    from rosarch.extractor.urdf.plugins import SimulatorPlugin
    from rosarch.extractor.urdf.robots import Robot


@dataclass(frozen=True, order=True)
class Place:
    """A line of a launch file."""

    path: str
    line: int
    column: int = 1

    def __str__(self) -> str:
        return f"{self.path}:{self.line}"


@dataclass(frozen=True)
class Condition:
    """An `if` (`holds`) or `unless`. One whose value cannot be known: what carries it is there in one of two alternatives.

    `text` is what is shown, `value` what it means.
    """

    text: str
    holds: bool
    place: Place
    value: Formula = field(repr=False)

    def __str__(self) -> str:
        return f"{'if' if self.holds else 'unless'} {self.text}"

    @property
    def formula(self) -> Formula:
        """What has to be so for the condition to hold."""
        return self.value if self.holds else Not(self.value)

    def contrary(self) -> Condition:
        """The condition that holds when this one does not."""
        return replace(self, holds=not self.holds)


def together(one: tuple[Condition, ...], other: tuple[Condition, ...]) -> bool | None:
    """Whether two things with these conditions can be there at once; None when it is not known."""
    return possible(tuple(dict.fromkeys(condition.formula for condition in (*one, *other))))


def exclusive(one: tuple[Condition, ...], other: tuple[Condition, ...]) -> bool:
    """Whether two things with these conditions are never there at once."""
    return bool(one and other) and together(one, other) is False


@dataclass(frozen=True)
class Remap:
    """One remapping, with names as written; `conditions` are those of the `<remap>` itself, not of the node that has it.

    With a `node`, it is for the nodes of a process that are called so; with `only`, for ports of this kind (topic, service).
    """

    source: str
    target: str
    place: Place
    conditions: tuple[Condition, ...] = ()
    node: str | None = None
    only: str | None = None


@dataclass(frozen=True)
class NodeStart:
    """A `<node>` or `<test>` that is started. `lines` lead from the launch file given to the line of the node.

    `namespace` begins and ends with a slash; `respawn_delay` is in seconds. `ros` is the version of ROS. Where a launch file of ROS 2 does
    not name a node, `called` is what it may be called and `given` what its process sets; with a `container` (its absolute name), `type` is
    a class that is loaded there. `params_files` are the files of parameters that it is given, `own_params` is what it is given itself,
    `process` what is set for all nodes of its process. Where its arguments decide what its program calls it, it `calls_itself` so. The
    container of a controller is its manager, a node like others. `conditions` are those that cannot be known, `held` those that are known
    to hold. `first` are the lines of the first node of this name, when this is another one. A node that another one makes is `inside` of
    the namespace of that, whose process it is in.
    """

    package: str
    type: str
    name: str | None
    namespace: str
    lines: tuple[Place, ...]
    remaps: tuple[Remap, ...] = ()
    args: str = ""
    respawn: bool = False
    respawn_delay: float = 0.0
    required: bool = False
    machine: str | None = None
    output: str | None = None
    cwd: str | None = None
    launch_prefix: str | None = None
    environment: tuple[tuple[str, str], ...] = ()
    conditions: tuple[Condition, ...] = ()
    test_name: str | None = None
    ros: int = 1
    called: str | None = None
    container: str | None = None
    held: tuple[Condition, ...] = ()
    first: tuple[Place, ...] = ()
    given: tuple[ProcessSetting, ...] = ()
    params_files: tuple[ParamsGiven, ...] = ()
    process: tuple[ProcessSetting, ...] = ()
    own_params: tuple[ParamSetting, ...] = ()
    is_controller: bool = False
    calls_itself: str | None = None
    inside: str | None = None

    @property
    def full_name(self) -> str:
        """The node's name in its namespace."""
        return self.namespace + (self.name or self.called or "")

    def by_its_own_name(self) -> NodeStart:
        """The node, called as it calls itself."""
        if self.calls_itself is None:
            return self
        new = replace(self, name=self.calls_itself)
        params = (replace(one, name=one.name.replace(f"{self.full_name}/", f"{new.full_name}/", 1)) for one in self.own_params)
        return replace(new, own_params=tuple(params))

    @property
    def own_remaps(self) -> tuple[Remap, ...]:
        """The remappings that hold for it: of several for one name the first."""
        found: list[Remap] = []
        settled: set[tuple[str, str | None]] = set()
        for remap in self.given_remaps:
            source = self.absolute(remap.source)
            if not {(source, None), (source, remap.only)} & settled:
                found.append(remap)
            if not remap.conditions:
                settled.add((source, remap.only))
        return tuple(found)

    def absolute(self, name: str) -> str:
        """A name as it is on the graph, before remapping."""
        return f"{self.full_name}/{name[1:]}" if name.startswith("~") else ns_join(self.namespace, name)

    @property
    def given_remaps(self) -> tuple[Remap, ...]:
        """The remappings that it is given: not those for other nodes of its process."""
        own = (None, self.name or self.called)
        return tuple(remap for remap in self.remaps if remap.node in own and not remap.source.startswith("__"))


@dataclass(frozen=True)
class ParamSetting:
    """A parameter and the value it is set to.

    `lines` lead to the element that sets it, `source` is the file the value is from, `written` its line in a YAML text.
    `robot` is what a value that is a robot description says.
    """

    name: str
    value: Any
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...] = ()
    source: str | None = None
    written: Place | None = None
    robot: Robot | None = None

    @property
    def place(self) -> Place:
        """Where the value is written."""
        return self.written or self.lines[-1]

    @property
    def plugins(self) -> tuple[SimulatorPlugin, ...]:
        """The simulator plugins of a robot."""
        return self.robot.plugins if self.robot else ()


@dataclass(frozen=True)
class ProcessSetting:
    """A parameter, by the name that nodes know it by, that is set for those nodes of a process whose full names match `nodes`.

    When it is not `read`, the file that it stands for could not be read.
    """

    nodes: str
    setting: ParamSetting
    read: bool = True


@dataclass(frozen=True)
class ParamsSection:
    """What a file of parameters says, at `place`, for the nodes that it calls `nodes`, whose full names match `expression`."""

    nodes: str
    expression: str
    place: Place


@dataclass(frozen=True)
class ParamsGiven:
    """The file of parameters at `path`, which a node of ROS 2 is given, be any of its sections for it or not."""

    path: str
    sections: tuple[ParamsSection, ...]


@dataclass(frozen=True)
class ControllerAsked:
    """The controller `name` is asked for, of the manager called `manager` (absolute)."""

    name: str
    manager: str
    place: Place


@dataclass(frozen=True)
class ArgumentDeclared:
    """An `<arg>` that the launch file at `path` declares; with a `value` it cannot be passed, without a `default` it must be."""

    path: str
    name: str
    value: str | None
    default: str | None
    place: Place


@dataclass(frozen=True)
class ArgumentPassed:
    """An `<arg>` that an `<include>`, at `include`, passes."""

    name: str
    value: str
    include: Place
    place: Place


@dataclass(frozen=True)
class World:
    """A simulated world, and the plugins that it loads. `lines` lead to what names its file."""

    file: str
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...]
    plugins: tuple[SimulatorPlugin, ...]


@dataclass(frozen=True)
class Include:
    """A launch file that is included; `file` is None when it is not known or cannot be read.

    `passes_all` is the attribute `pass_all_args`.
    """

    text: str
    file: str | None
    lines: tuple[Place, ...]
    conditions: tuple[Condition, ...] = ()
    passes_all: bool = False


@dataclass(frozen=True)
class Problem:
    """Something that roslaunch rejects (`fatal`) or that is not as it should be.

    `kind` and `subject` say what it is about (`package`, the name of a package), `message` says it to a reader. `meant` is a text
    there, and what was certainly meant by it.
    """

    kind: str
    subject: str
    message: str
    place: Place
    fatal: bool = True
    conditions: tuple[Condition, ...] = ()
    meant: tuple[str, str] | None = None

    def __str__(self) -> str:
        return f"{self.place.path}:{self.place.line}:{self.place.column}: {self.message}"


@dataclass(frozen=True)
class FileNamed:
    """An element names `file`; `role` is its attribute: include, rosparam, textfile, binfile, command, or value for any other text."""

    role: str
    file: str
    absent: bool
    place: Place


@dataclass(frozen=True)
class FileMeant:
    """With the arguments of this launch, an element means `file`.

    `role` is include, read (its content is used here), part (a robot description includes it), mesh or value. Of one that is `absent`,
    `beside` is a file of its kind in the same folder. One that is `made` is not among the sources, nor absent.
    """

    role: str
    file: str
    absent: bool
    place: Place
    beside: str | None = None
    made: bool = False


@dataclass(frozen=True)
class ProgramNamed:
    """A node or test runs `type` of `package`; `mentioned` when a file of the package is called so, or a build file says the word."""

    package: str
    type: str
    mentioned: bool
    place: Place


@dataclass(frozen=True)
class ComponentNamed:
    """A container loads the class `plugin` of `package`; `mentioned` when a build file of the package says its unqualified name."""

    package: str
    plugin: str
    mentioned: bool
    place: Place


@dataclass(frozen=True)
class PackageNamed:
    """An element names `package`; `folder` is None when it is not on the package path."""

    package: str
    folder: str | None
    place: Place


@dataclass(frozen=True)
class ArgumentUsed:
    """The text of an element uses the argument `name`."""

    name: str
    place: Place


@dataclass(frozen=True)
class HomePath:
    """An `attribute` of an `element`, or what it holds, names `path` below somebody's home folder."""

    element: str
    attribute: str
    path: str
    place: Place


@dataclass(frozen=True)
class TextTested:
    """What `perform` gives for the launch configuration `name`, a text, is taken for a truth value."""

    name: str
    place: Place


@dataclass(frozen=True)
class SubstitutionUsed:
    """What stands for the launch configuration `name` is taken for its value; `effect` is what comes of it."""

    name: str
    effect: str
    place: Place


@dataclass(frozen=True)
class Misjoined:
    """A path or command is put together wrongly, as `what` says."""

    what: str
    place: Place


@dataclass(frozen=True)
class ActionLeftOut:
    """An `action` is made and never used; `name` is the variable that holds it, "" for none."""

    action: str
    name: str
    place: Place


@dataclass(frozen=True)
class ArgumentLeaked:
    """The argument `name`, declared at `place`, has the `value` that a file included before gave it at `origin`, not its own default."""

    name: str
    value: str
    place: Place
    origin: Place


_OfArguments = ActionLeftOut | ArgumentLeaked | ArgumentUsed | Misjoined | SubstitutionUsed | TextTested
Reference = _OfArguments | FileNamed | FileMeant | ProgramNamed | ComponentNamed | PackageNamed | HomePath


@dataclass(frozen=True)
class Composition:
    """All that the launch files given start and set.

    `params` has one setting per parameter, and more only where conditions are unknown; `cleared` are namespaces whose parameters are
    removed first, `deleted` the parameters that `<rosparam command="delete">` removes. `unread` are namespaces that a YAML file which could
    not be read sets parameters in; the `source` of each is that file. `views` and `bridges` are the configurations that viewers and bridges
    are given, `commands` where events are emitted and commands run that are no nodes, `references` what the files read name, in all
    branches. `ros` is the version of ROS that they are for. `controllers` are nodes that launch knows nothing of: controllers that spawners
    ask for (`controllers_asked`), and the managers that simulators make. `hardware` is what robot descriptions export; there may be more
    when some is `unseen`.
    """

    nodes: tuple[NodeStart, ...]
    tests: tuple[NodeStart, ...]
    params: tuple[ParamSetting, ...]
    includes: tuple[Include, ...]
    problems: tuple[Problem, ...]
    files: tuple[str, ...]
    cleared: tuple[str, ...] = ()
    deleted: tuple[str, ...] = ()
    unread: tuple[ParamSetting, ...] = ()
    declared: tuple[ArgumentDeclared, ...] = ()
    passed: tuple[ArgumentPassed, ...] = ()
    remaps: tuple[Remap, ...] = ()
    worlds: tuple[World, ...] = ()
    views: tuple[View, ...] = ()
    bridges: tuple[BridgeFile, ...] = ()
    commands: tuple[Place, ...] = ()
    references: tuple[Reference, ...] = ()
    ros: int = 1
    controllers: tuple[NodeStart, ...] = ()
    controllers_asked: tuple[ControllerAsked, ...] = ()
    hardware: tuple[HardwareInterface, ...] = ()
    hardware_unseen: bool = False

    def with_controllers(self) -> Composition:
        """The composition as the graph has it.

        Its `controllers` are nodes with parameters, and nodes are called as they call themselves.
        """
        renamed = {f"{node.full_name}/" for node in self.nodes if node.calls_itself}
        renamed -= {f"{node.full_name}/" for node in self.nodes if not node.calls_itself}
        kept = (setting for setting in self.params if not any(setting.name.startswith(name) for name in renamed))
        nodes = tuple(node.by_its_own_name() for node in self.nodes)
        more = [*(node for node in nodes if node.calls_itself), *self.controllers]
        params = (setting for node in more for setting in node.own_params)
        return replace(self, nodes=(*nodes, *self.controllers), params=(*kept, *params), controllers=())

    @property
    def refusal(self) -> Problem | None:
        """What roslaunch would stop at."""
        return next((problem for problem in self.problems if problem.fatal and not problem.conditions), None)

    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """The problems, as other parts of the extractor report theirs, each in one line."""
        return tuple(
            Diagnostic(f"launch-{p.kind}", Path(p.place.path), p.place.line, p.place.column, p.message.replace("\n", "\\n"))
            for p in self.problems
        )


class LaunchError(Exception):
    """An element that is rejected; becomes a `Problem` at the element's place."""

    def __init__(self, kind: str, subject: str, message: str, meant: tuple[str, str] | None = None) -> None:
        super().__init__(message)
        self.kind, self.subject, self.message, self.meant = kind, subject, message, meant

    @property
    def is_limit(self) -> bool:
        """Whether a file is only not read here: roslaunch would read it."""
        return self.kind in ("outside", "size", "made")
