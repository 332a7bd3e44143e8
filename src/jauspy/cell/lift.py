"""The modular arm takes a box off the moving conveyor and throws it into the marked area."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, shifted
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout, Piece, pieces_of_part
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.throw import MARGIN, PERIOD, Load, ThrowPlan, ThrowPlanner, arm_limits, motion
from jauspy.cell.timed_connector import begin_motion
from jauspy.platform.modular.parts import ConveyorSetup, PartKind, TargetArea

BELT_SPEED: Final = 0.15
"""m/s."""
HOVER: Final = 0.06
"""Metres above the box to which it is lifted."""
RUN: Final = 0.08
LOWERED: Final = 0.0045
"""Metres that the tip moves along the belt before and after it meets the box, and by which it is lowered in each half:
it moves with the box then, so that nothing shears the cup while its vacuum builds up."""
LATENCY: Final = 0.09
"""Seconds by which boxes were ahead of the tip that met them without it: positions arrive late, and motions begin late.
"""
PRESSING: Final = 0.2
"""Seconds from the meeting until the pump runs: the cup lies flat on the box then, which would hang askew otherwise."""
LEAST_WAY: Final = 0.25
"""Metres to the meeting from which on there is time for the run-up."""
LATE: Final = 3.0
"""Seconds after a box should have reached the meeting from which on it does not come: something holds it up."""
LIFT_TIME: Final = 0.8
ATTEMPTS: Final = 3
READY: Final = np.array([0.0, 0.0, 0.6, 0.3, 0.0])
"""Upright, with the elbow bent: between the lift and the throw."""
WINDUP_REST: Final = 0.8
"""Seconds in which the joints come closer to the wind-up than a motion's tolerance: a box that is turned by half a
degree spins about another axis than its own, and lands on a corner."""
SETTLE: Final = 1.5
"""Seconds after the landing, in which a box comes to rest and the sensor sees it several times."""
LARGEST_LESSON: Final = 0.05
"""Metres: of a larger error only that much counts, since a box that has tumbled says little about the aim."""
SCATTER: Final = 0.01
"""Metres by which boxes that land alike come to rest apart; an error farther from the others weighs less."""
POLL: Final = 0.01


@dataclass(slots=True)
class LiftResult:
    """Measurements of one lift and throw."""

    box: str = ""
    attempts: int = 0
    payload: float = 0.0
    """Kilograms, by the arm's estimate."""
    lift_time: float = 0.0
    """Seconds from the start until the box hung on the arm."""
    release_speed: float = 0.0
    """m/s of the box at the release, as planned."""
    rest: tuple[float, float] = (math.nan, math.nan)
    """Metres along x and y where the sensor sees the middle of the box at rest."""
    plan: ThrowPlan | None = None


@dataclass(slots=True)
class Aim:
    """What earlier throws taught: where boxes come to rest, compared with where they were planned to.

    The errors that throws have in common (the arm lags behind its setpoints, the cup vents late, a box slides) are
    corrected; those that differ by chance average out. The estimate is Huber's: a box that has tumbled moves it little.
    """

    errors: list[Array] = field(default_factory=list)
    """Metres along x and y from where each box was planned to rest to where it does."""

    def learn(self, planned: Array, rest: Array) -> None:
        """Take in where a box was planned to rest and where it does, metres along x and y."""
        error = rest - planned
        self.errors.append(error * min(1.0, LARGEST_LESSON / max(1e-9, float(np.linalg.norm(error)))))

    @property
    def bias(self) -> Array:
        """The error that the next throw is expected to have, metres along x and y."""
        if not self.errors:
            return np.zeros(2)
        errors = np.array(self.errors)
        found = np.median(errors, axis=0)
        for _ in range(20):
            off = np.linalg.norm(errors - found, axis=1)
            found = np.average(errors, axis=0, weights=1.0 / np.maximum(1.0, off / SCATTER))
        return np.asarray(found)

    def at(self, goal: Array) -> Array:
        """The point at which to aim so that the box comes to rest at `goal`, metres along x and y."""
        return goal - self.bias


class Lifter:
    """Lifts and throws with an arm that stands beside the conveyor."""

    def __init__(self, cell: CellClient, layout: Layout, arm: ArmOperator, aim: Aim | None = None) -> None:
        self.on_throw: Callable[[str], None] = lambda _: None
        """Called with the box before the wind-up, for measurements."""
        if layout.setup.conveyor is None or layout.setup.target is None:
            raise TaskFailed("the cell has no conveyor, or no area to throw into")
        self.cell = cell
        self.layout = layout
        self.arm = arm
        self.aim = aim or Aim()
        self.planned: ThrowPlan | None = None
        """The last throw, whose postures the next one takes."""
        self.belt: ConveyorSetup = layout.setup.conveyor
        self.target: TargetArea = layout.setup.target
        self.boxes = [part.name for part in layout.setup.parts if layout.type_of(part.name).kind is PartKind.BOX]

    async def run(self) -> LiftResult:
        """Take the next box off the belt, and throw it. Raises `TaskFailed` when no box could be taken."""
        result = LiftResult()
        begun = self.cell.now()
        try:
            tried = set[str]()
            while not result.box:
                left = [box for box in self._in_order() if box not in tried]
                if not left or len(tried) == ATTEMPTS:
                    raise TaskFailed(f"no box could be taken off the belt in {len(tried)} attempts")
                tried.add(left[0])
                if await self._take(left[0]):
                    result.box = left[0]
            result.attempts = len(tried)
        finally:
            await self.cell.run_conveyor(0.0)
        result.lift_time = self.cell.now() - begun
        result.payload = (await self.arm.state()).payload
        await self._throw(result)
        return result

    def _in_order(self) -> list[str]:
        """The boxes that have not passed the arm, the first to arrive first."""
        place = self._place()
        found = []
        for box in self.boxes:
            _, pose = self.cell.latest(box)
            ahead = place[1] - float(pose.translation[1])
            if ahead > LEAST_WAY and abs(float(pose.translation[2]) - self.belt.pose.z) < 0.05:
                found.append((ahead, box))
        return [box for _, box in sorted(found)]

    def _place(self) -> tuple[float, float]:
        """The point where boxes are taken: on the line of the belt, as close to the arm's base as possible."""
        base = self.arm.chain.root
        return self.belt.pose.x, float(base[1])

    async def _take(self, box: str) -> bool:
        """Move along with the box, lower and lower, until the cup holds it."""
        arm, (_, y) = self.arm, self._place()
        _, pose = self.cell.latest(box)
        x, top = float(pose.translation[0]), float(pose.translation[2]) + self.height(box)
        await arm.look(*self.boxes)
        start = arm.above((x, y - RUN, top + LOWERED), await arm.positions())[0]
        end = arm.chain.solve_down((x, y + RUN, top - LOWERED), start)
        raised = arm.chain.solve_down((x, y, top + HOVER), start)
        if end is None or raised is None:
            raise NoPath(f"the arm cannot follow {box}")
        await arm.go(start)
        duration, before, meeting = self._following(start, end)
        await self.cell.run_conveyor(BELT_SPEED)
        until = self.cell.now() + (meeting - float(pose.translation[1])) / BELT_SPEED + LATE
        while True:
            seen, pose = self.cell.latest(box)
            if self.cell.now() > until:
                await self.cell.run_conveyor(0.0)
                return False
            wait = (meeting - float(pose.translation[1])) / BELT_SPEED - (self.cell.now() - seen) - before - LATENCY
            if wait < POLL:
                break
            await self.cell.sleep(min(wait, 0.2))
        await begin_motion(self.cell, await arm.vector(end), duration, arm.tip, before + PRESSING, enabled=True)
        held = await arm.wait_attached(arm.tip, before + PRESSING + duration)
        await self.cell.run_conveyor(0.0)
        await arm.move(raised, LIFT_TIME)
        if held == box and (await self.cell.connector(arm.tip)).attached_to == box:
            return True
        await self.cell.enable(arm.tip, False)
        return False

    def _following(self, start: Array, end: Array) -> tuple[float, float, float]:
        """Seconds of a motion whose largest speed is that of the belt; until it is reached; and y there, metres."""
        chain, limits = self.arm.chain, arm_limits(self.arm.chain)
        duration = 4.0 * RUN / BELT_SPEED
        for _ in range(5):
            moved = motion(start, end, limits, duration)
            speeds = [chain.velocity(q, v)[1] for q, v in zip(moved.q, moved.v, strict=True)]
            duration *= max(speeds) / BELT_SPEED
        middle = int(np.argmax(speeds))
        return moved.duration, (middle + 1) * PERIOD, float(chain.forward(moved.q[middle]).translation[1])

    def height(self, box: str) -> float:
        """Metres from the bottom of a box to its top."""
        return float(self.layout.grasp(box).translation[2])

    # --- throwing -------------------------------------------------------------------------------------------------

    async def _throw(self, result: LiftResult) -> None:
        """Wind up, throw, and recover, on planned motions."""
        arm, box = self.arm, result.box
        self.on_throw(box)
        kind, held = self.layout.type_of(box), await self.cell.connector(arm.tip)
        in_tip = se3(held.offset) * self.layout.grasp(box).inverse()
        arm.scene.hold(box, pieces_of_part(kind), in_tip)
        size = kind.solids[0].size
        middle = shifted(z=self.height(box) / 2.0)
        shapes = [Piece(piece.shape, middle.inverse() * piece.frame) for piece in pieces_of_part(kind)]
        limits = self.layout.setup.limits
        planner = ThrowPlanner(arm.chain, arm.scene, Load(result.payload, size, in_tip * middle), shapes, limits)
        goal = self.aim.at(np.array([self.target.pose.x, self.target.pose.y]))
        plan = await self.cell.compute(lambda: self._plan(planner, np.append(goal, 0.0)))
        self.planned = result.plan = plan
        await arm.go(plan.windup, margin=min(MARGIN, plan.clearance.distance))
        await self.cell.sleep(WINDUP_REST)
        vector = await arm.vector(plan.follow_through)
        await begin_motion(self.cell, vector, plan.duration, arm.tip, plan.release, enabled=False)
        result.release_speed = float(np.linalg.norm(plan.flight.velocity))
        await self.cell.sleep(plan.duration)
        until = self.cell.now() + LATE
        while (await arm.state()).moving and self.cell.now() < until:  # the robot's time may be slower than this clock
            await self.cell.sleep(POLL)
        arm.scene.release()
        await self.cell.sleep(SETTLE)
        await arm.look(box)
        await arm.go(READY + plan.windup[0] * np.eye(5)[0])
        await self._learn(result)

    def _plan(self, planner: ThrowPlanner, aim: Array) -> ThrowPlan:
        """The last throw with another aim, if it keeps all limits, or a new one."""
        if self.planned is not None:
            try:
                return planner.turned(self.planned, aim)
            except NoPath:
                pass
        return planner.plan(aim, self.planned)

    async def _learn(self, result: LiftResult) -> None:
        seen = (await self.cell.observe(fresh=True))[result.box].pose
        at = seen.act(np.array([0.0, 0.0, self.height(result.box) / 2.0]))
        result.rest = float(at[0]), float(at[1])
        size = self.layout.type_of(result.box).solids[0].size
        if at[2] < max(size) / 2.0 + 0.01:  # one that rests on another box teaches nothing
            assert result.plan is not None
            self.aim.learn(result.plan.flight.rest, at[:2])
