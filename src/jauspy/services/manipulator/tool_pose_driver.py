"""The base of the services that bring the tool to poses."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.kinematics import InverseKinematics, Solution
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import quaternion, rotation_from_quaternion
from jauspy.messages.manipulator import ReportCommandedEndEffectorPose, SetEndEffectorPose
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.driver import ArmDriver

STEPS_AT_ONCE: Final = 10
"""Steps of a search after which others have their turn: about two milliseconds for five joints."""
PAUSE: Final = 0.005
"""Seconds until it goes on."""
PERIOD: Final = 0.05
"""Seconds between two looks at whether a pose was reached."""
CLOSE: Final = 0.001
"""Metres from where the arm is to bring the tool at which it counts as there."""
ALIGNED: Final = math.radians(0.5)
"""Radians for the attitude."""
SHORTEST: Final = 0.01
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
        found = search.advance(STEPS_AT_ONCE)
        self._next_turn = self.host.now + PAUSE
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
        if distance <= CLOSE and turn <= ALIGNED:
            self.reached(exactly=found.reaches_pose)
        else:
            self.host.set_timer(self, self.host.now + PERIOD, lambda: self._look(found, goal))


def pose_of(msg: SetEndEffectorPose) -> Transform | None:
    """Where the tool is to be, in the manipulator's coordinate system; None when the quaternion has no direction."""
    parts = (
        msg.d_component_of_unit_quaternion_q,
        msg.a_component_of_unit_quaternion_q,
        msg.b_component_of_unit_quaternion_q,
        msg.c_component_of_unit_quaternion_q,
    )
    if math.hypot(*parts) < SHORTEST:
        return None
    point = (msg.tool_point_coordinate_x, msg.tool_point_coordinate_y, msg.tool_point_coordinate_z)
    return Transform(rotation_from_quaternion(*parts), point)
