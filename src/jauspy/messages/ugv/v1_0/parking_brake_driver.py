"""urn:jaus:jss:ugv:ParkingBrakeDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:ParkingBrakeDriver", "1.0")


@jd.message(_SERVICE, 0x0512, command=True)
class SetParkingBrake(jd.Message):
    """SetParkingBrake (0x0512): Sets the parking brake.

    parking_brake: 0..100. Wanted braking, in percent of the maximum; 0 is released
    """
    parking_brake: float = jd.field("parkingBrake", jd.real("B", 0.0, 100.0))


@jd.message(_SERVICE, 0x4512)
class ReportParkingBrake(jd.Message):
    """ReportParkingBrake (0x4512): Tells the commanded and the actual parking brake.

    commanded_parking_brake: 0..100. Wanted braking, in percent of the maximum
    actual_parking_brake: 0..100. Present braking, in percent of the maximum
    """
    commanded_parking_brake: float = jd.field("commandedParkingBrake", jd.real("B", 0.0, 100.0))
    actual_parking_brake: float = jd.field("actualParkingBrake", jd.real("B", 0.0, 100.0))


@jd.message(_SERVICE, 0x2512, query=True)
class QueryParkingBrake(jd.Message):
    """QueryParkingBrake (0x2512): Asks for the parking brake."""
    REPORT = ReportParkingBrake
