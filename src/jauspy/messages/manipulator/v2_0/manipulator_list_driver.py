"""urn:jaus:jss:manipulator:ManipulatorListDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_list_driver as manipulator_v1_0_manipulator_end_effector_pose_list_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorListDriver", "2.0")

@jd.derived(_SERVICE)
class ExecuteList(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ReportActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.QueryActiveElement):
    REPORT = ReportActiveElement
