"""urn:jaus:jss:mobility:VelocityStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class QueryVelocityState(rt.Message):
    """QueryVelocityState (0x2404): Asks for the velocity.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2404
    NAME: ClassVar[str] = "QueryVelocityState"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("presence_vector", "PresenceVector", rt.Number("H")),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryVelocityStateExt(rt.Message):
    """QueryVelocityStateExt (0x24A4): Asks for the velocity in its wider form.

    velocity_var_presence_vector: Which velocity components the report is to have, by bit
    report_velocity_state_ext_rec_presence_vector: Which other fields the report is to have, by bit
    """

    CODE: ClassVar[int] = 0x24A4
    NAME: ClassVar[str] = "QueryVelocityStateExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    velocity_var_presence_vector: int
    report_velocity_state_ext_rec_presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_var_presence_vector", "VelocityVarPresenceVector", rt.Number("B")),
                rt.Slot("report_velocity_state_ext_rec_presence_vector", "ReportVelocityStateExtRecPresenceVector", rt.Number("H")),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportVelocityState(rt.Message):
    """ReportVelocityState (0x4404): Tells the velocity.

    velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..3.14159265359 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x4404
    NAME: ClassVar[str] = "ReportVelocityState"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    velocity_x: float | None = None
    velocity_y: float | None = None
    velocity_z: float | None = None
    velocity_rms: float | None = None
    roll_rate: float | None = None
    pitch_rate: float | None = None
    yaw_rate: float | None = None
    rate_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_x", "Velocity_X", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_y", "Velocity_Y", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_z", "Velocity_Z", rt.Real("I", rt.Scaling(-327.68, 327.67, 4294967295), "meter per second"), optional=True),
                rt.Slot("velocity_rms", "Velocity_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter per second"), optional=True),
                rt.Slot("roll_rate", "RollRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("pitch_rate", "PitchRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("yaw_rate", "YawRate", rt.Real("H", rt.Scaling(-32.768, 32.767, 65535), "radian per second"), optional=True),
                rt.Slot("rate_rms", "Rate_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian per second"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )


@dataclass(slots=True, repr=False)
class ReportVelocityStateExt(rt.Message):
    """ReportVelocityStateExt (0x44A4): Tells the velocity in one of three frames, with speeds and shaft rotation.

    velocity_var: Velocity and its frame
    report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
    """

    CODE: ClassVar[int] = 0x44A4
    NAME: ClassVar[str] = "ReportVelocityStateExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec
    report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("velocity_var", "VelocityVar", rt.Union("B", (mobility_v1_0_types.VelocityVehicleXYZRec.layout(), mobility_v1_0_types.VelocityLocalXYZRec.layout(), mobility_v1_0_types.VelocityNEDRec.layout()))),
                rt.Slot("report_velocity_state_ext_rec", "ReportVelocityStateExtRec", mobility_v1_0_types.ReportVelocityStateExtRec.layout()),
            ),
        )
