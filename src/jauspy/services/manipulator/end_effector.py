"""The services of the end effector: pose and velocity drivers, their sensors, and the gripper's efforts (AS6057).

Poses and velocities are those of the tool point, with the attitude of the last joint's frame, in the manipulator's
coordinate system: metres, radians, unit quaternions.
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.kinematics import InverseKinematics, Solution
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import quaternion, rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.manipulator import (
    ReportCommandedEndEffectorPose,
    ReportCommandedEndEffectorVelocityState,
    ReportEndEffectorEffort,
    ReportEndEffectorPose,
    ReportEndEffectorSpecification,
    ReportEndEffectorVelocityState,
    SetEndEffectorEffort,
    SetEndEffectorPose,
    SetEndEffectorVelocityState,
)
from jauspy.platform.joints import ControlMode, JointGroup, Target
from jauspy.services.core import present_authority
from jauspy.services.manipulator.arm import CHECK_PERIOD, Arm, ArmDriver
from jauspy.services.manipulator.blocked_joints import StandstillWatch
from jauspy.services.manipulator.tool_motion import ToolMotion
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion
from jauspy.services.units import effort_or_zero

STEPS_PER_TURN: Final = 10
"""Steps of inverse kinematics at once: about two milliseconds for five joints."""
SEARCH_PAUSE: Final = 0.005
"""Seconds between two parts of a search, in which the component handles other events."""
POSITION_TOLERANCE: Final = 0.001
"""Metres from the pose that was found up to which it is reached."""
ATTITUDE_TOLERANCE: Final = math.radians(0.5)
"""Radians, for the attitude."""
SETTLING_TIME: Final = 5.0
"""Seconds that joints near their positions have to bring the tool to the pose; a load may keep it beside."""
MIN_QUATERNION_NORM: Final = 0.01
"""Norm below which a quaternion counts as zero; a zero arrives as some parts of a billion."""
CONTROL_PERIOD: Final = 0.02
"""Seconds between two velocity commands to the joints."""
VELOCITY_RESOLUTION: Final = 1e-7
"""rad/s or m/s below which a velocity counts as zero; zero lies between two steps of its field."""
ZERO_VELOCITY: Final = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class ToolPoseDriver(ArmDriver):
    """The base of drivers to poses: solves the inverse kinematics and moves the joints within the motion profile.

    Joints move independently, without collision checks. A pose whose point is out of reach is counted, and the arm
    holds. If the arm cannot take the attitude, the nearest is taken.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._goal: Transform | None = None
        self._search: InverseKinematics | None = None
        self._resume_at = -math.inf

    def go(self, goal: Transform) -> None:
        """Move the tool to a pose; preempts the command before.

        Commands may arrive faster than searches end: the arm moves on to what the search before has found.
        """
        arm, before = self.arm, self._search
        arm.preempt_for(self)
        if before is not None and before.best.reaches_point:
            arm.to_positions(self, before.best.positions)
        self._goal = goal
        self._search = InverseKinematics(arm.geometry.links, arm.tool, goal, arm.state().positions, arm.limits)
        if self.host.now >= self._resume_at:
            self._search_on()
        else:
            self.host.set_timer(self, self._resume_at, self._search_on)

    def reached(self, *, exactly: bool) -> None:
        """Called when the pose is reached; `exactly` is False if only its point is, or if the joints sag."""
        raise NotImplementedError(f"{type(self).__name__}.reached")

    def on_preempted(self) -> None:
        """Cancel the command."""
        self._goal = self._search = None
        self.host.cancel_timer(self)

    def report_commanded_end_effector_pose(self) -> ReportCommandedEndEffectorPose:
        """The commanded pose, of whichever pose driver moves the arm; else the present pose."""
        driver = self.arm.driver
        goal = driver._goal if isinstance(driver, ToolPoseDriver) else None  # noqa: SLF001 - of the same class
        tool = goal or self.arm.kinematic_state().tool
        return ReportCommandedEndEffectorPose(*tool.position, *quaternion(tool.rotation))

    def _search_on(self) -> None:
        search, goal = self._search, self._goal
        if search is None or goal is None:
            return
        found = search.advance(STEPS_PER_TURN)
        self._resume_at = self.host.now + SEARCH_PAUSE
        if found is None:
            self.host.set_timer(self, self._resume_at, self._search_on)
            return
        self._search = None
        if found.reaches_point:
            self.arm.to_positions(self, found.positions)
            self._check(found, goal, self.arm.watch(), math.inf)
        else:
            self.host.count("out_of_reach", f"{goal.position}: {found.distance:.3f} m are missing")
            self.arm.stop()

    def _check(self, found: Solution, goal: Transform, watch: StandstillWatch, near_since: float) -> None:
        tool = self.arm.kinematic_state().tool
        distance = math.dist(goal.position, tool.position) - found.distance
        turn = math.hypot(*rotation_vector(tool.rotation, goal.rotation)) - found.angle
        if distance <= POSITION_TOLERANCE and turn <= ATTITUDE_TOLERANCE:
            self.reached(exactly=found.reaches_pose)
            return
        now = self.host.now
        near_since = min(near_since, now) if self.arm.rests_near(found.positions) else math.inf
        if now - near_since >= SETTLING_TIME:
            self.reached(exactly=False)
        elif not self.stops_if_blocked(watch, found.positions):
            self.host.set_timer(self, now + CHECK_PERIOD, lambda: self._check(found, goal, watch, near_since))


def commanded_pose(msg: SetEndEffectorPose) -> Transform | None:
    """The pose of a command; None if the quaternion is zero."""
    parts = (
        msg.d_component_of_unit_quaternion_q,
        msg.a_component_of_unit_quaternion_q,
        msg.b_component_of_unit_quaternion_q,
        msg.c_component_of_unit_quaternion_q,
    )
    if math.hypot(*parts) < MIN_QUATERNION_NORM:
        return None
    point = (msg.tool_point_coordinate_x, msg.tool_point_coordinate_y, msg.tool_point_coordinate_z)
    return Transform(rotation_from_quaternion(*parts), point)


class EndEffectorPoseDriver(ToolPoseDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"):
    """A command is completed when the tool has the pose, and fails if the arm cannot take the attitude."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._command = CommandCompletion()

    def set_end_effector_pose(self, msg: SetEndEffectorPose) -> None:
        """Move to the pose; ignored, and counted, if the quaternion is zero."""
        command, goal = self.host.begin_command(), commanded_pose(msg)
        if goal is None:
            self.host.count("no_attitude", f"{msg}")
            command(False)
            return
        self._command(False)
        self._command = command
        self.go(goal)

    def reached(self, *, exactly: bool) -> None:
        """Complete the command."""
        self._command(exactly)

    def on_preempted(self) -> None:
        """The command has failed."""
        super().on_preempted()
        self._command(False)


class EndEffectorVelocityStateDriver(
    ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
):
    """rad/s and m/s. The whole motion is slowed down where a joint would exceed its motion profile.

    At the end of its reach the tool stops on its line.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._commanded = ZERO_VELOCITY
        self._motion: ToolMotion | None = None

    def set_end_effector_velocity_state(self, msg: SetEndEffectorVelocityState) -> None:
        """Move at this velocity until the next command."""
        angular = (
            _velocity(msg.angular_velocity_component_x),
            _velocity(msg.angular_velocity_component_y),
            _velocity(msg.angular_velocity_component_z),
        )
        linear = (
            _velocity(msg.linear_velocity_component_x),
            _velocity(msg.linear_velocity_component_y),
            _velocity(msg.linear_velocity_component_z),
        )
        self.arm.preempt_for(self)
        self._commanded = (*angular, *linear)
        self.on_endless_motion()
        if self._motion is not None:
            self._motion.follow(angular, linear)  # from the next control period on
            return
        self._motion = ToolMotion(self.arm)
        self._motion.follow(angular, linear)
        self.every(CONTROL_PERIOD, self._move)
        self._move()

    def on_preempted(self) -> None:
        """Cancel the command."""
        self._commanded, self._motion = ZERO_VELOCITY, None
        self.host.cancel_timer(self._move)

    def report_commanded_end_effector_velocity_state(self) -> ReportCommandedEndEffectorVelocityState:
        """The command, while it is carried out; else zero."""
        return ReportCommandedEndEffectorVelocityState(*self._commanded)

    def _move(self) -> None:
        motion = self._motion
        if motion is None or self.stops_if_touched():
            return
        self.arm.at_velocities(self, motion.rates(CONTROL_PERIOD))
        if motion.is_finished:
            self.arm.stop()


def _velocity(value: float) -> float:
    return 0.0 if abs(value) < VELOCITY_RESOLUTION else value


class EndEffectorPoseSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"):
    """The pose of the tool."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_pose(self) -> ReportEndEffectorPose:
        """The tool point, and the attitude of the last joint's frame."""
        tool = self._arm.kinematic_state().tool
        return ReportEndEffectorPose(*tool.position, *quaternion(tool.rotation))


class EndEffectorVelocityStateSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"):
    """The velocity of the tool, rad/s and m/s."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_velocity_state(self) -> ReportEndEffectorVelocityState:
        """Jacobian times joint velocities."""
        angular, linear = self._arm.kinematic_state().velocity(self._arm.state().velocities)
        return ReportEndEffectorVelocityState(*angular, *linear)


STILL: Final = 0.01
"""The share of their largest speed below which fingers stand still."""
CLOSED: Final = 0.02
"""The share of their way up to which fingers are closed, and hold nothing."""


class PrimitiveEndEffector(Service, urn="urn:jaus:jss:manipulator:PrimitiveEndEffector"):
    """Open-loop effort of a gripper in percent: positive closes, negative opens, zero holds.

    Fingers that close on a load are opened, or close with less effort, only for a client with at least the authority of
    the client that closed them.
    """

    def __init__(self, gripper: JointGroup, manipulator: JausID) -> None:
        self._gripper = gripper
        self._manipulator = manipulator
        self._effort = 0.0
        self._closed_with: int | None = None
        """The authority of the client that closed the fingers."""

    def set_end_effector_effort(self, msg: SetEndEffectorEffort) -> None:
        """Apply the effort until the next command; the joints of the fingers count from closed to open."""
        effort, authority = effort_or_zero(msg.end_effector_effort), present_authority(self.host)
        needed = self._closed_with if self._holds_load() else None
        if needed is not None and authority < needed and effort < self._effort:
            self.host.count("load_held", f"authority {needed} closed the gripper, and this client has {authority}")
            self.host.begin_command()(False)
            return
        if effort > 0.0:
            self._closed_with = authority if needed is None else max(needed, authority)
        self._effort = effort
        if not self._effort:
            self._gripper.hold()
            return
        share = -self._effort / 100.0
        self._gripper.command(
            [Target(ControlMode.EFFORT, share * joint.effort, compensated=True) for joint in self._gripper.joints]
        )

    def _holds_load(self) -> bool:
        """True if fingers that close stand still before they are closed."""
        if self._effort <= 0.0:
            return False
        state, joints = self._gripper.state(), self._gripper.joints
        still = all(abs(speed) < STILL * joint.velocity for joint, speed in zip(joints, state.velocities, strict=True))
        ways = zip(joints, state.positions, strict=True)
        return still and any(position - way.lower > CLOSED * (way.upper - way.lower) for way, position in ways)

    def report_end_effector_effort(self) -> ReportEndEffectorEffort:
        """The commanded effort, in percent."""
        return ReportEndEffectorEffort(self._effort)

    def report_end_effector_specification(self) -> ReportEndEffectorSpecification:
        """The manipulator that carries the gripper."""
        return ReportEndEffectorSpecification(int(self._manipulator))

    def control_lost(self) -> None:
        """Stop opening."""
        super().control_lost()
        self.stop()

    def stop(self) -> None:
        """Stop opening; a gripper that closes keeps its grasp. May be called twice."""
        if self._effort < 0.0:
            self._effort = 0.0
            self._gripper.hold()
