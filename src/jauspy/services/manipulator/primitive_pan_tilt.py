"""PrimitivePanTilt: open-loop efforts, in percent of what pan and tilt can do (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportPanTiltJointEffort, SetPanTiltJointEffort
from jauspy.services.manipulator.joints import EffortDriver


class PrimitivePanTilt(EffortDriver, urn="urn:jaus:jss:manipulator:PrimitivePanTilt"):
    """Motors push with what they are told; a joint whose effort is zero is held where it is, as by a brake."""

    def set_pan_tilt_joint_effort(self, msg: SetPanTiltJointEffort) -> None:
        """Positive efforts pan to the right and tilt upwards."""
        self.push([msg.joint1_effort, msg.joint2_effort])

    def report_pan_tilt_joint_effort(self) -> ReportPanTiltJointEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service moves the joints."""
        return ReportPanTiltJointEffort(*self.efforts)
