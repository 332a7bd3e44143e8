"""Parts of a campaign (fuzzing, trials) on a Dask cluster, in order. Another worker does again what a lost one did."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from typing import Any, Final, TypeVar

from jauspy.errors import ConfigError

_Part = TypeVar("_Part")
_Result = TypeVar("_Result")
WAITING_PER_THREAD: Final = 4
"""Parts that wait for each thread of the cluster."""


def spread(address: str, work: Callable[[_Part], _Result], parts: Iterable[_Part]) -> Iterator[_Result]:
    """Yield the results in the order of the parts; `address` is that of a Dask scheduler, or `local`.

    `local` starts workers on this machine, one for each processor. `work` must give the same result when it is done
    again. Raises `ConfigError` without Dask or a scheduler, and when a part ends every worker that tries it.
    """
    try:
        distributed = import_module("distributed")
    except ImportError:
        raise ConfigError("--cluster needs Dask's `distributed`; run: pip install 'jauspy[cell-cluster]'") from None
    if address == "local":
        with distributed.LocalCluster(threads_per_worker=1, dashboard_address=None) as cluster:
            yield from _in_order(distributed, cluster.scheduler_address, work, parts)
    else:
        yield from _in_order(distributed, address, work, parts)


def _in_order(
    distributed: Any, address: str, work: Callable[[_Part], _Result], parts: Iterable[_Part]
) -> Iterator[_Result]:
    try:
        client = distributed.Client(address, timeout="10s")
    except (OSError, ValueError) as error:
        raise ConfigError(f"no Dask scheduler answers at {address!r}: {error}") from error
    with client:
        waiting: deque[Any] = deque()
        limit = WAITING_PER_THREAD * max(1, sum(client.nthreads().values()))
        for part in parts:
            waiting.append(client.submit(work, part, pure=False))
            if len(waiting) >= limit:
                yield _result(distributed, waiting.popleft())
        while waiting:
            yield _result(distributed, waiting.popleft())


def _result(distributed: Any, future: Any) -> Any:
    try:
        return future.result()
    except distributed.KilledWorker as error:
        raise ConfigError(f"a part of the campaign ended every worker that tried it: {error}") from error
