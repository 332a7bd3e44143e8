"""The local frame of JAUS: where the robot started, or as a client has set it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from jauspy.geometry.poses import Pose, wrap_angle
from jauspy.services.mobility.guidance.leg import Point


@dataclass(frozen=True, slots=True)
class Reference:
    """Puts the local frame so that the platform at `raw` reads as `shown`: a shift and a turn about z."""

    raw: Pose
    shown: Pose

    @property
    def turn(self) -> float:
        """From the world's headings to those of the frame, rad."""
        return self.shown.yaw - self.raw.yaw


class LocalFrame:
    """One for all services of a component; all in JAUS axes, m and rad."""

    def __init__(self) -> None:
        self._reference = Reference(Pose(), Pose())

    def set(self, raw: Pose, shown: Pose) -> None:
        """The platform, in the world at `raw`, is at `shown` of the frame from now on."""
        self._reference = Reference(raw, shown)

    def show(self, pose: Pose) -> Pose:
        """A pose in the world, in the frame."""
        reference = self._reference
        x, y = _turned(pose.x - reference.raw.x, pose.y - reference.raw.y, reference.turn)
        return replace(
            pose,
            x=reference.shown.x + x,
            y=reference.shown.y + y,
            z=reference.shown.z + pose.z - reference.raw.z,
            yaw=wrap_angle(pose.yaw + reference.turn),
        )

    def place(self, x: float, y: float) -> Point:
        """Where a point of the frame is in the world."""
        reference = self._reference
        dx, dy = _turned(x - reference.shown.x, y - reference.shown.y, -reference.turn)
        return Point(reference.raw.x + dx, reference.raw.y + dy)

    def heading(self, yaw: float) -> float:
        """A heading of the frame, in the world."""
        return wrap_angle(yaw - self._reference.turn)


def _turned(x: float, y: float, by: float) -> tuple[float, float]:
    return math.cos(by) * x - math.sin(by) * y, math.sin(by) * x + math.cos(by) * y
