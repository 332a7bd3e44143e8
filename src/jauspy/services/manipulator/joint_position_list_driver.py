"""ManipulatorJointPositionListDriver: through a list of positions of the joints (AS6057)."""

from __future__ import annotations

from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.messages.manipulator import ReportCommandedJointPositions, SetJointPositions
from jauspy.services.core.list_manager import ListDriver
from jauspy.services.manipulator.driver import ArmDriver
from jauspy.services.manipulator.values import positions, read_positions, values

PERIOD: Final = 0.05
"""Seconds between two looks at whether an element was reached."""
_TIMER: Final = "joint position list"


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
        self.host.set_timer(_TIMER, self.host.now + PERIOD, self._look)

    def end_elements(self) -> None:
        """Hold."""
        self.host.cancel_timer(_TIMER)
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
            self.host.set_timer(_TIMER, self.host.now + PERIOD, self._look)

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
