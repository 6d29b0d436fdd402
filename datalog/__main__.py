"""`python -m rosarch.datalog PROGRAM.dl -F FACTS -D OUT`: evaluate a program on a folder of facts."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from .errors import DatalogError
from .program import Program, Result, load_program
from .row_text import column_writer


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m rosarch.datalog", description=__doc__)
    parser.add_argument("program", type=Path, nargs="+", help="rule files")
    parser.add_argument("-F", "--facts", type=Path, default=Path("."), help="folder of .facts files")
    parser.add_argument("-D", "--output", default=".", help="folder for .csv files, `-` for stdout")
    parser.add_argument("--engine", choices=("embedded", "souffle"), default="embedded")
    parser.add_argument("--limit-rows", type=int, help="stop when a relation has more rows")
    parser.add_argument("-w", "--no-warn", action="store_true", help="no warnings")
    options = parser.parse_args(argv)
    try:
        program = load_program(options.program)
        if not options.no_warn:
            for warning in program.warnings:
                print(warning, file=sys.stderr)
        result = program.evaluate(options.facts, engine=options.engine, limit_rows=options.limit_rows)
        _write(program, result, options.output)
    except DatalogError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def _write(program: Program, result: Result, output: str) -> None:
    """Write the outputs as souffle does: a file each, or all to stdout under a ruled heading."""
    outputs = {d.relation for d in program.directives if d.kind == "output"}
    for directive in program.directives:
        if directive.kind == "printsize":
            print(f"{directive.relation}\t{result.count(directive.relation)}")
    for name in sorted(outputs):
        attributes = program.relations[name].attributes
        lines = result.lines(name, [column_writer(a.type, program.types) for a in attributes])
        if output == "-":
            header = "\t".join(a.name for a in attributes)
            print(f"---------------\n{name}\n{header}\n===============")
            sys.stdout.writelines(lines)
            print("===============")
        else:
            folder = Path(output)
            folder.mkdir(parents=True, exist_ok=True)
            with (folder / f"{name}.csv").open("w", encoding="utf-8", errors="surrogateescape", newline="") as stream:
                stream.writelines(lines)


if __name__ == "__main__":
    sys.exit(main())
