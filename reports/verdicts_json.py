"""What checkers found about properties, as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict

from rosarch.behavior.verification.check import Verdict
from rosarch.reports.printable import json_text


def verdicts_text(system: str, verdicts: Sequence[Verdict], checker: str) -> str:
    """One document; a counterexample has its steps, those of `loop` forever."""
    rows = [
        {
            "property": found.property.name,
            "formula": found.property.text,
            "line": found.property.line,
            "verdict": found.verdict,
            "states": found.states,
            "seconds": round(found.seconds, 3),
            "notes": list(found.notes),
            "counterexample": None if found.trace is None else {**asdict(found.trace), "assumes": list(found.trace.assumes)},
        }
        for found in verdicts
    ]
    return json_text({"system": system, "checker": checker, "properties": rows})
