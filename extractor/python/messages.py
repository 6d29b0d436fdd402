"""Classes of messages by the modules that they are in."""

from __future__ import annotations

import re

_OWN_MODULE = re.compile(r"(\w+\.(?:msg|srv|action))\._\w+")


def interface_module(name: str) -> str:
    """`pkg.msg` for a module below it that generators write for a message, `pkg.msg._image` or `pkg.msg._Image`; any other as it is."""
    of_one = _OWN_MODULE.fullmatch(name)
    return of_one[1] if of_one else name


def message_of(name: str) -> tuple[str, str] | None:
    """Kind and type of the message that a class is by its name, as generators of Python code give them."""
    module, separator, names = name.partition("::")
    package, dot, part = module.rpartition(".")
    if not (separator and dot) or "." in package:
        return None
    outer, _, inner = names.partition("::")
    if part == "msg":
        return None if inner else ("message", f"{package}/{outer}")  # within a message there are constants only
    if part == "srv":
        for role in ("Request", "Response"):
            if inner == role or (not inner and outer.endswith(role)):
                return role.lower(), f"{package}/{outer if inner else outer.removesuffix(role)}"
        return None if inner else ("service", f"{package}/{outer}")
    if part == "cfg":
        return "config", f"{package}/{outer}"
    if part == "action":
        return "action" if not inner else "message", f"{package}/{outer}{inner}"
    return None
