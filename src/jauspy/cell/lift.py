"""The modular arm takes a box off the moving conveyor and throws it into the marked area."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.parts import ConveyorSetup, PartKind, TargetArea

BELT_SPEED: Final = 0.15
"""m/s."""
HOVER: Final = 0.06
"""Metres above the box, in which the arm waits for it."""
PRESS: Final = 0.002
"""Metres below the top of the box to which the tip is sent."""
DESCENT: Final = 0.6
"""Seconds of the descent, at whose end the middle of the box is under the tip."""
LIFT_TIME: Final = 0.6
ATTEMPTS: Final = 3
READY: Final = np.array([0.0, 0.0, 0.6, 0.3, 0.0])
"""Upright, with the elbow bent: between the lift and the throw."""
WINDUP: Final = np.array([0.0, -0.3, -0.7, -0.4, 0.0])
FOLLOW_THROUGH: Final = np.array([0.0, 0.7, 0.6, 0.5, 0.0])
"""Postures between which the arm throws, turned towards the area by the first joint."""
LATENCY: Final = 0.02
"""Seconds from the decision to release to the release."""
SLIDE: Final = 0.0
"""Metres that a box slides and tumbles for each (m/s)^2 of its horizontal speed when it lands."""
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
    """m/s of the tip at the release, by its encoders."""
    predicted: float = math.nan
    """Metres from the middle of the area at which the box was to come to rest."""


class Lifter:
    """Lifts and throws with an arm that stands beside the conveyor."""

    def __init__(self, cell: CellClient, layout: Layout, arm: ArmOperator) -> None:
        if layout.setup.conveyor is None or layout.setup.target is None:
            raise TaskFailed("the cell has no conveyor, or no area to throw into")
        self.cell = cell
        self.layout = layout
        self.arm = arm
        self.belt: ConveyorSetup = layout.setup.conveyor
        self.target: TargetArea = layout.setup.target
        self.boxes = [part.name for part in layout.setup.parts if layout.type_of(part.name).kind is PartKind.BOX]

    async def run(self) -> LiftResult:
        """Take the next box off the belt, and throw it. Raises `TaskFailed` when no box could be taken."""
        result = LiftResult()
        begun = self.cell.now()
        try:
            for box in self._in_order()[:ATTEMPTS]:
                result.attempts += 1
                if await self._take(box):
                    result.box = box
                    break
            else:
                raise TaskFailed(f"no box could be taken off the belt in {result.attempts} attempts")
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
            if ahead > 0.1 and abs(float(pose.translation[2]) - self.belt.pose.z) < 0.05:
                found.append((ahead, box))
        return [box for _, box in sorted(found)]

    def _place(self) -> tuple[float, float]:
        """The point where boxes are taken: on the line of the belt, as close to the arm's base as possible."""
        base = self.arm.chain.root
        return self.belt.pose.x, float(base[1])

    async def _take(self, box: str) -> bool:
        """Wait above the belt, and take the box as it passes."""
        _, y = self._place()
        _, pose = self.cell.latest(box)
        x = float(pose.translation[0])
        top = float(pose.translation[2]) + self._height(box)
        await self.arm.look(*self.boxes)
        hover = self.arm.above((x, y, top + HOVER), await self.arm.positions())[0]
        await self.arm.go(hover)
        down = self.arm.chain.solve_down((x, y, top - PRESS), hover)
        if down is None:
            raise NoPath(f"the arm cannot reach down to {box}")
        await self.cell.run_conveyor(BELT_SPEED)
        while True:
            seen, pose = self.cell.latest(box)
            wait = (y - float(pose.translation[1])) / BELT_SPEED - (self.cell.now() - seen) - DESCENT
            if wait < POLL:
                break
            await self.cell.sleep(min(wait, 0.2))
        await self.cell.enable(self.arm.tip, True)
        await self.cell.command_arm(await self.arm.vector(down), DESCENT)
        held = await self.arm.wait_attached(self.arm.tip, 2.0 * DESCENT)
        await self.arm.move(hover, LIFT_TIME)
        if held == box and (await self.cell.connector(self.arm.tip)).attached_to == box:
            return True
        await self.cell.enable(self.arm.tip, False)
        return False

    def _height(self, box: str) -> float:
        return float(self.layout.grasp(box).translation[2])

    # --- throwing -------------------------------------------------------------------------------------------------

    async def _throw(self, result: LiftResult) -> None:
        base = self.arm.chain.root
        away = np.array([self.target.pose.x - base[0], self.target.pose.y - base[1]])
        far = float(np.linalg.norm(away))
        yaw = math.atan2(away[1], away[0])
        turn = np.array([yaw, 0.0, 0.0, 0.0, 0.0])
        await self.arm.move(READY + turn, 1.5)
        await self.arm.move(WINDUP + turn, 2.0)
        await self.cell.command_arm(await self.arm.vector(FOLLOW_THROUGH + turn), 0.0)
        forward = np.array([away[0], away[1], 0.0]) / far
        height = self._height(result.box) / 2.0
        until, best = self.cell.now() + 3.0, -math.inf
        while self.cell.now() < until:
            state = await self.arm.state()
            q, v = self.arm.ordered(state, state.positions), self.arm.ordered(state, state.velocities)
            tip, speed = self.arm.chain.forward(q), self.arm.chain.velocity(q, v)
            box = tip.translation + height * tip.rotation[:, 2] + LATENCY * speed
            rest = _rest(box - base, speed, forward, height + float(base[2]))
            if rest >= far or (rest < best - 0.01 and best > 0.8 * far):
                break
            best = max(best, rest)
            await self.cell.sleep(POLL)
        await self.cell.enable(self.arm.tip, False)
        result.release_speed, result.predicted = float(np.linalg.norm(speed)), rest - far
        await self.cell.sleep(2.5)


def _rest(place: Array, velocity: Array, forward: Array, drop: float) -> float:
    """Metres along `forward` at which a thrown box comes to rest; `drop`: the base's height above the landing."""
    rise, fall = float(velocity[2]), float(place[2]) + drop
    time = (rise + math.sqrt(max(0.0, rise * rise + 2.0 * GRAVITY * fall))) / GRAVITY
    speed = float(velocity @ forward)
    return float(place @ forward) + speed * time + SLIDE * speed * abs(speed)
