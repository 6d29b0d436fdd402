"""Contested decisions of the analysis, each with several answers: files of rules in `rules/variants/<decision>/`, found on disk.

`interface.dl` there declares what every variant derives. The rules of components or of systems include the variant that is the default.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from rosarch.base.hints import hint
from rosarch.extractor.manifest import rules_folder

FOLDER = "variants"
INTERFACE = "interface"
PROGRAMS = ("component", "system")
_INCLUDED = re.compile(rf'^\.include "{FOLDER}/([\w-]+)/([\w-]+)\.dl"', re.MULTILINE)


class RuleSetError(ValueError):
    """Rules, variants or options that cannot be used; the text says which, where and why."""


@dataclass(frozen=True)
class Variant:
    """One answer to a decision; `doc` is what the head of its file says."""

    name: str
    doc: str
    path: Path


@dataclass(frozen=True)
class Decision:
    """A question that the rules of `program` answer by one of several files; `default` is the one they include."""

    name: str
    program: str
    doc: str
    default: Path
    variants: tuple[Variant, ...]

    def find(self, name: str) -> Variant | None:
        """The variant of a name."""
        return next((variant for variant in self.variants if variant.name == name), None)


def decisions(own: Sequence[Path] = ()) -> tuple[Decision, ...]:
    """All decisions, by name, with their variants: those that ship, and those in `<folder>/variants` of the user's own folders.

    A variant of the user's own takes the place of one of the same name.

    Raises:
        RuleSetError: a folder of the user's own is named after no decision.
    """
    known = {name: (program, default) for program in PROGRAMS for name, default in _defaults(program)}
    folders = [rules_folder() / FOLDER, *(folder / FOLDER for folder in own if (folder / FOLDER).is_dir())]
    for folder in folders[1:]:
        for inside in sorted(path for path in folder.iterdir() if path.is_dir()):
            if inside.name not in known:
                raise RuleSetError(f"{inside}: there is no decision `{inside.name}`{hint(inside.name, known)}")
    return tuple(
        Decision(name, program, head_comment(default.parent / f"{INTERFACE}.dl"), default, _variants([f / name for f in folders]))
        for name, (program, default) in sorted(known.items())
    )


@lru_cache(maxsize=2)
def _defaults(program: str) -> tuple[tuple[str, Path], ...]:
    text = (rules_folder() / f"{program}.dl").read_text(encoding="utf-8")
    included = ((match[1], match[2]) for match in _INCLUDED.finditer(text))
    return tuple((decision, rules_folder() / FOLDER / decision / f"{name}.dl") for decision, name in included if name != INTERFACE)


def _variants(folders: Iterable[Path]) -> tuple[Variant, ...]:
    paths = {path.stem: path for folder in folders for path in sorted(folder.glob("*.dl"))}
    paths.pop(INTERFACE, None)
    return tuple(Variant(name, head_comment(path), path) for name, path in sorted(paths.items()))


def head_comment(path: Path) -> str:
    """What the comment at the head of a file says."""
    lines = []
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        if not line.startswith("//") or line.startswith("///"):
            break
        lines.append(line.removeprefix("//").strip())
    return " ".join(lines)
