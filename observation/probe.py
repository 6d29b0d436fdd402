"""Experiments with a real node, in a private graph: what it does is compared with what its model says that it does."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import median

from rosarch.models.behavior import sent_in_loop
from rosarch.models.machine.steps import Row
from rosarch.observation.company import Company, company
from rosarch.observation.compare import Filled
from rosarch.observation.content import Values
from rosarch.observation.plan import Experiment, Plan, Stimulus
from rosarch.observation.private import StartError
from rosarch.observation.processes import Process, wait_until
from rosarch.observation.rpc import CallError
from rosarch.observation.subject import Place, Subject

CONFIRMED, REFUTED, UNREACHED = "confirmed", "refuted", "not reached"
_PATIENCE = 0.25
"""Seconds that something may take in addition to the rounds of loops."""
_GRACE = 0.1
"""So long after an input, what was sent before it may still come."""
_TRIES = 3
"""What is not confirmed is tried again: only what never is counts."""
_PERIODS = 20
_LONGEST_MEASURE = 4.0


@dataclass(frozen=True)
class Verdict:
    """What became of a row of the model: confirmed, refuted or not reached, and why."""

    row: Row
    verdict: str
    reason: str = ""


@dataclass
class Measured:
    """Seconds from an input to the first message on an output, by their ports, and of responses of services; sendings a second by loop."""

    latencies: dict[tuple[str, str], list[float]] = field(default_factory=lambda: defaultdict(list))
    responses: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    rates: dict[tuple[Row, str], float] = field(default_factory=dict)

    def add(self, other: Measured) -> None:
        """What was measured elsewhere, too."""
        for pair, seconds in other.latencies.items():
            self.latencies[pair] += seconds
        for port, seconds in other.responses.items():
            self.responses[port] += seconds
        self.rates.update(other.rates)


@dataclass(frozen=True)
class Results:
    """Verdicts on all rows of a model, what was measured meanwhile, and the names that the model leaves open."""

    verdicts: tuple[Verdict, ...]
    measured: Measured
    names: tuple[Filled, ...] = ()


class _ProbeError(Exception):
    """An experiment that could not be made; the text says why."""


def probe(subject: Subject, plan: Plan, command: Sequence[str], seconds: float, jobs: int) -> Results:
    """Make the experiments of a plan with the node that a command starts, several at a time, within a time limit."""
    end = time.monotonic() + seconds
    measured = Measured()
    verdicts = []
    with ThreadPoolExecutor(jobs) as pool:
        for verdict, found in pool.map(lambda experiment: _tried(subject, experiment, command, end), plan.experiments):
            verdicts.append(verdict)
            measured.add(found)
    left = [Verdict(row, UNREACHED, reason) for row, reason in plan.unreached]
    return Results((*verdicts, *left), measured)


def _tried(subject: Subject, experiment: Experiment, command: Sequence[str], end: float) -> tuple[Verdict, Measured]:
    """An experiment, again while it does not confirm."""
    verdict, measured = Verdict(experiment.row, UNREACHED, "the time limit was over"), Measured()
    for _ in range(_TRIES):
        if verdict.verdict == CONFIRMED or time.monotonic() > end:
            break
        verdict = _verdict(subject, experiment, command, measured)
    return verdict, measured


def _verdict(subject: Subject, experiment: Experiment, command: Sequence[str], measured: Measured) -> Verdict:
    row = experiment.row
    try:
        with company(subject) as other:
            trial = _started(subject, other, command, measured)
            for stimulus in experiment.stimuli[:-1]:
                seen = trial.give(stimulus)
                if not stimulus.expected.fits(seen):
                    return Verdict(row, UNREACHED, f"on the way, {trial.description(stimulus)} made it send {_names(subject, seen)}")
            last = experiment.stimuli[-1]
            seen = trial.give(last)
            if not last.expected.fits(seen):
                told = f"{trial.description(last)} made it send {_names(subject, seen)}"
                return Verdict(row, REFUTED if experiment.otherwise.fits(seen) else UNREACHED, told)
            if row.kind == "periodic":
                trial.measure(row)
            return Verdict(row, CONFIRMED)
    except (_ProbeError, StartError, CallError) as error:
        return Verdict(row, UNREACHED, str(error))


def _names(subject: Subject, ports: frozenset[str]) -> str:
    return " and ".join(sorted(subject.places[port].name for port in ports)) or "nothing"


def _started(subject: Subject, other: Company, command: Sequence[str], measured: Measured) -> _Trial:
    """Start the node, with `other` at the other end of all its topics."""
    for place in subject.outlets:
        other.subscribe(place)
    topics = [place for place in subject.inlets if not place.service]
    for place in topics:
        other.advertise(place)
    process = other.start(command)
    if not wait_until(lambda: all(other.readers(place) for place in topics), other.patience):
        left = " and ".join(place.name for place in topics if not other.readers(place))
        raise _ProbeError(f"it does not read {left}")
    return _Trial(subject, other, process, measured)


class _Trial:
    """A node that runs for one experiment, and the `other` end of its ports."""

    def __init__(self, subject: Subject, other: Company, process: Process, measured: Measured) -> None:
        self._subject = subject
        self._other = other
        self._process = process
        self._measured = measured
        self._before: frozenset[str] = frozenset()
        self._timed = frozenset(port for row in subject.document.get("periodic") or () for port in sent_in_loop(row))

    def give(self, stimulus: Stimulus) -> frozenset[str]:
        """Put something in, and wait; the ports that something came through."""
        begin = time.monotonic()
        given = stimulus.given
        if given is not None:
            place, values = self._subject.places[given.port], self._subject.values(given)
            if place.service:
                self._call(place, values, stimulus)
                self._measured.responses[given.port].append(time.monotonic() - begin)
            else:
                begin = self._other.publish(place, values)
        periods = [1 / hz for hz in self._subject.machine.loops.values() if hz]
        time.sleep(_PATIENCE + stimulus.rounds * max(periods, default=0.0))
        if (end := self._end_after(stimulus)) is not None:
            raise _ProbeError(end)
        late = {port: [at for at in times if at >= begin] for port, times in self._other.heard().items()}
        seen = {port for port, times in late.items() if times}
        trailing = {p for p in seen & self._before - stimulus.expected.may if max(late[p]) < begin + _GRACE}
        seen -= trailing
        if given is not None:
            for port in seen - (self._before & self._timed):
                self._measured.latencies[given.port, port].append(min(late[port]) - begin)
        self._before = frozenset(seen)
        return self._before

    def _call(self, place: Place, values: Values, stimulus: Stimulus) -> None:
        try:
            self._other.call(place, values)
        except CallError as error:
            raise _ProbeError(self._end_after(stimulus) or str(error)) from None

    def _end_after(self, stimulus: Stimulus) -> str | None:
        """How the node ended by itself."""
        return None if self._process.ended is None else f"after {self.description(stimulus)} it {self._process.ended}"

    def measure(self, row: Row) -> None:
        """How often something is sent through the ports of a timed loop."""
        entry = self._subject.entry(row)
        hz = entry.get("hz")
        begin = time.monotonic()
        time.sleep(min(_LONGEST_MEASURE, _PERIODS / hz) if hz else 1.0)
        heard = self._other.heard()
        for port in entry["publishes"]:
            times = [at for at in heard.get(port, ()) if at >= begin]
            intervals = [after - before for before, after in pairwise(times)]
            if intervals:
                self._measured.rates[row, port] = 1 / median(intervals)

    def description(self, stimulus: Stimulus) -> str:
        """A stimulus for people."""
        return self._subject.description(stimulus.given) if stimulus.given else "waiting"
