"""The sensors of a pan-tilt unit: angles, and how fast they change (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportPanTiltJointPositions, ReportPanTiltJointVelocity
from jauspy.services.manipulator.pan_tilt import PanTilt
from jauspy.services.service import Service


class PanTiltJointPositionSensor(Service, urn="urn:jaus:jss:manipulator:PanTiltJointPositionSensor"):
    """Radians, positive to the right and upwards."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_joint_positions(self) -> ReportPanTiltJointPositions:
        """Where the unit looks."""
        return ReportPanTiltJointPositions(*self._unit.state().positions)


class PanTiltJointVelocitySensor(Service, urn="urn:jaus:jss:manipulator:PanTiltJointVelocitySensor"):
    """rad/s, positive to the right and upwards."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_joint_velocity(self) -> ReportPanTiltJointVelocity:
        """How fast the unit turns."""
        return ReportPanTiltJointVelocity(*self._unit.state().velocities)
