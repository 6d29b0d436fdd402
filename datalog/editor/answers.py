"""What a name means, where it is used, what could appear at a place, and what renaming it would change."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.datalog.editor.occurrences import Call, Declared, Names, Occurrence, call_around
from rosarch.datalog.editor.programs import Programs, included
from rosarch.datalog.language.errors import closest
from rosarch.datalog.language.parser import is_word

_IDENTIFIER = re.compile(r"[?a-zA-Z]|[_?a-zA-Z][_?a-zA-Z0-9]+")  # IDENT of grammar.lark
PRIMITIVES = ("number", "unsigned", "float", "symbol")
DIRECTIVES = (".decl", ".type", ".input", ".output", ".include", ".functor", ".comp", ".init", ".override", ".printsize", ".limitsize")
WORDS: Mapping[str, str] = {
    "cat": "cat(a, b, ...): the texts one after the other", "strlen": "strlen(text): its length",
    "substr": "substr(text, start, length): a part of a text", "ord": "ord(text): a number for the text, of this run",
    "range": "range(from, to, step): the numbers from one to below another", "to_number": "to_number(text): the number it spells",
    "to_string": "to_string(number): the text that spells it", "to_float": "to_float(number)", "to_unsigned": "to_unsigned(number)",
    "match": 'match("regex", text): the whole text matches', "contains": "contains(part, text): the part occurs in the text",
    "count": "count : { body }: how many solutions the body has", "sum": "sum term : { body }", "min": "min term : { body }",
    "max": "max term : { body }", "mean": "mean term : { body }", "as": "as(term, type): the same value under another type",
}  # fmt: skip


class RenameError(Exception):
    """A name that cannot be changed as asked; the message says why."""


@dataclass(frozen=True, slots=True)
class Place:
    """A name in a file; `line`, `column` and `end` count from 1."""

    path: Path
    line: int
    column: int
    end: int


@dataclass(frozen=True, slots=True)
class Proposal:
    """What could appear at a place; `fill` is the text with places to fill in, as `${1:name}`."""

    label: str
    kind: str
    detail: str = ""
    doc: str = ""
    fill: str = ""


@dataclass(frozen=True, slots=True)
class Signature:
    """The relation whose arguments are being written, and which of them."""

    label: str
    doc: str
    attributes: tuple[str, ...]
    active: int


def _place(path: Path, found: Occurrence) -> Place:
    return Place(path, found.line, found.column, found.end)


def signature_of(declared: Declared) -> str:
    """`name(attribute: type, ...)`."""
    return f"{declared.name}({', '.join(f'{name}: {type_}' for name, type_ in declared.attributes)})"


class Answers:
    """Answers about files of rules. `folders` are those that are open, whose rule files are looked through for uses."""

    def __init__(self, programs: Programs, folders: Sequence[Path] = ()) -> None:
        self.programs = programs
        self.folders = tuple(f.resolve() for f in folders)

    # -- names --------------------------------------------------------------------------------

    def at(self, path: Path, line: int, column: int) -> Occurrence | None:
        """The name at a place, or ending there."""
        found = [o for o in self.programs.names(path).occurrences if o.line == line and o.column <= column <= o.end]
        return found[-1] if found else None

    def rule_files(self) -> list[Path]:
        """The rule files of the open folders and those being edited."""
        found = {Path(p) for p in self.programs.edited}
        for folder in self.folders:
            found.update(p for p in folder.rglob("*.dl") if not any(part.startswith(".") for part in p.relative_to(folder).parts))
        return sorted(found)

    def _program_files(self, path: Path) -> list[Path]:
        program = self.programs.program(path)
        return [path, *(Path(p) for p in program.texts if Path(p) != path)]

    def _declarations(self, path: Path, name: str, kind: str) -> list[tuple[Path, Occurrence]]:
        """Where a name is declared in the program of a file."""
        return [
            (file, o)
            for file in self._program_files(path)
            for o in self.programs.names(file).occurrences
            if o.is_declaration and o.kind == kind and o.name == name
        ]

    def definition(self, path: Path, line: int, column: int) -> list[Place]:
        """Where the name at a place is declared; of a variable, where it occurs first; of an `.include`, the file."""
        found = self.at(path, line, column)
        match found:
            case None:
                return []
            case Occurrence(kind="file"):
                target = included(path, found.name)
                return [Place(target, 1, 1, 1)] if target.is_file() else []
            case Occurrence(kind="variable"):
                return [_place(path, o) for o in self._local(path, found)][:1]
            case Occurrence(kind="attribute"):
                return [_place(path, o) for o in self._local(path, found) if o.is_declaration]
            case _:
                return [_place(file, o) for file, o in self._declarations(path, found.name, found.kind)]

    def _local(self, path: Path, found: Occurrence) -> list[Occurrence]:
        """The occurrences of a name that belongs to one clause or declaration."""
        own = self.programs.names(path).occurrences
        return [o for o in own if o.item == found.item and o.kind == found.kind and o.name == found.name]

    def references(self, path: Path, line: int, column: int) -> list[Place]:
        """Every occurrence of what the name at a place means: its declaration and its uses, in other files too."""
        found = self.at(path, line, column)
        if found is None:
            return []
        if found.kind in ("variable", "attribute"):
            return [_place(path, o) for o in self._local(path, found)]
        files = self._files_that_mean(path, found)
        return [
            _place(file, o)
            for file in files
            for o in self.programs.names(file).occurrences
            if o.kind == found.kind and o.name == found.name
        ]

    def _files_that_mean(self, path: Path, found: Occurrence) -> list[Path]:
        """The files in which a name of this kind means the same: those of the program, and those that do not declare it otherwise."""
        program = self._program_files(path)
        declaring = {file for file, _ in self._declarations(path, found.name, found.kind)}
        others = [f for f in self.rule_files() if f not in program]
        return [*program, *(f for f in others if self._means_the_same(f, found, declaring))]

    def _means_the_same(self, file: Path, found: Occurrence, declaring: set[Path]) -> bool:
        if not any(o.name == found.name and o.kind == found.kind for o in self.programs.names(file).occurrences):
            return False
        own = {
            f
            for f in self.programs.closure(file)
            if any(o.is_declaration and o.name == found.name and o.kind == found.kind for o in self.programs.names(f).occurrences)
        }
        return not own or bool(own & declaring)

    def rename(self, path: Path, line: int, column: int, new: str) -> list[Place]:
        """The places where the name at a place would have to be replaced. Raises RenameError."""
        found = self.at(path, line, column)
        if found is None or found.kind == "file" or (found.kind == "type" and found.name in PRIMITIVES):
            raise RenameError("nothing here can be renamed")
        if not _IDENTIFIER.fullmatch(new) or is_word(new):
            raise RenameError(f"`{new}` is no name: letters, digits and `_`, not one of the language's own words")
        local = found.kind in ("variable", "attribute")
        if local:
            taken = any(o.item == found.item and o.kind == found.kind and o.name == new for o in self.programs.names(path).occurrences)
            if taken:
                raise RenameError(f"`{new}` is another {found.kind} of the same {'clause' if found.kind == 'variable' else 'declaration'}")
            return self.references(path, line, column)
        declared = self._declarations(path, found.name, found.kind)
        if not declared:
            raise RenameError(f"`{found.name}` is declared nowhere")
        if len(declared) > 1 or found.qualifier:
            raise RenameError(f"`{found.name}` is a name inside components; rename it by hand")
        if not self._editable(declared[0][0]):
            raise RenameError(f"`{found.name}` is declared in {declared[0][0]}, which is not in an open folder")
        if clash := self._declarations(path, new, found.kind):
            raise RenameError(f"`{new}` is already declared at {clash[0][0]}:{clash[0][1].line}")
        return [p for p in self.references(path, line, column) if self._editable(p.path)]

    def _editable(self, path: Path) -> bool:
        return str(path) in self.programs.edited or any(path.is_relative_to(f) for f in self.folders)

    # -- what a name is -----------------------------------------------------------------------

    def hover(self, path: Path, line: int, column: int) -> tuple[str, str, Place] | None:
        """What the name at a place is: a line of code, the documentation, and the place of the name."""
        found = self.at(path, line, column)
        if found is None:
            return None
        place = _place(path, found)
        match found.kind:
            case "relation":
                relation = self._relation(path, found.name)
                return None if relation is None else (f".decl {signature_of(relation[1])}", self._with_file(path, *relation), place)
            case "variable":
                types = dict.fromkeys(self._variable_types(path, found))
                return (f"{found.name}: {', '.join(types)}", "", place) if types else None
            case "file":
                return found.name, str(included(path, found.name)), place
            case _:
                declared = self._declarations(path, found.name, found.kind)
                if not declared:
                    return None
                file, where = declared[0]
                source = self.programs.text(file).splitlines()[where.line - 1].strip()
                return source, self._with_file(path, file, Declared(found.name, (), where.line)), place

    def _with_file(self, asking: Path, path: Path, declared: Declared) -> str:
        """The documentation of a declaration, and which file it is in."""
        doc = self.programs.names(path).docs.get(declared.line, "")
        return doc if path == asking else f"{doc}\n\n{path.name}:{declared.line}".strip()

    def _relation(self, path: Path, name: str) -> tuple[Path, Declared] | None:
        return next(((f, found) for f in self._program_files(path) if (found := self.programs.names(f).relations.get(name))), None)

    def _variable_types(self, path: Path, variable: Occurrence) -> Iterator[str]:
        """The types of the attributes that a variable stands for."""
        for occurrence in self._local(path, variable):
            relation = occurrence.argument and self._relation(path, occurrence.argument[0])
            if occurrence.argument and relation and occurrence.argument[1] < len(relation[1].attributes):
                yield relation[1].attributes[occurrence.argument[1]][1]

    def signature(self, path: Path, line: int, column: int) -> Signature | None:
        """The relation whose arguments are being written at a place."""
        call = call_around(self.programs.text(path), line, column)
        relation = call and self._relation(path, call.relation)
        if not call or not relation:
            return None
        attributes = tuple(f"{name}: {type_}" for name, type_ in relation[1].attributes)
        doc = self.programs.names(relation[0]).docs.get(relation[1].line, "")
        return Signature(signature_of(relation[1]), doc, attributes, call.argument)

    # -- what could stand here ----------------------------------------------------------------

    def completion(self, path: Path, line: int, column: int) -> list[Proposal]:
        """What could appear at a place, the likeliest first."""
        lines = self.programs.text(path).splitlines()
        before = lines[line - 1][: column - 1] if line <= len(lines) else ""
        if re.search(r"^\s*\.\w*$", before):
            return [Proposal(word[1:], "keyword", word) for word in DIRECTIVES]
        if found := re.search(r'\.include\s+"([^"]*)$', before):
            return list(self._includes(path, found[1]))
        if re.search(r"(^\s*\.(decl|type|functor)\b.*(:|<:|=|\|)\s*\w*$)|(\bas\([^()]*,\s*\w*$)", before):
            return list(self._types(path))
        if re.search(r"^\s*\.(input|output|printsize|limitsize|override)\s+[\w, ]*$", before):
            return [p for p in self._relations(path) if p.kind == "relation"]
        if re.search(r"^\s*\.|//", before):
            return []
        call = call_around(self.programs.text(path), line, column)
        attribute = list(self._attribute(path, call)) if call else []
        return [*attribute, *self._variables(path, line, column, {p.label for p in attribute}), *self._relations(path), *self._words()]

    def _includes(self, path: Path, typed: str) -> Iterator[Proposal]:
        folder = (path.parent / typed.rpartition("/")[0]).resolve()
        if folder.is_dir():
            for entry in sorted(folder.iterdir()):
                if entry.is_dir() and not entry.name.startswith("."):
                    yield Proposal(f"{entry.name}/", "folder")
                elif entry.suffix == ".dl" and entry != path:
                    yield Proposal(entry.name, "file")

    def _declared(self, path: Path, kind: str) -> Iterator[tuple[Path, Names, Occurrence]]:
        for file in self._program_files(path):
            names = self.programs.names(file)
            for occurrence in names.occurrences:
                if occurrence.is_declaration and occurrence.kind == kind:
                    yield file, names, occurrence

    def _types(self, path: Path) -> Iterator[Proposal]:
        yield from (Proposal(name, "type") for name in PRIMITIVES)
        for _, names, found in self._declared(path, "type"):
            yield Proposal(found.name, "type", doc=names.docs.get(found.line, ""))

    def _attribute(self, path: Path, call: Call) -> Iterator[Proposal]:
        """The argument being written, by the name of its attribute."""
        relation = self._relation(path, call.relation)
        if relation and call.argument < len(relation[1].attributes):
            name, type_ = relation[1].attributes[call.argument]
            yield Proposal("".join(part.capitalize() for part in name.split("_")), "variable", type_)

    def _variables(self, path: Path, line: int, column: int, known: Iterable[str]) -> Iterator[Proposal]:
        own = self.programs.names(path).occurrences
        before = [o for o in own if (o.line, o.column) <= (line, column)]
        item = before[-1].item if before else 0
        inside = [o for o in own if o.item == item and o.kind == "variable" and not (o.line == line and o.end == column)]
        for name in dict.fromkeys(o.name for o in inside):
            if name not in known:
                first = next(o for o in inside if o.name == name)
                yield Proposal(name, "variable", ", ".join(dict.fromkeys(self._variable_types(path, first))))

    def _relations(self, path: Path) -> Iterator[Proposal]:
        """The relations of the program, but of other files not those that are private to them."""
        for file, names, found in self._declared(path, "relation"):
            if file == path or not found.name.startswith("_"):
                relation = names.relations[found.name]
                fill = ", ".join(
                    f"${{{i}:{''.join(p.capitalize() for p in name.split('_'))}}}" for i, (name, _) in enumerate(relation.attributes, 1)
                )
                yield Proposal(found.name, "relation", signature_of(relation), names.docs.get(found.line, ""), f"{found.name}({fill})")
        for _, names, found in self._declared(path, "functor"):
            yield Proposal(f"@{found.name}", "functor", doc=names.docs.get(found.line, ""))

    def _words(self) -> Iterator[Proposal]:
        yield from (Proposal(word, "keyword", detail) for word, detail in WORDS.items())

    def fix(self, path: Path, line: int, column: int) -> str:
        """A declared name close to the unknown one at a place."""
        found = self.at(path, line, column)
        return closest(found.name, [o.name for _, _, o in self._declared(path, found.kind)]) if found else ""
