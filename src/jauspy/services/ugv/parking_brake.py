"""ParkingBrakeDriver: sets and reports the parking brake (AS6091)."""

from __future__ import annotations

from jauspy.messages.ugv import ReportParkingBrake, SetParkingBrake
from jauspy.platform.drives import ParkingBrake
from jauspy.services.service import Service


class ParkingBrakeDriver(Service, urn="urn:jaus:jss:ugv:ParkingBrakeDriver"):
    """A brake that is either engaged or released: it engages fully at any level above zero percent.

    A client in control may engage it in any state, and release it only in Ready. When Ready is left, it engages.
    """

    def __init__(self, brake: ParkingBrake) -> None:
        self._brake = brake
        self._commanded = 100.0 if brake.engaged else 0.0

    def is_engage(self, msg: SetParkingBrake) -> bool:
        """True if the message does not release the brake."""
        return msg.parking_brake > 0.0

    def set_brake_level(self, msg: SetParkingBrake) -> None:
        """Engage or release the brake."""
        self._set(msg.parking_brake)

    def engage_brake(self) -> None:
        """Engage the brake; runs when Ready is left."""
        self._set(100.0)

    def send_report_parking_brake(self) -> ReportParkingBrake:
        """The commanded level, and 100 or 0 percent as the present one."""
        return ReportParkingBrake(self._commanded, 100.0 if self._brake.engaged else 0.0)

    def _set(self, level: float) -> None:
        self._commanded = level
        self._brake.set(level > 0.0)
