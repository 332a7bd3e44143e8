"""`jauspy cell assemble`, `lift`, `step`, `take-apart`, `car` and `demo`: one run of a task with its measurements."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Exact, Record, Seed, View, check_extra, millimetres
from jauspy.cli.client import make_ocu
from jauspy.cli.options import Connect, Json, OperatorKey, OwnId
from jauspy.cli.processes import run
from jauspy.errors import JausError

if TYPE_CHECKING:
    from jauspy.cell.measurements import Measured
    from jauspy.cell.story import Stage
    from jauspy.cell.tasks import Task

DISCOVERY_TIME: Final = 3.0
"""Seconds in which a running cell must answer discovery."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """The options of one run of a task."""

    seed: int
    exact: bool
    film: Path | None
    view: bool
    connect: str | None = None
    id: str | None = None
    operator_key: Path | None = None

    def carry_out(self, name: str, task: Task | None = None) -> Measured | None:
        """Run a task here, or in the running cell that `connect` names; None when it was stopped."""
        check_extra()
        if self.connect is not None and (self.film or self.view or self.exact):
            raise typer.BadParameter(
                "--record, --view and --exact are for a cell that is simulated here; leave out --connect"
            )
        return run(self._here(name, task) if self.connect is None else self._elsewhere(name, task))

    async def _here(self, name: str, task: Task | None) -> Measured:
        from jauspy.cell import tasks
        from jauspy.cell.session import UNDISTURBED

        disturbances = UNDISTURBED if self.exact else None
        more = {} if task is None else {"run": task}
        return await tasks.run_one(name, self.seed, disturbances, film=self.film, view=self.view, **more)

    async def _elsewhere(self, name: str, task: Task | None) -> Measured:
        from jauspy.cell.measurements import Measured
        from jauspy.cell.session import connected
        from jauspy.cell.tasks import TASKS

        ocu = make_ocu(self.id, self.connect, DISCOVERY_TIME, operator=self.operator_key)
        async with connected(ocu) as session:
            start = session.cell.now()
            try:
                return await (task or TASKS[name])(session, self.seed)
            except JausError as error:
                return Measured(self.seed, name, failure=str(error), duration=session.cell.now() - start)


def lift(
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
    """Take a box off the moving conveyor with the modular arm, and throw it into the marked area.

    The arm on platform 1 is taken as it stands. Without one, in a cell that is simulated here, its parts are put in
    place by writing their positions, which the result says; `jauspy cell assemble --connect` builds one in a running
    cell. Exit status 1 when the box does not rest in the area, or when a film is incomplete.

    Example:
      jauspy cell lift --seed 7
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    _show("lift", options.carry_out("lift"), json=json)


def throws(
    *, seed: Seed = 0, exact: Exact = False, record: Record = None, view: View = False, json: Json = False
) -> None:
    """Throw a box ten times, each aim corrected by where the boxes before came to rest.

    Boxes are put back on the belt by writing their positions. Exit status 1 when one of the last five rests more than
    2 cm from the middle of the area.

    Example:
      jauspy cell throws --seed 7
    """
    _show("throws", Run(seed=seed, exact=exact, film=record, view=view).carry_out("throws"), json=json)


def step(
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
    """Step with the modular arm from platform to platform, and back.

    The connector at one end is released only when that at the other end holds. The arm is taken as it stands, as by
    `jauspy cell lift`.

    Example:
      jauspy cell step --seed 7
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    _show("step", options.carry_out("step"), json=json)


def take_apart(
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
    """Take the modular arm apart: the UR10 puts its parts back into their bins.

    The arm is taken as it stands, as by `jauspy cell lift`.

    Example:
      jauspy cell take-apart --seed 7
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    _show("take-apart", options.carry_out("take-apart"), json=json)


def car(
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
    """Build the car, put the arm on top, and drive both off the conveyor.

    The UR10 puts the car and then the arm on the conveyor; the car is driven over the JAUS mobility services while the
    arm on it moves. The arm is taken as it stands, as by `jauspy cell lift`.

    Example:
      jauspy cell car --seed 7
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    _show("car", options.carry_out("car"), json=json)


def demo(
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
    """Do everything in one run: build the arm, throw, step, take it apart, build the car, drive off with the arm.

    Each stage begins with what the one before has left, and nothing is put in place by writing positions; where a cell
    is simulated here, the simulation checks that. The stages are printed as they go. Exit status 1 when a stage does
    not reach its goal, or when a film is incomplete.

    Example:
      jauspy cell demo --seed 7 --record cell_out/demo.mp4
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    check_extra()
    from jauspy.cell import tasks
    from jauspy.cell.session import Session
    from jauspy.cli.cell.tables import stage_text

    def told(stage: Stage, found: Measured | None) -> None:
        if found is None:
            console.note(f"{stage.title} …")
        elif not json:
            console.print_lines(stage_text(stage, found))

    async def story(session: Session, seed: int) -> Measured:
        return await tasks.demo(session, seed, told)

    found = options.carry_out("demo", story)
    if found is not None and not json:
        cpu = f", {found.cpu:.0f} s of CPU time" if found.cpu else ""
        verdict = "the whole story succeeded" if found.success else "the story failed"
        console.print_lines(f"{verdict}: {found.duration:.1f} s of the cell's time{cpu}")
        if found.failure:
            console.error(f"demo: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    elif found is not None:
        console.print_json(asdict(found))
    _end(found)


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

    Example:
      jauspy cell assemble --seed 7
    """
    options = Run(seed=seed, exact=exact, film=record, view=view, connect=connect, id=id, operator_key=operator_key)
    found = options.carry_out("assemble")
    if found is not None and not json:
        from jauspy.cli.cell.tables import assembly_table

        console.stdout(140).print(assembly_table(found))
        values = found.values
        cpu = f", {found.cpu:.0f} s of CPU time" if found.cpu else ""
        console.print_lines(
            f"{values.get('parts', 0):.0f} parts in {found.duration:.1f} s{cpu}; smallest distance "
            f"{millimetres(values.get('clearance', 0.0))} mm; {values.get('retries', 0):.0f} retries"
        )
        if not found.success:
            console.error(f"the arm was not finished: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    elif found is not None:
        console.print_json(asdict(found))
    _end(found)


def _show(task: str, found: Measured | None, *, json: bool) -> None:
    """Print the measurements of a run, and end with exit status 1 if it failed."""
    if found is not None and json:
        console.print_json(asdict(found))
    elif found is not None:
        from jauspy.cli.cell.tables import values_table

        console.stdout(140).print(values_table(found))
        if found.failure:
            console.error(f"{task}: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    _end(found)


def _end(found: Measured | None) -> None:
    if found is not None and (not found.success or found.film_problem):
        raise typer.Exit(1)
