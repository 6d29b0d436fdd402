"""The workspaces of a corpus as tasks of a Dask cluster."""

from __future__ import annotations

import logging
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from rosarch.evaluation.corpus.task import Done, Failed, Job, Unfinished, analyse

CONNECTING = 15.0
"""Seconds to wait for a scheduler."""


class NoCluster(Exception):
    """No workers are available; the text says why."""


@dataclass(frozen=True)
class Cluster:
    """Where tasks run: the scheduler at `address`, or `workers` processes of this machine; what fails is tried again `retries` times."""

    address: str | None = None
    workers: int = 1
    retries: int = 2


def run(jobs: Sequence[Job], cluster: Cluster) -> Iterator[tuple[int, Done | Failed]]:
    """Yield (index of the job, what came of it) as they are done.

    Raises:
        NoCluster: Dask is not installed, or the scheduler does not answer.
    """
    distributed = _dask()
    with _client(distributed, cluster) as client:
        futures = {client.submit(analyse, job, retries=cluster.retries, pure=False): index for index, job in enumerate(jobs)}
        try:
            for future in distributed.as_completed(futures):
                yield futures[future], future.result() if future.status == "finished" else Failed(_reason(future.exception()))
        finally:
            client.cancel(list(futures))


def _reason(error: BaseException | None) -> str:
    if isinstance(error, Unfinished):
        return str(error)
    return f"{type(error).__name__}: {' '.join(str(error).split())}"  # of Dask: a worker that was killed again and again, ...


def _dask() -> Any:
    try:
        return import_module("distributed")
    except ImportError:
        raise NoCluster("a corpus needs Dask: pip install 'rosarch[cluster]'") from None


@contextmanager
def _client(distributed: Any, cluster: Cluster) -> Iterator[Any]:
    if cluster.address is not None:
        try:
            client = distributed.Client(cluster.address, timeout=CONNECTING)
        except (OSError, ValueError) as error:
            raise NoCluster(f"{cluster.address}: no scheduler answers ({error})") from None
        with client:
            yield client
        return
    quiet = {"silence_logs": logging.CRITICAL, "dashboard_address": None}
    with distributed.LocalCluster(n_workers=cluster.workers, threads_per_worker=1, **quiet) as local, distributed.Client(local) as client:
        yield client
