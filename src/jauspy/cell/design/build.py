"""Designs that are built and used: the UR10 joins the modules, the arm goes to the goals, and the judge measures.

Everything is read from the simulation: poses of the tip, clearance and contacts at each step, energy.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace
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
from jauspy.cell.design.surroundings import LOAD, furnished, set_up
from jauspy.cell.design.tasks import DesignTask, Goal, projections
from jauspy.cell.disassembly import Disassembler
from jauspy.cell.frames import Array, se3, transform
from jauspy.cell.measurements import Measured
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.scene import cell_of, pieces_of_part
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.session import ROBOT, Session, simulated
from jauspy.errors import JausError
from jauspy.geometry.poses import Transform
from jauspy.platform.description import RobotModel

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
            begun, start = time.perf_counter(), session.cell.now()
            if number:
                set_up(session, tasks, number)
            found = Measured(seed, task.name)
            results.append(found)
            try:
                await DesignRun(session, task, design, base, load=load, found=found).run()
            except JausError as error:
                found.failure = found.failure or str(error)
            found.success = not found.failure
            found.duration, found.wall = session.cell.now() - start, time.perf_counter() - begun
            if not found.success:
                break
    if session.film is not None:
        results[-1].film_problem = session.film.problem
    return results


class DesignRun:
    """One design: built, used and taken apart. Figures go to `found`, also those of a run that fails."""

    def __init__(
        self, session: Session, task: DesignTask, design: Design, base: str, *, load: float, found: Measured
    ) -> None:
        self._session, self._cell, self._judge = session, session.cell, session.true
        self._task, self._design, self._base, self._load = task, design, base, load
        self._found = found
        self._ur10 = Assembler(session.cell, session.layout, seed=found.seed)

    async def run(self) -> None:
        """Build it, go to all goals, and take it apart. Raises `JausError` when it cannot be done."""
        design, values, drawn = self._design, self._found.values, self._judge.power().energy
        values |= {"mass": design.costs["mass"], "numJ": design.costs["numJ"], "designed_cyc": design.costs["cyc"]}
        values |= {f"designed_{name}": design.costs[name] for name in ("effort", "mechEnergy")}
        values |= {"designed_torque": design.torque, "designed_connector": design.moment}
        self._ur10.at = await self._cell.posture()
        await self._build()
        arm = await ArmOperator.found(self._cell, self._session.layout, self._base)
        await arm.ready()
        await self._use(arm)
        await self._take_apart()
        values["energy"] = self._judge.power().energy - drawn

    async def _build(self) -> None:
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
        await self._ur10.park()

    async def _use(self, arm: ArmOperator) -> None:
        """Go to all goals on free paths, each piece as fast as modules and connectors bear, and upright again."""
        cell, judge, task, found = self._cell, self._judge, self._task, self._found
        chain = await self._loaded(arm)
        watched = judge.watch([member.name for member in arm.members] + [LOAD] * bool(self._load))
        begun, drawn, moving = cell.now(), judge.power().energy, 0.0
        kinematics = ChainKinematics(
            transform(arm.base), [(transform(member.offset), member.type) for member in arm.members]
        )
        motions: list[TimedMotion] = []
        missed: list[str] = []
        for goal, wanted in zip(task.goals, self._wanted(kinematics), strict=True):
            q = kinematics.solve(goal, wanted)
            if q is None:
                raise TaskFailed(f"goal {goal.name} cannot be reached by the arm as it was built")
            path = arm.planner.to_posture(await arm.positions(), q)
            pieces = [(b, chain.shortest(a, b)) for a, b in pairwise(path.points)]
            since = cell.now()
            for end, motion in pieces:
                await arm.move(end, SLACK * motion.duration)
            moving += cell.now() - since
            motions += [motion for _, motion in pieces]
            await cell.sleep(REST)
            tip = transform(judge.connector(arm.tip))
            missed += [goal.name] * (not goal.met(tip))
            found.rows.append(_row(goal, tip, sum(motion.duration for _, motion in pieces)))
        found.values |= {
            "cyc": moving,
            "time_in_use": cell.now() - begun,
            "energy_in_use": judge.power().energy - drawn,
            "effort": sum(motion.effort for motion in motions),
            "mechEnergy": sum(motion.energy for motion in motions),
            "planned_torque": max(motion.torque for motion in motions),
            "planned_connector": max(motion.connector for motion in motions),
            "torque": watched.torque,
            "clearance": watched.clearance,
            "contacts": float(watched.contacts),
            "largest_error": max(row["error"] for row in found.rows if "goal" in row),
            "goals_reached": float(len(task.goals) - len(missed)),
            "goals": float(len(task.goals)),
        }
        if missed:
            raise TaskFailed(f"outside of the tolerance: {', '.join(missed)}")
        if self._load and (held := judge.attached().get(arm.tip)) != LOAD:
            raise TaskFailed(f"the load was lost: {arm.tip} holds {held or 'nothing'}")
        await arm.go(np.zeros(arm.chain.model.nq), margin=0.0)
        found.values["contacts"] = float(watched.contacts)
        if watched.contacts:
            raise TaskFailed("the arm or its load touched something")

    async def _loaded(self, arm: ArmOperator) -> LoadedChain:
        """The arm as its connectors report it, with its load in the scene, which has what the sensor sees."""
        await arm.look(LOAD)
        limits = self._session.layout.setup.limits
        if not self._load:
            return LoadedChain(arm.base, arm.chain, limits)
        type = self._session.layout.type_of(LOAD)
        arm.scene.hold(LOAD, pieces_of_part(type), se3((await self._cell.connector(arm.tip)).offset))
        return LoadedChain(arm.base, arm.chain, limits, self._load, type.solids[0].size[2] / 2.0)

    def _wanted(self, kinematics: ChainKinematics) -> list[Array]:
        """The designed postures for the arm as it was built, in which elbows may be turned by half a turn."""
        rows = [np.array(row) for row in self._design.positions]
        types = self._session.layout.setup.types
        designed = posture(kinematics.mount, self._design.elements, types, [0.0] * len(rows[0]))
        senses = _senses(kinematics.axes(), designed)
        return [senses * row for row in rows]

    async def _take_apart(self) -> None:
        found, judge = self._found, self._judge
        taken = await Disassembler(self._cell, self._session.layout, self._ur10).run(self._base)
        found.values |= {"take_apart_time": taken.duration, "put_down": float(len(taken.put_down))}
        still = sorted({row.part for row in taken.parts} & set(judge.attached().values()))
        if still:
            raise TaskFailed(f"not taken apart: {', '.join(still)}")


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
