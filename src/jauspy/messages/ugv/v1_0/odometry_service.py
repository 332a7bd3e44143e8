"""urn:jaus:jss:ugv:OdometryService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:OdometryService", "1.0")


@jd.message(_SERVICE, 0x0515, command=True)
class ResetOdometry(jd.Message):
    """ResetOdometry (0x0515): Sets a trip to zero.

    odometry_type: OdometryType. Which trip to set to zero
    """

    class OdometryType(IntEnum):
        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odometry_type: ResetOdometry.OdometryType | int = jd.field("OdometryType", lambda: jd.Number("B", jd.Values(ResetOdometry.OdometryType)))


@jd.message(_SERVICE, 0x4515)
class ReportOdometry(jd.Message):
    """ReportOdometry (0x4515): Tells a distance travelled.

    odom: Odom. Which distance; that of the platform cannot be reset
    odometry: in meter. Distance, in metres
    """

    class Odom(IntEnum):
        PLATFORM = 1
        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odom: ReportOdometry.Odom | int = jd.field("odom", lambda: jd.Number("B", jd.Values(ReportOdometry.Odom)))
    odometry: int = jd.field("odometry", jd.Number("I", jd.ANY, "meter"))


@jd.message(_SERVICE, 0x2515, query=True)
class QueryOdometry(jd.Message):
    """QueryOdometry (0x2515): Asks for a distance travelled.

    odom: Odom. Which distance; that of the platform cannot be reset
    """
    REPORT = ReportOdometry

    class Odom(IntEnum):
        PLATFORM = 1
        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odom: QueryOdometry.Odom | int = jd.field("odom", lambda: jd.Number("B", jd.Values(QueryOdometry.Odom)))
