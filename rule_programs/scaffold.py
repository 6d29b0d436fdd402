"""New files for your own rules: a check, a relation or the API of a library, with docs and a test that passes."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.whole import write_whole
from rosarch.datalog import load_declarations
from rosarch.datalog.language.parser import is_word
from rosarch.extractor.manifest import rules_folder
from rosarch.rule_programs.checks import Check, check_files, read_check
from rosarch.rule_programs.variants import RuleSetError

_FORMS = {
    "check": (r"[a-z][a-z0-9]*(-[a-z0-9]+)*", "small letters and digits with dashes between: `queue-too-short`"),
    "relation": (r"[a-z][a-z0-9]*(_[a-z0-9]+)*", "small letters and digits with underscores between: `answers_late`"),
    "api": (r"[a-z][a-z0-9_]*", "a C++ namespace in small letters: `my_library`"),
}


@dataclass(frozen=True)
class NewFile:
    """A file to be written."""

    path: Path
    text: str


def scaffold(kind: str, name: str, folder: Path) -> list[NewFile]:
    """The files of a new `kind` (check, relation, api) called `name` for a folder of rules; nothing is written.

    Raises:
        RuleSetError: the name has not the form of such names or is taken, or one of the files is there already.
    """
    form, told = _FORMS[kind]
    if not re.fullmatch(form, name):
        raise RuleSetError(f"`{name}` is no name for {'an' if kind == 'api' else 'a'} {kind}: {told}")
    relation = name.replace("-", "_")
    if kind != "api" and is_word(relation):
        raise RuleSetError(f"`{relation}` is a word of the language of rules and no name for a relation")
    _require_free(kind, name, relation)
    words = {"@NAME@": name, "@RELATION@": relation, "@FOLDER@": folder.as_posix()}
    templates = rules_folder() / "templates" / kind
    files = [
        NewFile(
            folder / _filled(path.relative_to(templates).as_posix().removesuffix(".in"), words), _filled(path.read_text("utf-8"), words)
        )
        for path in sorted(templates.rglob("*.in"))
    ]
    for file in files:
        if file.path.exists():
            raise RuleSetError(f"{file.path}: there is such a file already")
    return files


def write_scaffold(kind: str, name: str, folder: Path, page_of: Callable[[Check], str]) -> list[Path]:
    """Write the files of `scaffold`; those of a check have a page of documentation, which `page_of` makes from its head."""
    files = scaffold(kind, name, folder)
    for file in files:
        write_whole(file.path, file.text.encode())
    paths = [file.path for file in files]
    if kind == "check":
        page = folder / "docs" / f"{name}.md"
        write_whole(page, page_of(read_check(paths[0])).removeprefix("#").encode())
        paths.append(page)
    return paths


def _require_free(kind: str, name: str, relation: str) -> None:
    if kind == "check":
        for path in check_files():
            if path.stem == name:
                raise RuleSetError(f"there is a check `{name}` already, in {path}")
    if kind == "api":
        if (taken := rules_folder() / "api" / f"{name}.dl").is_file():
            raise RuleSetError(f"the API of `{name}` is known already, in {taken}")
        return
    for program in ("component.dl", "system.dl"):
        declared = load_declarations(rules_folder() / program).get(relation)
        if declared is not None:
            raise RuleSetError(f"there is a relation `{relation}` already, declared at {declared.location}")


def _filled(text: str, words: dict[str, str]) -> str:
    for word, value in words.items():
        text = text.replace(word, value)
    return text
