"""Answers to questions about cause and effect in a system: what the rules derive, and the shortest chain that shows it."""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.datalog import Result
from rosarch.models import formula
from rosarch.models.component import ComponentModel
from rosarch.models.system.asking import Causes, Port, find_ports
from rosarch.models.system.rows import Rows, grouped
from rosarch.rule_programs.sets import SystemRules

PORTS = ("port_node", "port_name", "port_written", "node_port")
ANSWERS = (
    "answer", "chain_step", "certain_step", "certainly_influenced", "influence_ends", "certainty_ends", "missing_for_answer", "step_waits",
    "step_filter", "step_variable",
)  # fmt: skip
_ORDER = {"data": 0, "control": 1, "connection": 0, "answer": 0, "reactive": 1, "deferred": 2, "kept": 3}


@dataclass(frozen=True)
class PortShown:
    """A port of a chain; `at` is where its component makes it."""

    name: str
    kind: str
    node: str
    at: Place | None


@dataclass(frozen=True)
class Step:
    """Two ports next to each other in a chain.

    `kind` is connection, answer (of a service), reactive, deferred (to a timed loop or timer) or kept (until something else makes the node
    send); `how` is data or control. Inside a node, `at` are the calls that send, `condition` says when, `variables` keep what arrives,
    `filters` are state variables that decide, and `waits` are how many seconds it waits at most for callbacks to run, or for sending.
    """

    source: PortShown
    sink: PortShown
    kind: str
    how: str
    certain: bool
    at: tuple[Place, ...] = ()
    condition: str | None = None
    variables: tuple[str, ...] = ()
    filters: tuple[str, ...] = ()
    waits: tuple[tuple[float, str], ...] = ()

    @property
    def bounded(self) -> bool:
        """Whether it is known how long something waits here at most.

        What a round sends only if other variables allow it may be sent by any later round.
        """
        if self.kind == "deferred":
            alone = self.certain or set(self.filters) <= set(self.variables)
            return alone and any(reason == "sending" for _, reason in self.waits)
        return self.kind != "kept"


@dataclass(frozen=True)
class ChainAnswer:
    """The answer to a question in the system `system`: yes with a chain, no with what cuts it, unknown with what is missing.

    `ends` are the ports at which the influence ends, `uncertain` the steps that need not follow, `missing` the nodes of which too little is
    known, each with the reason.
    """

    system: str
    asked: Causes
    answer: str
    chain: tuple[Step, ...] = ()
    ends: tuple[tuple[PortShown, str], ...] = ()
    uncertain: tuple[Step, ...] = ()
    missing: tuple[tuple[str, str], ...] = ()

    @property
    def waits(self) -> float | None:
        """How many seconds all steps of the chain wait at most; None when that is not known."""
        return sum(seconds for step in self.chain for seconds, _ in step.waits) if all(step.bounded for step in self.chain) else None


def ask_chain(rules: SystemRules, rows: Rows, asked: Causes, system: str, models: Sequence[ComponentModel], engine: str) -> ChainAnswer:
    """Answer a question about the system that `rows` are the facts of.

    Raises:
        QuestionError: it is about something that is not there.
    """
    question = {"question_port": {("source", *row) for row in asked.source.rows()} | {("target", *row) for row in asked.target.rows()}}
    result = rules.program.evaluate({**rows, **question}, engine=engine, keep=(*PORTS, *ANSWERS))
    sources, targets = find_ports(asked.source, result), find_ports(asked.target, result)
    shower = _Shower(rows, result, models)
    answers = {answer for (answer,) in result.rows("answer")}
    steps = _best_steps(result)
    if asked.always and "must" in answers:
        certain = set(result.rows("certain_step"))
        chain = _shortest({pair: step for pair, step in steps.items() if pair in certain}, sources, targets)
        return ChainAnswer(system, asked, "yes", shower.chain(chain))
    if not asked.always and "can" in answers:
        return ChainAnswer(system, asked, "yes", shower.chain(_shortest(steps, sources, targets)))
    missing = tuple(sorted({(shower.node_names[node], reason) for node, reason in result.rows("missing_for_answer")}))
    ends = tuple(sorted({(shower.port(port), reason) for port, reason in result.rows("influence_ends")}, key=repr))
    if "can" in answers:
        uncertain = shower.chain([(s, t, *steps[s, t]) for s, t in sorted(set(result.rows("certainty_ends")), key=repr)])
        answer = "unknown" if "perhaps" in answers else "no"
        return ChainAnswer(system, asked, answer, shower.chain(_shortest(steps, sources, targets)), uncertain=uncertain)
    return ChainAnswer(system, asked, "unknown" if "unknown" in answers else "no", ends=ends, missing=missing)


Kinds = tuple[str, str]
"""How something goes on, and by what kind of step."""
_Joined = tuple[Port, Port, str, str]


def _best_steps(result: Result) -> dict[tuple[Port, Port], Kinds]:
    """The steps; of several from one port to another data rather than control, and at once rather than later."""
    found: dict[tuple[Port, Port], Kinds] = {}
    for source, sink, how, kind in result.rows("chain_step"):
        known = found.get((source, sink))
        if known is None or (_ORDER[how], _ORDER[kind]) < (_ORDER[known[0]], _ORDER[known[1]]):
            found[source, sink] = (how, kind)
    return found


def _shortest(steps: Mapping[tuple[Port, Port], Kinds], sources: Sequence[Port], targets: Sequence[Port]) -> list[_Joined]:
    """The steps of a shortest chain from one of `sources` to one of `targets`."""
    after: dict[Port, list[Port]] = defaultdict(list)
    for source, sink in sorted(steps, key=repr):
        after[source].append(sink)
    before: dict[Port, Port | None] = dict.fromkeys(sources)
    waiting = deque(sources)
    while waiting:
        port = waiting.popleft()
        if port in targets:
            chain = []
            while (previous := before[port]) is not None:
                chain.append((previous, port, *steps[previous, port]))
                port = previous
            return chain[::-1]
        for following in after[port]:
            if following not in before:
                before[following] = port
                waiting.append(following)
    return []


class _Shower:
    """Shows what models and facts know about ports and steps."""

    def __init__(self, rows: Rows, result: Result, models: Sequence[ComponentModel]) -> None:
        self._places = {row[0]: Place(*row[1:]) for row in rows.get("place", ())}
        self._at: dict[str, str] = {row[0]: row[1] for row in rows.get("interface_port_at", ())}
        self._nodes: Mapping[Port, str] = dict(result.rows("port_node"))
        self._names: Mapping[Port, str] = dict(result.rows("port_name"))
        self._kinds: Mapping[Port, str] = dict(result.rows("node_port"))
        self._written = {(node, model, parameter): name for node, model, parameter, name in result.rows("port_written")}
        self._models = {model.title: model for model in models}
        self._certain = set(result.rows("certain_step"))
        details = ("step_waits", "step_filter", "step_variable")
        self._step_details = {name: grouped((row[:2], *row[2:]) for row in result.rows(name)) for name in details}
        self.node_names: dict[str, str] = {row[0]: row[1] for row in rows.get("started_name", ())}

    def port(self, port: Port) -> PortShown:
        """A port as it is shown."""
        name = self._names.get(port) or self._written[port]
        return PortShown(name, self._kinds[port], self._nodes[port], self._places.get(self._at.get(port[1], "")))

    def chain(self, steps: Sequence[_Joined]) -> tuple[Step, ...]:
        """The steps of a chain as they are shown."""
        return tuple(self.step(*step) for step in steps)

    def step(self, source: Port, sink: Port, how: str, kind: str) -> Step:
        """A step as it is shown."""
        places, condition = self._sent(source[1], sink[1], kind)
        waits, filters, variables = (
            self._step_details[name].get((source, sink), []) for name in ("step_waits", "step_filter", "step_variable")
        )
        certain = (source, sink) in self._certain
        kept, decided = (tuple(sorted(name for (name,) in found)) for found in (variables, filters))
        waited = tuple(sorted((seconds, reason) for reason, seconds in waits if reason == "callbacks" or kind == "deferred"))
        return Step(self.port(source), self.port(sink), kind, how, certain, places, condition, kept, decided, waited)

    def _sent(self, source: str, sink: str, kind: str) -> tuple[tuple[Place, ...], str | None]:
        """Where a component sends, and under which condition, when something arrives or in a timed loop."""
        component, _, input_ = source.rpartition("#")
        model, output = self._models.get(component), sink.rpartition("#")[2]
        if model is None or kind in ("connection", "answer"):
            return (), None
        for reaction in model.behavior.reactive if kind == "reactive" else ():
            if (reaction.input, reaction.output) == (input_, output):
                return reaction.at, formula.text(reaction.guard)
        loops = [loop for loop in model.behavior.periodic if output in loop.publishes] if kind == "deferred" else []
        conditions = {formula.text(loop.guard) for loop in loops}
        return tuple(sorted({loop.at for loop in loops})), conditions.pop() if len(conditions) == 1 else None
