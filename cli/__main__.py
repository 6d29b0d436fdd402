"""The entry of the installed command and of `python -m rosarch.cli`: imports little, so that it is in charge from the start."""

from __future__ import annotations

import gc
import os
import signal
import sys


def script() -> int:
    """As `main`; when the command is ended from outside, worker processes and temporary files go, too."""
    while (descriptor := os.open(os.devnull, os.O_RDWR)) < 3:
        pass  # closed standard streams would be the next files that are opened
    os.close(descriptor)
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:  # as `nohup` asks
            signal.signal(number, lambda number, _frame: sys.exit(128 + number))
    gc.set_threshold(500_000)  # what is made is mostly kept until the end
    try:
        from rosarch.cli.main import main

        return main()
    except KeyboardInterrupt:  # while modules are loaded; later it is `main` that reports it
        print("rosarch: interrupted", file=sys.stderr)
        return 128 + signal.SIGINT


if __name__ == "__main__":
    sys.exit(script())
