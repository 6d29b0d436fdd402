"""How many of the warnings and errors are right? Those of public systems against what people judged by reading the code.

    benchmarks/precision.py SYSTEMS_DIR [--judgements FILE] [--findings DIR] [--only SYSTEM ...]

SYSTEMS_DIR has the sources of each system, in a folder with the name that the judgements give it; systems that are not there are left out.
A judgement says of one finding that it is true (somebody should change something), harmless (true, but without consequence) or false.
The table counts, for each check, the findings of each verdict, those that nobody judged yet, and those judged true that are no longer made.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from rosarch.cli.main import main as rosarch

VERDICTS = ("true", "harmless", "false")
COLUMNS = (*VERDICTS, "not judged", "lost")
NEAR = 3
"""Lines by which a finding may have moved since it was judged."""


@dataclass(frozen=True)
class Reported:
    """A warning or an error of a check."""

    system: str
    check: str
    file: str
    line: int
    message: str

    def __str__(self) -> str:
        return f"{self.system}: {self.file}:{self.line}: {self.message} [{self.check}]"

    @property
    def text(self) -> tuple[str, ...]:
        """All but the line."""
        return self.system, self.check, self.file, self.message


@dataclass(frozen=True)
class Judgement:
    """What somebody who read the code says of a finding; findings with the same `cause` are false for the same reason."""

    finding: Reported
    verdict: str
    cause: str


def read_judgements(path: Path) -> tuple[list[str], list[Judgement]]:
    """The systems of a file, those without a finding as well, and the judgements."""
    document = yaml.safe_load(path.read_text(encoding="utf-8"))
    return sorted(document["systems"]), [_judgement(row) for row in document["judgements"]]


def _judgement(row: dict[str, Any]) -> Judgement:
    verdict = str(row["verdict"]).lower()  # a bare word true is a Boolean of YAML
    if verdict not in VERDICTS:
        raise SystemExit(f"verdict {verdict!r} of {row['file']}:{row['line']} is none of {', '.join(VERDICTS)}")
    return Judgement(_reported(row["system"], row), verdict, row["cause"])


def _reported(system: str, row: dict[str, Any]) -> Reported:
    return Reported(system, row["check"], row["file"], row["line"], row["message"])


def matched(findings: Iterable[Reported], judgements: Iterable[Judgement]) -> dict[Reported, Judgement]:
    """The judgement of each finding that has one. Each judgement is for one finding, the nearest; findings on the very line come first."""
    free = defaultdict(list)
    for judgement in judgements:
        free[judgement.finding.text].append(judgement)
    pairs = [
        (abs(judgement.finding.line - finding.line), finding.line, judgement.finding.line, finding, judgement)
        for finding in set(findings)
        for judgement in free[finding.text]
    ]
    found: dict[Reported, Judgement] = {}
    taken = set()
    for distance, _, _, finding, judgement in sorted(pairs, key=lambda pair: pair[:3]):
        if distance <= NEAR and finding not in found and judgement not in taken:
            found[finding] = judgement
            taken.add(judgement)
    return found


def counted(findings: Sequence[Reported], judgements: Sequence[Judgement]) -> dict[str, Counter[str]]:
    """How many findings of each check there are in each column of the table."""
    found = matched(findings, judgements)
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for finding in set(findings):
        counts[finding.check][found[finding].verdict if finding in found else "not judged"] += 1
    for judgement in lost(judgements, found):
        counts[judgement.finding.check]["lost"] += 1
    return counts


def lost(judgements: Iterable[Judgement], found: dict[Reported, Judgement]) -> list[Judgement]:
    """The judgements of true findings that are not made any more."""
    made = set(found.values())
    return [judgement for judgement in judgements if judgement.verdict == "true" and judgement not in made]


def checked(system: Path, kept: Path | None) -> list[Reported]:
    """The warnings and errors of a system: those that an earlier run kept, or of a new run."""
    if kept and kept.exists():
        text = kept.read_text(encoding="utf-8")
    else:
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            code = rosarch(["check", str(system), "--format", "json"])
        text = out.getvalue()
        if code > 1:
            raise SystemExit(f"{system.name}: rosarch check exits with {code}")
        if kept:
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(text, encoding="utf-8")
    rows = json.loads(text.replace(f"{system.resolve()}/", ""))["findings"]
    return [_reported(system.name, row) for row in rows if row["severity"] != "note"]


def table(counts: dict[str, Counter[str]]) -> str:
    """The counts as a table of Markdown, and the share of each verdict among the findings that were judged."""
    every = sum(counts.values(), Counter())
    rows = [*sorted(counts.items()), ("all", every)]
    lines = [f"| check | {' | '.join(COLUMNS)} |", f"|---|{'---:|' * len(COLUMNS)}"]
    lines += [f"| {check} | {' | '.join(str(count[column]) for column in COLUMNS)} |" for check, count in rows]
    judged = sum(every[verdict] for verdict in VERDICTS)
    if judged:
        lines += ["", ", ".join(f"{100 * every[verdict] / judged:.1f} % {verdict}" for verdict in VERDICTS)]
    return "\n".join(lines)


def causes(found: dict[Reported, Judgement]) -> list[str]:
    """The causes of false findings, those of most findings first, with an example."""
    by_cause = defaultdict(list)
    for finding, judgement in found.items():
        if judgement.verdict == "false":
            by_cause[judgement.cause].append(str(finding))
    ordered = sorted(by_cause.items(), key=lambda item: (-len(item[1]), item[0]))
    return [f"{len(texts)} {cause}, as {min(texts)}" for cause, texts in ordered]


def main() -> None:
    """Check each system, and count."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("--judgements", type=Path, default=Path(__file__).with_name("judgements.yml"))
    parser.add_argument("--findings", type=Path, help="where the findings are kept; a system that has some there is not checked again")
    parser.add_argument("--only", nargs="+", metavar="SYSTEM")
    options = parser.parse_args()
    names, judgements = read_judgements(options.judgements)
    folders = [options.systems / name for name in names if (options.systems / name).is_dir() and (not options.only or name in options.only)]
    findings = []
    for folder in folders:
        print(f"{folder.name} ...", file=sys.stderr)
        findings += checked(folder, options.findings and options.findings / f"{folder.name}.json")
    there = {folder.name for folder in folders}
    judgements = [judgement for judgement in judgements if judgement.finding.system in there]
    found = matched(findings, judgements)
    print(table(counted(findings, judgements)))
    for title, texts in (
        ("false, by cause", causes(found)),
        ("not judged", sorted(str(finding) for finding in findings if finding not in found)),
        ("lost", [str(judgement.finding) for judgement in lost(judgements, found)]),
    ):
        if texts:
            print(f"\n{title}:", *texts, sep="\n  ")


if __name__ == "__main__":
    main()
