"""The judge: its clients, and what it says."""

from __future__ import annotations

from typing import Final

from jauspy.messages.core import (
    ConfirmControl,
    RejectControl,
    ReportStatus,
    SetEmergency,
)

COP, C1, C2, C3, C4 = "42.1.1", "42.2.1", "42.2.2", "42.2.3", "42.2.4"
"""The judge's clients."""

ACCEPTED, NOT_AVAILABLE, INSUFFICIENT = ConfirmControl.ResponseCode
RELEASED = RejectControl.ResponseCode.CONTROL_RELEASED
Status = ReportStatus.Status
STOP: Final = SetEmergency.EmergencyCode.STOP
EVERYTHING: Final = 0xFFFF
