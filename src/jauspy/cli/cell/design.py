"""`jauspy cell design`: choose modules of the cell for a task in CoBRA's format."""

from __future__ import annotations

import json as json_module
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Seed, check_extra
from jauspy.cli.options import Json


def design(
    task: Annotated[Path, typer.Argument(metavar="TASK.json", help="A task in CoBRA's format.")],
    *,
    robot: Annotated[str, typer.Option("--robot", metavar="ROBOT", help="The cell: a name or a TOML file.")] = "cell",
    base: Annotated[
        str, typer.Option("--base", metavar="CONNECTOR", help="The connector that carries the arm.")
    ] = "platform_1/top",
    load: Annotated[float, typer.Option("--load", min=0.0, max=100.0, metavar="KG", help="Mass at the tip.")] = 0.0,
    cost: Annotated[
        str, typer.Option("--cost", metavar="COSTS", help="CoBRA's costs with weights: cyc, qDist, mass, numJ.")
    ] = "mass,numJ_0.2,cyc_0.1",
    candidates: Annotated[int, typer.Option("--candidates", min=1, metavar="N", help="Chains to try.")] = 2000,
    limit: Annotated[float, typer.Option("--limit", min=0.1, metavar="S", help="Seconds to search.")] = 60.0,
    seed: Seed = 0,
    out: Annotated[Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write the design, JSON.")] = None,
    json: Json = False,
) -> None:
    """Choose modules for a task: the cheapest chain found that reaches all goals.

    Nothing is built. Torques and the moments of connectors are those at rest. Exit status 1 if no chain was found.
    """
    check_extra()
    from jauspy.cell.design.search import Search, check, parse_costs
    from jauspy.cell.design.tasks import load_task
    from jauspy.cell.scene import cell_of
    from jauspy.robot import robot_files

    wanted = load_task(task)
    cell = cell_of(robot_files.robot_model(robot_files.load(robot)))
    search = Search(cell, wanted, base, load=load, weights=parse_costs(cost), seed=seed)
    found = search.run(candidates, limit, console.note)
    best = found.best
    wrong = [] if best is None else check(cell, wanted, base, best.elements, best.positions, load=load)
    result = {
        "task": wanted.name,
        "base": base,
        "load": load,
        "tried": found.tried,
        "lost": dict(found.reasons.most_common()),
        "design": None if best is None else asdict(best),
        "wrong": wrong,
    }
    if out is not None:
        out.write_text(json_module.dumps(result, indent=1))
    if json:
        console.print_json(result)
    else:
        screen = console.stdout(140)
        if best is not None:
            screen.print(f"{wanted.name}: " + ", ".join(element.type for element in best.elements))
            screen.print("costs: " + ", ".join(f"{name} {value:.3f}" for name, value in best.costs.items()))
            screen.print(
                f"at rest: torque {best.torque:.0%} and connectors {best.moment:.0%} of the limits;"
                f" clearance {best.clearance * 1e3:.0f} mm"
            )
        screen.print(f"{found.tried} chains; lost: " + ", ".join(f"{r} {n}" for r, n in found.reasons.most_common()))
    if best is None or wrong:
        raise typer.Exit(1)
