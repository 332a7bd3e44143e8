"""Results of many trials: by trial with efficiency factors and trial scores, and by challenge."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from statistics import fmean

from jauspy.cell.ariac.scoring import efficiency, trial_score
from jauspy.cell.measurements import Measured

ORDER_TIME = "order_time "
SCORE = "score "
"""Beginnings of the names of an order's figures."""


@dataclass(frozen=True, slots=True)
class TrialSummary:
    """Runs of one trial; means are over all of them."""

    trial: str
    challenges: tuple[str, ...]
    runs: int
    successes: int
    score: float
    """Mean of the completion scores."""
    most: float
    """Points that can be had."""
    duration: float
    """Mean seconds until the last order was submitted, or the trial ended."""
    trial_score: float
    """Mean of the trial scores: each order's completion score times its efficiency among these runs."""


def by_trial(results: Iterable[Measured]) -> list[TrialSummary]:
    """A summary of the runs of each trial, in the order of their names."""
    groups: defaultdict[str, list[Measured]] = defaultdict(list)
    for run in results:
        groups[run.rows[0]["trial"]].append(run)
    found = []
    for name, runs in sorted(groups.items()):
        durations: defaultdict[str, list[float]] = defaultdict(list)
        for run in runs:
            for figure, value in run.values.items():
                if figure.startswith(ORDER_TIME):
                    durations[figure.removeprefix(ORDER_TIME)].append(value)
        scores = [
            trial_score(
                (1.0, efficiency(run.values[f"{ORDER_TIME}{order}"], all_durations), run.values[f"{SCORE}{order}"])
                for order, all_durations in durations.items()
                if f"{ORDER_TIME}{order}" in run.values
            )
            for run in runs
        ]
        found.append(
            TrialSummary(
                trial=name,
                challenges=tuple(runs[0].rows[0]["challenges"]),
                runs=len(runs),
                successes=sum(run.success for run in runs),
                score=fmean(run.values["score"] for run in runs),
                most=max(run.values["most_points"] for run in runs),
                duration=fmean(run.duration for run in runs),
                trial_score=fmean(scores),
            )
        )
    return found


def by_challenge(results: Iterable[Measured]) -> dict[str, tuple[int, int]]:
    """Runs and successes by challenge; `none` has those of trials without any."""
    found: dict[str, tuple[int, int]] = {}
    for run in results:
        for challenge in run.rows[0]["challenges"] or ["none"]:
            runs, successes = found.get(challenge, (0, 0))
            found[challenge] = runs + 1, successes + run.success
    return dict(sorted(found.items()))
