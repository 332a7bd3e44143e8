"""Designs that are built and used: the UR10 joins the modules, the arm goes to the goals, and the judge measures.

Everything is read from the simulation: poses of the tip, clearance and contacts at each step, energy.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np

from jauspy.cell.assembly import Assembler
from jauspy.cell.design.chains import ChainPosture, posture
from jauspy.cell.design.kinematics import ChainKinematics
from jauspy.cell.design.loads import LoadedChain, TimedMotion
from jauspy.cell.design.rehearsal import slots_of
from jauspy.cell.design.search import Design
from jauspy.cell.design.surroundings import furnished, set_up
from jauspy.cell.design.tasks import DesignTask, Goal, projections
from jauspy.cell.disassembly import Disassembler
from jauspy.cell.frames import Array, se3, transform
from jauspy.cell.judge import Watched
from jauspy.cell.measurements import Measured
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.motion import Path as JointPath
from jauspy.cell.scene import cell_of, pieces_of_part
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.session import ROBOT, Session, simulated
from jauspy.errors import JausError
from jauspy.geometry.poses import Transform
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import CellSetup

CAMERA: Final = "platforms"
"""The camera that films it."""
SLACK: Final = 1.02
"""Factor of a motion's shortest duration, since it does not begin quite where it was planned to."""
REST: Final = 0.5
"""Seconds at a goal until the tip is measured."""


async def build_all(
    designs: Sequence[tuple[DesignTask, Design]],
    base: str,
    robot: str = ROBOT,
    *,
    load: float,
    seed: int,
    film: Path | None = None,
    view: bool = False,
) -> list[Measured]:
    """Build, use and take apart the designs one after the other, out of the same bins.

    It ends with the first that fails, since its parts are then not in their bins.
    """
    tasks = [task for task, _ in designs]
    results: list[Measured] = []

    def change(model: RobotModel) -> RobotModel:
        return replace(model, cell=furnished(cell_of(model), tasks, base, load))

    async with simulated(seed, film=film, camera=CAMERA, view=view, robot=robot, change=change) as session:
        for number, (task, design) in enumerate(designs):
            begun, start = time.process_time(), session.cell.now()
            if number:
                set_up(session, tasks, number)
            found = Measured(seed, task.name)
            results.append(found)
            try:
                await DesignRun(session, task, design, base, load=load, found=found).run()
            except JausError as error:
                found.failure = found.failure or str(error)
            found.success = not found.failure
            found.duration, found.cpu = session.cell.now() - start, time.process_time() - begun
            if not found.success:
                break
    if session.film is not None:
        results[-1].film_problem = session.film.problem
    return results


class DesignRun:
    """One design: built, used and taken apart. Figures go to `found`, also those of a run that fails."""

    def __init__(
        self,
        session: Session,
        task: DesignTask,
        design: Design,
        base: str,
        *,
        load: float,
        found: Measured,
        ur10: Assembler | None = None,
    ) -> None:
        self._session, self._cell, self._judge = session, session.cell, session.true
        self._task, self._design, self._base, self._load = task, design, base, load
        self._found = found
        self._ur10 = ur10 or Assembler(session.cell, session.layout, seed=found.seed)
        self._carried = ""
        values = found.values
        values |= {"mass": design.costs["mass"], "numJ": design.costs["numJ"], "designed_cyc": design.costs["cyc"]}
        values |= {f"designed_{name}": design.costs[name] for name in ("effort", "mechEnergy")}
        values |= {"designed_torque": design.torque, "designed_connector": design.moment}

    async def run(self) -> None:
        """Build it, go to all goals, and take it apart. Raises `JausError` when it cannot be done."""
        drawn = self._judge.power().energy
        self._ur10.at = await self._cell.posture()
        await self.build()
        await self._ur10.park()
        use = await self.use()
        await use.begin(self._judge.watch(use.parts))
        for goal in self._task.goals:
            await use.go(await use.plan(goal))
        await use.finish()
        await self.take_apart()
        self._found.values["energy"] = self._judge.power().energy - drawn

    async def build(self) -> None:
        """Join the modules, and the load. Raises `TaskFailed`."""
        found, drawn = self._found, self._judge.power().energy
        slots = slots_of(self._design.elements, self._session.layout.setup.types, self._load)
        owner, _, connector = self._base.partition("/")
        built = await self._ur10.build(owner, connector, slots)
        for part in built.parts:
            times = {"fetch_time": part.fetch_time, "join_time": part.join_time}
            found.rows.append({"slot": part.slot, "part": part.part, **times, "attempts": part.attempts})
        found.values |= {"build_time": built.duration, "build_energy": self._judge.power().energy - drawn}
        if built.failure:
            raise TaskFailed(f"not built: {built.failure}")
        if self._load:
            self._carried = built.parts[-1].part

    async def use(self) -> Use:
        """The arm that was built, ready to go to its goals."""
        arm = await ArmOperator.found(self._cell, self._session.layout, self._base)
        await arm.ready()
        carried = (self._carried, self._load)
        return Use(self._session, self._task, self._design, arm, carried=carried, found=self._found)

    async def take_apart(self) -> None:
        """Put the modules back into their bins. Raises `TaskFailed`."""
        found, judge = self._found, self._judge
        taken = await Disassembler(self._cell, self._session.layout, self._ur10).run(self._base)
        found.values |= {"take_apart_time": taken.duration, "put_down": float(len(taken.put_down))}
        still = sorted({row.part for row in taken.parts} & set(judge.attached().values()))
        if still:
            raise TaskFailed(f"not taken apart: {', '.join(still)}")


@dataclass(frozen=True, slots=True)
class Way:
    """A free path to a goal, and the motions along it."""

    goal: Goal
    path: JointPath
    motions: tuple[TimedMotion, ...]


class Use:
    """An arm that was built, on its way to the goals of its task; figures go to `found`."""

    def __init__(
        self,
        session: Session,
        task: DesignTask,
        design: Design,
        arm: ArmOperator,
        *,
        carried: tuple[str, float],
        found: Measured,
    ) -> None:
        """`carried` is the part at the tip, and its mass in kilograms; an empty name and zero without one."""
        self._session, self._cell, self._judge = session, session.cell, session.true
        self.arm = arm
        self._task, self._found = task, found
        self._carried, self.load = carried
        self.parts = (*arm.parts, *[self._carried] * bool(self._carried))
        """What moves."""
        self._moving = 0.0
        parts = [(transform(member.offset), member.type) for member in arm.members]
        self._kinematics = ChainKinematics(transform(arm.base), parts)
        wanted = _wanted(self._kinematics, design, session.layout.setup)
        self._wanted = {goal.name: row for goal, row in zip(task.goals, wanted, strict=True)}
        self._motions: list[TimedMotion] = []
        self._missed: list[str] = []

    async def begin(self, watched: Watched) -> None:
        """Put what the sensor sees into the scene, and take the load, if there is one, as the tip reports it.

        `watched` is what the simulation measures of its parts from now on.
        """
        self._watched = watched
        self._begun, self._drawn = self._cell.now(), self._judge.power().energy
        await self.arm.look(*self.parts)
        limits = self._session.layout.setup.limits
        if not self._carried:
            self._chain = LoadedChain(self.arm.base, self.arm.chain, limits)
            return
        type = self._session.layout.type_of(self._carried)
        offset = se3((await self._cell.connector(self.arm.tip)).offset)
        self.arm.scene.hold(self._carried, pieces_of_part(type), offset)
        height = type.solids[0].size[2] / 2.0
        self._chain = LoadedChain(self.arm.base, self.arm.chain, limits, self.load, height)

    async def plan(self, goal: Goal) -> Way:
        """A free path to a goal, each piece of it as fast as modules and connectors bear. Raises `JausError`."""
        q = self._kinematics.solve(goal, self._wanted[goal.name])
        if q is None:
            raise TaskFailed(f"goal {goal.name} cannot be reached by the arm as it was built")
        path = self.arm.planner.to_posture(await self.arm.positions(), q)
        return Way(goal, path, tuple(self._chain.shortest(a, b) for a, b in pairwise(path.points)))

    async def go(self, way: Way) -> None:
        """Move there, and measure where the tip is then."""
        since = self._cell.now()
        for end, motion in zip(way.path.points[1:], way.motions, strict=True):
            await self.arm.move(end, SLACK * motion.duration)
        self._moving += self._cell.now() - since
        self._motions += way.motions
        await self._cell.sleep(REST)
        tip = transform(self._judge.connector(self.arm.tip))
        self._missed += [way.goal.name] * (not way.goal.met(tip))
        self._found.rows.append(_row(way.goal, tip, sum(motion.duration for motion in way.motions)))

    async def finish(self) -> None:
        """State the figures, and move the arm upright. Raises `TaskFailed` if it has not done its task."""
        found, goals = self._found, float(len(self._task.goals))
        found.values |= {
            "cyc": self._moving,
            "time_in_use": self._cell.now() - self._begun,
            "energy_in_use": self._judge.power().energy - self._drawn,
            "effort": sum(motion.effort for motion in self._motions),
            "mechEnergy": sum(motion.energy for motion in self._motions),
            "planned_torque": max(motion.torque for motion in self._motions),
            "planned_connector": max(motion.connector for motion in self._motions),
            "torque": self._watched.torque,
            "clearance": self._watched.clearance,
            "contacts": float(self._watched.contacts),
            "largest_error": max(row["error"] for row in found.rows if "goal" in row),
            "goals_reached": goals - len(self._missed),
            "goals": goals,
        }
        if self._missed:
            raise TaskFailed(f"outside of the tolerance: {', '.join(self._missed)}")
        if self._carried and (held := self._judge.attached().get(self.arm.tip)) != self._carried:
            raise TaskFailed(f"the load was lost: {self.arm.tip} holds {held or 'nothing'}")
        await self.arm.go(np.zeros(self.arm.chain.model.nq), margin=0.0)
        found.values["contacts"] = float(self._watched.contacts)
        if self._watched.contacts:
            raise TaskFailed("the arm or its load touched something")


def _wanted(kinematics: ChainKinematics, design: Design, cell: CellSetup) -> list[Array]:
    """The designed postures for the arm as it was built, in which elbows may be turned by half a turn."""
    rows = [np.array(row) for row in design.positions]
    designed = posture(kinematics.mount, design.elements, cell.types, [0.0] * len(rows[0]))
    senses = _senses(kinematics.axes(), designed)
    return [senses * row for row in rows]


def _senses(axes: Array, designed: ChainPosture) -> Array:
    """1 for joints that turn as designed, -1 for those whose axis points the other way: half a turn of an elbow."""
    return np.array([math.copysign(1.0, axis @ wanted) for axis, (_, wanted) in zip(axes, designed.axes, strict=True)])


def _row(goal: Goal, tip: Transform, duration: float) -> dict[str, Any]:
    """The true error of the tip at a goal."""
    off = projections(goal.pose.inverse() @ tip)
    return {
        "goal": goal.name,
        "met": goal.met(tip),
        "error": off["r_sph"],
        "error_angle": off["Theta_R"] if "Theta_R" in goal.tolerances else None,
        "duration": duration,
    }
