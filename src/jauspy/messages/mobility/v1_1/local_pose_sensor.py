"""urn:jaus:jss:mobility:LocalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class SetLocalPose(rt.Message):
    """SetLocalPose (0x0403): Sets the pose that the sensor is to assume as the present one.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x0403
    NAME: ClassVar[str] = "SetLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    x: float | None = None
    y: float | None = None
    z: float | None = None
    position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    attitude_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z", "Z", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("position_rms", "Position_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("yaw", "Yaw", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )


@dataclass(slots=True, repr=False)
class SetLocalPoseExt(rt.Message):
    """SetLocalPoseExt (0x04A3): Sets the present pose, with a wider range and a choice of the vertical datum.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    z_position: optional. Vertical position and its datum
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE: ClassVar[int] = 0x04A3
    NAME: ClassVar[str] = "SetLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    x: float | None = None
    y: float | None = None
    z_position: mobility_v1_0_types.ZPosition | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position", "ZPosition", mobility_v1_0_types.ZPosition.layout(), optional=True),
                rt.Slot("xy_position_rms", "XYPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position_rms", "ZPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("heading", "Heading", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_seconds", "TimeSeconds", rt.Number("I", rt.ANY, "second"), optional=True),
                rt.Slot("time_nano_seconds", "TimeNanoSeconds", rt.Number("I"), optional=True),
            ),
            "H",
        )


@dataclass(slots=True, repr=False)
class QueryLocalPose(rt.Message):
    """QueryLocalPose (0x2403): Asks for the pose.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2403
    NAME: ClassVar[str] = "QueryLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
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
class QueryLocalPoseExt(rt.Message):
    """QueryLocalPoseExt (0x24A3): Asks for the pose in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x24A3
    NAME: ClassVar[str] = "QueryLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
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
class ReportLocalPose(rt.Message):
    """ReportLocalPose (0x4403): Tells the pose.

    x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """

    CODE: ClassVar[int] = 0x4403
    NAME: ClassVar[str] = "ReportLocalPose"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    x: float | None = None
    y: float | None = None
    z: float | None = None
    position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    yaw: float | None = None
    attitude_rms: float | None = None
    time_stamp: core_v1_0_types.TimeStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z", "Z", rt.Real("I", rt.Scaling(-100000.0, 100000.0, 4294967295), "meter"), optional=True),
                rt.Slot("position_rms", "Position_RMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("yaw", "Yaw", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
            ),
            "H",
        )


@dataclass(slots=True, repr=False)
class ReportLocalPoseExt(rt.Message):
    """ReportLocalPoseExt (0x44A3): Tells the pose, with a wider range and several vertical datums.

    x: -20000000..20000000 meter, optional. Position along X, in metres
    y: -20000000..20000000 meter, optional. Position along Y, in metres
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    z_local: -50000..50000 meter, optional. Position along Z of the local frame, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is along X
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE: ClassVar[int] = 0x44A3
    NAME: ClassVar[str] = "ReportLocalPoseExt"
    SERVICE: ClassVar[str] = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    x: float | None = None
    y: float | None = None
    altitude_agl: float | None = None
    altitude_msl: float | None = None
    altitude_asf: float | None = None
    depth: float | None = None
    z_local: float | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    course: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("x", "X", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("y", "Y", rt.Real("I", rt.Scaling(-20000000.0, 20000000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_agl", "AltitudeAGL", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_msl", "AltitudeMSL", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("altitude_asf", "AltitudeASF", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("depth", "Depth", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_local", "ZLocal", rt.Real("I", rt.Scaling(-50000.0, 50000.0, 4294967295), "meter"), optional=True),
                rt.Slot("xy_position_rms", "XYPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("z_position_rms", "ZPositionRMS", rt.Real("I", rt.Scaling(0.0, 100.0, 4294967295), "meter"), optional=True),
                rt.Slot("roll", "Roll", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("pitch", "Pitch", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("heading", "Heading", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("attitude_rms", "Attitude_RMS", rt.Real("H", rt.Scaling(0.0, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("course", "Course", rt.Real("H", rt.Scaling(-3.141592653589793, 3.141592653589793, 65535), "radian"), optional=True),
                rt.Slot("time_seconds", "TimeSeconds", rt.Number("I", rt.ANY, "second"), optional=True),
                rt.Slot("time_nano_seconds", "TimeNanoSeconds", rt.Number("I"), optional=True),
            ),
            "H",
        )
