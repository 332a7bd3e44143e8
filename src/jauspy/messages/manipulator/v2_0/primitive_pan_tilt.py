"""urn:jaus:jss:manipulator:PrimitivePanTilt 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitivePanTilt", "2.0")


@jd.message(_SERVICE, 0x4621)
class ReportPanTiltJointEffort(jd.Message):
    """ReportPanTiltJointEffort (0x4621): Tells the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """
    joint1_effort: float = jd.field("Joint1Effort", jd.real("H", -100.0, 100.0))
    joint2_effort: float = jd.field("Joint2Effort", jd.real("H", -100.0, 100.0))


@jd.message(_SERVICE, 0x2621, query=True)
class QueryPanTiltJointEffort(jd.Message):
    """QueryPanTiltJointEffort (0x2621): Asks for the efforts of pan and tilt."""
    REPORT = ReportPanTiltJointEffort


@jd.message(_SERVICE, 0x0621, command=True)
class SetPanTiltJointEffort(jd.Message):
    """SetPanTiltJointEffort (0x0621): Sets the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """
    joint1_effort: float = jd.field("Joint1Effort", jd.real("H", -100.0, 100.0))
    joint2_effort: float = jd.field("Joint2Effort", jd.real("H", -100.0, 100.0))
