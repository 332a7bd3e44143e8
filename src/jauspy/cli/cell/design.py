"""`jauspy cell design`: choose modules of the cell for tasks in CoBRA's format, build the arms and use them."""

from __future__ import annotations

import json as json_module
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Record, Seed, View, check_extra
from jauspy.cli.options import Json
from jauspy.cli.processes import run

if TYPE_CHECKING:
    from jauspy.cell.design.search import Design, Found
    from jauspy.cell.measurements import Measured


def design(
    tasks: Annotated[list[Path], typer.Argument(metavar="TASK.json...", help="Tasks in CoBRA's format.")],
    *,
    robot: Annotated[str, typer.Option("--robot", metavar="ROBOT", help="The cell: a name or a TOML file.")] = "cell",
    base: Annotated[
        str, typer.Option("--base", metavar="CONNECTOR", help="The connector that carries the arm.")
    ] = "platform_1/top",
    load: Annotated[float, typer.Option("--load", min=0.0, max=100.0, metavar="KG", help="Mass at the tip.")] = 0.0,
    cost: Annotated[
        str,
        typer.Option(
            "--cost", metavar="COSTS", help="CoBRA's costs with weights: cyc, qDist, mass, numJ, effort, mechEnergy."
        ),
    ] = "mass,numJ_0.2,cyc_0.1",
    candidates: Annotated[int, typer.Option("--candidates", min=1, metavar="N", help="Chains to try.")] = 2000,
    limit: Annotated[float, typer.Option("--limit", min=0.1, metavar="S", help="Seconds to search.")] = 60.0,
    build: Annotated[bool, typer.Option("--build", help="Build and use each arm in the simulation.")] = False,
    seed: Seed = 0,
    record: Record = None,
    view: View = False,
    out: Annotated[Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write the results, JSON.")] = None,
    json: Json = False,
) -> None:
    """Choose modules for a task: the cheapest chain found that reaches all goals.

    With --build the UR10 joins the modules of each task out of the bins, the arm goes to all goals, with its load, and
    is taken apart before the next one is built. Among designs the cheapest one is taken of which a quick plan shows how
    the UR10 joins its parts. All figures of what was built are measured in the simulation.

    Torques and loads of connectors are those at rest and in the motions between goals. Exit status 1 if no chain was
    found for a task, or one did not do its task.

    Example:
      jauspy cell design TASK.json --base platform_1/top
    """
    check_extra()
    if (record or view) and not build:
        raise typer.BadParameter("--record and --view show what is built; add --build")
    from jauspy.cell.design.build import build_all
    from jauspy.cell.design.rehearsal import first_buildable
    from jauspy.cell.design.search import Search, check, parse_costs
    from jauspy.cell.design.surroundings import furnished
    from jauspy.cell.design.tasks import load_task
    from jauspy.cell.scene import Layout, cell_of
    from jauspy.robot import robot_files

    wanted = [load_task(path) for path in tasks]
    model = robot_files.robot_model(robot_files.load(robot))
    results: list[dict[str, Any]] = []
    chosen: list[Design | None] = []
    for task in wanted:
        cell = cell_of(model)
        found = Search(cell, task, base, load=load, weights=parse_costs(cost), seed=seed).run(
            candidates, limit, console.note
        )
        best = found.best
        if build:
            layout = Layout(replace(model, cell=furnished(cell, [task], base, load)))
            best = first_buildable(layout, found, base, load, console.note)
        wrong = [] if best is None else check(cell, task, base, best, load=load)
        chosen.append(None if wrong else best)
        results.append(
            {
                "task": task.name,
                "base": base,
                "load": load,
                "tried": found.tried,
                "lost": dict(found.reasons.most_common()),
                "design": None if best is None else asdict(best),
                "wrong": wrong,
            }
        )
        if not json:
            _print_design(task.name, best, found)
    able = [(task, design) for task, design in zip(wanted, chosen, strict=True) if design is not None]
    problem = ""
    if build and able:
        measured = run(build_all(able, base, robot, load=load, seed=seed, film=record, view=view)) or []
        names = {found.task: found for found in measured}
        for result in results:
            if result["task"] in names:
                result["built"] = asdict(names[result["task"]])
        problem = next((found.film_problem for found in measured if found.film_problem), "")
        if not json:
            _print_built(measured)
        if problem:
            console.error(problem)
    if out is not None:
        out.write_text(json_module.dumps(results if len(results) > 1 else results[0], indent=1))
    if json:
        console.print_json(results if len(results) > 1 else results[0])
    done = all("built" in result and result["built"]["success"] for result in results) if build else all(chosen)
    if not done or problem:
        raise typer.Exit(1)


def _print_design(task: str, best: Design | None, found: Found) -> None:
    screen = console.stdout(140)
    if best is not None:
        screen.print(f"{task}: " + ", ".join(element.type for element in best.elements))
        screen.print("costs: " + ", ".join(f"{name} {value:.3f}" for name, value in best.costs.items()))
        screen.print(
            f"at most: torque {best.torque:.0%} and connectors {best.moment:.0%} of the limits;"
            f" clearance {best.clearance * 1e3:.0f} mm"
        )
    screen.print(f"{found.tried} chains; lost: " + ", ".join(f"{r} {n}" for r, n in found.reasons.most_common()))


def _print_built(measured: list[Measured]) -> None:
    """A table of what was designed and what was measured."""
    from rich.table import Table

    table = Table(title="designed and built", title_justify="left")
    table.add_column("task")
    for heading in (
        "numJ",
        "mass kg",
        "cyc s",
        "measured",
        "energy Wh",
        "error mm",
        "goals",
        "clearance mm",
        "build s",
    ):
        table.add_column(heading, justify="right")
    table.add_column("result")
    for found in measured:
        values = found.values
        if "cyc" not in values:
            table.add_row(found.task, *["-"] * 9, found.failure)
            continue
        table.add_row(
            found.task,
            f"{values['numJ']:.0f}",
            f"{values['mass']:.2f}",
            f"{values['designed_cyc']:.2f}",
            f"{values['cyc']:.2f}",
            f"{values['energy_in_use'] / 3600.0:.3f}",
            f"{1000.0 * values['largest_error']:.2f}",
            f"{values['goals_reached']:.0f} of {values['goals']:.0f}",
            f"{1000.0 * values['clearance']:.0f}",
            f"{values['build_time']:.0f}",
            found.failure or "success",
        )
    console.stdout(160).print(table)
