"""The base of the services that bring the tool to poses."""

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
from jauspy.services.completion import Completion
from jauspy.services.manipulator.arm import Arm, ArmDriver
from jauspy.services.manipulator.tool_motion import ToolMotion
from jauspy.services.percent import percent
from jauspy.services.service import Service

STEPS_PER_TURN: Final = 10
"""Steps of a search after which others have their turn: about two milliseconds for five joints."""
SEARCH_PAUSE: Final = 0.005
"""Seconds until it goes on."""
CHECK_PERIOD: Final = 0.05
"""Seconds between two looks at whether a pose was reached."""
POSITION_TOLERANCE: Final = 0.001
"""Metres from where the arm is to bring the tool at which it counts as there."""
ATTITUDE_TOLERANCE: Final = math.radians(0.5)
"""Radians for the attitude."""
MIN_QUATERNION_NORM: Final = 0.01
"""Length of a quaternion below which it says nothing: what is sent as zero arrives as some parts of a billion."""


class ToolPoseDriver(ArmDriver):
    """Finds positions of the joints for a pose, and goes there within the motion profile.

    Each joint goes its own way; the arm does not know what stands in it. A pose whose point is out of reach is counted,
    and the arm holds. Of attitudes that the arm cannot have the nearest is taken.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._goal: Transform | None = None
        self._search: InverseKinematics | None = None
        self._next_turn = -math.inf

    def go(self, goal: Transform) -> None:
        """Bring the tool there, in the manipulator's coordinate system; what moved the arm until now ends.

        Commands may follow each other faster than searches end: the arm goes on to what the one before has found.
        """
        arm, before = self.arm, self._search
        arm.take(self)
        if before is not None and before.best.reaches_point:
            arm.to_positions(self, before.best.positions)
        self._goal = goal
        self._search = InverseKinematics(arm.geometry.links, arm.tool, goal, arm.state().positions, arm.limits)
        if self.host.now >= self._next_turn:
            self._seek()
        else:
            self.host.set_timer(self, self._next_turn, self._seek)

    def reached(self, *, exactly: bool) -> None:
        """Called when the tool is there; not `exactly` when the arm cannot have the attitude."""
        raise NotImplementedError(f"{type(self).__name__}.reached")

    def taken_over(self) -> None:
        """What was commanded does not hold any more."""
        self._goal = self._search = None
        self.host.cancel_timer(self)

    def report_commanded_end_effector_pose(self) -> ReportCommandedEndEffectorPose:
        """What was commanded, by whichever of these services, while it holds; else where the tool is."""
        driver = self.arm.driver
        goal = driver._goal if isinstance(driver, ToolPoseDriver) else None  # noqa: SLF001 - of the same class
        tool = goal or self.arm.kinematic_state().tool
        return ReportCommandedEndEffectorPose(*tool.position, *quaternion(tool.rotation))

    def _seek(self) -> None:
        search, goal = self._search, self._goal
        if search is None or goal is None:
            return
        found = search.advance(STEPS_PER_TURN)
        self._next_turn = self.host.now + SEARCH_PAUSE
        if found is None:
            self.host.set_timer(self, self._next_turn, self._seek)
            return
        self._search = None
        if found.reaches_point:
            self.arm.to_positions(self, found.positions)
            self._look(found, goal)
        else:
            self.host.count("out_of_reach", f"{goal.position}: {found.distance:.3f} m are missing")
            self.arm.stop()

    def _look(self, found: Solution, goal: Transform) -> None:
        tool = self.arm.kinematic_state().tool
        distance = math.dist(goal.position, tool.position) - found.distance
        turn = math.hypot(*rotation_vector(tool.rotation, goal.rotation)) - found.angle
        if distance <= POSITION_TOLERANCE and turn <= ATTITUDE_TOLERANCE:
            self.reached(exactly=found.reaches_pose)
        else:
            self.host.set_timer(self, self.host.now + CHECK_PERIOD, lambda: self._look(found, goal))


def pose_of(msg: SetEndEffectorPose) -> Transform | None:
    """Where the tool is to be, in the manipulator's coordinate system; None when the quaternion has no direction."""
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
    """Metres and a quaternion in the manipulator's coordinate system, as EndEffectorPoseSensor reports them.

    A command has been carried out when the tool has the pose; one for an attitude that the arm cannot have is done as
    far as it can be, and counts as not carried out.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._command = Completion()

    def motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def set_end_effector_pose(self, msg: SetEndEffectorPose) -> None:
        """Go there; ignored, and counted, when the quaternion says nothing."""
        command, goal = self.host.begin_command(), pose_of(msg)
        if goal is None:
            self.host.count("no_attitude", f"{msg}")
            command(False)
            return
        self._command(False)
        self._command = command
        self.go(goal)

    def reached(self, *, exactly: bool) -> None:
        """Tell who waits for it."""
        self._command(exactly)

    def taken_over(self) -> None:
        """It will not be carried out any more."""
        super().taken_over()
        self._command(False)


CONTROL_PERIOD: Final = 0.02
"""Seconds between two looks at where the tool is, and new velocities of the joints."""
VELOCITY_RESOLUTION: Final = 1e-7
"""rad/s or m/s below which a velocity was meant to be zero, which lies between two steps of its field."""
ZERO_VELOCITY: Final = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class EndEffectorVelocityStateDriver(
    ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
):
    """rad/s and m/s in the manipulator's coordinate system, as EndEffectorVelocityStateSensor reports them.

    Within the motion profile: what would be too fast for a joint is slower as a whole. At the end of its reach the tool
    stops on its line.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._commanded = ZERO_VELOCITY
        self._motion: ToolMotion | None = None

    def motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def set_end_effector_velocity_state(self, msg: SetEndEffectorVelocityState) -> None:
        """Move like that until the next command."""
        turning = (
            _velocity(msg.angular_velocity_component_x),
            _velocity(msg.angular_velocity_component_y),
            _velocity(msg.angular_velocity_component_z),
        )
        moving = (
            _velocity(msg.linear_velocity_component_x),
            _velocity(msg.linear_velocity_component_y),
            _velocity(msg.linear_velocity_component_z),
        )
        self.arm.take(self)
        self._commanded = (*turning, *moving)
        if self._motion is not None:
            self._motion.follow(turning, moving)  # at the next look, however many commands come until then
            return
        self._motion = ToolMotion(self.arm)
        self._motion.follow(turning, moving)
        self.every(CONTROL_PERIOD, self._look)
        self._look()

    def taken_over(self) -> None:
        """What was commanded does not hold any more."""
        self._commanded, self._motion = ZERO_VELOCITY, None
        self.host.cancel_timer(self._look)

    def report_commanded_end_effector_velocity_state(self) -> ReportCommandedEndEffectorVelocityState:
        """What was commanded, while it holds; else zero."""
        return ReportCommandedEndEffectorVelocityState(*self._commanded)

    def _look(self) -> None:
        motion = self._motion
        if motion is None:
            return
        self.arm.at_velocities(self, motion.rates(CONTROL_PERIOD))
        if motion.is_over:
            self.arm.stop()


def _velocity(value: float) -> float:
    return 0.0 if abs(value) < VELOCITY_RESOLUTION else value


class EndEffectorPoseSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"):
    """Metres and a quaternion in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_pose(self) -> ReportEndEffectorPose:
        """The tool point, and the attitude of the last joint's frame."""
        tool = self._arm.kinematic_state().tool
        return ReportEndEffectorPose(*tool.position, *quaternion(tool.rotation))


class EndEffectorVelocityStateSensor(Service, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"):
    """rad/s and m/s in the manipulator's coordinate system."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm

    def report_end_effector_velocity_state(self) -> ReportEndEffectorVelocityState:
        """How the tool point moves, and how the last link turns: each joint adds its part."""
        turning, moving = self._arm.kinematic_state().velocity(self._arm.state().velocities)
        return ReportEndEffectorVelocityState(*turning, *moving)


class PrimitiveEndEffector(Service, urn="urn:jaus:jss:manipulator:PrimitiveEndEffector"):
    """Positive efforts close the gripper, negative ones open it; zero holds it as it is."""

    def __init__(self, gripper: JointGroup, manipulator: JausID) -> None:
        self._gripper = gripper
        self._manipulator = manipulator
        self._effort = 0.0

    def set_end_effector_effort(self, msg: SetEndEffectorEffort) -> None:
        """Reached only in Ready, from the controlling client; the fingers' joints count from closed to open."""
        self._effort = percent(msg.end_effector_effort)
        if not self._effort:
            self._gripper.hold()
            return
        share = -self._effort / 100.0
        self._gripper.command([Target(ControlMode.EFFORT, share * joint.effort) for joint in self._gripper.joints])

    def report_end_effector_effort(self) -> ReportEndEffectorEffort:
        """The last commanded effort, in percent."""
        return ReportEndEffectorEffort(self._effort)

    def report_end_effector_specification(self) -> ReportEndEffectorSpecification:
        """The manipulator that carries the gripper."""
        return ReportEndEffectorSpecification(int(self._manipulator))

    def control_lost(self) -> None:
        """What moves, stops."""
        super().control_lost()
        self.stop()

    def stop(self) -> None:
        """Stop opening; what is grasped stays grasped. Twice is fine."""
        if self._effort < 0.0:
            self._effort = 0.0
            self._gripper.hold()
