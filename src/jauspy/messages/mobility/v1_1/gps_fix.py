"""urn:jaus:jss:mobility:GPSFix 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:GPSFix", "1.1")


@jd.message(_SERVICE, 0x0428, command=True)
class RequestGPSFix(jd.Message):
    """RequestGPSFix (0x0428): Makes the receiver find its position anew."""


@jd.message(_SERVICE, 0x4428, presence="B")
class ReportGPSFix(jd.Message):
    """ReportGPSFix (0x4428): Tells position, velocity and quality of the solution.

    gps_status_var: optional. Either the least a receiver tells, or more
    """

    @jd.record("B")
    class GPSFixRec(jd.Struct):
        """gps_fix_time_seconds: in second. Time of the fix: whole seconds
        gps_fix_time_nano_seconds: Time of the fix: nanoseconds of the second
        gps_latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
        gps_longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
        gps_true_course: -180..180 degree, optional. Direction of travel from true north, in degrees
        gps_speed_over_ground: 0..327.67 meter per second, optional. Speed over ground, in metres per second
        """
        gps_fix_time_seconds: int = jd.field("GPSFixTimeSeconds", jd.Number("I", jd.ANY, "second"))
        gps_fix_time_nano_seconds: int = jd.field("GPSFixTimeNanoSeconds", jd.Number("I"))
        gps_latitude: float | None = jd.field("GPSLatitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
        gps_longitude: float | None = jd.field("GPSLongitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
        gps_true_course: float | None = jd.field("GPSTrueCourse", jd.real("I", -180.0, 180.0, "degree"), default=None)
        gps_speed_over_ground: float | None = jd.field("GPS_SpeedOverGround", jd.real("H", 0.0, 327.67, "meter per second"), default=None)
        reserved_presence: int = 0

    class GPSValidity(IntEnum):
        INVALID = 0
        VALID = 1

    @jd.record()
    class MinGPSRec(jd.Struct):
        """What every receiver tells.

        gps_validity: GPSValidity. Whether the solution is valid
        gps_magnetic_variation: -90..90 degree. Angle from true to magnetic north, in degrees; positive to the east
        """
        gps_validity: ReportGPSFix.GPSValidity | int = jd.field("GPSValidity", lambda: jd.Number("B", jd.Values(ReportGPSFix.GPSValidity)))
        gps_magnetic_variation: float = jd.field("GPSMagneticVariation", jd.real("I", -90.0, 90.0, "degree"))

    class GPSStatus(IntEnum):
        OPTIMAL_GPS_SIGNAL = 0
        GOOD_GPS_SIGNAL = 1
        MINIMAL_GPS_SIGNAL = 2
        NO_GPS_SIGNAL = 3

    class GPSFixCommandStatus(IntEnum):
        STABLE_GPS_FIX = 0
        INITIATING_GPS_FIX = 1
        PERFORMING_GPS_FIX = 2

    class GPSLatLonValid(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("B")
    class AltGPSRec(jd.Struct):
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
        gps_status: ReportGPSFix.GPSStatus | int = jd.field("GPSStatus", lambda: jd.Number("B", jd.Values(ReportGPSFix.GPSStatus)))
        gps_fix_command_status: ReportGPSFix.GPSFixCommandStatus | int = jd.field("GPSFixCommandStatus", lambda: jd.Number("B", jd.Values(ReportGPSFix.GPSFixCommandStatus)))
        gps_lat_lon_valid: ReportGPSFix.GPSLatLonValid | int = jd.field("GPSLatLonValid", lambda: jd.Number("B", jd.Values(ReportGPSFix.GPSLatLonValid)))
        gps_velocity_east: float | None = jd.field("GPSVelocityEast", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
        gps_velocity_north: float | None = jd.field("GPSVelocityNorth", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
        gps_velocity_down: float | None = jd.field("GPSVelocityDown", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
        gps_altitude: float | None = jd.field("GPSAltitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
        number_of_satellites_seen: int | None = jd.field("NumberOfSatellitesSeen", jd.Number("B"), default=None)
        number_of_satellites_in_solution: int | None = jd.field("NumberOfSatellitesInSolution", jd.Number("B"), default=None)
        reserved_presence: int = 0

    gps_fix_rec: ReportGPSFix.GPSFixRec = jd.field("GPSFixRec", lambda: ReportGPSFix.GPSFixRec.layout())
    gps_status_var: ReportGPSFix.MinGPSRec | ReportGPSFix.AltGPSRec | None = jd.field("GPSStatusVar", lambda: jd.Union.of("B", min_gps_rec=ReportGPSFix.MinGPSRec, alt_gps_rec=ReportGPSFix.AltGPSRec), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2428, query=True)
class QueryGPSFix(jd.Message):
    """QueryGPSFix (0x2428): Asks for the solution of the receiver."""
    REPORT = ReportGPSFix
