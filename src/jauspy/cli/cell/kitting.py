"""`jauspy cell kitting`: orders in the style of ARIAC 2018, by the UR10 alone and with an arm that it built."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from typing import TYPE_CHECKING

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import OUTPUT, Jobs, Out, Seeds, check_extra
from jauspy.cli.cell.trials import with_progress

if TYPE_CHECKING:
    from jauspy.cell.measured import Measured

WAYS = {"kitting": "UR10 alone", "kitting-arm": "UR10 with a modular arm"}


def kitting(*, seeds: Seeds = 20, jobs: Jobs = None, out: Out = OUTPUT) -> None:
    """Fill kitting orders with the UR10 alone and with an arm that it built, scored as in ARIAC 2018.

    Each order has two products from the bins and two boxes from the belt, at drawn poses on a tray. Prints score and
    time of both ways, and from how many orders on building the arm is worth its time.
    """
    check_extra()
    from rich.table import Table

    from jauspy.cell.trials import mean_of, run_trials

    out.mkdir(parents=True, exist_ok=True)
    results: dict[str, list[Measured]] = {}
    for task, way in WAYS.items():
        results[task] = []
        for each in with_progress(way, seeds, run_trials(task, range(seeds), jobs=jobs)):
            results[task].append(each)
            (out / f"{task}.json").write_text(json.dumps([asdict(every) for every in results[task]], indent=1))
    table = Table(title=f"{seeds} orders", title_justify="left")
    for heading in ("way", "runs", "score", "of", "time of an order, s", "building, s", "largest error, mm"):
        table.add_column(heading)
    for task, way in WAYS.items():
        found = [each for each in results[task] if each.success]
        figures = [f"{mean_of(found, name):.2f}" for name in ("score", "most_points", "order_time", "build_time")]
        table.add_row(way, f"{len(found)} of {seeds}", *figures, f"{1000 * mean_of(found, 'largest_error'):.1f}")
    console.stdout(140).print(table)
    console.print_lines(break_even(results["kitting"], results["kitting-arm"]))
    if not all(each.success for found in results.values() for each in found):
        raise typer.Exit(1)


def break_even(alone: list[Measured], both: list[Measured]) -> str:
    """From how many orders on building the arm saves time, in a sentence."""
    from jauspy.cell.trials import mean_of

    saved = mean_of(alone, "order_time") - mean_of(both, "order_time")
    building = mean_of(both, "build_time")
    if not saved > 0.0:
        return f"The arm does not pay: an order takes {-saved:.1f} s longer with it."
    orders = math.ceil(building / saved)
    return (
        f"The arm saves {saved:.1f} s an order and takes {building:.1f} s to build: worth it from {orders} orders on."
    )
