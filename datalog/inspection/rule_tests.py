"""Drop-in tests of rules: folders with `facts/*.facts` and `expected/<relation>.csv`.

A test may bring a `program.dl` of its own; without one the given program is tested. Only relations with an expected
file are compared: its lines are the rows, tab-separated, records written `[a, b]`; their order is of no account. A
file `known_failure.txt` says why a test fails today.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosarch.datalog.inspection.rows import RowStore
from rosarch.datalog.inspection.rule_coverage import Collector, Coverage
from rosarch.datalog.language.errors import DatalogError
from rosarch.datalog.language.values import ValueWriter
from rosarch.datalog.program import Program, Result, load_program

EXPECTED, FACTS, PROGRAM, KNOWN_FAILURE = "expected", "facts", "program.dl", "known_failure.txt"
_UNSAFE = str.maketrans("\t\n\r", "   ")


@dataclass(frozen=True, slots=True)
class Difference:
    """The rows of one relation that are expected and missing, and those that are there and not expected."""

    relation: str
    missing: tuple[str, ...]
    unexpected: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TestOutcome:
    """What became of one test; `known_failure` is why it is known to fail, `error` why it could not be run."""

    name: str
    differences: tuple[Difference, ...] = ()
    error: str = ""
    known_failure: str = ""

    @property
    def passed(self) -> bool:
        """Whether every row is as expected."""
        return not self.differences and not self.error

    @property
    def ok(self) -> bool:
        """Whether the test does as it should: it passes, or fails and is known to."""
        return self.passed != bool(self.known_failure)


@dataclass(frozen=True, slots=True)
class TestReport:
    """All outcomes, and the coverage of each program, by its root file."""

    outcomes: tuple[TestOutcome, ...]
    coverage: tuple[tuple[Path, Coverage], ...]

    @property
    def ok(self) -> bool:
        """Whether every test does as it should."""
        return all(o.ok for o in self.outcomes)


def find_tests(folder: Path) -> list[Path]:
    """The folders of tests at or below a folder."""
    return sorted(path.parent for path in folder.rglob(EXPECTED) if next(path.glob("*.csv"), None) is not None)


def run_rule_tests(
    folder: Path, default: Sequence[Path] | Program, *, engine: str = "embedded", progress: Callable[[TestOutcome], None] | None = None
) -> TestReport:
    """Run every test at or below a folder; `default` is the program of tests without their own, or its files."""
    given = (Path(next(iter(default.sources))),) if isinstance(default, Program) else tuple(default)
    collectors: dict[tuple[Path, ...], Collector] = {}
    outcomes = []
    for case in find_tests(folder):
        own = case / PROGRAM
        files = (own,) if own.is_file() else given
        name = str(case.relative_to(folder)) if case != folder else folder.resolve().name
        reason = case / KNOWN_FAILURE
        known = reason.read_text(encoding="utf-8").strip() or "yes" if reason.is_file() else ""
        try:
            if files not in collectors:
                collectors[files] = Collector(default if isinstance(default, Program) and files == given else load_program(files))
            outcome = TestOutcome(name, tuple(_run(case, collectors[files], engine)), known_failure=known)
        except (DatalogError, OSError, UnicodeDecodeError) as error:
            outcome = TestOutcome(name, error=str(error), known_failure=known)
        outcomes.append(outcome)
        if progress is not None:
            progress(outcome)
    return TestReport(tuple(outcomes), tuple((files[0], c.coverage()) for files, c in collectors.items()))


def _run(case: Path, collector: Collector, engine: str) -> Iterator[Difference]:
    program = collector.program
    facts = program.read_facts(case / FACTS) if (case / FACTS).is_dir() else {}
    result = program.evaluate(facts, engine=engine, keep="all")
    collector.add(RowStore(result, facts))
    for path in sorted((case / EXPECTED).glob("*.csv")):
        if path.stem not in program.relations:
            raise DatalogError(f"{path}: there is no relation `{path.stem}`")
        expected = set(path.read_text(encoding="utf-8").splitlines())
        actual = set(_lines(program, result, path.stem))
        if expected != actual:
            yield Difference(path.stem, tuple(sorted(expected - actual)), tuple(sorted(actual - expected)))


def _lines(program: Program, result: Result, name: str) -> Iterator[str]:
    show = ValueWriter(program.types).show
    types = [a.type for a in program.relations[name].attributes]
    for row in result.rows(name):
        yield "\t".join(show(v, t).translate(_UNSAFE) for v, t in zip(row, types, strict=True)) if row else "()"


def outcome_text(outcome: TestOutcome) -> str:
    """One line for a test that does as it should, else what is wrong with it."""
    if outcome.ok:
        return f"ok       {outcome.name}\n" if outcome.passed else f"known    {outcome.name}: {outcome.known_failure.splitlines()[0]}\n"
    if outcome.passed:
        return f"FAILED   {outcome.name}: passes now, remove {KNOWN_FAILURE}\n"
    lines = [f"FAILED   {outcome.name}", *(f"  {line}" for line in outcome.error.splitlines())]
    for difference in outcome.differences:
        lines.append(f"  {difference.relation}:")
        lines += [f"    missing     {row}" for row in difference.missing]
        lines += [f"    unexpected  {row}" for row in difference.unexpected]
    return "".join(f"{line}\n" for line in lines)


def report_text(report: TestReport, *, shorten: Callable[[str], str] = str, unfired: bool = True) -> str:
    """The coverage of every program, and how many tests do as they should."""
    lines = []
    for path, found in report.coverage:
        if not found.clauses:
            continue
        share = 100 * found.fired // found.clauses
        lines.append(f"coverage of {shorten(str(path))}: {found.fired} of {found.clauses} clauses fired ({share} %)")
        if found.unfired and unfired:
            lines.append("never fired:")
            lines += [f"  {shorten(c.location.path)}:{c.location.line}: {c.text}" for c in found.unfired]
    failed = sum(not o.ok for o in report.outcomes)
    total = len(report.outcomes)
    lines.append(f"{total} test{'s' * (total != 1)}, {failed} failed" if total else "no tests")
    return "".join(f"{line}\n" for line in lines)
