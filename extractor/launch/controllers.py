"""Controllers of ROS 1 that spawners have a controller manager load: each is taken for a node, in the manager's process.

The parameter `NAME/type` in the manager's namespace says of which class a controller is; what it has is below its own name there. Source:
ros_control (controller_manager.cpp, scripts/spawner, scripts/controller_manager), Indigo to Noetic.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence

from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.model import NodeStart, ParamSetting
from rosarch.extractor.launch.names import canonical, global_namespace, ns_join

_PACKAGE = "controller_manager"
_WITH_VALUE = ("--namespace", "--wait-for", "--timeout", "--shutdown-timeout")
"""Options that a word follows which is no controller."""


def controllers_of_spawners(nodes: Iterable[NodeStart], params: Iterable[ParamSetting]) -> Iterator[NodeStart]:
    """The controllers that are loaded; those of which the class is not known are left out."""
    spawners = [node for node in nodes if node.ros == 1 and node.package == _PACKAGE and node.type in ("spawner", _PACKAGE)]
    types: defaultdict[str, list[ParamSetting]] = defaultdict(list)
    for setting in params if spawners else ():
        types[setting.name].append(setting)
    found: dict[str, NodeStart] = {}
    for spawner in spawners:
        words = node_arguments(spawner).plain
        if spawner.type == _PACKAGE and words[:1] != ("spawn",):
            continue
        names, space = _read(words[1:] if spawner.type == _PACKAGE else words)
        namespace = global_namespace(ns_join(spawner.namespace, space)) if space else spawner.namespace
        for name in names:
            full = canonical(ns_join(namespace, name))
            given = types[f"{full}/type"]
            if len(given) == 1 and not given[0].conditions and isinstance(given[0].value, str) and "$(" not in full + given[0].value:
                found.setdefault(full, _controller(full, given[0].value, spawner, f"{canonical(namespace)}/{_PACKAGE}"))
    yield from found.values()


def _read(words: Sequence[str]) -> tuple[list[str], str]:
    """The controllers that a command line names, and the namespace of their manager."""
    names: list[str] = []
    space = ""
    rest = list(words)
    while rest:
        word, joined, value = rest.pop(0).partition("=")
        if word in _WITH_VALUE and (joined or rest):
            value = value if joined else rest.pop(0)
            space = value if word == "--namespace" else space
        elif not word.startswith("-"):
            names.append(word)
    return names, space


def _controller(full: str, type_: str, spawner: NodeStart, manager: str) -> NodeStart:
    namespace, _, name = full.rpartition("/")
    return NodeStart(
        package=type_.partition("/")[0],
        type=type_,
        name=name,
        namespace=f"{namespace}/",
        lines=spawner.lines,
        conditions=spawner.conditions,
        held=spawner.held,
        container=canonical(manager),
        is_controller=True,
    )
