"""Looking for the can, reaching for it, grasping and lifting it."""

from __future__ import annotations

import asyncio
import math
from pathlib import Path
from typing import Final

from jauspy.cli.demo import plan, sight
from jauspy.cli.demo.arm import Arm
from jauspy.cli.demo.report import Finding
from jauspy.errors import RequestError
from jauspy.geometry.vectors import Vector
from jauspy.ocu.frames import LOCAL, RobotFrames
from jauspy.ocu.robot import ComponentClient
from jauspy.platform.description import RobotModel

CAMERA: Final = "arm"
STILL: Final = "still.jpg"
SLACK: Final = 0.006
"""Metres by which the distance of the fingers may differ from the can's width."""
SCALES: Final = 0.2
"""Kilograms by which the measured weight may be off."""
SINKS: Final = 0.005
"""Metres that the tool may sink while it holds the can."""


class Grasp:
    """The can on the table, the arm that takes it, and the camera that sees both."""

    def __init__(
        self, arm: Arm, frames: RobotFrames, model: RobotModel, camera: ComponentClient, size: tuple[int, int]
    ) -> None:
        """`camera` is the module of the arm's, and `size` that of its pictures."""
        self._arm, self._frames = arm, frames
        self._camera, self._size = camera.service("StillImage"), size
        self._setup = next(camera for camera in model.cameras if camera.name == CAMERA)
        self._can: Vector = plan.CAN
        self._around = (0.0, 0.0, 0.0)
        self._empty = 0.0
        self._grasped: Vector = (0.0, 0.0, 0.0)

    async def look(self, folder: Path) -> Finding:
        """Find the can in the arm camera's picture, and with the arm's pose where it stands."""
        await self._arm.go(0.0, *plan.LOOKS_FROM)
        await asyncio.sleep(plan.SETTLING)
        photo = await self._camera.still(size=self._size, format="jpeg", timeout=plan.CAMERA_TIME)
        (folder / STILL).write_bytes(photo.content)
        frames = await self._frames.read()
        spot = sight.red_spot(sight.picture(photo.content))
        camera = frames.pose(self._setup.link, LOCAL)
        seen = spot and sight.at_height(camera, sight.ray(spot, self._setup.fov), plan.CAN[2])
        if seen is None:
            raise RequestError(f"no red can is in the picture of the camera {CAMERA!r}; see {folder / STILL}")
        self._can = seen
        x, y, z = frames.pose("base_link", LOCAL).inverse().apply(seen)
        self._around = self._arm.hand.around((x, y, z - frames.pose("base_link", LOCAL).position[2]))
        off = math.dist(seen, plan.CAN)
        return Finding(
            "look",
            f"the can is seen {math.hypot(x, y):.2f} m away, {_side(math.atan2(y, x))}, "
            f"{100 * off:.1f} cm from where it was said to be",
            off <= plan.SEARCH,
            {"x": seen[0], "y": seen[1], "from_plan": off},
        )

    async def reach(self) -> Finding:
        """Weigh the empty hand over the can, then go around the can."""
        opened = await self._arm.open_gripper()
        errors = [await self._go(*plan.HIGH), await self._go(*plan.OVER)]
        self._empty = await self._arm.weight()
        errors += [await self._go(*step) for step in plan.APPROACH]
        return Finding(
            "reach",
            f"{len(errors)} poses of five joints, each at most {math.degrees(max(errors)):.2f}° off; "
            f"the fingers are {100 * opened:.1f} cm apart",
            opened > plan.WIDTH,
            {"joint_error": max(errors), "opened": opened},
        )

    async def close(self) -> Finding:
        """Squeeze."""
        width = await self._arm.close_gripper()
        self._grasped = await self._arm.tool()
        return Finding(
            "grasp",
            f"the fingers stop {100 * width:.2f} cm apart, at a can of {100 * plan.WIDTH:g} cm",
            abs(width - plan.WIDTH) <= SLACK,
            {"width": width},
        )

    async def lift(self) -> Finding:
        """Up, hold it, and see that it hangs in the hand: by its weight, and by the fingers, which do not meet."""
        await self._go(*plan.OVER)
        weight = await self._arm.weight() - self._empty
        top = await self._arm.tool()
        await asyncio.sleep(plan.HOLD)
        end, width = await self._arm.tool(), await self._arm.width()
        lifted = min(top[2], end[2]) - self._grasped[2]
        held = abs(width - plan.WIDTH) <= SLACK and abs(weight - plan.WEIGHT) <= SCALES
        return Finding(
            "lift",
            f"{100 * lifted:.1f} cm by the arm's pose, held {plan.HOLD:g} s; the wrist feels {weight:.2f} kg, "
            f"the fingers are {100 * width:.2f} cm apart",
            lifted >= plan.LIFT and held and top[2] - end[2] <= SINKS,
            {"lifted": lifted, "weight": weight, "width": width, "sunk": top[2] - end[2]},
        )

    async def _go(self, farther: float, higher: float) -> float:
        turn, distance, height = self._around
        return await self._arm.go(turn, distance + farther, height + higher)


def _side(bearing: float) -> str:
    return f"{math.degrees(abs(bearing)):.1f}° to the {'left' if bearing > 0.0 else 'right'}"
