"""urn:jauspy:cell:PartSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:PartSensor", "1.0")


@jd.message(_SERVICE, 0xFA66)
class ReportPartObservations(jd.Message):
    """ReportPartObservations (0xFA66): Tells what the sensor saw last.

    part_list: 0..1023 items. The parts that the sensor sees
    """

    @jd.record()
    class ObservationTimeRec(jd.Struct):
        """time: in second. When it was seen, in seconds of the time of the robot"""
        time: float = jd.field("Time", jd.Number("d", jd.ANY, "second"))

    @jd.record()
    class ObservedPartRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        type: up to 255 characters. Type of the part
        x: in meter. X of its frame, in metres
        y: in meter. Y of its frame, in metres
        z: in meter. Z of its frame, in metres
        orientation_w: W of the unit quaternion from the frame of the part to that of the world
        orientation_x: X of the unit quaternion from the frame of the part to that of the world
        orientation_y: Y of the unit quaternion from the frame of the part to that of the world
        orientation_z: Z of the unit quaternion from the frame of the part to that of the world
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        type: str = jd.field("Type", jd.Text(count=jd.Count("B", 0, 255)))
        x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
        y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
        z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
        orientation_w: float = jd.field("OrientationW", jd.Number("f"))
        orientation_x: float = jd.field("OrientationX", jd.Number("f"))
        orientation_y: float = jd.field("OrientationY", jd.Number("f"))
        orientation_z: float = jd.field("OrientationZ", jd.Number("f"))

    observation_time_rec: ReportPartObservations.ObservationTimeRec = jd.field("ObservationTimeRec", lambda: ReportPartObservations.ObservationTimeRec.layout())
    part_list: list[ReportPartObservations.ObservedPartRec] = jd.field("PartList", lambda: jd.Repeat(jd.Count("H", 0, 1023), ReportPartObservations.ObservedPartRec.layout()))


@jd.message(_SERVICE, 0xEA66, query=True)
class QueryPartObservations(jd.Message):
    """QueryPartObservations (0xEA66): Asks for what the sensor saw last."""
    REPORT = ReportPartObservations
