"""Rules for questions about the flow of data, which takes longer to derive than all else: only when one asks for it."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from rosarch.datalog.inspection.clauses import rules_of
from rosarch.datalog.language.strata import reachable
from rosarch.rule_programs.sets import RuleSet, component_program, system_rules

_RELATION = re.compile(r"\b[A-Za-z_]\w*(?=\s*\()")


def rules_for(rules: RuleSet, asked: str, flow_traits: Collection[str], *, systems: bool) -> RuleSet:
    """The rules for a query or row: with the flow of data, when a relation that it names is about that, or rests on it.

    `flow_traits` are the traits of components (`models/traits.py`) that are derived only then.
    """
    names = set(_RELATION.findall(asked))
    with_flows = replace(rules, flows=True)
    if systems:
        reads = rules_of(system_rules(rules).program).reads
        about_flow = reachable(names & reads.keys(), reads) & {f"interface_{name}" for name in flow_traits}
    else:
        unknown = names - component_program(rules).relations.keys()
        about_flow = unknown and unknown & component_program(with_flows).relations.keys()
    return with_flows if about_flow else rules
