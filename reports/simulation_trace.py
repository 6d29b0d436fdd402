"""Simulated runs as traces: CSV and JSON."""

from __future__ import annotations

from dataclasses import asdict

from rosarch.behavior.simulation.records import Record, busy, latencies, queues, rates
from rosarch.reports.printable import json_text
from rosarch.reports.tables import Table, table_csv


def trace_csv(record: Record) -> str:
    """A line for each event."""
    rows = tuple((round(event.time, 9), event.kind, event.actor, event.subject, event.detail) for event in record.events)
    return table_csv(Table("trace", ("time", "kind", "actor", "subject", "detail"), rows))


def simulation_json(record: Record) -> str:
    """The figures and all events."""
    document = {
        "system": record.system,
        "seed": record.seed,
        "duration": record.duration,
        "rates": [asdict(rate) for rate in rates(record)],
        "queues": [asdict(queue) for queue in queues(record)],
        "latencies": [{"from": source, "to": target, **asdict(figures)} for (source, target), figures in latencies(record).items()],
        "busy": busy(record),
        "guessed": [{"node": node, "condition": text, "times": number} for (node, text), number in sorted(record.guessed.items())],
        "notes": list(dict.fromkeys(record.notes)),
        "events": [asdict(event) for event in record.events],
    }
    return json_text(document, 1)
