"""User-defined functors: Python functions behind `.functor` declarations.

    .functor initials(name: symbol): symbol

    load_program("p.dl", functors={"initials": lambda name: "".join(w[0] for w in name.split())})

A function gets and returns `str`, `int` and `float`; tuples for records, `None` for nil, `("Branch", ...)` for algebraic data types.
Numbers outside the number domain wrap around. It should depend on nothing but its arguments: how often it is called is not defined.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog.language.domain import Domain, EvaluationError, domain
from rosarch.datalog.language.errors import DatalogError, Location, Report
from rosarch.datalog.language.syntax import Unit, UserFunctor, clause_literals, walk
from rosarch.datalog.language.types import Types

if TYPE_CHECKING:
    from rosarch.datalog.program import Program

Functors = Mapping[str, Callable[..., Any]]
PREFIX = "user_"  # of the names of functors in generated code


@dataclass(frozen=True, slots=True)
class FunctorUse:
    """A functor that some rule calls: the type and base kind of its result, and the place of the first call."""

    result: str
    kind: str
    location: Location


def functor_uses(unit: Unit, types: Types) -> dict[str, FunctorUse]:
    """The functors that clauses call."""
    declared = {f.name: f for f in unit.functors}
    found: dict[str, FunctorUse] = {}
    for clause in unit.clauses if declared else ():
        for literal in clause_literals(clause):
            for node in walk(literal):
                if isinstance(node, UserFunctor) and node.name not in found:
                    result = declared[node.name].result
                    found[node.name] = FunctorUse(result, types.kind(result), node.location)
    return found


def bind(program: Program) -> dict[str, Callable[..., Any]]:
    """The functions that generated code calls. Raises DatalogError when one is missing."""
    report = Report(program.sources)
    bound: dict[str, Callable[..., Any]] = {}
    for name, use in program.functor_uses.items():
        function = program.functors.get(name)
        if function is None:
            report.error(f"functor `@{name}` has no Python function", use.location, "give one with `functors=` or `-l FILE.py`")
        else:
            bound[PREFIX + name] = _checked(name, function, use, domain(program.types.bits))
    report.raise_errors()
    return bound


def _checked(name: str, function: Callable[..., Any], use: FunctorUse, numbers: Domain) -> Callable[..., Any]:
    """The function with its result checked against the declared type."""

    def call(*args: Any) -> Any:
        try:
            value = function(*args)
        except Exception as error:
            raise EvaluationError(f"functor `@{name}` failed: {type(error).__name__}: {error}") from error
        match use.kind, value:
            case "s", str():
                return value
            case "i" | "u", int():
                return numbers.wrap(value) if use.kind == "i" else numbers.wrap_unsigned(value)
            case "f", int() | float():
                return numbers.single(float(value))
            case "r", None | tuple():
                return value
            case "+", tuple():
                return value
        raise EvaluationError(f"functor `@{name}` returned {value!r}, which is not of type `{use.result}`")

    return call


def load_functors(paths: list[Path]) -> dict[str, Callable[..., Any]]:
    """The functions that Python files define at their top level."""
    import runpy

    found: dict[str, Callable[..., Any]] = {}
    for path in paths:
        if path.suffix != ".py":
            raise DatalogError(f"{path}: functors of the embedded engine are Python functions in a `.py` file")
        if not path.is_file():
            raise DatalogError(f"no such file: `{path}`")
        try:
            namespace = runpy.run_path(str(path))
        except Exception as error:
            raise DatalogError(f"{path}: cannot be loaded: {type(error).__name__}: {error}") from error
        found.update({name: value for name, value in namespace.items() if name[0] != "_" and callable(value)})
    return found
