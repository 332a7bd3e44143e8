"""urn:jaus:jss:manipulator:PrimitivePanTilt 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PrimitivePanTilt", "1.0")

@jd.derived(_SERVICE)
class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications): ...

@jd.derived(_SERVICE)
class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    REPORT = ReportPanTiltSpecifications


@jd.message(_SERVICE, 0x4621)
class ReportPanTiltJointEfforts(jd.Message):
    """ReportPanTiltJointEfforts (0x4621): Tells the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """
    joint1_effort: float = jd.field("Joint1Effort", jd.real("H", -100.0, 100.0))
    joint2_effort: float = jd.field("Joint2Effort", jd.real("H", -100.0, 100.0))


@jd.message(_SERVICE, 0x2621, query=True)
class QueryPanTiltJointEfforts(jd.Message):
    """QueryPanTiltJointEfforts (0x2621): Asks for the efforts of pan and tilt."""
    REPORT = ReportPanTiltJointEfforts


@jd.message(_SERVICE, 0x0621, command=True)
class SetPanTiltJointEfforts(jd.Message):
    """SetPanTiltJointEfforts (0x0621): Sets the efforts of pan and tilt.

    joint1_effort: -100..100. Effort of the pan joint, in percent of the maximum
    joint2_effort: -100..100. Effort of the tilt joint, in percent of the maximum
    """
    joint1_effort: float = jd.field("Joint1Effort", jd.real("H", -100.0, 100.0))
    joint2_effort: float = jd.field("Joint2Effort", jd.real("H", -100.0, 100.0))
