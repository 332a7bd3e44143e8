"""Driving by the reported pose: straight ahead, and on the spot."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Final

from jauspy.errors import RequestError
from jauspy.messages.mobility import ReportLocalPose, ReportVelocityState, SetWrenchEffort
from jauspy.ocu.approach import FORWARD, TURN, Approach
from jauspy.ocu.control import Control
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subscription import Subscription

HEADING_GAIN: Final = 60.0
"""Percent of effort per radian off the straight line."""


@dataclass(frozen=True, slots=True)
class Motion:
    """Where the robot is and what it does: metres and radians in JAUS axes (yaw grows to the right), efforts in %."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    speed: float = 0.0
    yaw_rate: float = 0.0
    linear_effort: float = 0.0
    rotational_effort: float = 0.0


@dataclass(slots=True)
class _Leg:
    left: float = math.nan


class Drive:
    """Steers by the reports, one command for each pose.

    `moved` is told each motion, what is left to the target and its unit (`m` or `rad`); a leg that takes longer than
    `leg_time` seconds ends in `RequestError`.
    """

    def __init__(
        self,
        driver: ServiceClient,
        control: Control,
        poses: Subscription[ReportLocalPose],
        velocities: Subscription[ReportVelocityState],
        *,
        moved: Callable[[Motion, float, str], None],
        leg_time: float,
    ) -> None:
        self._driver = driver
        self._control = control
        self._poses = poses
        self._velocities = velocities
        self._moved = moved
        self._leg_time = leg_time
        self._efforts = (0.0, 0.0)

    async def look(self) -> Motion:
        """The next pose and the latest velocity; raises `ControlRejected` when control is lost."""
        self._control.check()
        pose = await self._poses.get()
        velocity = self._velocities.latest
        return Motion(
            pose.x or 0.0,
            pose.y or 0.0,
            pose.yaw or 0.0,
            (velocity.velocity_x or 0.0) if velocity else 0.0,
            (velocity.yaw_rate or 0.0) if velocity else 0.0,
            *self._efforts,
        )

    async def forward(self, distance: float) -> float:
        """Go straight ahead by `distance` metres; returns the error that is left."""
        start, approach, left = await self.look(), Approach(FORWARD), distance
        async with self._leg(f"{distance:g} m forward") as leg:
            while not approach.arrived:
                now = await self.look()
                dx, dy = now.x - start.x, now.y - start.y
                left = leg.left = distance - (dx * math.cos(start.yaw) + dy * math.sin(start.yaw))
                self._moved(now, left, "m")
                linear = approach.effort(left, now.speed)
                off = math.remainder(start.yaw - now.yaw, math.tau)
                await self._push(linear, HEADING_GAIN * off if linear else 0.0)
        return -left

    async def turn(self, heading: float) -> float:
        """Turn on the spot to `heading` radians, the short way round; returns the error that is left."""
        approach, left = Approach(TURN), 0.0
        async with self._leg("the turn") as leg:
            while not approach.arrived:
                now = await self.look()
                left = leg.left = math.remainder(heading - now.yaw, math.tau)
                self._moved(now, left, "rad")
                await self._push(0.0, approach.effort(left, now.yaw_rate))
        return -left

    @asynccontextmanager
    async def _leg(self, what: str) -> AsyncIterator[_Leg]:
        leg = _Leg()
        try:
            async with asyncio.timeout(self._leg_time) as limit:
                yield leg
        except TimeoutError:
            if not limit.expired():
                raise
            raise RequestError(
                f"{what} took longer than {self._leg_time:g} s, with {leg.left:.2f} to go and efforts of "
                f"{self._efforts[0]:.0f} and {self._efforts[1]:.0f} %; see whether something blocks the robot"
            ) from None

    async def _push(self, linear: float, rotational: float) -> None:
        self._efforts = (linear, rotational)
        await self._driver.send(
            SetWrenchEffort(propulsive_linear_effort_x=linear, propulsive_rotational_effort_z=rotational)
        )
