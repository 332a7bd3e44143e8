"""urn:jaus:jss:HMI:DigitalControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:HMI:DigitalControl", "1.0")


@jd.message(_SERVICE, 0x4706)
class ReportDCM(jd.Message):
    """ReportDCM (0x4706): Tells that a control was pressed or released.

    dcm_reference: Which control was used
    dcm_state_code: DCMStateCode. Whether the control was pressed or released
    """

    class DCMStateCode(IntEnum):
        PRESSED = 0
        RELEASED = 1

    dcm_reference: int = jd.field("DCMReference", jd.Number("H"))
    dcm_state_code: ReportDCM.DCMStateCode | int = jd.field("DCMStateCode", lambda: jd.Number("b", jd.Values(ReportDCM.DCMStateCode)))


@jd.message(_SERVICE, 0x2706, query=True)
class QueryDCM(jd.Message):
    """QueryDCM (0x2706): Asks for the control that was used."""
    REPORT = ReportDCM


@jd.message(_SERVICE, 0x0706, command=True)
class SetDCM(jd.Message):
    """SetDCM (0x0706): Sets how a control looks.

    dcm_reference: Which control is meant
    dcm_state_code: How the control is to look
    """

    class Updown(IntEnum):
        RELEASED = 0
        PRESSED = 1

    class Active(IntEnum):
        INACTIVE = 0
        ACTIVE = 1

    class Flash(IntEnum):
        STEADY = 0
        FLASHING = 1

    @jd.bit_field("B")
    class DCMStateCode(jd.Struct):
        """How the control is to look.

        updown: bit 0. Whether it looks pressed.
        active: bit 1. Whether it can be used.
        flash: bit 2. Whether it flashes.
        flash_rate: bits 3..4. How fast it flashes, from 0 to 3.
        """
        updown: SetDCM.Updown | int = jd.bits(0, 0x1, lambda: jd.Values(SetDCM.Updown))
        active: SetDCM.Active | int = jd.bits(1, 0x1, lambda: jd.Values(SetDCM.Active))
        flash: SetDCM.Flash | int = jd.bits(2, 0x1, lambda: jd.Values(SetDCM.Flash))
        flash_rate: int = jd.bits(3, 0x3, jd.Values(None, ((0, 3),)))
        reserved_bits: int = 0

    dcm_reference: int = jd.field("DCMReference", jd.Number("H"))
    dcm_state_code: SetDCM.DCMStateCode = jd.field("DCMStateCode", lambda: SetDCM.DCMStateCode.layout())
