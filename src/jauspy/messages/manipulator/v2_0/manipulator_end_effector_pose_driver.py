"""urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver


class SetEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.SetEndEffectorPose):
    """SetEndEffectorPose (0x0610): Sets the pose to move the tool point to."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "2.0"


class QueryCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryCommandedEndEffectorPose):
    """QueryCommandedEndEffectorPose (0x2610): Asks for the commanded pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportCommandedEndEffectorPose]]


class ReportCommandedEndEffectorPose(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportCommandedEndEffectorPose):
    """ReportCommandedEndEffectorPose (0x4610): Tells the commanded pose of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorPoseDriver"
    VERSION = "2.0"


QueryCommandedEndEffectorPose.REPORT = ReportCommandedEndEffectorPose
