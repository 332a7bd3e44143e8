"""Tables of the results of `jauspy cell`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from jauspy.cell.measurements import Measured, figure_text
from jauspy.cell.trials import Summary, mean_of
from jauspy.cli.cell.options import degrees, millimetres

if TYPE_CHECKING:
    from rich.table import Table

    from jauspy.cell.story import Stage


def assembly_table(found: Measured) -> Table:
    """A line for each part of an arm that was built."""
    from rich.table import Table

    table = Table(title=f"assembly, seed {found.seed}", title_justify="left")
    for heading in ("place", "part"):
        table.add_column(heading)
    for heading in (
        "fetch s",
        "join s",
        "grasp N",
        "mass kg",
        "joint N",
        "joint Nm",
        "off mm",
        "tilt deg",
        "turn deg",
        "retries",
    ):
        table.add_column(heading, justify="right")
    for row in found.rows:
        placed = "error" in row
        table.add_row(
            row["slot"],
            row["part"],
            f"{row['fetch_time']:.1f}",
            f"{row['join_time']:.1f}",
            f"{row['grasp_force']:.1f}",
            f"{row['mass']:.2f} ±{row['mass_deviation']:.2f}",
            f"{row['joint_force']:.1f}",
            f"{row['joint_moment']:.2f}",
            millimetres(row["error"]) if placed else "-",
            degrees(row["error_tilt"]) if placed else "-",
            degrees(row["error_turn"]) if placed else "-",
            str(len(row["attempts"])),
        )
    return table


def values_table(found: Measured) -> Table:
    """A table of the measurements of one run."""
    from rich.table import Table

    table = Table(title=f"{found.task}, seed {found.seed}", title_justify="left", show_header=False)
    table.add_column()
    table.add_column()
    table.add_row("result", "[green]success[/]" if found.success else "[red]failure[/]")
    cpu = f", {found.cpu:.0f} s of CPU time" if found.cpu else ""
    if found.duration:
        table.add_row("time of the cell", f"{found.duration:.1f} s{cpu}")
    for name, value in found.values.items():
        table.add_row(name.replace("_", " "), figure_text(name, value))
    if found.written:
        table.add_row("put in place by writing positions", ", ".join(found.written))
    for row in found.rows:
        if "event" in row:
            table.add_row("", row["event"])
        elif "slot" in row:
            tried = "; ".join(row["attempts"]) or "at once"
            table.add_row(row["slot"], f"{row['part']}: {row['fetch_time'] + row['join_time']:.1f} s, {tried}")
    return table


def stage_text(stage: Stage, found: Measured) -> str:
    """The result of one stage of a story, with its figures, on one line."""
    figures = [f"{name.replace('_', ' ')} {figure_text(name, value)}" for name, value in found.values.items()]
    result = "done" if found.success else f"FAILED ({found.failure or 'its goal was not reached'})"
    written = f"; put in place by writing positions: {', '.join(found.written)}" if found.written else ""
    return f"{stage.name}: {result} in {found.duration:.1f} s; {', '.join(figures)}{written}"


def trials_table(summary: Summary, results: Sequence[Measured]) -> Table:
    """A table of the results of many runs."""
    from rich.table import Table

    table = Table(title=f"{summary.runs} runs of {summary.task}", title_justify="left", show_header=False)
    table.add_column()
    table.add_column()
    table.add_row(
        "success",
        f"{summary.successes} of {summary.runs} (95 %: {100 * summary.low:.0f} to {100 * summary.high:.0f} %)",
    )
    table.add_row("time of a run", f"median {summary.duration:.1f} s, longest {summary.longest:.1f} s")
    table.add_row("CPU time of a run", f"mean {summary.cpu:.0f} s: {summary.speed:.1f} times real time")
    for name in sorted({name for result in results for name in result.values}):
        values = [result.values[name] for result in results if name in result.values]
        mean, most = figure_text(name, mean_of(results, name)), figure_text(name, max(values))
        table.add_row(name.replace("_", " "), f"mean {mean}, most {most}")
    for seed, reason in summary.failures:
        table.add_row(f"[red]seed {seed}[/]", reason)
    return table
