"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_sensor as manipulator_v1_0_manipulator_end_effector_pose_sensor


class QueryEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_sensor.QueryEndEffectorPose):
    """QueryEndEffectorPose (0x2615): Asks for the pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportEndEffectorPose]]


class ReportEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_sensor.ReportEndEffectorPose):
    """ReportEndEffectorPose (0x4615): Tells the pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseSensor"
    VERSION = "2.0"


QueryEndEffectorPose.REPORT = ReportEndEffectorPose
