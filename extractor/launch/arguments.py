"""What the command line of a node means: `args` of `<node>`, then its remappings, as roslaunch puts them together.

A later word overrides an earlier one of the same name. roslaunch adds `__name:=` last, so one in `args` has no effect, and a `<remap>`
overrides the same name in `args`. Sources: roslaunch.node_args, ros::init of roscpp.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from functools import lru_cache

from rosarch.extractor.launch.model import NodeStart


@dataclass(frozen=True)
class NodeArguments:
    """`words` are all words of `args`, `plain` those that are no assignments (`load`, `manager`, `--rate`).

    `remaps` are pairs of names and `params` pairs of a private name without `~` and the text of its value, from `args` alone. `namespace`
    is that of `__ns:=`. A text that cannot be split is one word.
    """

    words: tuple[str, ...]
    plain: tuple[str, ...]
    remaps: tuple[tuple[str, str], ...]
    params: tuple[tuple[str, str], ...]
    namespace: str | None = None


@lru_cache(maxsize=1000)
def _split(text: str) -> tuple[str, ...]:
    try:
        return tuple(shlex.split(text))
    except ValueError:
        return (text,)


def node_arguments(node: NodeStart) -> NodeArguments:
    """The meaning of `node.args`."""
    words = _split(node.args)
    if node.ros == 2:  # what `--ros-args` says was taken out where the node is started
        return NodeArguments(words, words, (), ())
    plain: list[str] = []
    remaps: dict[str, str] = {}
    params: dict[str, str] = {}
    special: dict[str, str] = {}
    for word in words:
        name, assigned, value = word.partition(":=")
        if not assigned or not name:
            plain.append(word)
        elif name.startswith("__"):
            special[name] = value
        elif name.startswith("_"):
            params[name[1:]] = value
        else:
            remaps[name] = value
    for remap in node.remaps:
        if not remap.conditions:
            remaps.pop(remap.source, None)
    return NodeArguments(words, tuple(plain), tuple(remaps.items()), tuple(params.items()), special.get("__ns"))
