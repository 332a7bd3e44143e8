"""PrimitiveDriver: open-loop efforts, in percent of what the platform can do (AS6009)."""

from __future__ import annotations

from jauspy.messages.mobility import ReportWrenchEffort, SetWrenchEffort
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.units import percent


class PrimitiveDriver(Driver, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
    """Drives along x and turns about z; a platform of this kind has no other axes, and no brakes to set.

    A command counts as a whole: an effort that it leaves out is zero.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._linear_x = 0.0
        self._rotational_z = 0.0

    def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
        """Reached only in Ready, from the controlling client. JAUS turns right for positive z."""
        self._linear_x = percent(msg.propulsive_linear_effort_x)
        self._rotational_z = percent(msg.propulsive_rotational_effort_z)
        self.vehicle.pilot.push(self, forward=self._linear_x / 100.0, right=self._rotational_z / 100.0)

    def taken_over(self) -> None:
        """The efforts end."""
        self._linear_x = self._rotational_z = 0.0

    def report_wrench_effort(self) -> ReportWrenchEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service drives."""
        return ReportWrenchEffort(
            propulsive_linear_effort_x=self._linear_x, propulsive_rotational_effort_z=self._rotational_z
        )
