"""ManipulatorEndEffectorPoseListDriver: through a list of poses of the tool (AS6057)."""

from __future__ import annotations

from typing import Any

from jauspy.codec.message import Message
from jauspy.messages.manipulator import SetEndEffectorPose
from jauspy.services.core.list_manager import ListDriver
from jauspy.services.manipulator.tool_pose_driver import ToolPoseDriver, pose_of


class EndEffectorPoseListDriver(
    ToolPoseDriver, ListDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
):
    """Its elements are SetEndEffectorPose messages; one that is out of reach ends the list."""

    element_types = (SetEndEffectorPose,)

    def read_element(self, content: Message | bytes) -> Message | None:
        """A pose; None for one whose quaternion says nothing, so that it is refused."""
        message = super().read_element(content)
        return message if isinstance(message, SetEndEffectorPose) and pose_of(message) else None

    def begin_element(self, uid: int, message: Message) -> None:  # noqa: ARG002 - the message says it all
        """Go there."""
        goal = pose_of(message) if isinstance(message, SetEndEffectorPose) else None
        assert goal is not None
        self.go(goal)

    def reached(self, *, exactly: bool) -> None:  # noqa: ARG002 - as near as the arm can
        """The next one."""
        self.elements.done()

    def end_elements(self) -> None:
        """Hold."""
        if self.moves:
            self.arm.stop()

    def taken_over(self) -> None:
        """Another service moves the joints now, or nobody may: the list is not carried out any more."""
        super().taken_over()
        if self.elements.active:
            self.elements.stop()

    def execute_target_list(self, msg: Any) -> None:
        """Start, or start over, from the element that is named."""
        self.elements.execute(msg.element_uid)
