"""urn:jaus:jss:core:Management 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:core:Management", "1.0")


@jd.message(_SERVICE, 0x0002, command=True)
class Shutdown(jd.Message):
    """Shutdown (0x0002): Makes the component release its resources and stop."""


@jd.message(_SERVICE, 0x0003, command=True)
class Standby(jd.Message):
    """Standby (0x0003): Moves the component from Ready to Standby."""


@jd.message(_SERVICE, 0x0004, command=True)
class Resume(jd.Message):
    """Resume (0x0004): Moves the component from Standby to Ready."""


@jd.message(_SERVICE, 0x0005, command=True)
class Reset(jd.Message):
    """Reset (0x0005): Makes the component initialise again."""


@jd.message(_SERVICE, 0x0006, command=True)
class SetEmergency(jd.Message):
    """SetEmergency (0x0006): Puts the component into the Emergency state; needs no control.

    emergency_code: EmergencyCode. The kind of emergency
    """

    class EmergencyCode(IntEnum):
        STOP = 1

    emergency_code: SetEmergency.EmergencyCode | int = jd.field("EmergencyCode", lambda: jd.Number("H", jd.Values(SetEmergency.EmergencyCode)))


@jd.message(_SERVICE, 0x0007, command=True)
class ClearEmergency(jd.Message):
    """ClearEmergency (0x0007): Ends the emergency that the same client has set.

    emergency_code: EmergencyCode. The kind of emergency
    """

    class EmergencyCode(IntEnum):
        STOP = 1

    emergency_code: ClearEmergency.EmergencyCode | int = jd.field("EmergencyCode", lambda: jd.Number("H", jd.Values(ClearEmergency.EmergencyCode)))


@jd.message(_SERVICE, 0x4002)
class ReportStatus(jd.Message):
    """ReportStatus (0x4002): Tells the state of the component.

    status: Status. The state of the component
    reserved: Sent as 0, ignored when received
    """

    class Status(IntEnum):
        INITIALIZE = 0
        READY = 1
        STANDBY = 2
        SHUTDOWN = 3
        FAILURE = 4
        EMERGENCY = 5

    status: ReportStatus.Status | int = jd.field("Status", lambda: jd.Number("B", jd.Values(ReportStatus.Status)))
    reserved: int = jd.field("Reserved", jd.Number("I"))


@jd.message(_SERVICE, 0x2002, query=True)
class QueryStatus(jd.Message):
    """QueryStatus (0x2002): Asks for the state of the component."""
    REPORT = ReportStatus
