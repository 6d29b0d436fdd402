"""Compare what two revisions of rosarch print about systems, byte for byte: for changes that are to change nothing.

    benchmarks/same_output.py OLD [NEW] --systems DIR...

OLD and NEW are git revisions of this repository; without NEW it is the checkout as it lies there. On every example and every DIR both
run the commands of `COMMANDS`; a line for each output that differs, with the first line that does, and exit code 1. Paths of rule files
in the output are compared without their folders, since rules may move.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from rosarch.base.git_revisions import export, resolve

TOP = Path(__file__).resolve().parents[1]
COMMANDS = (
    ("analyze", "--format", "json"),
    ("show", "behavior"),
    ("check", "-v", "--format", "json"),
    ("show", "graph", "--format", "json"),
    ("launch",),
)
_RULE_FILE = re.compile(r"[\w./-]*?(\w[\w-]*\.dl)\b")
_SECONDS = re.compile(r"\b\d+(\.\d+)? s\b")


@contextmanager
def checkout(revision: str | None) -> Iterator[Path]:
    """A folder of this revision."""
    if revision is None:
        yield TOP
        return
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "checkout")
        export(resolve(revision, TOP), TOP, path)
        yield path


def outputs(source: Path, system: Path, work: Path) -> dict[str, str]:
    """What each command prints about a system, and its exit code; what differs between two runs of one revision is left out."""
    found = {}
    packages = work / "packages"
    packages.mkdir(parents=True, exist_ok=True)
    if not (packages / "rosarch").exists():
        (packages / "rosarch").symlink_to(source)
    environment = {**os.environ, "PYTHONPATH": str(packages), "ROSARCH_CACHE_DIR": str(work / "cache"), "COLUMNS": "200"}
    for command, *options in COMMANDS:
        arguments = [command, options[0], str(system), *options[1:]] if command == "show" else [command, str(system), *options]
        done = subprocess.run(
            [sys.executable, "-m", "rosarch.cli", *arguments], env=environment, capture_output=True, text=True, check=False
        )
        text = _SECONDS.sub("N s", _RULE_FILE.sub(r"\1", done.stdout))
        found[" ".join((command, *options))] = f"{text}\nexit code {done.returncode}\n"
    return found


def difference(old: str, new: str) -> str:
    """The first lines that differ."""
    pairs = zip(old.splitlines(), new.splitlines(), strict=False)
    first = next(((a, b) for a, b in pairs if a != b), ("", f"{len(old.splitlines())} and {len(new.splitlines())} lines"))
    return " | ".join(line.strip()[:160] for line in first)


def main() -> int:
    """Compare what the arguments name."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", metavar="OLD")
    parser.add_argument("new", metavar="NEW", nargs="?")
    parser.add_argument("--systems", metavar="DIR", type=Path, nargs="*", default=[])
    arguments = parser.parse_args()
    examples = sorted(path.parent for path in (TOP / "examples").glob("*/src"))
    differ = compared = 0
    with (
        checkout(arguments.old) as old,
        checkout(arguments.new) as new,
        tempfile.TemporaryDirectory() as work,
        ThreadPoolExecutor(2) as pool,
    ):
        for system in [*examples, *(path.absolute() for path in arguments.systems)]:
            runs = [pool.submit(outputs, source, system, Path(work, name)) for name, source in (("old", old), ("new", new))]
            before, after = (run.result() for run in runs)
            for command, text in before.items():
                compared += 1
                if text != after[command]:
                    differ += 1
                    print(f"{system.name}: rosarch {command}: {difference(text, after[command])}", flush=True)
    print(f"{compared} outputs of {len(examples) + len(arguments.systems)} systems compared, {differ} differ")
    return 1 if differ else 0


if __name__ == "__main__":
    raise SystemExit(main())
