"""`jauspy cell design`: choose modules of the cell for tasks in CoBRA's format, build the arms and use them."""

from __future__ import annotations

import json as json_module
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Record, Seed, View, check_extra
from jauspy.cli.options import Json
from jauspy.cli.processes import run
from jauspy.errors import ConfigError

if TYPE_CHECKING:
    from collections.abc import Coroutine

    from jauspy.cell.design.choice import Choice
    from jauspy.cell.design.search import Design, Found
    from jauspy.cell.design.tasks import DesignTask
    from jauspy.cell.measurements import Measured


def design(
    tasks: Annotated[list[Path], typer.Argument(metavar="TASK.json...", help="Tasks in CoBRA's format.")],
    *,
    robot: Annotated[str, typer.Option("--robot", metavar="ROBOT", help="The cell: a name or a TOML file.")] = "cell",
    base: Annotated[
        str, typer.Option("--base", metavar="CONNECTOR", help="The connector that carries the arm.")
    ] = "platform_1/top",
    load: Annotated[
        float, typer.Option("--load", min=0.0, max=100.0, metavar="KG", help="Mass at the tip of each arm.")
    ] = 0.0,
    cost: Annotated[
        str,
        typer.Option(
            "--cost", metavar="COSTS", help="CoBRA's costs with weights: cyc, qDist, mass, numJ, effort, mechEnergy."
        ),
    ] = "mass,numJ_0.2,cyc_0.1",
    candidates: Annotated[int, typer.Option("--candidates", min=1, metavar="N", help="Chains to try.")] = 2000,
    limit: Annotated[
        float, typer.Option("--limit", min=0.1, metavar="S", help="Seconds of CPU time to search.")
    ] = 60.0,
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

    A task whose goals name arms, as connectors of the base, is one for two arms: both are chosen, built beside each
    other, commanded and measured, the second one clear of the first. For it a base with one connector is exchanged for
    a platform for two arms.

    Torques and loads of connectors are those at rest and in the motions between goals. Exit status 1 if no chain was
    found for a task, or one did not do its task.

    Example:
      jauspy cell design TASK.json --base platform_1/top
    """
    check_extra()
    if (record or view) and not build:
        raise typer.BadParameter("--record and --view show what is built; add --build")
    from jauspy.cell.design.choice import Chooser
    from jauspy.cell.design.pair import with_two_arms
    from jauspy.cell.design.search import parse_costs
    from jauspy.cell.design.tasks import load_task
    from jauspy.robot import robot_files

    wanted, config = [load_task(path) for path in tasks], robot_files.load(robot)
    paired = bool(wanted[0].arms)
    if any(bool(task.arms) != paired for task in wanted):
        raise ConfigError("tasks for one arm and for two need different bases; run a command for each")
    if paired:
        base = base.partition("/")[0]
        config = with_two_arms(config, base)
    chooser = Chooser(
        robot_files.robot_model(config), parse_costs(cost), seed, load, candidates, limit, build, console.note
    )
    results: list[dict[str, Any]] = []
    able: list[tuple[DesignTask, list[Design]]] = []
    for task in wanted:
        choices = chooser.choose(task, base)
        results += [_result(choice, load) for choice in choices]
        if not json:
            for choice in choices:
                _print_design(choice.task.name, choice.design, choice.found)
        if choices[-1].is_valid:
            able.append((task, [choice.design for choice in choices if choice.design is not None]))
    problem = ""
    if build and able:
        measured = run(_build(able, base, robot, load=load, seed=seed, film=record, view=view)) or []
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
    done = len(able) == len(wanted)
    if build:
        done = done and all("built" in result and result["built"]["success"] for result in results)
    if not done or problem:
        raise typer.Exit(1)


def _result(choice: Choice, load: float) -> dict[str, Any]:
    return {
        "task": choice.task.name,
        "base": choice.base,
        "load": load,
        "tried": choice.found.tried,
        "lost": dict(choice.found.reasons.most_common()),
        "design": None if choice.design is None else asdict(choice.design),
        "wrong": list(choice.wrong),
    }


def _build(
    able: list[tuple[DesignTask, list[Design]]],
    base: str,
    robot: str,
    *,
    load: float,
    seed: int,
    film: Path | None,
    view: bool,
) -> Coroutine[Any, Any, list[Measured]]:
    """Build and use the arms of each task in the simulation."""
    from jauspy.cell.design.build import build_all
    from jauspy.cell.design.pair import Pair, build_pairs

    if able[0][0].arms:
        pairs = [Pair(task, dict(zip(task.arms, designs, strict=True))) for task, designs in able]
        return build_pairs(pairs, base, robot, load=load, seed=seed, film=film, view=view)
    single = [(task, design) for task, (design,) in able]
    return build_all(single, base, robot, load=load, seed=seed, film=film, view=view)


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
