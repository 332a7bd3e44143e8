"""urn:jaus:jss:manipulator:ManipulatorJointPositionDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_driver as manipulator_v1_0_manipulator_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointPositionDriver", "2.0")

@jd.derived(_SERVICE)
class ReportCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.ReportCommandedJointPositions): ...

@jd.derived(_SERVICE)
class QueryCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.QueryCommandedJointPositions):
    REPORT = ReportCommandedJointPositions

@jd.derived(_SERVICE)
class SetJointPositions(manipulator_v1_0_manipulator_joint_position_driver.SetJointPositions): ...
