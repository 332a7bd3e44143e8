"""PrimitiveManipulator: open-loop efforts, in percent of what each joint can do (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportJointEffort, SetJointEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.driver import ArmDriver
from jauspy.services.manipulator.values import percents
from jauspy.services.percent import percent


class PrimitiveManipulator(ArmDriver, urn="urn:jaus:jss:manipulator:PrimitiveManipulator"):
    """Motors push with what they are told; a joint whose effort is zero is held where it is, as by a brake."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self._efforts = [0.0] * len(arm.joints.joints)

    def set_joint_effort(self, msg: SetJointEffort) -> None:
        """Ignored, and counted, unless there is an effort for each joint."""
        efforts = [percent(record.joint_effort) for record in msg.joint_effort_list]
        if len(efforts) != len(self._efforts):
            self.host.count("wrong_joints", f"{msg}")
            return
        rows = zip(efforts, self.arm.joints.joints, self.arm.state().positions, strict=True)
        self.arm.move(self, [_target(share, joint.effort, position) for share, joint, position in rows])
        self._efforts = efforts

    def taken_over(self) -> None:
        """The efforts end."""
        self._efforts = [0.0] * len(self._efforts)

    def report_joint_effort(self) -> ReportJointEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service moves the joints."""
        return ReportJointEffort(percents(self._efforts))


def _target(share: float, most: float, position: float) -> Target:
    if not share:
        return Target(ControlMode.POSITION, position)
    return Target(ControlMode.EFFORT, most * share / 100.0)
