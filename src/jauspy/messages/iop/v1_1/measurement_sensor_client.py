"""urn:jaus:jss:iop:MeasurementSensorClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.iop.v1_1 import measurement_sensor as iop_v1_1_measurement_sensor


class ReportMeasurement(iop_v1_1_measurement_sensor.ReportMeasurement):
    """ReportMeasurement (0xF92B): Tells readings."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:MeasurementSensorClient"
    VERSION = "1.1"


class QueryMeasurement(iop_v1_1_measurement_sensor.QueryMeasurement):
    """QueryMeasurement (0xF92A): Asks for readings."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:MeasurementSensorClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportMeasurement]]


QueryMeasurement.REPORT = ReportMeasurement
