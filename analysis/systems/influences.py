"""What reports show of systems beside their models: how often topics are sent on, and what influences what."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from rosarch.analysis.method import Method
from rosarch.analysis.systems.analysis import Composed, SystemAnalysis, composed, each_system, gathered
from rosarch.analysis.systems.reasons import Started, system_reasons
from rosarch.analysis.systems.shared import Launch, SharedFacts
from rosarch.base.pool import Failure
from rosarch.datalog import Result
from rosarch.datalog.inspection.clauses import rules_of
from rosarch.models.derivations import Derivations
from rosarch.models.system.build import evaluate
from rosarch.models.system.rates import RATE_RELATIONS, TopicRate, all_rates
from rosarch.models.system.rows import Rows
from rosarch.rule_programs.sets import SystemRules

_STEPS = ("chain_step", "certain_step")
End = tuple[str, str]
"""A node's id, and that of one of its ports."""


@dataclass(frozen=True)
class InfluenceStep:
    """What passes through `source` has an influence on what passes through `sink`, next to it in a chain; see `chain_step`."""

    source: End
    sink: End
    how: str
    kind: str
    certain: bool


@dataclass(frozen=True)
class SystemDetails:
    """Of one system; without rules of data flow there are no `steps`, but None, and without proofs no `reasons`."""

    rates: tuple[TopicRate, ...]
    steps: tuple[InfluenceStep, ...] | None = None
    reasons: Derivations | None = None


def analyse_in_detail(
    shared: SharedFacts, launches: Sequence[Launch], method: Method, shorten: Callable[[str], str] | None
) -> tuple[SystemAnalysis, Mapping[str, SystemDetails]]:
    """The systems, and the details of each by its name; with proofs, when `shorten` says how paths of rule files are shown.

    Rules are evaluated once for all of that.
    """

    def make(rules: SystemRules, launch: Launch, rows: Rows, method: Method) -> tuple[Composed, SystemDetails]:
        result = evaluate(rules, rows, method.engine, "all" if shorten else (*RATE_RELATIONS, *(_STEPS if method.rules.flows else ())))
        details = _details(result, method)
        if shorten:
            composition = shared.components.with_nodes(launch)[0].composition
            started = Started(composition, shared.root, launch.packages.underlay.holds)
            reasons = system_reasons(rules, rows, result, launch.name, started, shorten, chains=method.rules.flows)
            details = replace(details, reasons=reasons)
        return composed(rules, launch, rows, result), details

    found: dict[int, tuple[Composed, SystemDetails] | Failure] = {}
    before = (lambda rules: rules_of(rules.program)) if shorten else None
    for index, outcome in each_system("proofs" if shorten else "details", shared, launches, method, make, before):
        found[index] = outcome
        if method.sources.progress:
            method.sources.progress("systems", len(found), len(launches))
    systems = {index: outcome if isinstance(outcome, Failure) else outcome[0] for index, outcome in found.items()}
    details = {launches[index].name: outcome[1] for index, outcome in found.items() if not isinstance(outcome, Failure)}
    return gathered(shared, launches, systems), details


def _details(result: Result, method: Method) -> SystemDetails:
    rates = tuple(all_rates(result))
    if not method.rules.flows:
        return SystemDetails(rates)
    certain = set(result.rows("certain_step"))
    steps = [
        InfluenceStep(_end(source), _end(sink), how, kind, (source, sink) in certain)
        for source, sink, how, kind in sorted(result.rows("chain_step"), key=repr)
    ]
    return SystemDetails(rates, tuple(steps))


def _end(port: tuple[str, str, str]) -> End:
    node, model, parameter = port
    return node, model.rpartition("#")[2] + (f":{parameter}" if parameter else "")
