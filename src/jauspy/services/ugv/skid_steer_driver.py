"""SkidSteerDriver: open-loop efforts of the left and the right track (AS6091)."""

from __future__ import annotations

from jauspy.messages.ugv import ReportSkidSteerEffort, SetSkidSteerEffort
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.units import percent


class SkidSteerDriver(Driver, urn="urn:jaus:jss:ugv:SkidSteerDriver"):
    """Percent of the full effort of each side, positive forward; shares the chassis with the drivers of mobility."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._left = self._right = 0.0

    def set_skid_steer_effort(self, msg: SetSkidSteerEffort) -> None:
        """Reached only in Ready, from the controlling client."""
        self._left = percent(msg.left_side_propulsive_effort)
        self._right = percent(msg.right_side_propulsive_effort)
        forward, right = (self._left + self._right) / 200.0, (self._left - self._right) / 200.0
        self.vehicle.pilot.set_effort(self, forward=forward, right=right)

    def stop_motion(self) -> None:
        """Runs when Ready is left, for whatever reason."""
        self.vehicle.pilot.stop()

    def on_preempted(self) -> None:
        """The efforts end."""
        self._left = self._right = 0.0

    def send_report_skid_steer_effort(self) -> ReportSkidSteerEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service drives."""
        return ReportSkidSteerEffort(left_side_propulsive_effort=self._left, right_side_propulsive_effort=self._right)
