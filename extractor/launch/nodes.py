"""The elements that start something: node and test."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from rosarch.extractor.launch import elements
from rosarch.extractor.launch.descriptions import note_worlds
from rosarch.extractor.launch.model import Condition, LaunchError, NodeStart
from rosarch.extractor.launch.names import canonical, global_namespace, is_legal, ns_join
from rosarch.extractor.launch.scope import Scope
from rosarch.extractor.launch.state import State
from rosarch.extractor.launch.unknowns import with_unknowns_as
from rosarch.extractor.launch.xml_reader import Element

_NODE_ATTRIBUTES = (
    *("pkg", "type", "machine", "name", "args", "output", "respawn", "respawn_delay", "cwd", "ns", "clear_params"),
    *("launch-prefix", "required"),
)
_TEST_ATTRIBUTES = (*_NODE_ATTRIBUTES, "test-name", "time-limit", "retry")


def node(state: State, element: Element, scope: Scope) -> None:
    """`<node>`: a node is started.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, _NODE_ATTRIBUTES)
    name = state.required(element, "name", scope)
    started = _start(state, element, scope, name, conditions)
    state.at(element, scope, conditions)
    note_worlds(state, started.args.split(), scope.lines, scope.conditions)
    state.add_node(started)


def test(state: State, element: Element, scope: Scope) -> None:
    """`<test>`: a node that rostest starts.

    Raises:
        LaunchError: it is rejected.
    """
    conditions = state.conditions(element, scope)
    if conditions is None:
        return
    state.check_attributes(element, _TEST_ATTRIBUTES)
    name = state.text(element, "name", scope)
    for attribute in ("respawn", "respawn_delay", "output"):
        if attribute in element.attributes:
            raise LaunchError("attribute", attribute, f"<test> must not have an attribute `{attribute}`")
    test_name = state.required(element, "test-name", scope)
    limit, retry = state.text(element, "time-limit", scope), state.text(element, "retry", scope)
    if limit and not state.unknowns.is_open(limit) and not _is_positive(limit):
        raise LaunchError("number", "time-limit", f"`{limit}` is not a positive number, which `time-limit` must be")
    if retry and not state.unknowns.is_open(retry) and not _is_int(retry):
        raise LaunchError("number", "retry", f"`{retry}` is not a number, which `retry` must be")
    started = _start(state, element, scope, name or test_name, conditions)
    state.tests.append(replace(started, test_name=test_name, output="log"))


def namespace_of(state: State, element: Element, scope: Scope, conditions: tuple[Condition, ...], node_name: str | None = None) -> Scope:
    """The scope within an element with the attributes `ns` and `clear_params`.

    Raises:
        LaunchError: the namespace is empty or private.
    """
    namespace = state.text(element, "ns", scope)
    if namespace == "":
        raise LaunchError("namespace", "", f"<{element.tag}> has an empty `ns`")
    child = scope.child(namespace, conditions)
    if not conditions:
        child.held += state.condition_written(element)
    if state.flag(state.text(element, "clear_params", scope) or None, "clear_params"):
        if node_name is None and namespace is None:
            raise LaunchError("clear-params", element.tag, f"<{element.tag}> needs an attribute `ns` for `clear_params`")
        if node_name == "":
            raise LaunchError("clear-params", element.tag, f"<{element.tag}> needs an attribute `name` for `clear_params`")
        cleared = child.namespace if node_name is None else ns_join(child.namespace, node_name)
        try:
            state.cleared.append(state.unknowns.render(global_namespace(cleared)))
        except ValueError as error:
            raise LaunchError("namespace", cleared, str(error)) from None
    return child


@dataclass(frozen=True)
class _Attributes:
    """The attributes of a node that are texts of their own."""

    package: str
    type: str
    optional: Mapping[str, str | None]
    required: bool
    respawn: bool
    respawn_delay: float


def _start(state: State, element: Element, scope: Scope, name: str, conditions: tuple[Condition, ...]) -> NodeStart:
    if not is_legal(with_unknowns_as("x", name)):
        state.warn("illegal-name", name, f"`{name}` is no legal name of a node")
    outer = namespace_of(state, element, scope, conditions, name)
    inner = outer.child(name)
    inner.private = []
    found = _attributes(state, element, scope)
    lines = (*scope.lines, state.here)
    below = replace(scope.child(None, conditions), lines=lines)
    inner.lines = lines
    _children(state, element, scope, inner, below)
    state.at(element, scope, conditions)
    for setting in (*scope.private, *inner.private):
        key = canonical(inner.namespace + setting.name.removeprefix("~"))
        state.set_param(replace(setting, name=key, conditions=_joined(inner.conditions, setting.conditions)))
    namespace = "/" + "/".join([*filter(None, outer.namespace.split("/")), ""]) if outer.namespace.strip("/") else "/"
    started = NodeStart(
        package=found.package,
        type=found.type,
        name=name or None,
        namespace=namespace,
        lines=lines,
        remaps=tuple(below.all_remaps()),
        args=found.optional["args"] or "",
        respawn=found.respawn,
        respawn_delay=found.respawn_delay,
        required=found.required,
        machine=found.optional["machine"] or state.default_machine,
        output=found.optional["output"],
        cwd="ROS_HOME" if found.optional["cwd"] == "ros_home" else found.optional["cwd"],
        launch_prefix=found.optional["launch-prefix"] or None,
        environment=tuple(below.environment),
        conditions=outer.conditions,
        held=outer.held,
    )
    _check(state, started)
    return started


def _attributes(state: State, element: Element, scope: Scope) -> _Attributes:
    package, kind = state.required(element, "pkg", scope), state.required(element, "type", scope)
    names = ("machine", "args", "output", "respawn", "respawn_delay", "cwd", "launch-prefix", "required")
    optional = {name: state.text(element, name, scope) for name in names}
    required, respawn = state.flag(optional["required"], "required"), state.flag(optional["respawn"], "respawn")
    delay = optional["respawn_delay"]
    if delay is not None and not state.unknowns.is_open(delay) and not _is_float(delay):
        state.report(LaunchError("number", "respawn_delay", f"`{delay}` is not a number, which `respawn_delay` must be"))
    seconds = float(delay) if delay is not None and _is_float(delay) else 0.0
    return _Attributes(package, kind, optional, required, respawn, seconds)


def _children(state: State, element: Element, scope: Scope, inner: Scope, below: Scope) -> None:
    """Parameters go to `inner`, the scope of the node's own names; remappings and variables to `below`."""
    for child in element.children:
        state.enter(child, inner)
        tag = child.tag.lower()
        try:
            if tag == "remap":
                elements.remap(state, child, scope, below)
            elif tag == "param":
                elements.param(state, child, inner, private=True)
            elif tag == "rosparam":
                elements.rosparam(state, child, inner)
            elif tag == "env":
                elements.env(state, child, below)
            else:
                state.ignore(child, element)
        except LaunchError as error:
            state.report(error)


def _joined(outer: tuple[Condition, ...], inner: tuple[Condition, ...]) -> tuple[Condition, ...]:
    return (*outer, *(condition for condition in inner if condition not in outer))


def _check(state: State, started: NodeStart) -> None:
    """Report what roslaunch rejects in a node as a whole."""
    if started.respawn and started.required:
        state.report(LaunchError("node", "respawn required", "a node cannot be both `respawn` and `required`"))
    if "/" in (started.name or ""):
        state.report(LaunchError("node", "name", f"the name `{started.name}` of a node must not have a namespace; use `ns`"))
    for value, label in ((started.package, "pkg"), (started.type, "type")):
        if not value.strip():
            state.report(LaunchError("node", label, f"`{label}` of a node must not be empty"))
    if started.output not in ("log", "screen", None) and not state.unknowns.is_open(started.output):
        state.report(LaunchError("node", "output", f"`output` must be log or screen, not `{started.output}`"))
    if started.cwd not in ("ROS_HOME", "node", None) and not state.unknowns.is_open(started.cwd):
        state.report(LaunchError("node", "cwd", f"`cwd` must be ROS_HOME or node, not `{started.cwd}`"))


def _is_float(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _is_positive(text: str) -> bool:
    return _is_float(text) and float(text) > 0


def _is_int(text: str) -> bool:
    try:
        int(text)
    except ValueError:
        return False
    return True
