"""What was seen of a running system, as text, Markdown and JSON."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from itertools import pairwise
from typing import Any

from rosarch.findings.model import Finding
from rosarch.observation.compare import CONFIRMED, Comparison, Element
from rosarch.observation.graph import Snapshot
from rosarch.observation.observed import Recorded, Watched, delays
from rosarch.observation.statistics import Distribution
from rosarch.observation.summary import Stream, Summary
from rosarch.reports.printable import json_text, printable
from rosarch.reports.tables import Table, table_markdown, table_text, tables_as

_MILLI = 1000
Seen = Recorded | Watched


def observation_text(seen: Seen, comparison: Comparison) -> str:
    """Tables of what was seen and of the comparison, then contradictions."""
    return f"{_headline(seen)}\n\n" + _body(table_text, "", seen, comparison)


def observation_markdown(seen: Seen, comparison: Comparison) -> str:
    """The same for documentation and pull requests."""
    return f"# {_headline(seen)}\n\n" + _body(table_markdown, "- ", seen, comparison)


def _body(table: Callable[[Table], str], mark: str, seen: Seen, comparison: Comparison) -> str:
    lines = [*(f"note: {printable(problem)}" for problem in seen.problems), *_finding_lines(comparison.contradictions)]
    tables = tables_as(table, [*_seen_tables(seen), *_comparison_tables(comparison)])
    return tables + ("\n" if lines else "") + "".join(f"{mark}{line}\n" for line in lines)


def observation_json(seen: Seen, comparison: Comparison) -> str:
    """All of it."""
    what = _recorded(seen.summary) if isinstance(seen, Recorded) else {"snapshots": list(map(_snapshot, seen.snapshots))}
    source = {"recording": seen.name} if isinstance(seen, Recorded) else {"graph": seen.uri}
    return json_text({**source, **what, "problems": list(seen.problems), "comparison": _compared(comparison)})


def comparison_text(comparison: Comparison) -> str:
    """Only how well model and observation agree."""
    return tables_as(table_text, _comparison_tables(comparison))


def comparison_markdown(comparison: Comparison) -> str:
    """The same as Markdown."""
    return tables_as(table_markdown, _comparison_tables(comparison))


def comparison_json(comparison: Comparison) -> str:
    """The same, with all elements."""
    return json_text(_compared(comparison))


def _headline(seen: Seen) -> str:
    if isinstance(seen, Recorded):
        streams = seen.summary.streams.values()
        topics, count = len({stream.topic for stream in streams}), sum(stream.arrivals.count for stream in streams)
        return f"recording {printable(seen.name)}: {seen.summary.seconds:.1f} s, {topics} topics, {count} messages"
    last = seen.snapshots[-1]
    return f"graph {printable(seen.uri)}: {len(last.state.nodes())} nodes, {len(seen.snapshots)} snapshots in {last.at:g} s"


# what was seen


def _seen_tables(seen: Seen) -> list[Table]:
    """Topics, gaps and delays of a recording; what came and went in a graph."""
    found = _recorded_tables(seen.summary) if isinstance(seen, Recorded) else [*_graph_tables(seen)]
    return [table for table in found if table.rows]


def _recorded_tables(summary: Summary) -> list[Table]:
    streams = sorted(summary.streams.values(), key=lambda stream: (stream.topic, stream.sender or ""))
    return [
        Table(
            "topics (jitter and longest interval in ms)",
            ("topic", "type", "from", "messages", "Hz", "jitter", "longest", "gaps", "lost", "median age (ms)"),
            tuple(map(_stream_row, streams)),
        ),
        Table(
            "gaps (s)",
            ("topic", "from", "after", "for"),
            tuple((stream.topic, stream.sender or "-", *gap) for stream in streams for gap in stream.arrivals.gaps()),
        ),
        Table(
            "delays (ms)",
            ("from", "to", "by", "number", "least", "median", "99 %", "most"),
            tuple((source, sink, how, found.count, *map(_milli, _spread(found))) for source, sink, how, found in delays(summary)),
        ),
    ]


def _stream_row(stream: Stream) -> tuple[str | int | float | None, ...]:
    arrivals, several = stream.arrivals, stream.arrivals.intervals.count > 0
    jitter, longest = (_milli(arrivals.intervals.deviation), _milli(arrivals.intervals.most)) if several else (None, None)
    age = _milli(stream.ages.quantile(0.5)) if stream.ages.count else None
    sender = stream.sender or "-"
    return stream.topic, stream.type, sender, arrivals.count, arrivals.hz, jitter, longest, len(arrivals.gaps()), stream.lost, age


def _spread(found: Distribution) -> tuple[float, float, float, float]:
    return found.least, found.quantile(0.5), found.quantile(0.99), found.most


def _milli(seconds: float) -> float:
    return seconds * _MILLI


def _graph_tables(watched: Watched) -> Iterator[Table]:
    last = watched.snapshots[-1]
    topics = sorted({topic for _, topic in last.state.publishers | last.state.subscribers})
    rows = tuple(
        (
            topic,
            last.types.get(("topic", topic)),
            " ".join(sorted(node for node, name in last.state.publishers if name == topic)) or "-",
            " ".join(sorted(node for node, name in last.state.subscribers if name == topic)) or "-",
            len([1 for *_, name in last.connections if name == topic]),
        )
        for topic in topics
    )
    yield Table("topics", ("topic", "type", "published by", "read by", "connections"), rows)
    served = sorted((service, node) for node, service in last.state.services)
    serving = tuple((service, last.types.get(("service", service)), node) for service, node in served)
    yield Table("services", ("service", "type", "served by"), serving)
    others = tuple((kind, name, last.types.get((kind.partition("_")[0], name)), node) for kind, node, name in sorted(last.state.others))
    yield Table("clients and actions", ("kind", "name", "type", "of"), others)
    yield Table("what came and went", ("after (s)", "what"), tuple(_changes(watched.snapshots)))


def _changes(snapshots: Sequence[Snapshot]) -> Iterator[tuple[float, str]]:
    for before, after in pairwise(snapshots):
        for sign, new, old in (("+", after, before), ("-", before, after)):
            for node in sorted(new.state.nodes() - old.state.nodes()):
                yield after.at, f"{sign} {node}"
            for kind in ("publishers", "subscribers", "services"):
                for node, name in sorted(getattr(new.state, kind) - getattr(old.state, kind)):
                    yield after.at, f"{sign} {name} of {node} ({kind.removesuffix('s')})"


# what is compared


def _comparison_tables(comparison: Comparison) -> list[Table]:
    """How much of each kind agrees, what does not, and what was filled."""
    percent = tuple(
        (a.kind, a.predicted, a.observed, a.confirmed, a.filled, _percent(a.under), _percent(a.over)) for a in comparison.accuracies()
    )
    columns = ("kind", "predicted", "seen", "both", "filled", "under-approximation (%)", "over-approximation (%)")
    differing = tuple(
        (element.outcome, element.kind, str(element), "; ".join(element.reasons) or "-")
        for element in sorted(comparison.elements, key=_by_outcome)
        if element.outcome != CONFIRMED
    )
    filled = tuple((each.what, each.subject, each.value) for each in comparison.filled)
    found = [
        Table(f"{comparison.system}: predicted and seen", columns, percent),
        Table("what differs (missed: seen, not predicted; unseen: predicted, not seen)", ("outcome", "kind", "what", "reason"), differing),
        Table("observed, where the sources do not tell", ("what", "of", "is"), filled),
    ]
    return [table for table in found if table.rows]


def _by_outcome(element: Element) -> tuple[str, Element]:
    return element.outcome, element


def _percent(share: float | None) -> float | None:
    return None if share is None else 100 * share


def _finding_lines(found: Sequence[Finding]) -> Iterator[str]:
    for finding in found:
        yield f"{finding.place}: {finding.severity}: {printable(finding.message)}  [{finding.check.id}]"
        for step in finding.evidence[1:]:
            yield f"  {step.place}: {printable(step.text)}"


# JSON


def _recorded(summary: Summary) -> dict[str, Any]:
    return {
        "begin": summary.begin,
        "seconds": summary.seconds,
        "topics": [_stream(stream) for stream in summary.streams.values()],
        "delays": [
            {"from": source, "to": sink, "by": how, "number": found.count, **dict(zip(_SPREAD, _spread(found), strict=True))}
            for source, sink, how, found in delays(summary)
        ],
    }


_SPREAD = ("least", "median", "p99", "most")


def _stream(stream: Stream) -> dict[str, Any]:
    arrivals = stream.arrivals
    return {
        "topic": stream.topic, "type": stream.type, "sender": stream.sender, "messages": arrivals.count, "bytes": stream.size,
        "hz": arrivals.hz, "jitter": arrivals.intervals.deviation, "lost": stream.lost, "latched": stream.latched,
        "gaps": [{"after": begin, "seconds": length} for begin, length in arrivals.gaps()],
        "age": stream.ages.quantile(0.5) if stream.ages.count else None,
    }  # fmt: skip


def _snapshot(snapshot: Snapshot) -> dict[str, Any]:
    state = snapshot.state
    pairs = {"publishers": state.publishers, "subscribers": state.subscribers, "services": state.services}
    return {
        "at": snapshot.at,
        **{kind: [{"node": node, "name": name} for node, name in sorted(found)] for kind, found in pairs.items()},
        "others": [{"kind": kind, "node": node, "name": name} for kind, node, name in sorted(state.others)],
        "types": [{"kind": kind, "name": name, "type": type_} for (kind, name), type_ in sorted(snapshot.types.items())],
        "connections": [{"topic": topic, "from": sender, "to": reader} for sender, reader, topic in sorted(snapshot.connections)],
        "parameters": sorted(snapshot.parameters),
    }


def _compared(comparison: Comparison) -> dict[str, Any]:
    return {
        "system": comparison.system,
        "kinds": [
            {**asdict(a), "predicted": a.predicted, "seen": a.observed, "under": a.under, "over": a.over} for a in comparison.accuracies()
        ],
        "elements": [asdict(element) for element in comparison.elements],
        "filled": [asdict(filled) for filled in comparison.filled],
        "contradictions": [
            {
                "check": finding.check.id, "severity": finding.severity, "message": finding.message,
                "proofs": [{"at": str(step.place), "text": step.text} for step in finding.evidence],
            }
            for finding in comparison.contradictions
        ],
    }  # fmt: skip
