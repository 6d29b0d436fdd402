"""Inputs made from seeds: the same ones for the same seed of the generator, with no tool installed."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Sequence

LONGEST = 32 << 10
"""Bytes of an input; what grows faster than its input shows well before."""
_NESTING = (b"()", b"[]", b"{}", b"<a></a>", b"${}", b"$()", b'""', b"''", b"<!---->", b"/**/")
_ODD = (
    b"\0", b"\xff\xfe", b"\xc3", b"\xef\xbb\xbf", "\u202e\u2028".encode(), "\U00100042".encode(), b"\x1b[31m", b"\r", b"\t", b"\n", b" ",
    b"-1", b"0", b"99999999999999999999", b"1e999", b"nan", b"%999999999d", b"\\", b"..", b"../../etc/passwd", b"&a", b"*a", b"!!python/name:os.system",
)  # fmt: skip

Mutation = Callable[[random.Random, bytes, Sequence[bytes]], bytes]


def mutants(seeds: Sequence[bytes], words: Sequence[bytes], count: int, seed: str) -> Iterator[bytes]:
    """`count` inputs: the seeds as they are, then changed ones; `words` mean something to the reader of them."""
    yield from seeds[:count]
    chance = random.Random(seed)
    tokens = [*words, *_ODD]
    for _ in range(count - len(seeds)):
        yield mutant(chance, chance.choice(seeds), [*seeds, *tokens])


def mutant(chance: random.Random, data: bytes, pieces: Sequence[bytes]) -> bytes:
    """An input changed in one to five places, most in one: what is broken in many is refused early."""
    for _ in range(min(5, 1 + int(chance.expovariate(1.2)))):
        data = chance.choice(_MUTATIONS)(chance, data, pieces)[:LONGEST]
    return data


def _span(chance: random.Random, data: bytes) -> tuple[int, int]:
    begin = chance.randrange(len(data) + 1)
    return begin, min(len(data), begin + int(chance.expovariate(1 / 24)))


def _flip(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    at = chance.randrange(len(data) + 1)
    return data[:at] + bytes([chance.randrange(256)]) + data[at + 1 :]


def _remove(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    begin, end = _span(chance, data)
    return data[:begin] + data[end:]


def _insert(chance: random.Random, data: bytes, pieces: Sequence[bytes]) -> bytes:
    at = chance.randrange(len(data) + 1)
    return data[:at] + chance.choice(pieces) + data[at:]


def _replace(chance: random.Random, data: bytes, pieces: Sequence[bytes]) -> bytes:
    begin, end = _span(chance, data)
    return data[:begin] + chance.choice(pieces) + data[end:]


def _move(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    begin, end = _span(chance, data)
    at = chance.randrange(len(data) + 1)
    return data[:at] + data[begin:end] + data[at:]


def _repeat(chance: random.Random, data: bytes, pieces: Sequence[bytes]) -> bytes:
    begin, end = _span(chance, data)
    piece = data[begin:end] if chance.random() < 0.7 else chance.choice(pieces)
    return data[:end] + piece * int(2 ** chance.uniform(1, 14)) + data[end:]


def _nest(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    begin, end = _span(chance, data)
    pair = chance.choice(_NESTING)
    left, right, times = pair[: len(pair) // 2], pair[len(pair) // 2 :], int(2 ** chance.uniform(0, 13))
    return data[:begin] + left * times + data[begin:end] + right * times + data[end:]


def _cut(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    return data[: chance.randrange(len(data) + 1)]


def _line(chance: random.Random, data: bytes, _pieces: Sequence[bytes]) -> bytes:
    """A line dropped, doubled or moved: what is written line by line stays well-formed."""
    lines = data.splitlines(keepends=True) or [b""]
    at, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    line = lines[at]
    if chance.random() < 0.6:
        del lines[at]
    lines[other:other] = [line] * chance.choice((0, 1, 1, 2, 50))
    return b"".join(lines)


_VALUE = re.compile(rb"\"[^\"<\n]*\"|'[^'<\n]*'|(?<=[>:=])[^<>\n:=]+(?=[<\n])")


def _value(chance: random.Random, data: bytes, pieces: Sequence[bytes]) -> bytes:
    """What stands in quotes, in an element or behind a colon, replaced as a whole or in part."""
    found = list(_VALUE.finditer(data))
    if not found:
        return _insert(chance, data, pieces)
    begin, end = chance.choice(found).span()
    piece = chance.choice(pieces) if chance.random() < 0.7 else data[slice(*chance.choice(found).span())]
    piece = piece.strip(b"\"'").replace(b"<", b"").replace(b'"', b"")
    at = chance.choice((begin + 1, end - 1))
    return data[: begin + 1] + piece + data[end - 1 :] if chance.random() < 0.6 else data[:at] + piece + data[at:]


_MUTATIONS: tuple[Mutation, ...] = (
    _line,
    _line,
    _value,
    _value,
    _value,
    _flip,
    _remove,
    _insert,
    _insert,
    _replace,
    _replace,
    _move,
    _repeat,
    _nest,
    _cut,
)
