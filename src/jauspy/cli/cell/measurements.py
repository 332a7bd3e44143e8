"""`jauspy cell kpi` and `iso9283`: the swing after a release, and the accuracy of both arms."""

from __future__ import annotations

import json as json_module
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import OUTPUT, Out, Seed, check_extra
from jauspy.cli.options import Json
from jauspy.cli.processes import run
from jauspy.platform.modular import check_libraries

if TYPE_CHECKING:
    from jauspy.cell.measurements import Measured


def kpi(*, seed: Seed = 0, out: Out = OUTPUT, json: Json = False) -> None:
    """Measure how soon the arm comes to rest after a release, with both controllers.

    Writes DIR/swing.json and a plot of the last module's angular velocity, DIR/swing.svg. Exit status 1 unless the
    controller with the arm's model settles five times sooner and overshoots a third at most.

    Example:
      jauspy cell kpi --output cell_out
    """
    check_extra()
    from jauspy.cell.swing import compare, plot_swing

    async def measured() -> Measured:
        comparison = await compare(seed, console.note)
        out.mkdir(parents=True, exist_ok=True)
        plot_swing(comparison, out / "swing.svg")
        return comparison.measured(seed)

    _show(run(measured()), out, "swing", json=json)


def iso9283(
    *,
    seed: Seed = 0,
    cycles: Annotated[
        int, typer.Option("--cycles", min=2, metavar="N", help="Cycles of each pose; ISO 9283 requires 30.")
    ] = 30,
    path_cycles: Annotated[
        int, typer.Option("--path-cycles", min=2, metavar="N", help="Cycles of the path; ISO 9283 requires 10.")
    ] = 10,
    samples: Annotated[int, typer.Option("--samples", min=8, metavar="N", help="Postures of the calibration.")] = 60,
    out: Annotated[
        Path,
        typer.Option("-o", "--output", "--out", metavar="PATH", help="Directory of results, or the page: an .html."),
    ] = OUTPUT,
    json: Json = False,
) -> None:
    """Measure accuracy and repeatability of both arms, before and after a calibration.

    At poses and along a line, at the whole, half and a tenth of their speed, without a load, with a tenth of the rated
    load and with all of it, and how they drift. Writes iso9283.html with the standard's tables, iso9283.json and plots.
    Exit status 1 unless the calibration improves the accuracy at least five times.

    Example:
      jauspy cell iso9283 --output cell_out
    """
    check_extra()
    check_libraries("`jauspy cell iso9283`", "scipy", extra="cell-measurements")
    from jauspy.cell.iso9283.bench import Plan
    from jauspy.cell.iso9283.measurement import measure
    from jauspy.cell.iso9283.page import write_report

    plan = Plan(cycles, path_cycles, samples=samples)
    is_page = out.suffix.lower() in (".html", ".htm")
    directory = out.parent if is_page else out

    async def measured() -> Measured:
        report = await measure(seed, plan, console.note)
        written = write_report(report, plan, seed, directory, out if is_page else None)
        console.note(str(written))
        return report.measured(seed)

    _show(run(measured()), directory, "iso9283", json=json)


def _show(found: Measured | None, out: Path, name: str, *, json: bool) -> None:
    from jauspy.cli.cell.tables import values_table

    if found is None:
        return
    out.mkdir(parents=True, exist_ok=True)
    (out / f"{name}.json").write_text(json_module.dumps(asdict(found), indent=1))
    if json:
        console.print_json(asdict(found))
    else:
        console.stdout(140).print(values_table(found))
    if not found.success:
        if not json:
            console.error(f"{name}: {found.failure}")
        raise typer.Exit(1)
