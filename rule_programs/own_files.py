"""Files of rules of the user's own: found below folders, and distinguished by the program whose relations they use."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.checks import is_check
from rosarch.rule_programs.variants import FOLDER, PROGRAMS, RuleSetError

ASIDE = (FOLDER, "tests")
"""Folders whose files are no part of the program by themselves."""

_SKIPPED = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_DECLARED = re.compile(r"^[ \t]*\.(?:decl|init)[ \t]+([\w, \t]+)", re.MULTILINE)
_INCLUDE = re.compile(r'^\.include "([^"]+)"', re.MULTILINE)
_USED = re.compile(r"(?<![\w.$@?])([a-z_]\w*)(?:\.\w+)*\s*\(")


def own_files(paths: Iterable[Path]) -> list[Path]:
    """The files of rules that `paths` are or hold.

    Raises:
        RuleSetError: a path does not exist, or a folder holds none.
    """
    found: list[Path] = []
    for path in paths:
        if os.path.isdir(path):
            below = sorted(file for file in path.rglob("*.dl") if not set(file.relative_to(path).parts[:-1]) & set(ASIDE))
            if not below and not os.path.isdir(path / FOLDER):
                raise RuleSetError(f"{path}: no file of rules (*.dl) in this folder")
            found += below
        elif os.path.isfile(path):
            found.append(path)
        else:
            raise RuleSetError(f"{path}: {'neither a file nor a folder' if os.path.exists(path) else 'no such file or folder'}")
    return list(dict.fromkeys(found))


def own_programs(files: Sequence[Path]) -> Mapping[str, tuple[Path, ...]]:
    """The files that belong to the rules of components, and those that belong to the rules of systems; a file may belong to both.

    It does to the program whose relations it uses, and to that of the files whose relations it uses. A check is about systems.

    Raises:
        RuleSetError: a file uses relations that only the one and relations that only the other has.
    """
    shipped = {program: _shipped(program) for program in PROGRAMS}
    texts = {file: _code(file) for file in files}
    uses = {file: set(_USED.findall(text)) for file, text in texts.items()}
    owners = {name: file for file, text in texts.items() for name in _declared(text)}
    fits = {file: {p for p in PROGRAMS if not any(_only(name, p, shipped) for name in uses[file] - owners.keys())} for file in files}
    for file in files:
        if not fits[file]:
            raise RuleSetError(_mixed(file, texts[file], shipped))
        if is_check(file):
            fits[file] = {"system"}
    changed = True
    while changed:
        changed = False
        for file in files:
            for other in {owners[name] for name in uses[file] & owners.keys()} - {file}:
                common = fits[file] & fits[other]
                if common and common != fits[file]:
                    fits[file], changed = common, True
    return {program: tuple(file for file in files if program in fits[file]) for program in PROGRAMS}


def _only(name: str, program: str, shipped: Mapping[str, frozenset[str]]) -> bool:
    """Whether a relation is one of another program alone."""
    return name not in shipped[program] and any(name in names for names in shipped.values())


def _mixed(file: Path, text: str, shipped: Mapping[str, frozenset[str]]) -> str:
    first = {p: next((m for m in _USED.finditer(text) if _only(m[1], p, shipped)), None) for p in PROGRAMS}
    system, component = first["component"], first["system"]
    assert system is not None and component is not None
    line = text.count("\n", 0, system.start()) + 1
    column = system.start() - text.rfind("\n", 0, system.start())
    return f"{file}:{line}:{column}: `{system[1]}` is a relation of systems, `{component[1]}` one of components; a file can use either"


def _code(file: Path) -> str:
    """The text with blanks for comments and texts."""
    text = file.read_text(encoding="utf-8", errors="replace")
    return _SKIPPED.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def _declared(code: str) -> set[str]:
    return {name.strip() for match in _DECLARED.finditer(code) for name in match[1].split(",") if name.strip()}


@lru_cache(maxsize=2)
def _shipped(program: str) -> frozenset[str]:
    """The relations of a program, and the instances of components in it."""
    names: set[str] = set()
    waiting, seen = [rules_folder() / f"{program}.dl"], set()
    while waiting:
        path = waiting.pop()
        if path not in seen and os.path.isfile(path):
            seen.add(path)
            text = path.read_text(encoding="utf-8")
            names |= _declared(_SKIPPED.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text))
            waiting += [path.parent / name for name in _INCLUDE.findall(text)]
    return frozenset(names)
