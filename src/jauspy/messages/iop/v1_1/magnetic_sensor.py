"""urn:jaus:jss:iop:MagneticSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:MagneticSensor", "1.1")


@jd.message(_SERVICE, 0xDABA)
class ReportMagneticSensorStatus(jd.Message):
    """ReportMagneticSensorStatus (0xDABA): Tells the readings of the sensors.

    magnetic_sensor_status_list: 0..255 items. One element a sensor
    """

    class CoordinateFrameEnum(IntEnum):
        SENSOR_RELATIVE = 0
        VEHICLE_RELATIVE = 1
        GLOBAL_RELATIVE = 2

    @jd.record("B")
    class MagneticSensorStatusRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 is not allowed
        coordinate_frame_enum: CoordinateFrameEnum, optional. Frame that the readings' axes belong to
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_frame_enum: ReportMagneticSensorStatus.CoordinateFrameEnum | int | None = jd.field("CoordinateFrameEnum", lambda: jd.Number("B", jd.Values(ReportMagneticSensorStatus.CoordinateFrameEnum)), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class MagneticSensorDataRec(jd.Struct):
        """magnetic_x: optional. Field strength along x
        magnetic_y: optional. Field strength along y
        magnetic_z: optional. Field strength along z
        """
        magnetic_x: float | None = jd.field("MagneticX", jd.Number("d"), default=None)
        magnetic_y: float | None = jd.field("MagneticY", jd.Number("d"), default=None)
        magnetic_z: float | None = jd.field("MagneticZ", jd.Number("d"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class MagneticSensorStatuSeq(jd.Struct):
        """magnetic_sensor_data_list: 0..255 items. One element a reading"""
        magnetic_sensor_status_rec: ReportMagneticSensorStatus.MagneticSensorStatusRec = jd.field("MagneticSensorStatusRec", lambda: ReportMagneticSensorStatus.MagneticSensorStatusRec.layout())
        magnetic_sensor_data_list: list[ReportMagneticSensorStatus.MagneticSensorDataRec] = jd.field("MagneticSensorDataList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMagneticSensorStatus.MagneticSensorDataRec.layout()))

    magnetic_sensor_status_list: list[ReportMagneticSensorStatus.MagneticSensorStatuSeq] = jd.field("MagneticSensorStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMagneticSensorStatus.MagneticSensorStatuSeq.layout()))


@jd.message(_SERVICE, 0xDAB9, query=True)
class QueryMagneticSensorStatus(jd.Message):
    """QueryMagneticSensorStatus (0xDAB9): Asks for the readings of the listed sensors.

    query_magnetic_sensor_list: 0..255 items. Sensors asked about
    """
    REPORT = ReportMagneticSensorStatus

    @jd.record()
    class QueryMagneticSensorRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 stands for every sensor"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_magnetic_sensor_list: list[QueryMagneticSensorStatus.QueryMagneticSensorRec] = jd.field("QueryMagneticSensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryMagneticSensorStatus.QueryMagneticSensorRec.layout()))
