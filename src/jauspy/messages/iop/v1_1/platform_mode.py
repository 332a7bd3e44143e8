"""urn:jaus:jss:iop:PlatformMode 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:PlatformMode", "1.1")


@jd.message(_SERVICE, 0xFF20, command=True)
class SetPlatformMode(jd.Message):
    """SetPlatformMode (0xFF20): Sets the mode.

    platform_mode: PlatformMode or 175..255. The mode
    """

    class PlatformMode(IntEnum):
        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    platform_mode: SetPlatformMode.PlatformMode | int = jd.field("PlatformMode", lambda: jd.Number("B", jd.Values(SetPlatformMode.PlatformMode, ((175, 255),))))


@jd.message(_SERVICE, 0xFF23)
class ReportPlatformMode(jd.Message):
    """ReportPlatformMode (0xFF23): Tells the mode and whether it is changing.

    platform_mode: PlatformMode. The mode
    status: Status. Whether the mode is being entered, active or being left
    """

    class PlatformMode(IntEnum):
        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    class Status(IntEnum):
        INITIALIZING = 0
        ACTIVE = 1
        EXITING = 2

    platform_mode: ReportPlatformMode.PlatformMode | int = jd.field("PlatformMode", lambda: jd.Number("B", jd.Values(ReportPlatformMode.PlatformMode)))
    status: ReportPlatformMode.Status | int = jd.field("Status", lambda: jd.Number("B", jd.Values(ReportPlatformMode.Status)))


@jd.message(_SERVICE, 0xFF21, query=True)
class QueryPlatformMode(jd.Message):
    """QueryPlatformMode (0xFF21): Asks for the mode."""
    REPORT = ReportPlatformMode


@jd.message(_SERVICE, 0xFF24)
class ReportSupportedPlatformModes(jd.Message):
    """ReportSupportedPlatformModes (0xFF24): Tells which modes there are.

    supported_platform_modes_list: 0..255 items. The modes
    """

    class PlatformMode(IntEnum):
        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    @jd.record()
    class PlatformModeRec(jd.Struct):
        """One mode.

        platform_mode: PlatformMode or 175..255. The mode
        """
        platform_mode: ReportSupportedPlatformModes.PlatformMode | int = jd.field("PlatformMode", lambda: jd.Number("B", jd.Values(ReportSupportedPlatformModes.PlatformMode, ((175, 255),))))

    supported_platform_modes_list: list[ReportSupportedPlatformModes.PlatformModeRec] = jd.field("SupportedPlatformModesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportSupportedPlatformModes.PlatformModeRec.layout()))


@jd.message(_SERVICE, 0xFF22, query=True)
class QuerySupportedPlatformModes(jd.Message):
    """QuerySupportedPlatformModes (0xFF22): Asks which modes there are."""
    REPORT = ReportSupportedPlatformModes
