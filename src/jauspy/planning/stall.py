"""A robot that should drive and does not get on."""

from __future__ import annotations

import math
from typing import Final

from jauspy.errors import RequestError
from jauspy.ocu.state import RobotPose

STALL_TIME: Final = 12.0
"""Seconds without progress after which a new way is sought."""
MAX_STALLS: Final = 3
"""Times that the robot stalls before it gives up."""
PROGRESS: Final = 0.1
"""Metres that count as progress."""
PROGRESS_TURN: Final = 0.3
"""Radians that count as progress."""


class Stall:
    """Notices a robot that should drive and does not get on."""

    def __init__(self, now: float) -> None:
        self._pose: RobotPose | None = None
        self._since = now
        self._count = 0

    def is_stalled(self, pose: RobotPose, now: float) -> bool:
        """True once it has neither moved nor turned for `STALL_TIME`."""
        before = self._pose
        if (
            before is None
            or math.dist((before.x, before.y), (pose.x, pose.y)) > PROGRESS
            or abs(math.remainder(before.yaw - pose.yaw, math.tau)) > PROGRESS_TURN
        ):
            self._pose, self._since = pose, now
            return False
        return now - self._since > STALL_TIME

    def count(self, pose: RobotPose, left: float, goal: tuple[float, float]) -> None:
        """Note that the robot is `left` metres from where it was sent; raises `RequestError` if that is too often."""
        self._count += 1
        self._pose = None
        if self._count > MAX_STALLS:
            tilt = math.degrees(max(abs(pose.pitch), abs(pose.roll)))
            tilted = f"; it is tilted by {tilt:.0f} degrees" if tilt > 10.0 else ""
            raise RequestError(
                f"the robot stands {left:.2f} m from ({goal[0]:g}, {goal[1]:g}) and does not get on{tilted}; something "
                "that its sensors do not see may be in the way, or a guard stops it"
            )
