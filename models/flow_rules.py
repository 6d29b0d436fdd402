"""Questions about the flow of data, which models tell of only when they are asked: it takes longer to derive than all else."""

from __future__ import annotations

import re
from dataclasses import replace

from rosarch.datalog.clauses import rules_of
from rosarch.datalog.strata import reachable
from rosarch.models.rule_sets import RuleSet, component_program, system_rules
from rosarch.models.traits import FLOW_TRAITS

_RELATION = re.compile(r"\b[A-Za-z_]\w*(?=\s*\()")


def rules_for(rules: RuleSet, asked: str, *, systems: bool) -> RuleSet:
    """The rules for a query or row: with the flow of data, when a relation that it names is about that, or rests on it."""
    names = set(_RELATION.findall(asked))
    with_flows = replace(rules, flows=True)
    if systems:
        reads = rules_of(system_rules(rules).program).reads
        about_flow = reachable(names & reads.keys(), reads) & {f"interface_{name}" for name in FLOW_TRAITS}
    else:
        unknown = names - component_program(rules).relations.keys()
        about_flow = unknown and unknown & component_program(with_flows).relations.keys()
    return with_flows if about_flow else rules
