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
from jauspy.cli.cell.trials import WAYS, break_even, with_progress
from jauspy.cli.processes import run

if TYPE_CHECKING:
    from jauspy.cell.measurements import Measured
    from jauspy.cell.report import Promise, Section

FILMED: Final = {
    "assemble": "The UR10 builds the arm with five joints",
    "lift": "The arm takes a box off the moving conveyor and throws it",
    "step": "The arm steps from platform to platform and back",
    "car": "The UR10 builds the car, puts it and the arm on the conveyor, and it drives off",
}


def all_tasks(
    *,
    seeds: Annotated[
        int, typer.Option("--seeds", min=1, metavar="N", help="Runs of the assembly, and half as many of the lift.")
    ] = 100,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="N", help="Seed of the filmed runs.")] = 7,
    jobs: Jobs = None,
    films: Annotated[bool, typer.Option("--films/--no-films", help="Film each task. Needs the extra 'video'.")] = True,
    out: Out = OUTPUT,
) -> None:
    """Run everything once; write films, plots and a page of results.

    The page has all tables, plots and films inside and opens without a network. Exit status 0 only if every
    promised figure was reached.
    """
    check_extra()
    from jauspy.cell.report import page

    out.mkdir(parents=True, exist_ok=True)
    promises: list[Promise] = []
    sections: list[Section] = []
    for task, title in FILMED.items():
        found = _filmed(task, seed, out / f"{task}.mp4" if films else None)
        (out / f"{task}.json").write_text(json.dumps(asdict(found), indent=1))
        promise, section = _once(found, title, out / f"{task}.mp4")
        promises.append(promise)
        sections.append(section)
    for task, count, need in (("assemble", seeds, 0.95), ("lift", max(1, seeds // 2), 0.5)):
        promise, section = _trials(task, count, need, jobs, out)
        promises.append(promise)
        sections.append(section)
    for promise, section in (_swing(seed, out), _accuracy(seed)):
        promises.append(promise)
        sections.append(section)
    promise, section = _kitting(out, min(20, seeds), jobs)
    promises.append(promise)
    sections.append(section)
    text = page("The modular factory cell", "Everything below was measured by `jauspy cell all`.", promises, sections)
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


def _once(
    found: Measured, title: str, film: Path, wanted: str = "it succeeds", figures: str = ""
) -> tuple[Promise, Section]:
    """The result of one run of a task; `figures` are those with a required value, or else its duration."""
    from jauspy.cell.measurements import figure_text
    from jauspy.cell.report import Promise, Section

    measured = found.failure or figures or f"done in {found.duration:.1f} s of the cell's time"
    promise = Promise(title, wanted, measured, found.success)
    table: list[Sequence[str]] = [("figure", "value")]
    table += [(name.replace("_", " "), figure_text(name, value)) for name, value in found.values.items()]
    incomplete = f" Film: {found.film_problem}." if found.film_problem else ""
    section = Section(title, f"Seed {found.seed}: {measured}.{incomplete}", table, film=film)
    if found.rows and "slot" in found.rows[0]:
        section.table += [
            (f"{row['slot']}: {row['part']}", f"{row['fetch_time'] + row['join_time']:.1f} s to fetch and to join")
            for row in found.rows
        ]
    return promise, section


def _trials(task: str, count: int, need: float, jobs: int | None, out: Path) -> tuple[Promise, Section]:
    from jauspy.cell.report import Promise, Section, plot_trials
    from jauspy.cell.trials import run_trials, summarised

    console.note(f"{count} runs of {task}")
    results = run_trials(task, range(count), jobs=jobs)
    found = sorted(with_progress(task, count, results), key=lambda run: run.seed)
    (out / f"trials-{task}.json").write_text(json.dumps([asdict(run) for run in found], indent=1))
    summary = summarised(found)
    plot = out / f"trials-{task}.svg"
    plot_trials(found, summary, plot)
    measured = (
        f"{summary.successes} of {summary.runs} (95 %: {100 * summary.low:.0f} to {100 * summary.high:.0f} %), "
        f"median {summary.duration:.1f} s"
    )
    promise = Promise(f"trials of {task}", f"at least {100 * need:.0f} %", measured, summary.rate >= need)
    table: list[Sequence[str]] = [("seed", "reason of the failure"), *((str(a), b) for a, b in summary.failures)]
    return promise, Section(f"{count} runs of {task}", measured, table if summary.failures else [], [plot])


def _swing(seed: int, out: Path) -> tuple[Promise, Section]:
    from jauspy.cell import swing
    from jauspy.cell.measurements import Measured

    async def measured() -> Measured:
        comparison = await swing.compare(seed, console.note)
        swing.plot_swing(comparison, out / "swing.svg")
        return comparison.measured(seed)

    found = run(measured()) or Measured(seed, "swing", failure="stopped")
    figures = (
        "{settled_sooner:.1f} times sooner ({settled_model:.2f} s, not {settled_pid:.2f} s), {overshoot_ratio:.2f} of "
        "the overshoot"
    )
    promise, section = _once(
        found,
        "The swing after the release, with the model of the arm instead of a PID controller for each joint",
        Path("none"),
        "at rest at least 5 times sooner, at most a third of the overshoot",
        _filled(figures, found),
    )
    section.plots.append(out / "swing.svg")
    return promise, section


def _accuracy(seed: int) -> tuple[Promise, Section]:
    from jauspy.cell import iso9283
    from jauspy.cell.measurements import Measured

    async def measured() -> Measured:
        return (await iso9283.measure(seed, report=console.note)).measured(seed)

    found = run(measured()) or Measured(seed, "iso9283", failure="stopped")
    figures = "{improvement:.0f} times better; {improvement on reports:.1f} times what the connectors' reports give"
    return _once(
        found,
        "Accuracy by ISO 9283 after the calibration of a misassembled arm",
        Path("none"),
        "at least 5 times better",
        _filled(figures, found),
    )


def _filled(figures: str, found: Measured) -> str:
    """The text with the figures that were measured; empty without them."""
    return figures.format_map(found.values) if found.success else ""


def _kitting(out: Path, seeds: int, jobs: int | None) -> tuple[Promise, Section]:
    from jauspy.cell.report import Promise, Section
    from jauspy.cell.trials import mean_of, run_trials

    console.note(f"{seeds} kitting orders, each way")
    table: list[Sequence[str]] = [("way", "runs", "mean score", "of", "mean time of an order, s", "building, s")]
    results: dict[str, list[Measured]] = {}
    for task, way in WAYS.items():
        results[task] = found = list(with_progress(way, seeds, run_trials(task, range(seeds), jobs=jobs)))
        (out / f"{task}.json").write_text(json.dumps([asdict(run) for run in found], indent=1))
        figures = [f"{mean_of(found, name):.2f}" for name in ("score", "most_points", "order_time", "build_time")]
        table.append((way, str(len(found)), *figures))
    done = all(run.success for found in results.values() for run in found)
    conclusion = break_even(results["kitting"], results["kitting-arm"])
    promise = Promise("kitting orders, with and without a modular arm", "measured both ways", f"{seeds} each", done)
    return promise, Section("Kitting", f"Orders in the style of ARIAC 2018, scored by its rules. {conclusion}", table)
