"""urn:jaus:jss:iop:DebrisBlowerService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:DebrisBlowerService", "1.1")


@jd.message(_SERVICE, 0xD7BB)
class ReportDebrisBlowerCapabilities(jd.Message):
    """ReportDebrisBlowerCapabilities (0xD7BB): Tells what the blower can do; equal minimum and maximum means that the angle is fixed.

    speed_capabilities: Blowing strengths on offer (1 for yes)
    minimum_azimuth: -3.14159265359..3.14159265359 radian. Smallest horizontal angle of the jet; 0 is straight ahead
    maximum_azimuth: -3.14159265359..3.14159265359 radian. Largest horizontal angle of the jet; 0 is straight ahead
    minimum_elevation: -1.57079632679..1.57079632679 radian. Smallest vertical angle of the jet; 0 is level with the ground
    maximum_elevation: -1.57079632679..1.57079632679 radian. Largest vertical angle of the jet; 0 is level with the ground
    """

    @jd.bit_field("B")
    class SpeedCapabilities(jd.Struct):
        """Blowing strengths on offer (1 for yes).

        on_single_speed: bit 0. ON single speed.
        on_low: bit 1. ON low.
        on_medium: bit 2. ON medium.
        on_high: bit 3. ON high.
        """
        on_single_speed: int = jd.bits(0, 0x1)
        on_low: int = jd.bits(1, 0x1)
        on_medium: int = jd.bits(2, 0x1)
        on_high: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    speed_capabilities: ReportDebrisBlowerCapabilities.SpeedCapabilities = jd.field("SpeedCapabilities", lambda: ReportDebrisBlowerCapabilities.SpeedCapabilities.layout())
    minimum_azimuth: float = jd.field("MinimumAzimuth", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    maximum_azimuth: float = jd.field("MaximumAzimuth", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
    minimum_elevation: float = jd.field("MinimumElevation", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"))
    maximum_elevation: float = jd.field("MaximumElevation", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"))


@jd.message(_SERVICE, 0xD7B8, query=True)
class QueryDebrisBlowerCapabilities(jd.Message):
    """QueryDebrisBlowerCapabilities (0xD7B8): Asks what the blower can do."""
    REPORT = ReportDebrisBlowerCapabilities


@jd.message(_SERVICE, 0xD7BC, presence="B")
class ReportDebrisBlowerConfiguration(jd.Message):
    """ReportDebrisBlowerConfiguration (0xD7BC): Tells the blower's present setting.

    on_off_status: OnOffStatus, optional. Blowing strength
    azimuth: -3.14159265359..3.14159265359 radian, optional. Commanded horizontal angle of the jet; 0 is straight ahead
    elevation: -1.57079632679..1.57079632679 radian, optional. Commanded vertical angle of the jet; 0 is level with the ground
    """

    class OnOffStatus(IntEnum):
        OFF = 0
        ON_SINGLE_SPEED = 1
        ON_LOW = 2
        ON_MEDIUM = 3
        ON_HIGH = 4

    on_off_status: ReportDebrisBlowerConfiguration.OnOffStatus | int | None = jd.field("OnOffStatus", lambda: jd.Number("B", jd.Values(ReportDebrisBlowerConfiguration.OnOffStatus)), default=None)
    azimuth: float | None = jd.field("Azimuth", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    elevation: float | None = jd.field("Elevation", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xD7B9, query=True)
class QueryDebrisBlowerConfiguration(jd.Message):
    """QueryDebrisBlowerConfiguration (0xD7B9): Asks for the blower's present setting."""
    REPORT = ReportDebrisBlowerConfiguration


@jd.message(_SERVICE, 0xD7BA, presence="B", command=True)
class SetDebrisBlowerConfiguration(jd.Message):
    """SetDebrisBlowerConfiguration (0xD7BA): Switches and aims the blower; values it cannot do may make it ignore the message.

    on_off_status: OnOffStatus, optional. Blowing strength
    azimuth: -3.14159265359..3.14159265359 radian, optional. Wanted horizontal angle of the jet; 0 is straight ahead, right is positive
    elevation: -1.57079632679..1.57079632679 radian, optional. Wanted vertical angle of the jet; 0 is level with the ground, up is positive
    """

    class OnOffStatus(IntEnum):
        OFF = 0
        ON_SINGLE_SPEED = 1
        ON_LOW = 2
        ON_MEDIUM = 3
        ON_HIGH = 4

    on_off_status: SetDebrisBlowerConfiguration.OnOffStatus | int | None = jd.field("OnOffStatus", lambda: jd.Number("B", jd.Values(SetDebrisBlowerConfiguration.OnOffStatus)), default=None)
    azimuth: float | None = jd.field("Azimuth", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"), default=None)
    elevation: float | None = jd.field("Elevation", jd.real("H", -1.5707963267948966, 1.5707963267948966, "radian"), default=None)
    reserved_presence: int = 0
