"""Hand many inputs to everything that reads what others wrote; each crash, hang and excess of memory is printed and kept.

.venv/bin/python tests/fuzz/run.py --inputs 10000             # all targets
.venv/bin/python tests/fuzz/run.py --inputs 10000 launch cmake
.venv/bin/python tests/fuzz/run.py --atheris launch           # guided by coverage, until stopped; `pip install -e '.[fuzz]'`
"""

from __future__ import annotations

import argparse
import hashlib
import os
import resource
import shutil
import sys
import tempfile
import time
import traceback
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from mutations import mutants  # noqa: E402
from targets import TARGETS, Target, prepare  # noqa: E402

from rosarch.base.pool import Failure, default_jobs, run_tasks  # noqa: E402

SLOW = 3.0
"""Seconds of processor time that no input of this size may take."""
MEMORY = 1 << 30
"""Bytes that a worker may have beyond those that it begins with."""
_BATCH = 50
_HANG = 30.0
"""Seconds for a batch; one that is not done by then is tried again input by input."""
_HANG_ALONE = 120.0
"""Seconds for one input: beside other work, what takes a second of processor time takes long."""
OWN_PROCESS = frozenset({"cxx"})
"""Targets that may end their process, or be ended: a unit that does costs itself."""


@dataclass(frozen=True)
class Defect:
    """An input that a reader cannot take, and why."""

    target: str
    data: bytes
    reason: str


@dataclass
class Costs:
    """The most that an input took: seconds of processor time, bytes that its process had; and how many ended theirs, where that is no defect."""

    seconds: float = 0.0
    memory: int = 0
    ended: int = 0

    def include(self, other: Costs) -> None:
        """Take in what other inputs took."""
        self.seconds, self.memory = max(self.seconds, other.seconds), max(self.memory, other.memory)


def seeds(name: str) -> list[bytes]:
    """The corpus of a target, inputs that once failed among it."""
    return [path.read_bytes() for path in sorted((HERE / "corpus" / name).iterdir())]


def inputs(target: Target, count: int, seed: int) -> list[bytes]:
    """The corpus and what is made from it, `count` inputs in all."""
    return list(mutants(seeds(target.name), target.words, count, f"{seed} {target.name}"))


def defects(target: Target, given: Sequence[bytes], jobs: int, costs: Costs) -> Iterator[Defect]:
    """Those of the inputs that `target` cannot take; `costs` learns what they took."""
    top = Path(tempfile.mkdtemp(prefix="rosarch-fuzz-"))
    memory = MEMORY + _addresses()
    try:
        os.environ["ROSARCH_CACHE_DIR"] = str(top / "cache")

        def work(batch: Sequence[bytes]) -> tuple[list[tuple[int, str]], Costs]:
            taken = Costs()
            return list(_tried(target, batch, top / str(os.getpid()), taken)), taken

        batches = [given[begin : begin + _BATCH] for begin in range(0, len(given), _BATCH)]
        again: list[bytes] = []
        for index, outcome in run_tasks(work, batches, jobs=jobs, timeout=_HANG, memory=memory):
            if isinstance(outcome, Failure):
                again += batches[index]
            else:
                costs.include(outcome[1])
                yield from (Defect(target.name, batches[index][at], reason) for at, reason in outcome[0])
        for index, outcome in run_tasks(work, [[data] for data in again], jobs=jobs, timeout=_HANG_ALONE, memory=memory):
            if isinstance(outcome, Failure):
                costs.ended += 1
                if target.name not in OWN_PROCESS:
                    yield Defect(target.name, again[index], f"{outcome.reason}: {outcome.detail}")
            else:
                costs.include(outcome[1])
                yield from (Defect(target.name, again[index], reason) for _, reason in outcome[0])
    finally:
        shutil.rmtree(top, ignore_errors=True)


def _addresses() -> int:
    """Bytes of the addresses of this process, which may have run other tests: its workers begin with as many."""
    sizes = Path("/proc/self/statm")
    return int(sizes.read_text().split()[0]) * resource.getpagesize() if sizes.exists() else 0


def _tried(target: Target, batch: Iterable[bytes], folder: Path, costs: Costs) -> Iterator[tuple[int, str]]:
    """The position of each input that fails, and why; `costs` learns what they took."""
    if not folder.is_dir():
        folder.mkdir()
        prepare(folder)
        target.run(b"", folder)  # what is made once takes no time of the first input
    for at, data in enumerate(batch):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        try:
            target.run(data, folder)
        except (MemoryError, RecursionError) as error:
            yield at, f"{type(error).__name__}: {_where(error)}"
        except Exception as error:
            yield at, f"{type(error).__name__}: {' '.join(str(error).split())[:200]}: {_where(error)}"
        after = resource.getrusage(resource.RUSAGE_SELF)
        taken = after.ru_utime - before
        costs.include(Costs(taken, after.ru_maxrss << 10))
        if taken > SLOW and target.name not in OWN_PROCESS:
            yield at, f"slow: {taken:.1f} s"


def _where(error: BaseException) -> str:
    frames = traceback.extract_tb(error.__traceback__)
    ours = [
        frame
        for frame in frames
        if f"{HERE.parent.parent}/" in frame.filename and "/tests/" not in frame.filename and ".venv" not in frame.filename
    ]
    frame = (ours or frames)[-1]
    return f"{Path(frame.filename).name}:{frame.lineno} {frame.name}"


def _with_atheris(target: Target) -> None:
    """Fuzz one target, guided by coverage, until it fails or is stopped."""
    import atheris

    folder = Path(tempfile.mkdtemp(prefix="rosarch-fuzz-"))
    os.environ["ROSARCH_CACHE_DIR"] = str(folder / "cache")
    prepare(folder)
    found = folder / "found"
    found.mkdir()
    with atheris.instrument_imports(include=["rosarch"]):
        target.run(b"", folder)  # imports what is to be instrumented
    arguments = [sys.argv[0], str(found), str(HERE / "corpus" / target.name), "-timeout=10", "-rss_limit_mb=2048"]
    atheris.Setup(arguments, lambda data: target.run(data, folder))
    atheris.Fuzz()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"one of {', '.join(TARGETS)}; all by default")
    parser.add_argument("--inputs", type=int, default=1000, help="inputs for each target")
    parser.add_argument("--seed", type=int, default=0, help="another seed makes other inputs")
    parser.add_argument("--jobs", type=int, default=default_jobs())
    parser.add_argument("--out", type=Path, default=Path("fuzz-defects"), help="where inputs that fail are kept")
    parser.add_argument("--atheris", action="store_true", help="let atheris make the inputs of one target")
    given = parser.parse_args()
    if unknown := [name for name in given.targets if name not in TARGETS]:
        parser.error(f"no target: {', '.join(unknown)}")
    chosen = [TARGETS[name] for name in given.targets or TARGETS]
    if given.atheris:
        _with_atheris(chosen[0])
    failed = 0
    for target in chosen:
        begin, reasons, costs, bad = time.monotonic(), set(), Costs(), 0
        for defect in defects(target, inputs(target, given.inputs, given.seed), given.jobs, costs):
            bad += 1
            if defect.reason not in reasons:
                reasons.add(defect.reason)
                given.out.mkdir(parents=True, exist_ok=True)
                kept = given.out / f"{target.name}-{hashlib.sha256(defect.data).hexdigest()[:12]}"
                kept.write_bytes(defect.data)
                print(f"{target.name}: {defect.reason}  {kept}", flush=True)
        failed += bad
        most = f"slowest {costs.seconds:.2f} s, most memory {costs.memory >> 20} MiB, {costs.ended} ended their process"
        print(f"{target.name}: {given.inputs} inputs, {bad} failed, {most}; {time.monotonic() - begin:.0f} s", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
