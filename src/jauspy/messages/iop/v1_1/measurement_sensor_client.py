"""urn:jaus:jss:iop:MeasurementSensorClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_1 import measurement_sensor as iop_v1_1_measurement_sensor

_SERVICE = jd.Service("urn:jaus:jss:iop:MeasurementSensorClient", "1.1")

@jd.derived(_SERVICE)
class ReportMeasurement(iop_v1_1_measurement_sensor.ReportMeasurement): ...

@jd.derived(_SERVICE)
class QueryMeasurement(iop_v1_1_measurement_sensor.QueryMeasurement):
    REPORT = ReportMeasurement
