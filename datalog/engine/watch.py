"""The limits of an evaluation while one rule runs: without it they would be looked at only after the rule."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

from rosarch.datalog.engine.plan import Rule

if TYPE_CHECKING:
    from rosarch.datalog.engine.engine import Evaluation

INTERVAL = 0.1  # seconds


@contextmanager
def watching(evaluation: Evaluation) -> Iterator[None]:
    """Check the limits every now and then, where the system has timers and this is the main thread."""
    control = evaluation.control
    if not control.active or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return
    rules: dict[str, Rule] = {}
    for stratum in evaluation.code.strata:
        for rule in stratum.rules():
            rules[rule.function] = rule

    def look(_: int, frame: FrameType | None) -> None:
        while frame is not None:
            rule = rules.get(frame.f_code.co_name)
            if rule is not None and frame.f_code.co_filename == "<datalog>":
                control.check(rule, len(evaluation.slots[evaluation.code.relation_slot[rule.target]]))
                return
            frame = frame.f_back

    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, INTERVAL, INTERVAL)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
