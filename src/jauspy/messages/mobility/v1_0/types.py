"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@jd.record("B")
class GlobalWaypointRec(jd.Struct):
    """latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Wanted rotation about Z, in radians; 0 is true north
    waypoint_tolerance: 0..100 meter, optional. The waypoint is reached within this distance, in metres
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    waypoint_tolerance: float | None = jd.field("WaypointTolerance", jd.real("H", 0.0, 100.0, "meter"), default=None)
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.record("H")
class GlobalPoseRec(jd.Struct):
    """latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree, optional. Longitude (WGS 84), in degrees; positive to the east
    altitude: -10000..35000 meter, optional. Altitude (WGS 84), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is true north
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time within the month, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.record("H")
class LocalPoseRec(jd.Struct):
    """x: -100000..100000 meter, optional. Position along X, in metres
    y: -100000..100000 meter, optional. Position along Y, in metres
    z: -100000..100000 meter, optional. Position along Z (down), in metres
    position_rms: 0..100 meter, optional. Root mean square error of the position, in metres
    roll: -3.14159265359..3.14159265359 radian, optional. Rotation about X, in radians
    pitch: -3.14159265359..3.14159265359 radian, optional. Rotation about Y, in radians
    yaw: -3.14159265359..3.14159265359 radian, optional. Rotation about Z, in radians; 0 is along X
    attitude_rms: 0..3.14159265359 radian, optional. Root mean square error of the attitude, in radians
    time_stamp: optional. Time of the measurement
    """
    TimeStamp = core_v1_0_types.TimeStamp
    x: float | None = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    z: float | None = jd.field("Z", jd.real("I", -100000.0, 100000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(GlobalZPosition.Choice)))
class GlobalZPosition(jd.Struct):
    """0: meter, -50000..50000 meter
    1: meter, -50000..50000 meter
    2: meter, -50000..50000 meter
    3: meter, -50000..50000 meter
    """

    class Choice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    choice: GlobalZPosition.Choice | int
    value: float


@jd.record()
class PolygonRec(jd.Struct):
    """number_loiter_vertices: Number of corners of the polygon
    xy_extent: 0..100000 meter. Horizontal size of the polygon, in metres
    loiter_direction: LoiterDirection. Sense of rotation, seen from above
    loiter_bearing: 0..3.14159265359 radian. Direction of the polygon, in radians
    """

    class LoiterDirection(IntEnum):
        VEHICLE_DEPENDENT = 0
        CLOCKWISE = 1
        COUNTERCLOCKWISE = 2

    number_loiter_vertices: int = jd.field("NumberLoiterVertices", jd.Number("B"))
    xy_extent: float = jd.field("XYExtent", jd.real("I", 0.0, 100000.0, "meter"))
    loiter_direction: PolygonRec.LoiterDirection | int = jd.field("LoiterDirection", lambda: jd.Number("B", jd.Values(PolygonRec.LoiterDirection)))
    loiter_bearing: float = jd.field("LoiterBearing", jd.real("H", 0.0, 3.141592653589793, "radian"))


@jd.record()
class RaceTrackRec(jd.Struct):
    """loiter_type: LoiterType. Whether the straights are parallel or cross
    loiter_radius: 0..200000 meter. Radius of the turns, in metres
    loiter_length: 0..200000 meter. Length of the pattern, in metres
    loiter_direction: LoiterDirection. Sense of rotation, seen from above
    loiter_bearing: 0..3.14159265359 radian. Direction of the long axis of the pattern, in radians
    """

    class LoiterType(IntEnum):
        RACETRACK = 0
        FIGURE_8 = 1

    class LoiterDirection(IntEnum):
        VEHICLE_DEPENDENT = 0
        CLOCKWISE = 1
        COUNTERCLOCKWISE = 2

    loiter_type: RaceTrackRec.LoiterType | int = jd.field("LoiterType", lambda: jd.Number("B", jd.Values(RaceTrackRec.LoiterType)))
    loiter_radius: float = jd.field("LoiterRadius", jd.real("I", 0.0, 200000.0, "meter"))
    loiter_length: float = jd.field("LoiterLength", jd.real("I", 0.0, 200000.0, "meter"))
    loiter_direction: RaceTrackRec.LoiterDirection | int = jd.field("LoiterDirection", lambda: jd.Number("B", jd.Values(RaceTrackRec.LoiterDirection)))
    loiter_bearing: float = jd.field("LoiterBearing", jd.real("H", 0.0, 3.141592653589793, "radian"))


@jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("H", -327.68, 327.67, "meter per second"), 1: jd.real("H", -327.68, 327.67, "meter per second"), 2: jd.real("H", -1000.0, 1000.0, "rotations per minute"), 3: jd.real("H", -327.68, 327.67, "meter per second")}, jd.Values(Speed.Choice)))
class Speed(jd.Struct):
    """0: meter per second, -327.68..327.67 meter per second
    1: meter per second, -327.68..327.67 meter per second
    2: rotations per minute, -1000..1000 rotations per minute
    3: meter per second, -327.68..327.67 meter per second
    """

    class Choice(IntEnum):
        SPEED_OVER_GROUND = 0
        SPEED_RELATIVE_TO_MEDIUM = 1
        ROTATIONS_PER_MINUTE = 2
        INDICATED_SPEED = 3

    choice: Speed.Choice | int
    value: float


@jd.record()
class ZoneIDRec(jd.Struct):
    """zone_id: ZoneID or 2..65535. Number of the zone"""

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    zone_id: ZoneIDRec.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(ZoneIDRec.ZoneID, ((2, 65535),))))


@jd.record()
class ExcursionRec(jd.Struct):
    """zone_id: ZoneID or 2..65535. Number of the zone
    zone_status: ZoneStatus. Where the platform is with regard to the zone
    """

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    class ZoneStatus(IntEnum):
        INSIDE_SAFE_ZONE = 0
        OUTSIDE_SAFE_ZONE = 1
        INSIDE_SAFE_AND_EXCLUSION_ZONE = 2

    zone_id: ExcursionRec.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(ExcursionRec.ZoneID, ((2, 65535),))))
    zone_status: ExcursionRec.ZoneStatus | int = jd.field("ZoneStatus", lambda: jd.Number("B", jd.Values(ExcursionRec.ZoneStatus)))


@jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ZPosition.Choice)))
class ZPosition(jd.Struct):
    """0: meter, -50000..50000 meter
    1: meter, -50000..50000 meter
    2: meter, -50000..50000 meter
    3: meter, -50000..50000 meter
    4: meter, -50000..50000 meter
    """

    class Choice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    choice: ZPosition.Choice | int
    value: float


@jd.record("H")
class ReportGlobalPoseExtRec(jd.Struct):
    """latitude: -90..90 degree, optional. Latitude (WGS 84), in degrees; positive to the north
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
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude_agl: float | None = jd.field("AltitudeAGL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_msl: float | None = jd.field("AltitudeMSL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_asf: float | None = jd.field("AltitudeASF", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    depth: float | None = jd.field("Depth", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    xy_position_rms: float | None = jd.field("XYPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    z_position_rms: float | None = jd.field("ZPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0


@jd.record("H")
class ReportLocalPoseExtRec(jd.Struct):
    """x: -20000000..20000000 meter, optional. Position along X, in metres
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
    x: float | None = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    y: float | None = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"), default=None)
    altitude_agl: float | None = jd.field("AltitudeAGL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_msl: float | None = jd.field("AltitudeMSL", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    altitude_asf: float | None = jd.field("AltitudeASF", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    depth: float | None = jd.field("Depth", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    z_local: float | None = jd.field("ZLocal", jd.real("I", -50000.0, 50000.0, "meter"), default=None)
    xy_position_rms: float | None = jd.field("XYPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    z_position_rms: float | None = jd.field("ZPositionRMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    heading: float | None = jd.field("Heading", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    course: float | None = jd.field("Course", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)


@jd.record("B")
class VelocityVehicleXYZRec(jd.Struct):
    """velocity_x: -327.68..327.67 meter per second, optional. Velocity forward (X), in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity to the right (Y), in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity down (Z), in metres per second
    """
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    reserved_presence: int = 0


@jd.record("B")
class VelocityLocalXYZRec(jd.Struct):
    """velocity_x: -327.68..327.67 meter per second, optional. Velocity along X of the local frame, in metres per second
    velocity_y: -327.68..327.67 meter per second, optional. Velocity along Y of the local frame, in metres per second
    velocity_z: -327.68..327.67 meter per second, optional. Velocity along Z of the local frame, in metres per second
    """
    velocity_x: float | None = jd.field("Velocity_X", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_y: float | None = jd.field("Velocity_Y", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_z: float | None = jd.field("Velocity_Z", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    reserved_presence: int = 0


@jd.record("B")
class VelocityNEDRec(jd.Struct):
    """velocity_n: -327.68..327.67 meter per second, optional. Velocity to the north, in metres per second
    velocity_e: -327.68..327.67 meter per second, optional. Velocity to the east, in metres per second
    velocity_d: -327.68..327.67 meter per second, optional. Velocity down, in metres per second
    """
    velocity_n: float | None = jd.field("Velocity_N", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_e: float | None = jd.field("Velocity_E", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    velocity_d: float | None = jd.field("Velocity_D", jd.real("I", -327.68, 327.67, "meter per second"), default=None)
    reserved_presence: int = 0


@jd.record("H")
class ReportVelocityStateExtRec(jd.Struct):
    """velocity_rms: 0..100 meter per second, optional. Root mean square error of the velocity, in metres per second
    roll_rate: -32.768..32.767 radian per second, optional. Angular velocity about X, in radians per second
    pitch_rate: -32.768..32.767 radian per second, optional. Angular velocity about Y, in radians per second
    yaw_rate: -32.768..32.767 radian per second, optional. Angular velocity about Z (positive to the right), in radians per second
    rate_rms: 0..100 radian per second, optional. Root mean square error of the angular velocity, in radians per second
    speed_over_ground: -327.68..327.67 meter per second, optional. Speed over ground, in metres per second
    speed_relative_to_medium: -327.68..327.67 meter per second, optional. Speed through air or water, in metres per second
    rotations_per_minute: -1000..1000 rotations per minute, optional. Rotation of propeller or drive shaft, per minute
    indicated_speed: -327.68..327.67 meter per second, optional. Speed as an air or water speed indicator shows it, in metres per second
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    velocity_rms: float | None = jd.field("Velocity_RMS", jd.real("I", 0.0, 100.0, "meter per second"), default=None)
    roll_rate: float | None = jd.field("RollRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    pitch_rate: float | None = jd.field("PitchRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    yaw_rate: float | None = jd.field("YawRate", jd.real("I", -32.768, 32.767, "radian per second"), default=None)
    rate_rms: float | None = jd.field("Rate_RMS", jd.real("H", 0.0, 100.0, "radian per second"), default=None)
    speed_over_ground: float | None = jd.field("SpeedOverGround", jd.real("H", -327.68, 327.67, "meter per second"), default=None)
    speed_relative_to_medium: float | None = jd.field("SpeedRelativeToMedium", jd.real("H", -327.68, 327.67, "meter per second"), default=None)
    rotations_per_minute: float | None = jd.field("RotationsPerMinute", jd.real("H", -1000.0, 1000.0, "rotations per minute"), default=None)
    indicated_speed: float | None = jd.field("IndicatedSpeed", jd.real("H", -327.68, 327.67, "meter per second"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0


@jd.record("H")
class ReportAccelerationStateExtRec(jd.Struct):
    """acceleration_x: -1310.68..1310.68 meter per second squared, optional. Acceleration forward (X), in metres per second squared
    acceleration_y: -1310.68..1310.68 meter per second squared, optional. Acceleration to the right (Y), in metres per second squared
    acceleration_z: -1310.68..1310.68 meter per second squared, optional. Acceleration down (Z), in metres per second squared
    acceleration_rms: 0..100 meter per second squared, optional. Root mean square error of the acceleration, in metres per second squared
    roll_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about X, in radians per second squared
    pitch_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Y, in radians per second squared
    yaw_acceleration: -13106.8..13106.8 radian per second squared, optional. Angular acceleration about Z (positive to the right), in radians per second squared
    rotational_acceleration_rms: 0..1000 radian per second squared, optional. Root mean square error of the angular acceleration, in radians per second squared
    time_seconds: in second, optional. Time of the measurement: whole seconds
    time_nano_seconds: optional. Time of the measurement: nanoseconds of the second
    """
    acceleration_x: float | None = jd.field("Acceleration_X", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_y: float | None = jd.field("Acceleration_Y", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_z: float | None = jd.field("Acceleration_Z", jd.real("I", -1310.68, 1310.68, "meter per second squared"), default=None)
    acceleration_rms: float | None = jd.field("Acceleration_RMS", jd.real("I", 0.0, 100.0, "meter per second squared"), default=None)
    roll_acceleration: float | None = jd.field("RollAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    pitch_acceleration: float | None = jd.field("PitchAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    yaw_acceleration: float | None = jd.field("YawAcceleration", jd.real("I", -13106.8, 13106.8, "radian per second squared"), default=None)
    rotational_acceleration_rms: float | None = jd.field("RotationalAcceleration_RMS", jd.real("H", 0.0, 1000.0, "radian per second squared"), default=None)
    time_seconds: int | None = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"), default=None)
    time_nano_seconds: int | None = jd.field("TimeNanoSeconds", jd.Number("I"), default=None)
    reserved_presence: int = 0
