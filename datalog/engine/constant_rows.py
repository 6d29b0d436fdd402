"""Relations that no input has a part in: their rows are computed when a program is compiled."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from rosarch.datalog.engine.compile import Clauses, compile_program, effects
from rosarch.datalog.engine.engine import Control, Evaluation, load_functions
from rosarch.datalog.engine.runtime import names as runtime_names
from rosarch.datalog.language.domain import EvaluationError
from rosarch.datalog.language.errors import DatalogError
from rosarch.datalog.language.strata import atoms_of
from rosarch.datalog.language.syntax import Clause, Relation, UserFunctor, clause_literals, walk
from rosarch.datalog.language.types import Types


def constant_rows(
    relations: Mapping[str, Relation], strata: Sequence[Sequence[str]], clauses: Clauses, types: Types, inputs: Collection[str],
) -> dict[str, list[Any]]:  # fmt: skip
    """The rows of relations that follow from the clauses alone, bare values for unary ones.

    What is recursive, or depends on more than the rows of other relations, is left to an evaluation, which has its limits.
    """
    constant: list[str] = []
    found: set[str] = set()
    for stratum in strata:
        name = stratum[0]
        own = [clause for clause, _ in clauses.get(name, ())]
        read = {atom.name for clause in own for node in (*clause.head.args, *clause.body) for atom, _ in atoms_of(node)}
        if len(stratum) == 1 and name not in inputs and read <= found and _is_plain(relations[name], own, types):
            found.add(name)
            constant.append(name)
    code = compile_program(relations, [(name,) for name in constant], {name: clauses.get(name, ()) for name in constant}, types)
    functions = load_functions(compile(code.source, "<datalog>", "exec"), runtime_names(types.bits))
    try:
        rows = Evaluation(code, functions, {}, Control(None, None)).run(constant)
    except (DatalogError, EvaluationError):
        return {}  # an evaluation reports it
    return {name: sorted(each, key=repr) for name, each in rows.items()}


def _is_plain(relation: Relation, clauses: Sequence[Clause], types: Types) -> bool:
    """Whether the rows of a relation are all that its clauses derive, each evaluated once, of numbers and symbols."""
    nodes = [node for clause in clauses for literal in clause_literals(clause) for node in walk(literal)]
    return (
        not relation.choices and not relation.limit and "eqrel" not in relation.qualifiers
        and all(types.kind(attribute.type) in "iufs" for attribute in relation.attributes)
        and not any(clause.dominating is not None or any(effects(clause)) for clause in clauses)
        and not any(isinstance(node, UserFunctor) for node in nodes)
    )  # fmt: skip
