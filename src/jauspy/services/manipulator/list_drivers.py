"""ManipulatorListDriver: what the list drivers of a manipulator have in common (AS6057)."""

from __future__ import annotations

from typing import Any, Final

from jauspy.codec.base import Message
from jauspy.messages.manipulator import (
    ReportActiveElement,
    ReportCommandedJointPositions,
    SetEndEffectorPose,
    SetJointPositions,
)
from jauspy.services.core.list_driver import ListDriver
from jauspy.services.core.list_manager import ListManager
from jauspy.services.manipulator.arm import ArmDriver
from jauspy.services.manipulator.end_effector import ToolPoseDriver, pose_of
from jauspy.services.manipulator.joints import positions, read_positions, values


class ManipulatorListDriver(ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorListDriver"):
    """Says how far the list has been carried out; the services that inherit from it do that."""

    def report_active_element(self) -> ReportActiveElement:
        """The element that is being carried out, 0 for none."""
        elements = self.host.service(ListManager)
        return ReportActiveElement(element_uid=elements.active if elements else 0)


CHECK_PERIOD: Final = 0.05
"""Seconds between two looks at whether an element was reached."""
_LIST_TIMER: Final = "joint position list"


class JointPositionListDriver(ArmDriver, ListDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionListDriver"):
    """Its elements are SetJointPositions messages; each is gone to within the motion profile."""

    element_types = (SetJointPositions,)

    def begin_element(self, uid: int, message: Message) -> None:  # noqa: ARG002 - the message says it all
        """Go there; an element that does not fit the joints is counted and passed over."""
        found = self._read(message)
        if found is None:
            self.host.count("wrong_joints", f"{message}")
            self.elements.done()
            return
        self.arm.to_positions(self, found)
        self.host.set_timer(_LIST_TIMER, self.host.now + CHECK_PERIOD, self._look)

    def end_elements(self) -> None:
        """Hold."""
        self.host.cancel_timer(_LIST_TIMER)
        if self.moves:
            self.arm.stop()

    def taken_over(self) -> None:
        """Another service moves the joints now, or nobody may: the list is not carried out any more."""
        if self.elements.active:
            self.elements.stop()

    def _look(self) -> None:
        message = self.elements.message(self.elements.active)
        found = self._read(message) if message is not None else None
        if found is None:
            return
        if self.arm.is_at(found):
            self.elements.done()
        else:
            self.host.set_timer(_LIST_TIMER, self.host.now + CHECK_PERIOD, self._look)

    def _read(self, message: Message) -> list[float] | None:
        assert isinstance(message, SetJointPositions)
        return values(read_positions(message.joint_position_list), self.arm.geometry.links)

    # --- actions, predicates, reports

    def execute_target_list(self, msg: Any) -> None:
        """Start, or start over, from the element that is named."""
        self.elements.execute(msg.element_uid)

    def target_exists(self) -> bool:
        """There is an element to report."""
        return self._target() is not None

    def report_commanded_joint_positions(self) -> ReportCommandedJointPositions | None:
        """The active element, else the list's first one."""
        found = self._target()
        return None if found is None else ReportCommandedJointPositions(positions(found, self.arm.geometry.links))

    def _target(self) -> list[float] | None:
        message = self.elements.message(self.elements.active or next(iter(self.elements.list.order), 0))
        return self._read(message) if isinstance(message, SetJointPositions) else None


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
