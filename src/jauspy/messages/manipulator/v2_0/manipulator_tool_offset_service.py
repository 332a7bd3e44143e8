"""urn:jaus:jss:manipulator:ManipulatorToolOffsetService 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver


class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    """QueryToolOffset (0x2604): Asks where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorToolOffsetService"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportToolOffset]]


class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset):
    """SetToolOffset (0x0604): Sets where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorToolOffsetService"
    VERSION = "2.0"


class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset):
    """ReportToolOffset (0x4604): Tells where the tool point is."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorToolOffsetService"
    VERSION = "2.0"


QueryToolOffset.REPORT = ReportToolOffset
