"""The services of joints: drivers of positions, velocities, forces and efforts, and their sensors (AS6057).

Radians or metres, rad/s or m/s, newton metres or newtons, base to tip; positions as the specification counts them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.urdf import Joint
from jauspy.joint_values import kind_of, position_records, velocity_records
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
from jauspy.services.manipulator.arm import CHECK_PERIOD, Arm, ArmDriver, MotionProfile
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion
from jauspy.services.units import effort_or_zero

_TIMER: Final = "joint positions"

Choices: TypeAlias = Sequence[tuple[int, float]]
"""Kind and value of each field, base to tip."""


class JointDriver(ArmDriver):
    """The base of drivers with one value a joint; a message that does not match the joints is ignored and counted."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.commanded: Sequence[float] | None = None
        """The command, while it is carried out."""

    def on_preempted(self) -> None:
        """Forget the command."""
        self.commanded = None

    def read(self, choices: Choices, msg: Message) -> list[float] | None:
        """The values of a command; None, and counted, if they do not match the joints."""
        found = joint_values(choices, self.arm.geometry.links)
        if found is None:
            self.host.count("wrong_joints", f"{msg}")
            self.host.begin_command()(False)
        return found


class PositionDriver(JointDriver):
    """The base of drivers to positions; a command is completed when all joints have reached them."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._command = CommandCompletion()
        self._timer = (_TIMER, self.urn)
        self._watch = arm.watch()

    def go(self, positions: Sequence[float]) -> None:
        """Move to positions within the motion profile."""
        self.arm.to_positions(self, positions)
        self.commanded = positions
        self._watch = self.arm.watch()
        self._command(False)
        self._command = self.host.begin_command()
        self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._check)

    def on_preempted(self) -> None:
        """The command has failed, unless it is completed."""
        super().on_preempted()
        self.host.cancel_timer(self._timer)
        self._command(False)

    def _check(self) -> None:
        if self.commanded is not None and self.arm.is_at(self.commanded):
            self._command(True)
        elif self.commanded is None or not self.stops_if_blocked(self._watch, self.commanded):
            self.host.set_timer(self._timer, self.host.now + CHECK_PERIOD, self._check)


class JointPositionDriver(PositionDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"):
    """Positions beyond a joint's limits are limited."""

    def set_joint_efforts(self, msg: SetJointPositions) -> None:
        """Move to the positions. The action's name is that of the standard's JSIDL."""
        found = self.read(read_positions(msg.joint_position_list), msg)
        if found is not None:
            self.go(found)

    def report_commanded_joint_positions(self) -> ReportCommandedJointPositions:
        """The command, while it is carried out; else the present positions."""
        found = self.commanded or self.arm.state().positions
        return ReportCommandedJointPositions(position_records(found, self.arm.geometry.links))


class JointVelocityDriver(JointDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointVelocityDriver"):
    """Within the motion profile; a joint stops at its limit."""

    def set_joint_velocity(self, msg: SetJointVelocity) -> None:
        """Move at these velocities until the next command."""
        found = self.read(read_velocities(msg.joint_velocity_list), msg)
        if found is not None:
            self.arm.at_velocities(self, found)
            self.commanded = found
            self.on_endless_motion()

    def report_commanded_joint_velocity(self) -> ReportCommandedJointVelocity:
        """The command, while it is carried out; else zero."""
        links = self.arm.geometry.links
        return ReportCommandedJointVelocity(velocity_records(self.commanded or [0.0] * len(links), links))


class ActuatorForceTorqueDriver(JointDriver, urn="urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"):
    """Forces and torques of the motors, without gravity compensation."""

    def set_actuator_force_torques(self, msg: SetActuatorForceTorques) -> None:
        """Apply these until the next command; limited to the efforts of the joints."""
        found = self.read(read_efforts(msg.actuator_force_torque_list), msg)
        if found is not None:
            self.arm.move(self, [Target(ControlMode.EFFORT, effort) for effort in found])
            self.commanded = found
            self.on_endless_motion()

    def report_commanded_actuator_force_torques(self) -> ReportCommandedActuatorForceTorques:
        """The command, while it is carried out; else zero."""
        links = self.arm.geometry.links
        return ReportCommandedActuatorForceTorques(effort_records(self.commanded or [0.0] * len(links), links))


class JointPositionSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"):
    """Positions of the joints."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_positions(self) -> ReportJointPositions:
        """The positions after the last step."""
        return ReportJointPositions(position_records(self._arm.state().positions, self._arm.geometry.links))


class JointVelocitySensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointVelocitySensor"):
    """Velocities of the joints."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_velocity(self) -> ReportJointVelocity:
        """The velocities after the last step."""
        return ReportJointVelocity(velocity_records(self._arm.state().velocities, self._arm.geometry.links))


class JointForceTorqueSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"):
    """Forces and torques of the motors."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_joint_force_torques(self) -> ReportJointForceTorques:
        """The efforts after the last step."""
        return ReportJointForceTorques(effort_records(self._arm.state().efforts, self._arm.geometry.links))


class EffortDriver(ArmDriver):
    """The base of drivers by effort, in percent of each joint's greatest effort; a joint with zero effort holds.

    The efforts are in addition to what gravity needs, and move a joint at most at that share of its speed limit.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.efforts = [0.0] * len(arm.joints.joints)
        """The command, in percent; zeros after a stop, and while another service moves the joints."""

    def apply(self, efforts: Sequence[float]) -> None:
        """Apply efforts, in percent."""
        shares = [effort_or_zero(effort) for effort in efforts]
        rows = zip(shares, self.arm.joints.joints, self.arm.profiles, strict=True)
        self.arm.move(self, [_effort_target(share, joint, profile) for share, joint, profile in rows])
        self.efforts = shares
        self.on_endless_motion()

    def on_preempted(self) -> None:
        """The reported efforts become zero."""
        self.efforts = [0.0] * len(self.efforts)


class PrimitiveManipulator(EffortDriver, urn="urn:jaus:jss:manipulator:PrimitiveManipulator"):
    """Efforts in percent of what each joint can do, in addition to what gravity needs; zero holds."""

    def set_joint_effort(self, msg: SetJointEffort) -> None:
        """Apply these until the next command; ignored, and counted, unless there is one for each joint."""
        efforts = [record.joint_effort for record in msg.joint_effort_list]
        if len(efforts) != len(self.efforts):
            self.host.count("wrong_joints", f"{msg}")
            return
        self.apply(efforts)

    def report_joint_effort(self) -> ReportJointEffort:
        """The commanded efforts, in percent; zeros after a stop, and while another service moves the joints."""
        return ReportJointEffort(percent_records(self.efforts))


def _effort_target(share: float, joint: Joint, profile: MotionProfile) -> Target:
    return Target(
        ControlMode.EFFORT,
        joint.effort * share / 100.0,
        compensated=True,
        speed=profile.speed,
        acceleration=profile.acceleration,
        deceleration=profile.deceleration,
    )


def joint_values(choices: Choices, links: Sequence[DHLink]) -> list[float] | None:
    """The values; None unless there is one of the right kind for each joint."""
    kinds = [kind_of(link) for link in links]
    return [value for _, value in choices] if [kind for kind, _ in choices] == kinds else None


def read_positions(records: Sequence[JointPositionRec]) -> Choices:
    """The values of SetJointPositions."""
    return [(record.joint_position.choice, record.joint_position.value) for record in records]


def read_velocities(records: Sequence[JointVelocityRec]) -> Choices:
    """The values of SetJointVelocity."""
    return [(record.joint_velocity.choice, record.joint_velocity.value) for record in records]


def read_efforts(records: Sequence[ActuatorForceTorqueRec]) -> Choices:
    """The values of SetActuatorForceTorques."""
    return [(record.joint_force_torque.choice, record.joint_force_torque.value) for record in records]


def effort_records(found: Sequence[float], links: Sequence[DHLink]) -> list[ActuatorForceTorqueRec]:
    """A record for each joint: newton metres or newtons."""
    make, choice = ActuatorForceTorqueRec.JointForceTorque, ActuatorForceTorqueRec.JointForceTorqueChoice
    return [
        ActuatorForceTorqueRec(joint_force_torque=make(choice(kind_of(link)), value))
        for value, link in zip(found, links, strict=True)
    ]


def percent_records(found: Sequence[float]) -> list[JointEffortRec]:
    """A record for each joint: percent of its greatest effort."""
    return [JointEffortRec(joint_effort=value) for value in found]
