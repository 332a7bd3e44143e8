"""Campaigns of many runs that do not depend on each other: who does them, the file of results, and what a rate says."""

from __future__ import annotations

import math
import multiprocessing
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.connection import wait
from pathlib import Path
from typing import Final, TypeVar

from pydantic import TypeAdapter, ValidationError

from jauspy.cluster import spread
from jauspy.errors import ConfigError
from jauspy.user_files import read_file

_Part = TypeVar("_Part")
_Result = TypeVar("_Result")

MAX_RESULTS: Final = 256 << 20
"""Bytes of a file of results."""


def run_parts(
    work: Callable[[_Part], _Result],
    parts: Sequence[_Part],
    *,
    jobs: int | None = None,
    cluster: str | None = None,
) -> Iterator[_Result]:
    """Yield the results as they come, in any order: by `jobs` processes of this machine, or on a Dask cluster.

    None is a process for each processor; one part, or one job, is done in the calling process. `cluster` is as in
    `jauspy.cluster.spread`. `work` is a function of a module, perhaps a `partial` of one. Raises `ConfigError` when a
    process is killed.
    """
    if cluster is not None:
        yield from spread(cluster, work, parts)
    elif jobs == 1 or len(parts) <= 1:
        yield from map(work, parts)
    else:
        yield from _in_processes(work, parts, jobs or os.cpu_count())


def _in_processes(work: Callable[[_Part], _Result], parts: Sequence[_Part], count: int | None) -> Iterator[_Result]:
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(count, mp_context=multiprocessing.get_context("spawn"), initializer=_end_with_parent)
    unfinished = True
    try:
        futures = [pool.submit(work, part) for part in parts]
        for future in as_completed(futures):
            yield future.result()
        unfinished = False
    except BrokenProcessPool:
        raise ConfigError(
            "a process of the campaign was killed, perhaps for want of memory; use --resume, and fewer --jobs"
        ) from None
    finally:
        if unfinished:  # after an error, or Ctrl-C: nobody wants the results of the parts that were begun
            for process in set(multiprocessing.active_children()) - others:
                process.terminate()
        pool.shutdown(cancel_futures=True)


def _end_with_parent() -> None:
    """End this process when its parent has ended, however that was."""
    threading.Thread(target=_wait_for_parent, name="parent-watch", daemon=True).start()


def _wait_for_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    wait([parent.sentinel])
    os._exit(1)


def write_whole(path: Path, text: str) -> None:
    """Write a file; when that is interrupted, the file stays as it was."""
    unfinished = path.with_name(f"{path.name}.unfinished")
    unfinished.write_text(text)
    unfinished.replace(path)


def read_results(path: Path, results: TypeAdapter[_Result], verb: str) -> _Result:
    """The results in a file that a verb, as in `jauspy cell trials`, wrote. Raises `ConfigError`, which names it."""
    try:
        return results.validate_json(read_file(path, MAX_RESULTS))
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        place = ".".join(map(str, first["loc"])) or "the whole"
        raise ConfigError(f"{path}: is no file of results of `{verb}`: {place}: {first['msg']}") from None


def wilson(successes: int, runs: int) -> tuple[float, float]:
    """The 95 % confidence interval of a rate: E. B. Wilson, 1927."""
    if not runs:
        return 0.0, 1.0
    z, rate = 1.959964, successes / runs
    middle = (rate + z * z / (2 * runs)) / (1 + z * z / runs)
    half = z * math.sqrt(rate * (1 - rate) / runs + z * z / (4 * runs * runs)) / (1 + z * z / runs)
    return max(0.0, middle - half), min(1.0, middle + half)
