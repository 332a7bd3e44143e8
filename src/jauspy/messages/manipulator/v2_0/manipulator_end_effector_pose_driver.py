"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver", "2.0")

@jd.derived(_SERVICE)
class SetEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.SetEndEffectorPose): ...

@jd.derived(_SERVICE)
class ReportCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportCommandedEndEffectorPose): ...

@jd.derived(_SERVICE)
class QueryCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryCommandedEndEffectorPose):
    REPORT = ReportCommandedEndEffectorPose
