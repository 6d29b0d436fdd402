"""Datalog in Soufflé's dialect: an embedded engine, and the souffle binary behind the same interface.

program = load_program(Path("rules.dl"))
result = program.evaluate({"edge": [("a", "b")]}, keep="all")
result.rows("path")
query(program, result, "path(X, Y), X != Y").rows
print(proof_text(explain(program, result, "path(a, b)")))

`docs/datalog.md` shows the whole interface. All of it is imported when it is first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rosarch.datalog.files.facts import read_facts, write_facts
    from rosarch.datalog.inspection.near_misses import WhyNot, why_not, why_not_text
    from rosarch.datalog.inspection.profiling import Profile, profile, profile_text
    from rosarch.datalog.inspection.proof_printer import Layout, proof_text
    from rosarch.datalog.inspection.proofs import Proof
    from rosarch.datalog.inspection.prover import explain, explain_all
    from rosarch.datalog.inspection.queries import Table, query, table_text
    from rosarch.datalog.inspection.relation_reference import reference, reference_text
    from rosarch.datalog.inspection.rows import RowStore, row_store
    from rosarch.datalog.inspection.rule_coverage import Coverage, coverage
    from rosarch.datalog.inspection.rule_tests import run_rule_tests
    from rosarch.datalog.inspection.source_lines import SourceLines
    from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location
    from rosarch.datalog.language.overrides import Overridden
    from rosarch.datalog.program import Attribute, Program, RelationDecl, Result, is_compiled, load_declarations, load_program, ship_program

_LATER = {
    "language.errors": ("DatalogError", "Diagnostic", "Location"),
    "files.facts": ("read_facts", "write_facts"),
    "inspection.near_misses": ("WhyNot", "why_not", "why_not_text"),
    "language.overrides": ("Overridden",),
    "program": ("Attribute", "Program", "RelationDecl", "Result", "is_compiled", "load_declarations", "load_program", "ship_program"),
    "inspection.profiling": ("Profile", "profile", "profile_text"),
    "inspection.proof_printer": ("Layout", "proof_text"),
    "inspection.proofs": ("Proof",),
    "inspection.prover": ("explain", "explain_all"),
    "inspection.queries": ("Table", "query", "table_text"),
    "inspection.relation_reference": ("reference", "reference_text"),
    "inspection.rows": ("RowStore", "row_store"),
    "inspection.rule_coverage": ("Coverage", "coverage"),
    "inspection.rule_tests": ("run_rule_tests",),
    "inspection.source_lines": ("SourceLines",),
}
_MODULE_OF = {name: module for module, names in _LATER.items() for name in names}

__all__ = [
    "Attribute",
    "Coverage",
    "DatalogError",
    "Diagnostic",
    "Layout",
    "Location",
    "Overridden",
    "Profile",
    "Program",
    "Proof",
    "RelationDecl",
    "Result",
    "RowStore",
    "SourceLines",
    "Table",
    "WhyNot",
    "coverage",
    "explain",
    "explain_all",
    "is_compiled",
    "load_declarations",
    "load_program",
    "profile",
    "profile_text",
    "proof_text",
    "query",
    "read_facts",
    "reference",
    "reference_text",
    "row_store",
    "run_rule_tests",
    "ship_program",
    "table_text",
    "why_not",
    "why_not_text",
    "write_facts",
]


def __getattr__(name: str) -> Any:
    module = _MODULE_OF.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{module}", __name__), name)
