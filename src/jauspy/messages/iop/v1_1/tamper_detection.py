"""urn:jaus:jss:iop:TamperDetection 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:TamperDetection", "1.1")


@jd.message(_SERVICE, 0xDE68)
class ReportTamperDetectionStatus(jd.Message):
    """ReportTamperDetectionStatus (0xDE68): Tells whether the watch is on and what it found; a finding stays until it is cleared.

    current_state: CurrentState. Whether the watch is on
    tamper_status: Kinds of manipulation found
    description: up to 255 characters. Text on what was found
    """

    class CurrentState(IntEnum):
        DISABLED = 0
        ENABLED = 1
        ALWAYS_ENABLED = 2

    @jd.bit_field("H")
    class TamperStatus(jd.Struct):
        """Kinds of manipulation found.

        network_instrusion: bit 0. Network instrusion.
        physical_hardware_tamper: bit 1. Physical hardware tamper.
        electrical_tamper: bit 2. Electrical tamper.
        other: bit 3. Other.
        """
        network_instrusion: int = jd.bits(0, 0x1)
        physical_hardware_tamper: int = jd.bits(1, 0x1)
        electrical_tamper: int = jd.bits(2, 0x1)
        other: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    current_state: ReportTamperDetectionStatus.CurrentState | int = jd.field("CurrentState", lambda: jd.Number("B", jd.Values(ReportTamperDetectionStatus.CurrentState)))
    tamper_status: ReportTamperDetectionStatus.TamperStatus = jd.field("TamperStatus", lambda: ReportTamperDetectionStatus.TamperStatus.layout())
    description: str = jd.field("Description", jd.Text(count=jd.Count("B", 0, 255)))


@jd.message(_SERVICE, 0xDE67, query=True)
class QueryTamperDetectionStatus(jd.Message):
    """QueryTamperDetectionStatus (0xDE67): Asks what the watch has found."""
    REPORT = ReportTamperDetectionStatus


@jd.message(_SERVICE, 0xDE66, command=True)
class SetTamperDetectionState(jd.Message):
    """SetTamperDetectionState (0xDE66): Turns the watch on or off or clears earlier findings.

    state: State. What to do with the watch
    """

    class State(IntEnum):
        DISABLE = 0
        ENABLE = 1
        CLEAR = 2

    state: SetTamperDetectionState.State | int = jd.field("State", lambda: jd.Number("B", jd.Values(SetTamperDetectionState.State)))
