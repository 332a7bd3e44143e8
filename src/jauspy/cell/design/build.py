"""Designs that are built and used: the UR10 joins the modules, the arm goes to the goals, and the judge measures.

Everything is read from the simulation: poses of the tip, clearance and contacts at each step, energy.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Final

import numpy as np

from jauspy.cell.assembly import QUARTERS, Assembler, Slot, Tip, is_straight, slot_goals
from jauspy.cell.design.chains import ChainPosture, Element, posture
from jauspy.cell.design.kinematics import ChainKinematics
from jauspy.cell.design.loads import LoadedChain
from jauspy.cell.design.search import Design
from jauspy.cell.design.tasks import DesignTask, Goal, Obstacle, projections
from jauspy.cell.frames import Array, se3, se3_of_pose, transform
from jauspy.cell.handling import Handling
from jauspy.cell.measurements import Measured
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.motion import MotionPlanner, NoPath
from jauspy.cell.scene import Layout, connector_frame, pieces_of_part
from jauspy.cell.session import ROBOT, Session, simulated
from jauspy.errors import JausError
from jauspy.geometry.poses import Transform
from jauspy.platform.modular.parts import CellSetup, Fixture, PartKind, PartSolid, PartType, PlacedPart, Shape

LOAD: Final = "load"
"""The part, and its type, that the arm carries."""
LOAD_SIDE: Final = 0.07
"""Metres: side of its square base, so that a plate of 30 mm radius lies on it."""
LOAD_DENSITY: Final = 2700.0
"""kg/m^3: aluminium."""
ASIDE: Final = 50.0
"""Metres beside the cell, where obstacles of other tasks are."""
NODES: Final = 60
"""Postures of a detour in a rehearsal: fewer than when it is built, so that what is rehearsed is easy to build."""
SLACK: Final = 1.02
"""Factor of a motion's shortest duration, since it does not begin quite where it was planned to."""
CAMERA: Final = "platforms"
"""The camera that films it."""
REST: Final = 0.5
"""Seconds at a goal until the tip is measured."""


def furnished(cell: CellSetup, tasks: Sequence[DesignTask], base: str, load: float) -> CellSetup:
    """The cell with the obstacles of all tasks, those of the first in place, and with a load on another base."""
    fixtures = [
        _fixture(name, box, aside=number > 0) for number, task in enumerate(tasks) for name, box in _named(number, task)
    ]
    cell = replace(cell, fixtures=(*cell.fixtures, *fixtures))
    if not load:
        return cell
    size = (LOAD_SIDE, LOAD_SIDE, load / LOAD_DENSITY / LOAD_SIDE**2)
    middle = Transform(position=(0.0, 0.0, size[2] / 2.0))
    solid = PartSolid(Shape.CUBOID, size, load, middle)
    top = Transform(((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)), (0.0, 0.0, size[2]))
    type = PartType(LOAD, PartKind.BOX, (solid,), grasp=top)
    return replace(
        cell,
        types={**cell.types, LOAD: type},
        parts=(*cell.parts, PlacedPart(LOAD, LOAD, _shelf(cell, base.partition("/")[0]).to_pose())),
    )


def set_up(session: Session, tasks: Sequence[DesignTask], active: int) -> None:
    """Have the obstacles of one task in place, and those of the others aside, as a person would between tasks."""
    setup = session.layout.setup
    fixtures = {fixture.name: fixture for fixture in setup.fixtures}
    for number, task in enumerate(tasks):
        for name, box in _named(number, task):
            fixtures[name] = _fixture(name, box, aside=number != active)
            session.true.place(name, fixtures[name].pose)
    session.layout.setup = replace(setup, fixtures=tuple(fixtures.values()))


def slots_of(elements: Sequence[Element], types: Mapping[str, PartType], load: float) -> tuple[Slot, ...]:
    """The places of a design, base to tip, and of its load."""
    found, joints = [], 0
    for number, element in enumerate(elements):
        kind = types[element.type]
        joints += kind.servo is not None
        name = f"joint {joints}" if kind.servo is not None else f"part {number + 1}"
        others = QUARTERS if is_straight(kind) else QUARTERS[:1] if kind.servo is None else QUARTERS[:2]
        turns = tuple(element.turn + turn for turn in others)  # half a turn only reverses the axis of an elbow
        found.append(Slot(name, (element.type,), next(iter(kind.connectors)), turns))
    return (*found, Slot(LOAD, (LOAD,), "", QUARTERS)) if load else tuple(found)


def why_not_buildable(layout: Layout, design: Design, base: str, load: float) -> str:
    """Why the UR10 could not join the parts of a design where the file has them; empty if a plan was found."""
    owner, _, connector = base.partition("/")
    ur10 = Rehearsal(layout)
    placed = next(part for part in layout.setup.parts if part.name == owner)
    frame = se3_of_pose(placed.pose) * connector_frame(layout.type_of(owner), connector)
    tip = Tip(base, owner, frame)
    for slot in slots_of(design.elements, layout.setup.types, load):
        reasons = []
        for part in layout.of_types(slot.types):
            if part in ur10.used:
                continue
            try:
                ur10.join(part, slot, tip)
                break
            except NoPath as error:
                reasons.append(f"{part}: {error}")
        else:
            return f"{slot.name}: {'; '.join(reasons) or 'none is left'}"
    return ""


class Rehearsal:
    """Plans of the UR10 without a cell: each part lies where the file has it, and each motion ends as planned."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._scene = layout.scene()
        self._handling = Handling(layout, self._scene, MotionPlanner(self._scene, layout.kinematics, nodes=NODES))
        self._at = layout.home
        self.used: set[str] = set()
        """Parts that are joined."""

    def join(self, part: str, slot: Slot, tip: Tip) -> None:
        """Plan to fetch a part, and to join it to the tip; raises `NoPath`, and then all is as before."""
        handling, goals = self._handling, slot_goals(self._layout, slot, tip)
        lies = self._scene.poses[part]
        picked = handling.pick(part, lies, self._at, goals)
        try:
            place = handling.place(part, picked.grasp, picked.lift.end, goals, touches=[tip.part])
        except NoPath:
            self._scene.release()
            self._scene.put(part, handling.pieces(part), lies)
            raise
        self._scene.release()
        self._scene.put(part, handling.pieces(part), place.goal)
        self.used.add(part)
        self._at = handling.retreat(place.contact.end).end
        type = self._layout.type_of(part)
        if slot.connector in type.connectors:
            tip.advance(part, slot.connector, place.goal, connector_frame(type, slot.connector), slot.turns[0])


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
    """Build and use the designs one after the other, out of the same bins; it ends with the first that is not built."""
    tasks = [task for task, _ in designs]
    results: list[Measured] = []

    def furnish(cell: CellSetup) -> CellSetup:
        return furnished(cell, tasks, base, load)

    async with simulated(seed, film=film, camera=CAMERA, view=view, robot=robot, furnish=furnish) as session:
        for number, (task, design) in enumerate(designs):
            begun, start = time.perf_counter(), session.cell.now()
            if number:
                set_up(session, tasks, number)
            found = Measured(seed, task.name)
            try:
                await build_and_use(session, task, design, base, found, load)
            except JausError as error:
                found.failure = str(error)
            found.success = not found.failure
            found.duration, found.wall = session.cell.now() - start, time.perf_counter() - begun
            results.append(found)
            if not found.success:
                break
    if session.film is not None:
        results[-1].film_problem = session.film.problem
    return results


async def build_and_use(
    session: Session, task: DesignTask, design: Design, base: str, found: Measured, load: float
) -> None:
    """Build a design, go to all goals, and measure. The arm stands upright in the end, with its load."""
    cell, judge = session.cell, session.true
    found.values = {
        "mass": design.costs["mass"],
        "numJ": design.costs["numJ"],
        "designed_cyc": design.costs["cyc"],
        "designed_torque": design.torque,
        "designed_connector": design.moment,
    }
    drawn = judge.power().energy
    ur10 = Assembler(cell, session.layout, seed=found.seed)
    ur10.at = await cell.posture()
    slots = slots_of(design.elements, session.layout.setup.types, load)
    owner, _, connector = base.partition("/")
    built = await ur10.build(owner, connector, slots)
    found.rows = [
        {"slot": row.slot, "part": row.part, "fetch_time": row.fetch_time, "join_time": row.join_time}
        | {"attempts": row.attempts}
        for row in built.parts
    ]
    found.values |= {"build_time": built.duration, "build_energy": judge.power().energy - drawn}
    if built.failure:
        found.failure = f"not built: {built.failure}"
        return
    await ur10.park()
    parts = [row.part for row in built.parts]
    arm = await ArmOperator.found(cell, session.layout, parts[: len(design.elements)], base)
    await arm.ready()
    await _use(session, task, design, arm, found, load)


async def _use(
    session: Session, task: DesignTask, design: Design, arm: ArmOperator, found: Measured, load: float
) -> None:
    """Go to all goals on free paths, each piece as fast as modules and connectors bear."""
    cell, judge = session.cell, session.true
    parts, height = [member.name for member in arm.members], 0.0
    await arm.look(LOAD)
    if load:
        type = session.layout.type_of(LOAD)
        height = type.solids[0].size[2] / 2.0
        arm.scene.hold(LOAD, pieces_of_part(type), se3((await cell.connector(arm.tip)).offset))
        parts.append(LOAD)
    chain = LoadedChain(arm.base, arm.chain, load, height)
    zeros = [0.0] * len(design.positions[0])
    kinematics = ChainKinematics(
        transform(arm.base), [(transform(member.offset), member.type) for member in arm.members]
    )
    senses = _senses(
        kinematics.axes(), posture(transform(arm.base), design.elements, session.layout.setup.types, zeros)
    )
    watched = judge.watch(parts)
    begun, drawn, moving = cell.now(), judge.power().energy, 0.0
    torque = connector = 0.0
    reached = []
    for goal, wanted in zip(task.goals, design.positions, strict=True):
        q = kinematics.solve(goal, senses * np.array(wanted))
        if q is None:
            found.failure = f"goal {goal.name} cannot be reached by the arm as it was built"
            break
        start = await arm.positions()
        try:
            path = arm.planner.to_posture(start, q)
            pieces = [(b, chain.shortest(a, b)) for a, b in pairwise(path.points)]
        except NoPath as error:
            found.failure = f"goal {goal.name}: {error}"
            break
        since = cell.now()
        for end, motion in pieces:
            torque, connector = max(torque, motion.torque), max(connector, motion.connector)
            await arm.move(end, SLACK * motion.duration)
        moving += cell.now() - since
        await cell.sleep(REST)
        tip = transform(judge.connector(arm.tip))
        reached.append(goal.met(tip))
        found.rows.append(_row(goal, tip, sum(motion.duration for _, motion in pieces)))
    found.values |= {
        "cyc": moving,
        "energy_in_use": judge.power().energy - drawn,
        "time_in_use": cell.now() - begun,
        "planned_torque": torque,
        "planned_connector": connector,
        "torque": watched.torque,
        "clearance": watched.clearance,
        "contacts": float(watched.contacts),
        "largest_error": max((row["error"] for row in found.rows if "goal" in row), default=0.0),
        "goals_reached": float(sum(reached)),
        "goals": float(len(task.goals)),
    }
    held = judge.attached()
    if found.failure:
        return
    if load and held.get(arm.tip) != LOAD:
        found.failure = f"the load was lost: {arm.tip} holds {held.get(arm.tip, 'nothing')}"
    elif watched.contacts:
        found.failure = "the arm or its load touched something"
    elif not all(reached):
        missed = [goal.name for goal, met in zip(task.goals, reached, strict=True) if not met]
        found.failure = f"outside of the tolerance: {', '.join(missed)}"
    await arm.go(np.zeros(arm.chain.model.nq))


def _senses(axes: Array, designed: ChainPosture) -> Array:
    """1 for joints that turn as designed, -1 for those whose axis points the other way: half a turn of an elbow."""
    return np.array([math.copysign(1.0, axis @ wanted) for axis, (_, wanted) in zip(axes, designed.axes, strict=True)])


def _row(goal: Goal, tip: Transform, duration: float) -> dict[str, object]:
    """The true error of the tip at a goal."""
    off = projections(goal.pose.inverse() @ tip)
    return {
        "goal": goal.name,
        "met": goal.met(tip),
        "error": off["r_sph"],
        "error_angle": off["Theta_R"] if "Theta_R" in goal.tolerances else None,
        "duration": duration,
    }


def _named(number: int, task: DesignTask) -> list[tuple[str, Obstacle]]:
    return [(f"task_{number + 1}_box_{index + 1}", box) for index, box in enumerate(task.obstacles)]


def _fixture(name: str, box: Obstacle, *, aside: bool) -> Fixture:
    pose = box.pose.to_pose()
    return Fixture(name, (PartSolid(Shape.CUBOID, box.size),), replace(pose, x=pose.x + ASIDE) if aside else pose)


def _shelf(cell: CellSetup, base: str) -> Transform:
    """Where the load is at first: on the first platform that carries no arm."""
    for part in cell.parts:
        if part.fixed and part.name != base:
            kind = cell.types[part.type]
            return Transform.from_pose(part.pose) @ next(iter(kind.connectors.values()))
    raise NoPath(f"there is no platform beside {base} on which a load could be")
