"""The task to take an arm apart: from its tip down, the UR10 takes each part off and puts it back into its bin."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import GRASPS, Assembler
from jauspy.cell.carrying import INSERT_SPEED
from jauspy.cell.frames import se3_of_pose, shifted
from jauspy.cell.handling import LIFT, PickPlan
from jauspy.cell.interface import Cell
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.slots import PartResult
from jauspy.cell.standing import Joined, base_frame, frames_of, joint_positions, standing_on

ABOVE: Final = 0.002
"""Metres above the floor of its bin from which on a part is pressed down until it is in contact."""
DEEPER: Final = 0.005
"""Metres below that place to which a part is lowered at most."""
ROOM: Final = 0.006
"""Metres that a part must be off others in the place where it is put."""
ASIDE: Final = (0.0, 0.012, -0.012, 0.024, -0.024, 0.04, -0.04)
"""Metres along the bin by which a part is put beside its place when another one is too close."""


@dataclass(slots=True)
class DisassemblyResult:
    """Measurements of taking an arm apart."""

    parts: list[PartResult] = field(default_factory=list)
    """The parts in the order in which they were taken off; `join_time` is that of putting a part into its bin."""
    put_down: list[str] = field(default_factory=list)
    """Parts that lie on the floor, since there was no room in their bins."""
    duration: float = 0.0

    @property
    def retries(self) -> int:
        """Attempts that failed."""
        return sum(len(part.attempts) for part in self.parts)


class Disassembler:
    """Takes apart what stands on a base, at rest."""

    def __init__(self, cell: Cell, layout: Layout, ur10: Assembler) -> None:
        self.cell = cell
        self.layout = layout
        self.ur10 = ur10
        self.result = DisassemblyResult()
        self._homes = {part.name: se3_of_pose(part.pose) for part in layout.setup.parts}
        self._shelves = [
            *(bin.name for bin in layout.setup.bins),
            *(part.name for part in layout.setup.parts if part.fixed),
        ]
        """Things on which parts may lie: bins and platforms."""

    async def run(self, base: str = "platform_1/top") -> DisassemblyResult:
        """Take off all parts, those that carry nothing first. Raises `TaskFailed`, and then keeps what is held."""
        begun = self.cell.now()
        joined = await standing_on(self.cell, self.layout, base)
        if not joined:
            raise TaskFailed(f"nothing stands on {base}")
        positions = await joint_positions(self.cell, self.layout)
        frames = frames_of(self.layout, await base_frame(self.cell, self.layout, base), joined, positions)
        await self.ur10.look()
        self.ur10.stands(frames)
        for item in reversed(joined):
            await self._take_off(item, frames[item.part])
        await self.ur10.go_home()
        self.result.duration = self.cell.now() - begun
        return self.result

    async def _take_off(self, item: Joined, frame: pin.SE3) -> None:
        ur10, part = self.ur10, item.part
        row = PartResult(item.connector, part)
        self.result.parts.append(row)
        begun = self.cell.now()
        await ur10.look()
        owner = item.connector.partition("/")[0]
        for attempt in range(GRASPS):
            plan, places = await self.cell.compute(partial(self._plan, item, frame, owner, attempt))
            why = await ur10.try_grasp(plan, row, release=item.connector)
            if not why:
                break
            row.attempts.append(why)
            if (await self.cell.connector(item.connector)).attached_to != part:
                raise TaskFailed(f"{part} was lost when it was taken off {item.connector}: {why}")
        else:
            raise TaskFailed(f"{part} cannot be taken off {item.connector}: {'; '.join(row.attempts)}")
        row.fetch_time = self.cell.now() - begun
        begun = self.cell.now()
        await self._put_away(part, places, row)
        row.join_time = self.cell.now() - begun

    def _plan(self, item: Joined, frame: pin.SE3, owner: str, skip: int) -> tuple[PickPlan, list[pin.SE3]]:
        """How to grasp a part where it stands, and where to put it then. Raises `TaskFailed`."""
        reasons = []
        for face in self.layout.grasps(item.part):
            places = list(self.places(item.part, face))
            try:
                plan = self.ur10.handling.pick(
                    item.part, frame, self.ur10.at, places, supports=[owner], skip=skip, face=face
                )
            except NoPath as error:
                reasons.append(str(error))
            else:
                return plan, places
        raise TaskFailed(f"{item.part} cannot be taken off {item.connector}: {reasons[0]}")

    def places(self, part: str, face: pin.SE3 | None = None) -> Iterator[pin.SE3]:
        """Frames in the world where a part can lie in its bin, its own place first; none where others are too close.

        The part lies with `face` up, by which the gripper holds it, or as it lay at first.
        """
        scene, pieces, usual = self.ur10.scene, self.ur10.handling.pieces(part), self.layout.grasp(part)
        home = self._homes[part] * usual * (face or usual).inverse()
        length = next(
            (
                frame.rotation[:, 0]
                for bin in self.layout.setup.bins
                if _is_over(frame := se3_of_pose(bin.pose), home, (bin.length, bin.width))
            ),
            np.array([1.0, 0.0, 0.0]),
        )
        kept = scene.poses.get(part)
        scene.remove(part)
        try:
            for along in ASIDE:
                place = shifted(z=ABOVE) * shifted(*(along * length).tolist()) * home
                with scene.without(*self._shelves):
                    free = scene.clearance_of(pieces, place).distance >= ROOM
                if free:
                    yield place
        finally:
            if kept is not None:
                scene.put(part, pieces, kept)

    async def _put_away(self, part: str, places: Iterable[pin.SE3], row: PartResult) -> None:
        """Lower the held part into a free place of its bin, or let it lie on the floor."""
        ur10, held = self.ur10, self.ur10.held
        assert held is not None
        for place in places:
            lower = partial(
                ur10.handling.place,
                part,
                held.grasp,
                ur10.at,
                [place],
                along=shifted(z=LIFT),
                touches=self._shelves,
                press=DEEPER,
            )
            try:
                plan = await self.cell.compute(lower)
            except NoPath as error:
                row.attempts.append(f"{part}: {error}")
                continue
            await ur10.go(plan.transfer)
            await ur10.go(plan.insert, speed=INSERT_SPEED, contact=True)
            await ur10.press(plan.contact)
            await ur10.put_here(part, plan.goal)
            return
        await ur10.put_down(part)
        self.result.put_down.append(part)


def _is_over(bin: pin.SE3, part: pin.SE3, size: tuple[float, float]) -> bool:
    x, y, _ = bin.actInv(part).translation
    return abs(float(x)) < size[0] / 2.0 and abs(float(y)) < size[1] / 2.0
