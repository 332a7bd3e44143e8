"""The list drivers of a manipulator and their base, ManipulatorListDriver (AS6057)."""

from __future__ import annotations

from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.joint_values import position_records
from jauspy.messages.manipulator import (
    ReportActiveElement,
    ReportCommandedJointPositions,
    SetEndEffectorPose,
    SetJointPositions,
)
from jauspy.services.core.list_manager import ListDriver, ListManager
from jauspy.services.manipulator.arm import CHECK_PERIOD, ArmDriver
from jauspy.services.manipulator.end_effector import ToolPoseDriver, commanded_pose
from jauspy.services.manipulator.joints import joint_values, read_positions


class ManipulatorListDriver(ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorListDriver"):
    """Reports the active element; services that inherit from it execute the list."""

    def report_active_element(self) -> ReportActiveElement:
        """The active element, 0 for none."""
        elements = self.host.service(ListManager)
        return ReportActiveElement(element_uid=elements.active if elements else 0)


_LIST_TIMER: Final = "joint position list"


class JointPositionListDriver(ArmDriver, ListDriver, urn="urn:jaus:jss:manipulator:ManipulatorJointPositionListDriver"):
    """Carries out lists whose elements are SetJointPositions messages."""

    element_types = (SetJointPositions,)

    def begin_element(self, uid: int, message: Message) -> None:  # noqa: ARG002 - the message says it all
        """Move to the positions; an element that does not match the joints is counted and skipped."""
        found = self._read(message)
        if found is None:
            self.host.count("wrong_joints", f"{message}")
            self.elements.done()
            return
        self.arm.to_positions(self, found)
        self.host.set_timer(_LIST_TIMER, self.host.now + CHECK_PERIOD, self._check)

    def end_elements(self) -> None:
        """Hold, if this service moves the joints."""
        self.host.cancel_timer(_LIST_TIMER)
        if self.is_moving:
            self.arm.stop()

    def on_preempted(self) -> None:
        """Stop the list."""
        if self.elements.active:
            self.elements.stop()

    def _check(self) -> None:
        message = self.elements.message(self.elements.active)
        found = self._read(message) if message is not None else None
        if found is None:
            return
        if self.arm.is_at(found):
            self.elements.done()
        elif not self.stops_if_touched(found):
            self.host.set_timer(_LIST_TIMER, self.host.now + CHECK_PERIOD, self._check)

    def _read(self, message: Message) -> list[float] | None:
        assert isinstance(message, SetJointPositions)
        return joint_values(read_positions(message.joint_position_list), self.arm.geometry.links)

    # --- actions, predicates, reports

    def execute_target_list(self, msg: Any) -> None:
        """Start, or restart, at the given element."""
        self.elements.execute(msg.element_uid)

    def target_exists(self) -> bool:
        """True if there is an element to report."""
        return self._target() is not None

    def report_commanded_joint_positions(self) -> ReportCommandedJointPositions | None:
        """The active element, else the first of the list."""
        found = self._target()
        return (
            None if found is None else ReportCommandedJointPositions(position_records(found, self.arm.geometry.links))
        )

    def _target(self) -> list[float] | None:
        message = self.elements.message(self.elements.active or next(iter(self.elements.list.order), 0))
        return self._read(message) if isinstance(message, SetJointPositions) else None


class EndEffectorPoseListDriver(
    ToolPoseDriver, ListDriver, urn="urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseListDriver"
):
    """Carries out lists whose elements are SetEndEffectorPose messages; a pose out of reach ends the list."""

    element_types = (SetEndEffectorPose,)

    def read_element(self, content: Message | bytes) -> Message | None:
        """The message; None, so that it is rejected, if its quaternion is zero."""
        message = super().read_element(content)
        return message if isinstance(message, SetEndEffectorPose) and commanded_pose(message) else None

    def begin_element(self, uid: int, message: Message) -> None:  # noqa: ARG002 - the message says it all
        """Move to the pose."""
        goal = commanded_pose(message) if isinstance(message, SetEndEffectorPose) else None
        assert goal is not None
        self.go(goal)

    def reached(self, *, exactly: bool) -> None:  # noqa: ARG002 - as near as the arm can
        """Continue with the next element."""
        self.elements.done()

    def end_elements(self) -> None:
        """Hold, if this service moves the joints."""
        if self.is_moving:
            self.arm.stop()

    def on_preempted(self) -> None:
        """Stop the list."""
        super().on_preempted()
        if self.elements.active:
            self.elements.stop()

    def execute_target_list(self, msg: Any) -> None:
        """Start, or restart, at the given element."""
        self.elements.execute(msg.element_uid)
