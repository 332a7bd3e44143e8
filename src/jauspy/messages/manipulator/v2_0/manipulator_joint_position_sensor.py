"""urn:jaus:jss:manipulator:ManipulatorJointPositionSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_sensor as manipulator_v1_0_manipulator_joint_position_sensor

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointPositionSensor", "2.0")

@jd.derived(_SERVICE)
class ReportJointPositions(manipulator_v1_0_manipulator_joint_position_sensor.ReportJointPositions): ...

@jd.derived(_SERVICE)
class QueryJointPositions(manipulator_v1_0_manipulator_joint_position_sensor.QueryJointPositions):
    REPORT = ReportJointPositions
