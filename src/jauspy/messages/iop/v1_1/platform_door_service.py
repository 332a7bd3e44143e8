"""urn:jaus:jss:iop:PlatformDoorService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:PlatformDoorService", "1.1")


@jd.message(_SERVICE, 0xD722)
class ReportDoorStatus(jd.Message):
    """ReportDoorStatus (0xD722): Tells the state of the doors.

    lock_status: LockStatus. Whether the doors are locked
    door_ajar: DoorAjar. Whether a door is not fully shut
    """

    class LockStatus(IntEnum):
        UNLOCKED = 0
        LOCKED = 1

    class DoorAjar(IntEnum):
        DOOR_AJAR_FALSE = 0
        DOOR_AJAR_TRUE = 1

    lock_status: ReportDoorStatus.LockStatus | int = jd.field("LockStatus", lambda: jd.Number("B", jd.Values(ReportDoorStatus.LockStatus)))
    door_ajar: ReportDoorStatus.DoorAjar | int = jd.field("DoorAjar", lambda: jd.Number("B", jd.Values(ReportDoorStatus.DoorAjar)))


@jd.message(_SERVICE, 0xD721, query=True)
class QueryDoorStatus(jd.Message):
    """QueryDoorStatus (0xD721): Asks for the state of the doors."""
    REPORT = ReportDoorStatus


@jd.message(_SERVICE, 0xD720, command=True)
class SetDoorLock(jd.Message):
    """SetDoorLock (0xD720): Locks or unlocks the doors.

    lock_state: LockState. What to do with the locks
    """

    class LockState(IntEnum):
        UNLOCK = 0
        LOCK = 1

    lock_state: SetDoorLock.LockState | int = jd.field("LockState", lambda: jd.Number("B", jd.Values(SetDoorLock.LockState)))
