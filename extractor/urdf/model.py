"""What evaluating a xacro file comes to, as plain data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from rosarch.extractor.launch.model import Place, Problem

if TYPE_CHECKING:
    from rosarch.extractor.urdf.document import Document


PREFIX = "xacro:"


@dataclass(frozen=True)
class Dialect:
    """How a release of xacro reads files.

    `in_order`: definitions count from where they stand on; otherwise includes, macros and properties are collected first. `prefixed`: only
    tags with `xacro:` are xacro's, macros have scopes, and a text that says `true` is a Boolean.
    """

    in_order: bool
    prefixed: bool


TRADITIONAL = Dialect(in_order=False, prefixed=False)  # up to Lunar, unless --inorder is given
IN_ORDER = Dialect(in_order=True, prefixed=False)  # Jade to Lunar with --inorder, and Melodic
NOETIC = Dialect(in_order=True, prefixed=True)


class XacroError(Exception):
    """What xacro rejects; becomes a `Problem` at the element that is evaluated."""

    def __init__(self, message: str, subject: str = "xacro") -> None:
        super().__init__(message)
        self.message, self.subject = message, subject


@dataclass(frozen=True)
class Expansion:
    """What xacro makes of a file.

    `document` is None when the file is rejected, which the last of `problems` then reports. `bare_tags` says that tags without `xacro:`
    were left as they are although an older xacro takes them for its own. `work` is what it cost, `files` are those that were read, `meant`
    those that it includes from where packages are installed.
    It is `incomplete` when something was left out that is not known, such as a file that is missing.
    """

    document: Document | None
    problems: tuple[Problem, ...]
    files: tuple[str, ...]
    bare_tags: bool
    work: int
    incomplete: bool
    meant: tuple[tuple[str, Place], ...] = ()
