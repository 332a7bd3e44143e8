"""urn:jaus:jss:manipulator:ManipulatorToolOffsetService 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorToolOffsetService", "2.0")

@jd.derived(_SERVICE)
class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset): ...

@jd.derived(_SERVICE)
class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    REPORT = ReportToolOffset

@jd.derived(_SERVICE)
class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset): ...
