"""The operator of a modular arm: free paths for it in the planning scene, motions over JAUS."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import PARKED
from jauspy.cell.chain import Chain, Member
from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, se3_of_pose
from jauspy.cell.layout import Layout
from jauspy.cell.motion import MotionPlanner, NoPath
from jauspy.cell.scene import Clearance, PlanningScene, connector_frame, pieces_of_part
from jauspy.cell.schedule import TaskFailed
from jauspy.platform.modular.arm import ModularArmState

FIVE_JOINTS: Final = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_4", "servo_5")
"""The parts of the arm with five joints, base to tip, when no part of another type had to be taken."""
SHARE: Final = 0.6
"""Fraction of the joints' speed at which the arm moves between tasks."""
MIN_TIME: Final = 0.6
"""Seconds of the shortest motion."""
POLL: Final = 0.02


class ArmOperator:
    """Moves an arm that stands on a connector. `members` are its parts, base to tip."""

    def __init__(
        self, cell: CellClient, layout: Layout, base: pin.SE3, members: Sequence[Member], ur10: Array = PARKED
    ) -> None:
        self._ur10 = ur10
        self.cell = cell
        self.layout = layout
        self.members = tuple(members)
        self.base = base
        """The frame in the world of the connector that carries the arm at first."""
        self.base_name = ""
        """Its name."""
        self.last_goal: Array = np.zeros(sum(each.type.servo is not None for each in self.members))
        """Where the last motion went."""
        self.clearance = Clearance(1.0)
        self.stand(Chain(base, self.members))
        self.tip = f"{self.members[-1].name}/{self.members[-1].connector}"
        """The connector at the end."""

    def stand(self, chain: Chain) -> None:
        """Plan for the arm standing as this chain does from now on."""
        self.chain = chain
        self.scene = self._make_scene()
        self.planner = MotionPlanner(self.scene, chain, margin=0.01)

    @classmethod
    async def found(
        cls, cell: CellClient, layout: Layout, parts: Sequence[str] = FIVE_JOINTS, base: str = "platform_1/top"
    ) -> ArmOperator:
        """The operator of the arm that stands on a base, by what its connectors report."""
        owner, _, connector = base.partition("/")
        pose = next(se3_of_pose(each.pose) for each in layout.setup.parts if each.name == owner)
        if not any(each.fixed and each.name == owner for each in layout.setup.parts):
            pose = (await cell.observe())[owner].pose
        members, at = [], base
        for part in parts:
            state = await cell.connector(at)
            if state.attached_to != part:
                raise TaskFailed(f"{at} holds {state.attached_to or 'nothing'}, not {part}")
            output = next(iter(layout.type_of(part).connectors))
            members.append(Member(part, layout.type_of(part), se3(state.offset), output))
            at = f"{part}/{output}"
        arm = cls(cell, layout, pose * connector_frame(layout.type_of(owner), connector), members)
        arm.base_name = base
        return arm

    def _make_scene(self) -> PlanningScene:
        """What stands around the arm: the cell without the arm's own parts, and the UR10 at rest."""
        whole = self.layout.scene()
        scene = PlanningScene(self.chain, self.chain.links, wrist=None)
        own = {member.name for member in self.members}
        for name, pose in whole.poses.items():
            if name not in own:
                scene.put(name, whole.pieces(name), pose)
        for link, piece, pose in whole.links_at(self._ur10):
            scene.put(f"ur10 {link}", [piece], pose)
        return scene

    # --- state ----------------------------------------------------------------------------------------------------

    async def state(self) -> ModularArmState:
        """The arm's state, in the order of the chain; raises `TaskFailed` if it has other joints."""
        state = await self.cell.arm()
        if sorted(state.joints) != sorted(self.chain.joints):
            raise TaskFailed(f"the arm has the joints {', '.join(state.joints)}, not {', '.join(self.chain.joints)}")
        return state

    async def positions(self) -> Array:
        """Positions of the joints, base to tip, in radians."""
        state = await self.state()
        return self.ordered(state, state.positions)

    def ordered(self, state: ModularArmState, values: Sequence[float]) -> Array:
        """Values in the order of the controller's joints, in that of the chain."""
        by_name = dict(zip(state.joints, values, strict=True))
        return np.array([by_name[name] for name in self.chain.joints])

    async def ready(self, within: float = 5.0) -> None:
        """Wait until the arm has all its joints; raises `TaskFailed`."""
        until = self.cell.now() + within
        while sorted((await self.cell.arm()).joints) != sorted(self.chain.joints):
            if self.cell.now() > until:
                await self.state()
            await self.cell.sleep(0.1)

    # --- motions --------------------------------------------------------------------------------------------------

    async def look(self, *ignored: str) -> None:
        """Put the parts where the sensor sees them, without the arm's own and those ignored."""
        own = {member.name for member in self.members} | set(ignored)
        for name, seen in (await self.cell.observe()).items():
            if name in own:
                self.scene.remove(name)
            else:
                self.scene.put(name, pieces_of_part(self.layout.type_of(name)), seen.pose)

    async def go(self, goal: Array, *, share: float = SHARE, margin: float | None = None) -> None:
        """Move to a posture on a free path, a motion for each straight piece; raises `NoPath` or `MotionFailed`."""
        start = await self.positions()
        path = self.planner.to_posture(start, goal, margin=margin)
        if path.clearance.distance < self.clearance.distance:
            self.clearance = path.clearance
        for a, b in pairwise(path.points):
            await self.move(b, self.time(a, b, share))

    def time(self, start: Array, goal: Array, share: float) -> float:
        """Seconds for a motion at this fraction of the joints' speed, with smooth ends."""
        return max(MIN_TIME, 1.9 * float(np.max(np.abs(goal - start) / (self.chain.speeds * share))))

    async def move(self, goal: Array, duration: float) -> None:
        """Move straight in joint space, unchecked, and wait until the arm is there."""
        self.last_goal = goal
        await self.cell.move_arm(await self.vector(goal), duration)

    async def vector(self, goal: Array) -> list[float]:
        """Positions in the order in which the arm's controller counts its joints."""
        order = (await self.cell.arm()).joints
        by_name = dict(zip(self.chain.joints, goal.tolist(), strict=True))
        return [by_name.get(name, math.nan) for name in order]

    def above(self, point: Sequence[float], near: Array, direction: Sequence[float] = (0.0, 0.0, -1.0)) -> list[Array]:
        """Free postures with the tip at a point, pointing down, the closest first; raises `NoPath` without one."""
        found = self.chain.pointing(np.array(point), np.array(direction), near)
        if not found:
            raise NoPath(f"the arm cannot point down at {', '.join(f'{each:.2f}' for each in point)}")
        free = [each for each in found if self.scene.is_free(each, 0.0)]
        if not free:
            raise NoPath(f"no posture at the point is free: {self.scene.explain(found[0])}")
        return free

    async def wait_attached(self, connector: str, within: float) -> str:
        """The part that a connector has attached; empty when it has not after `within` seconds."""
        until = self.cell.now() + within
        while True:
            state = await self.cell.connector(connector)
            if state.attached_to or self.cell.now() > until:
                return state.attached_to
            await self.cell.sleep(POLL)
