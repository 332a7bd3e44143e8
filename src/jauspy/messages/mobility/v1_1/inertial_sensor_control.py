"""urn:jaus:jss:mobility:InertialSensorControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:InertialSensorControl", "1.1")


@jd.message(_SERVICE, 0x0429, command=True)
class InertialSensorControl(jd.Message):
    """InertialSensorControl (0x0429): Switches the sensor off or on, or restarts it.

    command: Command. What to do with the sensor
    """

    class Command(IntEnum):
        OFF = 0
        ON = 1
        RESTART = 2

    command: InertialSensorControl.Command | int = jd.field("Command", lambda: jd.Number("B", jd.Values(InertialSensorControl.Command)))


@jd.message(_SERVICE, 0x4429)
class ReportInertialSensorStatus(jd.Message):
    """ReportInertialSensorStatus (0x4429): Tells power and alignment of the sensor.

    power_state: PowerState. Whether the sensor is on
    operating_state: OperatingState. How far the alignment has got
    """

    class PowerState(IntEnum):
        OFF = 0
        ON = 1
        RESTARTING = 2

    class OperatingState(IntEnum):
        INIT = 0
        OPERATIONAL = 1
        COARSE_STATIONARY_ALIGNMENT = 2
        COARSE_GPS_ALIGNMENT = 3
        FINE_STATIONARY_ALIGNMENT_STARTED = 4
        FINE_STATIONARY_ALIGNMENT_COMPLETE = 5
        FINE_GPS_ALIGNMENT_STARTED = 6
        FINE_GPS_ALIGNMENT_COMPLETE = 7
        INERTIAL_SENSOR_FAILURE = 8

    power_state: ReportInertialSensorStatus.PowerState | int = jd.field("PowerState", lambda: jd.Number("B", jd.Values(ReportInertialSensorStatus.PowerState)))
    operating_state: ReportInertialSensorStatus.OperatingState | int = jd.field("OperatingState", lambda: jd.Number("B", jd.Values(ReportInertialSensorStatus.OperatingState)))


@jd.message(_SERVICE, 0x2429, query=True)
class QueryInertialSensorStatus(jd.Message):
    """QueryInertialSensorStatus (0x2429): Asks for power and alignment of the sensor."""
    REPORT = ReportInertialSensorStatus
