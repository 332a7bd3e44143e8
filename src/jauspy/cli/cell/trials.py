"""`jauspy cell trials` and `kitting`: many seeded runs of a task, and of orders in the style of ARIAC 2018."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import OUTPUT, Exact, Jobs, Out, Seeds, check_extra
from jauspy.cli.options import ClusterOption, Json
from jauspy.cli.progress import with_progress

if TYPE_CHECKING:
    from jauspy.cell.measurements import Measured


def runs_with_progress(what: str, total: int, results: Iterable[Measured]) -> Iterator[Measured]:
    """Pass results on, and show a progress bar with the number of failures."""
    return with_progress(what, total, results, lambda run: not run.success)


def trials(
    *,
    task: Annotated[
        str, typer.Argument(metavar="TASK", help="What to run: assemble, lift, step, take-apart, car, demo, ariac.")
    ] = "assemble",
    seeds: Seeds = 100,
    first: Annotated[int, typer.Option("--first", min=0, metavar="N", help="The first seed.")] = 0,
    jobs: Jobs = None,
    cluster: ClusterOption = None,
    resume: Annotated[
        bool,
        typer.Option("--resume", help="Keep the results in DIR of an interrupted run with the same options."),
    ] = False,
    exact: Exact = False,
    scatter: Annotated[
        bool, typer.Option("--scatter", help="Have the parts lie anywhere in their bins, turned at will.")
    ] = False,
    need: Annotated[
        float, typer.Option("--need", min=0.0, max=1.0, help="Exit status 1 when the rate of success is below this.")
    ] = 0.95,
    out: Out = OUTPUT,
    as_json: Json = False,
) -> None:
    """Run a task with many seeds, and report how often it succeeds.

    Parts' poses are off by up to 10 mm and 5 degrees, 2 % of the grasps fail at random, and the part sensor is
    noisy. Writes DIR/trials-TASK.json and a plot, DIR/trials-TASK.svg.

    Examples:
      jauspy cell trials assemble --seeds 100 --jobs 4
      jauspy cell trials demo --seeds 100 --resume
    """
    check_extra()
    from jauspy.cell.report import plot_trials
    from jauspy.cell.session import UNDISTURBED, Disturbances
    from jauspy.cell.tasks import NAMES
    from jauspy.cell.trials import read_results, run_trials, summarised, write_results
    from jauspy.cli.cell.ariac import summary_tables
    from jauspy.cli.cell.tables import trials_table

    if task not in NAMES:
        raise typer.BadParameter(f"{task!r} is not a task; the tasks are: {', '.join(NAMES)}", param_hint="TASK")
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"trials-{task}.json"
    found = read_results(path) if resume and path.exists() else []
    found = [run for run in found if first <= run.seed < first + seeds]
    wanted = sorted(set(range(first, first + seeds)) - {run.seed for run in found})
    disturbances = replace(UNDISTURBED if exact else Disturbances(), scatter=scatter)
    results = run_trials(task, wanted, disturbances, jobs=jobs, cluster=cluster)
    for run in runs_with_progress(task, len(wanted), results):
        found.append(run)
        write_results(path, found)
    found.sort(key=lambda run: run.seed)
    summary = summarised(found)
    write_results(path, found)
    plot_trials(found, summary, out / f"trials-{task}.svg")
    if as_json:
        console.print_json(asdict(summary))
    else:
        console.stdout(140).print(trials_table(summary, found))
        if task == "ariac":
            for table in summary_tables(found):
                console.stdout(140).print(table)
    if summary.rate < need:
        raise typer.Exit(1)


WAYS = {"kitting": "UR10 alone", "kitting-arm": "UR10 with a modular arm"}


def kitting(*, seeds: Seeds = 20, jobs: Jobs = None, out: Out = OUTPUT, as_json: Json = False) -> None:
    """Fill kitting orders with the UR10 alone and with an arm that it built, scored as in ARIAC 2018.

    Each order has two products from the bins and two boxes from the belt, at drawn poses on a tray. Prints score and
    time of both ways, and the number of orders from which building the arm saves time.

    Example:
      jauspy cell kitting --seeds 20 --jobs 4
    """
    check_extra()
    from jauspy.cell.trials import run_trials, write_results

    out.mkdir(parents=True, exist_ok=True)
    results: dict[str, list[Measured]] = {}
    for task, way in WAYS.items():
        results[task] = []
        for run in runs_with_progress(way, seeds, run_trials(task, range(seeds), jobs=jobs)):
            results[task].append(run)
            write_results(out / f"{task}.json", results[task])
    if as_json:
        console.print_json({task: [asdict(run) for run in found] for task, found in results.items()})
    else:
        _print_orders(seeds, results)
    if not all(run.success for found in results.values() for run in found):
        raise typer.Exit(1)


def _print_orders(seeds: int, results: dict[str, list[Measured]]) -> None:
    from rich.table import Table

    from jauspy.cell.trials import mean_of

    table = Table(title=f"{seeds} orders", title_justify="left")
    for heading in ("way", "runs", "score", "of", "time of an order, s", "building, s", "largest error, mm"):
        table.add_column(heading)
    for task, way in WAYS.items():
        found = [run for run in results[task] if run.success]
        figures = [f"{mean_of(found, name):.2f}" for name in ("score", "most_points", "order_time", "build_time")]
        table.add_row(way, f"{len(found)} of {seeds}", *figures, f"{1000 * mean_of(found, 'largest_error'):.1f}")
    console.stdout(140).print(table)
    console.print_lines(break_even(results["kitting"], results["kitting-arm"]))


def break_even(alone: list[Measured], both: list[Measured]) -> str:
    """A sentence with the number of orders from which building the arm saves time."""
    from jauspy.cell.trials import mean_of

    saved = mean_of(alone, "order_time") - mean_of(both, "order_time")
    building = mean_of(both, "build_time")
    if not saved > 0.0:
        return f"The arm does not pay: an order takes {-saved:.1f} s longer with it."
    orders = math.ceil(building / saved)
    return (
        f"The arm saves {saved:.1f} s an order and takes {building:.1f} s to build: worth it from {orders} orders on."
    )
