"""PrimitiveEndEffector: open-loop effort of a gripper, in percent of what it can do (AS6057)."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.messages.manipulator import ReportEndEffectorEffort, ReportEndEffectorSpecification, SetEndEffectorEffort
from jauspy.platform.joints import ControlMode, JointGroup, Target
from jauspy.services.service import Service
from jauspy.services.units import percent


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
