"""The checks: files of rules with a block of fields at the head, found on disk."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from textwrap import dedent

from rosarch.base.hints import hint
from rosarch.extractor.manifest import rules_folder

SEVERITIES = ("error", "warning", "note")
LEVELS = ("high", "medium", "low")
FIELDS = ("id", "title", "help", "impact", "confidence", "description", "scenario", "recommendation", "message", "at", "evidence")
CHANGE = ("at", "written", "meant")
"""The last columns of a relation that says how findings are to be fixed; those before it are columns of the check."""
_OPTIONAL = {"evidence"}
_FIELD = re.compile(r"// ?([a-z]+):(?: (.*))?")
_COLUMN = re.compile(r"\{(\w+)\}")
_WORD = re.compile(r"(?<=[a-z0-9])(?=[A-Z])")
_DECLARATION = re.compile(r"\.decl (\w+)\(([^)]*)\)")


@dataclass(frozen=True)
class Check:
    """A check, as the block of fields at the head of its file `rules/checks/<id>.dl` describes it.

    `message` has the columns of the relation `relation` in braces. `evidence` are columns that have a place, each with a text of the same
    form ("" for the usual one): first that of the fault, then those that say how it comes about. `columns` are names and types.
    `fix_columns` are those of the relation `<relation>_fix`, which says how findings are to be fixed; none without one.
    """

    id: str
    title: str
    help: str
    impact: str
    confidence: str
    description: str
    scenario: str
    recommendation: str
    message: str
    evidence: tuple[tuple[str, str], ...]
    relation: str
    columns: tuple[tuple[str, str], ...]
    path: str
    fix_columns: tuple[str, ...] = ()

    @property
    def fix_relation(self) -> str:
        """The relation that says how findings are to be fixed."""
        return f"{self.relation}_fix"

    @property
    def severity(self) -> str:
        """From impact and confidence: an error is bad and sure, a note is neither."""
        worst = max(LEVELS.index(self.impact), LEVELS.index(self.confidence))
        return "error" if (self.impact, self.confidence) == ("high", "high") else "note" if worst == 2 else "warning"


class CheckError(ValueError):
    """A check whose block of fields is not as it should be; the text says where and why."""


def check_files(folder: Path | None = None) -> list[Path]:
    """The files of the checks, by name; those that ship by default."""
    return sorted((folder or rules_folder() / "checks").glob("*.dl"))


def is_check(path: Path) -> bool:
    """Whether a file of rules begins with the block of fields of a check."""
    return _FIELD.match(path.read_text(encoding="utf-8", errors="replace")) is not None


def read_check(path: Path) -> Check:
    """The check in a file.

    Raises:
        CheckError: a field is missing, unknown or has no possible value, or the relation of the check is not declared.
    """
    text = path.read_text(encoding="utf-8")
    fields = {name: value for name, value in _fields(text, path)}
    for name in FIELDS:
        if name not in fields and name not in _OPTIONAL:
            raise CheckError(f"{path}:1:1: the check has no field `{name}`")
    if fields["id"] != path.stem:
        raise CheckError(f"{_place(text, path, 'id', fields['id'])}: the id `{fields['id']}` is not the name of the file")
    for name in ("impact", "confidence"):
        if fields[name] not in LEVELS:
            raise CheckError(f"{_place(text, path, name, fields[name])}: {name} is `{fields[name]}`, not one of {', '.join(LEVELS)}")
    relation = fields["id"].replace("-", "_")
    columns = _columns(text, relation)
    if not columns:
        raise CheckError(f"{path}:1:1: the relation `{relation}` of the check is not declared")
    names = [name for name, _ in columns]
    evidence = tuple(_step(line) for line in f"{fields['at']}\n{fields.get('evidence', '')}".splitlines() if line.strip())
    used = [("message", name) for name in _COLUMN.findall(fields["message"])]
    for field, (column, shown) in zip(("at", *["evidence"] * len(evidence)), evidence, strict=False):
        used += [(field, name) for name in (column, *_COLUMN.findall(shown))]
    for field, column in used:
        if column not in names:
            raise CheckError(f"{_place(text, path, field, column)}: {relation} has no column `{column}`{hint(column, names)}")
    texts = {name: fields[name] for name in FIELDS if name not in ("at", "evidence")}
    fix_columns = tuple(name for name, _ in _columns(text, f"{relation}_fix"))
    if fix_columns and (fix_columns[-3:] != CHANGE or not set(fix_columns[:-3]) <= set(names)):
        raise CheckError(f"{path}:1:1: {relation}_fix has other columns than some of {relation} and {', '.join(CHANGE)}")
    return Check(**texts, evidence=evidence, relation=relation, columns=columns, path=str(path), fix_columns=fix_columns)


@lru_cache(maxsize=1)
def shipped_checks() -> tuple[Check, ...]:
    """The checks that ship."""
    return read_checks(check_files())


def read_checks(paths: Iterable[Path]) -> tuple[Check, ...]:
    """The checks in files; see `read_check`."""
    return tuple(read_check(path) for path in paths)


def require_unique(paths: Iterable[Path]) -> None:
    """Reject two checks with one id.

    Raises:
        CheckError: the second of two files claims an id.
    """
    seen: dict[str, Path] = {}
    for path in paths:
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            match = _FIELD.fullmatch(line)
            if match is None or match[1] != "id":
                continue
            id_ = (match[2] or "").strip()
            if id_ in seen:
                raise CheckError(f"{path}:{number}:1: there is a check `{id_}` already, in {seen[id_]}")
            seen[id_] = path
            break


def _fields(text: str, path: Path) -> Iterator[tuple[str, str]]:
    """The fields at the head of a file; `|` or an indent continues one."""
    name, lines, seen = "", [""], set()
    for number, line in enumerate(text.splitlines(), 1):
        if not line.startswith("//") or line.startswith("///"):
            break
        match = _FIELD.fullmatch(line)
        if match is None:
            lines.append(line.removeprefix("//").removeprefix(" ").lstrip("|").removeprefix(" "))
            continue
        if name:
            yield name, dedent("\n".join(lines)).strip()
        name, lines = match[1], [(match[2] or "").removeprefix("|").strip()]
        if name not in FIELDS:
            raise CheckError(f"{path}:{number}:1: a check has no field `{name}`{hint(name, FIELDS)}")
        if name in seen:
            raise CheckError(f"{path}:{number}:1: the field `{name}` is there twice")
        seen.add(name)
    if name:
        yield name, dedent("\n".join(lines)).strip()


def _place(text: str, path: Path, field: str, word: str) -> str:
    """Where `word` is in a field."""
    lines = text.splitlines()
    first = next(number for number, line in enumerate(lines) if (match := _FIELD.fullmatch(line)) and match[1] == field)
    pattern = re.compile(rf"(?<![\w-]){re.escape(word)}(?![\w-])")
    for number, line in enumerate(lines[first:], first + 1):
        found = pattern.search(line, len(field) + 3 if number == first + 1 else 0)
        if word and found:
            return f"{path}:{number}:{found.start() + 1}"
    return f"{path}:{first + 1}:1"


def _step(line: str) -> tuple[str, str]:
    """`column`, or `column: text`."""
    column, _, text = line.partition(":")
    return column.strip(), text.strip()


def _columns(text: str, relation: str) -> tuple[tuple[str, str], ...]:
    """The columns of a relation and their types; none where it is not declared."""
    for match in _DECLARATION.finditer(text):
        if match[1] == relation:
            pairs = (column.partition(":") for column in match[2].split(","))
            return tuple((name.strip(), type_.strip()) for name, _, type_ in pairs)
    return ()


def evidence_of(type_: str) -> str:
    """The relation that says where things of a column's type lie: `evidence_of_node_port` of `NodePort`."""
    return f"evidence_of_{_snake(type_)}"


def shown_as(type_: str) -> str:
    """The relation that says how messages call things of a column's type."""
    return f"shown_as_{_snake(type_)}"


def _snake(type_: str) -> str:
    return _WORD.sub("_", type_).lower()


def require_places(checks: Iterable[Check], relations: Collection[str]) -> None:
    """Reject a check whose findings would have no place.

    Raises:
        CheckError: `relations` do not say where a column that a check shows lies.
    """
    for check in checks:
        for column, _ in check.evidence:
            relation = evidence_of(dict(check.columns)[column])
            if relation not in relations:
                raise CheckError(f"{check.path}:1:1: no relation `{relation}` tells the place of the column `{column}`")
