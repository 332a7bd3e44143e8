"""PrimitiveDriver: open-loop efforts, in percent of what the platform can do (AS6009)."""

from __future__ import annotations

from jauspy.messages.mobility import ReportWrenchEffort, SetWrenchEffort
from jauspy.platform.contract import DriveBase
from jauspy.services.service import Service


class PrimitiveDriver(Service, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
    """Drives along x and turns about z; a platform of this kind has no other axes, and no brakes to set.

    A command counts as a whole: an effort that it leaves out is zero.
    """

    def __init__(self, drive: DriveBase) -> None:
        self._drive = drive
        self._linear_x = 0.0
        self._rotational_z = 0.0

    def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
        """Reached only in Ready, from the controlling client. JAUS turns right for positive z, platforms left."""
        self._linear_x = msg.propulsive_linear_effort_x or 0.0
        self._rotational_z = msg.propulsive_rotational_effort_z or 0.0
        self._drive.set_effort(linear_x=self._linear_x / 100.0, rotational_z=-self._rotational_z / 100.0)

    def reset_travel_speed(self) -> None:
        """Runs when Ready is left, for whatever reason."""
        self._linear_x = self._rotational_z = 0.0
        self._drive.stop()

    def control_lost(self) -> None:
        """Another client's efforts must not go on under a new one, which may not know of them."""
        self.reset_travel_speed()

    def report_wrench_effort(self) -> ReportWrenchEffort:
        """The last commanded efforts, in percent."""
        return ReportWrenchEffort(
            propulsive_linear_effort_x=self._linear_x, propulsive_rotational_effort_z=self._rotational_z
        )
