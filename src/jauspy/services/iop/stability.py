"""StabilityControl: switches the aids that keep a robot from tipping over (IOP v3)."""

from __future__ import annotations

from dataclasses import fields

from jauspy.messages.iop import (
    ReportStabilityControlCapabilities,
    ReportStabilityControlStatus,
    SetStabilityControlStatus,
)
from jauspy.platform.stability import StabilityMonitor
from jauspy.services.service import Service


class StabilityControl(Service, urn="urn:jaus:jss:iop:StabilityControlService"):
    """Two aids: against tipping forward or backward, and against tipping to a side.

    A message that switches on an aid that the robot lacks is ignored and counted.
    """

    def __init__(self, stability: StabilityMonitor) -> None:
        self._stability = stability

    def set_stability_control_status(self, msg: SetStabilityControlStatus) -> None:
        """Switch both aids on or off, as told by the client in control."""
        wanted = msg.stability_control_status
        names = {field.name for field in fields(wanted) if not field.name.startswith("reserved")}
        if any(getattr(wanted, name) for name in names - {"active_pitchover_control", "active_rollover_control"}):
            self.host.count("missing_aid", f"{msg}")
            return
        self._stability.pitchover = bool(wanted.active_pitchover_control)
        self._stability.rollover = bool(wanted.active_rollover_control)

    def send_report_stability_control_capabilities(self) -> ReportStabilityControlCapabilities:
        """Both aids (D7CB)."""
        kind = ReportStabilityControlCapabilities
        return kind(kind.StabilityControlStatus(**_bits(kind.StabilityControlStatus, pitchover=True, rollover=True)))

    def send_report_stability_control_status(self) -> ReportStabilityControlStatus:
        """The aids that are on (D7CC)."""
        kind, stability = ReportStabilityControlStatus, self._stability
        bits = _bits(kind.StabilityControlStatus, pitchover=stability.pitchover, rollover=stability.rollover)
        return kind(kind.StabilityControlStatus(**bits))


def _bits(kind: type, *, pitchover: bool, rollover: bool) -> dict[str, int]:
    """All bits of the field, by name."""
    bits = dict.fromkeys((field.name for field in fields(kind)), 0)
    return bits | {"active_pitchover_control": int(pitchover), "active_rollover_control": int(rollover)}
