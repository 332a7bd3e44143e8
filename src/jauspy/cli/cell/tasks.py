"""`jauspy cell assemble`, `lift`, `step` and `car`: one run of a task with its measurements."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Exact, Record, Seed, View, check_extra, millimetres
from jauspy.cli.client import make_ocu
from jauspy.cli.options import Connect, Json, OperatorKey, OwnId
from jauspy.cli.processes import run


def lift(
    *, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False
) -> None:
    """Take a box off the moving conveyor with the modular arm, and throw it into the marked area.

    The arm is there already; `jauspy cell assemble` builds one. Exit status 1 when the box does not rest in the area,
    or when a film is incomplete.
    """
    _run("lift", seed, exact=exact, film=record, view=view, json=json)


def throws(
    *, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False
) -> None:
    """Throw a box ten times, each aim corrected by where the boxes before came to rest.

    Boxes are put back on the belt by writing their positions. Exit status 1 when one of the last five rests more than
    2 cm from the middle of the area.
    """
    _run("throws", seed, exact=exact, film=record, view=view, json=json)


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
    from jauspy.cell.session import UNDISTURBED
    from jauspy.cell.tasks import run_one
    from jauspy.cli.cell.tables import values_table

    found = run(run_one(task, seed, UNDISTURBED if exact else None, film=film, view=view))
    if found is None:
        return
    if json:
        console.print_json(asdict(found))
    else:
        console.stdout(140).print(values_table(found))
        if found.failure:
            console.error(f"{task}: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    if not found.success or found.film_problem:
        raise typer.Exit(1)


def assemble(
    *,
    seed: Seed = 0,
    exact: Exact = False,
    record: Record = None,
    view: View = False,
    connect: Connect = None,
    id: OwnId = None,
    operator_key: OperatorKey = None,
    json: Json = False,
) -> None:
    """Build an arm with five joints: the UR10 takes modules out of the bins and joins them.

    Every grasp and every joint is verified by the connectors' state and by force; a step that fails is repeated in
    another way. Without --connect the cell is simulated in this process, as fast as the machine can; with it the task
    is carried out by a running cell, such as `jauspy up cell`.

    Exit status 1 when the arm could not be built, or when a film is incomplete; the reason is printed, and the cell is
    left at rest.
    """
    check_extra()
    if connect is not None and (record or view or exact):
        raise typer.BadParameter(
            "--record, --view and --exact are for a cell that is simulated here; leave out --connect"
        )
    from dataclasses import asdict

    from jauspy.cell import tasks
    from jauspy.cell.measurements import Measured
    from jauspy.cell.session import UNDISTURBED, connected
    from jauspy.cli.cell.tables import assembly_table

    async def here() -> Measured:
        return await tasks.run_one("assemble", seed, UNDISTURBED if exact else None, film=record, view=view)

    async def elsewhere() -> Measured:
        async with connected(make_ocu(id, connect, 3.0, operator=operator_key)) as session:
            return await tasks.assemble(session, seed)

    found = run(here() if connect is None else elsewhere())
    if found is None:
        return
    if json:
        console.print_json(asdict(found))
    else:
        console.stdout(140).print(assembly_table(found))
        values = found.values
        speed = f", {found.duration / found.wall:.1f} times real time" if found.wall else ""
        console.print_lines(
            f"{values.get('parts', 0):.0f} parts in {found.duration:.1f} s{speed}; smallest distance "
            f"{millimetres(values.get('clearance', 0.0))} mm; {values.get('retries', 0):.0f} retries"
        )
        if not found.success:
            console.error(f"the arm was not finished: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    if not found.success or found.film_problem:
        raise typer.Exit(1)
