"""urn:jaus:jss:HMI:AnalogControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:HMI:AnalogControl", "1.0")


@jd.message(_SERVICE, 0x4707)
class ReportAnalogDevices(jd.Message):
    """ReportAnalogDevices (0x4707): Tells which controls there are.

    report_analog_devices_list: 0..255 items. The controls
    """

    @jd.record()
    class ReportAnalogDevicesRec(jd.Struct):
        """reference: Number of the control
        name: up to 255 characters. Name of the control, for people
        """
        reference: int = jd.field("Reference", jd.Number("H"))
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))

    report_analog_devices_list: list[ReportAnalogDevices.ReportAnalogDevicesRec] = jd.field("ReportAnalogDevicesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAnalogDevices.ReportAnalogDevicesRec.layout()))


@jd.message(_SERVICE, 0x2707, query=True)
class QueryAnalogDevices(jd.Message):
    """QueryAnalogDevices (0x2707): Asks which controls there are."""
    REPORT = ReportAnalogDevices


@jd.message(_SERVICE, 0x4708, presence="B")
class ReportAnalogAction(jd.Message):
    """ReportAnalogAction (0x4708): Tells the deflection of a control.

    reference: Number of the control
    longitudinal: optional. Deflection forward
    lateral: optional. Deflection to the right
    vertical: optional. Deflection upward
    roll: optional. Rotation about the forward axis
    pitch: optional. Rotation about the axis to the right
    yaw: optional. Rotation about the upward axis
    """

    class LongitudinalChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.LongitudinalChoice)))
    class Longitudinal(jd.Struct):
        """Deflection forward.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.LongitudinalChoice | int
        value: int

    class LateralChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.LateralChoice)))
    class Lateral(jd.Struct):
        """Deflection to the right.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.LateralChoice | int
        value: int

    class VerticalChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.VerticalChoice)))
    class Vertical(jd.Struct):
        """Deflection upward.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.VerticalChoice | int
        value: int

    class RollChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.RollChoice)))
    class Roll(jd.Struct):
        """Rotation about the forward axis.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.RollChoice | int
        value: int

    class PitchChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.PitchChoice)))
    class Pitch(jd.Struct):
        """Rotation about the axis to the right.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.PitchChoice | int
        value: int

    class YawChoice(IntEnum):
        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("b"), 1: jd.Number("h"), 2: jd.Number("i")}, jd.Values(ReportAnalogAction.YawChoice)))
    class Yaw(jd.Struct):
        """Rotation about the upward axis.

        0: one
        1: one
        2: one
        """
        choice: ReportAnalogAction.YawChoice | int
        value: int

    reference: int = jd.field("Reference", jd.Number("H"))
    longitudinal: ReportAnalogAction.Longitudinal | None = jd.field("Longitudinal", lambda: ReportAnalogAction.Longitudinal.layout(), default=None)
    lateral: ReportAnalogAction.Lateral | None = jd.field("Lateral", lambda: ReportAnalogAction.Lateral.layout(), default=None)
    vertical: ReportAnalogAction.Vertical | None = jd.field("Vertical", lambda: ReportAnalogAction.Vertical.layout(), default=None)
    roll: ReportAnalogAction.Roll | None = jd.field("Roll", lambda: ReportAnalogAction.Roll.layout(), default=None)
    pitch: ReportAnalogAction.Pitch | None = jd.field("Pitch", lambda: ReportAnalogAction.Pitch.layout(), default=None)
    yaw: ReportAnalogAction.Yaw | None = jd.field("Yaw", lambda: ReportAnalogAction.Yaw.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2708, query=True)
class QueryAnalogAction(jd.Message):
    """QueryAnalogAction (0x2708): Asks for the deflection of a control.

    presence_vector: Which axes the report is to have, by bit
    analog_reference: Which control is meant
    """
    REPORT = ReportAnalogAction
    presence_vector: int = jd.field("PresenceVector", jd.Number("b"))
    analog_reference: int = jd.field("AnalogReference", jd.Number("H"))
