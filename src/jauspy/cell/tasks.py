"""The tasks of the cell, each in a fresh one, and what the judge measures of them."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Coroutine, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final, TypeAlias

import numpy as np

from jauspy.cell.ariac.runner import run_seed
from jauspy.cell.assembly import Assembler
from jauspy.cell.car import MOVED, CarTask
from jauspy.cell.disassembly import Disassembler
from jauspy.cell.frames import offset_between, se3_of_pose
from jauspy.cell.interface import GRIPPER
from jauspy.cell.judge import Placement, Watched
from jauspy.cell.kitting import Kitter, drawn_order, score
from jauspy.cell.lift import Lifter
from jauspy.cell.measurements import Measured
from jauspy.cell.modular_arm import FIVE_JOINTS, ArmOperator
from jauspy.cell.physics import Physics
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.session import Disturbances, Session, simulated
from jauspy.cell.standing import all_frames, standing_on
from jauspy.cell.step import Stepper
from jauspy.cell.story import Stage, Told, tell, untold
from jauspy.errors import JausError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Z, rotation_about

BASE: Final = "platform_1/top"
MAX_ARM_ERROR: Final = 0.03
"""Radians by which the arm's joints may be off on the driving car."""
MEAN_MISS: Final = 0.02
"""Metres by which boxes may be off in the mean after some throws have taught the aim; single ones tumble further."""
IN_PLACE: Final = 0.1
"""Metres from a part's place within which it counts as put back."""
SETTLE: Final = 0.1
"""Seconds until a prepared arm is known to all."""


async def ur10_of(session: Session, seed: int = 0) -> Assembler:
    """The UR10 where it is, which knows what stands on the bases; raises `TaskFailed` if its gripper holds a part."""
    cell, layout = session.cell, session.layout
    if held := (await cell.connector(GRIPPER)).attached_to:
        raise TaskFailed(f"the gripper holds {held}, and no task has put it there; release it first")
    ur10 = Assembler(cell, layout, seed=seed)
    ur10.at = await cell.posture()
    ur10.know(await all_frames(cell, layout))
    return ur10


async def prepared(session: Session, parts: Sequence[str] = FIVE_JOINTS, *, heading: float = 0.0) -> ArmOperator:
    """The operator of the arm that stands on the platform; the UR10 parks.

    Without one, in a simulation of this process, `parts` are assembled by writing their positions, which the result
    says; the first is turned by `heading`, in radians. Raises `TaskFailed` when there is no arm, or none with as many
    joints.
    """
    cell, layout = session.cell, session.layout
    if not await standing_on(cell, layout, BASE):
        if session.judge is None:
            raise TaskFailed(f"no arm stands on {BASE}; `jauspy cell assemble` builds one")
        session.judge.prepare(BASE, parts, {parts[0]: Transform(rotation_about(Z, heading))})
        await cell.sleep(SETTLE)
    await (await ur10_of(session)).park()
    arm = await ArmOperator.found(cell, layout, BASE)
    wanted = sum(layout.type_of(part).servo is not None for part in parts)
    if len(arm.chain.joints) != wanted:
        raise TaskFailed(f"the arm on {BASE} has {len(arm.chain.joints)} joints, and {wanted} are needed")
    if held := (await cell.connector(arm.tip)).attached_to:
        raise TaskFailed(f"{arm.tip} holds {held} already")
    await arm.ready()
    return arm


async def assemble(session: Session, seed: int) -> Measured:
    """Build the arm with five joints, and measure how the parts sit."""
    if standing := await standing_on(session.cell, session.layout, BASE):
        raise TaskFailed(f"{BASE} holds {standing[0].part} already; `jauspy cell take-apart` takes it off")
    result = await (await ur10_of(session, seed)).build()
    found = Measured(seed, "assemble", not result.failure, result.failure, result.duration)
    placements = _placements(session)
    for row in result.parts:
        placed = placements.get(row.part)
        line = asdict(row)
        line |= {"error": placed.distance, "error_tilt": placed.tilt, "error_turn": placed.turn} if placed else {}
        found.rows.append(line)
    joined = [placements[row.part] for row in result.parts if row.part in placements]
    found.values = {
        "parts": float(len(joined) if placements else sum(row.joint_force > 0.0 for row in result.parts)),
        "retries": float(result.retries),
        "clearance": result.clearance.distance,
        "largest_error": max((placement.distance for placement in joined), default=0.0),
        "largest_tilt": max((placement.tilt for placement in joined), default=0.0),
        "saved_by_schedule": result.timeline.saved,
    }
    if found.success and placements and len(joined) < len(result.parts):
        found.success = False
        found.failure = f"only {len(joined)} of {len(result.parts)} parts are attached in the end"
    return found


def _placements(session: Session) -> dict[str, Placement]:
    if session.judge is None:
        return {}
    judge = session.judge
    return {part: judge.placement(at, part) for at, part in judge.attached().items() if at != "gripper"}


async def lift(session: Session, seed: int) -> Measured:
    """Take a box off the moving conveyor and throw it; a hit rests in the marked area."""
    begun = session.cell.now()
    arm = await prepared(session)
    lifter = Lifter(session.cell, session.layout, arm)
    watched: list[Watched] = []
    if (judge := session.judge) is not None:
        lifter.on_throw = lambda box: watched.append(judge.watch((*arm.parts, box)))
    result = await lifter.run()
    area = lifter.target
    found = Measured(seed, "lift", duration=session.cell.now() - begun)
    found.values = {
        "attempts": float(result.attempts),
        "payload": result.payload,
        "lift_time": result.lift_time,
        "release_speed": result.release_speed,
        "planned_clearance": arm.clearance.distance,
        "miss": math.dist(result.rest, (area.pose.x, area.pose.y)),
    }
    if (plan := result.plan) is not None:
        found.values["planned_clearance"] = min(arm.clearance.distance, plan.clearance.distance)
        found.values |= {"planned_utilisation": plan.utilisation, "planned_torque": plan.torque_ratio}
    for seen in watched:
        found.values |= {
            "clearance": seen.clearance,
            "contacts": float(seen.contacts),
            "penetration": seen.penetration,
            "servo_speed": seen.speed,
            "servo_torque": seen.torque,
        }
    if session.judge is not None:
        x, y, _ = session.judge.pose(result.box).translation.tolist()
    else:
        x, y = result.rest
    off = x - area.pose.x, y - area.pose.y
    found.values |= {"off_x": off[0], "off_y": off[1]}
    found.success = abs(off[0]) <= area.length / 2.0 and abs(off[1]) <= area.width / 2.0
    if not found.success:
        found.failure = f"{result.box} rests {off[0]:+.2f} m, {off[1]:+.2f} m from the middle of the area"
    if watched and watched[-1].contacts:
        found.success, found.failure = False, f"the arm or {result.box} touched something from the wind-up on"
    return found


THROWS: Final = 10


async def throws(session: Session, seed: int) -> Measured:
    """Throw ten times, each aim corrected by what the throws before taught.

    Boxes are put back on the belt by writing their positions; the rows say so.
    """
    begun = session.cell.now()
    judge = session.true
    arm = await prepared(session)
    lifter = Lifter(session.cell, session.layout, arm)
    area, watched = lifter.target, list[Watched]()
    lifter.on_throw = lambda box: watched.append(judge.watch((*arm.parts, box)))
    found = Measured(seed, "throws")
    errors = []
    for number in range(1, THROWS + 1):
        result = await lifter.run()
        x, y, _ = judge.pose(result.box).act(np.array([0.0, 0.0, lifter.height(result.box) / 2.0]))
        errors.append(math.hypot(x - area.pose.x, y - area.pose.y))
        seen = watched[-1]
        found.rows.append(
            {"throw": number, "box": result.box, "off_x": float(x) - area.pose.x, "off_y": float(y) - area.pose.y}
            | {"error": errors[-1], "clearance": seen.clearance, "contacts": seen.contacts}
            | {"penetration": seen.penetration, "servo_speed": seen.speed}
            | {"planned_load": result.plan.utilisation if result.plan is not None else math.nan}
            | {"after": "parts placed by writing positions"}
        )
        for part in session.layout.setup.parts:
            if part.name in lifter.boxes:
                judge.place(part.name, part.pose)
        await session.cell.sleep(2.0 * SETTLE + 1.0)
    late = errors[THROWS // 2 :]
    found.values = {
        "throws": float(THROWS),
        "first_error": errors[0],
        "mean_error_of_last_half": float(np.mean(late)),
        "largest_error_of_last_half": max(late),
        "clearance": min(row["clearance"] for row in found.rows),
        "contacts": float(sum(row["contacts"] for row in found.rows)),
        "penetration": max(row["penetration"] for row in found.rows),
        "servo_speed": max(row["servo_speed"] for row in found.rows),
    }
    found.duration = session.cell.now() - begun
    found.success = float(np.mean(late)) < MEAN_MISS and not found.values["contacts"]
    if found.values["contacts"]:
        found.failure = "the arm or a box touched something from a wind-up on"
    elif not found.success:
        found.failure = f"the mean error of the last {len(late)} throws is {1000.0 * float(np.mean(late)):.0f} mm"
    return found


async def step(session: Session, seed: int) -> Measured:
    """Step from platform to platform, and back."""
    begun = session.cell.now()
    arm = await prepared(session)
    stepper = Stepper(session.cell, session.layout, arm, BASE)
    result = await stepper.run()
    found = Measured(seed, "step", success=result.steps == 2, duration=session.cell.now() - begun)
    found.values = {
        "steps": float(result.steps),
        "there": result.times[0],
        "back": result.times[1],
        "attempts": float(result.attempts),
        "clearance": arm.clearance.distance,
    }
    found.rows = [{"event": line} for line in result.log]
    if session.judge is not None:
        held = session.judge.attached()
        found.success = found.success and held.get(BASE) == arm.members[0].name and arm.tip not in held
        found.values["placement"] = session.judge.placement(BASE, arm.members[0].name).distance
    return found


async def take_apart(session: Session, seed: int) -> Measured:
    """Take the arm apart, from its tip down, and put its parts back into their bins."""
    begun = session.cell.now()
    arm = await prepared(session, heading=math.pi)  # as the UR10 builds it: grasped from its side
    await arm.look()
    await arm.go(np.zeros(arm.chain.model.nq), margin=0.0)
    ur10 = await ur10_of(session, seed)
    result = await Disassembler(session.cell, session.layout, ur10).run(BASE)
    found = Measured(seed, "take-apart", success=True, duration=session.cell.now() - begun)
    found.rows = [asdict(row) for row in result.parts]
    found.values = {
        "parts": float(len(result.parts)),
        "retries": float(result.retries),
        "put_down": float(len(result.put_down)),
        "clearance": ur10.clearance.distance,
    }
    if (judge := session.judge) is not None:
        taken = {row.part for row in result.parts}
        still = sorted(taken & set(judge.attached().values()))
        homes = {part.name: se3_of_pose(part.pose) for part in session.layout.setup.parts if part.name in taken}
        off = {part: offset_between(judge.pose(part), home)[0] for part, home in homes.items()}
        found.values["largest_error"] = max(off.values(), default=0.0)
        astray = [part for part, distance in off.items() if distance > IN_PLACE]
        if still or astray:
            found.success = False
            found.failure = f"attached: {', '.join(still) or 'none'}; not in their bins: {', '.join(astray) or 'none'}"
    return found


async def car(session: Session, seed: int) -> Measured:
    """Build the car, put it on the conveyor with the arm on top, and drive it off."""
    begun = session.cell.now()
    await prepared(session)
    return await _drive_off(session, seed, "car", begun)


async def whole_car(session: Session, seed: int) -> Measured:
    """Same as `car`, and build the arm, too, after the car stands on the conveyor."""
    return await _drive_off(session, seed, "car", session.cell.now())


async def _drive_off(session: Session, seed: int, task: str, begun: float) -> Measured:
    ur10 = await ur10_of(session, seed)
    car_task = CarTask(session.cell, session.layout, ur10, BASE)
    result = await car_task.run()
    found = Measured(seed, task, duration=session.cell.now() - begun)
    found.rows = [asdict(row) for row in result.parts]
    found.values = {
        "retries": float(sum(len(row.attempts) for row in result.parts) + len(result.failed_grasps)),
        "build_time": result.build_time,
        "load_time": result.load_time,
        "car_force": result.car_force,
        "arm_force": result.arm_force,
        "arm_moment": result.arm_moment,
        "driven": result.driven,
        "arm_motions": float(result.arm_motions),
        "arm_error": result.arm_error,
        "clearance": ur10.clearance.distance,
    }
    found.success = result.driven >= MOVED and result.arm_error < MAX_ARM_ERROR
    if not found.success:
        found.failure = f"the car drove {result.driven:.2f} m, and the arm was {result.arm_error:.3f} rad off"
    if found.success and session.judge is not None:
        found.success = session.judge.attached().get(f"{car_task.car}/top") == car_task.arm.members[0].name
        found.failure = "" if found.success else "the arm does not stand on the car"
    return found


async def kitting(session: Session, seed: int) -> Measured:
    """Fill one order with the UR10 alone."""
    ur10 = await ur10_of(session, seed)
    await ur10.park()
    return await _kitted(session, seed, "kitting", Kitter(session.cell, session.layout, ur10), 0.0)


async def kitting_with_arm(session: Session, seed: int) -> Measured:
    """Have the UR10 build an arm, and fill one order with both; the time of building is measured apart."""
    ur10 = await ur10_of(session, seed)
    built = await ur10.build()
    if built.failure:
        return Measured(seed, "kitting-arm", failure=f"the arm was not built: {built.failure}")
    await ur10.park()
    parts = [row.part for row in built.parts]
    arm = await ArmOperator.found(session.cell, session.layout, BASE)
    await arm.ready()
    ur10.used -= set(parts)  # the arm moves from now on: the sensor reports where its parts are
    ur10.rejected |= set(parts)
    kitter = Kitter(session.cell, session.layout, ur10, arm)
    return await _kitted(session, seed, "kitting-arm", kitter, built.duration)


async def _kitted(session: Session, seed: int, task: str, kitter: Kitter, building: float) -> Measured:
    order = drawn_order(seed)
    await kitter.prepare()
    begun = session.cell.now()
    kit = await kitter.fill(order)
    await session.cell.sleep(0.5)
    judge = session.true
    placed = {}
    for product, part in kit.products:
        off = offset_between(judge.pose(part), kitter.goal(product, part))
        placed[order.index(product)] = off
    points = score(placed, len(order))
    found = Measured(seed, task, success=True, duration=session.cell.now() - begun + building)
    found.values = {
        "score": float(points),
        "most_points": 3.0 * len(order),
        "placed": float(len(placed)),
        "order_time": kit.time,
        "build_time": building,
        "expected_time": kit.share.expected,
        "expected_time_alone": kit.share.alone,
        "boxes_by_arm": float(len(kit.share.by_arm)),
        "saved_by_schedule": kit.timeline.saved,
        "largest_error": max((off[0] for off in placed.values()), default=0.0),
    }
    found.rows = [{"event": line} for line in kit.failures]
    return found


STAGES: Final = (
    Stage("assemble", "The UR10 builds an arm with five joints", assemble),
    Stage("lift", "The arm takes a box off the moving conveyor and throws it", lift),
    Stage("step", "The arm steps to the other platform and back", step),
    Stage("take apart", "The UR10 takes the arm apart and puts its parts back into their bins", take_apart),
    Stage("car", "The UR10 builds the car and the arm anew and puts both together, and they drive off", whole_car),
)
"""The story: each stage begins with what the one before has left."""


async def demo(session: Session, seed: int, told: Told = untold) -> Measured:
    """All tasks in one run, one after the other; nothing is put in place by writing positions."""
    return await tell(session, seed, STAGES, told)


Task: TypeAlias = Callable[[Session, int], Coroutine[Any, Any, Measured]]

TASKS: Final[dict[str, Task]] = {
    "assemble": assemble,
    "lift": lift,
    "throws": throws,
    "step": step,
    "take-apart": take_apart,
    "car": car,
    "demo": demo,
    "kitting": kitting,
    "kitting-arm": kitting_with_arm,
}
"""The tasks that can be run by name."""

OWN_CELLS: Final[dict[str, Callable[..., Coroutine[Any, Any, Measured]]]] = {"ariac": run_seed}
"""Tasks that open a cell of their own: the trials in the style of ARIAC, of which a seed chooses one."""
NAMES: Final = (*TASKS, *OWN_CELLS)

FILMED_BY: Final[dict[str, str]] = {
    "assemble": "platforms",
    "take-apart": "platforms",
    "lift": "target",
    "throws": "target",
    "step": "steps",
    "car": "car",
    "demo": "story",
}
"""The camera of the cell that films a task; others are filmed by the one that sees all of the cell."""


async def run_one(
    task: str,
    seed: int,
    disturbances: Disturbances | None = None,
    *,
    film: Path | None = None,
    view: bool = False,
    run: Task | None = None,
) -> Measured:
    """One run of a task by name, or of `run`; a task that raises is a failure with that reason.

    `film` is a file, `view` opens a window. A film that is incomplete changes nothing else of the result.
    """
    if task in OWN_CELLS:
        return await OWN_CELLS[task](seed, disturbances, film=film, view=view)
    begun = time.process_time()
    camera = FILMED_BY.get(task, "overview")
    async with simulated(seed, disturbances, film=film, camera=camera, view=view) as session:
        start = session.cell.now()
        power = session.judge.power() if session.judge is not None else None
        probe = session.judge.probe() if session.judge is not None else None
        try:
            found = await (run or TASKS[task])(session, seed)
        except JausError as error:
            found = Measured(seed, task, failure=str(error), duration=session.cell.now() - start)
        if session.judge is not None and probe is not None and power is not None:
            found.physics, found.written = Physics.of(probe), session.judge.written
            found.values |= session.judge.drawn_since(power)
    found.cpu = time.process_time() - begun
    if session.film is not None:
        found.film_problem = session.film.problem
    return found
