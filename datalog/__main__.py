"""`python -m rosarch.datalog PROGRAM.dl -F FACTS -D OUT`: evaluate a program with souffle's option letters."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.program import Program, Result, load_program

# Options of souffle that change how it runs, not what it computes.
_WITHOUT_EFFECT = (
    (("-j", "--jobs"), "N"), (("-z", "--disable-transformers"), "NAMES"), (("-m", "--magic-transform"), "NAMES"),
    (("--magic-transform-exclude",), "NAMES"), (("--inline-exclude",), "NAMES"), (("-W", "--warn"), "NAME"), (("--wno",), "NAME"),
    (("--preprocessor",), "CMD"), (("-a", "--auto-schedule"), "FILE"), (("-L", "--library-dir"), "DIR"),
)  # fmt: skip
_REFUSED = (
    (("-c", "--compile"), "the embedded engine has no compiler to C++; `--engine souffle` runs the binary"),
    (("-C", "--compile-many"), "the embedded engine has no compiler to C++; `--engine souffle` runs the binary"),
)
_REFUSED_WITH_VALUE = (
    (("-o", "--dl-program"), "the embedded engine does not make binaries"),
    (("-g", "--generate"), "the embedded engine does not generate C++"),
    (("-G", "--generate-many"), "the embedded engine does not generate C++"),
    (("-s", "--swig"), "the embedded engine has no SWIG interface"),
    (("-t", "--provenance"), "proofs are given by `rosarch explain` and by `rosarch.datalog.explain`"),
    (("-r", "--debug-report"), "the embedded engine writes no debug report"),
    (("--show",), "the embedded engine has no intermediate program to show"),
)


class _Refuse(argparse.Action):
    """An option of souffle that has no meaning here."""

    def __call__(self, parser: argparse.ArgumentParser, namespace: object, values: object, option_string: str | None = None) -> None:
        parser.error(f"{option_string}: {self.const}")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m rosarch.datalog", description=__doc__, allow_abbrev=False)
    parser.add_argument("program", type=Path, nargs="+", help="rule files")
    parser.add_argument("-F", "--fact-dir", "--facts", metavar="DIR", help="folder of .facts files (default: .)")
    parser.add_argument("-D", "--output-dir", "--output", metavar="DIR", help="folder for .csv files, `-` for stdout (default: .)")
    parser.add_argument("-I", "--include-dir", type=Path, action="append", default=[], metavar="DIR", help="folder for included files")
    parser.add_argument("-M", "--macro", action="append", default=[], metavar="MACROS", help="macros of the C preprocessor: 'A B=1'")
    parser.add_argument("--no-preprocessor", action="store_true", help="take `#` lines as comments")
    parser.add_argument("-P", "--pragma", action="append", default=[], metavar="OPTIONS", help="pragmas, without effect")
    parser.add_argument("-l", "--libraries", type=Path, action="append", default=[], metavar="FILE", help="functors: Python files")
    parser.add_argument("-p", "--profile", type=Path, metavar="FILE", help="write a table of rules by time and rows")
    parser.add_argument("-w", "--no-warn", action="store_true", help="no warnings; missing fact files are empty")
    parser.add_argument("--werror", action="store_true", help="warnings are errors")
    parser.add_argument("-v", "--verbose", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--legacy", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--parse-errors", action="store_true", help="only check the program")
    parser.add_argument("--version", action="store_true", help="show the version")
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    parser.add_argument("--bits", type=int, choices=(32, 64), default=32, help="width of numbers (default: 32)")
    parser.add_argument("--limit-rows", type=int, metavar="N", help="stop when a relation has more rows")
    parser.add_argument("--time-limit", type=float, metavar="SECONDS", help="stop after so long")
    for flags, value in _WITHOUT_EFFECT:
        parser.add_argument(*flags, action="append", metavar=value, help=argparse.SUPPRESS)
    for flags, reason in _REFUSED:
        parser.add_argument(*flags, action=_Refuse, nargs=0, const=reason, help=argparse.SUPPRESS)
    for flags, reason in _REFUSED_WITH_VALUE:
        parser.add_argument(*flags, action=_Refuse, const=reason, help=argparse.SUPPRESS)
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit code: 0, or 2 after an error, when nothing has been written."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    if "--version" in arguments:
        from importlib.metadata import version

        print(f"rosarch {version('rosarch')}, Datalog of souffle 2.5")
        return 0
    options = _parser().parse_args(arguments)
    try:
        _run(options)
    except DatalogError as error:
        print(error, file=sys.stderr)
        return 2
    except RecursionError:
        print("the program is nested too deeply", file=sys.stderr)
        return 2
    except MemoryError:
        print("out of memory", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:  # the reader of stdout has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    return 0


def _run(options: argparse.Namespace) -> None:
    for folder in options.include_dir:
        if not folder.is_dir():
            raise DatalogError(f"no such folder of included files: `{folder}`")
    functors = {}
    if options.libraries:
        from rosarch.datalog.engine.user_functors import load_functors

        functors = load_functors(options.libraries)
    program = load_program(
        options.program, preprocess=not options.no_preprocessor, macros=[m for text in options.macro for m in text.split()],
        include=options.include_dir, bits=options.bits, functors=functors,
    )  # fmt: skip
    quiet = options.no_warn or "no-warn" in program.pragmas or "suppress-warnings" in program.pragmas
    _warn(program, quiet, options.werror)
    if options.parse_errors:
        return
    folder = options.output_dir or program.pragmas.get("output-dir") or "."
    if folder != "-" and Path(folder).exists() and not Path(folder).is_dir():
        raise DatalogError(f"not a folder for outputs: `{folder}`")
    facts = program.read_facts(Path(options.fact_dir or program.pragmas.get("fact-dir") or "."), strict=not options.no_warn)
    from rosarch.datalog.files.outputs import OutputWriter

    OutputWriter(program, _evaluate(program, facts, options), folder).write()


def _warn(program: Program, quiet: bool, as_errors: bool) -> None:
    if as_errors and program.warnings:
        raise DatalogError([Diagnostic(w.message, w.location, w.hint, w.source) for w in program.warnings])
    for warning in () if quiet else program.warnings:
        print(warning, file=sys.stderr)


def _evaluate(program: Program, facts: dict[str, list[tuple[object, ...]]], options: argparse.Namespace) -> Result:
    if options.profile is None:
        return program.evaluate(facts, engine=options.engine, limit_rows=options.limit_rows, time_limit=options.time_limit)
    from rosarch.datalog.inspection.profiling import profile, profile_text

    found = profile(program, facts, keep=None)
    try:
        options.profile.write_text(profile_text(found, most=1000), encoding="utf-8")
    except OSError as error:
        raise DatalogError(f"{options.profile}: cannot write: {error.strerror}") from None
    return found.result


if __name__ == "__main__":
    sys.exit(main())
