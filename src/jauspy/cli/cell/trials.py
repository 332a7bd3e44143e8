"""`jauspy cell trials`: many seeded runs of a task."""

from __future__ import annotations

import json as json_module
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import OUTPUT, Exact, Jobs, Out, Seeds, check_extra

if TYPE_CHECKING:
    from jauspy.cell.measured import Measured


def with_progress(what: str, total: int, results: Iterable[Measured]) -> Iterator[Measured]:
    """Pass results on, and show a progress bar with the number of failures."""
    from rich.progress import Progress

    failed = 0
    with Progress(console=console.stderr()) as progress:
        bar = progress.add_task(what, total=total)
        for each in results:
            failed += not each.success
            progress.update(bar, advance=1, description=f"{what}, {failed} failed" if failed else what)
            yield each


def trials(
    *,
    task: Annotated[str, typer.Argument(metavar="TASK", help="What to run: assemble, lift, step, car.")] = "assemble",
    seeds: Seeds = 100,
    first: Annotated[int, typer.Option("--first", min=0, metavar="N", help="The first seed.")] = 0,
    jobs: Jobs = None,
    cluster: Annotated[
        str | None,
        typer.Option(
            "--cluster", metavar="ADDRESS", help="Run on the cluster of this Dask scheduler, tcp://HOST:PORT."
        ),
    ] = None,
    exact: Exact = False,
    need: Annotated[
        float, typer.Option("--need", min=0.0, max=1.0, help="Exit status 1 when the rate of success is below this.")
    ] = 0.95,
    out: Out = OUTPUT,
) -> None:
    """Run a task with many seeds, and report how often it succeeds.

    Parts' poses are off by up to 10 mm and 5 degrees, 2 % of the grasps fail by themselves, and the part sensor is
    noisy. Writes DIR/trials-TASK.json and a plot, DIR/trials-TASK.svg.
    """
    check_extra()
    from jauspy.cell.plots import plot_trials
    from jauspy.cell.session import NONE
    from jauspy.cell.tasks import TASKS
    from jauspy.cell.trials import run_trials, summarised
    from jauspy.cli.cell.tables import trials_table

    if task not in TASKS:
        raise typer.BadParameter(f"{task!r} is no task; there are: {', '.join(TASKS)}", param_hint="TASK")
    found: list[Measured] = []
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"trials-{task}.json"
    disturbances = NONE if exact else None
    results = run_trials(task, range(first, first + seeds), disturbances, jobs=jobs, cluster=cluster)
    for each in with_progress(task, seeds, results):
        found.append(each)
        path.write_text(json_module.dumps([asdict(every) for every in found], indent=1))
    found.sort(key=lambda each: each.seed)
    summary = summarised(found)
    path.write_text(json_module.dumps([asdict(each) for each in found], indent=1))
    plot_trials(found, summary, out / f"trials-{task}.svg")
    console.stdout(140).print(trials_table(summary, found))
    if summary.rate < need:
        raise typer.Exit(1)
