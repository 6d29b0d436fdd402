"""What a team has settled about checking its workspace."""

from __future__ import annotations

from dataclasses import dataclass

from rosarch.base.places import Place
from rosarch.findings.policy import Severities

NAME = ".rosarch.yml"
"""The file that says so."""


@dataclass(frozen=True)
class LaunchChoice:
    """Launch files that are started together; every combination of the values of `arguments` is a system."""

    files: tuple[str, ...]
    arguments: tuple[tuple[str, tuple[str, ...]], ...]
    at: Place


@dataclass(frozen=True)
class RateGiven:
    """How many messages per second pass through `topic`: from `low` to `high`."""

    topic: str
    low: float
    high: float
    at: Place


@dataclass(frozen=True)
class Configuration:
    """The settings of a workspace; None and empty ones are not given. Paths are as written: relative to the folder of the file."""

    checks: Severities = ()
    fail_on: str | None = None
    ignore_paths: tuple[str, ...] = ()
    baseline: str | None = None
    launch: tuple[LaunchChoice, ...] = ()
    package_path: tuple[str, ...] = ()
    environment: tuple[tuple[str, str], ...] = ()
    rates: tuple[RateGiven, ...] = ()
