"""Closed-loop control of the joints: positions, velocities, forces and torques (AS6057)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from jauspy.codec.base import Message
from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.messages.manipulator import (
    ActuatorForceTorqueRec,
    JointEffortRec,
    JointPositionRec,
    JointVelocityRec,
    ReportCommandedActuatorForceTorques,
    ReportCommandedJointPositions,
    ReportCommandedJointVelocity,
    ReportJointEffort,
    ReportJointForceTorques,
    ReportJointPositions,
    ReportJointVelocity,
    SetActuatorForceTorques,
    SetJointEffort,
    SetJointPositions,
    SetJointVelocity,
)
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.completion import Completion
from jauspy.services.manipulator.arm import Arm, ArmDriver
from jauspy.services.percent import percent
from jauspy.services.service import Service

REVOLUTE, PRISMATIC = 1, 2
"""Which of the two kinds of value a field holds."""

Choices = Sequence[tuple[int, float]]


def values(choices: Choices, links: Sequence[DHLink]) -> list[float] | None:
    """The values, base to tip; None unless there is one of the right kind for each joint."""
    kinds = [REVOLUTE if link.is_revolute else PRISMATIC for link in links]
    return [value for _, value in choices] if [kind for kind, _ in choices] == kinds else None


def read_positions(records: Sequence[JointPositionRec]) -> Choices:
    """What SetJointPositions holds."""
    return [(record.joint_position.choice, record.joint_position.value) for record in records]


def read_velocities(records: Sequence[JointVelocityRec]) -> Choices:
    """What SetJointVelocity holds."""
    return [(record.joint_velocity.choice, record.joint_velocity.value) for record in records]


def read_efforts(records: Sequence[ActuatorForceTorqueRec]) -> Choices:
    """What SetActuatorForceTorques holds."""
    return [(record.joint_force_torque.choice, record.joint_force_torque.value) for record in records]


def positions(found: Sequence[float], links: Sequence[DHLink]) -> list[JointPositionRec]:
    """Radians or metres for each joint."""
    make, choice = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    return [
        JointPositionRec(joint_position=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def velocities(found: Sequence[float], links: Sequence[DHLink]) -> list[JointVelocityRec]:
    """rad/s or m/s for each joint."""
    make, choice = JointVelocityRec.JointVelocity, JointVelocityRec.JointVelocityChoice
    return [
        JointVelocityRec(joint_velocity=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def efforts(found: Sequence[float], links: Sequence[DHLink]) -> list[ActuatorForceTorqueRec]:
    """Newton metres or newtons for each joint."""
    make, choice = ActuatorForceTorqueRec.JointForceTorque, ActuatorForceTorqueRec.JointForceTorqueChoice
    return [
        ActuatorForceTorqueRec(joint_force_torque=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def percents(found: Sequence[float]) -> list[JointEffortRec]:
    """Percent of each joint's greatest effort."""
    return [JointEffortRec(joint_effort=value) for value in found]


CHECK_PERIOD: Final = 0.05
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
        self._command = Completion()
        self._timer = (_TIMER, self.urn)

    def go(self, positions: Sequence[float]) -> None:
        """Go there within the motion profile; the positions are the standard's."""
        self.arm.to_positions(self, positions)
        self.commanded = positions
        self._command(False)
        self._command = self.host.begin_command()
        self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._look)

    def taken_over(self) -> None:
        """The positions were not reached, or are left again."""
        super().taken_over()
        self.host.cancel_timer(self._timer)
        self._command(False)

    def _look(self) -> None:
        if self.commanded is not None and self.arm.is_at(self.commanded):
            self._command(True)
        else:
            self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._look)


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


class EffortDriver(ArmDriver):
    """Motors push with what they are told; a joint whose effort is zero is held where it is, as by a brake."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.efforts = [0.0] * len(arm.joints.joints)
        """The last commanded ones, in percent; zero when they were stopped or another service moves the joints."""

    def push(self, efforts: Sequence[float]) -> None:
        """Percent of what each joint can do, base to tip."""
        shares = [percent(effort) for effort in efforts]
        rows = zip(shares, self.arm.joints.joints, self.arm.state().positions, strict=True)
        self.arm.move(self, [_target(share, joint.effort, position) for share, joint, position in rows])
        self.efforts = shares

    def taken_over(self) -> None:
        """The efforts end."""
        self.efforts = [0.0] * len(self.efforts)


class PrimitiveManipulator(EffortDriver, urn="urn:jaus:jss:manipulator:PrimitiveManipulator"):
    """An effort for each joint, base to tip."""

    def set_joint_effort(self, msg: SetJointEffort) -> None:
        """Ignored, and counted, unless there is an effort for each joint."""
        efforts = [record.joint_effort for record in msg.joint_effort_list]
        if len(efforts) != len(self.efforts):
            self.host.count("wrong_joints", f"{msg}")
            return
        self.push(efforts)

    def report_joint_effort(self) -> ReportJointEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service moves the joints."""
        return ReportJointEffort(percents(self.efforts))


def _target(share: float, most: float, position: float) -> Target:
    if not share:
        return Target(ControlMode.POSITION, position)
    return Target(ControlMode.EFFORT, most * share / 100.0)
