"""Figures of a simulated run, as tables."""

from __future__ import annotations

from rosarch.behavior.simulation.records import Record, busy, latencies, queues, rates
from rosarch.reports.printable import printable
from rosarch.reports.tables import Table, table_text, tables_as

_MILLI = 1000


def simulation_text(record: Record) -> str:
    """Rates, queues, latencies and load."""
    head = f"{record.system}: {record.duration:g} s, seed {record.seed}, {len(record.events)} events\n\n"
    notes = [f"note: {printable(note)}\n" for note in dict.fromkeys(record.notes)]
    notes += [
        f"note: `{printable(text)}` of {printable(node)} was decided by lot, {number} times\n"
        for (node, text), number in sorted(record.guessed.items())
    ]
    return head + tables_as(table_text, simulation_tables(record)) + ("\n" if notes else "") + "".join(notes)


def simulation_tables(record: Record) -> list[Table]:
    """The tables that are not empty."""
    found = [
        Table(
            "rates",
            ("topic", "messages", "Hz", "shortest gap (ms)", "longest gap (ms)"),
            tuple((rate.topic, rate.number, rate.hz, _milli(rate.shortest), _milli(rate.longest)) for rate in rates(record)),
        ),
        Table(
            "queues",
            ("node", "topic", "most", "mean", "dropped"),
            tuple((queue.node, queue.topic, queue.most, queue.mean, queue.dropped) for queue in queues(record)),
        ),
        Table(
            "latencies (ms)",
            ("from", "to", "number", "least", "mean", "median", "95 %", "most"),
            tuple(
                (source, target, d.number, *(_milli(value) for value in (d.least, d.mean, d.median, d.high, d.most)))
                for (source, target), d in latencies(record).items()
            ),
        ),
        Table("load", ("node", "busy (%)"), tuple((node, 100 * part) for node, part in busy(record).items())),
    ]
    return [table for table in found if table.rows]


def _milli(seconds: float | None) -> float | None:
    return None if seconds is None else seconds * _MILLI
