"""Many seeded runs of a task, in processes of this machine or on a Dask cluster, and what they say together."""

from __future__ import annotations

import asyncio
import json
import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from statistics import fmean, median
from typing import Final

from pydantic import TypeAdapter

from jauspy import campaigns
from jauspy.campaigns import run_parts, wilson, write_whole
from jauspy.cell.measurements import Measured
from jauspy.cell.session import Disturbances
from jauspy.cell.tasks import run_one
from jauspy.errors import ConfigError


def run_seed(task: str, disturbances: Disturbances | None, seed: int) -> Measured:
    """Run a task once, in the calling process."""
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    return asyncio.run(run_one(task, seed, disturbances))


def run_trials(
    task: str,
    seeds: Iterable[int],
    disturbances: Disturbances | None = None,
    *,
    jobs: int | None = None,
    cluster: str | None = None,
) -> Iterator[Measured]:
    """Yield the results as they come, in any order; `cluster` is as in `jauspy.campaigns.run_parts`."""
    yield from run_parts(partial(run_seed, task, disturbances), list(seeds), jobs=jobs, cluster=cluster)


@dataclass(frozen=True, slots=True)
class Summary:
    """Results of many runs."""

    task: str
    runs: int
    successes: int
    low: float
    """Lower end of the 95 % confidence interval of the success rate (Wilson)."""
    high: float
    duration: float
    """Median of the successful runs, in seconds of the cell's time."""
    longest: float
    speed: float
    """Seconds of the cell's time for a second of CPU time, of all runs together."""
    cpu: float
    """Mean CPU time of a run, in seconds."""
    failures: tuple[tuple[int, str], ...]
    """Seed and reason of each failed run."""

    @property
    def rate(self) -> float:
        """Fraction of successful runs."""
        return self.successes / self.runs if self.runs else 0.0


def summarised(results: Iterable[Measured]) -> Summary:
    """The summary of the runs of one task."""
    found = sorted(results, key=lambda run: run.seed)
    good = [run for run in found if run.success]
    low, high = wilson(len(good), len(found))
    cpu = sum(run.cpu for run in found)
    return Summary(
        task=found[0].task if found else "",
        runs=len(found),
        successes=len(good),
        low=low,
        high=high,
        duration=median(run.duration for run in good) if good else math.nan,
        longest=max((run.duration for run in good), default=math.nan),
        speed=sum(run.duration for run in found) / cpu if cpu else math.nan,
        cpu=cpu / len(found) if found else math.nan,
        failures=tuple((run.seed, run.failure) for run in found if not run.success),
    )


def mean_of(results: Iterable[Measured], name: str) -> float:
    """The mean of a figure over the runs that have it."""
    found = [run.values[name] for run in results if name in run.values]
    return fmean(found) if found else math.nan


_RESULTS: Final = TypeAdapter(list[Measured])


def write_results(path: Path, results: Iterable[Measured]) -> None:
    """Write the file that `read_results` reads; one that is interrupted leaves the file as it was."""
    write_whole(path, json.dumps([asdict(run) for run in results], indent=1))


def read_results(path: Path) -> list[Measured]:
    """The results in a file that `jauspy cell trials` wrote, by seed. Raises `ConfigError`, which names the file."""
    rows = campaigns.read_results(path, _RESULTS, "jauspy cell trials")
    if not rows:
        raise ConfigError(f"{path}: has no results; run `jauspy cell trials` again")
    return sorted(rows, key=lambda run: run.seed)
