"""`jauspy cell lift`, `step` and `car`: one run of a task, and what was measured."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Exact, Record, Seed, View, check_extra
from jauspy.cli.options import Json
from jauspy.cli.processes import run


def lift(
    *, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False
) -> None:
    """Take a box off the moving conveyor with the modular arm, and throw it into the marked area.

    The arm is there already; `jauspy cell assemble` builds one. Exit status 1 when the box does not rest in the area.
    """
    _run("lift", seed, exact=exact, film=record, view=view, json=json)


def step(
    *, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False
) -> None:
    """Step with the modular arm from platform to platform, and back.

    The connector at one end is released only when that at the other end holds.
    """
    _run("step", seed, exact=exact, film=record, view=view, json=json)


def car(*, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False) -> None:
    """Build the car, put the arm on top, and drive both off the conveyor.

    The UR10 puts the car and then the arm on the conveyor; the car is driven over the JAUS mobility services while the
    arm on it moves.
    """
    _run("car", seed, exact=exact, film=record, view=view, json=json)


def _run(task: str, seed: int, *, exact: bool, film: Path | None, view: bool, json: bool) -> None:
    check_extra()
    from jauspy.cell.session import NONE
    from jauspy.cell.tasks import run_one
    from jauspy.cli.cell.tables import values_table

    found = run(run_one(task, seed, NONE if exact else None, film=film, view=view))
    if found is None:
        return
    if json:
        console.print_json(asdict(found))
    else:
        console.stdout(140).print(values_table(found))
        if found.failure:
            console.error(f"{task}: {found.failure}")
    if not found.success:
        raise typer.Exit(1)
