"""Macros of absent headers, recognised by where they are: no C++ has a word, or a call, in these places.

`DECLARE(int, x)` in a class, `LOAD(x)` without a semicolon, `FOR_EACH(x, list) {`, `void API f()`. Clang takes them for declarations, and
loses what follows. The places are found in the text; what a macro does is not known, so that it leaves of its arguments what is code.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from typing import NamedTuple

_TOKEN = re.compile(rb"[A-Za-z_]\w*|::|->|\d[\w.']*|\"[^\"]*\"|'[^']*'|\S")
_DEFINITION = re.compile(rb"^[ \t]*#[ \t]*define[ \t]+(\w+)(\([^)\n]*\))?((?:\\\r?\n|[^\n])*)", re.MULTILINE)
_CAPITALS = re.compile(r"[A-Z][A-Z0-9_]{2,}")
_WORD = re.compile(r"[A-Za-z_]\w*")
_OPENING = {"(": ")", "{": "}", "[": "]"}
_ACCESS = frozenset({"public", "protected", "private", "signals", "slots"})
_QUALIFIERS = frozenset({"const", "override", "final", "noexcept", "volatile", "&"})
_TYPES = frozenset(
    {
        "bool",
        "char",
        "class",
        "const",
        "double",
        "enum",
        "float",
        "int",
        "long",
        "short",
        "signed",
        "struct",
        "typename",
        "unsigned",
        "void",
    }
)
_DECLARING = _TYPES | {
    "constexpr",
    "explicit",
    "extern",
    "friend",
    "inline",
    "mutable",
    "static",
    "template",
    "typedef",
    "using",
    "virtual",
}
_SPECIFIERS = _DECLARING - {"bool", "char", "double", "float", "int", "long", "short", "signed", "unsigned", "void"}
_STATEMENTS = frozenset({"break", "case", "continue", "delete", "do", "for", "goto", "if", "return", "switch", "throw", "try", "while"})
_CONTROL = _STATEMENTS | {"catch", "else", "constexpr", "and", "or", "not", "sizeof", "decltype", "alignas", "noexcept"}
_DEEPEST = 8

Scope = str
"""namespace, class or function: what the declarations and statements are in; block is the head of a loop or block in a function."""


class _Token(NamedTuple):
    text: str
    begin: int


class Use(NamedTuple):
    """A macro that stands for members, declarations or statements, with the scope in which it does."""

    offset: int
    name: str
    scope: Scope


@dataclass
class Macros:
    """How the undefined macros of a text are used, by name.

    `calls` are those that are like a call but for the semicolon, `code` those of which an argument is code, with its index; `values` are
    words that are in expressions. `uses` say where they stand for something; `bodies_of_functions` where these open and close.
    """

    uses: list[Use] = field(default_factory=list)
    bodies_of_functions: list[tuple[int, int]] = field(default_factory=list)

    calls: set[str] = field(default_factory=set)
    plain: set[str] = field(default_factory=set)
    empty: set[str] = field(default_factory=set)
    loops: set[str] = field(default_factory=set)
    bare_loops: set[str] = field(default_factory=set)
    functions: set[str] = field(default_factory=set)
    code: dict[str, int] = field(default_factory=dict)
    values: set[str] = field(default_factory=set)

    def bodies(self, unknown: str) -> dict[str, str]:
        """A body for each, parameters included, that makes sense of all uses; `unknown()` is a value of unknown type."""
        bodies = {name: f"(...) {name}(__VA_ARGS__);" for name in self.calls - self.values}
        bodies |= dict.fromkeys(self.plain, "")
        bodies |= dict.fromkeys(self.empty, "(...)")
        bodies |= {name: f"({''.join(f'a{index}, ' for index in range(at))}...) __VA_ARGS__" for name, at in self.code.items()}
        bodies |= dict.fromkeys(self.functions, "(...) void ROSARCH_NUMBERED(function_of_macro_)()")
        bodies |= dict.fromkeys(self.bare_loops, f"for (; {unknown}(); )")
        return bodies | dict.fromkeys(self.loops, f"(...) for (; {unknown}(); )")


def undefined_macros(text: bytes, hidden: bytes, defined: Set[str]) -> Macros:
    """The macros that `text` uses and nothing defines: it is `hidden` without comments, literals and directives; `defined` are known."""
    own: dict[str, list[bytes]] = {}
    for match in _DEFINITION.finditer(text):
        own.setdefault(match.group(1).decode(), []).append(match.group(3).replace(b"\\\n", b" ").replace(b"\\\r\n", b" "))
    found = Macros()
    _Scanner(hidden, own, defined, found).statements("namespace", "")
    return found


class _Scanner:
    """Reads the declarations and statements of a text; that of a macro's definition is at the `place` of its use, else this is -1."""

    def __init__(
        self, text: bytes, own: Mapping[str, Sequence[bytes]], defined: Set[str], macros: Macros, *, at: int = -1, depth: int = 0
    ) -> None:
        self.place = at
        self.tokens = [_Token(match.group().decode("utf-8", "replace"), match.start()) for match in _TOKEN.finditer(text)]
        self.ends = _matching(self.tokens)
        self.starts = {end: start for start, end in self.ends.items()}
        self.own, self.defined, self.macros, self.depth = own, defined, macros, depth

    def at(self, index: int, end: int) -> str:
        """The token at `index`, empty beyond `end`."""
        return self.tokens[index].text if 0 <= index < end else ""

    def statements(self, scope: Scope, owner: str, begin: int = 0, end: int | None = None, behind: str = "") -> None:
        """Read what is at [begin, end) in a `scope`; `owner` is the class, `behind` what follows."""
        index, end = begin, len(self.tokens) if end is None else end
        while index < end:
            word = self.at(index, end)
            if word in (";", "}"):
                index += 1
            elif word in _ACCESS and self.at(index + 1, end) in (":", *_ACCESS):
                index += 2
            else:
                after = self._macro(scope, owner, index, end, behind)
                index = self._statement(scope, index, end) if after is None else after

    def _offset(self, index: int) -> int:
        return self.tokens[index].begin if self.place < 0 else self.place

    def _body(self, begin: int, end: int) -> None:
        """Read the body of a function, of which `begin` and `end` are the braces."""
        if self.place < 0 and end < len(self.tokens):
            self.macros.bodies_of_functions.append((self.tokens[begin].begin, self.tokens[end].begin))
        self.statements("function", "", begin + 1, end)

    def _undefined(self, word: str) -> bool:
        return bool(_CAPITALS.fullmatch(word)) and word not in self.defined and word not in self.own

    def _macro(self, scope: Scope, owner: str, index: int, end: int, behind: str) -> int | None:
        """Where the macro ends that a statement begins with, if it does."""
        name = self.at(index, end)
        called = self.at(index + 1, end) == "("
        after = self.ends.get(index + 1, end) + 1 if called else index + 1
        following = self.at(after, end) or behind
        if name in self.own:
            if self.depth < _DEEPEST and (scope != "function" or following != ";"):
                own = {other: bodies for other, bodies in self.own.items() if other != name}
                for body in self.own[name]:
                    inner = _Scanner(body, own, self.defined, self.macros, at=self._offset(index), depth=self.depth + 1)
                    inner.statements(scope, owner, behind=following or "}")
            return after
        if not _WORD.fullmatch(name) or name == owner:
            return None
        stands_in = scope
        if scope == "function" and following == "{" and name not in _CONTROL and name not in self.defined:
            found, stands_in = self._loop(name, called, after, end), "block"
        elif not self._undefined(name):
            found = None
        elif not called:
            return after if self._stands_alone(scope, owner, name, after, end) else None
        else:
            found = self._called(scope, name, index + 1, after, following)
        if found is not None:
            self.macros.uses.append(Use(self._offset(index), name, stands_in))
        return found

    def _loop(self, name: str, called: bool, after: int, end: int) -> int | None:
        if not called and not self._undefined(name):
            return None  # an object of a class
        (self.macros.loops if called else self.macros.bare_loops).add(name)
        stop = self.ends.get(after, end)
        self.statements("function", "", after + 1, stop)
        return stop + 1

    def _stands_alone(self, scope: Scope, owner: str, name: str, after: int, end: int) -> bool:
        """Whether a word in capitals is no type of what follows."""
        first, second = self.at(after, end), self.at(after + 1, end)
        if scope == "function":
            alone = first in _STATEMENTS or (bool(_WORD.fullmatch(first)) and second in (".", "->"))
        else:
            constructor = (first == owner and second == "(") or (second == "::" and self.at(after + 2, end) in (first, "~"))
            alone = first in _DECLARING or first in ("}", "") or constructor or (first in _ACCESS and second == ":")
            alone = alone or (bool(_WORD.fullmatch(first)) and bool(_WORD.fullmatch(second)) and second not in _QUALIFIERS)
        if alone:
            self.macros.plain.add(name)
        return alone

    def _called(self, scope: Scope, name: str, opening: int, after: int, following: str) -> int | None:
        """`NAME(...)` at the beginning of a statement."""
        code = self._code_argument(opening, after - 1)
        if code is not None and scope == "function":
            self.macros.code[name] = min(code, self.macros.code.get(name, code))
            self.statements("function", "", opening + 1, after - 1)
        elif scope != "function":
            if following == "{":
                self.macros.functions.add(name)
                self._body(after, self.ends.get(after, after))
                return self.ends.get(after, after) + 1
            if following != ";" and following != "}" and not _WORD.fullmatch(following) and following not in ("", "~", "[", "::"):
                return None
            if following in _QUALIFIERS:
                return None
            self.macros.empty.add(name)
        elif following not in ("}", "") and (not _WORD.fullmatch(following) or following == "else"):
            return None
        else:
            self.macros.calls.add(name)
        return after

    def _code_argument(self, opening: int, closing: int) -> int | None:
        """The index of the first argument that is statements."""
        argument, index = 0, opening + 1
        first = True
        while index < closing:
            word = self.tokens[index].text
            if word == ";" or (word == "{" and first):
                return argument
            first = word == ","
            argument += first
            index = self.ends.get(index, index) + 1
        return None

    def _statement(self, scope: Scope, begin: int, end: int) -> int:
        """Read one declaration or statement; where it ends."""
        index, braced = begin, False
        while index < end:
            word = self.tokens[index].text
            stop = min(self.ends.get(index, end), end)
            if word == ";":
                return index + 1
            if word == "}":
                return index
            if word == ":" and scope == "function" and self.at(begin, end) in ("case", "default"):
                return index + 1
            if word == "{":
                kind, name = self._block(scope, begin, index)
                if kind == "function" and scope != "function" and "friend" not in (token.text for token in self.tokens[begin:index]):
                    self._body(index, stop)
                elif kind:
                    self.statements(kind, name, index + 1, stop)
                else:
                    self._inside(index + 1, stop)
                index, braced = stop + 1, bool(kind) and kind != "class"
                if braced and (scope != "function" or index >= end or self.tokens[index].text not in (",", ")", ".", "(", ";")):
                    return index
                continue
            if word == "(":
                if scope != "function":
                    self._parameters(index + 1, stop)
                self._inside(index + 1, stop)
                control = scope == "function" and self.at(index - 1, end) in ("if", "for", "while", "switch")
                index = stop + 1
                if control:
                    return index
                continue
            if word in ("else", "do") and scope == "function":
                return index + 1
            if scope == "function":
                if index > begin and self._undefined(word):
                    self.macros.values.add(word)
            elif index > begin:
                self._between(begin, index, end)
            index += 1
        return end

    def _inside(self, begin: int, end: int) -> None:
        """Read what is in brackets: lambda expressions."""
        index = begin
        while index < end:
            word = self.tokens[index].text
            stop = min(self.ends.get(index, end), end)
            if word == "{" and self._is_lambda(begin, index):
                self.statements("function", "", index + 1, stop)
                index = stop
            elif word in _OPENING and word != "[":
                self._inside(index + 1, stop)
                index = stop
            elif self._undefined(word):
                self.macros.values.add(word)
            index += 1

    def _is_lambda(self, begin: int, index: int) -> bool:
        """Whether `{` at `index` opens the body of a lambda expression."""
        back = index - 1
        while back >= begin and (_WORD.fullmatch(self.tokens[back].text) or self.tokens[back].text in ("->", "::", "<", ">", "&", "*")):
            back -= 1
        if back >= begin and self.tokens[back].text == ")":
            back = self.starts.get(back, begin) - 1
        return back >= begin and self.tokens[back].text == "]"

    def _block(self, scope: Scope, begin: int, index: int) -> tuple[Scope, str]:
        """What `{` at `index` opens in what begins at `begin`: a scope, or nothing for a list; and which class."""
        words = [token.text for token in self.tokens[begin:index]]
        last = words[-1] if words else ""
        if scope == "function":
            return ("function", "") if last in ("", ")", "else", "do", "try", ":") or self._is_lambda(begin, index) else ("", "")
        if "namespace" in words or (words[:1] == ["extern"] and len(words) == 2):
            return "namespace", ""
        if "enum" in words or last == "=":
            return "", ""
        if "(" in words and ("operator" in words or not _class_of(words)):
            listed = ":" in words and "->" not in words and last not in _QUALIFIERS and (last == ">" or _WORD.fullmatch(last))
            return ("", "") if listed else ("function", "")
        name = _class_of(words)
        return ("class", name) if name else ("", "")

    def _between(self, begin: int, index: int, end: int) -> None:
        """A word in capitals within a declaration: `void API f()`, `void f() const REQUIRES(m) {`, `class N API : public B`."""
        name = self.tokens[index].text
        if not self._undefined(name):
            return
        before, after = self.at(index - 1, end), self.at(index + 1, end)
        called = after == "("
        behind = self.at(self.ends.get(index + 1, end) + 1, end) if called else after
        words = [token.text for token in self.tokens[begin:index]]
        if before in ("class", "struct"):
            macro = called and bool(_WORD.fullmatch(behind))
        elif words[-2:-1] in (["class"], ["struct"]) and behind in (":", "{"):
            macro = True
        elif ")" in words and ":" not in words and (before == ")" or before in _QUALIFIERS):
            macro = behind in ("{", ";", "=", *_QUALIFIERS) or self._undefined(behind)
        else:
            declares = _WORD.fullmatch(before) and before not in _SPECIFIERS and before != "operator"
            macro = bool(not called and declares and _WORD.fullmatch(after))
        if macro:
            (self.macros.empty if called else self.macros.plain).add(name)

    def _parameters(self, begin: int, end: int) -> None:
        """`int x UNUSED`, `int UNUSED(x)` among parameters."""
        for index in range(begin + 1, end):
            name, before, after = self.at(index, end), self.at(index - 1, end), self.at(index + 1, end)
            if not self._undefined(name) or not (_WORD.fullmatch(before) or before in ("&", "*", ">")):
                continue
            if after in ("", ",") and _WORD.fullmatch(before) and before not in _DECLARING:
                type_ = self.at(index - 2, end) if index - 2 >= begin else ""
                if type_ in ("&", "*", ">") or (_WORD.fullmatch(type_) and type_ not in _SPECIFIERS):
                    self.macros.plain.add(name)
            elif after == "(" and self.ends.get(index + 1) == index + 3:
                self.macros.code.setdefault(name, 0)


def _class_of(words: Sequence[str]) -> str:
    """The name of the class that `words` begin the definition of; empty for none."""
    for index, word in enumerate(words):
        if word in ("class", "struct", "union") and (index == 0 or words[index - 1] not in ("<", ",")):
            return _class_name(words[index + 1 :])
    return ""


def _class_name(words: Sequence[str]) -> str:
    """The name of a class by what follows `class`, macros among it; empty for that of a function that gives back a class."""
    names: list[str] = []
    depth = 0
    for word in words:
        if word == "(" and depth == 0 and not (names and _CAPITALS.fullmatch(names[-1])):
            return ""
        depth += (word == "(") - (word == ")")
        if word in (":", "<"):
            break
        if depth == 0 and _WORD.fullmatch(word) and word != "final":
            names.append(word)
    if not names:
        return "?"
    return names[-1] if _CAPITALS.fullmatch(names[0]) else names[0]


def _matching(tokens: Sequence[_Token]) -> dict[int, int]:
    """Where each bracket closes; braces that do not match end those within."""
    ends: dict[int, int] = {}
    stack: list[tuple[str, int]] = []
    for index, (text, _) in enumerate(tokens):
        if text in _OPENING:
            stack.append((_OPENING[text], index))
        elif text in (")", "]", "}"):
            if text == "}":
                while stack and stack[-1][0] != "}":
                    ends[stack.pop()[1]] = index
            if stack and stack[-1][0] == text:
                ends[stack.pop()[1]] = index
    ends.update((index, len(tokens)) for _, index in stack)
    return ends
