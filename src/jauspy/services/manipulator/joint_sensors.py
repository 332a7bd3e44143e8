"""The sensors of the joints: positions, velocities, forces and torques (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportJointForceTorques, ReportJointPositions, ReportJointVelocity
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.values import efforts, positions, velocities
from jauspy.services.service import Service


class JointPositionSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"):
    """Radians or metres, base to tip, as the specification counts them."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_positions(self) -> ReportJointPositions:
        """Where the joints are."""
        return ReportJointPositions(positions(self._arm.state().positions, self._arm.geometry.links))


class JointVelocitySensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"):
    """rad/s or m/s, base to tip."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_velocity(self) -> ReportJointVelocity:
        """How fast the joints move."""
        return ReportJointVelocity(velocities(self._arm.state().velocities, self._arm.geometry.links))


class JointForceTorqueSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"):
    """Newton metres or newtons, base to tip: what the motors apply."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_force_torques(self) -> ReportJointForceTorques:
        """What the motors apply."""
        return ReportJointForceTorques(efforts(self._arm.state().efforts, self._arm.geometry.links))
