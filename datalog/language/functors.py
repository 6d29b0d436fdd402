"""The intrinsic functors with their overloads (souffle's FunctorOps.cpp)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Overload:
    """One signature: argument kinds (one that repeats when `variadic`) and the kind of the result."""

    params: str
    result: str
    variadic: bool = False

    def accepts(self, arity: int) -> bool:
        """Whether the overload takes this many arguments."""
        return self.variadic or len(self.params) == arity

    def kinds(self, arity: int) -> str:
        """The kinds of the arguments."""
        return self.params * arity if self.variadic else self.params


def _binary(kinds: str) -> tuple[Overload, ...]:
    return tuple(Overload(k * 2, k) for k in kinds)


def _unary(kinds: str) -> tuple[Overload, ...]:
    return tuple(Overload(k, k) for k in kinds)


INFIX = frozenset(("+", "-", "*", "/", "%", "^", "band", "bor", "bxor", "bshl", "bshr", "bshru", "land", "lor", "lxor"))

FUNCTORS: dict[str, tuple[Overload, ...]] = {
    "+": (*_binary("iuf"), Overload("ss", "s")),
    **{op: _binary("iuf") for op in ("-", "*", "/", "^")},
    **{op: _binary("iu") for op in ("%", "band", "bor", "bxor", "bshl", "bshr", "bshru", "land", "lor", "lxor")},
    "neg": _unary("if"),
    "bnot": _unary("iu"),
    "lnot": _unary("iu"),
    "range": tuple(Overload(k * n, k) for n in (2, 3) for k in "iuf"),
    "max": tuple(Overload(k, k, variadic=True) for k in "iufs"),
    "min": tuple(Overload(k, k, variadic=True) for k in "iufs"),
    "ord": tuple(Overload(k, "i") for k in "iufsr+"),
    "cat": (Overload("s", "s", variadic=True),),
    "strlen": (Overload("s", "i"),),
    "substr": (Overload("sii", "s"),),
    "to_number": tuple(Overload(k, "i") for k in "ifsu"),
    "to_string": tuple(Overload(k, "s") for k in "sifu"),
    "to_unsigned": tuple(Overload(k, "u") for k in "uifs"),
    "to_float": tuple(Overload(k, "f") for k in "fisu"),
}
MULTI_RESULT = frozenset(("range",))
