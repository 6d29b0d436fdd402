"""Graph resource names as roslaunch joins and checks them (wiki.ros.org/Names; rosgraph.names)."""

from __future__ import annotations

import re

_LEGAL = re.compile(r"[~/A-Za-z][\w/]*")
_REMAP = re.compile(r"([~/A-Za-z]|_|__)[\w/]*:=.*")


def ns_join(namespace: str, name: str) -> str:
    """`name` within `namespace`; a private or global name is kept as it is."""
    if name.startswith(("~", "/")):
        return name
    if namespace == "~":
        return "~" + name
    if not namespace:
        return name
    return namespace + name if namespace.endswith("/") else f"{namespace}/{name}"


def global_namespace(name: str) -> str:
    """`name` with a slash at both ends.

    Raises:
        ValueError: the name is private.
    """
    if name.startswith("~"):
        raise ValueError(f"cannot turn `{name}` into a global name")
    name = name if name.startswith("/") else "/" + name
    return name if name.endswith("/") else name + "/"


def canonical(name: str) -> str:
    """`name` without doubled and final slashes."""
    if not name or name == "/":
        return name
    joined = "/".join(part for part in name.split("/") if part)
    return "/" + joined if name.startswith("/") else joined


def is_legal(name: str) -> bool:
    """Whether ROS accepts `name`; the empty one names a namespace."""
    return not name or (_LEGAL.fullmatch(name) is not None and "//" not in name)


def parents(name: str) -> list[str]:
    """`/`, `/a`, `/a/b` of `/a/b/c`."""
    parts = [part for part in name.split("/") if part]
    return ["/", *("/" + "/".join(parts[:count]) for count in range(1, len(parts)))]


def mapping(text: str) -> tuple[str, str] | None:
    """`a:=b` as a pair, when ROS takes the text for a mapping that is no parameter (`_p:=v`)."""
    if not _REMAP.fullmatch(text):
        return None
    parts = [part.strip() for part in text.split(":=")]
    if len(parts) != 2 or not all(parts) or (len(parts[0]) > 1 and parts[0][0] == "_" and parts[0][1] != "_"):
        return None
    return parts[0], parts[1]
