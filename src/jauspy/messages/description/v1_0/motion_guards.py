"""urn:jauspy:description:MotionGuards 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:description:MotionGuards", "1.0")


@jd.message(_SERVICE, 0xFA82)
class ReportMotionGuards(jd.Message):
    """ReportMotionGuards (0xFA82): The guards that the robot has.

    motion_guard_list: 0..255 items. One for each guard
    """

    class Guard(IntEnum):
        SELF_COLLISION = 0
        OBSTACLE = 1

    class State(IntEnum):
        DISABLED = 0
        ENABLED = 1
        ACTIVE = 2

    @jd.record("B")
    class MotionGuardRec(jd.Struct):
        """guard: Guard. What it guards against
        state: State. Whether it is on, and slows a command down or has stopped it
        distance: 0..1000 meter, optional. Clearance of the nearest pair of links, or from the chassis to the nearest obstacle; left out while nothing is near, or the guard is off
        problem: up to 255 characters, optional. Why it stopped the robot, as a sentence, until a command moves that part again
        """
        guard: ReportMotionGuards.Guard | int = jd.field("Guard", lambda: jd.Number("B", jd.Values(ReportMotionGuards.Guard)))
        state: ReportMotionGuards.State | int = jd.field("State", lambda: jd.Number("B", jd.Values(ReportMotionGuards.State)))
        distance: float | None = jd.field("Distance", jd.real("I", 0.0, 1000.0, "meter"), default=None)
        problem: str | None = jd.field("Problem", jd.Text(count=jd.Count("B", 0, 255)), default=None)
        reserved_presence: int = 0

    motion_guard_list: list[ReportMotionGuards.MotionGuardRec] = jd.field("MotionGuardList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMotionGuards.MotionGuardRec.layout()))


@jd.message(_SERVICE, 0xEA82, query=True)
class QueryMotionGuards(jd.Message):
    """QueryMotionGuards (0xEA82): Asks for the states of all guards."""
    REPORT = ReportMotionGuards
