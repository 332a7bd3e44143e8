"""urn:jaus:jss:environmentSensing:RangeSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:RangeSensor", "2.0")


@jd.message(_SERVICE, 0x0802, command=True)
class SetRangeSensorConfiguration(jd.Message):
    """SetRangeSensorConfiguration (0x0802): Sets the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class SensorState(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    @jd.record("B")
    class RangeSensorConfigurationRec(jd.Struct):
        """Settings of one sensor.

        sensor_id: 1..65535. Identifies the sensor
        horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from left to right, in radians
        horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from left to right, in radians
        vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from top to bottom, in radians
        vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from top to bottom, in radians
        update_rate: 0..1000 hertz, optional. Rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        sensor_state: SensorState, optional. Whether the sensor works
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        horizontal_field_of_view_start_angle: float | None = jd.field("HorizontalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        horizontal_field_of_view_stop_angle: float | None = jd.field("HorizontalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view_start_angle: float | None = jd.field("VerticalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view_stop_angle: float | None = jd.field("VerticalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        update_rate: float | None = jd.field("UpdateRate", jd.real("H", 0.0, 1000.0, "hertz"), default=None)
        minimum_range: float | None = jd.field("MinimumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        maximum_range: float | None = jd.field("MaximumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        sensor_state: SetRangeSensorConfiguration.SensorState | int | None = jd.field("SensorState", lambda: jd.Number("B", jd.Values(SetRangeSensorConfiguration.SensorState)), default=None)

    request_id_rec: SetRangeSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetRangeSensorConfiguration.RequestIdRec.layout())
    range_sensor_configuration_list: list[SetRangeSensorConfiguration.RangeSensorConfigurationRec] = jd.field("RangeSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetRangeSensorConfiguration.RangeSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4805)
class ReportSensorGeometricProperties(jd.Message):
    """ReportSensorGeometricProperties (0x4805): Tells where sensors are mounted.

    geometric_properties_list: 0..65535 items. The sensors
    """
    SensorIdRec = environment_sensing_v1_0_types.SensorIdRec
    StaticGeometricPropertiesRec = environment_sensing_v1_0_types.StaticGeometricPropertiesRec
    ManipulatorGeometricPropertiesRec = environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec

    @jd.record()
    class Empty0(jd.Struct):
        """Empty0."""

    @jd.record()
    class NoGeometricPropertiesVariant(jd.Struct):
        """Mounting is unknown.

        no_geometric_properties_variant: Mounting is unknown
        """
        no_geometric_properties_variant: ReportSensorGeometricProperties.Empty0 = jd.field("NoGeometricPropertiesVariant", lambda: jd.Union.of("B", empty0=ReportSensorGeometricProperties.Empty0))

    @jd.record()
    class GeometricPropertiesSequence(jd.Struct):
        """sensor_id_rec: One sensor
        geometric_properties_variant: Mounting on the vehicle, on a manipulator, or unknown
        """
        sensor_id_rec: environment_sensing_v1_0_types.SensorIdRec = jd.field("SensorIdRec", lambda: environment_sensing_v1_0_types.SensorIdRec.layout())
        geometric_properties_variant: ReportSensorGeometricProperties.NoGeometricPropertiesVariant | environment_sensing_v1_0_types.StaticGeometricPropertiesRec | environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec = jd.field("GeometricPropertiesVariant", lambda: jd.Union.of("B", no_geometric_properties_variant=ReportSensorGeometricProperties.NoGeometricPropertiesVariant, static_geometric_properties_rec=environment_sensing_v1_0_types.StaticGeometricPropertiesRec, manipulator_geometric_properties_rec=environment_sensing_v1_0_types.ManipulatorGeometricPropertiesRec))

    geometric_properties_list: list[ReportSensorGeometricProperties.GeometricPropertiesSequence] = jd.field("GeometricPropertiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportSensorGeometricProperties.GeometricPropertiesSequence.layout()))


@jd.message(_SERVICE, 0x2805, query=True)
class QuerySensorGeometricProperties(jd.Message):
    """QuerySensorGeometricProperties (0x2805): Asks where sensors are mounted.

    sensor_id_list: 0..65535 items. The sensors
    """
    REPORT = ReportSensorGeometricProperties
    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec
    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec] = jd.field("SensorIdList", lambda: jd.Repeat(jd.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout()))


@jd.message(_SERVICE, 0x4804)
class ReportRangeSensorCompressedData(jd.Message):
    """ReportRangeSensorCompressedData (0x4804): Tells measurements of range in a compressed form.

    range_sensor_compressed_data_list: 0..65535 items. The sensors
    """
    TimeStamp = core_v1_0_types.TimeStamp

    class DataErrorCode(IntEnum):
        SENSOR_NOT_ACTIVE = 0
        INVALID_COMPRESSION_FORMAT = 1
        UNKNOWN_ERROR = 255

    @jd.record()
    class RangeSensorDataErrorRec(jd.Struct):
        """Why a sensor has no measurement.

        sensor_id: 1..65535. Identifies the sensor
        data_error_code: DataErrorCode. Why there is no measurement
        error_message: up to 255 characters. An explanation for people
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        data_error_code: ReportRangeSensorCompressedData.DataErrorCode | int = jd.field("DataErrorCode", lambda: jd.Number("B", jd.Values(ReportRangeSensorCompressedData.DataErrorCode)))
        error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    class DataCompression(IntEnum):
        NONE = 0
        DEFLATE = 1
        BZIP2 = 2
        LZMA = 3

    @jd.record()
    class RangeSensorCompressedDataRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: Time within the month, in UTC
        data_compression: DataCompression. Kind of compression
        compressed_data: RangeSensorDataPointList. The points of a report, compressed
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        report_coordinate_system: ReportRangeSensorCompressedData.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(ReportRangeSensorCompressedData.ReportCoordinateSystem)))
        time_stamp: core_v1_0_types.TimeStamp = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout())
        data_compression: ReportRangeSensorCompressedData.DataCompression | int = jd.field("DataCompression", lambda: jd.Number("B", jd.Values(ReportRangeSensorCompressedData.DataCompression)))
        compressed_data: bytes = jd.field("CompressedData", jd.Blob(jd.Count("I", 0, 2147483647)))

    range_sensor_compressed_data_list: list[ReportRangeSensorCompressedData.RangeSensorDataErrorRec | ReportRangeSensorCompressedData.RangeSensorCompressedDataRec] = jd.field("RangeSensorCompressedDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), jd.Union.of("B", range_sensor_data_error_rec=ReportRangeSensorCompressedData.RangeSensorDataErrorRec, range_sensor_compressed_data_rec=ReportRangeSensorCompressedData.RangeSensorCompressedDataRec)))


@jd.message(_SERVICE, 0x2804, query=True)
class QueryRangeSensorCompressedData(jd.Message):
    """QueryRangeSensorCompressedData (0x2804): Asks for measurements of range in a compressed form.

    query_range_sensor_compressed_data_list: 0..65535 items. The sensors
    """
    REPORT = ReportRangeSensorCompressedData

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    class DataCompression(IntEnum):
        NONE = 0
        DEFLATE = 1
        BZIP2 = 2
        LZMA = 3

    @jd.record()
    class QueryRangeSensorCompressedDataRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        data_compression: DataCompression. Kind of compression
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryRangeSensorCompressedData.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryRangeSensorCompressedData.SensorID, ((1, 65535),))))
        report_coordinate_system: QueryRangeSensorCompressedData.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(QueryRangeSensorCompressedData.ReportCoordinateSystem)))
        data_compression: QueryRangeSensorCompressedData.DataCompression | int = jd.field("DataCompression", lambda: jd.Number("B", jd.Values(QueryRangeSensorCompressedData.DataCompression)))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_range_sensor_compressed_data_list: list[QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec] = jd.field("QueryRangeSensorCompressedDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec.layout()))


@jd.message(_SERVICE, 0x4803)
class ReportRangeSensorData(jd.Message):
    """ReportRangeSensorData (0x4803): Tells measurements of range, point by point.

    range_sensor_data_list: 0..65535 items. The sensors
    """
    TimeStamp = core_v1_0_types.TimeStamp

    class DataErrorCode(IntEnum):
        SENSOR_NOT_ACTIVE = 0
        INVALID_COMPRESSION_FORMAT = 1
        UNKNOWN_ERROR = 255

    @jd.record()
    class RangeSensorDataErrorRec(jd.Struct):
        """Why a sensor has no measurement.

        sensor_id: 1..65535. Identifies the sensor
        data_error_code: DataErrorCode. Why there is no measurement
        error_message: up to 255 characters. An explanation for people
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        data_error_code: ReportRangeSensorData.DataErrorCode | int = jd.field("DataErrorCode", lambda: jd.Number("B", jd.Values(ReportRangeSensorData.DataErrorCode)))
        error_message: str = jd.field("ErrorMessage", jd.Text(count=jd.Count("B", 0, 255)))

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    @jd.record()
    class RangeSensorDataRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: Time within the month, in UTC
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        report_coordinate_system: ReportRangeSensorData.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(ReportRangeSensorData.ReportCoordinateSystem)))
        time_stamp: core_v1_0_types.TimeStamp = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout())

    class RangeValidity(IntEnum):
        FALSE = 0
        TRUE = 1

    class BearingValidity(IntEnum):
        FALSE = 0
        TRUE = 1

    class InclinationValidity(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("B", kw_only=True)
    class RangeSensorDataPointRec(jd.Struct):
        """point_id: optional. Identifies the point
        range: 0..1000000 meter. Distance, in metres
        range_validity: RangeValidity, optional. Whether the distance can be used
        range_error_rms: 0..100000 meter, optional. Root mean square error of the distance, in metres
        bearing: -3.14159265359..3.14159265359 radian. Angle in the horizontal plane of the frame, in radians; 0 is ahead
        bearing_validity: BearingValidity, optional. Whether the bearing can be used
        bearing_error_rms: 0..3.14159265359 radian, optional. Root mean square error of the bearing, in radians
        inclination: -3.14159265359..3.14159265359 radian. Angle to the horizontal plane of the frame, in radians
        inclination_validity: InclinationValidity, optional. Whether the inclination can be used
        inclination_error_rms: 0..3.14159265359 radian, optional. Root mean square error of the inclination, in radians
        """
        point_id: int | None = jd.field("PointID", jd.Number("I"), default=None)
        range: float = jd.field("Range", jd.real("I", 0.0, 1000000.0, "meter"))
        range_validity: ReportRangeSensorData.RangeValidity | int | None = jd.field("RangeValidity", lambda: jd.Number("B", jd.Values(ReportRangeSensorData.RangeValidity)), default=None)
        range_error_rms: float | None = jd.field("RangeErrorRMS", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        bearing: float = jd.field("Bearing", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"))
        bearing_validity: ReportRangeSensorData.BearingValidity | int | None = jd.field("BearingValidity", lambda: jd.Number("B", jd.Values(ReportRangeSensorData.BearingValidity)), default=None)
        bearing_error_rms: float | None = jd.field("BearingErrorRMS", jd.real("I", 0.0, 3.141592653589793, "radian"), default=None)
        inclination: float = jd.field("Inclination", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"))
        inclination_validity: ReportRangeSensorData.InclinationValidity | int | None = jd.field("InclinationValidity", lambda: jd.Number("B", jd.Values(ReportRangeSensorData.InclinationValidity)), default=None)
        inclination_error_rms: float | None = jd.field("InclinationErrorRMS", jd.real("I", 0.0, 3.141592653589793, "radian"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class RangeSensorDataSeq(jd.Struct):
        """range_sensor_data_point_list: 0..65535 items. The points"""
        range_sensor_data_rec: ReportRangeSensorData.RangeSensorDataRec = jd.field("RangeSensorDataRec", lambda: ReportRangeSensorData.RangeSensorDataRec.layout())
        range_sensor_data_point_list: list[ReportRangeSensorData.RangeSensorDataPointRec] = jd.field("RangeSensorDataPointList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportRangeSensorData.RangeSensorDataPointRec.layout()))

    range_sensor_data_list: list[ReportRangeSensorData.RangeSensorDataErrorRec | ReportRangeSensorData.RangeSensorDataSeq] = jd.field("RangeSensorDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), jd.Union.of("B", range_sensor_data_error_rec=ReportRangeSensorData.RangeSensorDataErrorRec, range_sensor_data_seq=ReportRangeSensorData.RangeSensorDataSeq)))


@jd.message(_SERVICE, 0x2803, query=True)
class QueryRangeSensorData(jd.Message):
    """QueryRangeSensorData (0x2803): Asks for measurements of range.

    query_range_sensor_data_list: 0..65535 items. The sensors
    """
    REPORT = ReportRangeSensorData

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    @jd.record()
    class QueryRangeSensorDataRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryRangeSensorData.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryRangeSensorData.SensorID, ((1, 65535),))))
        report_coordinate_system: QueryRangeSensorData.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(QueryRangeSensorData.ReportCoordinateSystem)))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_range_sensor_data_list: list[QueryRangeSensorData.QueryRangeSensorDataRec] = jd.field("QueryRangeSensorDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryRangeSensorData.QueryRangeSensorDataRec.layout()))


@jd.message(_SERVICE, 0x4801)
class ReportRangeSensorCapabilities(jd.Message):
    """ReportRangeSensorCapabilities (0x4801): Tells what range sensors can do.

    range_sensor_capabilities_list: 0..65535 items. The sensors
    """
    SupportedStates = environment_sensing_v1_0_types.SupportedStates
    SupportedCompression = environment_sensing_v1_0_types.SupportedCompression

    class CoordinateTransformationSupported(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("H")
    class RangeSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        supported_states: optional. States that the sensor offers
        minimum_horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the first angle from left to right, in radians
        maximum_horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the last angle from left to right, in radians
        minimum_vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the first angle from top to bottom, in radians
        maximum_vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Limit of the last angle from top to bottom, in radians
        miniumum_update_rate: 0..1000 hertz, optional. Smallest rate of measurement, in hertz
        maximum_update_rate: 0..1000 hertz, optional. Largest rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        supported_compression: optional. Kinds of compression that the sensor offers
        coordinate_transformation_supported: CoordinateTransformationSupported, optional. Whether the sensor can report in the frame of the vehicle
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensor_name: str = jd.field("SensorName", jd.Text(count=jd.Count("B", 0, 255)))
        supported_states: environment_sensing_v1_0_types.SupportedStates | None = jd.field("SupportedStates", lambda: environment_sensing_v1_0_types.SupportedStates.layout(), default=None)
        minimum_horizontal_field_of_view_start_angle: float | None = jd.field("MinimumHorizontalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        maximum_horizontal_field_of_view_stop_angle: float | None = jd.field("MaximumHorizontalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        minimum_vertical_field_of_view_start_angle: float | None = jd.field("MinimumVerticalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        maximum_vertical_field_of_view_stop_angle: float | None = jd.field("MaximumVerticalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        miniumum_update_rate: float | None = jd.field("MiniumumUpdateRate", jd.real("H", 0.0, 1000.0, "hertz"), default=None)
        maximum_update_rate: float | None = jd.field("MaximumUpdateRate", jd.real("H", 0.0, 1000.0, "hertz"), default=None)
        minimum_range: float | None = jd.field("MinimumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        maximum_range: float | None = jd.field("MaximumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        supported_compression: environment_sensing_v1_0_types.SupportedCompression | None = jd.field("SupportedCompression", lambda: environment_sensing_v1_0_types.SupportedCompression.layout(), default=None)
        coordinate_transformation_supported: ReportRangeSensorCapabilities.CoordinateTransformationSupported | int | None = jd.field("CoordinateTransformationSupported", lambda: jd.Number("B", jd.Values(ReportRangeSensorCapabilities.CoordinateTransformationSupported)), default=None)
        reserved_presence: int = 0

    range_sensor_capabilities_list: list[ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec] = jd.field("RangeSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportRangeSensorCapabilities.RangeSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2801, query=True)
class QueryRangeSensorCapabilities(jd.Message):
    """QueryRangeSensorCapabilities (0x2801): Asks what range sensors can do.

    range_sensor_capabilities_list: 0..65535 items. The sensors
    """
    REPORT = ReportRangeSensorCapabilities

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryRangeSensorCapabilitiesRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryRangeSensorCapabilities.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryRangeSensorCapabilities.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    range_sensor_capabilities_list: list[QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec] = jd.field("RangeSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x4802)
class ReportRangeSensorConfiguration(jd.Message):
    """ReportRangeSensorConfiguration (0x4802): Tells the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """

    class SensorState(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    @jd.record("B")
    class RangeSensorConfigurationRec(jd.Struct):
        """Settings of one sensor.

        sensor_id: 1..65535. Identifies the sensor
        horizontal_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from left to right, in radians
        horizontal_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from left to right, in radians
        vertical_field_of_view_start_angle: -3.14159265359..3.14159265359 radian, optional. First angle from top to bottom, in radians
        vertical_field_of_view_stop_angle: -3.14159265359..3.14159265359 radian, optional. Last angle from top to bottom, in radians
        update_rate: 0..1000 hertz, optional. Rate of measurement, in hertz
        minimum_range: 0..1000000 meter, optional. Smallest distance, in metres
        maximum_range: 0..1000000 meter, optional. Largest distance, in metres
        sensor_state: SensorState, optional. Whether the sensor works
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        horizontal_field_of_view_start_angle: float | None = jd.field("HorizontalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        horizontal_field_of_view_stop_angle: float | None = jd.field("HorizontalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view_start_angle: float | None = jd.field("VerticalFieldOfViewStartAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view_stop_angle: float | None = jd.field("VerticalFieldOfViewStopAngle", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        update_rate: float | None = jd.field("UpdateRate", jd.real("H", 0.0, 1000.0, "hertz"), default=None)
        minimum_range: float | None = jd.field("MinimumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        maximum_range: float | None = jd.field("MaximumRange", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        sensor_state: ReportRangeSensorConfiguration.SensorState | int | None = jd.field("SensorState", lambda: jd.Number("B", jd.Values(ReportRangeSensorConfiguration.SensorState)), default=None)

    range_sensor_configuration_list: list[ReportRangeSensorConfiguration.RangeSensorConfigurationRec] = jd.field("RangeSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportRangeSensorConfiguration.RangeSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x2802, query=True)
class QueryRangeSensorConfiguration(jd.Message):
    """QueryRangeSensorConfiguration (0x2802): Asks for the configuration of range sensors.

    range_sensor_configuration_list: 0..65535 items. The sensors
    """
    REPORT = ReportRangeSensorConfiguration

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryRangeSensorConfigurationRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryRangeSensorConfiguration.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryRangeSensorConfiguration.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    range_sensor_configuration_list: list[QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec] = jd.field("RangeSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec.layout()))

@jd.derived(_SERVICE)
class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration): ...
