"""urn:jaus:jss:mobility:LocalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import local_pose_sensor as mobility_v1_0_local_pose_sensor
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


class SetLocalPose(mobility_v1_0_local_pose_sensor.SetLocalPose):
    """SetLocalPose (0x0403): Sets the pose that the sensor is to assume as the present one."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"


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

    CODE = 0x04A3
    NAME = "SetLocalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    ZPosition = mobility_v1_0_types.ZPosition

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
        return rt.composite(
            cls, "H",
            ("X", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("Y", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("ZPosition", mobility_v1_0_types.ZPosition.layout(), True),
            ("XYPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("ZPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xA3 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, 2)
        packer = _M_SetLocalPoseExt_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, 4)).__next__
        at = 4 + packer.size
        self.x = -20000000.0 + raw() * 0.00931322574832319 if mask & 1 else None
        self.y = -20000000.0 + raw() * 0.00931322574832319 if mask & 2 else None
        if mask & 4:
            self.z_position, at = mobility_v1_0_types.ZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetLocalPoseExt_2[mask & 0x7F8]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.xy_position_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.z_position_rms = raw() * 2.3283064370807974e-08 if mask & 16 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 32 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 64 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 128 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 256 else None
        self.time_seconds = raw() if mask & 512 else None
        self.time_nano_seconds = raw() if mask & 1024 else None
        self.reserved_presence = mask & 0xF800
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xa3\x04")
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_3)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_3)
            raw.append(y_raw_)
        out += _M_SetLocalPoseExt_0[mask & 0x3].pack(*raw)
        z_position_ = self.z_position
        if z_position_ is not None:
            mask |= 4
            if type(z_position_) is not mobility_v1_0_types.ZPosition: raise rt.Reject
            z_position_._write(out)
        raw = []
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 8
            if not 0.0 <= xy_position_rms_ <= 100.0: raise rt.Reject
            near = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_position_rms_raw_ < 0.9999847412109375: xy_position_rms_raw_ = rt.exact_raw(xy_position_rms_, _R_4)
            raw.append(xy_position_rms_raw_)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 16
            if not 0.0 <= z_position_rms_ <= 100.0: raise rt.Reject
            near = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_position_rms_raw_ < 0.9999847412109375: z_position_rms_raw_ = rt.exact_raw(z_position_rms_, _R_4)
            raw.append(z_position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 32
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_5)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 64
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_5)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 128
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_5)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 256
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_6)
            raw.append(attitude_rms_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 512
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 1024
            raw.append(time_nano_seconds_)
        out += _M_SetLocalPoseExt_2[mask & 0x7F8].pack(*raw)
        _S_H.pack_into(out, start, mask)
        return bytes(out)


class QueryLocalPose(mobility_v1_0_local_pose_sensor.QueryLocalPose):
    """QueryLocalPose (0x2403): Asks for the pose."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportLocalPose]]


@dataclass(slots=True, repr=False)
class QueryLocalPoseExt(rt.Message):
    """QueryLocalPoseExt (0x24A3): Asks for the pose in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24A3
    NAME = "QueryLocalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportLocalPoseExt]]

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector = _S_2H.unpack(data)
        if code != 0x24A3: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x24A3, self.presence_vector)


class ReportLocalPose(mobility_v1_0_local_pose_sensor.ReportLocalPose):
    """ReportLocalPose (0x4403): Tells the pose."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"


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

    CODE = 0x44A3
    NAME = "ReportLocalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:LocalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

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
        return rt.composite(
            cls, "H",
            ("X", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("Y", rt.real("I", -20000000.0, 20000000.0, "meter"), True),
            ("AltitudeAGL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeMSL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeASF", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("Depth", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("ZLocal", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("XYPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("ZPositionRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("Course", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_2H.unpack_from(data)
        if code != 0x44A3: raise rt.Reject
        raw = iter(_M_ReportLocalPoseExt[mask & 0xFFFF].unpack(data)).__next__
        self = rt.new(cls)
        self.x = -20000000.0 + raw() * 0.00931322574832319 if mask & 1 else None
        self.y = -20000000.0 + raw() * 0.00931322574832319 if mask & 2 else None
        self.altitude_agl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.altitude_msl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 8 else None
        self.altitude_asf = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 16 else None
        self.depth = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.z_local = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 64 else None
        self.xy_position_rms = raw() * 2.3283064370807974e-08 if mask & 128 else None
        self.z_position_rms = raw() * 2.3283064370807974e-08 if mask & 256 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 512 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 2048 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 4096 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 8192 else None
        self.time_seconds = raw() if mask & 16384 else None
        self.time_nano_seconds = raw() if mask & 32768 else None
        return self

    def _pack(self) -> bytes:
        mask = 0
        raw: list[int | float | bytes] = []
        x_ = self.x
        if x_ is not None:
            mask |= 1
            if not -20000000.0 <= x_ <= 20000000.0: raise rt.Reject
            near = x_ * 107.374182375 + 2147483648.0
            x_raw_ = int(near)
            if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_3)
            raw.append(x_raw_)
        y_ = self.y
        if y_ is not None:
            mask |= 2
            if not -20000000.0 <= y_ <= 20000000.0: raise rt.Reject
            near = y_ * 107.374182375 + 2147483648.0
            y_raw_ = int(near)
            if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_3)
            raw.append(y_raw_)
        altitude_agl_ = self.altitude_agl
        if altitude_agl_ is not None:
            mask |= 4
            if not -50000.0 <= altitude_agl_ <= 50000.0: raise rt.Reject
            near = altitude_agl_ * 42949.67295 + 2147483648.0
            altitude_agl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_agl_raw_ < 0.9999847412109375: altitude_agl_raw_ = rt.exact_raw(altitude_agl_, _R_9)
            raw.append(altitude_agl_raw_)
        altitude_msl_ = self.altitude_msl
        if altitude_msl_ is not None:
            mask |= 8
            if not -50000.0 <= altitude_msl_ <= 50000.0: raise rt.Reject
            near = altitude_msl_ * 42949.67295 + 2147483648.0
            altitude_msl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_msl_raw_ < 0.9999847412109375: altitude_msl_raw_ = rt.exact_raw(altitude_msl_, _R_9)
            raw.append(altitude_msl_raw_)
        altitude_asf_ = self.altitude_asf
        if altitude_asf_ is not None:
            mask |= 16
            if not -50000.0 <= altitude_asf_ <= 50000.0: raise rt.Reject
            near = altitude_asf_ * 42949.67295 + 2147483648.0
            altitude_asf_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_asf_raw_ < 0.9999847412109375: altitude_asf_raw_ = rt.exact_raw(altitude_asf_, _R_9)
            raw.append(altitude_asf_raw_)
        depth_ = self.depth
        if depth_ is not None:
            mask |= 32
            if not -50000.0 <= depth_ <= 50000.0: raise rt.Reject
            near = depth_ * 42949.67295 + 2147483648.0
            depth_raw_ = int(near)
            if not 1.52587890625e-05 < near - depth_raw_ < 0.9999847412109375: depth_raw_ = rt.exact_raw(depth_, _R_9)
            raw.append(depth_raw_)
        z_local_ = self.z_local
        if z_local_ is not None:
            mask |= 64
            if not -50000.0 <= z_local_ <= 50000.0: raise rt.Reject
            near = z_local_ * 42949.67295 + 2147483648.0
            z_local_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_local_raw_ < 0.9999847412109375: z_local_raw_ = rt.exact_raw(z_local_, _R_9)
            raw.append(z_local_raw_)
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 128
            if not 0.0 <= xy_position_rms_ <= 100.0: raise rt.Reject
            near = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_position_rms_raw_ < 0.9999847412109375: xy_position_rms_raw_ = rt.exact_raw(xy_position_rms_, _R_4)
            raw.append(xy_position_rms_raw_)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 256
            if not 0.0 <= z_position_rms_ <= 100.0: raise rt.Reject
            near = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_position_rms_raw_ < 0.9999847412109375: z_position_rms_raw_ = rt.exact_raw(z_position_rms_, _R_4)
            raw.append(z_position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 512
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_5)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 1024
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_5)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 2048
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_5)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 4096
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_6)
            raw.append(attitude_rms_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 8192
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_5)
            raw.append(course_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 16384
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 32768
            raw.append(time_nano_seconds_)
        return _M_ReportLocalPoseExt_pack[mask & 0xFFFF].pack(0x44A3, mask, *raw)


_S_H = rt.Packer("<H")
_M_SetLocalPoseExt_0 = rt.Masks("", ((1, "I"), (2, "I")))
_M_SetLocalPoseExt_2 = rt.Masks("", ((8, "I"), (16, "I"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "I"), (1024, "I")))
_R_3 = rt.Scaling(-20000000.0, 20000000.0, 4294967295)
_R_4 = rt.Scaling(0.0, 100.0, 4294967295)
_R_5 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_6 = rt.Scaling(0.0, 3.141592653589793, 65535)
_S_2H = rt.Packer("<2H")
_M_ReportLocalPoseExt = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "I"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "H"), (16384, "I"), (32768, "I")))
_R_9 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_M_ReportLocalPoseExt_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "I"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "H"), (16384, "I"), (32768, "I")))
QueryLocalPose.REPORT = ReportLocalPose
QueryLocalPoseExt.REPORT = ReportLocalPoseExt
