"""What clang dropped: calls and names in statements it could not type, read from the source text.

Clang leaves a whole statement out of its tree when one name in it is not declared. The calls in such a statement are
found in the text; receivers and arguments are the literals, variables and functions that their words name. Everything
made here is marked: `call_unresolved(call, "recovered")`.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeVar

from rosarch.extractor.cxx.declarations import declare_unknown_type
from rosarch.extractor.cxx.literals import decode_string
from rosarch.extractor.cxx.unit import TEXT_LIMIT, FunctionSpan, SourceFile, Span, UnitFacts

_HIDDEN = re.compile(
    rb"""//[^\n]*|/\*.*?\*/|R"(?P<mark>[^()\s\\]{0,16})\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'"""
    rb"""|^[ \t]*\#(?:[^\n\\]|\\.)*""",
    re.DOTALL | re.MULTILINE,
)
_CALL = re.compile(
    rb"(?<!\w)(?:(?P<receiver>(?:\w+(?:\[\w*\])?\s*(?:\.|->)\s*)*\w+(?:\[\w*\])?)\s*(?:\.|->)\s*(?:template\s+)?)?"
    rb"(?P<name>(?:\w+::)*\w+)\s*(?P<types><[\w:<>,\s]*>)?\s*\("
)
_NO_CALLEE = (b"(", b")", b";", b"{", b"}", b"=")
"""Signs that are not in what `_CALL` finds, but for its end."""
_KEYWORDS = frozenset(
    {"if", "while", "for", "switch", "return", "catch", "sizeof", "defined", "new", "delete", "throw", "else", "do", "and", "or", "not"}
    | {"static_cast", "dynamic_cast", "const_cast", "reinterpret_cast", "decltype", "typeid", "alignof", "noexcept", "static_assert"}
)
_NUMBER = re.compile(r"[-+]?(\d+|\d*\.\d+|\d+\.\d*)([eE][-+]?\d+)?[fFuUlL]*")
_NAME = re.compile(r"&?\s*(?:\w+\s*(?:\.|->|::)\s*)*\w+")
_NEW = re.compile(rb"\bnew\s+$")
_IN_EXPRESSION = re.compile(rb"(?:[=(,;{}!&|?:+<)]|\breturn|\belse)\s*$")  # in front of the name in a declaration is a type
_TARGET = re.compile(rb"(?<![\w.>=!<+*/|&^%-])(\w+)\s*=\s*$")
_STRINGS = re.compile(r"(?:\"(?:\\.|[^\"\\])*\"\s*)+")

_Key = TypeVar("_Key", str, tuple[str, str])
Rows = Mapping[str, set[tuple[str | int, ...]]]


class Names(NamedTuple):
    """Declared entities by unqualified name."""

    functions: dict[str, list[tuple[str, str]]]
    constructors: dict[str, list[tuple[str, str]]]
    classes: dict[str, str]
    locals: dict[tuple[str, str], str]
    fields: dict[tuple[str, str], str]
    fields_by_name: dict[str, list[str]]
    globals: dict[str, str]


def recover(unit: UnitFacts, names: Sequence[Names]) -> None:
    """Add the calls and names that the walk of the syntax tree did not meet; `names` are those that the text may use."""
    _name_unknowns(unit, names)
    assigned = _assigned(unit)
    by_file: dict[int, tuple[SourceFile, list[FunctionSpan]]] = {}
    for function in unit.functions:
        by_file.setdefault(id(function.file), (function.file, []))[1].append(function)
    for file, functions in by_file.values():
        seen = unit.call_sites[id(file)]
        skipped = unit.skipped.get(str(file.path), [])
        functions.sort(key=lambda function: (function.begin, -function.end))
        begins = [function.begin for function in functions]
        for match in _calls_in(_hidden(file.data), _outermost(functions), seen):
            begin = match.start("name")
            holder = _innermost(functions, begins, begin)
            if holder is not None and not any(start <= begin < stop for start, stop in skipped):
                _recover_call(_Reader(unit, names, holder, match.string, assigned), match)
    for expr, file, end in unit.remnants:
        if (id(file), end) in unit.recovered:
            unit.add("call_remnant", expr, unit.recovered[id(file), end])


def _assigned(unit: UnitFacts) -> Set[str]:
    """Where the assignments begin that clang did not drop, in units of which it dropped parts of expressions."""
    if not unit.remnants:
        return frozenset()
    return {str(expr).rpartition(":")[0] for expr, operator in unit.rows["operator"] if operator == "="}


@lru_cache(maxsize=256)
def _hidden(data: bytes) -> bytes:
    """The text of a file, as `hide` leaves it; headers are asked for by many units."""
    return hide(data)


def _calls_in(text: bytes, spans: Iterable[tuple[int, int]], seen: Set[int]) -> Iterator[re.Match[bytes]]:
    """What looks like a call within `spans`, but for those whose names end where they are `seen`: nearly all are."""
    for begin, end in spans:
        paren = text.find(b"(", begin, end)
        while paren >= 0:
            last = paren
            while text[last - 1] in b" \t\n\r\f\v":
                last -= 1
            if last not in seen:
                start = 1 + max(text.rfind(mark, begin, paren) for mark in _NO_CALLEE)
                match = _CALL.search(text, start, paren + 1)
                if match and match.end("name") not in seen:
                    yield match
            paren = text.find(b"(", paren + 1, end)


def _outermost(functions: Iterable[FunctionSpan]) -> Iterator[tuple[int, int]]:
    """Where the functions lie that are in no other, of functions sorted by where they begin."""
    reached = -1
    for function in functions:
        if function.begin >= reached:
            reached = function.end
            yield function.begin, function.end


def _innermost(functions: list[FunctionSpan], begins: list[int], offset: int) -> FunctionSpan | None:
    """The function, of those sorted by where they begin, whose body holds `offset`; of nested ones the inner."""
    for index in range(bisect_left(begins, offset) - 1, -1, -1):
        if functions[index].end > offset:
            return functions[index]
        if index and functions[index - 1].end < begins[index]:
            return None  # a body that ends before the next begins holds no other
    return None


def hide(data: bytes) -> bytes:
    """Blank out comments, literals and preprocessor lines; offsets stay as they are, quotes too."""

    def blank(match: re.Match[bytes]) -> bytes:
        text = match.group()
        kept = re.sub(rb"[^\n]", b" ", text)
        return text[:1] + kept[1:-1] + text[-1:] if text[:1] in b"\"'" and len(text) > 1 else kept

    return _HIDDEN.sub(blank, data)


def declared_names(rows: Rows) -> Names:
    """The names of what the facts `rows` declare."""
    callable_kinds = {str(function) for function, kind in rows["function"] if kind in ("function", "method", "static_method")}
    constructors = {str(function) for function, kind in rows["function"] if kind == "constructor"}
    classes = {str(function): str(owner) for function, owner in rows["function_class"] if function in constructors}
    names = Names({}, {}, classes, {}, {}, {}, {})
    for function, name in rows["function_name"]:
        if function in constructors:
            names.constructors.setdefault(str(name).rpartition("::")[2], []).append((classes.get(str(function), ""), str(function)))
        elif function in callable_kinds:
            names.functions.setdefault(str(name).rpartition("::")[2], []).append((str(name), str(function)))
    owners = {str(variable): str(owner) for variable, owner in rows["field_class"]}
    functions = {str(variable): str(function) for variable, function in rows["variable_function"]}
    for variable, name in rows["variable_name"]:
        variable, name = str(variable), str(name)
        if variable in owners:
            _keep_last(names.fields, (owners[variable], name), variable)
            names.fields_by_name.setdefault(name, []).append(variable)
        elif variable in functions:
            _keep_last(names.locals, (functions[variable], name), variable)
        else:
            _keep_last(names.globals, name, variable)
    return names


def _keep_last(names: dict[_Key, str], key: _Key, variable: str) -> None:
    """Of several variables of one name, keep the same one in every run: the last by its identifier."""
    if names.get(key, "") <= variable:
        names[key] = variable


def _name_unknowns(unit: UnitFacts, names: Sequence[Names]) -> None:
    """An expression without type that is a plain name: the functions called so."""
    texts = {expr: str(text) for expr, text in unit.rows["expr_text"]}
    for expr, _reason in unit.rows["expr_unknown"]:
        text = texts.get(expr, "")
        if _NAME.fullmatch(text):
            for function in _functions_named(names, text):
                unit.add("function_use", expr, function)


def _constructors_named(names: Sequence[Names], text: str) -> list[str]:
    """The constructors of the class that `text` may name."""
    short = text.rpartition("::")[2]
    found = (entry for table in names for entry in table.constructors.get(short, ()))
    return [function for owner, function in found if owner == text or owner.endswith(f"::{text}")]


def _functions_named(names: Sequence[Names], text: str) -> list[str]:
    name = re.sub(r"[&\s]", "", text)
    short = name.rpartition("::")[2]
    found = (entry for table in names for entry in table.functions.get(short, ()))
    return [function for full, function in found if full == name or full.endswith(f"::{name}")]


@dataclass(frozen=True)
class _Reader:
    """Reads expressions of one function from text. `assigned` says where the assignments begin that need not be read."""

    unit: UnitFacts
    names: Sequence[Names]
    holder: FunctionSpan
    hidden: bytes
    assigned: Set[str]

    def node(self, begin: int, end: int, form: str) -> str:
        expr = self.unit.node(Span(self.holder.file, begin, end), form)
        self.unit.add("expr_function", expr, self.holder.function)
        if form in ("call", "op", "use"):
            self._place(expr, begin)
        return expr

    def _place(self, expr: str, offset: int) -> None:
        """Put an expression into the control-flow graph, behind the statement before it."""
        marks = self.unit.marks.get(self.holder.function, [])
        index = bisect_right(marks, (offset, "\uffff", 0)) - 1
        if index >= 0:
            _, block, position = marks[index]
            self.unit.add("block_expr", block, position, expr)

    def class_of(self, constructor: str) -> str:
        """The class that a constructor belongs to."""
        return next(table.classes[constructor] for table in self.names if constructor in table.classes)

    def source(self, begin: int, end: int) -> str:
        return self.holder.file.data[begin:end].decode("utf-8", "replace")

    def variable(self, name: str) -> str | None:
        """The variable that a name means in the function: local, parameter, field, global."""
        local = max(table.locals.get((self.holder.function, name), "") for table in self.names)
        own = local or max(table.fields.get((self.holder.owner, name), "") for table in self.names)
        if own:
            return own
        of_any = {field for table in self.names for field in table.fields_by_name.get(name, ())}
        return of_any.pop() if len(of_any) == 1 else max(table.globals.get(name, "") for table in self.names) or None

    def expression(self, begin: int, end: int) -> str:
        """Record the expression written at [begin, end)."""
        text = self.source(begin, end)
        lead = len(text) - len(text.lstrip())
        begin, text = begin + len(text[:lead].encode()), text.strip()
        end = begin + len(text.encode())
        for read in (self._literal, self._sum, self._name, self._call):
            expr = read(text, begin, end)
            if expr is not None:
                self.unit.add("expr_text", expr, " ".join(text.split())[:TEXT_LIMIT])
                return expr
        expr = self.node(begin, end, "unknown")
        self.unit.add("expr_unknown", expr, "recovered")
        self.unit.add("expr_text", expr, " ".join(text.split())[:500])
        return expr

    def _literal(self, text: str, begin: int, end: int) -> str | None:
        if _STRINGS.fullmatch(text):
            kind, value = "string", decode_string('"' + "".join(re.findall(r"\"((?:\\.|[^\"\\])*)\"", text)) + '"')
        elif _NUMBER.fullmatch(text):
            value = text.rstrip("fFuUlL")
            kind = "float" if "." in value or "e" in value.lower() else "integer"
        elif text in ("true", "false"):
            kind, value = "boolean", text
        else:
            return None
        expr = self.node(begin, end, "str" if kind == "string" else "num")
        self.unit.add("literal", expr, kind, value)
        return expr

    def _sum(self, _text: str, begin: int, end: int) -> str | None:
        parts = list(split(self.hidden[begin:end], b"+"))
        if len(parts) < 2:
            return None
        total = self.expression(begin + parts[0][0], begin + parts[0][1])
        for start, stop in parts[1:]:
            right = self.expression(begin + start, begin + stop)
            expr = self.node(begin, begin + stop, "op")
            self.unit.add("operator", expr, "+")
            self.unit.add("operand", expr, 0, total)
            self.unit.add("operand", expr, 1, right)
            total = expr
        return total

    def _name(self, text: str, begin: int, end: int) -> str | None:
        if not _NAME.fullmatch(text):
            return None
        if text == "this":
            return self.this(begin, end)
        variable = None if "&" in text or "::" in text else self.variable(re.split(r"\.|->", text)[-1].strip())
        if variable is not None:
            expr = self.node(begin, end, "use")
            self.unit.add("variable_use", expr, variable)
            return expr
        functions = _functions_named(self.names, text)
        if not functions:
            return None
        expr = self.node(begin, end, "fn")
        for function in functions:
            self.unit.add("function_use", expr, function)
        return expr

    def this(self, begin: int, end: int | None = None) -> str:
        """The object that the function is a method of, written or not."""
        expr = self.node(begin, begin if end is None else end, "this")
        self.unit.add("this_use", expr, self.holder.owner)
        return expr

    def _call(self, _text: str, begin: int, end: int) -> str | None:
        match = _CALL.match(self.hidden, begin, end)
        if match is None or _closing(self.hidden, match.end() - 1) != end - 1:
            return None
        return _recover_call(self, match)


def _recover_call(reader: _Reader, match: re.Match[bytes]) -> str | None:
    """Record one call; a plain name must be that of a function, so that declarations are not taken for calls."""
    unit, holder, text = reader.unit, reader.holder, reader.hidden
    name = match.group("name").decode()
    receiver = match.group("receiver")
    made = not receiver and _NEW.search(text, max(0, match.start("name") - 20), match.start("name"))
    functions = [] if receiver else _constructors_named(reader.names, name) if made else _functions_named(reader.names, name)
    if not receiver and not functions and not made and "::" in name:  # declared by a header that brings no rows of its own
        functions = [name]
        unit.add("function", name, "function")
        unit.add("function_name", name, name)
    close = _closing(text, match.end() - 1)
    seen = unit.call_sites[id(holder.file)]
    inherited = not (receiver or functions or made) and _may_be_inherited(reader, name, match.start("name"))
    if name in _KEYWORDS or close is None or not (receiver or functions or inherited) or match.end("name") in seen:
        return None
    seen.add(match.end("name"))
    begin = match.start("receiver") if receiver else match.start("name")
    call = reader.node(begin, close + 1, "call")
    unit.recovered[id(holder.file), match.end("name")] = call
    unit.add("call", call, name.rpartition("::")[2])
    unit.add("call_unresolved", call, "recovered")
    unit.add("expr_text", call, holder.file.text(begin, close + 1)[:500])
    for function in functions:
        unit.add("call_function", call, function)
        if made:
            unit.add("call_constructs", call, reader.class_of(function))
    if receiver:
        unit.add("call_receiver", call, reader.expression(match.start("receiver"), match.end("receiver")))
    elif inherited:
        unit.add("call_receiver", call, reader.this(begin))
    for index, (start, stop) in enumerate(split(text[match.end() : close], b",")):
        if text[match.end() + start : match.end() + stop].strip():
            unit.add("call_argument", call, index, reader.expression(match.end() + start, match.end() + stop))
    _recover_target(reader, call, begin)
    _recover_types(reader, call, (match.group("types") or b"")[1:-1], [reader.class_of(function) for function in functions if made])
    return call


def _may_be_inherited(reader: _Reader, name: str, begin: int) -> bool:
    """Whether a call of `name`, which begins there and is of no function that is known, may be one of a method of a base class."""
    bases = {row[0] for row in reader.unit.rows["class_base"]}
    plain = "::" not in name and not name[:1].isupper() and reader.variable(name) is None
    return plain and reader.holder.owner in bases and bool(_IN_EXPRESSION.search(reader.hidden, max(0, begin - 80), begin))


def _recover_types(reader: _Reader, call: str, written: bytes, classes: list[str]) -> None:
    """Template arguments: those of the call, or those of the class of which it makes an instance."""
    unit = reader.unit
    parts = split(written.replace(b"<", b"(").replace(b">", b")"), b",") if written else ()
    arguments = [declare_unknown_type(unit, written[start:stop].decode()) for start, stop in parts]
    for index, argument in enumerate(arguments):
        unit.add("call_template_argument", call, index, argument)
    for owner in sorted(set(classes)):
        instance = f"?{owner}<{', '.join(arguments)}>"
        unit.add("expr_type", call, instance)
        unit.add("type_class", instance, owner)
        for index, argument in enumerate(arguments):
            unit.add("type_argument", instance, index, argument)


def _recover_target(reader: _Reader, call: str, begin: int) -> None:
    """`variable = call`, `Type variable = call`: the call's value becomes the variable's."""
    data = reader.holder.file.data
    match = _TARGET.search(data[max(0, begin - 200) : begin])
    variable = reader.variable(match.group(1).decode()) if match else None
    if match is None or variable is None:
        return
    start = max(0, begin - 200) + match.start(1)
    line, column = reader.holder.file.line_column(start)
    if f"{reader.holder.file.label}:{line}:{column}" in reader.assigned:
        return  # of what clang could not determine: `call_remnant` says that this is the call
    assignment = reader.node(start, begin, "op")
    reader.unit.add("operator", assignment, "=")
    reader.unit.add("operand", assignment, 0, reader.expression(start, start + len(match.group(1))))
    reader.unit.add("operand", assignment, 1, call)


def _closing(text: bytes, start: int) -> int | None:
    depth = 0
    for offset in range(start, min(len(text), start + 20_000)):
        char = text[offset]
        if char == 0x28:
            depth += 1
        elif char == 0x29:
            depth -= 1
            if depth == 0:
                return offset
    return None


def split(text: bytes, separator: bytes) -> Iterator[tuple[int, int]]:
    """The parts of hidden text between separators outside brackets and literals, as offsets."""
    depth, start, quoted = 0, 0, 0
    for offset, char in enumerate(text):
        if quoted:
            quoted = 0 if char == quoted else quoted
        elif char in b"\"'":
            quoted = char
        elif char in b"([{":
            depth += 1
        elif char in b")]}":
            depth -= 1
        elif depth == 0 and char == separator[0] and text[offset - 1 : offset] != separator and text[offset + 1 : offset + 2] != separator:
            yield start, offset
            start = offset + 1
    yield start, len(text)
