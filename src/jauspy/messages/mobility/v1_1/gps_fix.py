"""urn:jaus:jss:mobility:GPSFix 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class RequestGPSFix(rt.Message):
    """RequestGPSFix (0x0428): Makes the receiver find its position anew."""

    CODE = 0x0428
    NAME = "RequestGPSFix"
    SERVICE = "urn:jaus:jss:mobility:GPSFix"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'(\x04': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x0428)


@dataclass(slots=True, repr=False)
class QueryGPSFix(rt.Message):
    """QueryGPSFix (0x2428): Asks for the solution of the receiver."""

    CODE = 0x2428
    NAME = "QueryGPSFix"
    SERVICE = "urn:jaus:jss:mobility:GPSFix"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportGPSFix]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'($': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2428)


@dataclass(slots=True, repr=False)
class ReportGPSFix(rt.Message):
    """ReportGPSFix (0x4428): Tells position, velocity and quality of the solution.

    gps_status_var: optional. Either the least a receiver tells, or more
    """

    CODE = 0x4428
    NAME = "ReportGPSFix"
    SERVICE = "urn:jaus:jss:mobility:GPSFix"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class GPSFixRec(rt.Struct):
        """GPSFixRec.

        gps_fix_time_seconds: in second. Time of the fix: whole seconds
        gps_fix_time_nano_seconds: Time of the fix: nanoseconds of the second
        gps_latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
        gps_longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
        gps_true_course: -180..180 degree, optional. Direction of travel from true north, in degrees
        gps_speed_over_ground: 0..327.67 meter per second, optional. Speed over ground, in metres per second
        """

        gps_fix_time_seconds: int
        gps_fix_time_nano_seconds: int
        gps_latitude: float | None = None
        gps_longitude: float | None = None
        gps_true_course: float | None = None
        gps_speed_over_ground: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("GPSFixTimeSeconds", rt.Number("I", rt.ANY, "second")),
                ("GPSFixTimeNanoSeconds", rt.Number("I")),
                ("GPSLatitude", rt.real("I", -90.0, 90.0, "degree"), True),
                ("GPSLongitude", rt.real("I", -180.0, 180.0, "degree"), True),
                ("GPSTrueCourse", rt.real("I", -180.0, 180.0, "degree"), True),
                ("GPS_SpeedOverGround", rt.real("H", 0.0, 327.67, "meter per second"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportGPSFix_GPSFixRec_0[mask & 0xF]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.gps_fix_time_seconds = raw()
            self.gps_fix_time_nano_seconds = raw()
            self.gps_latitude = -90.0 + raw() * 4.190951586745435e-08 if mask & 1 else None
            self.gps_longitude = -180.0 + raw() * 8.38190317349087e-08 if mask & 2 else None
            self.gps_true_course = -180.0 + raw() * 8.38190317349087e-08 if mask & 4 else None
            self.gps_speed_over_ground = raw() * 0.0049999237048905165 if mask & 8 else None
            self.reserved_presence = mask & 0xF0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0xF: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.gps_fix_time_seconds)
            raw.append(self.gps_fix_time_nano_seconds)
            gps_latitude_ = self.gps_latitude
            if gps_latitude_ is not None:
                mask |= 1
                if not -90.0 <= gps_latitude_ <= 90.0: raise rt.Reject
                near = gps_latitude_ * 23860929.416666668 + 2147483648.0
                gps_latitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_latitude_raw_ < 0.9999847412109375: gps_latitude_raw_ = rt.exact_raw(gps_latitude_, _R_2)
                raw.append(gps_latitude_raw_)
            gps_longitude_ = self.gps_longitude
            if gps_longitude_ is not None:
                mask |= 2
                if not -180.0 <= gps_longitude_ <= 180.0: raise rt.Reject
                near = gps_longitude_ * 11930464.708333334 + 2147483648.0
                gps_longitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_longitude_raw_ < 0.9999847412109375: gps_longitude_raw_ = rt.exact_raw(gps_longitude_, _R_3)
                raw.append(gps_longitude_raw_)
            gps_true_course_ = self.gps_true_course
            if gps_true_course_ is not None:
                mask |= 4
                if not -180.0 <= gps_true_course_ <= 180.0: raise rt.Reject
                near = gps_true_course_ * 11930464.708333334 + 2147483648.0
                gps_true_course_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_true_course_raw_ < 0.9999847412109375: gps_true_course_raw_ = rt.exact_raw(gps_true_course_, _R_3)
                raw.append(gps_true_course_raw_)
            gps_speed_over_ground_ = self.gps_speed_over_ground
            if gps_speed_over_ground_ is not None:
                mask |= 8
                if not 0.0 <= gps_speed_over_ground_ <= 327.67: raise rt.Reject
                near = gps_speed_over_ground_ * 200.0030518509476 + 0.5
                gps_speed_over_ground_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_speed_over_ground_raw_ < 0.9999847412109375: gps_speed_over_ground_raw_ = rt.exact_raw(gps_speed_over_ground_, _R_4)
                raw.append(gps_speed_over_ground_raw_)
            out += _M_ReportGPSFix_GPSFixRec_0[mask & 0xF].pack(*raw)
            _S_B.pack_into(out, start, mask)

    class GPSValidity(IntEnum):
        """Values of GPSValidity."""

        INVALID = 0
        VALID = 1

    @dataclass(slots=True, repr=False)
    class MinGPSRec(rt.Struct):
        """What every receiver tells.

        gps_validity: GPSValidity. Whether the solution is valid
        gps_magnetic_variation: -90..90 degree. Angle from true to magnetic north, in degrees; positive to the east
        """

        gps_validity: ReportGPSFix.GPSValidity | int
        gps_magnetic_variation: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GPSValidity", rt.Number("B", rt.Values(ReportGPSFix.GPSValidity))),
                ("GPSMagneticVariation", rt.real("I", -90.0, 90.0, "degree")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            gps_validity_, gps_magnetic_variation_ = _S_BI.unpack_from(data, at)
            self.gps_validity = _E_ReportGPSFix_GPSValidity[gps_validity_]
            self.gps_magnetic_variation = -90.0 + gps_magnetic_variation_ * 4.190951586745435e-08
            return self, at + 5

        def _write(self, out: bytearray) -> None:
            gps_validity_ = self.gps_validity
            if gps_validity_ not in _E_ReportGPSFix_GPSValidity: raise rt.Reject
            gps_magnetic_variation_ = self.gps_magnetic_variation
            if not -90.0 <= gps_magnetic_variation_ <= 90.0: raise rt.Reject
            near = gps_magnetic_variation_ * 23860929.416666668 + 2147483648.0
            gps_magnetic_variation_raw_ = int(near)
            if not 1.52587890625e-05 < near - gps_magnetic_variation_raw_ < 0.9999847412109375: gps_magnetic_variation_raw_ = rt.exact_raw(gps_magnetic_variation_, _R_2)
            out += _S_BI.pack(gps_validity_, gps_magnetic_variation_raw_)

    class GPSStatus(IntEnum):
        """Values of GPSStatus."""

        OPTIMAL_GPS_SIGNAL = 0
        GOOD_GPS_SIGNAL = 1
        MINIMAL_GPS_SIGNAL = 2
        NO_GPS_SIGNAL = 3

    class GPSFixCommandStatus(IntEnum):
        """Values of GPSFixCommandStatus."""

        STABLE_GPS_FIX = 0
        INITIATING_GPS_FIX = 1
        PERFORMING_GPS_FIX = 2

    class GPSLatLonValid(IntEnum):
        """Values of GPSLatLonValid."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False)
    class AltGPSRec(rt.Struct):
        """What better receivers tell.

        gps_status: GPSStatus. Quality of the signal
        gps_fix_command_status: GPSFixCommandStatus. Whether a new fix is wanted, under way or done
        gps_lat_lon_valid: GPSLatLonValid. Whether latitude and longitude are valid
        gps_velocity_east: -327.68..327.67 meter per second, optional. Velocity to the east, in metres per second
        gps_velocity_north: -327.68..327.67 meter per second, optional. Velocity to the north, in metres per second
        gps_velocity_down: -327.68..327.67 meter per second, optional. Velocity down, in metres per second
        gps_altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
        number_of_satellites_seen: optional. Number of satellites in view
        number_of_satellites_in_solution: optional. Number of satellites in use
        """

        gps_status: ReportGPSFix.GPSStatus | int
        gps_fix_command_status: ReportGPSFix.GPSFixCommandStatus | int
        gps_lat_lon_valid: ReportGPSFix.GPSLatLonValid | int
        gps_velocity_east: float | None = None
        gps_velocity_north: float | None = None
        gps_velocity_down: float | None = None
        gps_altitude: float | None = None
        number_of_satellites_seen: int | None = None
        number_of_satellites_in_solution: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("GPSStatus", rt.Number("B", rt.Values(ReportGPSFix.GPSStatus))),
                ("GPSFixCommandStatus", rt.Number("B", rt.Values(ReportGPSFix.GPSFixCommandStatus))),
                ("GPSLatLonValid", rt.Number("B", rt.Values(ReportGPSFix.GPSLatLonValid))),
                ("GPSVelocityEast", rt.real("I", -327.68, 327.67, "meter per second"), True),
                ("GPSVelocityNorth", rt.real("I", -327.68, 327.67, "meter per second"), True),
                ("GPSVelocityDown", rt.real("I", -327.68, 327.67, "meter per second"), True),
                ("GPSAltitude", rt.real("I", -10000.0, 35000.0, "meter"), True),
                ("NumberOfSatellitesSeen", rt.Number("B"), True),
                ("NumberOfSatellitesInSolution", rt.Number("B"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportGPSFix_AltGPSRec_0[mask & 0x3F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            gps_status_ = raw()
            self.gps_status = _E_ReportGPSFix_GPSStatus[gps_status_]
            gps_fix_command_status_ = raw()
            self.gps_fix_command_status = _E_ReportGPSFix_GPSFixCommandStatus[gps_fix_command_status_]
            gps_lat_lon_valid_ = raw()
            self.gps_lat_lon_valid = _E_ReportGPSFix_GPSLatLonValid[gps_lat_lon_valid_]
            self.gps_velocity_east = -327.68 + raw() * 1.5258556235409007e-07 if mask & 1 else None
            self.gps_velocity_north = -327.68 + raw() * 1.5258556235409007e-07 if mask & 2 else None
            self.gps_velocity_down = -327.68 + raw() * 1.5258556235409007e-07 if mask & 4 else None
            self.gps_altitude = -10000.0 + raw() * 1.0477378966863588e-05 if mask & 8 else None
            self.number_of_satellites_seen = raw() if mask & 16 else None
            self.number_of_satellites_in_solution = raw() if mask & 32 else None
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
            raw: list[int | float | bytes] = []
            gps_status_ = self.gps_status
            if gps_status_ not in _E_ReportGPSFix_GPSStatus: raise rt.Reject
            raw.append(gps_status_)
            gps_fix_command_status_ = self.gps_fix_command_status
            if gps_fix_command_status_ not in _E_ReportGPSFix_GPSFixCommandStatus: raise rt.Reject
            raw.append(gps_fix_command_status_)
            gps_lat_lon_valid_ = self.gps_lat_lon_valid
            if gps_lat_lon_valid_ not in _E_ReportGPSFix_GPSLatLonValid: raise rt.Reject
            raw.append(gps_lat_lon_valid_)
            gps_velocity_east_ = self.gps_velocity_east
            if gps_velocity_east_ is not None:
                mask |= 1
                if not -327.68 <= gps_velocity_east_ <= 327.67: raise rt.Reject
                near = gps_velocity_east_ * 6553700.0 + 2147516416.5
                gps_velocity_east_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_velocity_east_raw_ < 0.9999847412109375: gps_velocity_east_raw_ = rt.exact_raw(gps_velocity_east_, _R_12)
                raw.append(gps_velocity_east_raw_)
            gps_velocity_north_ = self.gps_velocity_north
            if gps_velocity_north_ is not None:
                mask |= 2
                if not -327.68 <= gps_velocity_north_ <= 327.67: raise rt.Reject
                near = gps_velocity_north_ * 6553700.0 + 2147516416.5
                gps_velocity_north_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_velocity_north_raw_ < 0.9999847412109375: gps_velocity_north_raw_ = rt.exact_raw(gps_velocity_north_, _R_12)
                raw.append(gps_velocity_north_raw_)
            gps_velocity_down_ = self.gps_velocity_down
            if gps_velocity_down_ is not None:
                mask |= 4
                if not -327.68 <= gps_velocity_down_ <= 327.67: raise rt.Reject
                near = gps_velocity_down_ * 6553700.0 + 2147516416.5
                gps_velocity_down_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_velocity_down_raw_ < 0.9999847412109375: gps_velocity_down_raw_ = rt.exact_raw(gps_velocity_down_, _R_12)
                raw.append(gps_velocity_down_raw_)
            gps_altitude_ = self.gps_altitude
            if gps_altitude_ is not None:
                mask |= 8
                if not -10000.0 <= gps_altitude_ <= 35000.0: raise rt.Reject
                near = gps_altitude_ * 95443.71766666666 + 954437177.1666666
                gps_altitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - gps_altitude_raw_ < 0.9999847412109375: gps_altitude_raw_ = rt.exact_raw(gps_altitude_, _R_13)
                raw.append(gps_altitude_raw_)
            number_of_satellites_seen_ = self.number_of_satellites_seen
            if number_of_satellites_seen_ is not None:
                mask |= 16
                raw.append(number_of_satellites_seen_)
            number_of_satellites_in_solution_ = self.number_of_satellites_in_solution
            if number_of_satellites_in_solution_ is not None:
                mask |= 32
                raw.append(number_of_satellites_in_solution_)
            out += _M_ReportGPSFix_AltGPSRec_0[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    gps_fix_rec: ReportGPSFix.GPSFixRec
    gps_status_var: ReportGPSFix.MinGPSRec | ReportGPSFix.AltGPSRec | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("GPSFixRec", ReportGPSFix.GPSFixRec.layout()),
            ("GPSStatusVar", rt.Union.of("B", min_gps_rec=ReportGPSFix.MinGPSRec, alt_gps_rec=ReportGPSFix.AltGPSRec), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x28 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        self.gps_fix_rec, at = ReportGPSFix.GPSFixRec._read(data, at, nesting)
        if mask & 1:
            tag = data[at]
            at += 1
            self.gps_status_var, at = _U_14[tag]._read(data, at, nesting)
        else: self.gps_status_var = None
        self.reserved_presence = mask & 0xFE
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x28\x44")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x1: raise rt.Reject
        gps_fix_rec_ = self.gps_fix_rec
        if type(gps_fix_rec_) is not ReportGPSFix.GPSFixRec: raise rt.Reject
        gps_fix_rec_._write(out)
        gps_status_var_ = self.gps_status_var
        if gps_status_var_ is not None:
            mask |= 1
            out.append(_T_15[type(gps_status_var_)])
            gps_status_var_._write(out)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_S_H = rt.Packer("<H")
_M_ReportGPSFix_GPSFixRec_0 = rt.Masks("", ((0, "I"), (0, "I"), (1, "I"), (2, "I"), (4, "I"), (8, "H")))
_R_2 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_3 = rt.Scaling(-180.0, 180.0, 4294967295)
_R_4 = rt.Scaling(0.0, 327.67, 65535)
_S_B = rt.Packer("<B")
_E_ReportGPSFix_GPSValidity = rt.members(ReportGPSFix.GPSValidity)
_S_BI = rt.Packer("<BI")
_M_ReportGPSFix_AltGPSRec_0 = rt.Masks("", ((0, "B"), (0, "B"), (0, "B"), (1, "I"), (2, "I"), (4, "I"), (8, "I"), (16, "B"), (32, "B")))
_E_ReportGPSFix_GPSStatus = rt.members(ReportGPSFix.GPSStatus)
_E_ReportGPSFix_GPSFixCommandStatus = rt.members(ReportGPSFix.GPSFixCommandStatus)
_E_ReportGPSFix_GPSLatLonValid = rt.members(ReportGPSFix.GPSLatLonValid)
_R_12 = rt.Scaling(-327.68, 327.67, 4294967295)
_R_13 = rt.Scaling(-10000.0, 35000.0, 4294967295)
_U_14: tuple[type[ReportGPSFix.MinGPSRec] | type[ReportGPSFix.AltGPSRec], ...] = (ReportGPSFix.MinGPSRec, ReportGPSFix.AltGPSRec)
_T_15: dict[type[rt.Struct], int] = {ReportGPSFix.MinGPSRec: 0, ReportGPSFix.AltGPSRec: 1}
QueryGPSFix.REPORT = ReportGPSFix
