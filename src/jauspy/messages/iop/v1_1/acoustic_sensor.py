"""urn:jaus:jss:iop:AcousticSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:AcousticSensor", "1.1")


@jd.message(_SERVICE, 0xDAB6)
class ReportAcousticSensorStatus(jd.Message):
    """ReportAcousticSensorStatus (0xDAB6): Tells what each acoustic sensor has heard.

    acoustic_sensor_status_list: 0..255 items. One entry a sensor
    """

    class CoordinateFrameEnum(IntEnum):
        SENSOR_RELATIVE = 0
        VEHICLE_RELATIVE = 1
        GLOBAL_RELATIVE = 2

    @jd.record("B")
    class AcousticSensorStatusRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 must not be used
        coordinate_frame_enum: CoordinateFrameEnum, optional. Frame the positions below refer to
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_frame_enum: ReportAcousticSensorStatus.CoordinateFrameEnum | int | None = jd.field("CoordinateFrameEnum", lambda: jd.Number("B", jd.Values(ReportAcousticSensorStatus.CoordinateFrameEnum)), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class AcousticSensorDataRec(jd.Struct):
        """range: 0..1000000 meter, optional. How far away the source is
        bearing: -3.14159265359..3.14159265359 radian, optional. Direction of the source as angle around Z
        elevation: -3.14159265359..3.14159265359 radian, optional. Direction of the source as angle around Y
        intensity: optional. Strength of the sound
        characterization: 0..99 or 100..255, optional. Class of the sound, such as the kind of weapon
        """
        range: float | None = jd.field("Range", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        bearing: float | None = jd.field("Bearing", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        elevation: float | None = jd.field("Elevation", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        intensity: float | None = jd.field("Intensity", jd.Number("f"), default=None)
        characterization: int | None = jd.field("Characterization", jd.Number("B", jd.Values(None, ((0, 99), (100, 255)))), default=None)
        reserved_presence: int = 0

    @jd.record()
    class AcousticSensorStatuSeq(jd.Struct):
        """acoustic_sensor_data_list: 0..255 items. One entry a detected source of sound"""
        acoustic_sensor_status_rec: ReportAcousticSensorStatus.AcousticSensorStatusRec = jd.field("AcousticSensorStatusRec", lambda: ReportAcousticSensorStatus.AcousticSensorStatusRec.layout())
        acoustic_sensor_data_list: list[ReportAcousticSensorStatus.AcousticSensorDataRec] = jd.field("AcousticSensorDataList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAcousticSensorStatus.AcousticSensorDataRec.layout()))

    acoustic_sensor_status_list: list[ReportAcousticSensorStatus.AcousticSensorStatuSeq] = jd.field("AcousticSensorStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAcousticSensorStatus.AcousticSensorStatuSeq.layout()))


@jd.message(_SERVICE, 0xDAB5, query=True)
class QueryAcousticSensorStatus(jd.Message):
    """QueryAcousticSensorStatus (0xDAB5): Asks for the detections of the named acoustic sensors.

    query_acoustic_sensor_list: 0..255 items. Sensors the question is about
    """
    REPORT = ReportAcousticSensorStatus

    @jd.record()
    class QueryAcousticSensorRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 stands for every sensor"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_acoustic_sensor_list: list[QueryAcousticSensorStatus.QueryAcousticSensorRec] = jd.field("QueryAcousticSensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryAcousticSensorStatus.QueryAcousticSensorRec.layout()))
