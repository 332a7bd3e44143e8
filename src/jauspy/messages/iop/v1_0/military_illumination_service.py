"""urn:jaus:jss:iop:MilitaryIlluminationService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:MilitaryIlluminationService", "1.0")


@jd.message(_SERVICE, 0xB514)
class ReportMilitaryIlluminationMode(jd.Message):
    """ReportMilitaryIlluminationMode (0xB514): Tells whether blackout mode is on.

    blackout_mode: Blackout_mode. Whether the bit fields of the parent service stand for military lamps (ON) or the usual ones (OFF)
    """

    class Blackout_mode(IntEnum):
        OFF = 0
        ON = 1

    blackout_mode: ReportMilitaryIlluminationMode.Blackout_mode | int = jd.field("Blackout_mode", lambda: jd.Number("B", jd.Values(ReportMilitaryIlluminationMode.Blackout_mode)))


@jd.message(_SERVICE, 0xB513, query=True)
class QueryMilitaryIlluminationMode(jd.Message):
    """QueryMilitaryIlluminationMode (0xB513): Asks whether blackout mode is on."""
    REPORT = ReportMilitaryIlluminationMode


@jd.message(_SERVICE, 0xB514, command=True)
class SetMilitaryIlluminationMode(jd.Message):
    """SetMilitaryIlluminationMode (0xB514): Turns blackout mode on or off.

    blackout_mode: Blackout_mode. Whether the bit fields of the parent service stand for military lamps (ON) or the usual ones (OFF)
    """

    class Blackout_mode(IntEnum):
        OFF = 0
        ON = 1

    blackout_mode: SetMilitaryIlluminationMode.Blackout_mode | int = jd.field("Blackout_mode", lambda: jd.Number("B", jd.Values(SetMilitaryIlluminationMode.Blackout_mode)))
