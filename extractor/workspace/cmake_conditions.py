"""The condition language of `if`, `elseif` and `while`.

Source: https://cmake.org/cmake/help/latest/command/if.html (precedence: parentheses, unary tests, binary tests, NOT, AND, OR).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.base.patterns import PatternError
from rosarch.extractor.workspace.cmake_expand import is_true, split_list
from rosarch.extractor.workspace.cmake_regex import compile_regex


@dataclass(frozen=True, slots=True)
class Word:
    """One argument of a condition after expansion; a quoted word is neither a keyword nor a variable."""

    text: str
    quoted: bool


@dataclass(frozen=True)
class CMakeEnvironment:
    """What a condition may ask the evaluator."""

    value: Callable[[str], str | None]
    defined: Callable[[str], bool]
    is_command: Callable[[str], bool]
    is_target: Callable[[str], bool]
    exists: Callable[[str], bool]
    is_directory: Callable[[str], bool]
    set_matches: Callable[[Sequence[str]], None]


class ConditionError(ValueError):
    """The words do not form a condition."""


def evaluate(words: Sequence[Word], around: CMakeEnvironment) -> bool:
    """The truth of a condition."""
    parser = _Condition(words, around)
    result = parser.disjunction()
    if parser.position < len(words):
        raise ConditionError(f"unexpected `{words[parser.position].text}` in condition")
    return result


_NUMERIC: dict[str, Callable[[float, float], bool]] = {
    "EQUAL": lambda a, b: a == b,
    "LESS": lambda a, b: a < b,
    "GREATER": lambda a, b: a > b,
    "LESS_EQUAL": lambda a, b: a <= b,
    "GREATER_EQUAL": lambda a, b: a >= b,
}
_STRING: dict[str, Callable[[str, str], bool]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
    "STRLESS_EQUAL": lambda a, b: a <= b,
    "STRGREATER_EQUAL": lambda a, b: a >= b,
}
_BINARY = {*_NUMERIC, *_STRING, *("VERSION_" + name for name in _NUMERIC), "MATCHES", "IN_LIST", "IS_NEWER_THAN", "PATH_EQUAL"}
_UNARY = {"EXISTS", "COMMAND", "DEFINED", "TARGET", "POLICY", "TEST", "IS_DIRECTORY", "IS_SYMLINK", "IS_ABSOLUTE", "IS_READABLE"}


class _Condition:
    def __init__(self, words: Sequence[Word], around: CMakeEnvironment) -> None:
        self.words = words
        self.around = around
        self.position = 0

    def keyword(self, offset: int = 0) -> str:
        """The unquoted word ahead, or an empty text."""
        index = self.position + offset
        if index < len(self.words) and not self.words[index].quoted:
            return self.words[index].text
        return ""

    def disjunction(self) -> bool:
        result = self.conjunction()
        while self.keyword() == "OR":
            self.position += 1
            result = self.conjunction() or result
        return result

    def conjunction(self) -> bool:
        result = self.negation()
        while self.keyword() == "AND":
            self.position += 1
            result = self.negation() and result
        return result

    def negation(self) -> bool:
        if self.keyword() == "NOT":
            self.position += 1
            return not self.negation()
        return self.comparison()

    def comparison(self) -> bool:
        if self.keyword() == "(":
            self.position += 1
            result = self.disjunction()
            if self.keyword() != ")":
                raise ConditionError("missing `)` in condition")
            self.position += 1
            return result
        if self.position >= len(self.words):
            raise ConditionError("condition ends too early")
        if self.keyword() in _UNARY and self.position + 1 < len(self.words) and self.keyword(1) not in _BINARY:
            return self.unary()
        left = self.words[self.position]
        if self.keyword(1) in _BINARY and self.position + 2 < len(self.words):
            operator = self.keyword(1)
            right = self.words[self.position + 2]
            self.position += 3
            return self.binary(left, operator, right)
        self.position += 1
        return self.truth(left)

    def unary(self) -> bool:
        operator = self.keyword()
        operand = self.words[self.position + 1].text
        self.position += 2
        if operator == "DEFINED":
            return self.around.defined(operand)
        if operator == "COMMAND":
            return self.around.is_command(operand)
        if operator == "TARGET":
            return self.around.is_target(operand)
        if operator == "IS_DIRECTORY":
            return self.around.is_directory(operand)
        if operator == "IS_SYMLINK":
            return Path(operand).is_symlink()
        if operator == "IS_ABSOLUTE":
            return operand.startswith("/")
        if operator == "POLICY":
            return True
        return operator != "TEST" and self.around.exists(operand)

    def truth(self, word: Word) -> bool:
        constant = is_true(word.text)
        if constant is not None:
            return constant
        if word.quoted:
            return False
        value = self.around.value(word.text)
        return value is not None and is_true(value) is not False

    def operand(self, word: Word) -> str:
        """Unquoted words that name a variable stand for its value."""
        if word.quoted:
            return word.text
        value = self.around.value(word.text)
        return word.text if value is None else value

    def binary(self, left: Word, operator: str, right: Word) -> bool:
        a = self.operand(left)
        if operator == "MATCHES":
            return self.matches(a, right.text)
        if operator == "IN_LIST":
            return a in split_list(self.around.value(right.text) or "")
        b = self.operand(right)
        if operator in _STRING:
            return _STRING[operator](a, b)
        if operator.startswith("VERSION_"):
            return _NUMERIC[operator[8:]](compare_versions(a, b), 0)
        if operator in _NUMERIC:
            try:
                return _NUMERIC[operator](float(a), float(b))
            except ValueError:
                return False
        return operator == "IS_NEWER_THAN" or a.rstrip("/") == b.rstrip("/")

    def matches(self, text: str, pattern: str) -> bool:
        try:
            found = compile_regex(pattern).search(text)
        except PatternError as error:
            raise ConditionError(str(error)) from error
        if found:
            self.around.set_matches(found)
        return found is not None


def compare_versions(a: str, b: str) -> int:
    """Negative, zero or positive; components are integers, missing ones are zero."""
    left, right = _components(a), _components(b)
    width = max(len(left), len(right))
    left += [0] * (width - len(left))
    right += [0] * (width - len(right))
    return (left > right) - (left < right)


def _components(version: str) -> list[int]:
    result = []
    for part in version.split("."):
        digits = re.match(r"\d+", part)
        if not digits:
            break
        result.append(int(digits.group()))
        if digits.end() < len(part):
            break
    return result
