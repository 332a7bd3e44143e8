"""`jauspy cell all`: everything once, with films, plots and a page of results."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import OUTPUT, Jobs, Out, check_extra
from jauspy.cli.cell.trials import WAYS, break_even, runs_with_progress
from jauspy.cli.processes import run

if TYPE_CHECKING:
    from jauspy.cell.measurements import Measured
    from jauspy.cell.report import Promise, Section

FILMED: Final = {
    "assemble": "The UR10 builds the arm with five joints",
    "lift": "The arm takes a box off the moving conveyor and throws it",
    "step": "The arm steps from platform to platform and back",
    "take-apart": "The UR10 takes the arm apart, and puts its parts back into their bins",
    "car": "The UR10 builds the car, puts it and the arm on the conveyor, and it drives off",
}
STORIES: Final = "trials-demo.json"
"""File in the directory of results with many runs of the whole story, if there is one."""


def all_tasks(
    *,
    seeds: Annotated[
        int, typer.Option("--seeds", min=1, metavar="N", help="Runs of the assembly, and half as many of the lift.")
    ] = 100,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="N", help="Seed of the filmed runs.")] = 7,
    jobs: Jobs = None,
    films: Annotated[bool, typer.Option("--films/--no-films", help="Film each task. Needs the extra 'video'.")] = True,
    stories: Annotated[
        Path | None,
        typer.Option(
            "--stories", metavar="FILE", help="Results of `jauspy cell trials demo`. Default: those in DIR, if any."
        ),
    ] = None,
    out: Out = OUTPUT,
) -> None:
    """Run everything once; write films, plots and a page of results.

    The page has all tables, plots and films inside and opens without a network. Its figures of contacts, attachments
    and joints are those that the simulation measures at each step. Exit status 0 only if every promised figure was
    reached.

    Example:
      jauspy cell all --output cell_out
    """
    check_extra()
    from jauspy.cell.physics_tables import energy_table
    from jauspy.cell.report import Section, page

    out.mkdir(parents=True, exist_ok=True)
    found: list[tuple[list[Promise], Section]] = []
    told = stories or (out / STORIES if (out / STORIES).exists() else None)
    if told is not None:
        found.append(_stories(told, out))
    filmed: list[Measured] = []
    for task, title in FILMED.items():
        result = _filmed(task, seed, out / f"{task}.mp4" if films else None)
        (out / f"{task}.json").write_text(json.dumps(asdict(result), indent=1))
        found.append(_task(result, title, out / f"{task}.mp4"))
        filmed.append(result)
    if (energy := energy_table(filmed)) is not None:
        text = "What the modules of the cell drew, and what their batteries have left."
        found.append(([], Section("Energy", text, [energy])))
    for task, count, need in (("assemble", seeds, 0.95), ("lift", max(1, seeds // 2), 0.5)):
        found.append(_trials(task, count, need, jobs, out))
    found += [_swing(seed, out), _accuracy(seed, out), _kitting(out, min(20, seeds), jobs)]
    promises = [promise for some, _ in found for promise in some]
    lead = (
        "Everything below was measured by `jauspy cell all`. What is called measured by the simulation comes from its "
        "physics at each step, not from reports of tasks."
    )
    text = page("The modular factory cell", lead, promises, [section for _, section in found])
    (out / "index.html").write_text(text, encoding="utf-8")
    for item in promises:
        mark = "kept    " if item.kept else "NOT KEPT"
        console.print_lines(f"{mark}  {item.what}: {item.measured} (promised: {item.wanted})")
    console.print_lines(str(out / "index.html"))
    if not all(item.kept for item in promises):
        raise typer.Exit(1)


def _filmed(task: str, seed: int, film: Path | None) -> Measured:
    from jauspy.cell.measurements import Measured
    from jauspy.cell.tasks import run_one

    console.note(f"{task}, seed {seed}")
    found = run(run_one(task, seed, film=film)) or Measured(seed, task, failure="stopped")
    if found.film_problem:
        console.error(found.film_problem)
    return found


def _task(found: Measured, title: str, film: Path) -> tuple[list[Promise], Section]:
    """A task that was filmed, with the figures of the simulation."""
    from jauspy.cell.physics_tables import gentle, physics_tables

    promises, section = _once(found, title, film=film)
    if found.physics is not None:
        promises += gentle(found)
        section.tables += physics_tables(found.physics)
    return promises, section


def _once(
    found: Measured, title: str, wanted: str = "it succeeds", figures: str = "", *, film: Path | None = None
) -> tuple[list[Promise], Section]:
    """The result of one run of a task; `figures` are those with a required value, or else its duration."""
    from jauspy.cell.measurements import figure_text
    from jauspy.cell.report import Promise, Section, Table

    measured = found.failure or figures or f"done in {found.duration:.1f} s of the cell's time"
    incomplete = f" Film: {found.film_problem}." if found.film_problem else ""
    rows: list[Sequence[str]] = [("figure", "value")]
    rows += [(name.replace("_", " "), figure_text(name, value)) for name, value in found.values.items()]
    if found.rows and "slot" in found.rows[0]:
        rows += [
            (f"{row['slot']}: {row['part']}", f"{row['fetch_time'] + row['join_time']:.1f} s to fetch and to join")
            for row in found.rows
        ]
    tables = [Table("Reported by the task, and measured by the judge", rows)]
    section = Section(title, f"Seed {found.seed}: {measured}.{incomplete}", tables, film=film)
    return [Promise(title, wanted, measured, found.success)], section


def _trials(task: str, count: int, need: float, jobs: int | None, out: Path) -> tuple[list[Promise], Section]:
    from jauspy.cell.trials import run_trials, write_results

    console.note(f"{count} runs of {task}")
    results = run_trials(task, range(count), jobs=jobs)
    found = sorted(runs_with_progress(task, count, results), key=lambda run: run.seed)
    write_results(out / f"trials-{task}.json", found)
    return _many(found, f"{count} runs of {task}", need, out / f"trials-{task}.svg")


def _many(found: list[Measured], title: str, need: float, plot: Path) -> tuple[list[Promise], Section]:
    """Many runs of one task: how often it succeeds, and the figures of the simulation by seed."""
    from jauspy.cell.physics_tables import trials_tables
    from jauspy.cell.report import Plot, Promise, Section, Table, plot_trials
    from jauspy.cell.trials import summarised

    summary = summarised(found)
    plot_trials(found, summary, plot)
    measured = (
        f"{summary.successes} of {summary.runs} (95 %: {100 * summary.low:.0f} to {100 * summary.high:.0f} %), "
        f"median {summary.duration:.1f} s"
    )
    promise = Promise(title, f"at least {100 * need:.0f} %", measured, summary.rate >= need)
    section = Section(title, f"{measured}.", plots=[Plot(plot, "Time of each run, and errors or times of all.")])
    if summary.failures:
        rows: list[Sequence[str]] = [("seed", "reason of the failure")]
        section.tables.append(Table("Failures", [*rows, *((str(seed), why) for seed, why in summary.failures)]))
    section.tables += trials_tables(found)
    return [promise], section


def _stories(path: Path, out: Path) -> tuple[list[Promise], Section]:
    """The whole story, many times, from a file of results."""
    from jauspy.cell.trials import read_results

    found = read_results(path)
    promises, section = _many(found, f"{len(found)} whole stories", 0.9, out / "trials-demo.svg")
    section.text += f" Read from {path.name}, which `jauspy cell trials demo` wrote."
    return promises, section


def _swing(seed: int, out: Path) -> tuple[list[Promise], Section]:
    from jauspy.cell import swing
    from jauspy.cell.measurements import Measured
    from jauspy.cell.report import Plot

    async def measured() -> Measured:
        comparison = await swing.compare(seed, console.note)
        swing.plot_swing(comparison, out / "swing.svg")
        return comparison.measured(seed)

    found = run(measured()) or Measured(seed, "swing", failure="stopped")
    figures = (
        "{settled_sooner:.1f} times sooner ({settled_model:.2f} s, not {settled_pid:.2f} s), {overshoot_ratio:.2f} of "
        "the overshoot"
    )
    promises, section = _once(
        found,
        "The swing after the release, with the model of the arm instead of a PID controller for each joint",
        "at rest at least 5 times sooner, at most a third of the overshoot",
        _filled(figures, found),
    )
    section.plots.append(Plot(out / "swing.svg", "Angular velocity of the last module after the release."))
    return promises, section


def _accuracy(seed: int, out: Path) -> tuple[list[Promise], Section]:
    from jauspy.cell.iso9283 import measurement, page
    from jauspy.cell.measurements import Measured
    from jauspy.cell.report import Plot

    async def measured() -> Measured:
        report = await measurement.measure(seed, report=console.note)
        page.write_report(report, measurement.WHOLE, seed, out)
        return report.measured(seed)

    found = run(measured()) or Measured(seed, "iso9283", failure="stopped")
    figures = "{improvement:.0f} times better; {improvement on reports:.1f} times what the connectors' reports give"
    promises, section = _once(
        found,
        "Accuracy by ISO 9283 after the calibration of a misassembled arm",
        "at least 5 times better",
        _filled(figures, found),
    )
    section.text += " The tables of the standard are in iso9283.html."
    section.plots += [
        Plot(out / page.PLACES, "Attained places less the commanded ones, without a load; crosses are means."),
        Plot(out / page.PATHS, "Distance of the mean path from the commanded line, along the line."),
    ]
    return promises, section


def _filled(figures: str, found: Measured) -> str:
    """The text with the figures that were measured; empty without them."""
    return figures.format_map(found.values) if found.success else ""


def _kitting(out: Path, seeds: int, jobs: int | None) -> tuple[list[Promise], Section]:
    from jauspy.cell.report import Promise, Section, Table
    from jauspy.cell.trials import mean_of, run_trials, write_results

    console.note(f"{seeds} kitting orders, each way")
    rows: list[Sequence[str]] = [("way", "runs", "mean score", "of", "mean time of an order, s", "building, s")]
    results: dict[str, list[Measured]] = {}
    for task, way in WAYS.items():
        results[task] = found = list(runs_with_progress(way, seeds, run_trials(task, range(seeds), jobs=jobs)))
        write_results(out / f"{task}.json", found)
        figures = [f"{mean_of(found, name):.2f}" for name in ("score", "most_points", "order_time", "build_time")]
        rows.append((way, str(len(found)), *figures))
    done = all(run.success for found in results.values() for run in found)
    conclusion = break_even(results["kitting"], results["kitting-arm"])
    promise = Promise("kitting orders, with and without a modular arm", "measured both ways", f"{seeds} each", done)
    text = f"Orders in the style of ARIAC 2018, scored by its rules. {conclusion}"
    return [promise], Section("Kitting", text, [Table("Orders", rows)])
