"""The modular arm steps from platform to platform and back; a connector is released only when the other end holds."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, se3_of_pose, shifted, turned
from jauspy.cell.modular_arm import PRESS, TOUCH, ArmOperator, Chain, HangingChain
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed

HOVER: Final = 0.05
"""Metres over a connector from which the end is lowered."""
DEEPER: Final = 0.002
"""Metres by which the end is sent further down each time when nothing attaches."""
PRESSES: Final = 4
LOWERING_TIME: Final = 1.5
TOUCH_TIME: Final = 1.5
"""Seconds of the slow motion into contact: at most 7 mm/s."""
ATTACH_TIME: Final = 0.4
RAISED: Final = 0.12
"""Metres to which the free end is raised before the arm stands up."""
SHARE: Final = 0.35
"""Fraction of the joints' speed."""
UPRIGHT_MARGIN: Final = 0.0


@dataclass(slots=True)
class StepResult:
    """Measurements of a step forth and back."""

    steps: int = 0
    times: list[float] = field(default_factory=list)
    """Seconds of each step, from upright to upright."""
    attempts: int = 0
    """Number of further presses until an end held."""
    log: list[str] = field(default_factory=list)
    """Connectors that held when one was released, in order."""


class Stepper:
    """Moves an arm from its platform to another one, and back."""

    def __init__(self, cell: CellClient, layout: Layout, arm: ArmOperator, base: str = "platform_1/top") -> None:
        self.cell = cell
        self.layout = layout
        self.arm = arm
        self.base = base
        self.result = StepResult()

    def frame(self, connector: str) -> pin.SE3:
        """The frame of a platform's connector in the world."""
        owner, _, name = connector.partition("/")
        return self._platform(owner) * connector_frame(self.layout.type_of(owner), name)

    def _platform(self, name: str) -> pin.SE3:
        for part in self.layout.setup.parts:
            if part.name == name and part.fixed:
                return se3_of_pose(part.pose)
        raise TaskFailed(f"there is no platform {name!r} that stands still")

    async def run(self, other: str = "platform_2/top") -> StepResult:
        """Step to the other platform, stand up there, and step back; raises `TaskFailed` while one end holds."""
        begun = self.cell.now()
        await self._to_other(other)
        self.result.times.append(self.cell.now() - begun)
        begun = self.cell.now()
        await self._back(other)
        self.result.times.append(self.cell.now() - begun)
        return self.result

    async def _to_other(self, other: str) -> None:
        arm, there = self.arm, self.frame(other)
        tip, owner = arm.tip, other.partition("/")[0]
        await arm.look()
        start = await arm.positions()
        hover = arm.above((there * shifted(z=HOVER)).translation.tolist(), start)[0]
        await arm.go(hover, share=SHARE)
        await self._lower(there, np.array([0.0, 0.0, -1.0]), hover, tip, owner)
        await self._release(self.base, holds=tip, part=owner)
        held = await self.cell.connector(tip)
        # the connector reports the platform's frame in its own
        platform = self._platform(owner)
        latch = self.layout.type_of(owner).latch
        arm.stand(HangingChain(platform * se3(held.offset).inverse(), arm.members, base_latch=latch))
        await self._stand_up()

    async def _back(self, other: str) -> None:
        arm, there = self.arm, self.frame(self.base)
        first = arm.members[0].name
        start = await arm.positions()
        up = np.array([0.0, 0.0, 1.0])
        hover = arm.above((there * shifted(z=HOVER)).translation.tolist(), start, up.tolist())[0]
        hover = self._facing(hover, there)
        await arm.go(hover, share=SHARE)
        await self._lower(there, up, hover, self.base, first)
        await self._release(arm.tip, holds=self.base, part=first)
        held = await self.cell.connector(self.base)
        arm.members = (replace(arm.members[0], offset=se3(held.offset)), *arm.members[1:])
        latch = self.layout.type_of(self.base.partition("/")[0]).latch
        arm.stand(Chain(there, arm.members, base_latch=latch))
        with arm.scene.without(other.partition("/")[0]):
            await self._stand_up()

    def _facing(self, posture: Array, frame: pin.SE3) -> Array:
        """The posture with the last joint turned so that the free end faces as `frame` does, about its z axis."""
        chain = self.arm.chain
        off = chain.forward(posture).actInv(frame).rotation
        rate = pin.computeFrameJacobian(chain.model, chain.data, posture, chain.tool, pin.LOCAL)[5, -1]
        turn = math.remainder(posture[-1] + math.atan2(off[1, 0], off[0, 0]) / rate, math.tau)
        return np.array([*posture[:-1], turn])

    async def _lower(self, there: pin.SE3, direction: Array, hover: Array, connector: str, part: str) -> None:
        """Lower the free end onto a connector until `connector` holds `part`."""
        chain, start = self.arm.chain, hover
        heights = [TOUCH, *(-PRESS - press * DEEPER for press in range(PRESSES + 1))]
        for number, height in enumerate(heights):
            goal = pin.SE3(turned("x", np.pi).rotation if direction[2] < 0.0 else np.eye(3), there.translation)
            goal.translation = there.translation + np.array([0.0, 0.0, height])
            down = chain.solve_from(goal, start)
            if down is None:
                raise TaskFailed(f"the end of the arm cannot be lowered onto {connector}")
            start = down
            if number == 0:
                await self.arm.move(down, LOWERING_TIME)
                continue
            # pressed on the connector, it need not arrive
            await self.cell.command_arm(await self.arm.vector(down), TOUCH_TIME)
            await self.cell.sleep(TOUCH_TIME)
            self.arm.last_goal = down
            if number == 1:
                await self.cell.enable(connector, True)
            else:
                self.result.attempts += 1
            if await self.arm.wait_attached(connector, ATTACH_TIME) == part:
                return
        state = await self.cell.connector(connector)
        raise TaskFailed(f"{connector} does not hold {part}: {state.last_error or 'nothing attaches'}")

    async def _release(self, connector: str, *, holds: str, part: str) -> None:
        """Release one end, after a further query that the other one holds."""
        state = await self.cell.connector(holds)
        if state.attached_to != part:
            raise TaskFailed(f"{connector} stays enabled: {holds} holds {state.attached_to or 'nothing'}, not {part}")
        if self.layout.locks(holds, part) and not state.latched:
            raise TaskFailed(f"{connector} stays enabled: {holds} has not locked {part}: {state.last_error}")
        self.result.log.append(f"{holds} holds {part} with {state.force:.1f} N; {connector} is released")
        await self.cell.enable(connector, False)
        await self.cell.sleep(0.2)
        if (await self.cell.connector(connector)).attached_to:
            raise TaskFailed(f"{connector} does not let go")
        if (await self.cell.connector(holds)).attached_to != part:
            raise TaskFailed(f"{holds} lost {part} when {connector} let go")
        self.result.steps += 1

    async def _stand_up(self) -> None:
        """Raise the free end straight up, and stand upright."""
        chain = self.arm.chain
        q = await self.arm.positions()
        here = chain.forward(q)
        raised = chain.solve_from(pin.SE3(here.rotation, here.translation + np.array([0.0, 0.0, RAISED])), q)
        if raised is not None:
            await self.arm.move(raised, LOWERING_TIME)
        await self.arm.go(np.zeros(chain.model.nq), share=SHARE, margin=UPRIGHT_MARGIN)
