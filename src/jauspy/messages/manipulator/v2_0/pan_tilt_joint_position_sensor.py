"""urn:jaus:jss:manipulator:PanTiltJointPositionSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_sensor as manipulator_v1_0_pan_tilt_joint_position_sensor

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointPositionSensor", "2.0")

@jd.derived(_SERVICE)
class ReportPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_sensor.ReportPanTiltJointPositions): ...

@jd.derived(_SERVICE)
class QueryPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_sensor.QueryPanTiltJointPositions):
    REPORT = ReportPanTiltJointPositions
