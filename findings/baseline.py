"""A baseline: the findings a team has decided to live with for now, so that only new ones are reported.

It knows findings by their fingerprints, which line shifts do not change. Equal findings of one file are counted, not distinguished: when a
file had two and has three now, one is new.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict, dataclass

from rosarch.findings.model import Finding

FORMAT = 1


class BaselineError(Exception):
    """A text that is no baseline; one line, `path:line:col: message`."""


@dataclass(frozen=True, order=True)
class BaselineEntry:
    """One finding; check, file and message are there for the reader."""

    file: str
    check: str
    message: str
    fingerprint: str


@dataclass(frozen=True)
class Baseline:
    """The findings that are known."""

    entries: tuple[BaselineEntry, ...]

    @classmethod
    def of(cls, findings: Iterable[Finding]) -> Baseline:
        """The baseline that knows these findings, in an order that does not depend on theirs."""
        return cls(tuple(sorted(BaselineEntry(f.place.path, f.check.id, f.message, f.fingerprint) for f in findings)))


def baseline_text(baseline: Baseline) -> str:
    """The file of a baseline: JSON for reviewers and for version control."""
    findings = [asdict(entry) for entry in baseline.entries]
    return json.dumps({"rosarch_baseline": FORMAT, "findings": findings}, indent=2, ensure_ascii=False) + "\n"


def read_baseline(text: str, path: str) -> Baseline:
    """The baseline in a file.

    Raises:
        BaselineError: the text is none.
    """
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise BaselineError(f"{path}:{error.lineno}:{error.colno}: not a baseline: {error.msg.lower()}") from None
    except RecursionError:
        raise BaselineError(f"{path}:1:1: not a baseline: nested too deeply") from None
    except ValueError as error:  # a number of more digits than Python reads
        raise BaselineError(f"{path}:1:1: not a baseline: {str(error).partition(';')[0].lower()}") from None
    if not isinstance(data, dict) or "rosarch_baseline" not in data:
        raise BaselineError(f"{path}:1:1: not a baseline: `rosarch check --write-baseline FILE` writes one")
    if data["rosarch_baseline"] != FORMAT:
        raise BaselineError(f"{path}:1:1: a baseline of format {data['rosarch_baseline']!r}, this version reads format {FORMAT}")
    fields = ("file", "check", "message", "fingerprint")
    entries = []
    for number, item in enumerate(data["findings"] if isinstance(data.get("findings"), list) else [None], 1):
        if not (isinstance(item, dict) and all(isinstance(item.get(field), str) for field in fields)):
            raise BaselineError(f"{path}:1:1: not a baseline: finding {number} lacks one of {', '.join(fields)}")
        entries.append(BaselineEntry(*(item[field] for field in fields)))
    return Baseline(tuple(entries))


def compare(
    baseline: Baseline, active: Iterable[Finding], hidden: Iterable[Finding]
) -> tuple[list[Finding], list[Finding], list[BaselineEntry]]:
    """The active findings that are new, those that are known, and the entries that nothing answers to any more.

    Findings that are `hidden`, for another reason than the baseline, keep an entry alive but come second.
    """
    left = Counter(entry.fingerprint for entry in baseline.entries)
    new: list[Finding] = []
    known: list[Finding] = []
    for finding in active:
        if left[finding.fingerprint] > 0:
            left[finding.fingerprint] -= 1
            known.append(finding)
        else:
            new.append(finding)
    left -= Counter(finding.fingerprint for finding in hidden)
    gone = []
    for entry in baseline.entries:
        if left[entry.fingerprint] > 0:
            left[entry.fingerprint] -= 1
            gone.append(entry)
    return new, known, gone
