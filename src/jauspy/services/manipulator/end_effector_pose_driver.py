"""ManipulatorEndEffectorPoseDriver: brings the tool to a pose (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import SetEndEffectorPose
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.tool_pose_driver import ToolPoseDriver, pose_of
from jauspy.services.state_machine import CommandCompletion


class EndEffectorPoseDriver(ToolPoseDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"):
    """Metres and a quaternion in the manipulator's coordinate system, as EndEffectorPoseSensor reports them.

    A command has been carried out when the tool has the pose; one for an attitude that the arm cannot have is done as
    far as it can be, and counts as not carried out.
    """

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._command = CommandCompletion()

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
