"""Names to declare in place of headers that are absent, and the header that declares them all permissively."""

from __future__ import annotations

import hashlib
import os
import re
import zlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rosarch.base.whole import write_whole
from rosarch.extractor.cxx.assumed import assumed_struct, assumed_text
from rosarch.extractor.cxx.includes import HEALED, SHIPPED

UNKNOWN = "rosarch_healed::unknown"

_RANK = {"value": 1, "constant": 2, "function": 3, "class": 4, "template": 5, "base": 6, "namespace": 7}
_TYPES = ("class", "template", "base")
_MEMBER_KINDS = (
    "function",
    "constant",
    "value",
    "template",
)  # a value can be called, a function cannot be read; template arguments need a template
_NAME = re.compile(r"[A-Za-z_]\w*")
_ROS1_PARTS = re.compile(r"^  int (request|response);\n", re.MULTILINE)
_KEYWORDS = frozenset(
    {"void", "int", "unsigned", "signed", "long", "short", "char", "bool", "float", "double", "auto", "const", "static"}
    | {"class", "struct", "union", "enum", "template", "typename", "operator"}
)
_RESERVED = frozenset(
    {"alignof", "and", "asm", "auto", "bool", "break", "case", "catch", "char", "class", "const", "constexpr", "continue", "decltype"}
    | {"default", "delete", "do", "double", "else", "enum", "explicit", "extern", "false", "float", "for", "friend", "goto", "if"}
    | {"inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "nullptr", "operator", "or", "private", "protected"}
    | {"public", "register", "return", "short", "signed", "sizeof", "static", "struct", "switch", "template", "this", "throw", "true"}
    | {"try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual", "void", "volatile", "while", "begin", "end"}
)
"""No members: words of the language, and what a value of unknown type has already."""
_MEMBER = re.compile(rb"(?:\.|->)(?:template\s+)?([A-Za-z_]\w*)")
_ARGUMENTS = re.compile(rb"\s*(<[\w\s:,*&.]*(?:<[\w\s:,*&.]*>[\w\s:,*&.]*)*>)?\s*\(")


@dataclass
class Node:
    """A name with the names inside it; `kind` is a key of the ranks above: a later, higher one replaces a lower one.

    `certain` says that clang knows it as a namespace; by `::` behind a name alone it may be a class.
    """

    kind: str
    parameters: str = "typename..."
    certain: bool = False
    inner: dict[str, Node] = field(default_factory=dict)

    def render(self, name: str, member: bool) -> Iterator[str]:
        """The declaration, line by line; `member` of a class."""
        if self.kind == "namespace" and not member:
            yield f"namespace {name} {{"
            yield from _render_all(self.inner, False)
            yield "}"
        elif self.kind == "value":
            yield f"{'static' if member else 'extern'} {UNKNOWN} {name};"
        elif self.kind == "constant":
            yield f"{'static ' if member else ''}constexpr int {name} = {_number(name)};"
        elif self.kind == "function":
            yield f"template <typename... T, typename... A> {'static ' if member else ''}{UNKNOWN}& {name}(A&&...);"
        else:
            yield from self._render_class(name)

    def _render_class(self, name: str) -> Iterator[str]:
        if self.kind == "template":
            yield f"template <{self.parameters}>"
        # a base is no unknown value: what derives from it would convert to everything
        yield f"struct {name}{'' if self.kind == 'base' else f' : {UNKNOWN}'} {{"
        yield f"{name}(); template <typename A, typename... B> {name}(A&&, B&&...);"
        if self.kind == "base":
            yield f"virtual ~{name}();"
        elif self.kind == "class":
            yield f"template <typename A> {name}& operator=(A&&);"
            yield f"{name}* operator&(); const {name}* operator&() const;"
            yield f"typedef boost::shared_ptr<{name}> Ptr; typedef boost::shared_ptr<const {name}> ConstPtr;"
        yield from _render_all({key: node for key, node in self.inner.items() if key not in (name, "Ptr", "ConstPtr")}, True)
        yield "};"


def _member_rank(kind: str) -> int:
    return _MEMBER_KINDS.index(kind) if kind else -1


def kind_of_member(text: bytes, offset: int) -> str:
    """What a member is by what follows its name: `<...>(`, `(` or neither."""
    match = _ARGUMENTS.match(text, offset)
    return "value" if match is None else "template" if match.group(1) else "function"


def _render_all(nodes: dict[str, Node], member: bool) -> Iterator[str]:
    for name, node in sorted(nodes.items()):
        yield from node.render(name, member)


def _number(name: str) -> int:
    """A value for a constant of unknown value: it only has to make a case label."""
    return zlib.crc32(name.encode()) & 0x7FFFFFFF


@dataclass
class Wanted:
    """All that is to be declared; `changed` says whether something was added.

    `messages` holds, by header and struct, the members of messages of which only the name is known, each with its kind (`type` for one of
    a field's type); `interfaces` the headers of those that the source does not include, where `interfaces_by_scope` says that such names
    are those of interfaces; `bases` the absent base classes of a class of the workspace; `read` the files whose members are wanted;
    `defined` are macros that are never wanted: they are there; `homes` the namespaces that names belong to which are written without them.
    """

    scratch: Path
    interfaces_by_scope: bool = False
    interfaces: set[str] = field(default_factory=set)
    top: dict[str, Node] = field(default_factory=dict)
    macros: dict[str, str] = field(default_factory=dict)
    defined: set[str] = field(default_factory=set)
    members: dict[str, str] = field(default_factory=dict)
    messages: dict[tuple[str, str], dict[str, str]] = field(default_factory=dict)
    bases: dict[str, set[str]] = field(default_factory=dict)
    banned: set[str] = field(default_factory=set)
    homes: dict[str, tuple[str, ...]] = field(default_factory=dict)
    read: set[str] = field(default_factory=set)
    changed: bool = False

    def name(self, path: Sequence[str], kind: str, parameters: str = "") -> None:
        """Want the qualified name `path`; what encloses it is a namespace, or a class by its capital letter."""
        if path[-1] in self.banned or any(part in _KEYWORDS or not _NAME.fullmatch(part) for part in path) or self._interface(path):
            return
        path = [*self.homes.get(path[0], ()), *path]
        scope, inside = self.top, False
        for part in path[:-1]:
            inside = inside or (part[:1].isupper() and (part not in scope or scope[part].kind != "namespace"))
            scope = self._put(scope, part, "class" if inside else "namespace").inner
        node = self._put(scope, path[-1], kind)
        if parameters and parameters != node.parameters == "typename...":
            node.parameters, self.changed = parameters, True

    def _interface(self, path: Sequence[str]) -> bool:
        """Want the interface that `path` names, `package::msg::Name`, which no header declares that the source includes."""
        struct = assumed_struct(path[:3]) if self.interfaces_by_scope and len(path) > 2 else None
        if struct is None:
            return False
        header = struct[0]
        text = assumed_text(header)
        if not re.search(rf"\b{path[2]}\b", text):  # the name of the header does not give that of the message
            return False
        _write(self._message(header), text)
        self.changed |= header not in self.interfaces
        self.interfaces.add(header)
        self.messages.setdefault(struct, {})
        return True

    def namespace(self, path: Sequence[str]) -> None:
        """Take `path` for namespaces, however they are spelled."""
        scope = self.top
        for part in path:
            if part in self.banned:
                return
            node = self._put(scope, part, "namespace")
            node.certain, scope = True, node.inner

    def _put(self, scope: dict[str, Node], name: str, kind: str) -> Node:
        node = scope.get(name)
        if node is None:
            node = scope[name] = Node(kind)
            self.changed = True
        elif node.kind == "namespace":
            if kind in _TYPES and not node.certain:
                node.kind, self.changed = kind, True
        elif _RANK[kind] > _RANK[node.kind] and not (kind == "namespace" and node.kind in _TYPES):
            node.kind, self.changed = kind, True
        return node

    def members_in(self, data: bytes) -> None:
        """Want of values of unknown type what any object in a text is asked for: which objects these are, clang reports one by one."""
        for match in _MEMBER.finditer(data):
            name, kind = match.group(1).decode(), kind_of_member(data, match.end())
            if name not in _RESERVED and _member_rank(kind) > _member_rank(self.members.get(name, "")):
                self.members[name] = kind

    def macro(self, name: str, body: str) -> None:
        """Want a macro."""
        if name not in self.banned | self.defined and self.macros.get(name) != body:
            self.macros[name], self.changed = body, True

    def undefined(self, bodies: Mapping[str, str], defined: Collection[str]) -> None:
        """Want macros by their bodies; one that calls its own name needs a function of it. Those that are `defined` are never wanted."""
        for name, body in bodies.items():
            self.macro(name, body)
            if body.startswith(f"(...) {name}("):
                self.name([name], "function")
        self.defined |= {*bodies, *defined}

    def correct(self, name: str, kind: str) -> None:
        """Take what was declared as class or value for something else: clang does not accept it where it is used."""
        for scope in self._scopes():
            node = scope.get(name)
            if node is None or node.kind == kind:
                continue
            guessed = node.kind in ("class", "value") and not node.inner
            if guessed or (node.kind == "namespace" and kind == "class" and not node.certain):
                node.kind, self.changed = kind, True

    def correct_to_type(self, name: str) -> None:
        """Take what was declared as a value, or as a constant of a message, for a type."""
        self.correct(name, "class")
        for fields in self.messages.values():
            if fields.get(name) == "constant":
                fields[name], self.changed = "type", True

    def _scopes(self) -> list[dict[str, Node]]:
        found = [self.top]
        for scope in found:
            found += [node.inner for node in scope.values()]
        return found

    def nested(self, name: str) -> bool:
        """Whether the name is wanted in a namespace or class."""
        return any(name in scope for scope in self._scopes()[1:])

    def find(self, path: Sequence[str]) -> Node | None:
        """What is wanted under a qualified name."""
        scope, node = self.top, None
        for part in path:
            node = scope.get(part)
            if node is None:
                return None
            scope = node.inner
        return node

    def member(self, owner: str, name: str, kind: str) -> None:
        """Want member `name` of the class that clang spells `owner`, if that class is a stand-in."""
        owner = re.sub(r"\b(?:const|volatile|struct|class)\b|<.*", "", owner).strip()
        path = owner.split("::")
        struct = assumed_struct(path)
        if owner == UNKNOWN and kind != "type":
            if name not in _RESERVED and _member_rank(kind) > _member_rank(self.members.get(name, "")):
                self.members[name], self.changed = kind, True
        elif struct is not None and self.find(path) is None and os.path.isfile(self._message(struct[0])):
            fields = self.messages.setdefault(struct, {})
            if name not in fields or (kind == "type" and fields[name] != kind):  # clang is certain of types; the text around a name is not
                fields[name], self.changed = kind, True
        elif kind == "type":
            return
        elif self.find(path) is not None:
            self.name([*path, name], "function" if kind == "template" else kind)
        else:
            for base in sorted(self.bases.get(path[-1], ())):
                self.name([*base.split("::"), name], "function" if kind == "template" else kind)

    def _message(self, header: str) -> Path:
        """Where the stand-in of a message is of which only the name is known (see `HeaderFinder`)."""
        return self.scratch / "absent" / str(header.count("/")) / header

    def settle(self, names: Collection[str]) -> set[str]:
        """Want names of two that are ambiguous only in the namespace that `using namespace` brings in; return those that this settles."""
        settled = set()
        for name in sorted(names):
            homes = [path for path, scope in self._namespaces(()) if path and name in scope]
            outer = self.top.get(name)
            if outer is not None and len(homes) == 1:
                del self.top[name]
                self.homes[name] = homes[0]
                self._want_again((name,), outer)
                settled.add(name)
        return settled

    def _want_again(self, path: tuple[str, ...], node: Node) -> None:
        self.name(path, node.kind, node.parameters)
        for name, inner in node.inner.items():
            self._want_again((*path, name), inner)

    def _namespaces(self, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], dict[str, Node]]]:
        """The wanted namespaces and what is in them."""
        node = self.find(path)
        scope = node.inner if node else self.top
        yield path, scope
        for name, inner in scope.items():
            if inner.kind == "namespace":
                yield from self._namespaces((*path, name))

    def ban(self, names: Collection[str]) -> bool:
        """Leave out names that the workspace declares itself; the outermost of that name is in its way. Return whether any is new."""
        new = not self.banned.issuperset(names)
        for name in sorted(names):
            self.banned.add(name)
            if self.top.pop(name, None) is None and self.macros.pop(name, None) is None:
                for scope in self._scopes():
                    scope.pop(name, None)
        return new

    def write(self) -> Path:
        """Write `healed.h` and the messages; return their folder."""
        unknown = " ".join(
            f"template <typename... T, typename... A> unknown& {name}(A&&...) const;"
            if kind in ("function", "template")
            else f"static unknown {name};"
            for name, kind in sorted(self.members.items())
        )
        lines = ["#pragma once", f"#define ROSARCH_UNKNOWN_MEMBERS {unknown}", f'#include "{SHIPPED / "healing.h"}"']
        lines += ["#include <boost/shared_ptr.hpp>", *_render_all(self.top, False)]
        lines += [f'#include "{header}"' for header in sorted(self.interfaces)]
        lines += [
            f"#ifndef {name}\n#define {name}{'' if body.startswith('(') else ' '}{body}\n#endif"
            for name, body in sorted(self.macros.items())
        ]
        files = {header: self._message_text(header) for header, _ in sorted(self.messages)}
        files[HEALED] = "\n".join(lines) + "\n"
        key = hashlib.sha1("\0".join([*files, *files.values()]).encode(), usedforsecurity=False).hexdigest()[:16]
        folder = self.scratch / "healed" / key
        for name, text in files.items():
            _write(folder / name, text)
        return folder

    def _message_text(self, header: str) -> str:
        """The stand-in of a message, or of the parts of a service, with the fields that code uses."""
        text = self._message(header).read_text(encoding="utf-8")
        for (own, struct), fields in sorted(self.messages.items()):
            if own == header:
                text = _with_fields(text, struct, fields)
        return text


_FIELD = {"constant": "  static constexpr int {name} = {number};\n", "type": "  typedef {unknown}_named {name};\n"}


def _with_fields(text: str, struct: str, fields: Mapping[str, str]) -> str:
    """The stand-in `text` in which `struct` has these members."""
    added = "".join(
        _FIELD.get(kind, "  {unknown} {name};\n").format(name=name, number=_number(name), unknown=UNKNOWN)
        for name, kind in sorted(fields.items())
    )
    text = _ROS1_PARTS.sub(lambda part: "" if part[1] in fields else f"  {UNKNOWN} {part[1]};\n", text)
    return text.replace(f"struct {struct} {{\n", f"struct {struct} {{\n{added}", 1)


def _write(path: Path, text: str) -> None:
    if not path.is_file():
        write_whole(path, text.encode())
