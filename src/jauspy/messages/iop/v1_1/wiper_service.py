"""urn:jaus:jss:iop:WiperService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:WiperService", "1.1")


@jd.message(_SERVICE, 0xD7C3, presence="H")
class ReportWiperCapabilities(jd.Message):
    """ReportWiperCapabilities (0xD7C3): Lists the supported wiping modes and, where known, their timing.

    wiper_capabilities: Supported modes; a set bit marks a mode the hardware has
    low_period: 0..25.5 second, optional. Cycle time of LowPeriodic, start of a wipe to start of the next
    medium_period: 0..25.5 second, optional. Cycle time of MediumPeriodic
    high_period: 0..25.5 second, optional. Cycle time of HighPeriodic
    low_interval_period: 0..25.5 second, optional. Cycle time of LowInterval, pause included
    medium_interval_period: 0..25.5 second, optional. Cycle time of MediumInterval, pause included
    high_interval_period: 0..25.5 second, optional. Cycle time of HighInterval, pause included
    low_interval_delay: 0..25.5 second, optional. Pause of LowInterval, end of a wipe to start of the next
    medium_interval_delay: 0..25.5 second, optional. Pause of MediumInterval between two wipes
    high_interval_delay: 0..25.5 second, optional. Pause of HighInterval between two wipes
    """

    @jd.bit_field("B")
    class WiperCapabilities(jd.Struct):
        """Supported modes; a set bit marks a mode the hardware has.

        one_shot: bit 0. One shot.
        low_periodic: bit 1. Low periodic.
        medium_periodic: bit 2. Medium periodic.
        high_periodic: bit 3. High periodic.
        low_interval: bit 4. Low interval.
        medium_interval: bit 5. Medium interval.
        high_interval: bit 6. High interval.
        """
        one_shot: int = jd.bits(0, 0x1)
        low_periodic: int = jd.bits(1, 0x1)
        medium_periodic: int = jd.bits(2, 0x1)
        high_periodic: int = jd.bits(3, 0x1)
        low_interval: int = jd.bits(4, 0x1)
        medium_interval: int = jd.bits(5, 0x1)
        high_interval: int = jd.bits(6, 0x1)
        reserved_bits: int = 0

    wiper_capabilities: ReportWiperCapabilities.WiperCapabilities = jd.field("WiperCapabilities", lambda: ReportWiperCapabilities.WiperCapabilities.layout())
    low_period: float | None = jd.field("LowPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    medium_period: float | None = jd.field("MediumPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    high_period: float | None = jd.field("HighPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    low_interval_period: float | None = jd.field("LowIntervalPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    medium_interval_period: float | None = jd.field("MediumIntervalPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    high_interval_period: float | None = jd.field("HighIntervalPeriod", jd.real("B", 0.0, 25.5, "second"), default=None)
    low_interval_delay: float | None = jd.field("LowIntervalDelay", jd.real("B", 0.0, 25.5, "second"), default=None)
    medium_interval_delay: float | None = jd.field("MediumIntervalDelay", jd.real("B", 0.0, 25.5, "second"), default=None)
    high_interval_delay: float | None = jd.field("HighIntervalDelay", jd.real("B", 0.0, 25.5, "second"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xD7C0, query=True)
class QueryWiperCapabilities(jd.Message):
    """QueryWiperCapabilities (0xD7C0): Asks which wiping modes the hardware offers."""
    REPORT = ReportWiperCapabilities


@jd.message(_SERVICE, 0xD7C4)
class ReportWiperStatus(jd.Message):
    """ReportWiperStatus (0xD7C4): Tells which wiping mode is in use.

    wiper_status: WiperStatus. Mode in use
    """

    class WiperStatus(IntEnum):
        OFF = 0
        ONE_SHOT_ACTIVE = 1
        LOW_PERIODIC = 2
        MEDIUM_PERIODIC = 3
        HIGH_PERIODIC = 4
        LOW_INTERVAL = 5
        MEDIUM_INTERVAL = 6
        HIGH_INTERVAL = 7

    wiper_status: ReportWiperStatus.WiperStatus | int = jd.field("WiperStatus", lambda: jd.Number("B", jd.Values(ReportWiperStatus.WiperStatus)))


@jd.message(_SERVICE, 0xD7C1, query=True)
class QueryWiperStatus(jd.Message):
    """QueryWiperStatus (0xD7C1): Asks for the wiping mode now in use."""
    REPORT = ReportWiperStatus


@jd.message(_SERVICE, 0xD7C2, command=True)
class SetWiperStatus(jd.Message):
    """SetWiperStatus (0xD7C2): Selects the wiping mode.

    wiper_status: WiperStatus. Wanted mode
    """

    class WiperStatus(IntEnum):
        OFF = 0
        ONE_SHOT_ACTIVE = 1
        LOW_PERIODIC = 2
        MEDIUM_PERIODIC = 3
        HIGH_PERIODIC = 4
        LOW_INTERVAL = 5
        MEDIUM_INTERVAL = 6
        HIGH_INTERVAL = 7

    wiper_status: SetWiperStatus.WiperStatus | int = jd.field("WiperStatus", lambda: jd.Number("B", jd.Values(SetWiperStatus.WiperStatus)))
