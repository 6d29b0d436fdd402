"""Plans and results of experiments with a node."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Any

from rosarch.models.behavior import sent_in_loop
from rosarch.models.machine.steps import Row
from rosarch.observation.plan import Plan, Stimulus
from rosarch.observation.probe import CONFIRMED, REFUTED, UNREACHED, Results
from rosarch.observation.subject import Subject
from rosarch.reports.printable import json_text
from rosarch.reports.tables import Table, table_markdown, table_text, tables_as

_MILLI = 1000
_SPREAD = ("number", "least", "median", "p99")


def plan_text(subject: Subject, plan: Plan) -> str:
    """What would be put in for each row of the model, and what is expected."""
    lines = [f"{subject.name}: {len(plan.experiments)} of {len(subject.rows)} can be settled"]
    for experiment in plan.experiments:
        lines.append(f"{_row(subject, experiment.row)}  {experiment.row.at}")
        lines += [f"  {_stimulus(subject, stimulus)}" for stimulus in experiment.stimuli]
        lines.append(f"    else it sends {_ports(subject, experiment.otherwise.must)}")
    lines += [f"{_row(subject, row)}  {row.at}\n  not reached: {reason}" for row, reason in plan.unreached]
    return "".join(f"{line}\n" for line in lines)


def _stimulus(subject: Subject, stimulus: Stimulus) -> str:
    given = subject.description(stimulus.given) if stimulus.given else "wait"
    uncertain = stimulus.expected.may - stimulus.expected.must
    perhaps = f", perhaps {_ports(subject, uncertain)}" if uncertain else ""
    return f"{given} -> {_ports(subject, stimulus.expected.must)}{perhaps}"


def _ports(subject: Subject, ports: frozenset[str]) -> str:
    return ", ".join(sorted(subject.places[port].name if port in subject.places else port for port in ports)) or "nothing"


def _row(subject: Subject, row: Row) -> str:
    """A row of the model in a few words."""
    entry = subject.entry(row)
    if row.kind == "transitions":
        return f"{entry['variable']}{entry.get('field') or ''} becomes {entry['value']}"
    if row.kind == "periodic":
        return f"loop sends {_ports(subject, frozenset(sent_in_loop(entry)))}"
    if row.kind == "reactive":
        return f"{_ports(subject, frozenset({entry['input']}))} makes it send {_ports(subject, frozenset({entry['output']}))}"
    return f"timer sends {_ports(subject, frozenset({entry['output']}))}"


def results_text(subject: Subject, results: Results) -> str:
    """Verdicts, times and rates."""
    return f"{_headline(subject, results)}\n\n" + tables_as(table_text, _tables(subject, results))


def results_markdown(subject: Subject, results: Results) -> str:
    """The same as Markdown."""
    return f"# {_headline(subject, results)}\n\n" + tables_as(table_markdown, _tables(subject, results))


def _headline(subject: Subject, results: Results) -> str:
    counted = {verdict: sum(each.verdict == verdict for each in results.verdicts) for verdict in (CONFIRMED, REFUTED, UNREACHED)}
    return f"{subject.name}: {', '.join(f'{count} {verdict}' for verdict, count in counted.items())}"


def _tables(subject: Subject, results: Results) -> list[Table]:
    verdicts = tuple((each.verdict, _row(subject, each.row), each.row.at, each.reason or "-") for each in results.verdicts)
    times = tuple((source, sink, *_spread(seconds, _MILLI)) for source, sink, seconds in _times(subject, results))
    rates = tuple((topic, predicted, hz) for topic, predicted, hz in _rates(subject, results))
    found = [
        Table("verdicts", ("verdict", "what", "source", "reason"), verdicts),
        Table("times (ms)", ("from", "to", "number", "least", "median", "99 %"), times),
        Table("rates (Hz)", ("topic", "predicted", "measured"), rates),
        Table("names that the sources leave open", ("of", "name"), tuple((each.subject, each.value) for each in results.names)),
    ]
    return [table for table in found if table.rows]


def _times(subject: Subject, results: Results) -> Iterator[tuple[str, str, list[float]]]:
    for port, seconds in sorted(results.measured.responses.items()):
        yield subject.places[port].name, "response", seconds
    for (given, sent), seconds in sorted(results.measured.latencies.items()):
        yield subject.places[given].name, subject.places[sent].name, seconds


def _spread(seconds: Sequence[float], factor: float = 1.0) -> tuple[int, float, float, float]:
    ordered = [factor * each for each in sorted(seconds)]
    count = len(ordered)
    return count, ordered[0], ordered[(count - 1) // 2], ordered[math.ceil(0.99 * count) - 1]


def _rates(subject: Subject, results: Results) -> Iterator[tuple[str, float | None, float]]:
    for (row, port), hz in results.measured.rates.items():
        yield subject.places[port].name, subject.entry(row)["hz"], hz


def results_json(subject: Subject, results: Results) -> str:
    """All of it; what was measured has the provenance `observed`."""
    document: dict[str, Any] = {
        "node": subject.name,
        "verdicts": [
            {
                "kind": each.row.kind,
                "index": subject.index(each.row),
                "at": each.row.at,
                "verdict": each.verdict,
                "reason": each.reason or None,
            }
            for each in results.verdicts
        ],
        "times": [
            {"from": source, "to": sink, **dict(zip(_SPREAD, _spread(seconds), strict=True)), "provenance": "observed"}
            for source, sink, seconds in _times(subject, results)
        ],
        "rates": [
            {"topic": topic, "predicted": predicted, "measured": hz, "provenance": "observed"}
            for topic, predicted, hz in _rates(subject, results)
        ],
        "names": [{"of": each.subject, "name": each.value, "provenance": each.provenance} for each in results.names],
    }
    return json_text(document)


def scenario_text(subject: Subject, results: Results) -> str:
    """What was measured, as the part of a scenario for `rosarch simulate` that says how long reactions take."""
    reactions = {(row["input"], row["output"]) for row in subject.document.get("reactive") or ()}
    spans: dict[str, list[float]] = defaultdict(list)
    for port, seconds in results.measured.responses.items():
        spans[subject.places[port].name] += seconds
    for (given, sent), seconds in results.measured.latencies.items():
        if (given, sent) in reactions:
            spans[subject.places[given].name] += seconds
    lines = [f"    {name}: [{min(seconds):.6f}, {max(seconds):.6f}]\n" for name, seconds in spans.items()]
    return f"execution:  # observed\n  {subject.name.lstrip('/')}:\n{''.join(lines)}" if lines else "execution: {}\n"
