"""Terms to Python expressions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from rosarch.datalog.engine.runtime import full_match
from rosarch.datalog.engine.user_functors import PREFIX
from rosarch.datalog.language.domain import EvaluationError, domain
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.functors import Overload
from rosarch.datalog.language.inference import ClauseTypes, kind_of
from rosarch.datalog.language.syntax import (
    Argument,
    Branch,
    Cast,
    Constraint,
    Counter,
    Functor,
    IterationCounter,
    Nil,
    Number,
    Record,
    String,
    UserFunctor,
    Variable,
)  # fmt: skip
from rosarch.datalog.language.types import Types

# `HALF`, `MASK` and `LAST` stand for constants of the number domain.
_NUMBER_BINARY = {
    "+": "(({0} + {1} + HALF & MASK) - HALF)",
    "-": "(({0} - {1} + HALF & MASK) - HALF)",
    "*": "(({0} * {1} + HALF & MASK) - HALF)",
    "/": "divide_number({0}, {1})",
    "%": "modulo_number({0}, {1})",
    "^": "power_number({0}, {1})",
    "band": "({0} & {1})",
    "bor": "({0} | {1})",
    "bxor": "({0} ^ {1})",
    "bshl": "shift_left({0}, {1})",
    "bshr": "shift_right({0}, {1})",
    "bshru": "shift_right_unsigned({0}, {1})",
    "land": "(1 if {0} and {1} else 0)",
    "lor": "(1 if {0} or {1} else 0)",
    "lxor": "(1 if (not {0}) != (not {1}) else 0)",
}
_UNSIGNED_BINARY = {
    "+": "({0} + {1} & MASK)",
    "-": "({0} - {1} & MASK)",
    "*": "({0} * {1} & MASK)",
    "/": "quotient({0}, {1})",
    "%": "modulo_number({0}, {1})",
    "^": "power_unsigned({0}, {1})",
    "bshl": "({0} << ({1} & LAST) & MASK)",
    "bshr": "({0} >> ({1} & LAST))",
    "bshru": "({0} >> ({1} & LAST))",
    **{op: _NUMBER_BINARY[op] for op in ("band", "bor", "bxor", "land", "lor", "lxor")},
}
_FLOAT_BINARY = {
    "+": "single({0} + {1})",
    "-": "single({0} - {1})",
    "*": "single({0} * {1})",
    "/": "divide_float({0}, {1})",
    "^": "power_float({0}, {1})",
}
_BINARY = {"i": _NUMBER_BINARY, "u": _UNSIGNED_BINARY, "f": _FLOAT_BINARY}
_UNARY = {
    ("neg", "i"): "wrap(-{0})",
    ("neg", "f"): "(-{0})",
    ("bnot", "i"): "(~{0})",
    ("bnot", "u"): "(~{0} & MASK)",
    ("lnot", "i"): "(0 if {0} else 1)",
    ("lnot", "u"): "(0 if {0} else 1)",
}
_CONVERSIONS = {
    "ii": "{0}", "uu": "{0}", "ff": "{0}", "ss": "{0}",
    "if": "single({0})", "uf": "single({0})", "sf": "float_of_symbol({0})",
    "ui": "wrap({0})", "fi": "number_of_float({0})", "si": "number_of_symbol({0})",
    "iu": "({0} & MASK)", "fu": "unsigned_of_float({0})", "su": "unsigned_of_symbol({0})",
    "is": "str({0})", "us": "str({0})", "fs": "symbol_of_float({0})",
}  # fmt: skip
_COMPARISONS = {"=": "==", "!=": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}


def number_value(text: str, kind: str, bits: int = 32) -> int | float:
    """The value of a numeric constant of the given kind; ValueError when it does not fit the number domain."""
    numbers = domain(bits)
    if kind == "f":
        return numbers.single(float(text) if "x" not in text and "b" not in text else float(int(text, 0)))
    negative, digits = text.startswith("-"), text.lstrip("-")
    if "." in digits:
        raise ValueError(text)
    patterned = digits[:2] in ("0x", "0b")
    value = int(digits, 0) if patterned else int(digits)
    value = -value if negative else value
    if kind == "u":
        if not 0 <= value <= numbers.mask:
            raise ValueError(text)
        return value
    if not -numbers.half <= value <= (numbers.mask if patterned else numbers.half - 1):
        raise ValueError(text)
    return numbers.wrap(value)


class Expressions:
    """Writes the expressions of one clause, with types from inference."""

    def __init__(self, types: Types, clause_types: ClauseTypes, matchers: dict[str, str], *, interned: bool = False) -> None:
        self.interned = interned  # whether records are those of an evaluation
        self.types = types
        self.clause_types = clause_types
        self.bits = types.bits
        self.constants = {"HALF": str(1 << types.bits - 1), "MASK": str((1 << types.bits) - 1), "LAST": str(types.bits - 1)}
        self.matchers = matchers  # regular expression -> name of its module-level matcher

    def kind(self, term: Argument) -> str:
        """The base kind of a term, `i` when nothing says otherwise."""
        return kind_of(self.clause_types.of(term), self.types) or "i"

    def overload(self, term: Functor) -> Overload:
        """The overload of a functor: the one that is left, or the one its argument kinds pick."""
        candidates = self.clause_types.overloads.get(id(term), [])
        kinds = "".join(self.kind(a) for a in term.args)
        for candidate in candidates:
            if candidate.kinds(len(term.args)) == kinds:
                return candidate
        if not candidates:
            raise DatalogError([Diagnostic(f"no valid overload of `{term.op}`", term.location)])
        return candidates[0]

    def constant(self, term: String | Number) -> Any:
        """The value of a constant."""
        return term.value if isinstance(term, String) else number_value(term.text, self.kind(term))

    def write(self, term: Argument, bound: Mapping[str, str]) -> str:
        """The Python expression of a term whose variables are all bound."""
        match term:
            case Variable():
                return bound[term.name]
            case String():
                return repr(term.value)
            case Number():
                return repr(number_value(term.text, self.kind(term), self.bits))
            case Nil():
                return "None"
            case Cast():
                return self._cast(term, bound)
            case Record():
                return self._record([self.write(a, bound) for a in term.args], [self.kind(a) for a in term.args])
            case Branch():
                return self._record([repr(term.name), *(self.write(a, bound) for a in term.args)], ["s", *map(self.kind, term.args)])
            case Counter():
                return "S.next_counter()"
            case IterationCounter():
                return "S.iteration"
            case Functor():
                return self._functor(term, bound)
            case UserFunctor():
                call = f"{PREFIX}{term.name}({', '.join(self.write(a, bound) for a in term.args)})"
                return f"S.records.pack_value({call})" if self.interned and self.kind(term) in ("r", "+") else call
            case _:
                raise DatalogError([Diagnostic(f"unexpected term {type(term).__name__}", term.location)])

    @staticmethod
    def _tuple(parts: list[str]) -> str:
        return f"({', '.join(parts)}{',' if len(parts) == 1 else ''})"

    def _record(self, parts: list[str], kinds: list[str]) -> str:
        fields = self._tuple(parts)
        if not self.interned:
            return fields
        if "f" in kinds:
            return f"S.records.pack_floats({fields}, {''.join('f' if k == 'f' else '.' for k in kinds)!r})"
        return f"S.records.pack({fields})"

    def _cast(self, term: Cast, bound: Mapping[str, str]) -> str:
        source, target = self.kind(term.arg), self.types.kind(term.type)
        inner = self.write(term.arg, bound)
        if source == target or isinstance(term.arg, Number):
            return inner
        if (source, target) == ("i", "u"):
            return f"wrap_unsigned({inner})"
        if (source, target) == ("u", "i"):
            return f"wrap({inner})"
        if source == "s" and target in "iu":
            return f"S.ordinals.number({inner})"
        return inner

    def _functor(self, term: Functor, bound: Mapping[str, str]) -> str:
        args = [self.write(a, bound) for a in term.args]
        overload = self.overload(term)
        kind = overload.result
        op = term.op
        if op == "cat" or (op == "+" and kind == "s"):
            return f"({' + '.join(args)})" if args else "''"
        if len(args) == 2 and op in _NUMBER_BINARY:
            return self._filled(_BINARY[kind][op], args)
        if (op, kind) in _UNARY:
            return self._filled(_UNARY[op, kind], args)
        if op.startswith("to_"):
            return self._filled(_CONVERSIONS[overload.params + kind], args)
        match op:
            case "min" | "max":
                return args[0] if len(args) == 1 else f"{op}({', '.join(args)})"
            case "strlen":
                return f"string_length({args[0]})"
            case "substr":
                return f"substring({', '.join(args)})"
            case "range":
                return f"{'float' if kind == 'f' else 'number'}_range({', '.join(args)})"
            case "ord":
                inner = self.kind(term.args[0])
                return args[0] if inner == "i" else f"S.ordinals.number({args[0]})"
        raise DatalogError([Diagnostic(f"unknown functor `{op}`", term.location)])

    def _filled(self, template: str, args: Sequence[str]) -> str:
        """A template with the constants of the number domain and the arguments put in."""
        for name, value in self.constants.items():
            template = template.replace(name, value)
        return template.format(*args)

    def condition(self, constraint: Constraint, bound: Mapping[str, str]) -> str:
        """The Python condition of a constraint."""
        left, right = self.write(constraint.left, bound), self.write(constraint.right, bound)
        op = constraint.op
        if op in _COMPARISONS:
            return f"{left} {_COMPARISONS[op]} {right}"
        if op.endswith("contains"):
            return f"{left} {'not in' if op[0] == '!' else 'in'} {right}"
        negated = op[0] == "!"
        if not isinstance(constraint.left, String):
            return f"{'differs' if negated else 'matches'}({left}, {right})"
        try:
            if full_match(constraint.left.value) is None:
                return "False"
        except EvaluationError as error:
            raise DatalogError([Diagnostic(str(error), constraint.left.location)]) from None
        matcher = self.matchers.setdefault(constraint.left.value, f"match_{len(self.matchers)}")
        return f"{matcher}({right}) is {'' if negated else 'not '}None"
