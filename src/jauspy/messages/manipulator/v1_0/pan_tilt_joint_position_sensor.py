"""urn:jaus:jss:manipulator:PanTiltJointPositionSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointPositionSensor", "1.0")


@jd.message(_SERVICE, 0x4622)
class ReportPanTiltJointPositions(jd.Message):
    """ReportPanTiltJointPositions (0x4622): Tells the angles.

    joint1_position: -25.1327412287..25.1327412287 radian. Angle of the pan joint, in radians
    joint2_position: -25.1327412287..25.1327412287 radian. Angle of the tilt joint, in radians
    """
    joint1_position: float = jd.field("Joint1Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))
    joint2_position: float = jd.field("Joint2Position", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"))


@jd.message(_SERVICE, 0x2622, query=True)
class QueryPanTiltJointPositions(jd.Message):
    """QueryPanTiltJointPositions (0x2622): Asks for the angles."""
    REPORT = ReportPanTiltJointPositions

@jd.derived(_SERVICE)
class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications): ...

@jd.derived(_SERVICE)
class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    REPORT = ReportPanTiltSpecifications
