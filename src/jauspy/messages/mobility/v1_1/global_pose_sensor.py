"""urn:jaus:jss:mobility:GlobalPoseSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import global_pose_sensor as mobility_v1_0_global_pose_sensor
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


class SetGlobalPose(mobility_v1_0_global_pose_sensor.SetGlobalPose):
    """SetGlobalPose (0x0402): Sets the pose on the globe that the sensor is to assume as the present one."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class SetGlobalPoseExt(rt.Message):
    """SetGlobalPoseExt (0x04A2): Sets the present pose on the globe, with a choice of the vertical datum.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    z_position: optional. Vertical position and its datum
    horizontal_rms: 0..100 meter, optional. Root mean square error of latitude and longitude, in metres
    vertical_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE = 0x04A2
    NAME = "SetGlobalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    GlobalZPosition = mobility_v1_0_types.GlobalZPosition

    latitude: float | None = None
    longitude: float | None = None
    z_position: mobility_v1_0_types.GlobalZPosition | None = None
    horizontal_rms: float | None = None
    vertical_rms: float | None = None
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
            ("Latitude", rt.real("I", -90.0, 90.0, "degree"), True),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree"), True),
            ("ZPosition", mobility_v1_0_types.GlobalZPosition.layout(), True),
            ("HorizontalRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("VerticalRMS", rt.real("I", 0.0, 100.0, "meter"), True),
            ("Roll", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Pitch", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Heading", rt.real("H", -3.141592653589793, 3.141592653589793, "radian"), True),
            ("Attitude_RMS", rt.real("H", 0.0, 3.141592653589793, "radian"), True),
            ("TimeSeconds", rt.Number("I", rt.ANY, "second"), True),
            ("TimeNanoSeconds", rt.Number("I"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xA2 or data[1] != 0x04: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (mask,) = _S_H.unpack_from(data, 2)
        packer = _M_SetGlobalPoseExt_0[mask & 0x3]
        raw = iter(packer.unpack_from(data, 4)).__next__
        at = 4 + packer.size
        self.latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
        self.longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
        if mask & 4:
            self.z_position, at = mobility_v1_0_types.GlobalZPosition._read(data, at, nesting)
        else: self.z_position = None
        packer = _M_SetGlobalPoseExt_2[mask & 0x7F8]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        self.horizontal_rms = raw() * 2.3283064370807974e-08 if mask & 8 else None
        self.vertical_rms = raw() * 2.3283064370807974e-08 if mask & 16 else None
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
        out = bytearray(b"\xa2\x04")
        start = len(out)
        out += b"\0\0"
        mask = self.reserved_presence
        if mask & 0x7FF: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if latitude_ is not None:
            mask |= 1
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_3)
            raw.append(latitude_raw_)
        longitude_ = self.longitude
        if longitude_ is not None:
            mask |= 2
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_4)
            raw.append(longitude_raw_)
        out += _M_SetGlobalPoseExt_0[mask & 0x3].pack(*raw)
        z_position_ = self.z_position
        if z_position_ is not None:
            mask |= 4
            if type(z_position_) is not mobility_v1_0_types.GlobalZPosition: raise rt.Reject
            z_position_._write(out)
        raw = []
        horizontal_rms_ = self.horizontal_rms
        if horizontal_rms_ is not None:
            mask |= 8
            if not 0.0 <= horizontal_rms_ <= 100.0: raise rt.Reject
            near = horizontal_rms_ * 42949672.95 + 0.5
            horizontal_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - horizontal_rms_raw_ < 0.9999847412109375: horizontal_rms_raw_ = rt.exact_raw(horizontal_rms_, _R_5)
            raw.append(horizontal_rms_raw_)
        vertical_rms_ = self.vertical_rms
        if vertical_rms_ is not None:
            mask |= 16
            if not 0.0 <= vertical_rms_ <= 100.0: raise rt.Reject
            near = vertical_rms_ * 42949672.95 + 0.5
            vertical_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - vertical_rms_raw_ < 0.9999847412109375: vertical_rms_raw_ = rt.exact_raw(vertical_rms_, _R_5)
            raw.append(vertical_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 32
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 64
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 128
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_6)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 256
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
            raw.append(attitude_rms_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 512
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 1024
            raw.append(time_nano_seconds_)
        out += _M_SetGlobalPoseExt_2[mask & 0x7F8].pack(*raw)
        _S_H.pack_into(out, start, mask)
        return bytes(out)


class SetGeomagneticProperty(mobility_v1_0_global_pose_sensor.SetGeomagneticProperty):
    """SetGeomagneticProperty (0x0412): Sets the magnetic variation at the present place."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"


class QueryGlobalPose(mobility_v1_0_global_pose_sensor.QueryGlobalPose):
    """QueryGlobalPose (0x2402): Asks for the pose on the globe."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportGlobalPose]]


@dataclass(slots=True, repr=False)
class QueryGlobalPoseExt(rt.Message):
    """QueryGlobalPoseExt (0x24A2): Asks for the pose on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x24A2
    NAME = "QueryGlobalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGlobalPoseExt]]

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
        if code != 0x24A2: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x24A2, self.presence_vector)


class QueryGeomagneticProperty(mobility_v1_0_global_pose_sensor.QueryGeomagneticProperty):
    """QueryGeomagneticProperty (0x2412): Asks for the magnetic variation in use."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportGeomagneticProperty]]


class ReportGlobalPose(mobility_v1_0_global_pose_sensor.ReportGlobalPose):
    """ReportGlobalPose (0x4402): Tells the pose on the globe."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportGlobalPoseExt(rt.Message):
    """ReportGlobalPoseExt (0x44A2): Tells the pose on the globe, with several vertical datums, heading and course.

    latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude_agl: -50000..50000 meter, optional. Height above ground, in metres
    altitude_msl: -50000..50000 meter, optional. Height above mean sea level, in metres
    altitude_asf: -50000..50000 meter, optional. Height above the sea floor, in metres
    depth: -50000..50000 meter, optional. Depth below the water surface, in metres
    xy_position_rms: 0..100 meter, optional. Root mean square error of X and Y, in metres
    z_position_rms: 0..100 meter, optional. Root mean square error of the vertical position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    heading: -3.14159265359..3.14159265359 radian, optional. Direction the platform points to, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    course: -3.14159265359..3.14159265359 radian, optional. Direction of travel, in radians; 0 is true north
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """

    CODE = 0x44A2
    NAME = "ReportGlobalPoseExt"
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    latitude: float | None = None
    longitude: float | None = None
    altitude_agl: float | None = None
    altitude_msl: float | None = None
    altitude_asf: float | None = None
    depth: float | None = None
    xy_position_rms: float | None = None
    z_position_rms: float | None = None
    roll: float | None = None
    pitch: float | None = None
    heading: float | None = None
    attitude_rms: float | None = None
    course: float | None = None
    time_seconds: int | None = None
    time_nano_seconds: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "H",
            ("Latitude", rt.real("I", -90.0, 90.0, "degree"), True),
            ("Longitude", rt.real("I", -180.0, 180.0, "degree"), True),
            ("AltitudeAGL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeMSL", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("AltitudeASF", rt.real("I", -50000.0, 50000.0, "meter"), True),
            ("Depth", rt.real("I", -50000.0, 50000.0, "meter"), True),
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
        if code != 0x44A2: raise rt.Reject
        raw = iter(_M_ReportGlobalPoseExt[mask & 0x7FFF].unpack(data)).__next__
        self = rt.new(cls)
        self.latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
        self.longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
        self.altitude_agl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 4 else None
        self.altitude_msl = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 8 else None
        self.altitude_asf = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 16 else None
        self.depth = -50000.0 + raw() * 2.3283064370807974e-05 if mask & 32 else None
        self.xy_position_rms = raw() * 2.3283064370807974e-08 if mask & 64 else None
        self.z_position_rms = raw() * 2.3283064370807974e-08 if mask & 128 else None
        self.roll = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 256 else None
        self.pitch = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 512 else None
        self.heading = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 1024 else None
        self.attitude_rms = raw() * 4.793763109162727e-05 if mask & 2048 else None
        self.course = -3.141592653589793 + raw() * 9.587526218325454e-05 if mask & 4096 else None
        self.time_seconds = raw() if mask & 8192 else None
        self.time_nano_seconds = raw() if mask & 16384 else None
        self.reserved_presence = mask & 0x8000
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x7FFF: raise rt.Reject
        raw: list[int | float | bytes] = []
        latitude_ = self.latitude
        if latitude_ is not None:
            mask |= 1
            if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
            near = latitude_ * 23860929.416666668 + 2147483648.0
            latitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_3)
            raw.append(latitude_raw_)
        longitude_ = self.longitude
        if longitude_ is not None:
            mask |= 2
            if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
            near = longitude_ * 11930464.708333334 + 2147483648.0
            longitude_raw_ = int(near)
            if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_4)
            raw.append(longitude_raw_)
        altitude_agl_ = self.altitude_agl
        if altitude_agl_ is not None:
            mask |= 4
            if not -50000.0 <= altitude_agl_ <= 50000.0: raise rt.Reject
            near = altitude_agl_ * 42949.67295 + 2147483648.0
            altitude_agl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_agl_raw_ < 0.9999847412109375: altitude_agl_raw_ = rt.exact_raw(altitude_agl_, _R_10)
            raw.append(altitude_agl_raw_)
        altitude_msl_ = self.altitude_msl
        if altitude_msl_ is not None:
            mask |= 8
            if not -50000.0 <= altitude_msl_ <= 50000.0: raise rt.Reject
            near = altitude_msl_ * 42949.67295 + 2147483648.0
            altitude_msl_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_msl_raw_ < 0.9999847412109375: altitude_msl_raw_ = rt.exact_raw(altitude_msl_, _R_10)
            raw.append(altitude_msl_raw_)
        altitude_asf_ = self.altitude_asf
        if altitude_asf_ is not None:
            mask |= 16
            if not -50000.0 <= altitude_asf_ <= 50000.0: raise rt.Reject
            near = altitude_asf_ * 42949.67295 + 2147483648.0
            altitude_asf_raw_ = int(near)
            if not 1.52587890625e-05 < near - altitude_asf_raw_ < 0.9999847412109375: altitude_asf_raw_ = rt.exact_raw(altitude_asf_, _R_10)
            raw.append(altitude_asf_raw_)
        depth_ = self.depth
        if depth_ is not None:
            mask |= 32
            if not -50000.0 <= depth_ <= 50000.0: raise rt.Reject
            near = depth_ * 42949.67295 + 2147483648.0
            depth_raw_ = int(near)
            if not 1.52587890625e-05 < near - depth_raw_ < 0.9999847412109375: depth_raw_ = rt.exact_raw(depth_, _R_10)
            raw.append(depth_raw_)
        xy_position_rms_ = self.xy_position_rms
        if xy_position_rms_ is not None:
            mask |= 64
            if not 0.0 <= xy_position_rms_ <= 100.0: raise rt.Reject
            near = xy_position_rms_ * 42949672.95 + 0.5
            xy_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - xy_position_rms_raw_ < 0.9999847412109375: xy_position_rms_raw_ = rt.exact_raw(xy_position_rms_, _R_5)
            raw.append(xy_position_rms_raw_)
        z_position_rms_ = self.z_position_rms
        if z_position_rms_ is not None:
            mask |= 128
            if not 0.0 <= z_position_rms_ <= 100.0: raise rt.Reject
            near = z_position_rms_ * 42949672.95 + 0.5
            z_position_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - z_position_rms_raw_ < 0.9999847412109375: z_position_rms_raw_ = rt.exact_raw(z_position_rms_, _R_5)
            raw.append(z_position_rms_raw_)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 256
            if not -3.141592653589793 <= roll_ <= 3.141592653589793: raise rt.Reject
            near = roll_ * 10430.219195527361 + 32768.0
            roll_raw_ = int(near)
            if not 1.52587890625e-05 < near - roll_raw_ < 0.9999847412109375: roll_raw_ = rt.exact_raw(roll_, _R_6)
            raw.append(roll_raw_)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 512
            if not -3.141592653589793 <= pitch_ <= 3.141592653589793: raise rt.Reject
            near = pitch_ * 10430.219195527361 + 32768.0
            pitch_raw_ = int(near)
            if not 1.52587890625e-05 < near - pitch_raw_ < 0.9999847412109375: pitch_raw_ = rt.exact_raw(pitch_, _R_6)
            raw.append(pitch_raw_)
        heading_ = self.heading
        if heading_ is not None:
            mask |= 1024
            if not -3.141592653589793 <= heading_ <= 3.141592653589793: raise rt.Reject
            near = heading_ * 10430.219195527361 + 32768.0
            heading_raw_ = int(near)
            if not 1.52587890625e-05 < near - heading_raw_ < 0.9999847412109375: heading_raw_ = rt.exact_raw(heading_, _R_6)
            raw.append(heading_raw_)
        attitude_rms_ = self.attitude_rms
        if attitude_rms_ is not None:
            mask |= 2048
            if not 0.0 <= attitude_rms_ <= 3.141592653589793: raise rt.Reject
            near = attitude_rms_ * 20860.438391054722 + 0.5
            attitude_rms_raw_ = int(near)
            if not 1.52587890625e-05 < near - attitude_rms_raw_ < 0.9999847412109375: attitude_rms_raw_ = rt.exact_raw(attitude_rms_, _R_7)
            raw.append(attitude_rms_raw_)
        course_ = self.course
        if course_ is not None:
            mask |= 4096
            if not -3.141592653589793 <= course_ <= 3.141592653589793: raise rt.Reject
            near = course_ * 10430.219195527361 + 32768.0
            course_raw_ = int(near)
            if not 1.52587890625e-05 < near - course_raw_ < 0.9999847412109375: course_raw_ = rt.exact_raw(course_, _R_6)
            raw.append(course_raw_)
        time_seconds_ = self.time_seconds
        if time_seconds_ is not None:
            mask |= 8192
            raw.append(time_seconds_)
        time_nano_seconds_ = self.time_nano_seconds
        if time_nano_seconds_ is not None:
            mask |= 16384
            raw.append(time_nano_seconds_)
        return _M_ReportGlobalPoseExt_pack[mask & 0x7FFF].pack(0x44A2, mask, *raw)


class ReportGeomagneticProperty(mobility_v1_0_global_pose_sensor.ReportGeomagneticProperty):
    """ReportGeomagneticProperty (0x4412): Tells the magnetic variation in use."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:GlobalPoseSensor"
    VERSION = "1.1"


_S_H = rt.Packer("<H")
_M_SetGlobalPoseExt_0 = rt.Masks("", ((1, "I"), (2, "I")))
_M_SetGlobalPoseExt_2 = rt.Masks("", ((8, "I"), (16, "I"), (32, "H"), (64, "H"), (128, "H"), (256, "H"), (512, "I"), (1024, "I")))
_R_3 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_4 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_5 = rt.Scaling(0.0, 100.0, 4294967295)
_R_6 = rt.Scaling(-3.141592653589793, 3.141592653589793, 65535)
_R_7 = rt.Scaling(0.0, 3.141592653589793, 65535)
_S_2H = rt.Packer("<2H")
_M_ReportGlobalPoseExt = rt.Masks("4x", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "I"), (16384, "I")))
_R_10 = rt.Scaling(-50000.0, 50000.0, 4294967295)
_M_ReportGlobalPoseExt_pack = rt.Masks("HH", ((1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "I"), (32, "I"), (64, "I"), (128, "I"), (256, "H"), (512, "H"), (1024, "H"), (2048, "H"), (4096, "H"), (8192, "I"), (16384, "I")))
QueryGlobalPose.REPORT = ReportGlobalPose
QueryGlobalPoseExt.REPORT = ReportGlobalPoseExt
QueryGeomagneticProperty.REPORT = ReportGeomagneticProperty
