"""The report of trials of navigation: figures of each world, a table as text, and a plot.

Names of worlds and bodies, and reasons, may come from a file; here they are printable text, never markup.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Any, Final

from jauspy.campaigns import wilson
from jauspy.navigation_trials.results import Drive, TrialPlan, TrialResults
from jauspy.plots import ACCENT, BAD, GOOD, figure
from jauspy.printable import printable

LONGER: Final = 1.2
"""Ratio of the way driven to the shortest one above which it counts as too long."""
MAX_PLOTTED: Final = 24
"""Failures that the plot names; the table has all."""
MAX_REASON: Final = 200
"""Characters of a reason in the plot."""


@dataclass(frozen=True)
class Spread:
    """Median, 95th percentile and largest of some numbers."""

    median: float
    p95: float
    most: float


@dataclass(frozen=True)
class WorldReport:
    """The drives in one world; None where there is nothing to measure."""

    world: str
    known: bool
    """True for drives of robots that began with a map."""
    goals: int
    """Drives, without those whose goals could not be reached any more."""
    reached: int
    touched: int
    """Drives with a contact with something that is not the ground."""
    low: float
    high: float
    """The 95 % confidence interval of the rate of goals that were reached (Wilson)."""
    ratio: Spread | None
    """Way driven by the shortest one, of goals that were reached."""
    too_long: int
    """Ways of more than `LONGER` times the shortest one."""
    to_planned: Spread | None
    """Way driven by the one of the navigator's search on the true map, of goals that were reached."""
    longer_than_planned: int
    """Ways of more than `LONGER` times that one."""
    planning: float
    """Seconds of processor time of the longest search."""
    things: int
    """Things that were put into the way."""
    blocked: int
    """Drives that did not reach their goals because such a thing left no way on the true map."""
    new_way: Spread | None
    """Seconds until the robot was sent along another way: its own time, and the processor time of the search."""
    cpu: float
    """Seconds of processor time, with the physics."""


@dataclass(frozen=True)
class Report:
    """The report of all worlds."""

    worlds: tuple[WorldReport, ...]
    failures: tuple[Mapping[str, Any], ...]
    """What went wrong: world, group and number of the drive, start, goal, reason, and what was touched."""
    missing: int
    """Groups that were not driven."""

    @property
    def rate(self) -> float:
        """Fraction of the goals that were reached."""
        goals = sum(world.goals for world in self.worlds)
        return sum(world.reached for world in self.worlds) / goals if goals else 0.0

    def is_good(self, need: float) -> bool:
        """True if all was driven, at least this fraction of the goals was reached, and nothing was touched."""
        return not self.missing and self.rate >= need and not any(world.touched for world in self.worlds)

    def values(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {"rate": round(self.rate, 4), **asdict(self)}


def reported(results: TrialResults) -> Report:
    """The report of what was driven so far."""
    failed = [drive for drive in results.drives if (drive.counts and not drive.reached) or drive.contacts]
    return Report(
        tuple(_of_world(world, drives) for world, drives in _by_world(results) if drives),
        tuple(_failure(drive) for drive in failed),
        len(results.missing()),
    )


def _of_world(world: str, drives: Sequence[Drive]) -> WorldReport:
    reached = [drive for drive in drives if drive.reached]
    ratios = [drive.way / drive.shortest for drive in reached]
    to_planned = [drive.way / drive.planned for drive in reached if drive.planned]
    goals = sum(drive.counts for drive in drives)
    low, high = wilson(len(reached), goals)
    return WorldReport(
        world=world,
        known=drives[0].known,
        goals=goals,
        reached=len(reached),
        touched=sum(bool(drive.contacts) for drive in drives),
        low=round(low, 4),
        high=round(high, 4),
        ratio=_spread(ratios),
        too_long=sum(ratio > LONGER for ratio in ratios),
        to_planned=_spread(to_planned),
        longer_than_planned=sum(ratio > LONGER for ratio in to_planned),
        planning=max(drive.planning for drive in drives),
        things=sum(bool(drive.thing) for drive in drives),
        blocked=len(drives) - goals,
        new_way=_spread([time for drive in drives if (time := new_way(drive)) is not None]),
        cpu=round(sum(drive.cpu for drive in drives), 1),
    )


def new_way(drive: Drive) -> float | None:
    """Seconds from when a thing was put into the way until the robot was sent along another one; None if it was not.

    The robot's own time, which stands still during the search, and the processor time of that.
    """
    return None if drive.new_way is None else drive.new_way + (drive.new_way_planning or 0.0)


def _failure(drive: Drive) -> dict[str, Any]:
    found = asdict(drive)
    return {name: found[name] for name in ("world", "group", "number", "start", "goal", "error", "contacts")}


def _spread(numbers: Sequence[float]) -> Spread | None:
    if not numbers:
        return None
    ordered = sorted(numbers)
    p95 = ordered[max(0, math.ceil(0.95 * len(ordered)) - 1)]
    return Spread(round(median(ordered), 3), round(p95, 3), round(ordered[-1], 3))


def _by_world(results: TrialResults) -> Iterator[tuple[str, list[Drive]]]:
    """The drives in each world; apart from them those that began with a map."""
    for world, known in _rows(results.plan):
        yield world, [drive for drive in results.drives if drive.world == world and drive.known is known]


def _rows(plan: TrialPlan) -> list[tuple[str, bool]]:
    """The worlds, and whether the robots began with a map there."""
    return [(world, known) for world in plan.worlds for known in (False, True)[: 1 + plan.again]]


def _label(world: str, *, known: bool) -> str:
    return f"{printable(world)}, known" if known else printable(world)


ROWS: Final = (
    *("goals", "reached", "reached, 95 % confidence, %", "touched something"),
    *("way / shortest, median", "way / shortest, 95 %", "way / shortest, most", f"way / shortest > {LONGER}"),
    *(
        "way / planned on the true map, median",
        "way / planned, 95 %",
        "way / planned, most",
        f"way / planned > {LONGER}",
    ),
    *("longest search, CPU s", "things put into the way", "no way left"),
    *("new way after, s, median", "new way after, s, 95 %", "new way after, s, most"),
)
"""Figures of a world, as in the table."""


def lines(report: Report) -> list[str]:
    """A table with a column for each world, and lines about drives that failed or touched something."""
    columns = [("", *ROWS), *((_label(world.world, known=world.known), *_figures(world)) for world in report.worlds)]
    widths = [max(map(len, column)) for column in columns]
    found = [
        "  ".join(cell.rjust(width) if number else cell.ljust(width) for number, (cell, width) in enumerate(cells))
        for cells in (list(zip(row, widths, strict=True)) for row in zip(*columns, strict=True))
    ]
    found += [failure_text(failure) for failure in report.failures]
    if report.missing:
        found.append(f"not driven: {report.missing} groups of goals")
    return found


def _figures(world: WorldReport) -> tuple[str, ...]:
    return (
        str(world.goals),
        str(world.reached),
        f"{100.0 * world.low:.0f} to {100.0 * world.high:.0f}",
        str(world.touched),
        *_spread_texts(world.ratio),
        str(world.too_long),
        *_spread_texts(world.to_planned),
        str(world.longer_than_planned),
        f"{world.planning:.2f}",
        str(world.things),
        str(world.blocked),
        *_spread_texts(world.new_way),
    )


def _spread_texts(spread: Spread | None) -> tuple[str, str, str]:
    return ("-", "-", "-") if spread is None else (f"{spread.median:.2f}", f"{spread.p95:.2f}", f"{spread.most:.2f}")


def failure_text(failure: Mapping[str, Any]) -> str:
    """A drive that failed or touched something, as a line."""
    start, goal = (", ".join(f"{value:g}" for value in failure[name]) for name in ("start", "goal"))
    touched = [f"touched {name} in {count} samples" for name, count in failure["contacts"].items()]
    reasons = "; ".join([*([failure["error"]] if failure["error"] else []), *touched])
    place = f"{failure['world']}, group {failure['group']}, goal {failure['number']}"
    return printable(f"{place}: ({start}) to ({goal}): {reasons}")


def plot(results: TrialResults, report: Report, path: Path) -> None:
    """Write a plot: ways by the shortest ones, times to another way, contacts, and the reasons of failures."""
    names = [failure_text(failure) for failure in report.failures]
    shown = [name if len(name) <= MAX_REASON else f"{name[:MAX_REASON]}..." for name in names[:MAX_PLOTTED]]
    if len(names) > MAX_PLOTTED:
        shown.append(f"and {len(names) - MAX_PLOTTED} more")
    with figure(path, columns=3, size=(14.0, 4.5 + 0.18 * len(shown))) as (ways, times, touches):
        _plot_ways(ways, results)
        _plot_times(times, results)
        _plot_touches(touches, results)
        goals, reached = (sum(getattr(world, name) for world in report.worlds) for name in ("goals", "reached"))
        text = "\n".join([f"{reached} of {goals} goals reached", *shown])
        ways.figure.suptitle(text, x=0.01, ha="left", fontsize=9, parse_math=False)


def _plot_ways(axes: Any, results: TrialResults) -> None:
    for number, (_, drives) in enumerate(_by_world(results)):
        for reached, colour in ((True, GOOD), (False, BAD)):
            rows = [drive for drive in drives if drive.reached is reached]
            axes.scatter(
                [number + _beside(index, len(rows)) for index in range(len(rows))],
                [drive.way / drive.shortest for drive in rows],
                s=12,
                color=colour,
                label=("reached" if reached else "not reached") if number == 0 else None,
            )
    axes.axhline(LONGER, color=ACCENT, linewidth=1.0)
    axes.set_ylabel("way driven / shortest")
    axes.legend(loc="best")
    _name_worlds(axes, results)


def _plot_times(axes: Any, results: TrialResults) -> None:
    found = [time for drive in results.drives if (time := new_way(drive)) is not None]
    if found:
        axes.hist(found, bins=20, color=ACCENT)
    axes.set_xlabel("time to another way after a thing was put there, s")
    axes.set_ylabel("drives")


def _plot_touches(axes: Any, results: TrialResults) -> None:
    counts = Counter(
        (number, name)
        for number, (_, drives) in enumerate(_by_world(results))
        for drive in drives
        for name in drive.contacts
    )
    for number, (_, drives) in enumerate(_by_world(results)):
        axes.bar(number, sum(bool(drive.contacts) for drive in drives), color=BAD)
        names = [f"{name}: {count}" for (place, name), count in sorted(counts.items()) if place == number][:5]
        if names:
            axes.text(number, 0.0, printable("; ".join(names))[:60], rotation=90, va="bottom", parse_math=False)
    axes.set_ylabel("drives that touched something")
    axes.yaxis.get_major_locator().set_params(integer=True)
    _name_worlds(axes, results)


def _name_worlds(axes: Any, results: TrialResults) -> None:
    names = [_label(world, known=known)[-30:] for world, known in _rows(results.plan)]
    axes.set_xticks(range(len(names)), names, parse_math=False)
    axes.set_xlim(-0.6, len(names) - 0.4)


def _beside(index: int, count: int) -> float:
    """Where a point is drawn beside the middle of its column."""
    return 0.6 * (index / (count - 1) - 0.5) if count > 1 else 0.0
