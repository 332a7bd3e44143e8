"""Closed-loop control of the joints: positions, velocities, forces and torques (AS6057)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from jauspy.codec.message import Message
from jauspy.messages.manipulator import (
    ReportCommandedActuatorForceTorques,
    ReportCommandedJointPositions,
    ReportCommandedJointVelocity,
    SetActuatorForceTorques,
    SetJointPositions,
    SetJointVelocity,
)
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.driver import ArmDriver
from jauspy.services.manipulator.values import (
    Choices,
    efforts,
    positions,
    read_efforts,
    read_positions,
    read_velocities,
    values,
    velocities,
)
from jauspy.services.state_machine import CommandCompletion

PERIOD: Final = 0.05
"""Seconds between two looks at whether the joints have come where they were sent."""
_TIMER: Final = "joint positions"


class JointDriver(ArmDriver):
    """Takes one value for each joint; a message that has others is ignored and counted."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.commanded: Sequence[float] | None = None
        """What was commanded, while it holds."""

    def motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def taken_over(self) -> None:
        """What was commanded does not hold any more."""
        self.commanded = None

    def values(self, choices: Choices, msg: Message) -> list[float] | None:
        """The values of a command."""
        found = values(choices, self.arm.geometry.links)
        if found is None:
            self.host.count("wrong_joints", f"{msg}")
            self.host.begin_command()(False)
        return found


class PositionDriver(JointDriver):
    """Sends the joints somewhere; a command has been carried out when all joints are there."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._command = CommandCompletion()
        self._timer = (_TIMER, self.urn)

    def go(self, positions: Sequence[float]) -> None:
        """Go there within the motion profile; the positions are the standard's."""
        self.arm.to_positions(self, positions)
        self.commanded = positions
        self._command(False)
        self._command = self.host.begin_command()
        self.host.set_timer(self._timer, self.host.now + PERIOD, self._look)

    def taken_over(self) -> None:
        """The positions were not reached, or are left again."""
        super().taken_over()
        self.host.cancel_timer(self._timer)
        self._command(False)

    def _look(self) -> None:
        if self.commanded is not None and self.arm.is_at(self.commanded):
            self._command(True)
        else:
            self.host.set_timer(self._timer, self.host.now + PERIOD, self._look)


class JointPositionDriver(PositionDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"):
    """Radians or metres, as the specification counts them; positions beyond a joint's limits are limited."""

    def set_joint_efforts(self, msg: SetJointPositions) -> None:
        """Go there within the motion profile. The standard's definition gives the action this name."""
        found = self.values(read_positions(msg.joint_position_list), msg)
        if found is not None:
            self.go(found)

    def report_commanded_joint_positions(self) -> ReportCommandedJointPositions:
        """What was commanded, while it holds; else where the joints are."""
        found = self.commanded or self.arm.state().positions
        return ReportCommandedJointPositions(positions(found, self.arm.geometry.links))


class JointVelocityDriver(JointDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver"):
    """rad/s or m/s, within the motion profile; a joint stops at its limit."""

    def set_joint_velocity(self, msg: SetJointVelocity) -> None:
        """Move like that until the next command."""
        found = self.values(read_velocities(msg.joint_velocity_list), msg)
        if found is not None:
            self.arm.at_velocities(self, found)
            self.commanded = found

    def report_commanded_joint_velocity(self) -> ReportCommandedJointVelocity:
        """What was commanded, while it holds; else zero."""
        links = self.arm.geometry.links
        return ReportCommandedJointVelocity(velocities(self.commanded or [0.0] * len(links), links))


class ActuatorForceTorqueDriver(JointDriver, urn="urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"):
    """Newton metres or newtons that the motors apply; nothing else holds the arm, not even against gravity."""

    def set_actuator_force_torques(self, msg: SetActuatorForceTorques) -> None:
        """Apply these until the next command; what a motor cannot do is limited."""
        found = self.values(read_efforts(msg.actuator_force_torque_list), msg)
        if found is not None:
            self.arm.move(self, [Target(ControlMode.EFFORT, effort) for effort in found])
            self.commanded = found

    def report_commanded_actuator_force_torques(self) -> ReportCommandedActuatorForceTorques:
        """What was commanded, while it holds; else zero."""
        links = self.arm.geometry.links
        return ReportCommandedActuatorForceTorques(efforts(self.commanded or [0.0] * len(links), links))
