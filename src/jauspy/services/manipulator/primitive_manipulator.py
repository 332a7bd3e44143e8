"""PrimitiveManipulator: open-loop efforts, in percent of what each joint can do (AS6057)."""

from __future__ import annotations

from collections.abc import Sequence

from jauspy.messages.manipulator import ReportJointEffort, SetJointEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.manipulator.arm import Arm, ArmDriver
from jauspy.services.manipulator.values import percents
from jauspy.services.percent import percent


class EffortDriver(ArmDriver):
    """Motors push with what they are told; a joint whose effort is zero is held where it is, as by a brake."""

    def __init__(self, arm: Arm) -> None:
        super().__init__(arm)
        self.efforts = [0.0] * len(arm.joints.joints)
        """The last commanded ones, in percent; zero when they were stopped or another service moves the joints."""

    def push(self, efforts: Sequence[float]) -> None:
        """Percent of what each joint can do, base to tip."""
        shares = [percent(effort) for effort in efforts]
        rows = zip(shares, self.arm.joints.joints, self.arm.state().positions, strict=True)
        self.arm.move(self, [_target(share, joint.effort, position) for share, joint, position in rows])
        self.efforts = shares

    def taken_over(self) -> None:
        """The efforts end."""
        self.efforts = [0.0] * len(self.efforts)


class PrimitiveManipulator(EffortDriver, urn="urn:jaus:jss:manipulator:PrimitiveManipulator"):
    """An effort for each joint, base to tip."""

    def set_joint_effort(self, msg: SetJointEffort) -> None:
        """Ignored, and counted, unless there is an effort for each joint."""
        efforts = [record.joint_effort for record in msg.joint_effort_list]
        if len(efforts) != len(self.efforts):
            self.host.count("wrong_joints", f"{msg}")
            return
        self.push(efforts)

    def report_joint_effort(self) -> ReportJointEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service moves the joints."""
        return ReportJointEffort(percents(self.efforts))


def _target(share: float, most: float, position: float) -> Target:
    if not share:
        return Target(ControlMode.POSITION, position)
    return Target(ControlMode.EFFORT, most * share / 100.0)
