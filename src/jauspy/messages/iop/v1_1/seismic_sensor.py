"""urn:jaus:jss:iop:SeismicSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:SeismicSensor", "1.1")


@jd.message(_SERVICE, 0xDAB8)
class ReportSeismicSensorStatus(jd.Message):
    """ReportSeismicSensorStatus (0xDAB8): Detections of the listed sensors.

    seismic_sensor_status_list: 0..255 items. One element per sensor
    """

    class CoordinateFrameEnum(IntEnum):
        SENSOR_RELATIVE = 0
        VEHICLE_RELATIVE = 1
        GLOBAL_RELATIVE = 2

    @jd.record("B")
    class SeismicSensorStatusRec(jd.Struct):
        """sensor_id: Sensor that the element is about; zero is not allowed
        coordinate_frame_enum: CoordinateFrameEnum, optional. Frame of the data below
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_frame_enum: ReportSeismicSensorStatus.CoordinateFrameEnum | int | None = jd.field("CoordinateFrameEnum", lambda: jd.Number("B", jd.Values(ReportSeismicSensorStatus.CoordinateFrameEnum)), default=None)
        reserved_presence: int = 0

    class IntensityChoice(IntEnum):
        OPTION0 = 0
        OPTION1 = 1

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.Number("f"), 1: jd.Number("f")}, jd.Values(ReportSeismicSensorStatus.IntensityChoice)))
    class Intensity(jd.Struct):
        """How strong the source's signal is.

        0: one
        1: one
        """
        choice: ReportSeismicSensorStatus.IntensityChoice | int
        value: float

    @jd.record("B")
    class SeismicSensorDataRec(jd.Struct):
        """range: 0..1000000 meter, optional. Distance to the source
        bearing: -3.14159265359..3.14159265359 radian, optional. Direction of the source as an angle about the z axis
        elevation: -3.14159265359..3.14159265359 radian, optional. Direction of the source as an angle about the y axis
        intensity: optional. How strong the source's signal is
        characterization: 0..99 or 100..255, optional. Kind of source, such as footsteps or a car
        """
        range: float | None = jd.field("Range", jd.real("I", 0.0, 1000000.0, "meter"), default=None)
        bearing: float | None = jd.field("Bearing", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        elevation: float | None = jd.field("Elevation", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        intensity: ReportSeismicSensorStatus.Intensity | None = jd.field("Intensity", lambda: ReportSeismicSensorStatus.Intensity.layout(), default=None)
        characterization: int | None = jd.field("Characterization", jd.Number("B", jd.Values(None, ((0, 99), (100, 255)))), default=None)
        reserved_presence: int = 0

    @jd.record()
    class SeismicSensorStatuSeq(jd.Struct):
        """seismic_sensor_data_list: 0..255 items. One element per source found"""
        seismic_sensor_status_rec: ReportSeismicSensorStatus.SeismicSensorStatusRec = jd.field("SeismicSensorStatusRec", lambda: ReportSeismicSensorStatus.SeismicSensorStatusRec.layout())
        seismic_sensor_data_list: list[ReportSeismicSensorStatus.SeismicSensorDataRec] = jd.field("SeismicSensorDataList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportSeismicSensorStatus.SeismicSensorDataRec.layout()))

    seismic_sensor_status_list: list[ReportSeismicSensorStatus.SeismicSensorStatuSeq] = jd.field("SeismicSensorStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportSeismicSensorStatus.SeismicSensorStatuSeq.layout()))


@jd.message(_SERVICE, 0xDAB7, query=True)
class QuerySeismicSensorStatus(jd.Message):
    """QuerySeismicSensorStatus (0xDAB7): Asks for the detections of the listed sensors.

    query_seismic_sensor_list: 0..255 items. One element per sensor asked about
    """
    REPORT = ReportSeismicSensorStatus

    @jd.record()
    class QuerySeismicSensorRec(jd.Struct):
        """sensor_id: Sensor asked about; zero stands for all of them"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_seismic_sensor_list: list[QuerySeismicSensorStatus.QuerySeismicSensorRec] = jd.field("QuerySeismicSensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), QuerySeismicSensorStatus.QuerySeismicSensorRec.layout()))
