"""urn:jaus:jss:manipulator:PanTiltJointPositionDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointPositionDriver", "2.0")

@jd.derived(_SERVICE)
class ReportCommandedPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.ReportCommandedPanTiltJointPositions): ...

@jd.derived(_SERVICE)
class QueryCommandedPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.QueryCommandedPanTiltJointPositions):
    REPORT = ReportCommandedPanTiltJointPositions

@jd.derived(_SERVICE)
class SetPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.SetPanTiltJointPositions): ...
