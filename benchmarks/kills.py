"""End `rosarch` at random moments and see that no later run is wrong for it.

    benchmarks/kills.py WORKSPACE [--kills N] [--signal KILL|INT|TERM] [--command check|analyze] [--seed N]

A run begins with an empty cache, every third time with what earlier runs left of it, and is ended at a moment that is chosen by chance from
as long as such a run takes: in seconds of processor time, so that it falls within the run whatever else the machine does. Then the same
command runs to its end with that cache: it must print what a cold run prints. Ctrl-C (INT) goes to all processes of the run, as a terminal
sends it: one line must report it, unless it comes too late. No process and, but for those of a run that was killed, no folder for temporary
files may be left; these go with the next run.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

_MEASURED = 3


@dataclass(frozen=True)
class Ended:
    """What a run printed, and how it ended."""

    code: int
    output: bytes
    errors: bytes


@dataclass
class Trial:
    """Runs of one command in a folder of their own."""

    command: list[str]
    top: Path

    def __post_init__(self) -> None:
        (self.top / "tmp").mkdir()
        self.cache = self.top / "cache"
        self.environment = {**os.environ, "ROSARCH_CACHE_DIR": str(self.cache), "TMPDIR": str(self.top / "tmp")}

    def run(self, ends_after: float | None = None, number: signal.Signals = signal.SIGKILL) -> Ended:
        """Run the command, and end it after so many seconds of processor time."""
        with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
            process = subprocess.Popen(self.command, env=self.environment, stdout=output, stderr=errors, start_new_session=True)
            while ends_after is not None and process.poll() is None:
                if _processor_time(process.pid) >= ends_after:
                    if number is signal.SIGINT:
                        os.killpg(process.pid, number)
                    else:
                        process.send_signal(number)
                    break
                time.sleep(0.002)
            process.wait(None if ends_after is None else 60)
            _wait_for_group(process.pid)
            output.seek(0)
            errors.seek(0)
            return Ended(process.returncode, output.read(), errors.read())

    def forget(self) -> None:
        """Empty the cache of all but the compiled rules."""
        shutil.rmtree(self.cache / "units", ignore_errors=True)

    def seconds(self, cold: bool) -> float:
        """The least processor time of some runs."""
        taken = []
        for _ in range(_MEASURED):
            if cold:
                self.forget()
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.run()
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        return min(taken)

    def left(self) -> list[str]:
        """What lies among temporary files."""
        return sorted(path.name for path in (self.top / "tmp").iterdir())


def _processor_time(session: int) -> float:
    """Seconds that the processes of a session and those that they waited for have taken."""
    ticks = 0
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):  # it has ended meanwhile
            fields = stat.read_text(errors="replace").rpartition(")")[2].split()
            if int(fields[3]) == session:
                ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def _wait_for_group(group: int) -> None:
    """Until no process of a run is there any more; those that outlive it by more than five seconds are a defect."""
    until = time.monotonic() + 5
    while time.monotonic() < until:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return
        time.sleep(0.01)
    os.killpg(group, signal.SIGKILL)
    raise SystemExit("a process outlives its run")


def complaints(ended: Ended, number: signal.Signals, expected: Ended, left: list[str]) -> list[str]:
    """What is wrong with how a run ended."""
    told = {signal.SIGINT: (130, b"rosarch: interrupted\n"), signal.SIGTERM: (143, b""), signal.SIGKILL: (-9, b"")}
    code, errors = told[number]
    found = []
    if number is signal.SIGINT and ended.errors.endswith(b"KeyboardInterrupt\n") and b"/cli/" not in ended.errors:
        pass  # Python itself was about to begin
    elif ended.code == expected.code:
        found += [] if ended.output == expected.output else ["ended well with another report"]
    elif ended.code != code and ended.code != -number:  # before Python has begun, a signal ends it in the system's way
        found.append(f"ended with {ended.code}: {ended.errors[-300:]!r}")
    elif ended.code == code and errors != ended.errors[-len(errors) :]:
        found.append(f"printed {ended.errors[-300:]!r}")
    if left and number is not signal.SIGKILL and ended.code != -number:
        found.append(f"left {', '.join(left)}")
    return found


def main() -> int:
    """Kill, run again, compare."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("workspace", type=Path)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--signal", choices=("KILL", "INT", "TERM"), default="KILL")
    parser.add_argument("--command", choices=("check", "analyze"), default="check")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    number = signal.Signals[f"SIG{options.signal}"]
    chance = random.Random(options.seed)
    count: Counter[str] = Counter()
    with tempfile.TemporaryDirectory(prefix="kills-") as top:
        command = [sys.executable, "-m", "rosarch.cli", options.command, str(options.workspace), "--format", "json"]
        trial = Trial(command, Path(top))
        expected = trial.run()
        seconds = {cold: trial.seconds(cold) for cold in (True, False)}
        for index in range(options.kills):
            cold = index % 3 != 2
            if cold:
                trial.forget()
            moment = chance.uniform(0, seconds[cold])
            ended = trial.run(moment, number)
            wrong = complaints(ended, number, expected, trial.left())
            later = trial.run()
            if (later.code, later.output) != (expected.code, expected.output):
                wrong.append(f"the run after it ended with {later.code}: {later.errors[-300:]!r}")
            if trial.left():
                wrong.append(f"the run after it left {', '.join(trial.left())}")
            count["too late" if ended.code == expected.code else "ended"] += 1
            count["wrong"] += bool(wrong)
            for text in wrong:
                print(f"{index}, after {moment:.3f} s of processor time: {text}", flush=True)
    ended = f"{count['ended']} ended by it, {count['too late']} before it"
    print(f"{options.kills} runs of rosarch {options.command} and SIG{options.signal}: {ended}; {count['wrong']} wrong")
    return 1 if count["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
