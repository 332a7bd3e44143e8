"""urn:jaus:jss:HMI:PointingDevice 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:HMI:PointingDevice", "1.0")


@jd.message(_SERVICE, 0x4703)
class ReportPointingDeviceMovement(jd.Message):
    """ReportPointingDeviceMovement (0x4703): Tells the position of the pointer.

    x: Position of the pointer along X
    y: Position of the pointer along Y
    valid: Valid. Whether the position can be used
    """

    class Valid(IntEnum):
        INVALID = 0
        VALID = 1

    x: int = jd.field("X", jd.Number("i"))
    y: int = jd.field("Y", jd.Number("i"))
    valid: ReportPointingDeviceMovement.Valid | int = jd.field("Valid", lambda: jd.Number("b", jd.Values(ReportPointingDeviceMovement.Valid)))


@jd.message(_SERVICE, 0x2703, query=True)
class QueryPointingDeviceMovement(jd.Message):
    """QueryPointingDeviceMovement (0x2703): Asks for the position of the pointer."""
    REPORT = ReportPointingDeviceMovement


@jd.message(_SERVICE, 0x4704)
class ReportPointingDeviceAction(jd.Message):
    """ReportPointingDeviceAction (0x4704): Tells that a button was pressed or released, and where.

    button: Button. Which button was used
    state: State. Whether the button went up or down
    x: Position of the pointer along X
    y: Position of the pointer along Y
    valid: Valid. Whether the position can be used
    """

    class Button(IntEnum):
        LEFT = 0
        MIDDLE = 1
        RIGHT = 2

    class State(IntEnum):
        UP = 0
        DOWN = 1

    class Valid(IntEnum):
        INVALID = 0
        VALID = 1

    button: ReportPointingDeviceAction.Button | int = jd.field("Button", lambda: jd.Number("b", jd.Values(ReportPointingDeviceAction.Button)))
    state: ReportPointingDeviceAction.State | int = jd.field("State", lambda: jd.Number("b", jd.Values(ReportPointingDeviceAction.State)))
    x: int = jd.field("X", jd.Number("i"))
    y: int = jd.field("Y", jd.Number("i"))
    valid: ReportPointingDeviceAction.Valid | int = jd.field("Valid", lambda: jd.Number("b", jd.Values(ReportPointingDeviceAction.Valid)))


@jd.message(_SERVICE, 0x2704, query=True)
class QueryPointingDeviceAction(jd.Message):
    """QueryPointingDeviceAction (0x2704): Asks for the button that was used."""
    REPORT = ReportPointingDeviceAction
