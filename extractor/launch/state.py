"""What is collected while launch files are composed, and the steps that all elements share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.formulas import Test, truth
from rosarch.extractor.launch.model import (
    ArgumentDeclared,
    ArgumentPassed,
    Condition,
    ControllerAsked,
    Include,
    LaunchError,
    NodeStart,
    ParamSetting,
    Place,
    Problem,
    Remap,
    World,
    exclusive,
    together,
)
from rosarch.extractor.launch.names import parents
from rosarch.extractor.launch.scope import Scope, settle
from rosarch.extractor.launch.substitution import Resolver
from rosarch.extractor.launch.unknowns import Unknowns, is_known
from rosarch.extractor.launch.values import boolean
from rosarch.extractor.launch.xml_reader import Element

if TYPE_CHECKING:
    from rosarch.extractor.urdf.hardware import HardwareInterface

MAX_ELEMENTS = 500_000  # processed in one composition, included files counted each time
MAX_PARAMS = 500_000
MAX_CHARACTERS = 64 * 1024 * 1024  # of all texts resolved and read
YAML_COST = 16  # reading YAML takes as long as resolving so many times its text
PART_COST = 64  # so does looking at a part of a list, which others may hold, and itself

_MEANT = frozenset(map(frozenset, (("from", "to"), ("pkg", "type"), ("name", "value"))))
"""Attributes that elements of roslaunch have together."""


class Exhausted(Exception):
    """The launch files unfold to more than is composed."""


class State:
    """One composition in progress. `here` and `scope` are those of the element that is processed, for reports."""

    def __init__(self, files: Files, environment: Mapping[str, str]) -> None:
        self.files = files
        self.unknowns = Unknowns()
        self.resolver = Resolver(files.packages, environment, self.unknowns, self)
        self.nodes: list[NodeStart] = []
        self.tests: list[NodeStart] = []
        self.params: dict[str, list[ParamSetting]] = {}
        self.unread: list[ParamSetting] = []
        self.worlds: dict[str, World] = {}
        self.meshes: dict[tuple[str, Place], None] = {}
        self.parts: dict[tuple[str, Place], None] = {}
        self.commands: dict[Place, None] = {}
        self.includes: list[Include] = []
        self.declared: list[ArgumentDeclared] = []
        self.passed: list[ArgumentPassed] = []
        self.remaps: list[Remap] = []
        self.include = Place("", 1)  # the one whose arguments are read
        self.problems: dict[Problem, None] = {}
        self.read: dict[str, None] = {}
        self.written: dict[str, str] = {}  # the texts of files that launch files write
        self.cleared: list[str] = []
        self.deleted: list[str] = []
        self.machines: dict[str, tuple[object, ...]] = {"": ("this computer",)}
        self.default_machine: str | None = None
        self.controllers: list[NodeStart] = []
        self.controllers_asked: list[ControllerAsked] = []
        self.hardware: dict[HardwareInterface, None] = {}
        self.hardware_unseen = False
        self.named: dict[str, list[NodeStart]] = {}
        self.started_anew: set[tuple[str, Place]] = set()
        self.here = Place("", 1)
        self.scope = Scope("/", "")
        self.own_conditions: tuple[Condition, ...] = ()
        self.elements = 0
        self.settings = 0
        self.characters = 0

    def enter(self, element: Element, scope: Scope) -> None:
        """Make `element` the one that reports are about.

        Raises:
            Exhausted: too many elements were processed.
        """
        self.count()
        self.at(element, scope)

    def count(self) -> None:
        """Count an element, or an action, that is processed.

        Raises:
            Exhausted: there were too many.
        """
        self.elements += 1
        if self.elements > MAX_ELEMENTS:
            raise Exhausted(f"more than {MAX_ELEMENTS} elements, the rest is left out")

    def spend(self, characters: int) -> None:
        """Count a text that was made.

        Raises:
            Exhausted: all of them together are too long.
        """
        self.characters += characters
        if self.characters > MAX_CHARACTERS:
            raise Exhausted(f"more than {MAX_CHARACTERS // 2**20} Mi characters of text, the rest is left out")

    def at(self, element: Element, scope: Scope, conditions: tuple[Condition, ...] = ()) -> None:
        """Report what follows at `element`, which has unknown `conditions` of its own."""
        self.here, self.scope, self.own_conditions = Place(self.path_of(scope), element.line, element.column), scope, conditions

    def path_of(self, scope: Scope) -> str:
        """The file that `scope` is in, as it is shown."""
        return self.unknowns.render(scope.filename)

    def report(self, error: LaunchError, fatal: bool = True, place: Place | None = None) -> None:
        """Note a problem, once: at the present element, unless it has a place of its own."""
        render = self.unknowns.render
        conditions = self.scope.conditions + self.own_conditions
        problem = Problem(error.kind, render(error.subject), render(error.message), place or self.here, fatal, conditions, error.meant)
        self.problems.setdefault(problem)

    def report_unread(self, error: LaunchError) -> None:
        """Note why a file is not read; what is not read here only is no fault of the launch file."""
        self.report(error, fatal=not error.is_limit)

    def warn(self, kind: str, subject: str, message: str, place: Place | None = None) -> None:
        """Note something that roslaunch only warns of."""
        self.report(LaunchError(kind, subject, message), fatal=False, place=place)

    def ignore(self, element: Element, parent: Element) -> None:
        """Note an element that roslaunch passes over; one with the attributes of another was meant to be that."""
        kind = "unknown-element" if _MEANT.isdisjoint(map(frozenset, combinations(sorted(element.attributes), 2))) else "mistaken-element"
        self.warn(kind, element.tag, f"<{element.tag}> in <{parent.tag}> is ignored")

    def text(self, element: Element, name: str, scope: Scope) -> str | None:
        """An attribute, resolved; None when it is not there."""
        raw = element.attributes.get(name)
        return None if raw is None else self.resolver.resolve(raw, scope)

    def required(self, element: Element, name: str, scope: Scope) -> str:
        """An attribute that must be there, resolved.

        Raises:
            LaunchError: it is not there.
        """
        value = self.text(element, name, scope)
        if value is None:
            raise LaunchError("attribute", name, f"<{element.tag}> has no attribute `{name}`")
        return value

    def flag(self, text: str | None, label: str) -> bool:
        """A `true` or `false` attribute; what is neither is reported and taken for false."""
        if text is None or self.unknowns.is_open(text):
            return False
        if text.lower() not in ("true", "false"):
            self.report(LaunchError("bool", label, f"`{text}` is not true or false, which `{label}` must be"))
        return text.lower() == "true"

    def check_attributes(self, element: Element, known: Iterable[str]) -> None:
        """Warn of attributes that roslaunch does not know."""
        for name in element.attributes:
            if name not in known and name not in ("if", "unless"):
                self.warn("unknown-attribute", name, f"<{element.tag}> has no attribute `{name}`, it is ignored")

    def conditions(self, element: Element, scope: Scope) -> tuple[Condition, ...] | None:
        """None when `if` or `unless` leave the element out; a condition when that cannot be known.

        Raises:
            LaunchError: both are there, or the value is not a Boolean.
        """
        if "if" not in element.attributes and "unless" not in element.attributes:
            return ()
        texts = [self.text(element, name, scope) for name in ("if", "unless")]
        if None not in texts:
            raise LaunchError("condition", "if unless", f"<{element.tag}> has both `if` and `unless`")
        holds = texts[0] is not None
        text = texts[0] if texts[0] is not None else texts[1] or ""
        if self.unknowns.is_open(text):
            return self._unknown_condition(text, holds, scope)
        try:
            return () if boolean(text) is holds else None
        except ValueError as error:
            raise LaunchError("condition", text, f"{'if' if holds else 'unless'}: {error}") from None

    def condition_written(self, element: Element) -> tuple[Condition, ...]:
        """The `if` or `unless` of an element, as written."""
        found = [(name, element.attributes[name]) for name in ("if", "unless") if name in element.attributes]
        return tuple(Condition(text, name == "if", self.here, Test(text)) for name, text in found)

    def _unknown_condition(self, text: str, holds: bool, scope: Scope) -> tuple[Condition, ...] | None:
        """A condition is new unless the element is already within the same one, or within its contrary."""
        condition = Condition(self.unknowns.render(text), holds, self.here, truth(self.unknowns, text))
        if exclusive(scope.conditions, (condition,)):
            return None
        if exclusive(scope.conditions, (condition.contrary(),)):
            return ()
        self.own_conditions = (condition,)
        return self.own_conditions

    def set_param(self, setting: ParamSetting) -> None:
        """Set a parameter.

        Raises:
            Exhausted: too many parameters were set.
        """
        self.settings += 1
        if self.settings > MAX_PARAMS:
            raise Exhausted(f"more than {MAX_PARAMS} parameters, the rest is left out")
        for parent in parents(setting.name):
            if parent in self.params and parent != setting.name:
                self.warn("param-conflict", setting.name, f"parameter `{setting.name}` lies below parameter `{parent}`, which has a value")
        settle(self.params, setting)

    def add_node(self, node: NodeStart, fatal: bool = True, *, anew: bool = False) -> None:
        """Start a node; two of one name are rejected, or (not `fatal`) only reported, unless they are alternatives, or may be.

        `anew`: when another process has ended; the node of the same line is started again then.
        """
        others = [] if not node.name or self.unknowns.is_open(node.full_name) else self.named.setdefault(node.full_name, [])
        other = next((other for other in others if together(node.conditions, other.conditions)), None)
        if anew:
            self.started_anew.add((node.full_name, node.lines[-1]))
        if other is not None and other.lines[-1] == node.lines[-1] and (node.full_name, node.lines[-1]) in self.started_anew:
            return
        self.nodes.append(node if other is None else replace(node, first=other.lines))
        if other is not None:
            message = f"a second node `{node.full_name}`, the first is at {other.lines[-1]}"
            self.report(LaunchError("duplicate-node", node.full_name, message), fatal)
        others.append(node)


def written_files(state: State) -> dict[str, str]:
    """The texts of files that launch files write, by their paths as they are shown: those that are known."""
    return {state.unknowns.render(path): text for path, text in state.written.items() if is_known(text)}


Handler = Callable[[State, Element, Scope], None]
