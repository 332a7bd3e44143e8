"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@jd.bit_field("H")
class FilterType(jd.Struct):
    """self_collision_avoidance: bit 0. Self collision avoidance."""
    self_collision_avoidance: int = jd.bits(0, 0x1)
    reserved_bits: int = 0


@jd.bit_field("I")
class JAUS_ID(jd.Struct):
    """component_id: bits 0..7. Component ID.
    node_id: bits 8..15. Node ID.
    subsystem_id: bits 16..31. Subsystem ID.
    """
    component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 254),)))
    node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 254),)))
    subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65534),)))


@jd.record("B")
class WaypointInformationRec(jd.Struct):
    """element_uid: Id of the element of the global waypoint list that this adds to
    direction_of_travel: DirectionOfTravel, optional. Which way the vehicle faces on its way to the point
    wait_time: 0..3600 second, optional. Halt at the point before going on; 0 = until the next execute command; left out = no halt
    """

    class DirectionOfTravel(IntEnum):
        FORWARD = 0
        REVERSE = 1

    element_uid: int = jd.field("ElementUID", jd.Number("H"))
    direction_of_travel: WaypointInformationRec.DirectionOfTravel | int | None = jd.field("DirectionOfTravel", lambda: jd.Number("B", jd.Values(WaypointInformationRec.DirectionOfTravel)), default=None)
    wait_time: float | None = jd.field("WaitTime", jd.real("H", 0.0, 3600.0, "second"), default=None)
    reserved_presence: int = 0


@jd.record()
class QueryCostMap2DRec(jd.Struct):
    """max_width: 0..10000 meter. Largest size along the rows, in metres
    max_height: 0..10000 meter. Largest size along the columns, in metres
    """
    max_width: float = jd.field("MaxWidth", jd.real("H", 0.0, 10000.0, "meter"))
    max_height: float = jd.field("MaxHeight", jd.real("H", 0.0, 10000.0, "meter"))


@jd.record()
class CostMap2DGlobalPoseRec(jd.Struct):
    """map_center_latitude: -90..90 degree. Latitude of the middle (WGS 84), in degrees
    map_center_longitude: -180..180 degree. Longitude of the middle (WGS 84), in degrees
    map_rotation: -3.14159265359..3.14159265359 radian. Rotation of the map about its middle, in radians
    """
    map_center_latitude: float = jd.field("MapCenterLatitude", jd.real("I", -90.0, 90.0, "degree"))
    map_center_longitude: float = jd.field("MapCenterLongitude", jd.real("I", -180.0, 180.0, "degree"))
    map_rotation: float = jd.field("MapRotation", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))


@jd.record()
class CostMap2DLocalPoseRec(jd.Struct):
    """map_center_x: -100000..100000 meter. Position of the middle along X, in metres
    map_center_y: -100000..100000 meter. Position of the middle along Y, in metres
    map_rotation: -3.14159265359..3.14159265359 radian. Rotation of the map about its middle, in radians
    """
    map_center_x: float = jd.field("MapCenterX", jd.real("I", -100000.0, 100000.0, "meter"))
    map_center_y: float = jd.field("MapCenterY", jd.real("I", -100000.0, 100000.0, "meter"))
    map_rotation: float = jd.field("MapRotation", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))


@jd.record()
class GlobalVertexRec(jd.Struct):
    """latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
    longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
    """
    latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
    longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))


@jd.record()
class LocalVertexRec(jd.Struct):
    """x: -100000..100000 meter. Position along X, in metres
    y: -100000..100000 meter. Position along Y, in metres
    """
    x: float = jd.field("X", jd.real("I", -100000.0, 100000.0, "meter"))
    y: float = jd.field("Y", jd.real("I", -100000.0, 100000.0, "meter"))


@jd.record()
class CostMap2DRec(jd.Struct):
    """number_of_rows: Cells in each column
    number_of_columns: Cells in each row
    map_width: 0..10000 meter. Size along the rows, in metres
    map_height: 0..10000 meter. Size along the columns, in metres
    """
    number_of_rows: int = jd.field("NumberOfRows", jd.Number("H"))
    number_of_columns: int = jd.field("NumberOfColumns", jd.Number("H"))
    map_width: float = jd.field("MapWidth", jd.real("H", 0.0, 10000.0, "meter"))
    map_height: float = jd.field("MapHeight", jd.real("H", 0.0, 10000.0, "meter"))


@jd.record()
class CostDataRec(jd.Struct):
    """cost: 0..254 or 255..255. Cost of the cell from 0 to 254; higher is harder to drive. 255 is outside of this scale"""
    cost: int = jd.field("Cost", jd.Number("B", jd.Values(None, ((0, 254), (255, 255)))))


@jd.record()
class CostAndConfidenceDataRec(jd.Struct):
    """cost: 0..254. Cost of the cell from 0 to 254; higher is harder to drive
    confidence: 0..100. How certain the cost is, in percent
    """
    cost: int = jd.field("Cost", jd.Number("B", jd.Values(None, ((0, 254),))))
    confidence: float = jd.field("Confidence", jd.real("B", 0.0, 100.0))


@jd.record()
class RunLengthEncodedDataRec(jd.Struct):
    """cost_and_run_length: A run of cells with equal cost"""

    class CertaintySubField(IntEnum):
        UNKNOWN = 0
        KNOWN = 1

    @jd.bit_field("H")
    class CostAndRunLength(jd.Struct):
        """A run of cells with equal cost.

        cost_sub_field: bits 0..2. Cost of the cells.
        certainty_sub_field: bit 3. Whether the cost is known.
        number_cells_sub_field: bits 4..15. Number of cells.
        """
        cost_sub_field: int = jd.bits(0, 0x7, jd.Values(None, ((0, 7),)))
        certainty_sub_field: RunLengthEncodedDataRec.CertaintySubField | int = jd.bits(3, 0x1, lambda: jd.Values(RunLengthEncodedDataRec.CertaintySubField))
        number_cells_sub_field: int = jd.bits(4, 0xFFF, jd.Values(None, ((0, 4095),)))

    cost_and_run_length: RunLengthEncodedDataRec.CostAndRunLength = jd.field("CostAndRunLength", lambda: RunLengthEncodedDataRec.CostAndRunLength.layout())


@jd.record("B")
class DigitalResourceEndpointRec(jd.Struct):
    """server_type: ServerType. Protocol for fetching it
    server_url: up to 255 characters. Where to fetch it
    jaus_id: optional. The component that the stream or file belongs to
    resource_id: optional. Number of the resource in its component, as a sensor has one
    """
    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID

    class ServerType(IntEnum):
        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7

    server_type: DigitalResourceEndpointRec.ServerType | int = jd.field("ServerType", lambda: jd.Number("B", jd.Values(DigitalResourceEndpointRec.ServerType)))
    server_url: str = jd.field("ServerURL", jd.Text(count=jd.Count("B", 0, 255)))
    jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = jd.field("JAUS_ID", lambda: environment_sensing_v1_0_types.JAUS_ID.layout(), default=None)
    resource_id: int | None = jd.field("ResourceID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.record()
class ReleaseControlRec(jd.Struct):
    """id: Number of the request
    response_code: ResponseCode. Whether the controlling client hands over
    """

    class ResponseCode(IntEnum):
        GRANTED = 0
        DENIED = 1
        WAIT = 2

    id: int = jd.field("ID", jd.Number("B"))
    response_code: ReleaseControlRec.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(ReleaseControlRec.ResponseCode)))


@jd.bit_field("I")
class ParentID(jd.Struct):
    """component_id: bits 0..7. Component ID.
    node_id: bits 8..15. Node ID.
    subsystem_id: bits 16..31. Subsystem ID.
    """
    component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((0, 255),)))
    node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((0, 255),)))
    subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((0, 65535),)))


@jd.record("B")
class DeviceRec(jd.Struct):
    """device_name: up to 255 characters. Name of the device
    device_designation: up to 255 characters, optional. Type of the device
    classification: up to 255 characters, optional. Kind of the device
    """
    device_name: str = jd.field("DeviceName", jd.Text(count=jd.Count("B", 0, 255)))
    device_designation: str | None = jd.field("DeviceDesignation", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    classification: str | None = jd.field("Classification", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    reserved_presence: int = 0


@jd.record("B")
class ReadingRec(jd.Struct):
    """sensor: up to 255 characters. Name of the sensor
    source: up to 255 characters. What is measured
    type: up to 255 characters. Kind of reading
    unit: up to 255 characters, optional. Unit of the values
    minimum: optional. Smallest reading
    avarage: optional. Mean of the readings
    maximum: optional. Largest reading
    alert_level: AlertLevel, optional. How serious the reading is
    alert_explanation: up to 255 characters, optional. Why there is an alert, for people
    extended_info: up to 255 characters, optional. What else there is to say
    """

    class AlertLevel(IntEnum):
        NO_ALERT = 0
        LOW = 1
        MIDDLE = 2
        HIGHT = 3
        NOT_SUPPORTED = 255

    sensor: str = jd.field("Sensor", jd.Text(count=jd.Count("B", 0, 255)))
    source: str = jd.field("Source", jd.Text(count=jd.Count("B", 0, 255)))
    type: str = jd.field("Type", jd.Text(count=jd.Count("B", 0, 255)))
    unit: str | None = jd.field("Unit", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    minimum: int | None = jd.field("Minimum", jd.Number("B"), default=None)
    avarage: int | None = jd.field("Avarage", jd.Number("B"), default=None)
    maximum: int | None = jd.field("Maximum", jd.Number("B"), default=None)
    alert_level: ReadingRec.AlertLevel | int | None = jd.field("AlertLevel", lambda: jd.Number("B", jd.Values(ReadingRec.AlertLevel)), default=None)
    alert_explanation: str | None = jd.field("AlertExplanation", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    extended_info: str | None = jd.field("ExtendedInfo", jd.Text(count=jd.Count("B", 0, 255)), default=None)
    reserved_presence: int = 0


@jd.record()
class ValueRec(jd.Struct):
    """value: -10000..10000. One value"""
    value: float = jd.field("Value", jd.real("I", -10000.0, 10000.0))


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
    """
    latitude: float | None = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"), default=None)
    longitude: float | None = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"), default=None)
    altitude: float | None = jd.field("Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    position_rms: float | None = jd.field("Position_RMS", jd.real("I", 0.0, 100.0, "meter"), default=None)
    roll: float | None = jd.field("Roll", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    pitch: float | None = jd.field("Pitch", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    yaw: float | None = jd.field("Yaw", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    attitude_rms: float | None = jd.field("Attitude_RMS", jd.real("H", 0.0, 3.141592653589793, "radian"), default=None)
    reserved_presence: int = 0


@jd.record()
class TimestampRec(jd.Struct):
    """time_stamp: Time within the month, in UTC"""
    TimeStamp = core_v1_0_types.TimeStamp
    time_stamp: core_v1_0_types.TimeStamp = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout())


@jd.record("B")
class PathReporterCapabilitiesRec(jd.Struct):
    """path_type: PathType. Whether the path was travelled or is planned, and its frame
    min_target_resolution: 0..10000 meter, optional. Smallest distance of points, in metres
    max_target_resolution: 0..10000 meter, optional. Largest distance of points, in metres
    maximum_points: optional. Largest number of points
    maximum_distance: in meter, optional. Largest length of the path, in metres
    maximum_time: in second, optional. Longest time that the path covers, in seconds
    """

    class PathType(IntEnum):
        HISTORICAL_GLOBAL_PATH = 0
        HISTORICAL_LOCAL_PATH = 1
        PLANNED_GLOBAL_PATH = 2
        PLANNED_LOCAL_PATH = 3

    path_type: PathReporterCapabilitiesRec.PathType | int = jd.field("PathType", lambda: jd.Number("B", jd.Values(PathReporterCapabilitiesRec.PathType)))
    min_target_resolution: float | None = jd.field("MinTargetResolution", jd.real("H", 0.0, 10000.0, "meter"), default=None)
    max_target_resolution: float | None = jd.field("MaxTargetResolution", jd.real("H", 0.0, 10000.0, "meter"), default=None)
    maximum_points: int | None = jd.field("MaximumPoints", jd.Number("H"), default=None)
    maximum_distance: int | None = jd.field("MaximumDistance", jd.Number("I", jd.ANY, "meter"), default=None)
    maximum_time: int | None = jd.field("MaximumTime", jd.Number("I", jd.ANY, "second"), default=None)
    reserved_presence: int = 0
