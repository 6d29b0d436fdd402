"""Declaring what absent headers would have declared, so that clang keeps the statements that use it.

Clang says which names it misses, and the text around them says what they are: a namespace, a class, a base class, a
template, a function, a variable, a macro. They are declared permissively in a header that the source sees first.
Messages of which only the name is known get the fields that code uses.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.files import read_file
from rosarch.extractor.cxx import libclang
from rosarch.extractor.cxx.includes import HEALED
from rosarch.extractor.cxx.unit import UnitFacts
from rosarch.extractor.cxx.unseen import Unseen
from rosarch.extractor.cxx.wanted import UNKNOWN, Wanted, kind_of_member

ROUNDS = 4
ERROR_LIMIT = 50_000  # beyond, a source is of another language
OPTIONS = libclang.KEEP_GOING | libclang.DETAILED_PREPROCESSING
_ERROR = 3

_QUOTED = re.compile(r"'([^']*)'")
_CHAIN = re.compile(rb"\w+(?:\s*::\s*\w+)*")
_QUALIFIER = re.compile(rb"((?:\b(?!public\b|protected\b|private\b|virtual\b)\w+\s*::\s*)+)$")
_BASE_CLAUSE = re.compile(rb"[:,]\s*(?:(?:public|protected|private|virtual)\s+)*(?:::\s*)?(?:\w+\s*::\s*)*$")
_CLASS_HEAD = re.compile(rb"\b(?:class|struct)\s+(?:[A-Z_]+\s+)?([\w:]+)[^;{}()]*$")
_TEMPLATE = re.compile(rb"\s*<((?:[\w\s:,*&.]|<[\w\s:,*&.]*>)*)>\s*(.?)")
_FOLLOWING = re.compile(rb"\s*(?:\[[^\]\n]*\]\s*|\([^()\n]*\)\s*)*(?:\.|->)\s*(\w+)")
_DECLARATOR = re.compile(rb"\s*(?:const\s*)?[*&]*\s*[A-Za-z_]\w*\s*[;=,(){\[:]")
_USING = re.compile(rb"\busing\s+(?:(\w+)\s*=\s*)?(?:::\s*)?(?:\w+\s*::\s*)*$")
_GLOBAL = re.compile(rb"(?<![\w>])\s*::\s*$")
"""A name is looked for outside of all namespaces."""
_MACRO = re.compile(r"__\w+__|[A-Z][A-Z0-9_]{2,}")
_MACRO_CALL = re.compile(rb"\s*\((?:[^()]|\([^()]*\))*\)\s*(.?)")
_TRAILING_MACRO = re.compile(rb"\s*([A-Z][A-Z0-9_]{2,})\s*(\(?)")
_HEAD_MACRO = re.compile(rb"\b(?:class|struct)\s+([A-Z][A-Z0-9_]{2,})\s+$")
_CLASS_BODY = re.compile(rb"\w+\s*(?:final\s*)?[:{]")
_DECLARATION = re.compile(rb"\s+[A-Za-z_]\w*(?:\s*[*&]+\s*|\s+|\s*<[^;{}]*>\s*|\s*::\s*)[A-Za-z_]")
_CLASH = re.compile(r"redefinition of '(\w+)'|reference to '(\w+)' is ambiguous|conflicting types for '(\w+)'")
_AMBIGUOUS = re.compile(r"reference to '(\w+)' is ambiguous")
_END_EXPECTED = (
    "expected ';' at end of declaration list",
    "expected ';' after top level declarator",
    "expected function body after function declarator",
)
_NAME_ERRORS = ("use of undeclared identifier", "unknown type name", "no template named", "expected class name", "expected namespace name")
_HARMLESS = ("only virtual member functions can be marked", "switch condition type")
"""Errors after which clang's tree has all that the source has."""
_NO_TYPE = ("no type named", "no struct named", "no class named")


@dataclass(frozen=True)
class _Error:
    """What clang complains of."""

    message: str
    file: str
    offset: int


@dataclass(frozen=True)
class _Place:
    """The text around an error."""

    before: bytes
    after: bytes

    def chain(self) -> tuple[list[str], bytes]:
        """The qualified name that begins here, and the text after it."""
        match = _CHAIN.match(self.after)
        if match is None:
            return [], b""
        return re.sub(r"\s+", "", match.group().decode("utf-8", "replace")).split("::"), self.after[match.end() :]


class _Sources:
    """The files that errors are in."""

    def __init__(self) -> None:
        self._data: dict[str, bytes] = {}

    def text(self, file: str) -> bytes:
        """What a file holds."""
        if file not in self._data:
            self._data[file] = b""
            with suppress(OSError):
                self._data[file] = read_file(file)
        return self._data[file]

    def place(self, error: _Error) -> _Place:
        """Where an error is."""
        data, offset = self.text(error.file), error.offset
        return _Place(data[max(0, offset - 400) : offset], data[offset : offset + 500])


def files_with_errors(facts: UnitFacts, parsed: libclang.Unit) -> set[str]:
    """The paths of files that clang had trouble with."""
    return {str(facts.file(name).path) for name in {error.file for error in _errors(parsed)} if name}


def worth_healing(facts: UnitFacts, parsed: libclang.Unit) -> bool:
    """Whether clang had trouble with a file of the workspace; what it drops there may leave no trace in the facts."""
    return any(facts.file(error.file).key for error in _errors(parsed) if error.file)


def without_unknown(rows: dict[str, set[tuple[str | int, ...]]]) -> None:
    """Take back the types that stand for unknown ones: no type is what the rules know as unknown."""
    rows["expr_type"] = {row for row in rows["expr_type"] if UNKNOWN not in str(row[1])}


@dataclass(frozen=True)
class Healed:
    """A source with declarations for what it lacks; `interfaces` are the headers of those interfaces that are declared for it."""

    unit: libclang.Unit
    interfaces: frozenset[str]


@contextmanager
def healed(
    source: Path,
    arguments: Sequence[str],
    first: libclang.Unit,
    scratch: Path,
    interfaces_by_scope: bool = False,
    unseen: Unseen | None = None,
) -> Iterator[Healed | None]:
    """Parse `source` again with declarations for what `first` lacks; yield None when that leaves no fewer errors.

    `interfaces_by_scope` says that `package::msg::Name` is a message, and so on for services and actions, as in ROS 2. `unseen` are the
    macros that nothing defines.
    """
    errors = _errors(first)
    fewest, best = _trouble(errors), None
    wanted = Wanted(scratch, interfaces_by_scope)
    if unseen is not None:
        wanted.undefined(unseen.bodies(UNKNOWN), unseen.defined)
    clashes = wanted.changed
    with ExitStack() as units:
        for number in range(ROUNDS if len(errors) <= ERROR_LIMIT else 0):
            wanted.changed = clashes
            _collect(wanted, errors, variables=number > 0)
            if not wanted.changed:
                break
            try:
                unit = units.enter_context(libclang.Unit(source, _with(arguments, wanted.write()), OPTIONS))
            except (libclang.ParseError, OSError):
                break
            found = _errors(unit)
            settled = wanted.settle({match.group(1) for error in found if (match := _AMBIGUOUS.match(error.message))})
            clashes = wanted.ban(_clashes(found, scratch) - settled) or bool(settled)
            if not clashes or _trouble(found) < fewest:
                errors = found  # else most follow from what is now banned
            if _trouble(found) < fewest:
                best, fewest = Healed(unit, frozenset(wanted.interfaces)), _trouble(found)
        yield best


def _trouble(errors: Sequence[_Error]) -> tuple[int, int]:
    """How many errors there are; of those the ones that lose what follows."""
    return len(errors), sum(error.message.startswith("expected") for error in errors)


def _clashes(errors: Iterable[_Error], scratch: Path) -> set[str]:
    """The names that the workspace, or a header that is there, declares in another way.

    An alias of a message that is made below `scratch` clashes in one place; without the name, all would be lost that uses it before.
    """
    found = {name for error in errors for match in _CLASH.finditer(error.message) for name in match.groups() if name}
    sources = _Sources()
    aliases = [sources.place(error).chain()[0] for error in errors if _redefines(error, scratch)]
    return found | {path[-1] for path in aliases if path}


def _redefines(error: _Error, scratch: Path) -> bool:
    return error.message.startswith("typedef redefinition") and not Path(error.file).is_relative_to(scratch)


def _errors(unit: libclang.Unit) -> list[_Error]:
    found = [(text, place) for severity, text, place in unit.diagnostics if severity >= _ERROR and not text.startswith(_HARMLESS)]
    return [_Error(text, *libclang.file_location(place)) for text, place in found]


def _with(arguments: Sequence[str], folder: Path) -> list[str]:
    """The arguments with the healed headers: searched before other stand-ins, included after the precompiled one."""
    first = arguments.index("-isystem") if "-isystem" in arguments else len(arguments)
    return [*arguments[:first], "-isystem", str(folder), *arguments[first:], "-include", str(folder / HEALED)]


def _collect(wanted: Wanted, errors: Sequence[_Error], variables: bool) -> None:
    """Read off the errors what is missing.

    Plain names wait: a class may come in from a namespace by `using`, and most undeclared variables follow from a
    declaration that clang dropped, so `variables` are not wanted before all else is declared.
    """
    sources = _Sources()
    for file in dict.fromkeys(error.file for error in errors):
        if file not in wanted.read:
            wanted.read.add(file)
            wanted.members_in(sources.text(file))
    plain: list[tuple[str, str, str]] = []
    brought = _brought(errors, sources)
    for error in errors:
        quoted = _QUOTED.findall(error.message)
        place = sources.place(error)
        if error.message.startswith(_NAME_ERRORS):
            _collect_name(wanted, error.message, quoted, place, plain)
        elif error.message.startswith(("no member named", *_NO_TYPE)) and quoted:
            if quoted[0] not in brought or _USING.search(place.before):
                _collect_member(wanted, error.message, quoted, place)
        else:
            _collect_correction(wanted, error.message, quoted, place)
    for name, kind, parameters in plain:
        if kind == "template" and wanted.nested(name):
            wanted.correct(name, kind)  # brought in by `using`, which does not say
        elif kind != "value" and not wanted.nested(name):
            wanted.name([name], kind, parameters)
    if variables or not wanted.changed:
        for name, kind, _ in plain:
            if kind == "value":
                wanted.name([name], kind)


def _brought(errors: Iterable[_Error], sources: _Sources) -> set[str]:
    """The names that `using` would bring into a namespace, if what it names were declared."""
    found: set[str] = set()
    for place in map(sources.place, errors):
        if match := _USING.search(place.before):
            path = place.chain()[0]
            found |= {match.group(1).decode()} if match.group(1) else set(path[-1:])
    return found


def _collect_name(wanted: Wanted, message: str, quoted: list[str], place: _Place, plain: list[tuple[str, str, str]]) -> None:
    """A name that is not declared: `use of undeclared identifier 'x'` and the like."""
    path, after = place.chain()
    if quoted and (not path or path[0] != quoted[0]):
        path, after = [quoted[0]], b""  # within a macro: the place is that of its use
    if not path:
        return
    body = _macro_body(path[0], message, after) if len(path) == 1 else None
    if body is not None:
        wanted.macro(path[0], body)
        return
    if message.startswith("no template named") and len(quoted) > 1:
        owner = quoted[1].partition("<")[0].split("::")
        path = [*owner, *path]
        if "in namespace" in message:
            wanted.namespace(owner)
    default = ""
    if message.startswith("expected namespace"):
        default = "namespace"
    elif message.startswith("expected class"):
        default = "base"
        qualifier = _QUALIFIER.search(place.before)
        path = [*(re.findall(r"\w+", qualifier.group(1).decode()) if qualifier else []), *path]
    elif message.startswith("unknown type name") and len(path) == 1:
        default = "class"
    kind, parameters = _kind(path, place.before, after, default)
    head = _CLASS_HEAD.search(place.before)
    if head and kind in ("base", "template") and _BASE_CLAUSE.search(place.before):
        wanted.bases.setdefault(head.group(1).decode().rpartition("::")[2], set()).add("::".join(path))
    if len(path) == 1 and kind in ("value", "class", "template"):
        plain.append((path[0], kind, parameters))
    else:
        wanted.name(path, kind, parameters)


def _macro_body(name: str, message: str, after: bytes) -> str | None:
    """The body of a macro that would make sense of a name in capitals, parameters included; None for no macro.

    Where clang looked for a declaration, `NAME(...)` stands for one, `Q_PROPERTY(int x)`.
    """
    if not _MACRO.fullmatch(name) or message.startswith("expected"):
        return None
    if name.startswith("__"):
        return "(...)" if after.lstrip().startswith(b"(") else ""
    call = _MACRO_CALL.match(after)
    if call and call.group(1) == b"{":
        return f"(...) for (; {UNKNOWN}(); )"
    if call:
        return "(...)" if message.startswith("unknown type name") else None
    return "" if re.match(rb"[ \t]*\r?\n", after) or _DECLARATION.match(after) else None


def _kind(path: Sequence[str], before: bytes, after: bytes, default: str = "") -> tuple[str, str]:
    """What a name is by what is around it, `default` if that is known; for a template also its parameters."""
    name = path[-1]
    template = _TEMPLATE.match(after)
    if template and (template.group(2) or default):
        if template.group(2) == b"(" and name[:1].islower() and not default:
            return "function", ""
        values = [bool(re.fullmatch(rb"\s*(?:-?\d+|true|false)\s*", argument)) for argument in template.group(1).split(b",")]
        return "template", ", ".join("auto" if value else "typename" for value in values) if any(values) else "typename..."
    if _BASE_CLAUSE.search(before) and re.match(rb"\s*[{,]", after) and re.search(rb"\b(?:class|struct)\s+[\w\s:]+:[^;{}()]*$", before):
        return "base", ""
    return default or _kind_in_expression(name, len(path) > 1, before, after), ""


def _kind_in_expression(name: str, qualified: bool, before: bytes, after: bytes) -> str:
    capital = name[:1].isupper()
    if re.search(rb"\bcase(?:\s+|\s*\(\s*)$", before):
        return "constant"
    if after.lstrip().startswith(b"("):
        return "class" if re.search(rb"\b(?:new|throw)\s*$", before) or (qualified and capital) else "function"
    if re.search(rb"\busing\s+namespace\s+$", before):
        return "namespace"
    if re.search(rb"\b(?:const|new|typedef|struct|class)\s+$", before) or _DECLARATOR.match(after):
        return "class"
    if capital and re.search(rb"\busing\s+(?:\w+\s*::\s*)*$", before):
        return "class"
    if (
        capital
        and not name.isupper()
        and re.match(rb"\s*(?:const\s*)?[*&]*\s*[>)]", after)
        and re.search(rb"[<,(]\s*(?:const\s+)?$", before)
    ):
        return "class"
    return "class" if qualified and capital and re.match(rb"\s*[*&]*\s*[>{]", after) else "value"


def _collect_member(wanted: Wanted, message: str, quoted: list[str], place: _Place) -> None:
    """A name that is not declared in a namespace or class: `no member named 'x' in 'Y'` and the like."""
    path, after = place.chain()
    if not path or path[0] != quoted[0]:
        path, after = [quoted[0]], b""
    is_type = message.startswith(_NO_TYPE)
    kind, parameters = _kind(["", *path], place.before, after, "class" if is_type and len(path) == 1 else "")
    if "in the global namespace" in message:
        wanted.name(path, kind, parameters)
    elif len(quoted) < 2:
        return
    elif "in namespace" in message:
        wanted.namespace(quoted[1].split("::"))
        wanted.name([*quoted[1].split("::"), *path], kind, parameters)
    elif is_type:
        owner = quoted[1].partition("<")[0].split("::")
        if wanted.find(owner) is not None:
            wanted.name([*owner, path[0]], kind if len(path) == 1 else "class", parameters)
        elif len(path) == 1:
            wanted.member(quoted[1], path[0], "type")
    elif re.search(rb"::\s*$", place.before):
        wanted.member(quoted[1], path[0], "constant" if kind_of_member(after, 0) == "value" else "function")
    else:
        wanted.member(quoted[1], path[0], kind_of_member(after, 0))
        for name, kind in _following(after):
            wanted.member(UNKNOWN, name, kind)


def _following(after: bytes) -> Iterator[tuple[str, str]]:
    """The members that code goes on to, `.stamp.toSec()`, each with its kind."""
    position = 0
    while (match := _FOLLOWING.match(after, position)) is not None:
        yield match.group(1).decode(), kind_of_member(after, match.end(1))
        position = match.end(1)


def _collect_correction(wanted: Wanted, message: str, quoted: list[str], place: _Place) -> None:
    """What was declared in an earlier round, but not as it is used; and classes that are declared but not defined."""
    path = place.chain()[0]
    if message.startswith(_END_EXPECTED) and (macro := _TRAILING_MACRO.match(place.after)):  # `int x GUARDED_BY(mutex_);`
        wanted.macro(macro.group(1).decode(), "(...)" if macro.group(2) else "")
    elif message.startswith("variable has incomplete") and _CLASS_BODY.match(place.after) and (macro := _HEAD_MACRO.search(place.before)):
        wanted.macro(macro.group(1).decode(), "")  # `class MY_LIBRARY_EXPORT Driver : public Node {`
    elif message.startswith(("case value is not a constant", "enumerator value is not a constant")) and path:
        wanted.correct(path[-1], "constant")
    elif message.endswith("does not name a template but is followed by template arguments"):
        wanted.correct(quoted[0], "template" if quoted[0][:1].isupper() else "function")
        if quoted[0] in wanted.members:
            wanted.member(UNKNOWN, quoted[0], "template")
    elif message.startswith("unexpected namespace name"):
        wanted.correct(quoted[0], "class")
    elif message == "template argument for template type parameter must be a type" and path:
        wanted.correct_to_type(path[-1])
    elif message.endswith("does not refer to a value"):
        wanted.correct(quoted[0], "value")
    elif message.startswith("expected '(' for function-style") and (name := re.search(rb"(\w+)\s*$", place.before)):
        wanted.correct(name.group(1).decode(), "value")
    elif message.endswith("is not a class, namespace, or enumeration") and len(path) > 1 and _GLOBAL.search(place.before):
        wanted.name(path, "class" if path[-1][:1].isupper() else _kind(path, place.before, place.chain()[1])[0])
    elif "incomplete type" in message and quoted:
        wanted.name(re.sub(r"^(?:class|struct|const)\s+|<.*", "", quoted[0]).split("::"), "class")
