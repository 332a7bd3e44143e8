"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_sensor as manipulator_v1_0_manipulator_end_effector_pose_sensor

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor", "2.0")

@jd.derived(_SERVICE)
class ReportEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_sensor.ReportEndEffectorPose): ...

@jd.derived(_SERVICE)
class QueryEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_sensor.QueryEndEffectorPose):
    REPORT = ReportEndEffectorPose
