"""urn:jaus:jss:iop:MeasurementSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:MeasurementSensor", "1.1")


@jd.message(_SERVICE, 0xF92B, presence="B")
class ReportMeasurement(jd.Message):
    """ReportMeasurement (0xF92B): Tells readings.

    device_rec: The device
    readings_list: 0..255 items. The readings
    global_pose_rec: optional. A pose on the globe
    timestamp_rec: optional. Time of the readings
    """
    DeviceRec = iop_v1_0_types.DeviceRec
    ReadingRec = iop_v1_0_types.ReadingRec
    ValueRec = iop_v1_0_types.ValueRec
    GlobalPoseRec = iop_v1_0_types.GlobalPoseRec
    TimestampRec = iop_v1_0_types.TimestampRec

    @jd.record()
    class ReadingSeq(jd.Struct):
        """reading_rec: One reading
        value_list: 0..255 items. The values
        """
        reading_rec: iop_v1_0_types.ReadingRec = jd.field("ReadingRec", lambda: iop_v1_0_types.ReadingRec.layout())
        value_list: list[iop_v1_0_types.ValueRec] = jd.field("ValueList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.ValueRec.layout()))

    device_rec: iop_v1_0_types.DeviceRec = jd.field("DeviceRec", lambda: iop_v1_0_types.DeviceRec.layout())
    readings_list: list[ReportMeasurement.ReadingSeq] = jd.field("ReadingsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMeasurement.ReadingSeq.layout()))
    global_pose_rec: iop_v1_0_types.GlobalPoseRec | None = jd.field("GlobalPoseRec", lambda: iop_v1_0_types.GlobalPoseRec.layout(), default=None)
    timestamp_rec: iop_v1_0_types.TimestampRec | None = jd.field("TimestampRec", lambda: iop_v1_0_types.TimestampRec.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xF92A, query=True)
class QueryMeasurement(jd.Message):
    """QueryMeasurement (0xF92A): Asks for readings."""
    REPORT = ReportMeasurement
